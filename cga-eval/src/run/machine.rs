//! Evaluates the code of expressions.

use std::cell::RefCell;

use cga_lang::ir::Type;
use cga_runtime::rt::{self, Array, Env, File, Files, ShapeRef, Text, Value, func, host};
use cga_runtime::rt_eval::Candidate;

use super::values::Values;
use crate::code::{Code, CompCode, HostCall, Instruction, NumberOperator};
use crate::current::{Current, view, whole};
use crate::object::{Object, is_number};
use crate::stack::{Frame, Stack};

/// A function that returns to the code that called it.
#[derive(Clone, Copy, Debug)]
struct Return {
    /// The function that called; `None` for the code at the beginning.
    caller: Option<u32>,
    next: usize,
    frame: Frame,
    callee: u32,
}

impl Values {
    /// Evaluates code on a slim shape, for a rule with that frame. The values are left on the stack.
    pub(crate) fn eval(&self, env: &mut Env, shape: &ShapeRef<'_>, code: &Code, frame: Frame) {
        let stack = &mut *self.stack.borrow_mut();
        match &*code.steps {
            [] => {}
            [Instruction::Number(number)] => stack.push_float(*number),
            _ if code.is_whole => self.eval_whole(stack, env, shape, code, frame),
            _ => self.run(stack, env, &mut Current::Slim(shape), code, frame),
        }
    }

    #[cold]
    #[inline(never)]
    fn eval_whole(&self, stack: &mut Stack, env: &mut Env, shape: &ShapeRef<'_>, code: &Code, frame: Frame) {
        let mut whole = env.whole(shape);
        self.run(stack, env, &mut Current::Whole(&mut whole), code, frame);
        shape.drawn(&whole);
    }

    /// Evaluates a number on a slim shape.
    pub(crate) fn number(&self, env: &mut Env, shape: &ShapeRef<'_>, code: &Code, frame: Frame) -> f64 {
        if let [Instruction::Number(number)] = &*code.steps {
            return *number;
        }
        self.eval(env, shape, code, frame);
        self.stack.borrow_mut().float()
    }

    /// Evaluates code. The values are left on the stack.
    pub(crate) fn run(
        &self,
        stack: &mut Stack,
        env: &mut Env,
        current: &mut Current<'_, '_>,
        entry: &Code,
        mut frame: Frame,
    ) {
        let functions = &self.program.functions;
        let mut returns: Vec<Return> = Vec::new();
        let (mut caller, mut code, mut next) = (None, &*entry.steps, 0);
        loop {
            let Some(instruction) = code.get(next) else {
                let Some(back) = returns.pop() else { return };
                let callee = &functions[back.callee as usize];
                if let Some(bytes) = callee.request {
                    env.called(bytes);
                }
                leave(stack, callee.ty, frame);
                (caller, next, frame) = (back.caller, back.next, back.frame);
                code = match caller {
                    None => &entry.steps,
                    Some(function) => &functions[function as usize].code.steps,
                };
                continue;
            };
            next += 1;
            match instruction {
                Instruction::Number(number) => stack.push_float(*number),
                Instruction::LocalNumber(at) => {
                    let number = stack.numbers.get(frame.numbers + *at as usize).copied();
                    stack.push_float(number.unwrap_or_default());
                }
                Instruction::RunNumber(slot) => stack.push_float(self.numbers[*slot as usize]),
                Instruction::Numbers(operator) => {
                    let b = stack.float();
                    if let Some(a) = stack.numbers.last_mut() {
                        *a = numbers(*operator, *a, b);
                    }
                }
                // Texts and arrays may be large. After the end of the run values do not matter; missing ones count as 0 or empty.
                Instruction::Function(call) => {
                    if env.may_read(stack.objects.last().map_or(0, Object::size)) {
                        (call.0)(stack, env, current);
                    }
                }
                Instruction::Jump(to) => next = *to as usize,
                Instruction::JumpUnless(to) => {
                    if !stack.bool() {
                        next = *to as usize;
                    }
                }
                Instruction::Call(number, sites) => {
                    let callee = &functions[*number as usize];
                    let args = Frame {
                        numbers: stack.numbers.len().saturating_sub(callee.args.0),
                        objects: stack.objects.len().saturating_sub(callee.args.1),
                        site: sites.at(frame.site),
                    };
                    if let Some(bytes) = callee.request
                        && !env.call(bytes)
                    {
                        stack.truncate(args);
                        stack.push_nothing(callee.ty);
                        continue;
                    }
                    returns.push(Return { caller, next, frame, callee: *number });
                    (caller, code, next, frame) = (Some(*number), &callee.code.steps, 0, args);
                }
                other => self.rare(other, stack, env, current, frame),
            }
        }
    }

    /// The instructions that call nothing of the rules, or that few rules have.
    #[inline(never)]
    fn rare(
        &self,
        instruction: &Instruction,
        stack: &mut Stack,
        env: &mut Env,
        current: &mut Current<'_, '_>,
        frame: Frame,
    ) {
        match instruction {
            Instruction::Object(object) => stack.objects.push(object.clone()),
            Instruction::LocalObject(at) => {
                let object = stack.objects.get(frame.objects + *at as usize).cloned();
                stack.objects.push(object.unwrap_or_else(|| Object::empty(Type::Text)));
            }
            Instruction::RunObject(slot) => stack.objects.push(self.objects[*slot as usize].clone()),
            Instruction::Global(global) => self.global(stack, env, current, *global as usize),
            Instruction::Neg => {
                let value = -stack.float();
                stack.push_float(value);
            }
            Instruction::Not => {
                let value = !stack.bool();
                stack.push_bool(value);
            }
            Instruction::Texts(operator) => {
                let (b, a) = (stack.text(), stack.text());
                stack.push_bool(env.may_read(a.len().min(b.len())) && texts(*operator, &a, &b));
            }
            Instruction::Concat => {
                let (b, a) = (stack.text(), stack.text());
                let joined = func::concat(env, a, b);
                stack.push_text(joined);
            }
            Instruction::Host(call) => host_call(call, stack, env),
            Instruction::Chance { percent, before } => {
                let taken = view!(env, current, |shape| rt::branch(shape, *percent, *before));
                stack.push_bool(taken);
            }
            Instruction::Word(word) => {
                let selects = match current {
                    Current::Candidate(candidate) => candidate.is(*word),
                    Current::Slim(_) | Current::Whole(_) => false,
                };
                stack.push_bool(selects);
            }
            Instruction::Style(styles) => stack.push_bool(styles.contains(&self.style)),
            Instruction::Site(sites) => stack.push_bool(sites.contains(&frame.site)),
            Instruction::File(folder) => {
                let name = stack.text();
                stack.objects.push(Object::File(Box::new(File::new(name, folder.clone()))));
            }
            Instruction::Files(folder) => {
                let names = stack.texts();
                stack.objects.push(Object::Files(Box::new(Files::new(names, folder.clone()))));
            }
            Instruction::Image => {
                let file = stack.file();
                stack.push_text(rt::image(env, file));
            }
            Instruction::Comp(comp) => self.comp(comp, stack, env, current, frame),
            // `run` has the others.
            _ => {}
        }
    }

    /// The values of components.
    #[inline(never)]
    fn comp(&self, comp: &CompCode, stack: &mut Stack, env: &mut Env, current: &mut Current<'_, '_>, frame: Frame) {
        self.run(stack, env, current, &comp.arms.indices, frame);
        match comp.ty {
            Type::Bools => {
                let values = self.values(comp, stack, env, current, frame, |stack| stack.bool());
                stack.push_bools(values);
            }
            Type::Texts => {
                let values = self.values(comp, stack, env, current, frame, |stack| stack.text());
                stack.push_texts(values);
            }
            _ => {
                let values = self.values(comp, stack, env, current, frame, |stack| stack.float());
                stack.push_floats(values);
            }
        }
    }

    fn values<T: cga_runtime::value::array::Element>(
        &self,
        comp: &CompCode,
        stack: &mut Stack,
        env: &mut Env,
        current: &mut Current<'_, '_>,
        frame: Frame,
        pop: impl Fn(&mut Stack) -> T,
    ) -> Array<T> {
        let arms = comp.arms.table(stack);
        // Conditions and values are evaluated one after the other.
        let stack = RefCell::new(stack);
        let when = |env: &mut Env, arm: u32, candidate: &mut Candidate<'_>| {
            let Some(Some(condition)) = comp.arms.conditions.get(arm as usize) else { return false };
            let stack = &mut **stack.borrow_mut();
            self.run(stack, env, &mut Current::Candidate(candidate), condition, frame);
            stack.bool()
        };
        let value = |env: &mut Env, arm: u32, part: &mut rt::Shape| {
            let Some(value) = comp.values.get(arm as usize) else { return T::default() };
            let stack = &mut **stack.borrow_mut();
            self.run(stack, env, &mut Current::Whole(part), value, frame);
            pop(stack)
        };
        whole!(env, current, |shape| rt::comp_values(env, shape, comp.components, comp.align, &arms, when, value))
    }

    /// Tests the condition of an arm.
    pub(crate) fn condition(
        &self,
        env: &mut Env,
        candidate: &mut Candidate<'_>,
        conditions: &[Option<Code>],
        arm: u32,
        frame: Frame,
    ) -> bool {
        let Some(Some(condition)) = conditions.get(arm as usize) else { return false };
        let stack = &mut *self.stack.borrow_mut();
        self.run(stack, env, &mut Current::Candidate(candidate), condition, frame);
        stack.bool()
    }
}

/// Leaves a function: its value takes the place of its arguments.
fn leave(stack: &mut Stack, ty: Type, frame: Frame) {
    if is_number(ty) {
        let value = stack.float();
        stack.truncate(frame);
        stack.push_float(value);
    } else {
        let value = stack.objects.pop();
        stack.truncate(frame);
        stack.objects.extend(value);
    }
}

/// An operator on numbers or truth values. NaN is less than anything; see `func::compare`.
#[inline]
fn numbers(operator: NumberOperator, a: f64, b: f64) -> f64 {
    let truth = |value: bool| f64::from(u8::from(value));
    match operator {
        NumberOperator::Add => a + b,
        NumberOperator::Sub => a - b,
        NumberOperator::Mul => a * b,
        NumberOperator::Div => a / b,
        NumberOperator::Rem => a % b,
        NumberOperator::Lt => truth(!matches!(a.partial_cmp(&b), Some(o) if o.is_ge())),
        NumberOperator::Le => truth(!matches!(a.partial_cmp(&b), Some(o) if o.is_gt())),
        NumberOperator::Gt => truth(a > b),
        NumberOperator::Ge => truth(a >= b),
        NumberOperator::Eq => truth(a == b),
        NumberOperator::Ne => truth(a != b),
        NumberOperator::And => truth((a != 0.0) & (b != 0.0)),
        NumberOperator::Or => truth((a != 0.0) | (b != 0.0)),
    }
}

/// An operator on texts.
fn texts(operator: NumberOperator, a: &Text, b: &Text) -> bool {
    match operator {
        NumberOperator::Eq => a == b,
        NumberOperator::Ne => a != b,
        NumberOperator::Lt => a < b,
        NumberOperator::Le => a <= b,
        NumberOperator::Gt => a > b,
        NumberOperator::Ge => a >= b,
        _ => false,
    }
}

/// Calls a function of the host program.
fn host_call(call: &HostCall, stack: &mut Stack, env: &mut Env) {
    let mut args: Vec<Value> = call.args.iter().rev().map(|ty| stack.value(*ty)).collect();
    args.reverse();
    let value = host::of_type(env, &call.name, (call.function)(&args), &crate::object::nothing(call.ty));
    if !call.is_value {
        host::count(env, &value);
    }
    stack.push_value(value);
}
