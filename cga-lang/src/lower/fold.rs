//! Constant folding.
//!
//! Folds only what gives the same bits at run time on every platform: arithmetic and comparisons, not `sin` or `pow`.
//! A result of infinity or NaN is not folded, because at run time it is a fault with a place.

use crate::ir::{Binary, Expr, ExprKind, Type, Value};
use crate::ops::Meaning;

/// Longest text made while compiling: doubling it again and again must not fill the memory.
const LONGEST_TEXT: usize = 4096;

/// Most elements of an array made while compiling.
const MOST_ELEMENTS: usize = 1024;

/// Values of the grammar that are known.
#[derive(Default)]
pub(crate) struct Folded {
    /// By attribute and constant; attributes have none.
    pub(crate) globals: Vec<Option<Value>>,
    /// By function; only functions without parameters have one.
    pub(crate) functions: Vec<Option<Value>>,
}

/// Folds an expression in place; returns its value when it is known.
pub(crate) fn fold(expr: &mut Expr, known: &Folded) -> Option<Value> {
    let value = match &mut expr.kind {
        ExprKind::Value(value) => return Some(value.clone()),
        ExprKind::Global(id) => known.globals.get(id.0 as usize)?.clone()?,
        ExprKind::Call(id, _, args) => {
            for arg in args.iter_mut() {
                fold(arg, known);
            }
            if !args.is_empty() {
                return None;
            }
            known.functions.get(id.0 as usize)?.clone()?
        }
        ExprKind::Builtin(row, args) => {
            let (meaning, pure) = (row.meaning, row.pure);
            let values: Option<Vec<Value>> =
                args.iter_mut().map(|arg| fold(arg, known)).collect::<Vec<_>>().into_iter().collect();
            builtin(meaning, &values.filter(|_| pure)?)?
        }
        ExprKind::Neg(operand) => match fold(operand, known)? {
            Value::Float(value) => Value::Float(-value),
            _ => return None,
        },
        ExprKind::Not(operand) => match fold(operand, known)? {
            Value::Bool(value) => Value::Bool(!value),
            _ => return None,
        },
        ExprKind::Binary(op, left, right) => {
            let (left, right) = (fold(left, known), fold(right, known));
            binary(*op, left?, right?)?
        }
        ExprKind::Chain(first, links) => {
            let mut all = fold(first, known);
            for (op, operand) in links {
                let operand = fold(operand, known);
                all = all.and_then(|all| binary(*op, all, operand?));
            }
            all?
        }
        ExprKind::ToText(operand) => to_text(fold(operand, known)?)?,
        ExprKind::Case(arms, otherwise) => return case(arms, otherwise, known).and_then(|chosen| put(expr, chosen)),
        ExprKind::Array(rows) => array(rows, known)?,
        _ => {
            for part in expr.parts_mut() {
                fold(part, known);
            }
            return None;
        }
    };
    expr.kind = ExprKind::Value(value.clone());
    Some(value)
}

/// Replaces a `case` by the branch that is always taken.
fn put(expr: &mut Expr, chosen: Expr) -> Option<Value> {
    expr.kind = chosen.kind;
    match &expr.kind {
        ExprKind::Value(value) => Some(value.clone()),
        _ => None,
    }
}

/// Leaves out branches that are never taken; returns the one that is always taken.
fn case(arms: &mut Vec<(Expr, Expr)>, otherwise: &mut Box<Expr>, known: &Folded) -> Option<Expr> {
    let mut left = Vec::new();
    let mut settled = None;
    for (mut condition, mut value) in std::mem::take(arms) {
        match fold(&mut condition, known) {
            Some(Value::Bool(false)) => continue,
            test => {
                fold(&mut value, known);
                if test == Some(Value::Bool(true)) {
                    settled = Some(value);
                    break;
                }
                left.push((condition, value));
            }
        }
    }
    match settled {
        Some(value) => **otherwise = value,
        None => _ = fold(otherwise, known),
    }
    *arms = left;
    let empty = Expr { kind: ExprKind::Value(Value::Bool(false)), ty: Type::Bool, span: otherwise.span };
    arms.is_empty().then(|| std::mem::replace(&mut **otherwise, empty))
}

/// An array of known single values in equal rows.
fn array(rows: &mut [Vec<Expr>], known: &Folded) -> Option<Value> {
    let mut values = Vec::with_capacity(rows.len());
    for row in rows.iter_mut() {
        let row: Vec<Option<Value>> = row.iter_mut().map(|entry| fold(entry, known)).collect();
        values.push(row);
    }
    let columns = values.first().map_or(0, Vec::len);
    let rows: Option<Vec<Vec<Value>>> = values.into_iter().map(|row| row.into_iter().collect()).collect();
    let rows = rows?;
    let even = 0 < columns && rows.iter().all(|row| row.len() == columns);
    let single = rows.iter().flatten().all(|entry| !matches!(entry, Value::Array(_)));
    (even && single && rows.len() * columns <= MOST_ELEMENTS).then_some(Value::Array(rows))
}

fn finite(value: f64) -> Option<Value> {
    value.is_finite().then_some(Value::Float(value))
}

fn binary(op: Binary, left: Value, right: Value) -> Option<Value> {
    use std::cmp::Ordering::{Equal, Greater, Less};
    let order = match (&left, &right) {
        (Value::Float(a), Value::Float(b)) => a.partial_cmp(b)?,
        (Value::Bool(a), Value::Bool(b)) => a.cmp(b),
        (Value::Text(a), Value::Text(b)) => a.cmp(b),
        // Arrays are compared by the runtime.
        _ => return None,
    };
    Some(match (op, left, right) {
        (Binary::Add, Value::Float(a), Value::Float(b)) => finite(a + b)?,
        (Binary::Sub, Value::Float(a), Value::Float(b)) => finite(a - b)?,
        (Binary::Mul, Value::Float(a), Value::Float(b)) => finite(a * b)?,
        (Binary::Div, Value::Float(a), Value::Float(b)) => finite(a / b)?,
        (Binary::Rem, Value::Float(a), Value::Float(b)) => finite(a % b)?,
        (Binary::Add, Value::Text(a), Value::Text(b)) if a.len() + b.len() <= LONGEST_TEXT => Value::Text(a + &b),
        (Binary::And, Value::Bool(a), Value::Bool(b)) => Value::Bool(a && b),
        (Binary::Or, Value::Bool(a), Value::Bool(b)) => Value::Bool(a || b),
        (Binary::Eq, ..) => Value::Bool(order == Equal),
        (Binary::Ne, ..) => Value::Bool(order != Equal),
        (Binary::Lt, ..) => Value::Bool(order == Less),
        (Binary::Le, ..) => Value::Bool(order != Greater),
        (Binary::Gt, ..) => Value::Bool(order == Greater),
        (Binary::Ge, ..) => Value::Bool(order != Less),
        _ => return None,
    })
}

fn to_text(value: Value) -> Option<Value> {
    match value {
        Value::Text(text) => Some(Value::Text(text)),
        Value::Bool(value) => Some(Value::Text(value.to_string())),
        // The runtime formats fractions. Whole numbers have one format only.
        Value::Float(value) if value.fract() == 0.0 && value.abs() < 1e9 => {
            Some(Value::Text(format!("{}", value as i64)))
        }
        Value::Float(_) | Value::Array(_) => None,
    }
}

fn builtin(meaning: Meaning, args: &[Value]) -> Option<Value> {
    match (meaning, args) {
        (Meaning::Floor, [Value::Float(a)]) => finite(a.floor()),
        (Meaning::Ceil, [Value::Float(a)]) => finite(a.ceil()),
        (Meaning::Abs, [Value::Float(a)]) => finite(a.abs()),
        (Meaning::Sqrt, [Value::Float(a)]) => finite(a.sqrt()),
        (Meaning::BoolToFloat, [Value::Bool(a)]) => Some(Value::Float(f64::from(u8::from(*a)))),
        (Meaning::FloatToBool, [Value::Float(a)]) => Some(Value::Bool(*a != 0.0)),
        (Meaning::Round, [Value::Float(a)]) => finite(a.round_ties_even()),
        // Which zero wins is left to the runtime.
        (Meaning::Min, [Value::Float(a), Value::Float(b)]) if a != b => finite(a.min(*b)),
        (Meaning::Max, [Value::Float(a), Value::Float(b)]) if a != b => finite(a.max(*b)),
        _ => None,
    }
}

impl Value {
    /// Its type.
    pub fn ty(&self) -> Type {
        match self {
            Value::Float(_) => Type::Float,
            Value::Bool(_) => Type::Bool,
            Value::Text(_) => Type::Text,
            Value::Array(rows) => {
                rows.first().and_then(|row| row.first()).map_or(Type::Floats, |first| first.ty().array())
            }
        }
    }
}
