//! Operands of boolean operations that never make a shape.

use crate::analysis::body;
use crate::diag::Diags;
use crate::diag::code::Code;
use crate::ops::{Braces, Operation};
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::syntax::ast::{Block, BlockPart, Op, OpKind, Role};

/// The deepest nesting of calls that is followed.
const DEEPEST: usize = 64;

/// Checks the operands of an operation. `known` are the answers of [`vanishes`] for rules.
pub(crate) fn check(
    row: &Operation,
    block: &Block,
    names: Entries,
    cx: &Context,
    known: &mut [Option<bool>],
    diags: &mut Diags,
) {
    if row.braces != Braces::Operands {
        return;
    }
    for operand in block.parts.iter().flat_map(|part| if let BlockPart::Ops(sides) = part { &sides[..] } else { &[] }) {
        let (Some(first), Some(last)) = (operand.first(), operand.last()) else { continue };
        if vanishes(operand, names, cx, known, 0) {
            let message = format!("this operand of `{}` never makes a shape", block.name.text);
            let diag = diags.report(Code::EmptyOperand, first.span.to(last.span), message);
            diag.note("all its shapes end with `NIL`").help("write a shape that stays, such as `X.`");
        }
    }
}

/// Returns true if all shapes that some operations make are removed. `known` are the answers for rules; a rule that is being
/// examined counts as one that leaves a shape.
fn vanishes(list: &[Op], names: Entries, cx: &Context, known: &mut [Option<bool>], depth: usize) -> bool {
    if DEEPEST < depth {
        return false;
    }
    // A shape without successors is a leaf.
    let mut has_successor = false;
    for op in list {
        let all_vanish = match &op.kind {
            OpKind::Nil => true,
            OpKind::Call(name, _) => match names.of(name) {
                Some(Use::Operation(_) | Use::SetAttr(_) | Use::SetShape(_)) => continue,
                // An importing file may replace an extension.
                Some(Use::Rule(rule)) if cx.globals.rules[rule as usize].decl.role == Role::Extension => false,
                Some(Use::Rule(rule)) => known[rule as usize].unwrap_or_else(|| {
                    let item = &cx.globals.rules[rule as usize];
                    known[rule as usize] = Some(false);
                    let vanishes = vanishes(body(item), cx.tables.at(item.own), cx, known, depth + 1);
                    known[rule as usize] = Some(vanishes);
                    vanishes
                }),
                _ => false,
            },
            OpKind::Push(inner) => vanishes(inner, names, cx, known, depth + 1),
            OpKind::Case(..) | OpKind::Chance(..) => op.bodies().all(|ops| vanishes(ops, names, cx, known, depth + 1)),
            OpKind::Block(_) | OpKind::Leaf(_) | OpKind::Dynamic { .. } | OpKind::Path(..) | OpKind::Error => false,
        };
        if !all_vanish {
            return false;
        }
        has_successor = true;
    }
    has_successor
}
