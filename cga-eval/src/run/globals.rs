//! Attributes and constants: computed when a run begins, read by expressions, and computed again by renewals of imports.

use cga_lang::ir::Type;
use cga_runtime::rt::{self, Env, Evaluated, Lazy, Origin, Shape, Value, get, set};

use super::values::{LazyValue, Values};
use crate::current::{Current, view};
use crate::object::{Object, nothing};
use crate::program::{GlobalCode, Slot};
use crate::stack::{Frame, Stack};

impl Values {
    /// Computes the attributes and constants of the style.
    pub(crate) fn compute(&mut self, env: &mut Env, initial: &Shape) {
        let program = self.program.clone();
        if 0 < program.slots.lazy {
            self.origin = Origin::initial(initial);
        }
        for init in &program.init {
            let global = &program.globals[init.global];
            let (Slot::Lazy(slot), Some(field)) = (global.slot, global.field) else { continue };
            self.lazy[slot as usize] = match &self.fields[field] {
                Some(value) => Lazy::known(LazyValue(Some(value.clone()))),
                None => Lazy::default(),
            };
        }
        let style = self.style;
        for init in program.init.iter().filter(|init| init.is_in(style)) {
            let global = &program.globals[init.global];
            let (Slot::Number(_) | Slot::Object(_)) = global.slot else {
                let stack = &mut Stack::default();
                self.lazy_value(stack, env, init.global);
                continue;
            };
            let given = global.field.and_then(|field| self.fields[field].clone());
            let value = match (given, &global.known) {
                (Some(given), _) => given,
                (None, Some(known)) => known.clone(),
                (None, None) => self.evaluated(env, &mut rt::global(initial, global.stream), global),
            };
            self.store(global.slot, value);
        }
    }

    fn store(&mut self, slot: Slot, value: Value) {
        match (slot, value) {
            (Slot::Number(slot), Value::Float(number)) => self.numbers[slot as usize] = number,
            (Slot::Number(slot), Value::Bool(truth)) => self.numbers[slot as usize] = f64::from(u8::from(truth)),
            (Slot::Object(slot), value) => {
                let mut stack = Stack::default();
                stack.push_value(value);
                if let Some(object) = stack.objects.pop() {
                    self.objects[slot as usize] = object;
                }
            }
            _ => {}
        }
    }

    /// The value of an attribute or constant on a shape.
    fn evaluated(&self, env: &mut Env, shape: &mut Shape, global: &GlobalCode) -> Value {
        let stack = &mut *self.stack.borrow_mut();
        let frame = stack.frame(0);
        self.run(stack, env, &mut Current::Whole(shape), &global.value, frame);
        let value = stack.value(global.ty);
        stack.truncate(frame);
        value
    }

    /// Adds the value of an attribute or constant that shapes may hold, or that is computed on its first read.
    #[inline(never)]
    pub(crate) fn global(&self, stack: &mut Stack, env: &mut Env, current: &mut Current<'_, '_>, number: usize) {
        let global = &self.program.globals[number];
        let held = match global.slot {
            Slot::Number(slot) if global.ty == Type::Bool => Value::Bool(self.numbers[slot as usize] != 0.0),
            Slot::Number(slot) => Value::Float(self.numbers[slot as usize]),
            Slot::Object(slot) => {
                self.objects[slot as usize].clone().into_value().unwrap_or_else(|| nothing(global.ty))
            }
            Slot::Lazy(_) => self.lazy_value(stack, env, number),
        };
        let value = if global.is_set { of_shape(env, current, number as u32, held) } else { held };
        stack.push_value(value);
    }

    /// The value of a lazy attribute or constant. The first read computes it.
    fn lazy_value(&self, stack: &mut Stack, env: &mut Env, number: usize) -> Value {
        let global = &self.program.globals[number];
        let Slot::Lazy(slot) = global.slot else { return nothing(global.ty) };
        let found = self.lazy[slot as usize].get(env, global.name.clone(), global.stack, |env| {
            let shape = &mut self.origin.global(global.stream);
            let frame = stack.frame(0);
            self.run(stack, env, &mut Current::Whole(shape), &global.value, frame);
            let value = stack.value(global.ty);
            stack.truncate(frame);
            LazyValue(Some(value))
        });
        found.0.unwrap_or_else(|| nothing(global.ty))
    }

    /// The value of an attribute or constant in the run, if it is known.
    pub(crate) fn found(&self, number: usize) -> Option<Value> {
        let global = &self.program.globals[number];
        match global.slot {
            Slot::Number(slot) if global.ty == Type::Bool => Some(Value::Bool(self.numbers[slot as usize] != 0.0)),
            Slot::Number(slot) => Some(Value::Float(self.numbers[slot as usize])),
            Slot::Object(slot) => Object::into_value(self.objects[slot as usize].clone()),
            Slot::Lazy(slot) => self.lazy[slot as usize].value(),
        }
    }

    /// Hands out the values of the fields, in their order; `None` for attributes that the style does not have.
    pub(crate) fn used(&self, style: u32, each: &mut dyn FnMut(Option<Value>)) {
        for field in &self.program.fields {
            // The last one that the style has counts.
            let own = field.inits.iter().rev().map(|init| &self.program.init[*init]);
            let own = own.into_iter().find(|init| init.is_in(style));
            each(own.and_then(|init| self.found(init.global)));
        }
    }

    /// Computes the values of an import again, except the given ones, on a copy of the current shape. The numbers in `given` are
    /// sorted.
    pub(crate) fn renew(&self, env: &mut Env, shape: &mut Shape, renewal: usize, given: &[u32]) {
        for group in &self.program.renewals[renewal].groups {
            match group[..] {
                [number] if !matches!(self.program.globals[number].slot, Slot::Lazy(_)) => {
                    self.renew_one(env, shape, number, given);
                }
                _ => self.renew_lazy(env, shape, group, given),
            }
        }
    }

    fn renew_one(&self, env: &mut Env, shape: &mut Shape, number: usize, given: &[u32]) {
        let global = &self.program.globals[number];
        if global.is_attribute && given.binary_search(&(number as u32)).is_ok() {
            return;
        }
        let held = global.renewed_field.and_then(|field| self.fields[field].clone());
        let value = match held {
            Some(value) => value,
            None if global.is_literal => self.evaluated(env, shape, global),
            None => rt::renew(shape, global.stream, |shape| self.evaluated(env, shape, global)),
        };
        set::attribute(shape, number as u32, value);
    }

    fn renew_lazy(&self, env: &mut Env, shape: &mut Shape, group: &[usize], given: &[u32]) {
        let mut numbers: Vec<u32> = group.iter().map(|number| *number as u32).collect();
        numbers.sort_unstable();
        let mut own = self.reopened();
        own.origin = Origin::renewed(shape, &numbers);
        for &number in group {
            let global = &self.program.globals[number];
            let Slot::Lazy(slot) = global.slot else { continue };
            let is_given = global.is_attribute && given.binary_search(&(number as u32)).is_ok();
            let value = match is_given {
                true => Some(of_shape(env, &mut Current::Whole(shape), number as u32, nothing(global.ty))),
                false => global.renewed_field.and_then(|field| self.fields[field].clone()),
            };
            own.lazy[slot as usize] = value.map_or_else(Lazy::default, |value| Lazy::known(LazyValue(Some(value))));
        }
        for &number in group {
            let stack = &mut Stack::default();
            let value = own.lazy_value(stack, env, number);
            set::attribute(shape, number as u32, value);
        }
    }

    /// A frame without parameters.
    pub(crate) fn empty_frame(&self, site: u32) -> Frame {
        self.stack.borrow().frame(site)
    }
}

/// The value that a shape has of its own, else the one given.
fn of_shape(env: &mut Env, current: &mut Current<'_, '_>, number: u32, held: Value) -> Value {
    view!(env, current, |shape| match &held {
        Value::Float(held) => Value::Float(get::float_attribute(shape, number, *held)),
        Value::Bool(held) => Value::Bool(get::bool_attribute(shape, number, *held)),
        Value::Text(held) => Value::Text(get::text_attribute(shape, number, held)),
        Value::Floats(held) => Value::Floats(get::floats_attribute(shape, number, held)),
        Value::Bools(held) => Value::Bools(get::bools_attribute(shape, number, held)),
        Value::Texts(held) => Value::Texts(get::texts_attribute(shape, number, held)),
        _ => held.clone(),
    })
}
