//! Calls of functions of their arguments alone.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::FunctionCall;
use cga_lang::ir::Expr;
use cga_runtime::rt::func;

/// The call of a function of this group, by the key of its row.
pub(super) fn call(key: &str, _: &[Expr]) -> Option<FunctionCall> {
    Some(match key {
        "bool_to_float(bool)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.bool();
            let value = func::bool_to_float(a0);
            stack.push_float(value);
        }),
        "clamp(float, float, float)" => FunctionCall::new(move |stack, _, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            let value = func::clamp(a0, a1, a2);
            stack.push_float(value);
        }),
        "clamp(text, text, text)" => FunctionCall::new(move |stack, _, _| {
            let a2 = stack.text();
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::clamp(a0, a1, a2);
            stack.push_text(value);
        }),
        "count(text, text)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::count(a0, a1);
            stack.push_float(value);
        }),
        "count_true(bools)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.bools();
            let value = func::count_true(a0);
            stack.push_float(value);
        }),
        "find_element(bools, bool)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.bool();
            let a0 = stack.bools();
            let value = func::find_element(a0, a1);
            stack.push_float(value);
        }),
        "find_element(texts, text)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.text();
            let a0 = stack.texts();
            let value = func::find_element(a0, a1);
            stack.push_float(value);
        }),
        "find_first(text, text)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::find_first(a0, a1);
            stack.push_float(value);
        }),
        "find_last(text, text)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::find_last(a0, a1);
            stack.push_float(value);
        }),
        "float_to_bool(float)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.float();
            let value = func::float_to_bool(a0);
            stack.push_bool(value);
        }),
        "isinf(float)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.float();
            let value = func::isinf(a0);
            stack.push_bool(value);
        }),
        "isnan(float)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.float();
            let value = func::isnan(a0);
            stack.push_bool(value);
        }),
        "isnull_float(float)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.float();
            let value = func::isnull_float(a0);
            stack.push_bool(value);
        }),
        "isnull_text(text)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.text();
            let value = func::isnull_text(a0);
            stack.push_bool(value);
        }),
        "len(text)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.text();
            let value = func::len(a0);
            stack.push_float(value);
        }),
        "list_count(text, text)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::list_count(a0, a1);
            stack.push_float(value);
        }),
        "list_index(text, text)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::list_index(a0, a1);
            stack.push_float(value);
        }),
        "list_size(text)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.text();
            let value = func::list_size(a0);
            stack.push_float(value);
        }),
        "max(float, float)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.float();
            let a0 = stack.float();
            let value = func::max(a0, a1);
            stack.push_float(value);
        }),
        "max(text, text)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::max(a0, a1);
            stack.push_text(value);
        }),
        "min(float, float)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.float();
            let a0 = stack.float();
            let value = func::min(a0, a1);
            stack.push_float(value);
        }),
        "min(text, text)" => FunctionCall::new(move |stack, _, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::min(a0, a1);
            stack.push_text(value);
        }),
        "n_columns(bools)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.bools();
            let value = func::n_columns(a0);
            stack.push_float(value);
        }),
        "n_columns(floats)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.floats();
            let value = func::n_columns(a0);
            stack.push_float(value);
        }),
        "n_columns(texts)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.texts();
            let value = func::n_columns(a0);
            stack.push_float(value);
        }),
        "n_rows(bools)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.bools();
            let value = func::n_rows(a0);
            stack.push_float(value);
        }),
        "n_rows(floats)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.floats();
            let value = func::n_rows(a0);
            stack.push_float(value);
        }),
        "n_rows(texts)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.texts();
            let value = func::n_rows(a0);
            stack.push_float(value);
        }),
        "no_bools()" => FunctionCall::new(move |stack, _, _| {
            let value = func::no_bools();
            stack.push_bools(value);
        }),
        "no_floats()" => FunctionCall::new(move |stack, _, _| {
            let value = func::no_floats();
            stack.push_floats(value);
        }),
        "no_texts()" => FunctionCall::new(move |stack, _, _| {
            let value = func::no_texts();
            stack.push_texts(value);
        }),
        "size(bools)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.bools();
            let value = func::size(a0);
            stack.push_float(value);
        }),
        "size(floats)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.floats();
            let value = func::size(a0);
            stack.push_float(value);
        }),
        "size(texts)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.texts();
            let value = func::size(a0);
            stack.push_float(value);
        }),
        "sum(floats)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.floats();
            let value = func::sum(a0);
            stack.push_float(value);
        }),
        "text_to_bool(text)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.text();
            let value = func::text_to_bool(a0);
            stack.push_bool(value);
        }),
        "text_to_float(text)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.text();
            let value = func::text_to_float(a0);
            stack.push_float(value);
        }),
        "text_to_text(text)" => FunctionCall::new(move |stack, _, _| {
            let a0 = stack.text();
            let value = func::text_to_text(a0);
            stack.push_text(value);
        }),
        _ => return None,
    })
}
