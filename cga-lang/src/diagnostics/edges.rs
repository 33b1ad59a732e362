//! Setbacks that set nothing back: they have no arm for edges, or no width.

use super::switch::is_switch;
use crate::analysis::{AbstractState, DataFlow};
use crate::diag::Diags;
use crate::diag::code::Code;
use crate::ops::{self, Braces, Operation, ParamKind, Selector, SelectorPlaces};
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::syntax::ast::{Arg, Arm, Block, BlockPart, ExprKind};
use crate::types::Type;

/// Reports a setback whose arms all select the remainder (*setbackToArea operation*).
pub(crate) fn check(row: &Operation, block: &Block, names: Entries, diags: &mut Diags) {
    let [BlockPart::Arms(arms)] = block.parts.as_slice() else { return };
    if row.braces != Braces::Arms(SelectorPlaces::SETBACK) || arms.is_empty() {
        return;
    }
    if arms.iter().all(|arm| is_rest(arm, names)) {
        let message = format!("`{}` sets nothing back: no arm selects edges", block.name.text);
        let diag = diags.report(Code::NoEffect, block.name.span, message);
        diag.note("the remainder is the whole shape").help("add an arm for edges: `all : NIL`");
    }
}

/// Reports an operation whose widths are all 0 (*shapeL, shapeU, shapeO operations*). A width that a constant sets to 0
/// is turned off.
pub(crate) fn widths(
    row: &Operation,
    args: &[Arg],
    facts: &AbstractState,
    flow: &DataFlow,
    cx: &Context,
    diags: &mut Diags,
) {
    let has_widths = row.params.iter().all(|param| param.kind == ParamKind::Value(Type::Float));
    let (Some(first), Some(last)) = (args.first(), args.last()) else { return };
    if row.braces != Braces::Arms(SelectorPlaces::SHAPE) || !has_widths {
        return;
    }
    let names = cx.tables.at(facts.own);
    let is_zero =
        |arg: &Arg| flow.value(&arg.value, facts).number().known() == Some(0.0) && !is_switch(&arg.value, names);
    if args.iter().all(is_zero) {
        let message = format!("`{}` makes no shape: all its widths are 0", row.name);
        let diag = diags.report(Code::NoEffect, first.span.to(last.span), message);
        diag.note("the remainder is the whole shape").help("write a width above 0 for one of the sides");
    }
}

/// Returns true for the word for the remainder.
fn is_rest(arm: &Arm, names: Entries) -> bool {
    let ExprKind::Name(name) = &arm.selector.kind else { return false };
    let Some(Use::Selector(word)) = names.of(name) else { return false };
    matches!(ops::selector(word), Some(Selector { is_rest: true, .. }))
}
