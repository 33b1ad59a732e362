//! Calls of `setElems` on arrays of texts.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::FunctionCall;
use cga_lang::ir::Expr;
use cga_runtime::rt::func;

/// The call of a function of this group, by the key of its row.
pub(super) fn call(key: &str, _: &[Expr]) -> Option<FunctionCall> {
    Some(match key {
        "set_elements(texts, bools, text)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.text();
            let a1 = stack.bools();
            let a0 = stack.texts();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_texts(value);
        }),
        "set_elements(texts, bools, texts)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.texts();
            let a1 = stack.bools();
            let a0 = stack.texts();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_texts(value);
        }),
        "set_elements(texts, float, text)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.text();
            let a1 = stack.float();
            let a0 = stack.texts();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_texts(value);
        }),
        "set_elements(texts, float, texts)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.texts();
            let a1 = stack.float();
            let a0 = stack.texts();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_texts(value);
        }),
        "set_elements(texts, floats, text)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.text();
            let a1 = stack.floats();
            let a0 = stack.texts();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_texts(value);
        }),
        "set_elements(texts, floats, texts)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.texts();
            let a1 = stack.floats();
            let a0 = stack.texts();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, bools, bools, text)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.text();
            let a2 = stack.bools();
            let a1 = stack.bools();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, bools, bools, texts)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.texts();
            let a2 = stack.bools();
            let a1 = stack.bools();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, bools, float, text)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.text();
            let a2 = stack.float();
            let a1 = stack.bools();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, bools, float, texts)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.texts();
            let a2 = stack.float();
            let a1 = stack.bools();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, bools, floats, text)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.text();
            let a2 = stack.floats();
            let a1 = stack.bools();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, bools, floats, texts)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.texts();
            let a2 = stack.floats();
            let a1 = stack.bools();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, float, bools, text)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.text();
            let a2 = stack.bools();
            let a1 = stack.float();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, float, bools, texts)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.texts();
            let a2 = stack.bools();
            let a1 = stack.float();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, float, float, text)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.text();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, float, float, texts)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.texts();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, float, floats, text)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.text();
            let a2 = stack.floats();
            let a1 = stack.float();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, float, floats, texts)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.texts();
            let a2 = stack.floats();
            let a1 = stack.float();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, floats, bools, text)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.text();
            let a2 = stack.bools();
            let a1 = stack.floats();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, floats, bools, texts)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.texts();
            let a2 = stack.bools();
            let a1 = stack.floats();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, floats, float, text)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.text();
            let a2 = stack.float();
            let a1 = stack.floats();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, floats, float, texts)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.texts();
            let a2 = stack.float();
            let a1 = stack.floats();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, floats, floats, text)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.text();
            let a2 = stack.floats();
            let a1 = stack.floats();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        "set_elements_at(texts, floats, floats, texts)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.texts();
            let a2 = stack.floats();
            let a1 = stack.floats();
            let a0 = stack.texts();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_texts(value);
        }),
        _ => return None,
    })
}
