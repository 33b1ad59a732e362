//! Refines the values that a condition compares, on the branch that is taken.

use super::evaluator::Evaluator;
use super::facts::AbstractState;

use super::interval::Interval;
use super::texts::TextSet;
use super::value::Value;
use crate::ir::GlobalId;
use crate::ops::AttrValues;
use crate::resolve::tables::Use;
use crate::syntax::ast::{Binary, Expr, ExprKind, Unary};

/// A value of the state that can be refined.
enum Refinable {
    Size(usize),
    Param(usize),
    Global(GlobalId),
}

impl Evaluator<'_> {
    /// The state on the branch where a condition is true, or false; `None` if that branch is never taken.
    pub(super) fn refine(
        &self,
        condition: &Expr,
        truth: bool,
        facts: AbstractState,
        depth: u32,
    ) -> Option<AbstractState> {
        match &condition.kind {
            ExprKind::Unary(Unary::Not, operand) => self.refine(operand, !truth, facts, depth),
            ExprKind::Binary(Binary::And, _, left, right) if truth => {
                self.refine(right, true, self.refine(left, true, facts, depth)?, depth)
            }
            ExprKind::Binary(Binary::Or, _, left, right) if !truth => {
                self.refine(right, false, self.refine(left, false, facts, depth)?, depth)
            }
            ExprKind::Chain(first, links) => match links.first()?.op {
                Binary::And | Binary::Or if (links[0].op == Binary::And) == truth => {
                    let facts = self.refine(first, truth, facts, depth)?;
                    links.iter().try_fold(facts, |facts, link| self.refine(&link.operand, truth, facts, depth))
                }
                _ => Some(facts),
            },
            ExprKind::Binary(op, _, left, right) => {
                let Some(holds) = Holds::new(*op, truth) else { return Some(facts) };
                if self.place(left, &facts).is_none() && self.place(right, &facts).is_none() {
                    return Some(facts);
                }
                let (a, b) = (self.within(left, &facts, depth), self.within(right, &facts, depth));
                let facts = self.narrow(left, holds, b, facts)?;
                self.narrow(right, holds.turned(), a, facts)
            }
            ExprKind::Name(_) => self.narrow(condition, Holds::SAME, Value::Truth(Some(truth)), facts),
            _ => Some(facts),
        }
    }

    fn place(&self, expr: &Expr, facts: &AbstractState) -> Option<Refinable> {
        let ExprKind::Name(name) = &expr.kind else { return None };
        match self.of(name, facts)? {
            Use::Param(index) => Some(Refinable::Param(index as usize)),
            Use::Attr(index) if self.is_constant(index) => Some(Refinable::Global(GlobalId(index))),
            Use::Const(index) => Some(Refinable::Global(self.constant(index))),
            Use::Shape(row) => match row.values {
                AttrValues::Size(axis) => Some(Refinable::Size(axis)),
                AttrValues::Any | AttrValues::From(_) => None,
            },
            _ => None,
        }
    }

    /// Removes the values that a comparison excludes.
    fn narrow(&self, expr: &Expr, holds: Holds, with: Value, mut facts: AbstractState) -> Option<AbstractState> {
        let Some(place) = self.place(expr, &facts) else { return Some(facts) };
        let narrowed = holds.narrowed(self.within(expr, &facts, 0), with)?;
        match place {
            Refinable::Size(axis) => {
                let size = narrowed.number().tame();
                if facts.shape.size[axis] != size {
                    (facts.shape.size[axis], facts.shape.since[axis]) = (size, None);
                    // A face with a depth is not planar.
                    facts.shape.is_face &= axis != 2 || size.lo <= 0.0 && 0.0 <= size.hi;
                }
            }
            Refinable::Param(index) => {
                if let Some(param) = facts.params.get_mut(index) {
                    *param = narrowed;
                }
            }
            Refinable::Global(global) => facts.set_global(global, narrowed),
        }
        Some(facts)
    }
}

/// A comparison that holds for the value on its left side, or an equation that fails.
#[derive(Clone, Copy)]
struct Holds {
    op: Binary,
    /// NaN satisfies it too.
    or_nan: bool,
}

impl Holds {
    const SAME: Holds = Holds { op: Binary::Eq, or_nan: false };

    /// The comparison that holds on the branch where another one is true, or false.
    fn new(op: Binary, truth: bool) -> Option<Holds> {
        let (op, or_nan) = match (op, truth) {
            (Binary::Lt, true) | (Binary::Ge, false) => (Binary::Lt, true),
            (Binary::Le, true) | (Binary::Gt, false) => (Binary::Le, true),
            (Binary::Gt, true) | (Binary::Le, false) => (Binary::Gt, false),
            (Binary::Ge, true) | (Binary::Lt, false) => (Binary::Ge, false),
            (Binary::Eq, true) | (Binary::Ne, false) => (Binary::Eq, false),
            (Binary::Ne, true) | (Binary::Eq, false) => (Binary::Ne, true),
            _ => return None,
        };
        Some(Holds { op, or_nan })
    }

    /// The comparison with its sides swapped.
    fn turned(self) -> Holds {
        let op = match self.op {
            Binary::Lt => Binary::Gt,
            Binary::Le => Binary::Ge,
            Binary::Gt => Binary::Lt,
            Binary::Ge => Binary::Le,
            other => other,
        };
        Holds { op, ..self }
    }

    /// The rest of the left value, given the right one; `None` if no value is left.
    fn narrowed(self, value: Value, with: Value) -> Option<Value> {
        let is_same = self.op == Binary::Eq;
        Some(match (value, with) {
            (Value::Number(number), Value::Number(with)) => Value::Number(self.number(number, with)?),
            (Value::Any, Value::Number(with)) => Value::Number(self.number(Interval::ALL, with)?),
            (Value::Text(_) | Value::Any, Value::Text(with)) => {
                let texts = if let Value::Text(texts) = value { texts } else { TextSet::ANY };
                match self.op {
                    Binary::Eq => Value::Text(texts.and(with)?),
                    Binary::Ne => Value::Text(texts.without(with)?),
                    _ => value,
                }
            }
            (Value::Truth(_) | Value::Any, Value::Truth(Some(with))) => {
                let here = with == is_same;
                if value.truth() == Some(!here) {
                    return None;
                }
                Value::Truth(Some(here))
            }
            _ => value,
        })
    }

    /// Ends stay included, for strict comparisons too.
    fn number(self, number: Interval, with: Interval) -> Option<Interval> {
        match self.op {
            Binary::Ne => Some(number),
            _ if !self.or_nan => number.ordered().compared(self.op, with),
            // NaN on the other side may satisfy it.
            _ if with.may_be_nan() => Some(number),
            _ => match number.compared(self.op, with) {
                None if number.may_be_nan() => Some(number),
                found => found,
            },
        }
    }
}
