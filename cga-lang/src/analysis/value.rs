//! The abstract value of an expression.

use super::interval::Interval;
use super::texts::TextSet;
use crate::ir::Type;
use crate::syntax::ast::Binary;

/// An abstract value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Value {
    /// A number of an interval.
    Number(Interval),
    /// A truth value; `None` if both are possible.
    Truth(Option<bool>),
    /// A text of a set.
    Text(TextSet),
    /// Any value of any type.
    Any,
}

impl Value {
    /// Any value of a type.
    pub(super) fn of(ty: Option<Type>) -> Value {
        match ty {
            Some(Type::Float) => Value::Number(Interval::ALL),
            Some(Type::Bool) => Value::Truth(None),
            Some(Type::Text) => Value::Text(TextSet::ANY),
            _ => Value::Any,
        }
    }

    /// The value as a number.
    pub(crate) fn number(self) -> Interval {
        match self {
            Value::Number(interval) => interval,
            _ => Interval::ALL,
        }
    }

    /// The value as a truth value, if it is certain.
    pub(crate) fn truth(self) -> Option<bool> {
        match self {
            Value::Truth(truth) => truth,
            _ => None,
        }
    }

    /// The join of two values.
    pub(super) fn or(self, other: Value) -> Value {
        match (self, other) {
            (Value::Number(a), Value::Number(b)) => Value::Number(a.or(b)),
            (Value::Truth(a), Value::Truth(b)) => Value::Truth(a.filter(|_| a == b)),
            (Value::Text(a), Value::Text(b)) => Value::Text(a.or(b)),
            _ => Value::Any,
        }
    }

    /// Widens the parts that have changed since `before`.
    pub(super) fn widen(self, before: Value) -> Value {
        match (self, before) {
            (Value::Number(a), Value::Number(b)) => Value::Number(a.widen(b)),
            (now, _) => now,
        }
    }

    /// The transfer function of a binary operator.
    pub(super) fn binary(op: Binary, left: Value, right: Value) -> Value {
        match (op, left, right) {
            (Binary::And | Binary::Or, ..) => {
                let decisive = op == Binary::Or;
                Value::Truth(match (left.truth(), right.truth()) {
                    (Some(a), _) | (_, Some(a)) if a == decisive => Some(decisive),
                    (Some(_), Some(_)) => Some(!decisive),
                    _ => None,
                })
            }
            (Binary::Eq, ..) => Value::Truth(left.same(right)),
            (Binary::Ne, ..) => Value::Truth(left.same(right).map(|same| !same)),
            (_, Value::Number(a), Value::Number(b)) => match op {
                Binary::Add => Value::Number(a.add(b)),
                Binary::Sub => Value::Number(a.sub(b)),
                Binary::Mul => Value::Number(a.mul(b)),
                Binary::Div => Value::Number(a.div(b)),
                Binary::Rem => Value::Number(a.rem(b)),
                Binary::Lt => Value::Truth(a.less(b)),
                Binary::Gt => Value::Truth(a.at_most(b).map(|at_most| !at_most)),
                Binary::Le => Value::Truth(a.at_most(b)),
                Binary::Ge => Value::Truth(a.less(b).map(|less| !less)),
                Binary::And | Binary::Or | Binary::Eq | Binary::Ne => Value::Any,
            },
            (Binary::Lt | Binary::Le | Binary::Gt | Binary::Ge, ..) => Value::Truth(None),
            // With text on one side, `+` concatenates.
            _ => Value::Any,
        }
    }

    /// The result of `==`, if it is certain.
    fn same(self, other: Value) -> Option<bool> {
        match (self, other) {
            (Value::Number(a), Value::Number(b)) => a.same(b),
            (Value::Truth(Some(a)), Value::Truth(Some(b))) => Some(a == b),
            (Value::Text(a), Value::Text(b)) => a.same(b),
            _ => None,
        }
    }
}
