//! The functions.

use super::{B, F, Function, Needs, Param, Run, boolean, float, text};
use crate::ir::Type;

/// Every function. `str`, `float` and `bool` of a value that has the type already is the value itself, and `str` of a
/// float or bool is [`ToText`](crate::ir::ExprKind::ToText): these need no row.
pub static FUNCTIONS: &[&[Function]] = &[VALUES];

const fn func(
    name: &'static str,
    call: &'static str,
    params: &'static [Param],
    ty: Type,
    about: &'static str,
) -> Function {
    Function { name, run: Run::Now(call), params, ty, needs: Needs::Nothing, pure: true, about }
}

const fn draw(
    name: &'static str,
    call: &'static str,
    params: &'static [Param],
    ty: Type,
    about: &'static str,
) -> Function {
    Function { name, run: Run::Now(call), params, ty, needs: Needs::Shape, pure: false, about }
}

static VALUES: &[Function] = &[
    draw("rand", "rand", &[], F, ""),
    draw("rand", "rand_to", &[float("max")], F, ""),
    draw("rand", "rand_between", &[float("min"), float("max")], F, ""),
    draw("p", "chance", &[float("q")], B, ""),
    func("floor", "floor", &[float("x")], F, ""),
    func("ceil", "ceil", &[float("x")], F, ""),
    func("rint", "rint", &[float("x")], F, ""),
    func("abs", "abs", &[float("x")], F, ""),
    func("sqrt", "sqrt", &[float("x")], F, ""),
    func("sin", "sin", &[float("x")], F, ""),
    func("cos", "cos", &[float("x")], F, ""),
    func("tan", "tan", &[float("x")], F, ""),
    func("asin", "asin", &[float("x")], F, ""),
    func("acos", "acos", &[float("x")], F, ""),
    func("atan", "atan", &[float("x")], F, ""),
    func("atan2", "atan2", &[float("y"), float("x")], F, ""),
    func("pow", "pow", &[float("base"), float("exponent")], F, ""),
    func("exp", "exp", &[float("x")], F, ""),
    func("ln", "ln", &[float("x")], F, ""),
    func("log10", "log10", &[float("x")], F, ""),
    func("min", "min", &[float("x"), float("y")], F, ""),
    func("max", "max", &[float("x"), float("y")], F, ""),
    func("clamp", "clamp", &[float("x"), float("min"), float("max")], F, ""),
    func("isnan", "isnan", &[float("x")], B, ""),
    func("isinf", "isinf", &[float("x")], B, ""),
    func("float", "bool_to_float", &[boolean("x")], F, ""),
    func("float", "text_to_float", &[text("x")], F, ""),
    func("bool", "float_to_bool", &[float("x")], B, ""),
    func("bool", "text_to_bool", &[text("x")], B, ""),
];
