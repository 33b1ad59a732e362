//! Operations without a result.
//!
//! A shape with children is not a leaf, so operations after its last child have no visible effect.

use super::instances::CommonDiags;
use crate::analysis::body;
use crate::diag::code::Code;
use crate::diag::{Diag, Diags};
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::syntax::ast::{Block, BlockPart, Op, OpKind};

pub(crate) fn check(cx: &Context) -> Vec<Diag> {
    let mut common = CommonDiags::default();
    for item in &cx.globals.rules {
        common.check(item, |diags| _ = sequence(body(item), false, false, cx.tables.at(item.own), diags));
    }
    common.finish()
}

/// Checks the operations of one shape, and returns true if the shape certainly has a child after them. `made` is true
/// if it has a child before them, and `restored` if its earlier state is restored after them.
fn sequence(ops: &[Op], made: bool, restored: bool, names: Entries, diags: &mut Diags) -> bool {
    let mut made = made;
    // The index of the first operation that only changes the shape.
    let mut idle = None;
    for (at, op) in ops.iter().enumerate() {
        // Labels, reports and prints act on the run and show the changes before them.
        let changes = match &op.kind {
            OpKind::Call(name, _) => match names.of(name) {
                Some(Use::Operation(row)) => !row.is_for_run(),
                Some(Use::SetAttr(_) | Use::SetShape(_)) => true,
                Some(Use::Rule(_) | Use::Leaf) => {
                    made = true;
                    false
                }
                _ => false,
            },
            OpKind::Leaf(_) | OpKind::Nil | OpKind::Dynamic { .. } => {
                made = true;
                false
            }
            OpKind::Block(block) => {
                // The parts are shapes of their own.
                op.bodies().for_each(|ops| _ = sequence(ops, false, false, names, diags));
                made |= makes_children(block, names);
                false
            }
            OpKind::Push(inner) => {
                made |= sequence(inner, made, true, names, diags);
                false
            }
            OpKind::Case(..) | OpKind::Chance(..) => {
                // Every branch is checked, even after the result is known.
                let ends: Vec<bool> = op.bodies().map(|ops| sequence(ops, made, restored, names, diags)).collect();
                made = ends.into_iter().all(|made| made);
                false
            }
            OpKind::Path(..) | OpKind::Error => false,
        };
        idle = if changes { idle.or(Some(at)) } else { None };
    }
    if let Some(first) = idle.filter(|_| made || restored) {
        let span = ops[first].span.to(ops[ops.len() - 1].span);
        let diag = diags.report(Code::NoEffect, span, "this has no effect: no successor follows it");
        if restored {
            diag.note("the bracket restores the shape");
        } else {
            diag.note("a shape with successors is not a leaf, so later changes to it are not visible");
        }
        diag.help("move it before the successors");
    }
    made
}

/// Returns true if an operation with braces certainly makes a child. The slots of a split may find nothing to divide.
fn makes_children(block: &Block, names: Entries) -> bool {
    let makes = matches!(names.of(&block.name), Some(Use::Operation(row)) if row.braces.divides());
    makes && block.parts.iter().any(|part| matches!(part, BlockPart::Arms(_)))
}
