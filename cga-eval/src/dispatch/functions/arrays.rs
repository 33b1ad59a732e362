//! Calls of functions that read the run and make an array.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::{FunctionCall, Known as _, words};
use cga_lang::ir::Expr;
use cga_runtime::rt::func;

/// The call of a function of this group, by the key of its row.
pub(super) fn call(key: &str, known: &[Expr]) -> Option<FunctionCall> {
    Some(match key {
        "abs_each(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::abs_each(env, a0);
            stack.push_floats(value);
        }),
        "asset_metadata_bools(file, text, bools)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.bools();
            let a1 = stack.text();
            let a0 = stack.file();
            let value = func::asset_metadata_bools(env, a0, a1, a2);
            stack.push_bools(value);
        }),
        "asset_metadata_floats(file, text, floats)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.floats();
            let a1 = stack.text();
            let a0 = stack.file();
            let value = func::asset_metadata_floats(env, a0, a1, a2);
            stack.push_floats(value);
        }),
        "asset_metadata_texts(file, text, texts)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.texts();
            let a1 = stack.text();
            let a0 = stack.file();
            let value = func::asset_metadata_texts(env, a0, a1, a2);
            stack.push_texts(value);
        }),
        "asset_naming_infos(file, AssetNaming)" => {
            let a1 = words::func_asset_naming(known.word(1)?)?;
            FunctionCall::new(move |stack, env, _| {
                let a0 = stack.file();
                let value = func::asset_naming_infos(env, a0, a1);
                stack.push_texts(value);
            })
        }
        "bools_from_floats(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::bools_from_floats(env, a0);
            stack.push_bools(value);
        }),
        "bools_from_texts(texts)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.texts();
            let value = func::bools_from_texts(env, a0);
            stack.push_bools(value);
        }),
        "ceil_each(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::ceil_each(env, a0);
            stack.push_floats(value);
        }),
        "clamp_each(floats, floats, floats)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.floats();
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::clamp_each(env, a0, a1, a2);
            stack.push_floats(value);
        }),
        "clamp_each(texts, texts, texts)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.texts();
            let a1 = stack.texts();
            let a0 = stack.texts();
            let value = func::clamp_each(env, a0, a1, a2);
            stack.push_texts(value);
        }),
        "files_search(file)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.file();
            let value = func::files_search(env, a0);
            stack.push_texts(value);
        }),
        "floats_from_bools(bools)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.bools();
            let value = func::floats_from_bools(env, a0);
            stack.push_floats(value);
        }),
        "floats_from_texts(texts)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.texts();
            let value = func::floats_from_texts(env, a0);
            stack.push_floats(value);
        }),
        "floor_each(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::floor_each(env, a0);
            stack.push_floats(value);
        }),
        "isinf_each(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::isinf_each(env, a0);
            stack.push_bools(value);
        }),
        "isnan_each(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::isnan_each(env, a0);
            stack.push_bools(value);
        }),
        "isnull_float_each(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::isnull_float_each(env, a0);
            stack.push_bools(value);
        }),
        "isnull_text_each(texts)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.texts();
            let value = func::isnull_text_each(env, a0);
            stack.push_bools(value);
        }),
        "list_to_array(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::list_to_array(env, a0);
            stack.push_texts(value);
        }),
        "max_each(floats, floats)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::max_each(env, a0, a1);
            stack.push_floats(value);
        }),
        "max_each(texts, texts)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.texts();
            let a0 = stack.texts();
            let value = func::max_each(env, a0, a1);
            stack.push_texts(value);
        }),
        "min_each(floats, floats)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::min_each(env, a0, a1);
            stack.push_floats(value);
        }),
        "min_each(texts, texts)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.texts();
            let a0 = stack.texts();
            let value = func::min_each(env, a0, a1);
            stack.push_texts(value);
        }),
        "print(bools)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.bools();
            let value = func::print(env, a0);
            stack.push_bools(value);
        }),
        "print(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::print(env, a0);
            stack.push_floats(value);
        }),
        "print(texts)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.texts();
            let value = func::print(env, a0);
            stack.push_texts(value);
        }),
        "read_float_table(file)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.file();
            let value = func::read_float_table(env, a0);
            stack.push_floats(value);
        }),
        "read_material(file)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.file();
            let value = func::read_material(env, a0);
            stack.push_texts(value);
        }),
        "read_string_table(file)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.file();
            let value = func::read_string_table(env, a0);
            stack.push_texts(value);
        }),
        "rint_each(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::rint_each(env, a0);
            stack.push_floats(value);
        }),
        "sort_indices(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::sort_indices(env, a0);
            stack.push_floats(value);
        }),
        "sort_indices(texts)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.texts();
            let value = func::sort_indices(env, a0);
            stack.push_floats(value);
        }),
        "sort_row_indices(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::sort_row_indices(env, a0);
            stack.push_floats(value);
        }),
        "sort_row_indices(texts)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.texts();
            let value = func::sort_row_indices(env, a0);
            stack.push_floats(value);
        }),
        "split_string(text, text)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::split_string(env, a0, a1);
            stack.push_texts(value);
        }),
        "texts_from_bools(bools)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.bools();
            let value = func::texts_from_bools(env, a0);
            stack.push_texts(value);
        }),
        "texts_from_floats(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::texts_from_floats(env, a0);
            stack.push_texts(value);
        }),
        "transpose(bools)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.bools();
            let value = func::transpose(env, a0);
            stack.push_bools(value);
        }),
        "transpose(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::transpose(env, a0);
            stack.push_floats(value);
        }),
        "transpose(texts)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.texts();
            let value = func::transpose(env, a0);
            stack.push_texts(value);
        }),
        _ => return None,
    })
}
