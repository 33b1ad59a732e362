//! Expressions.

use std::cell::Cell;

use cga_lang::ir::plan::RunPlan;
use cga_lang::ir::{
    Arg, Arm, Binary, Comp, EachUnary, Expr, ExprKind, Global, GlobalId, Grammar, HostId, Param, Selector, Type, Value,
};
use cga_lang::ops::ParamKind;
use cga_runtime::rt::{self, Select, Text, func};

use super::arrays;
use super::problems::Problems;
use super::registered::Registered;
use crate::code::{ArmsCode, Code, CompCode, HostCall, HostFunction, Instruction, NumberOperator, Sites, mode};
use crate::dispatch::{self, FunctionCall};
use crate::object::{constant, is_number};
use crate::program::Slot;
use crate::stack::Stack;

/// The tables that all parts of the compiler use.
pub(super) struct Compiler<'g> {
    pub(super) grammar: &'g Grammar,
    pub(super) plan: &'g RunPlan<'g>,
    /// True if blocks tell when they are entered and left.
    pub(super) tells_parts: bool,
    pub(super) slots: Vec<Slot>,
    pub(super) registered: &'g Registered,
    pub(super) problems: Problems,
    /// The number of places with a template so far.
    pub(super) places: Cell<u32>,
    /// The number of places with a change of the material so far.
    pub(super) changes: Cell<u32>,
}

/// The parameters and locals of a rule or function: the index of each among the numbers or the objects.
pub(super) struct Locals(Vec<u32>);

impl Locals {
    /// The index of a parameter.
    pub(super) fn index(&self, number: u32) -> u32 {
        self.0[number as usize]
    }

    pub(super) fn new(params: &[Param]) -> Self {
        let mut counts = [0, 0];
        let index = |param: &Param| {
            let count = &mut counts[usize::from(is_number(param.ty))];
            *count += 1;
            *count - 1
        };
        Locals(params.iter().map(index).collect())
    }
}

/// The numbers of values that are numbers, and that are objects.
pub(super) fn counts(types: impl Iterator<Item = Type>) -> (usize, usize) {
    types.fold(
        (0, 0),
        |(numbers, objects), ty| if is_number(ty) { (numbers + 1, objects) } else { (numbers, objects + 1) },
    )
}

/// The code of expressions, under construction.
#[derive(Default)]
pub(super) struct Steps(pub(super) Vec<Instruction>);

impl Steps {
    fn add(&mut self, instruction: Instruction) {
        self.0.push(instruction);
    }

    fn call(&mut self, call: FunctionCall) {
        self.add(Instruction::Function(call));
    }

    /// Adds a value of Rust code.
    fn host(&mut self, name: String, function: HostFunction, ty: Type) {
        self.add(Instruction::Host(Box::new(HostCall { name, function, args: Box::default(), ty, is_value: true })));
    }

    /// Adds a jump whose end is not known yet.
    fn jump(&mut self) -> usize {
        self.add(Instruction::Jump(0));
        self.0.len() - 1
    }

    /// Sets the end of a jump to the next instruction.
    fn land(&mut self, at: usize) {
        let end = self.0.len() as u32;
        match &mut self.0[at] {
            Instruction::Jump(to) | Instruction::JumpUnless(to) => *to = end,
            _ => {}
        }
    }

    fn value(&mut self, value: &Value) {
        let mut stack = Stack::default();
        stack.push_value(constant(value));
        self.0.extend(stack.numbers.into_iter().map(Instruction::Number));
        self.0.extend(stack.objects.into_iter().map(Instruction::Object));
    }

    /// The code of functions, attributes and constants, which are evaluated on whole shapes or views.
    pub(super) fn finish(self) -> Code {
        Code { steps: self.0.into(), is_whole: false }
    }
}

impl Compiler<'_> {
    /// The code of expressions of a rule.
    pub(super) fn code<'e>(&self, exprs: impl IntoIterator<Item = &'e Expr>, locals: &Locals) -> Code {
        let (mut steps, mut is_whole) = (Steps::default(), false);
        for expr in exprs {
            self.expr(expr, locals, &mut steps);
            is_whole |= self.plan.needs_whole(expr);
        }
        Code { is_whole, ..steps.finish() }
    }

    /// The arguments of an operation. Words are part of the call.
    pub(super) fn args(&self, params: &[cga_lang::ops::Param], args: &[Arg], locals: &Locals) -> Code {
        let (mut steps, mut is_whole) = (Steps::default(), false);
        for (arg, param) in args.iter().zip(params) {
            let value = match arg {
                Arg::Value(value) => value,
                Arg::Length(size) => &size.value,
                Arg::Word(_) => continue,
            };
            is_whole |= self.plan.needs_whole(value);
            match param.kind {
                ParamKind::Image(_) => self.image(value, locals, &mut steps),
                _ => self.expr(value, locals, &mut steps),
            }
        }
        Code { is_whole, ..steps.finish() }
    }

    /// The name of an image, as text.
    pub(super) fn image(&self, expr: &Expr, locals: &Locals, steps: &mut Steps) {
        match &expr.kind {
            // Nothing is looked for.
            ExprKind::File(name, folder) if folder.is_empty() => self.expr(name, locals, steps),
            ExprKind::File(..) => {
                self.expr(expr, locals, steps);
                steps.add(Instruction::Image);
            }
            _ => self.expr(expr, locals, steps),
        }
    }

    /// An expression.
    pub(super) fn expr(&self, expr: &Expr, locals: &Locals, steps: &mut Steps) {
        match &expr.kind {
            ExprKind::Value(known) => steps.value(known),
            ExprKind::Param(number) => {
                let at = locals.index(*number);
                steps.add(if is_number(expr.ty) { Instruction::LocalNumber(at) } else { Instruction::LocalObject(at) });
            }
            ExprKind::Global(id) => self.global(*id, steps),
            ExprKind::Host(id) => {
                let name = self.host_name(*id);
                let function = self.registered.function(&name, &[], expr.ty);
                self.rust_value(name, function, expr, steps);
            }
            ExprKind::Call(id, sites, args) => {
                self.parts(args, locals, steps);
                steps.add(Instruction::Call(id.0, Sites::new(sites.iter().copied())));
            }
            ExprKind::Builtin(function, args) => {
                let values = args.iter().zip(function.params);
                let values = values.filter(|(arg, param)| {
                    param.kind.words().is_none() || !matches!(arg.kind, ExprKind::Value(Value::Text(_)))
                });
                values.for_each(|(arg, _)| self.expr(arg, locals, steps));
                match dispatch::function(function, args) {
                    Some(call) => steps.call(call),
                    None => self.problems.missing(function.name, expr.span),
                }
            }
            ExprKind::Rust(path, args) => {
                self.parts(args, locals, steps);
                let name = spelling(path);
                let Some(function) = self.registered.function(&name, args, expr.ty) else {
                    return self.problems.unregistered(&name, "function", self.registered.is_live, expr.span);
                };
                let args = args.iter().map(|arg| arg.ty).collect();
                steps.add(Instruction::Host(Box::new(HostCall { name, function, args, ty: expr.ty, is_value: false })));
            }
            ExprKind::Shape(attr) => match dispatch::read(attr) {
                Some(call) => steps.call(call),
                None => self.problems.missing(attr.name, expr.span),
            },
            ExprKind::Comp(comp) => self.comp(comp, expr.ty, locals, steps),
            ExprKind::Word(word) => match dispatch::rt_word(word) {
                Some(word) => steps.add(Instruction::Word(word)),
                None => self.problems.missing(word, expr.span),
            },
            ExprKind::Style(styles) => steps.add(Instruction::Style(styles.clone().into())),
            ExprKind::Site(sites) => steps.add(Instruction::Site(sites.clone().into())),
            ExprKind::Array(rows) => {
                self.parts(rows.iter().flatten(), locals, steps);
                let types = rows.iter().map(|row| row.iter().map(|entry| entry.ty).collect()).collect();
                steps.call(arrays::array(expr.ty, types));
            }
            ExprKind::Range(base, step, limit) => {
                self.parts([&**base, step, limit], locals, steps);
                steps.call(FunctionCall::new(|stack, env, _| {
                    let (limit, step, base) = (stack.float(), stack.float(), stack.float());
                    stack.push_floats(func::range_by(env, base, step, limit));
                }));
            }
            ExprKind::Index(array, indices) => {
                self.parts([&**array].into_iter().chain(indices), locals, steps);
                let types: Vec<Type> = indices.iter().map(|index| index.ty).collect();
                steps.call(arrays::index(array.ty, &types));
            }
            ExprKind::EachUnary(operator, inner) => {
                self.expr(inner, locals, steps);
                steps.call(match operator {
                    EachUnary::Neg => FunctionCall::new(|stack, env, _| {
                        let array = func::each_minus(env, stack.floats());
                        stack.push_floats(array);
                    }),
                    EachUnary::Not => FunctionCall::new(|stack, env, _| {
                        let array = func::each_not(env, stack.bools());
                        stack.push_bools(array);
                    }),
                });
            }
            ExprKind::Each(operator, left, right) => {
                self.parts([&**left, right], locals, steps);
                steps.call(arrays::each(*operator, expr.ty, left.ty, right.ty));
            }
            ExprKind::Neg(inner) => {
                self.expr(inner, locals, steps);
                steps.add(Instruction::Neg);
            }
            ExprKind::Not(inner) => {
                self.expr(inner, locals, steps);
                steps.add(Instruction::Not);
            }
            ExprKind::Binary(operator, left, right) => {
                self.parts([&**left, right], locals, steps);
                self.binary(*operator, expr.ty, left.ty, steps);
            }
            ExprKind::Chain(first, links) => {
                self.expr(first, locals, steps);
                for (operator, operand) in links {
                    self.expr(operand, locals, steps);
                    self.binary(*operator, expr.ty, first.ty, steps);
                }
            }
            ExprKind::File(name, folder) => {
                self.expr(name, locals, steps);
                let folder = Text::from(folder.as_str());
                steps.add(if name.ty.is_array() { Instruction::Files(folder) } else { Instruction::File(folder) });
            }
            ExprKind::ToText(inner) => {
                if let ExprKind::Host(id) = inner.kind {
                    return self.shown_value(id, expr, steps);
                }
                self.expr(inner, locals, steps);
                if let Some(call) = arrays::to_text(inner.ty) {
                    steps.call(call);
                }
            }
            ExprKind::Case(arms, otherwise) => self.case(arms, otherwise, locals, steps),
            ExprKind::Chance { percent, before } => {
                steps.add(Instruction::Chance { percent: *percent, before: *before });
            }
        }
    }

    /// A Rust value in the rules, as `#` and the expression.
    fn host_name(&self, id: HostId) -> String {
        let handle = self.grammar.hosts[id.0 as usize].handle;
        self.registered.values.get(handle as usize).cloned().unwrap_or_default()
    }

    /// A Rust value that is joined with text.
    fn shown_value(&self, id: HostId, expr: &Expr, steps: &mut Steps) {
        let name = self.host_name(id);
        let function = self.registered.shown(&name);
        self.rust_value(name, function, expr, steps);
    }

    fn rust_value(&self, name: String, function: Option<HostFunction>, expr: &Expr, steps: &mut Steps) {
        match function {
            Some(function) => steps.host(name, function, expr.ty),
            None => self.problems.captured(&name, expr.ty, expr.span),
        }
    }

    fn parts<'e>(&self, parts: impl IntoIterator<Item = &'e Expr>, locals: &Locals, steps: &mut Steps) {
        parts.into_iter().for_each(|part| self.expr(part, locals, steps));
    }

    fn case(&self, arms: &[(Expr, Expr)], otherwise: &Expr, locals: &Locals, steps: &mut Steps) {
        let mut ends = Vec::new();
        for (condition, value) in arms {
            self.expr(condition, locals, steps);
            steps.add(Instruction::JumpUnless(0));
            let next = steps.0.len() - 1;
            self.expr(value, locals, steps);
            ends.push(steps.jump());
            steps.land(next);
        }
        self.expr(otherwise, locals, steps);
        ends.into_iter().for_each(|end| steps.land(end));
    }

    /// An attribute or constant.
    pub(super) fn global(&self, id: GlobalId, steps: &mut Steps) {
        let global = self.grammar.global(id);
        match (global, self.slots[id.0 as usize]) {
            (Global { attr: None, known: Some(known), .. }, _) => steps.value(known),
            (Global { is_set: false, .. }, Slot::Number(slot)) => steps.add(Instruction::RunNumber(slot)),
            (Global { is_set: false, .. }, Slot::Object(slot)) => steps.add(Instruction::RunObject(slot)),
            _ => steps.add(Instruction::Global(id.0)),
        }
    }

    fn binary(&self, operator: Binary, result: Type, operands: Type, steps: &mut Steps) {
        steps.add(match operands {
            _ if result == Type::Text => Instruction::Concat,
            Type::Float | Type::Bool => Instruction::Numbers(number_operator(operator)),
            Type::Text => Instruction::Texts(number_operator(operator)),
            Type::Floats | Type::Bools | Type::Texts => Instruction::Function(arrays::compare(operator, operands)),
        });
    }

    fn comp(&self, comp: &Comp, ty: Type, locals: &Locals, steps: &mut Steps) {
        let Some((components, align)) = components(&comp.args) else { return };
        let values = comp.arms.iter().map(|arm| {
            let mut steps = Steps::default();
            self.expr(&arm.then, locals, &mut steps);
            steps.finish()
        });
        let values = values.collect();
        let arms = self.arms(&comp.arms, locals);
        steps.add(Instruction::Comp(Box::new(CompCode { components, align, arms, values, ty })));
    }

    /// The selectors of arms.
    pub(super) fn arms<T>(&self, arms: &[Arm<T>], locals: &Locals) -> ArmsCode {
        let indices = arms.iter().filter_map(|arm| match &arm.selector {
            Selector::Index(index) => Some(index),
            Selector::Word(_) | Selector::When(_) => None,
        });
        let indices = self.code(indices, locals);
        let conditions = arms.iter().map(|arm| match &arm.selector {
            Selector::When(condition) => {
                let mut steps = Steps::default();
                self.expr(condition, locals, &mut steps);
                Some(steps.finish())
            }
            Selector::Word(_) | Selector::Index(_) => None,
        });
        let table = arms.iter().map(|arm| {
            let select = match &arm.selector {
                Selector::Word(word) => dispatch::rt_word(word).map_or(Select::When, Select::Word),
                Selector::Index(_) => Select::Index(0.0),
                Selector::When(_) => Select::When,
            };
            rt::Arm { select, mode: mode(arm.mode), text: Text::from(arm.text.as_str()) }
        });
        ArmsCode::new(table.collect(), indices, conditions.collect())
    }
}

/// The components and their alignment, which are words.
pub(super) fn components(args: &[Arg]) -> Option<(rt::Components, rt::Align)> {
    let word = |number: usize| match args.get(number) {
        Some(Arg::Word(word)) => Some(*word),
        _ => None,
    };
    Some((dispatch::rt_components(word(0)?)?, dispatch::rt_align(word(1)?)?))
}

/// The name by which a Rust function is registered: its path without spaces.
pub(super) fn spelling(path: &str) -> String {
    path.chars().filter(|character| !character.is_whitespace()).collect()
}

pub(super) fn number_operator(operator: Binary) -> NumberOperator {
    match operator {
        Binary::Add => NumberOperator::Add,
        Binary::Sub => NumberOperator::Sub,
        Binary::Mul => NumberOperator::Mul,
        Binary::Div => NumberOperator::Div,
        Binary::Rem => NumberOperator::Rem,
        Binary::Eq => NumberOperator::Eq,
        Binary::Ne => NumberOperator::Ne,
        Binary::Lt => NumberOperator::Lt,
        Binary::Le => NumberOperator::Le,
        Binary::Gt => NumberOperator::Gt,
        Binary::Ge => NumberOperator::Ge,
        Binary::And => NumberOperator::And,
        Binary::Or => NumberOperator::Or,
    }
}
