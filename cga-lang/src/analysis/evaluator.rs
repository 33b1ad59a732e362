//! Abstract values of attributes, constants and functions, computed once, and of expressions at any point.

use super::facts::AbstractState;
use super::interval::Interval;
use super::texts::{TextSet, Texts};
use super::value::Value;
use crate::ir::{AttrInfo, ChoiceValues, GlobalId, Type};
use crate::link::InstanceId;
use crate::ops::{AttrValues, Meaning};
use crate::resolve::globals::{Declared, Globals, Initializer};
use crate::resolve::tables::{Tables, Use};
use crate::syntax::ast::{Binary, Decl, Expr, ExprKind, Link, Name, Unary};
use crate::syntax::token::Tok;
use std::cell::Cell;
use std::collections::{HashMap, HashSet};

/// The nesting depth up to which calls of functions are evaluated with their arguments.
const DEEPEST: u32 = 3;

/// The steps that one evaluation may take; beyond them the result is unknown.
const MOST_STEPS: u32 = 5_000;

/// The steps of all evaluations of a program; after them each evaluation has few.
const MOST_IN_ALL: u64 = 3_000_000;

/// The steps of one evaluation after that.
const FEW_STEPS: u32 = 200;

/// The largest number of parameters and locals of a function that is evaluated with its arguments.
const MOST_LOCALS: usize = 40;

/// The assumption about the values of attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Attrs {
    /// Any value that a run accepts.
    Accepted,
    /// The default value, where a run accepts any value.
    Defaults,
}

/// A function that is evaluated with its arguments.
#[derive(Clone, Copy)]
struct Callee<'f> {
    /// The instance whose entries its names have.
    own: InstanceId,
    decl: &'f Decl,
    body: &'f Expr,
}

/// The abstract values of a grammar.
pub(crate) struct Evaluator<'f> {
    tables: &'f Tables,
    /// All tokens.
    pub(super) tokens: &'f [Tok],
    texts: Texts,
    attrs: Vec<Value>,
    consts: Vec<Value>,
    /// By function: the result for any arguments.
    functions: Vec<Value>,
    /// Functions without recursion, to be evaluated with their arguments.
    bodies: Vec<Option<Callee<'f>>>,
    /// By rule: the instance whose entries its names have.
    pub(super) rules: Vec<InstanceId>,
    /// The attributes that rules set.
    changing: HashSet<u32>,
    /// The number of steps left for this evaluation.
    steps: Cell<u32>,
    /// The number of steps taken so far.
    taken: Cell<u64>,
}

impl<'f> Evaluator<'f> {
    pub(crate) fn new(globals: &Globals<'f>, tables: &'f Tables, mode: Attrs) -> Evaluator<'f> {
        let (attrs, consts) = (globals.attrs.len(), globals.consts.len());
        let body = |(index, item): (usize, &Declared<'f>)| {
            let (body, own) = item.value().filter(|_| item.is_own() && !tables.recursive.contains(&(index as u32)))?;
            Some(Callee { own, decl: item.decl, body })
        };
        let mut known = Evaluator {
            tables,
            tokens: globals.program.tokens.as_slice(),
            texts: Texts::new(globals.program.tokens.as_slice()),
            attrs: vec![Value::Any; attrs],
            consts: vec![Value::Any; consts],
            functions: vec![Value::Any; globals.functions.len()],
            bodies: globals.functions.iter().enumerate().map(body).collect(),
            rules: globals.rules.iter().map(|item| item.own).collect(),
            changing: tables.targets.values().copied().collect(),
            steps: Cell::new(MOST_STEPS),
            taken: Cell::new(0),
        };
        known.changing.extend(tables.uses.values().filter_map(|found| match found {
            Use::SetAttr(index) => Some(*index),
            _ => None,
        }));
        let mut first: HashMap<&str, usize> = HashMap::new();
        for (index, item) in globals.attrs.iter().enumerate() {
            first.entry(&item.name).or_insert(index);
        }
        for &node in &tables.order {
            if node < attrs {
                let first = first[globals.attrs[node].name.as_str()];
                known.attrs[node] = known.attr(globals, node, first, mode);
            } else if node < attrs + consts {
                known.consts[node - attrs] = known.alone(&globals.consts[node - attrs]);
            } else if !tables.recursive.contains(&((node - attrs - consts) as u32)) {
                known.functions[node - attrs - consts] = known.alone(&globals.functions[node - attrs - consts]);
            }
        }
        known
    }

    /// The value of a declaration, on any shape and with any arguments.
    fn alone(&self, item: &Declared) -> Value {
        let Some((value, own)) = item.value() else { return Value::Any };
        let mut facts = AbstractState::any(own, if item.is_own() { item.decl.params.len() } else { 0 });
        if item.is_own() {
            self.begin();
            self.enter_locals(item.decl, &mut facts, 0);
        }
        self.value(value, &facts)
    }

    /// Adds the locals of a declaration.
    fn enter_locals(&self, decl: &Decl, facts: &mut AbstractState, depth: u32) {
        for (_, local) in &decl.locals {
            let value = self.within(local, facts, depth);
            facts.params.push(value);
        }
    }

    /// The value of an attribute; `first` is the number of the first of its name.
    fn attr(&self, globals: &Globals, index: usize, first: usize, mode: Attrs) -> Value {
        let item = &globals.attrs[index];
        let any = Value::of(item.ty(self.tables));
        if self.changing.contains(&(index as u32)) {
            return any;
        }
        let default = match item.init {
            Initializer::Flows(outer) => self.attrs[outer as usize],
            _ => self.alone(item),
        };
        // A value from the host program is checked against them, a default is not. All styles share the field of an attribute.
        let info = self.tables.attrs.get(first);
        if let (Some(range), Value::Number(_)) = (info.and_then(AttrInfo::held_to_range), any) {
            return Value::Number(Interval::between(range.min, range.max)).or(default);
        }
        let all = match (info.and_then(AttrInfo::held_to_choices), any) {
            (Some(ChoiceValues::Floats(list)), Value::Number(_)) => {
                list.iter().map(|value| Interval::point(*value)).reduce(Interval::or).map(Value::Number)
            }
            (Some(ChoiceValues::Texts(list)), Value::Text(_)) => {
                list.iter().map(|text| Value::Text(self.texts.set(text))).reduce(Value::or)
            }
            _ => None,
        };
        if let Some(all) = all {
            return all.or(default);
        }
        match (mode, default) {
            (Attrs::Defaults, Value::Number(number)) if number.known().is_some() => default,
            _ => any,
        }
    }

    /// A set of texts for messages.
    pub(crate) fn told(&self, set: TextSet) -> Option<String> {
        self.texts.told(set)
    }

    /// The meaning of a name.
    pub(super) fn of(&self, name: &Name, facts: &AbstractState) -> Option<Use> {
        self.tables.at(facts.own).of(name)
    }

    /// Returns true if an attribute has the same value on all shapes of a run.
    pub(super) fn is_constant(&self, attr: u32) -> bool {
        !self.changing.contains(&attr)
    }

    /// The constant with an index.
    pub(super) fn constant(&self, index: u32) -> GlobalId {
        GlobalId(self.attrs.len() as u32 + index)
    }

    /// The abstract value of an expression.
    pub(crate) fn value(&self, expr: &Expr, facts: &AbstractState) -> Value {
        self.begin();
        self.within(expr, facts, 0)
    }

    /// Resets the steps of the evaluation.
    fn begin(&self) {
        let most = |taken: u64| if taken < MOST_IN_ALL { MOST_STEPS } else { FEW_STEPS };
        let taken = self.taken.get();
        let taken = taken + u64::from(most(taken).saturating_sub(self.steps.get()));
        self.taken.set(taken);
        self.steps.set(most(taken));
    }

    /// The state on the branch where a condition is true, or false; `None` if that branch is never taken.
    pub(crate) fn past(&self, condition: &Expr, truth: bool, facts: AbstractState) -> Option<AbstractState> {
        self.begin();
        if self.within(condition, &facts, 0).truth() == Some(!truth) {
            return None;
        }
        self.refine(condition, truth, facts, 0)
    }

    /// The abstract value of an expression at a nesting depth of functions.
    pub(super) fn within(&self, expr: &Expr, facts: &AbstractState, depth: u32) -> Value {
        let Some(left) = self.steps.get().checked_sub(1) else { return Value::Any };
        self.steps.set(left);
        let value = |part: &Expr| self.within(part, facts, depth);
        match &expr.kind {
            ExprKind::Number(number) => Value::Number(Interval::point(*number)),
            ExprKind::Bool(truth) => Value::Truth(Some(*truth)),
            ExprKind::Text(text) => Value::Text(self.texts.set(text)),
            ExprKind::Name(name) => {
                self.of(name, facts).map_or(Value::Any, |found| self.used(found, Vec::new(), facts, depth))
            }
            ExprKind::Call(name, args) => {
                let Some(found) = self.of(name, facts) else { return Value::Any };
                self.used(found, args.iter().map(value).collect(), facts, depth)
            }
            ExprKind::Unary(Unary::Plus, operand) => value(operand),
            ExprKind::Unary(Unary::Minus, operand) => match value(operand) {
                Value::Number(number) => Value::Number(number.neg()),
                _ => Value::Any,
            },
            ExprKind::Unary(Unary::Not, operand) => Value::Truth(value(operand).truth().map(|truth| !truth)),
            ExprKind::Binary(op @ (Binary::And | Binary::Or), _, left, right) => {
                self.both(*op, left, right, facts, depth)
            }
            ExprKind::Binary(op, _, left, right) => Value::binary(*op, value(left), value(right)),
            ExprKind::Chain(first, links)
                if matches!(links.first(), Some(Link { op: Binary::And | Binary::Or, .. })) =>
            {
                self.all(first, links, facts, depth)
            }
            ExprKind::Chain(first, links) => {
                links.iter().fold(value(first), |all, link| Value::binary(link.op, all, value(&link.operand)))
            }
            ExprKind::Case(arms, otherwise) => self.case(arms, otherwise, facts, depth),
            ExprKind::Chance(arms, otherwise) => {
                arms.iter().fold(value(otherwise), |all, (_, result)| all.or(value(result)))
            }
            _ => Value::Any,
        }
    }

    /// `&&` or `||`. Both sides are computed, but the right one counts only where the left one does not decide.
    fn both(&self, op: Binary, left: &Expr, right: &Expr, facts: &AbstractState, depth: u32) -> Value {
        let (goes_on, left_is) = (op == Binary::And, self.within(left, facts, depth));
        if left_is.truth() == Some(!goes_on) {
            return left_is;
        }
        match self.refine(left, goes_on, facts.clone(), depth) {
            Some(facts) => Value::binary(op, left_is, self.within(right, &facts, depth)),
            None => Value::Truth(Some(!goes_on)),
        }
    }

    /// A chain of `&&` or `||`, as [`both`](Evaluator::both) of all before each operand.
    fn all(&self, first: &Expr, links: &[Link], facts: &AbstractState, depth: u32) -> Value {
        let (mut all, mut facts, mut last) = (self.within(first, facts, depth), facts.clone(), first);
        for Link { op, operand, .. } in links {
            let goes_on = *op == Binary::And;
            if all.truth() == Some(!goes_on) {
                break;
            }
            match self.refine(last, goes_on, facts, depth) {
                Some(refined) => facts = refined,
                None => return Value::Truth(Some(!goes_on)),
            }
            all = Value::binary(*op, all, self.within(operand, &facts, depth));
            last = operand;
        }
        all
    }

    fn case(&self, arms: &[(Expr, Expr)], otherwise: &Expr, facts: &AbstractState, depth: u32) -> Value {
        let (mut found, mut left) = (None, Some(facts.clone()));
        for (condition, result) in arms {
            let Some(here) = left else { break };
            if self.steps.get() == 0 {
                return Value::Any;
            }
            let truth = self.within(condition, &here, depth).truth();
            let refined = |truth| self.refine(condition, truth, here.clone(), depth);
            if let Some(inside) = refined(true).filter(|_| truth != Some(false)) {
                let result = self.within(result, &inside, depth);
                found = Some(found.map_or(result, |found: Value| found.or(result)));
            }
            left = refined(false).filter(|_| truth != Some(true));
        }
        let otherwise = left.map(|here| self.within(otherwise, &here, depth));
        found.into_iter().chain(otherwise).reduce(Value::or).unwrap_or(Value::Any)
    }

    fn used(&self, found: Use, args: Vec<Value>, facts: &AbstractState, depth: u32) -> Value {
        match found {
            Use::Param(index) => facts.params.get(index as usize).copied().unwrap_or(Value::Any),
            Use::Attr(index) => facts.global(GlobalId(index)).unwrap_or(self.attrs[index as usize]),
            Use::Const(index) => facts.global(self.constant(index)).unwrap_or(self.consts[index as usize]),
            Use::Function(index) => match self.bodies[index as usize] {
                Some(Callee { own, decl, body })
                    if depth < DEEPEST && decl.params.len() == args.len() && decl.locals.len() < MOST_LOCALS =>
                {
                    let mut inside = facts.with(own, args);
                    self.enter_locals(decl, &mut inside, depth + 1);
                    self.within(body, &inside, depth + 1)
                }
                _ => self.functions[index as usize],
            },
            Use::Convert(Type::Float) => match args[..] {
                [number @ Value::Number(_)] => number,
                _ => Value::Number(Interval::ALL),
            },
            Use::Builtin(row) if row.ty == Type::Float => {
                let args: Vec<Interval> = args.iter().map(|arg| arg.number()).collect();
                Value::Number(Interval::function(row.meaning, &args))
            }
            // `p` of a share between 0 and 1 is neither always true nor always false.
            Use::Builtin(row) if row.meaning == Meaning::Chance => Value::Truth(match args[..] {
                [Value::Number(chance)] if 1.0 < chance.lo && !chance.is_odd() => Some(true),
                [Value::Number(chance)] if chance.hi < 0.0 && !chance.is_odd() => Some(false),
                _ => None,
            }),
            Use::Builtin(row) => Value::of(Some(row.ty)),
            Use::Shape(row) => match row.values {
                AttrValues::Size(axis) => Value::Number(facts.shape.size[axis]),
                AttrValues::From(least) => Value::Number(Interval::finite(least, f64::MAX)),
                AttrValues::Any => Value::of(row.kind.ty()),
            },
            _ => Value::Any,
        }
    }
}
