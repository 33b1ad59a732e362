//! Reads of attributes of the current shape.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::current::{view, whole};
use crate::dispatch::FunctionCall;
use cga_runtime::rt::get;

/// The read of an attribute, by its name.
pub(crate) fn call(name: &str) -> Option<FunctionCall> {
    Some(match name {
        "scope.sx" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::scope_sx(shape,));
            stack.push_float(value);
        }),
        "scope.sy" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::scope_sy(shape,));
            stack.push_float(value);
        }),
        "scope.sz" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::scope_sz(shape,));
            stack.push_float(value);
        }),
        "scope.tx" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::scope_tx(shape,));
            stack.push_float(value);
        }),
        "scope.ty" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::scope_ty(shape,));
            stack.push_float(value);
        }),
        "scope.tz" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::scope_tz(shape,));
            stack.push_float(value);
        }),
        "scope.rx" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::scope_rx(shape,));
            stack.push_float(value);
        }),
        "scope.ry" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::scope_ry(shape,));
            stack.push_float(value);
        }),
        "scope.rz" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::scope_rz(shape,));
            stack.push_float(value);
        }),
        "scope.elevation" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::scope_elevation(env, shape,));
            stack.push_float(value);
        }),
        "split.index" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::split_index(shape,));
            stack.push_float(value);
        }),
        "split.total" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::split_total(shape,));
            stack.push_float(value);
        }),
        "comp.index" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::comp_index(shape,));
            stack.push_float(value);
        }),
        "comp.total" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::comp_total(shape,));
            stack.push_float(value);
        }),
        "comp.sel" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::comp_sel(shape,));
            stack.push_text(value);
        }),
        "trim.vertical" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::trim_vertical(shape,));
            stack.push_bool(value);
        }),
        "trim.horizontal" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::trim_horizontal(shape,));
            stack.push_bool(value);
        }),
        "seedian" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::seedian(shape,));
            stack.push_float(value);
        }),
        "uid" => FunctionCall::new(|stack, env, _| {
            let value = get::uid(env);
            stack.push_float(value);
        }),
        "initialShape.name" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::initial_shape_name(env, shape,));
            stack.push_text(value);
        }),
        "initialShape.startRule" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::initial_shape_start_rule(env, shape,));
            stack.push_text(value);
        }),
        "initialShape.symbol" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::initial_shape_start_rule(env, shape,));
            stack.push_text(value);
        }),
        "initialShape.origin.px" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::initial_shape_origin_px(env, shape,));
            stack.push_float(value);
        }),
        "initialShape.origin.py" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::initial_shape_origin_py(env, shape,));
            stack.push_float(value);
        }),
        "initialShape.origin.pz" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::initial_shape_origin_pz(env, shape,));
            stack.push_float(value);
        }),
        "initialShape.origin.ox" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::initial_shape_origin_ox(env, shape,));
            stack.push_float(value);
        }),
        "initialShape.origin.oy" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::initial_shape_origin_oy(env, shape,));
            stack.push_float(value);
        }),
        "initialShape.origin.oz" => FunctionCall::new(|stack, env, current| {
            let value = view!(env, current, |shape| get::initial_shape_origin_oz(env, shape,));
            stack.push_float(value);
        }),
        "pivot.px" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::pivot_px(env, shape,));
            stack.push_float(value);
        }),
        "pivot.py" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::pivot_py(env, shape,));
            stack.push_float(value);
        }),
        "pivot.pz" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::pivot_pz(env, shape,));
            stack.push_float(value);
        }),
        "pivot.ox" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::pivot_ox(env, shape,));
            stack.push_float(value);
        }),
        "pivot.oy" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::pivot_oy(env, shape,));
            stack.push_float(value);
        }),
        "pivot.oz" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::pivot_oz(env, shape,));
            stack.push_float(value);
        }),
        _ => return None,
    })
}
