//! Calls of the runtime's operations and functions. The calls themselves are generated from the tables of the language: a row
//! without a function does not compile.

mod functions;
mod get;
mod operations;
mod set;
mod words;

use std::fmt;

use cga_lang::ir::{Arg, Expr, ExprKind, Prefix, Type, Value};
use cga_lang::ops::{Function, Operation, ShapeAttr};
use cga_runtime::rt::{Arm, Bases, Cx, Env, Flow, Item, Length, Shape, ShapeRef, Size};
use cga_runtime::rt_eval::Candidate;
use cga_runtime::shape::scope::Scope;

use crate::call::Call;
use crate::current::Current;
use crate::stack::{SharedStack, Stack};

pub(crate) use operations::{arms, each, operands, says, sections, slim};
pub(crate) use words::{rt_adjust, rt_align, rt_axis, rt_components, rt_texture_space, rt_uv_axis, rt_word};

/// A condition on components, by arm.
pub(crate) type When<'w> = dyn FnMut(&mut Env, u32, &mut Candidate<'_>) -> bool + 'w;

/// The successor of a part, by arm or slot.
pub(crate) type Visit<'v> = dyn FnMut(&mut Cx<'_, Call>, u32, &ShapeRef<'_>) -> Flow + 'v;

/// The successor of a part.
pub(crate) type VisitEach<'v> = dyn FnMut(&mut Cx<'_, Call>, &ShapeRef<'_>) -> Flow + 'v;

/// The depth of a section.
pub(crate) type Depth<'d> = dyn FnMut(&mut Env, u32, &mut Shape) -> f64 + 'd;

/// Types of calls, with a function that gives closures their types.
macro_rules! calls {
    ($($(#[$doc:meta])* $name:ident { $($bound:tt)* })*) => {$(
        $(#[$doc])*
        pub(crate) struct $name(pub(crate) Box<dyn $($bound)* + Send + Sync>);

        impl $name {
            pub(crate) fn new(call: impl $($bound)* + Send + Sync + 'static) -> Self {
                $name(Box::new(call))
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(stringify!($name))
            }
        }
    )*};
}

calls! {
    /// A function: it takes its arguments from the stack and leaves its value there. An operation that reads the shape alone leaves
    /// nothing.
    FunctionCall { Fn(&mut Stack, &mut Env, &mut Current<'_, '_>) }
    /// An operation that changes a whole shape. The scope is the one at the start of the rule, bracket or part.
    Change { Fn(&mut Stack, &mut Env, &mut Shape, &Scope) }
    /// An operation that changes a slim shape.
    SlimCall {
        for<'s, 'b> Fn(
            &mut Stack,
            &mut Env,
            &'s ShapeRef<'b>,
            &'b Bases,
            &'s mut Option<ShapeRef<'b>>,
        ) -> &'s ShapeRef<'b>
    }
    /// An operation with arms.
    ArmsCall {
        Fn(SharedStack<'_>, &mut Cx<'_, Call>, &ShapeRef<'_>, u32, &[Arm], &mut When<'_>, &mut Visit<'_>) -> Flow
    }
    /// An operation with sections.
    SectionsCall {
        Fn(
            SharedStack<'_>,
            &mut Cx<'_, Call>,
            &ShapeRef<'_>,
            u32,
            (&[Item], &mut [Size]),
            &[Arm],
            &mut Depth<'_>,
            &mut Visit<'_>,
        ) -> Flow
    }
    /// An operation with the same successor for each part.
    EachCall { Fn(SharedStack<'_>, &mut Cx<'_, Call>, &ShapeRef<'_>, u32, &mut VisitEach<'_>) -> Flow }
    /// An operation with operands.
    OperandsCall { Fn(&mut Stack, &mut Env, &mut Shape, Vec<Vec<Shape>>) }
}

/// The parts of arguments that are known when rules are loaded.
trait Known {
    /// The word of an argument.
    fn word(&self, number: usize) -> Option<&str>;

    /// The kind of length of an argument.
    fn length(&self, _number: usize) -> LengthKind {
        LengthKind::Absolute
    }

    /// The kind of size of an argument.
    fn size(&self, _number: usize) -> SizeKind {
        SizeKind(Prefix::Absolute)
    }

    /// The type of an argument.
    fn ty(&self, number: usize) -> Option<Type>;
}

impl Known for [Arg] {
    fn word(&self, number: usize) -> Option<&str> {
        match self.get(number)? {
            Arg::Word(word) => Some(word),
            Arg::Value(_) | Arg::Length(_) => None,
        }
    }

    fn length(&self, number: usize) -> LengthKind {
        match self.get(number) {
            Some(Arg::Length(size)) if size.prefix == Prefix::Relative => LengthKind::Relative,
            _ => LengthKind::Absolute,
        }
    }

    fn size(&self, number: usize) -> SizeKind {
        match self.get(number) {
            Some(Arg::Length(size)) => SizeKind(size.prefix),
            _ => SizeKind(Prefix::Absolute),
        }
    }

    fn ty(&self, number: usize) -> Option<Type> {
        match self.get(number)? {
            Arg::Value(value) => Some(value.ty),
            Arg::Length(size) => Some(size.value.ty),
            Arg::Word(_) => None,
        }
    }
}

impl Known for [Expr] {
    fn word(&self, number: usize) -> Option<&str> {
        match &self.get(number)?.kind {
            ExprKind::Value(Value::Text(word)) => Some(word),
            _ => None,
        }
    }

    fn ty(&self, number: usize) -> Option<Type> {
        Some(self.get(number)?.ty)
    }
}

/// The kind of a length.
#[derive(Clone, Copy, Debug)]
enum LengthKind {
    Absolute,
    Relative,
}

impl LengthKind {
    fn of(self, value: f64) -> Length {
        match self {
            LengthKind::Absolute => Length::Absolute(value),
            LengthKind::Relative => Length::Relative(value),
        }
    }
}

/// The kind of a size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SizeKind(pub(crate) Prefix);

impl SizeKind {
    pub(crate) fn of(self, value: f64) -> Size {
        match self.0 {
            Prefix::Absolute => Size::absolute(value),
            Prefix::Relative => Size::relative(value),
            Prefix::Floating => Size::floating(value),
        }
    }
}

/// The call of a function.
pub(crate) fn function(row: &Function, args: &[Expr]) -> Option<FunctionCall> {
    functions::call(&row.key(), args)
}

/// The read of an attribute of shapes.
pub(crate) fn read(row: &ShapeAttr) -> Option<FunctionCall> {
    get::material::call(row.name).or_else(|| get::shape::call(row.name))
}

/// The change of an attribute of shapes.
pub(crate) fn set(row: &ShapeAttr) -> Option<Change> {
    row.set?;
    set::call(row.name)
}

/// The change of a whole shape by an operation.
pub(crate) fn change(row: &Operation, args: &[Arg]) -> Option<Change> {
    let key = row.key();
    operations::whole::call(&key, args).or_else(|| operations::made::call(&key, args))
}
