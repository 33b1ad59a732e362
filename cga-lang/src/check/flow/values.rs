//! What is known of values: of attributes, constants and functions once, of expressions wherever they stand.

use super::shape::Shape;
use crate::ast::{Binary, Expr, ExprKind, Unary};
use crate::check::globals::{Globals, Init};
use crate::check::interval::Interval;
use crate::check::{Tables, Use};
use crate::ir::{ChoiceValues, Type};
use std::collections::HashSet;

/// What is known of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::check) enum Value {
    Number(Interval),
    /// `None`: it may be both.
    Truth(Option<bool>),
    /// Anything, of any type.
    Any,
}

impl Value {
    /// As a number.
    pub(in crate::check) fn number(self) -> Interval {
        match self {
            Value::Number(interval) => interval,
            Value::Truth(_) | Value::Any => Interval::ALL,
        }
    }

    /// As a truth value.
    pub(in crate::check) fn truth(self) -> Option<bool> {
        match self {
            Value::Truth(truth) => truth,
            Value::Number(_) | Value::Any => None,
        }
    }

    pub(super) fn or(self, other: Value) -> Value {
        match (self, other) {
            (Value::Number(a), Value::Number(b)) => Value::Number(a.or(b)),
            (Value::Truth(a), Value::Truth(b)) => Value::Truth(a.filter(|_| a == b)),
            _ => Value::Any,
        }
    }

    pub(super) fn widen(self, before: Value) -> Value {
        match (self, before) {
            (Value::Number(a), Value::Number(b)) => Value::Number(a.widen(b)),
            (now, _) => now,
        }
    }

    /// Anything of a type.
    fn of(ty: Option<Type>) -> Value {
        match ty {
            Some(Type::Float) => Value::Number(Interval::ALL),
            Some(Type::Bool) => Value::Truth(None),
            _ => Value::Any,
        }
    }
}

/// What attributes count as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::check) enum Attrs {
    /// Whatever a run accepts.
    Accepted,
    /// The default, where a run accepts anything.
    Defaults,
}

/// What is known of the values of a grammar.
pub(in crate::check) struct Known {
    attrs: Vec<Value>,
    consts: Vec<Value>,
    functions: Vec<Value>,
}

/// Where an expression stands: what is known there.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::check) struct Facts {
    pub(in crate::check) shape: Shape,
    /// Parameters, then locals.
    pub(in crate::check) params: Vec<Value>,
}

impl Facts {
    /// Nothing is known.
    pub(in crate::check) fn any(params: usize) -> Facts {
        Facts { shape: Shape::ANY, params: vec![Value::Any; params] }
    }
}

impl Facts {
    /// The same values on a shape of which nothing is known.
    pub(in crate::check) fn on_any_shape(&self) -> Facts {
        Facts { shape: Shape::ANY, params: self.params.clone() }
    }
}

impl Known {
    pub(super) fn new(globals: &Globals, tables: &Tables, mode: Attrs) -> Known {
        let (attrs, consts) = (globals.attrs.len(), globals.consts.len());
        let mut known = Known {
            attrs: vec![Value::Any; attrs],
            consts: vec![Value::Any; consts],
            functions: vec![Value::Any; globals.functions.len()],
        };
        let mut changing: HashSet<u32> = tables.targets.values().copied().collect();
        changing.extend(tables.uses.values().filter_map(|found| match found {
            Use::SetAttr(index) => Some(*index),
            _ => None,
        }));
        for &node in &tables.order {
            if node < attrs {
                known.attrs[node] = known.attr(globals, tables, node, changing.contains(&(node as u32)), mode);
            } else if node < attrs + consts {
                known.consts[node - attrs] = known.alone(tables, &globals.consts[node - attrs]);
            } else if !tables.recursive.contains(&((node - attrs - consts) as u32)) {
                known.functions[node - attrs - consts] = known.alone(tables, &globals.functions[node - attrs - consts]);
            }
        }
        known
    }

    /// The value of a declaration, on any shape and with any arguments.
    fn alone(&self, tables: &Tables, item: &crate::check::Item) -> Value {
        let Some((value, _)) = item.value() else { return Value::Any };
        let mut facts = Facts::any(if item.is_own() { item.decl.params.len() } else { 0 });
        if item.is_own() {
            self.enter_locals(tables, item.decl, &mut facts);
        }
        self.value(tables, value, &facts)
    }

    /// Adds the locals of a declaration.
    pub(super) fn enter_locals(&self, tables: &Tables, decl: &crate::ast::Decl, facts: &mut Facts) {
        for (_, local) in &decl.locals {
            let value = self.value(tables, local, facts);
            facts.params.push(value);
        }
    }

    fn attr(&self, globals: &Globals, tables: &Tables, index: usize, changes: bool, mode: Attrs) -> Value {
        let item = &globals.attrs[index];
        let any = Value::of(tables.types.get(&item.decl.name.id()).copied());
        if changes {
            return any;
        }
        let default = match item.init {
            Init::Flows(outer) => self.attrs[outer as usize],
            _ => self.alone(tables, item),
        };
        // What the host program sets is held to these; a default need not be.
        let info = tables.attrs.get(index);
        let range = info.and_then(|info| info.range).filter(|range| range.restricted);
        if let (Some(range), Value::Number(_)) = (range, any) {
            return Value::Number(Interval::between(range.min, range.max)).or(default);
        }
        let choices = info.and_then(|info| info.choices.as_ref()).filter(|choices| choices.restricted);
        if let (Some(ChoiceValues::Floats(list)), Value::Number(_)) = (choices.map(|choices| &choices.values), any)
            && let Some(all) = list.iter().map(|value| Interval::point(*value)).reduce(Interval::or)
        {
            return Value::Number(all).or(default);
        }
        match (mode, default) {
            (Attrs::Defaults, Value::Number(number)) if number.known().is_some() => default,
            _ => any,
        }
    }

    /// What is known of an expression.
    pub(in crate::check) fn value(&self, tables: &Tables, expr: &Expr, facts: &Facts) -> Value {
        let value = |part: &Expr| self.value(tables, part, facts);
        match &expr.kind {
            ExprKind::Number(number) => Value::Number(Interval::point(*number)),
            ExprKind::Bool(truth) => Value::Truth(Some(*truth)),
            ExprKind::Name(name) => tables.of(name).map_or(Value::Any, |found| self.used(found, &[], facts)),
            ExprKind::Call(name, args) => {
                let Some(found) = tables.of(name) else { return Value::Any };
                let args: Vec<Value> = args.iter().map(value).collect();
                self.used(found, &args, facts)
            }
            ExprKind::Unary(Unary::Plus, operand) => value(operand),
            ExprKind::Unary(Unary::Minus, operand) => match value(operand) {
                Value::Number(number) => Value::Number(number.neg()),
                _ => Value::Any,
            },
            ExprKind::Unary(Unary::Not, operand) => Value::Truth(value(operand).truth().map(|truth| !truth)),
            ExprKind::Binary(op, _, left, right) => binary(*op, value(left), value(right)),
            ExprKind::Case(arms, otherwise) => {
                let mut found: Option<Value> = None;
                for (condition, result) in arms {
                    let truth = value(condition).truth();
                    if truth != Some(false) {
                        let result = value(result);
                        found = Some(found.map_or(result, |found| found.or(result)));
                    }
                    if truth == Some(true) {
                        return found.unwrap_or(Value::Any);
                    }
                }
                let otherwise = value(otherwise);
                found.map_or(otherwise, |found| found.or(otherwise))
            }
            ExprKind::Chance(arms, otherwise) => {
                arms.iter().fold(value(otherwise), |all, (_, result)| all.or(value(result)))
            }
            _ => Value::Any,
        }
    }

    fn used(&self, found: Use, args: &[Value], facts: &Facts) -> Value {
        match found {
            Use::Param(index) => facts.params.get(index as usize).copied().unwrap_or(Value::Any),
            Use::Attr(index) => self.attrs[index as usize],
            Use::Const(index) => self.consts[index as usize],
            Use::Function(index) => self.functions[index as usize],
            Use::Convert(Type::Float) => match args {
                [number @ Value::Number(_)] => *number,
                _ => Value::Number(Interval::ALL),
            },
            Use::Builtin(row) if row.ty == Type::Float => {
                let args: Vec<Interval> = args.iter().map(|arg| arg.number()).collect();
                Value::Number(Interval::function(row.name, &args))
            }
            Use::Builtin(row) => Value::of(Some(row.ty)),
            Use::Shape(row) => match row.name {
                "scope.sx" => Value::Number(facts.shape.size[0]),
                "scope.sy" => Value::Number(facts.shape.size[1]),
                "scope.sz" => Value::Number(facts.shape.size[2]),
                "split.index" | "split.total" => Value::Number(Interval::EXTENT),
                _ => Value::of(Some(row.ty)),
            },
            _ => Value::Any,
        }
    }
}

fn binary(op: Binary, left: Value, right: Value) -> Value {
    let (a, b) = match (op, left, right) {
        (Binary::And | Binary::Or, ..) => {
            let decisive = op == Binary::Or;
            return Value::Truth(match (left.truth(), right.truth()) {
                (Some(a), _) | (_, Some(a)) if a == decisive => Some(decisive),
                (Some(_), Some(_)) => Some(!decisive),
                _ => None,
            });
        }
        (Binary::Eq, Value::Truth(Some(a)), Value::Truth(Some(b))) => return Value::Truth(Some(a == b)),
        (Binary::Ne, Value::Truth(Some(a)), Value::Truth(Some(b))) => return Value::Truth(Some(a != b)),
        (_, Value::Number(a), Value::Number(b)) => (a, b),
        (Binary::Eq | Binary::Ne | Binary::Lt | Binary::Le | Binary::Gt | Binary::Ge, ..) => {
            return Value::Truth(None);
        }
        // Text beside it makes `+` text.
        _ => return Value::Any,
    };
    let not = |truth: Option<bool>| truth.map(|truth| !truth);
    match op {
        Binary::Add => Value::Number(a.add(b)),
        Binary::Sub => Value::Number(a.sub(b)),
        Binary::Mul => Value::Number(a.mul(b)),
        Binary::Div => Value::Number(a.div(b)),
        Binary::Rem => Value::Number(a.rem(b)),
        Binary::Lt => Value::Truth(a.less(b)),
        Binary::Gt => Value::Truth(b.less(a)),
        Binary::Le => Value::Truth(not(b.less(a))),
        Binary::Ge => Value::Truth(not(a.less(b))),
        Binary::Eq => Value::Truth(a.same(b)),
        Binary::Ne => Value::Truth(not(a.same(b))),
        Binary::And | Binary::Or => Value::Truth(None),
    }
}
