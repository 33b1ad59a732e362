//! Computed indices that no component has. Literals have other checks: negative ones are reported with the names, fractions with
//! hidden selectors.

use super::numbers::shown;
use crate::analysis::{AbstractState, DataFlow, Value};
use crate::diag::Diags;
use crate::diag::code::Code;
use crate::ops::Operation;
use crate::syntax::ast::{Block, BlockPart, Expr, ExprKind, Unary};

/// Checks the selectors of an operation on components. Negative indices of `setback` wrap (*setback operation*).
pub(crate) fn check(row: &Operation, block: &Block, facts: &AbstractState, flow: &DataFlow, diags: &mut Diags) {
    if !row.places(block.args.first().and_then(|arg| arg.value.word())).connects() {
        return;
    }
    for arm in block.parts.iter().flat_map(|part| if let BlockPart::Arms(arms) = part { &arms[..] } else { &[] }) {
        selector(&arm.selector, facts, flow, diags);
    }
}

/// Reports a selector that is a number no component has.
pub(crate) fn selector(selector: &Expr, facts: &AbstractState, flow: &DataFlow, diags: &mut Diags) {
    let is_literal = match &selector.kind {
        ExprKind::Number(_) => true,
        ExprKind::Unary(Unary::Minus, operand) => matches!(operand.kind, ExprKind::Number(_)),
        _ => false,
    };
    let Value::Number(index) = flow.value(selector, &facts.on_any_shape()) else { return };
    let is_fraction = index.known().is_some_and(|index| index.fract() != 0.0);
    if is_literal || index.is_odd() || !is_fraction && 0.0 <= index.hi {
        return;
    }
    let index =
        index.known().map_or_else(|| "a negative index".to_owned(), |index| format!("the index {}", shown(index)));
    let diag = diags.report(Code::SelectorHidden, selector.span, format!("no component has {index}"));
    diag.note("indices of components are whole numbers from 0").help("write the index of a component, or a selector");
}
