//! Calls of functions that have no rows: arrays, indices, operators on arrays, values as text.

use cga_lang::ir::{Binary, Type};
use cga_runtime::rt::func::{self, ArrayPart};
use cga_runtime::rt::{Array, Text};
use cga_runtime::value::array::Element;

use crate::dispatch::FunctionCall;
use crate::stack::Stack;

/// `[a, b; c, d]`, with the types of the entries by row.
pub(super) fn array(ty: Type, rows: Vec<Vec<Type>>) -> FunctionCall {
    match ty {
        Type::Bools => FunctionCall::new(move |stack, env, _| {
            let rows = taken(stack, &rows, |stack| stack.bool(), |stack| stack.bools());
            stack.push_bools(func::array(env, &slices(&rows)));
        }),
        Type::Texts => FunctionCall::new(move |stack, env, _| {
            let rows = taken(stack, &rows, |stack| stack.text(), |stack| stack.texts());
            stack.push_texts(func::array(env, &slices(&rows)));
        }),
        _ => FunctionCall::new(move |stack, env, _| {
            let rows = taken(stack, &rows, |stack| stack.float(), |stack| stack.floats());
            stack.push_floats(func::array(env, &slices(&rows)));
        }),
    }
}

/// Takes the entries of an array from the stack.
fn taken<T>(
    stack: &mut Stack,
    rows: &[Vec<Type>],
    one: impl Fn(&mut Stack) -> T,
    many: impl Fn(&mut Stack) -> Array<T>,
) -> Vec<Vec<ArrayPart<T>>> {
    let mut part = |ty: &Type| if ty.is_array() { ArrayPart::Many(many(stack)) } else { ArrayPart::One(one(stack)) };
    let mut taken: Vec<Vec<ArrayPart<T>>> = rows
        .iter()
        .rev()
        .map(|row| {
            let mut row: Vec<ArrayPart<T>> = row.iter().rev().map(&mut part).collect();
            row.reverse();
            row
        })
        .collect();
    taken.reverse();
    taken
}

fn slices<T>(rows: &[Vec<ArrayPart<T>>]) -> Vec<&[ArrayPart<T>]> {
    rows.iter().map(Vec::as_slice).collect()
}

/// A call with a function for each type of arrays.
macro_rules! by_type {
    ($ty:expr, |$stack:ident, $env:ident, $pop:ident, $push:ident| $run:expr) => {
        match $ty {
            Type::Bools | Type::Bool => by_type!(@call bools push_bools $stack $env $pop $push $run),
            Type::Texts | Type::Text => by_type!(@call texts push_texts $stack $env $pop $push $run),
            _ => by_type!(@call floats push_floats $stack $env $pop $push $run),
        }
    };
    (@call $take:ident $give:ident $stack:ident $env:ident $pop:ident $push:ident $run:expr) => {
        FunctionCall::new(move |$stack, $env, _| {
            #[allow(unused_variables)]
            let $pop = |stack: &mut Stack| stack.$take();
            #[allow(unused_variables)]
            let $push = |stack: &mut Stack, value| stack.$give(value);
            $run
        })
    };
}

/// `a[i]` or `a[row, column]`, with the types of the indices.
pub(super) fn index(array: Type, indices: &[Type]) -> FunctionCall {
    if indices.iter().all(|ty| !ty.is_array()) {
        return match (array, indices.len()) {
            (Type::Bools, 1) => FunctionCall::new(|stack, env, _| {
                let index = stack.float();
                let value = func::element(env, stack.bools(), index);
                stack.push_bool(value);
            }),
            (Type::Bools, _) => FunctionCall::new(|stack, env, _| {
                let (column, row) = (stack.float(), stack.float());
                let value = func::element_at(env, stack.bools(), row, column);
                stack.push_bool(value);
            }),
            (Type::Texts, 1) => FunctionCall::new(|stack, env, _| {
                let index = stack.float();
                let value = func::element(env, stack.texts(), index);
                stack.push_text(value);
            }),
            (Type::Texts, _) => FunctionCall::new(|stack, env, _| {
                let (column, row) = (stack.float(), stack.float());
                let value = func::element_at(env, stack.texts(), row, column);
                stack.push_text(value);
            }),
            (_, 1) => FunctionCall::new(|stack, env, _| {
                let index = stack.float();
                let value = func::element(env, stack.floats(), index);
                stack.push_float(value);
            }),
            _ => FunctionCall::new(|stack, env, _| {
                let (column, row) = (stack.float(), stack.float());
                let value = func::element_at(env, stack.floats(), row, column);
                stack.push_float(value);
            }),
        };
    }
    match *indices {
        [Type::Bools] => by_type!(array, |stack, env, pop, push| {
            let index = stack.bools();
            let value = func::elements(env, pop(stack), index);
            push(stack, value);
        }),
        [_] => by_type!(array, |stack, env, pop, push| {
            let index = stack.floats();
            let value = func::elements(env, pop(stack), index);
            push(stack, value);
        }),
        [rows, columns, ..] => block(array, rows, columns),
        [] => FunctionCall::new(|_, _, _| ()),
    }
}

/// `a[rows, columns]`, where at least one index is an array.
fn block(array: Type, rows: Type, columns: Type) -> FunctionCall {
    macro_rules! indices {
        ($rows:ident $columns:ident) => {
            by_type!(array, |stack, env, pop, push| {
                let columns = stack.$columns();
                let rows = stack.$rows();
                let value = func::elements_at(env, pop(stack), rows, columns);
                push(stack, value);
            })
        };
    }
    match (rows, columns) {
        (Type::Bools, Type::Bools) => indices!(bools bools),
        (Type::Bools, Type::Floats) => indices!(bools floats),
        (Type::Bools, _) => indices!(bools float),
        (Type::Floats, Type::Bools) => indices!(floats bools),
        (Type::Floats, Type::Floats) => indices!(floats floats),
        (Type::Floats, _) => indices!(floats float),
        (_, Type::Bools) => indices!(float bools),
        _ => indices!(float floats),
    }
}

/// Compares two arrays.
pub(super) fn compare(operator: Binary, ty: Type) -> FunctionCall {
    macro_rules! comparison {
        ($function:ident) => {
            by_type!(ty, |stack, _env, pop, _push| {
                let (b, a) = (pop(stack), pop(stack));
                stack.push_bool(func::$function(a, b));
            })
        };
    }
    match operator {
        Binary::Ne => comparison!(unequal),
        Binary::Lt => comparison!(less),
        Binary::Le => comparison!(less_equal),
        Binary::Gt => comparison!(greater),
        Binary::Ge => comparison!(greater_equal),
        _ => comparison!(equal),
    }
}

/// `a .+ b`: an operator on each pair of elements.
pub(super) fn each(operator: Binary, result: Type, left: Type, right: Type) -> FunctionCall {
    match operator {
        Binary::Add if result == Type::Texts => concat(left, right),
        Binary::Add | Binary::Sub | Binary::Mul | Binary::Div | Binary::Rem => arithmetic(operator, left, right),
        Binary::And | Binary::Or => logic(operator == Binary::And, left, right),
        _ => match left.element() {
            Type::Bool => compared(operator, left, right, |stack| stack.bool(), |stack| stack.bools()),
            Type::Text => compared(operator, left, right, |stack| stack.text(), |stack| stack.texts()),
            _ => compared(operator, left, right, |stack| stack.float(), |stack| stack.floats()),
        },
    }
}

/// A value or an array as the operand of an operator on elements.
enum Side<T> {
    One(T),
    Many(Array<T>),
}

impl<T> Side<T> {
    fn taken(
        stack: &mut Stack,
        ty: Type,
        one: impl Fn(&mut Stack) -> T,
        many: impl Fn(&mut Stack) -> Array<T>,
    ) -> Self {
        if ty.is_array() { Side::Many(many(stack)) } else { Side::One(one(stack)) }
    }
}

impl<T: Element> func::Operand for Side<T> {
    type Item = T;

    fn form(&self) -> Option<(usize, usize)> {
        match self {
            Side::One(_) => None,
            Side::Many(array) => array.form(),
        }
    }

    fn item(&self, number: usize) -> T {
        match self {
            Side::One(value) => value.clone(),
            Side::Many(array) => array.item(number),
        }
    }
}

fn arithmetic(operator: Binary, left: Type, right: Type) -> FunctionCall {
    FunctionCall::new(move |stack, env, _| {
        let mut side = |ty| Side::taken(stack, ty, |stack| stack.float(), |stack| stack.floats());
        let (b, a) = (side(right), side(left));
        stack.push_floats(match operator {
            Binary::Sub => func::each_subtract(env, a, b),
            Binary::Mul => func::each_multiply(env, a, b),
            Binary::Div => func::each_divide(env, a, b),
            Binary::Rem => func::each_remainder(env, a, b),
            _ => func::each_add(env, a, b),
        });
    })
}

fn logic(is_and: bool, left: Type, right: Type) -> FunctionCall {
    FunctionCall::new(move |stack, env, _| {
        let mut side = |ty| Side::taken(stack, ty, |stack| stack.bool(), |stack| stack.bools());
        let (b, a) = (side(right), side(left));
        stack.push_bools(if is_and { func::each_and(env, a, b) } else { func::each_or(env, a, b) });
    })
}

fn compared<T: Element>(
    operator: Binary,
    left: Type,
    right: Type,
    one: impl Fn(&mut Stack) -> T + Send + Sync + 'static,
    many: impl Fn(&mut Stack) -> Array<T> + Send + Sync + 'static,
) -> FunctionCall {
    FunctionCall::new(move |stack, env, _| {
        let mut side = |ty| Side::taken(stack, ty, &one, &many);
        let (b, a) = (side(right), side(left));
        stack.push_bools(match operator {
            Binary::Ne => func::each_unequal(env, a, b),
            Binary::Lt => func::each_less(env, a, b),
            Binary::Le => func::each_less_equal(env, a, b),
            Binary::Gt => func::each_greater(env, a, b),
            Binary::Ge => func::each_greater_equal(env, a, b),
            _ => func::each_equal(env, a, b),
        });
    })
}

/// Joins the elements as text. One side may have another type.
fn concat(left: Type, right: Type) -> FunctionCall {
    macro_rules! sides {
        ($one:ident $many:ident, $left_one:ident $left_many:ident) => {
            FunctionCall::new(move |stack, env, _| {
                let b = Side::taken(stack, right, |stack| stack.$one(), |stack| stack.$many());
                let a = Side::taken(stack, left, |stack| stack.$left_one(), |stack| stack.$left_many());
                stack.push_texts(func::each_concat(env, a, b));
            })
        };
    }
    match (left.element(), right.element()) {
        (Type::Text, Type::Text) => sides!(text texts, text texts),
        (Type::Text, Type::Bool) => sides!(bool bools, text texts),
        (Type::Text, _) => sides!(float floats, text texts),
        (Type::Bool, Type::Text) => sides!(text texts, bool bools),
        (Type::Bool, Type::Bool) => sides!(bool bools, bool bools),
        (Type::Bool, _) => sides!(float floats, bool bools),
        (_, Type::Text) => sides!(text texts, float floats),
        (_, Type::Bool) => sides!(bool bools, float floats),
        _ => sides!(float floats, float floats),
    }
}

/// A value as text; `None` if it is text.
pub(super) fn to_text(ty: Type) -> Option<FunctionCall> {
    Some(match ty {
        Type::Text => return None,
        Type::Float => FunctionCall::new(|stack, _, _| {
            let text: Text = func::float_to_text(stack.float());
            stack.push_text(text);
        }),
        Type::Bool => FunctionCall::new(|stack, _, _| {
            let text: Text = func::bool_to_text(stack.bool());
            stack.push_text(text);
        }),
        ty => by_type!(ty, |stack, env, pop, _push| {
            let text = func::array_to_text(env, pop(stack));
            stack.push_text(text);
        }),
    })
}
