//! What a condition says of the values in it, for whoever has come past it.

use super::values::Facts;
use super::walk::Walk;
use crate::ast::{Binary, Expr, ExprKind, Unary};
use crate::check::Use;
use crate::check::interval::Interval;

/// A place in what is known.
enum Place {
    Size(usize),
    Param(usize),
}

/// What is known where a condition is true, or false; nothing where that cannot be.
pub(super) fn refine(walk: &Walk, condition: &Expr, truth: bool, facts: Facts) -> Option<Facts> {
    match &condition.kind {
        ExprKind::Unary(Unary::Not, operand) => refine(walk, operand, !truth, facts),
        ExprKind::Binary(Binary::And, _, left, right) if truth => {
            refine(walk, right, true, refine(walk, left, true, facts)?)
        }
        ExprKind::Binary(Binary::Or, _, left, right) if !truth => {
            refine(walk, right, false, refine(walk, left, false, facts)?)
        }
        ExprKind::Binary(op, _, left, right) => {
            let Some(op) = settled(*op, truth) else { return Some(facts) };
            let (a, b) = (number(walk, left, &facts), number(walk, right, &facts));
            let facts = narrow(walk, left, op, b, facts)?;
            narrow(walk, right, turned(op), a, facts)
        }
        _ => Some(facts),
    }
}

fn number(walk: &Walk, expr: &Expr, facts: &Facts) -> Interval {
    walk.known.value(walk.tables, expr, facts).number()
}

/// The comparison that holds.
fn settled(op: Binary, truth: bool) -> Option<Binary> {
    Some(match (op, truth) {
        (Binary::Lt, true) | (Binary::Ge, false) => Binary::Lt,
        (Binary::Le, true) | (Binary::Gt, false) => Binary::Le,
        (Binary::Gt, true) | (Binary::Le, false) => Binary::Gt,
        (Binary::Ge, true) | (Binary::Lt, false) => Binary::Ge,
        (Binary::Eq, true) | (Binary::Ne, false) => Binary::Eq,
        _ => return None,
    })
}

fn turned(op: Binary) -> Binary {
    match op {
        Binary::Lt => Binary::Gt,
        Binary::Le => Binary::Ge,
        Binary::Gt => Binary::Lt,
        Binary::Ge => Binary::Le,
        other => other,
    }
}

fn place(walk: &Walk, expr: &Expr) -> Option<Place> {
    let ExprKind::Name(name) = &expr.kind else { return None };
    match walk.tables.of(name)? {
        Use::Param(index) => Some(Place::Param(index as usize)),
        Use::Shape(row) => match row.name {
            "scope.sx" => Some(Place::Size(0)),
            "scope.sy" => Some(Place::Size(1)),
            "scope.sz" => Some(Place::Size(2)),
            _ => None,
        },
        _ => None,
    }
}

/// Cuts off what a comparison rules out. Ends stay in, so that it does not matter whether they are.
fn narrow(walk: &Walk, expr: &Expr, op: Binary, with: Interval, mut facts: Facts) -> Option<Facts> {
    let Some(place) = place(walk, expr) else { return Some(facts) };
    // What is no number compares as it likes.
    if with.odd {
        return Some(facts);
    }
    let value = match place {
        Place::Size(axis) => &mut facts.shape.size[axis],
        Place::Param(index) => match facts.params.get_mut(index) {
            Some(super::values::Value::Number(number)) => number,
            _ => return Some(facts),
        },
    };
    if value.odd {
        return Some(facts);
    }
    match op {
        Binary::Lt | Binary::Le => value.hi = value.hi.min(with.hi),
        Binary::Gt | Binary::Ge => value.lo = value.lo.max(with.lo),
        _ => (value.lo, value.hi) = (value.lo.max(with.lo), value.hi.min(with.hi)),
    }
    (value.lo <= value.hi).then_some(facts)
}
