//! Conditions that are always true or always false.

use super::flow::{Facts, Flow, Value};
use super::size::range;
use super::{Cx, Tables, Use};
use crate::ast::{Binary, Expr, ExprKind, Unary};
use crate::code::Code;
use crate::diag::{Diag, Diags};

/// Looks at a condition of a `case`.
pub(super) fn check(condition: &Expr, facts: &Facts, flow: &Flow, cx: &Cx, diags: &mut Diags) {
    let Some(truth) = flow.value(condition, facts).truth() else { return };
    if is_decided_by_switch(condition, truth, facts, flow, &cx.tables) {
        return;
    }
    let word = if truth { "true" } else { "false" };
    let diag = diags.report(Code::CaseAlways, condition.span, format!("this condition is always {word}"));
    reasons(condition, truth, facts, flow, diag);
    diag.note(if truth { "what comes after it is never done" } else { "what it leads to is never done" });
}

/// Says what is known of the numbers that are compared, where that decides.
fn reasons(condition: &Expr, truth: bool, facts: &Facts, flow: &Flow, diag: &mut Diag) {
    match &condition.kind {
        ExprKind::Unary(Unary::Not, operand) => reasons(operand, !truth, facts, flow, diag),
        ExprKind::Binary(Binary::And | Binary::Or, _, left, right) => {
            for side in [left, right] {
                if flow.value(side, facts).truth() == Some(truth) {
                    reasons(side, truth, facts, flow, diag);
                }
            }
        }
        ExprKind::Binary(_, _, left, right) => {
            for side in [left, right] {
                let ExprKind::Name(name) = &side.kind else { continue };
                if let Value::Number(here) = flow.value(side, facts) {
                    diag.note(format!("`{}` is {} here", name.text, range(here)));
                }
            }
        }
        _ => {}
    }
}

/// Whether it is a switch that decides a condition.
fn is_decided_by_switch(condition: &Expr, truth: bool, facts: &Facts, flow: &Flow, tables: &Tables) -> bool {
    let decides = |side: &Expr, truth: bool| {
        flow.value(side, facts).truth() == Some(truth) && is_decided_by_switch(side, truth, facts, flow, tables)
    };
    is_switch(condition, tables)
        || match (&condition.kind, truth) {
            (ExprKind::Unary(Unary::Not, operand), _) => decides(operand, !truth),
            // One side is enough, or one of the two it takes.
            (ExprKind::Binary(Binary::And | Binary::Or, _, left, right), _) => {
                decides(left, truth) || decides(right, truth)
            }
            _ => false,
        }
}

/// Whether an expression is a bare `true` or `false`, or made of constants alone: a switch that its author sets by hand.
pub(super) fn is_switch(expr: &Expr, tables: &Tables) -> bool {
    fn names(expr: &Expr, tables: &Tables, constants: &mut usize, others: &mut usize) {
        if let ExprKind::Name(name) | ExprKind::Call(name, _) = &expr.kind {
            match tables.of(name) {
                Some(Use::Const(_) | Use::Function(_)) => *constants += 1,
                _ => *others += 1,
            }
        }
        expr.parts().into_iter().for_each(|part| names(part, tables, constants, others));
    }
    let (mut constants, mut others) = (0, 0);
    names(expr, tables, &mut constants, &mut others);
    matches!(expr.kind, ExprKind::Bool(_)) || 0 < constants && others == 0
}
