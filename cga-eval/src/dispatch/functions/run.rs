//! Calls of functions that read the run and make a single value.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::{FunctionCall, Known as _, words};
use cga_lang::ir::Expr;
use cga_runtime::rt::func;

/// The call of a function of this group, by the key of its row.
pub(super) fn call(key: &str, known: &[Expr]) -> Option<FunctionCall> {
    Some(match key {
        "abs(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::abs(env, a0);
            stack.push_float(value);
        }),
        "acos(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::acos(env, a0);
            stack.push_float(value);
        }),
        "asin(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::asin(env, a0);
            stack.push_float(value);
        }),
        "asset_info(file, AssetDimension)" => {
            let a1 = words::func_asset_dimension(known.word(1)?)?;
            FunctionCall::new(move |stack, env, _| {
                let a0 = stack.file();
                let value = func::asset_info(env, a0, a1);
                stack.push_float(value);
            })
        }
        "asset_metadata_bool(file, text, bool)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.bool();
            let a1 = stack.text();
            let a0 = stack.file();
            let value = func::asset_metadata_bool(env, a0, a1, a2);
            stack.push_bool(value);
        }),
        "asset_metadata_float(file, text, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.text();
            let a0 = stack.file();
            let value = func::asset_metadata_float(env, a0, a1, a2);
            stack.push_float(value);
        }),
        "asset_metadata_text(file, text, text)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.text();
            let a1 = stack.text();
            let a0 = stack.file();
            let value = func::asset_metadata_text(env, a0, a1, a2);
            stack.push_text(value);
        }),
        "asset_naming_info(file, AssetNaming)" => {
            let a1 = words::func_asset_naming(known.word(1)?)?;
            FunctionCall::new(move |stack, env, _| {
                let a0 = stack.file();
                let value = func::asset_naming_info(env, a0, a1);
                stack.push_text(value);
            })
        }
        "atan(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::atan(env, a0);
            stack.push_float(value);
        }),
        "atan2(float, float)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.float();
            let a0 = stack.float();
            let value = func::atan2(env, a0, a1);
            stack.push_float(value);
        }),
        "ceil(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::ceil(env, a0);
            stack.push_float(value);
        }),
        "color_hex_to_b(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::color_hex_to_b(env, a0);
            stack.push_float(value);
        }),
        "color_hex_to_g(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::color_hex_to_g(env, a0);
            stack.push_float(value);
        }),
        "color_hex_to_h(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::color_hex_to_h(env, a0);
            stack.push_float(value);
        }),
        "color_hex_to_o(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::color_hex_to_o(env, a0);
            stack.push_float(value);
        }),
        "color_hex_to_r(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::color_hex_to_r(env, a0);
            stack.push_float(value);
        }),
        "color_hex_to_s(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::color_hex_to_s(env, a0);
            stack.push_float(value);
        }),
        "color_hex_to_v(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::color_hex_to_v(env, a0);
            stack.push_float(value);
        }),
        "color_hsv_to_hex(float, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            let value = func::color_hsv_to_hex(env, a0, a1, a2);
            stack.push_text(value);
        }),
        "color_hsvo_to_hex(float, float, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            let value = func::color_hsvo_to_hex(env, a0, a1, a2, a3);
            stack.push_text(value);
        }),
        "color_ramp(text, float)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.float();
            let a0 = stack.text();
            let value = func::color_ramp(env, a0, a1);
            stack.push_text(value);
        }),
        "color_rgb_to_hex(float, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            let value = func::color_rgb_to_hex(env, a0, a1, a2);
            stack.push_text(value);
        }),
        "color_rgbo_to_hex(float, float, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            let value = func::color_rgbo_to_hex(env, a0, a1, a2, a3);
            stack.push_text(value);
        }),
        "cos(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::cos(env, a0);
            stack.push_float(value);
        }),
        "exp(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::exp(env, a0);
            stack.push_float(value);
        }),
        "file_basename(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::file_basename(env, a0);
            stack.push_text(value);
        }),
        "file_directory(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::file_directory(env, a0);
            stack.push_text(value);
        }),
        "file_exists(file)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.file();
            let value = func::file_exists(env, a0);
            stack.push_bool(value);
        }),
        "file_extension(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::file_extension(env, a0);
            stack.push_text(value);
        }),
        "file_name(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::file_name(env, a0);
            stack.push_text(value);
        }),
        "file_search(file)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.file();
            let value = func::file_search(env, a0);
            stack.push_text(value);
        }),
        "find(text, text, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::find(env, a0, a1, a2);
            stack.push_float(value);
        }),
        "find_near(floats, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.floats();
            let value = func::find_near(env, a0, a1, a2);
            stack.push_float(value);
        }),
        "floor(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::floor(env, a0);
            stack.push_float(value);
        }),
        "get_prefix(text, text)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::get_prefix(env, a0, a1);
            stack.push_text(value);
        }),
        "get_range(text, text, text)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.text();
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::get_range(env, a0, a1, a2);
            stack.push_text(value);
        }),
        "get_suffix(text, text)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::get_suffix(env, a0, a1);
            stack.push_text(value);
        }),
        "get_tree_key()" => FunctionCall::new(move |stack, env, _| {
            let value = func::get_tree_key(env);
            stack.push_text(value);
        }),
        "image_info(file, ImageDimension)" => {
            let a1 = words::func_image_dimension(known.word(1)?)?;
            FunctionCall::new(move |stack, env, _| {
                let a0 = stack.file();
                let value = func::image_info(env, a0, a1);
                stack.push_float(value);
            })
        }
        "join(texts)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.texts();
            let value = func::join(env, a0);
            stack.push_text(value);
        }),
        "list_add(text, text)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::list_add(env, a0, a1);
            stack.push_text(value);
        }),
        "list_clean(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::list_clean(env, a0);
            stack.push_text(value);
        }),
        "list_first(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::list_first(env, a0);
            stack.push_text(value);
        }),
        "list_from_array(bools)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.bools();
            let value = func::list_from_array(env, a0);
            stack.push_text(value);
        }),
        "list_from_array(floats)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.floats();
            let value = func::list_from_array(env, a0);
            stack.push_text(value);
        }),
        "list_from_array(texts)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.texts();
            let value = func::list_from_array(env, a0);
            stack.push_text(value);
        }),
        "list_item(text, float)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.float();
            let a0 = stack.text();
            let value = func::list_item(env, a0, a1);
            stack.push_text(value);
        }),
        "list_last(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::list_last(env, a0);
            stack.push_text(value);
        }),
        "list_range(text, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.text();
            let value = func::list_range(env, a0, a1, a2);
            stack.push_text(value);
        }),
        "list_remove(text, text)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::list_remove(env, a0, a1);
            stack.push_text(value);
        }),
        "list_remove_all(text, text)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::list_remove_all(env, a0, a1);
            stack.push_text(value);
        }),
        "list_retain_all(text, text)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::list_retain_all(env, a0, a1);
            stack.push_text(value);
        }),
        "list_terminate(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::list_terminate(env, a0);
            stack.push_text(value);
        }),
        "ln(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::ln(env, a0);
            stack.push_float(value);
        }),
        "log10(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::log10(env, a0);
            stack.push_float(value);
        }),
        "pow(float, float)" => FunctionCall::new(move |stack, env, _| {
            let a1 = stack.float();
            let a0 = stack.float();
            let value = func::pow(env, a0, a1);
            stack.push_float(value);
        }),
        "print(bool)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.bool();
            let value = func::print(env, a0);
            stack.push_bool(value);
        }),
        "print(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::print(env, a0);
            stack.push_float(value);
        }),
        "print(text)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.text();
            let value = func::print(env, a0);
            stack.push_text(value);
        }),
        "read_text_file(file)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.file();
            let value = func::read_text_file(env, a0);
            stack.push_text(value);
        }),
        "replace(text, text, bool)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.bool();
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::replace(env, a0, a1, a2);
            stack.push_text(value);
        }),
        "replace(text, text, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::replace(env, a0, a1, a2);
            stack.push_text(value);
        }),
        "replace(text, text, text)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.text();
            let a1 = stack.text();
            let a0 = stack.text();
            let value = func::replace(env, a0, a1, a2);
            stack.push_text(value);
        }),
        "rint(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::rint(env, a0);
            stack.push_float(value);
        }),
        "sin(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::sin(env, a0);
            stack.push_float(value);
        }),
        "sqrt(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::sqrt(env, a0);
            stack.push_float(value);
        }),
        "substring(text, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.text();
            let value = func::substring(env, a0, a1, a2);
            stack.push_text(value);
        }),
        "tan(float)" => FunctionCall::new(move |stack, env, _| {
            let a0 = stack.float();
            let value = func::tan(env, a0);
            stack.push_float(value);
        }),
        _ => return None,
    })
}
