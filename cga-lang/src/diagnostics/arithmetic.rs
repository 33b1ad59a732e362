//! Checks of expressions: division by zero, arguments out of bounds, constant conditions.

use super::{bounds, branches, colour, indices, shadowing, tags, texture};
use crate::analysis::{AbstractState, CaseBranch, DataFlow};
use crate::diag::Diags;
use crate::diag::code::Code;
use crate::resolve::context::Context;
use crate::resolve::tables::Use;
use crate::syntax::ast::{Binary, Expr, ExprKind};
use crate::syntax::written::Written;

/// Checks an expression and its parts.
pub(crate) fn check(expr: &Expr, facts: &AbstractState, flow: &DataFlow, cx: &Context, diags: &mut Diags) {
    match &expr.kind {
        ExprKind::Binary(op, _, _, right) => division(*op, right, facts, flow, diags),
        ExprKind::Chain(_, links) => {
            links.iter().for_each(|link| division(link.op, &link.operand, facts, flow, diags));
        }
        ExprKind::Case(arms, other) => {
            let mut before = Written::new(cx.globals.program.tokens.as_slice());
            return case(arms, other, facts, (facts, &mut before), flow, cx, diags);
        }
        ExprKind::Call(name, args) => {
            if let Some(Use::Builtin(row)) = cx.tables.at(facts.own).of(name) {
                texture::asked(row, name, args, (facts, flow), diags);
                let args: Vec<&Expr> = args.iter().collect();
                bounds::check(row.params, &args, facts, flow, cx, diags);
                tags::check(row.params, &args, &cx.tables.given_tags, diags);
                colour::check(cx.globals.program, row.params, &args, facts, flow, diags);
            }
        }
        ExprKind::Comp(comp) => {
            shadowing::values(comp, facts, cx, diags);
            comp.arms.iter().for_each(|(selector, ..)| indices::selector(selector, facts, flow, diags));
        }
        _ => {}
    }
    // The values of a comp are computed on each component.
    let component = matches!(expr.kind, ExprKind::Comp(_)).then(|| facts.on_any_shape());
    let facts = component.as_ref().unwrap_or(facts);
    expr.parts().into_iter().for_each(|part| check(part, facts, flow, cx, diags));
}

/// Reports a division by zero.
fn division(op: Binary, right: &Expr, facts: &AbstractState, flow: &DataFlow, diags: &mut Diags) {
    let what = match op {
        Binary::Div => "this divides by zero",
        Binary::Rem => "the remainder of a division by zero is NaN",
        _ => return,
    };
    if flow.value(right, facts).number().known() == Some(0.0) {
        let diag = diags.report(Code::DivisionByZero, right.span, what);
        diag.note("the result is not finite: operations use 0 instead, with a fault");
    }
}

/// Checks a `case`. `first` has the facts at its first condition, with the conditions since then, because the `case`
/// may follow the `else` of another one.
fn case<'e>(
    arms: &'e [(Expr, Expr)],
    other: &'e Expr,
    facts: &AbstractState,
    (first, before): (&AbstractState, &mut Written<'_, &'e Expr>),
    flow: &DataFlow,
    cx: &Context,
    diags: &mut Diags,
) {
    // A part that is never computed has no diagnostics.
    let mut left = Some(facts.clone());
    for (at, (condition, value)) in arms.iter().enumerate() {
        let Some(here) = left else { return };
        let is_last = at + 1 == arms.len();
        branches::check(&CaseBranch { condition, before, is_last, first }, &here, flow, cx, diags);
        before.add(condition.span, condition);
        check(condition, &here, flow, cx, diags);
        if let Some(inside) = flow.known.past(condition, true, here.clone()) {
            check(value, &inside, flow, cx, diags);
        }
        left = flow.known.past(condition, false, here);
    }
    match (left, &other.kind) {
        (Some(here), ExprKind::Case(arms, other)) => case(arms, other, &here, (first, before), flow, cx, diags),
        (Some(here), _) => check(other, &here, flow, cx, diags),
        (None, _) => {}
    }
}
