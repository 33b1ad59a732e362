//! Setbacks without an arm for edges.

use super::agreed::Agreed;
use crate::analysis::body;
use crate::diag::Diag;
use crate::diag::code::Code;
use crate::ops::{self, Braces, Operation, Selector, SelectorPlaces};
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::syntax::ast::{Arm, BlockPart, ExprKind, OpKind};
use crate::syntax::walk;

/// Reports setbacks whose arms all select the remainder (*setbackToArea operation*).
pub(crate) fn check(cx: &Context) -> Vec<Diag> {
    let mut agreed = Agreed::default();
    for item in &cx.globals.rules {
        let names = cx.tables.at(item.own);
        agreed.check(item, |diags| {
            for op in walk::ops(body(item)) {
                let OpKind::Block(block) = &op.kind else { continue };
                let Some(Use::Operation(Operation { braces: Braces::Arms(SelectorPlaces::SETBACK), .. })) =
                    names.of(&block.name)
                else {
                    continue;
                };
                let [BlockPart::Arms(arms)] = block.parts.as_slice() else { continue };
                if !arms.is_empty() && arms.iter().all(|arm| is_rest(arm, names)) {
                    let message = format!("`{}` sets nothing back: no arm selects edges", block.name.text);
                    let diag = diags.report(Code::NoEffect, block.name.span, message);
                    diag.note("the remainder is the whole shape").help("add an arm for edges: `all : NIL`");
                }
            }
        });
    }
    agreed.finish()
}

/// Returns true for the word for the remainder.
fn is_rest(arm: &Arm, names: Entries) -> bool {
    let ExprKind::Name(name) = &arm.selector.kind else { return false };
    let Some(Use::Selector(word)) = names.of(name) else { return false };
    matches!(ops::selector(word), Some(Selector { is_rest: true, .. }))
}
