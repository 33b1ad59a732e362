//! Upper bounds for the stack that rules and functions take where they are compiled without optimisation, so that every value has
//! a place of its own. They were measured on 64 bits, and `tests/language/deep.rs` checks them.
//!
//! They follow from the rules alone, so that a run is the same in every build and with every back end.

use crate::ir::walk;
use crate::ir::{Arm, BlockParts, Expr, ExprKind, Function, Rule, Selector, StepKind, Target, Type, Value};

/// Kilobytes that a rule takes, with what the runtime's operations that call it back take.
pub(super) fn rule(rule: &Rule) -> u32 {
    let mut bytes: usize = 1000;
    walk::steps(&rule.body, &mut |step| {
        bytes += match &step.kind {
            StepKind::Give(Target::Nil) => 100,
            StepKind::Give(_) => 700,
            StepKind::Block(block) => match &block.parts {
                BlockParts::Slots(slots) => 3000 + 500 * slots.targets.len(),
                BlockParts::Arms(arms) => 4000 + 500 * arms.len(),
                BlockParts::Sections(parts) => 4000 + 500 * (parts.slots.targets.len() + parts.rest.len()),
                BlockParts::Each(_) => 4000,
                BlockParts::Operands(targets) => 4000 + 500 * targets.len(),
            },
            StepKind::Push(_) => 400,
            // A whole shape, a base and two slim shapes; steps after each other share them.
            StepKind::Do(..) | StepKind::SetAttr(..) | StepKind::SetShape(..) | StepKind::Rust(..) => 1300,
            StepKind::Renew(call) => 2300 + 200 * call.given.len(),
            StepKind::Case { .. } => 100,
        }
    });
    // Intermediate values have stack slots too.
    walk::in_rule(rule, &mut |expr| bytes += own(expr));
    u32::try_from(bytes.div_ceil(1024)).unwrap_or(u32::MAX)
}

/// Bytes that a function takes.
pub(super) fn function(function: &Function) -> u32 {
    let mut bytes: usize = 144 + 8 * function.params.len();
    for value in function.locals.iter().chain([&function.body]) {
        walk::parts(value, &mut |expr| bytes += own(expr) + divided(expr));
    }
    u32::try_from(bytes).unwrap_or(u32::MAX)
}

/// Bytes that the first read of a lazy attribute or constant takes: the runtime's part and the shape that it is computed on
/// among them.
pub(super) fn lazy(value: &Expr) -> u32 {
    let mut bytes: usize = 2000;
    walk::parts(value, &mut |expr| bytes += own(expr) + divided(expr));
    u32::try_from(bytes).unwrap_or(u32::MAX)
}

/// Bytes that the runtime takes before it calls back for values of components, or for conditions on them.
fn divided(expr: &Expr) -> usize {
    let ExprKind::Comp(comp) = &expr.kind else { return 0 };
    let has_condition = |arm: &Arm<Expr>| matches!(arm.selector, Selector::When(_));
    if comp.arms.iter().any(has_condition) { 10_000 } else { 5000 }
}

/// Bytes of an expression itself, without its parts.
fn own(expr: &Expr) -> usize {
    let place = match expr.ty {
        Type::Float | Type::Bool => 8,
        _ => 64,
    };
    place
        + match &expr.kind {
            // Each entry becomes a `Part` before it gets into the slice.
            ExprKind::Array(rows) => rows.iter().map(|row| 16 + 64 * row.len()).sum::<usize>() + 32,
            // The elements are adjacent; texts have a second slot each.
            ExprKind::Value(Value::Array(rows)) => {
                let element = if expr.ty == Type::Texts { 48 } else { 8 };
                rows.iter().map(|row| element * row.len()).sum()
            }
            ExprKind::Comp(comp) => 128 * comp.arms.len(),
            _ => 0,
        }
}
