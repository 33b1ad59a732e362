//! Conditions that are always true or always false.

use super::flow::{Facts, Flow};
use super::size::range;
use super::{Cx, Tables, Use};
use crate::ast::{Expr, ExprKind};
use crate::code::Code;
use crate::diag::Diags;

/// Looks at a condition of a `case`.
pub(super) fn check(condition: &Expr, facts: &Facts, flow: &Flow, cx: &Cx, diags: &mut Diags) {
    let truth = flow.value(condition, facts).truth().filter(|_| !is_switch(condition, &cx.tables));
    let Some(truth) = truth else { return };
    let word = if truth { "true" } else { "false" };
    let diag = diags.report(Code::CaseAlways, condition.span, format!("this condition is always {word}"));
    if let ExprKind::Binary(_, _, left, right) = &condition.kind {
        for side in [left, right] {
            if let ExprKind::Name(name) = &side.kind {
                let here = flow.value(side, facts).number();
                diag.note(format!("`{}` is {} here", name.text, range(here)));
            }
        }
    }
    diag.note(if truth { "what comes after it is never done" } else { "what it leads to is never done" });
}

/// Whether a condition is a bare `true` or `false`, or made of constants alone: a switch that its author sets by hand.
fn is_switch(condition: &Expr, tables: &Tables) -> bool {
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
    names(condition, tables, &mut constants, &mut others);
    matches!(condition.kind, ExprKind::Bool(_)) || 0 < constants && others == 0
}
