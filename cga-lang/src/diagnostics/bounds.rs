//! Arguments outside the documented values of their parameters.

use cga_split::tags;

use super::numbers::shown;
use crate::analysis::interval::Interval;
use crate::analysis::{AbstractState, DataFlow, Value};
use crate::diag::code::Code;
use crate::diag::{Diags, Level};
use crate::ops::{Allowed, Param, ParamBounds};
use crate::syntax::ast::{Expr, ExprKind};

/// Reports the arguments of a call that are out of bounds for all their possible values.
pub(crate) fn check(params: &[Param], args: &[&Expr], facts: &AbstractState, flow: &DataFlow, diags: &mut Diags) {
    for (param, arg) in params.iter().zip(args) {
        let Some(bounds) = param.bounds else { continue };
        let found = match (bounds.values, flow.value(arg, facts)) {
            (Allowed::NotEmpty, _) => is_empty_text(arg).then(|| "this text".to_owned()),
            (Allowed::TagName, _) => match &arg.kind {
                ExprKind::Text(text) => Some(tags::name(text)).filter(|name| name.is_empty() || name != text),
                _ => None,
            },
            (values, Value::Number(number)) => {
                is_outside(values, number).then(|| number.known().map_or_else(|| "this".to_owned(), shown))
            }
            (values, _) => has_only_outside(values, arg, facts, flow).then(|| "every element".to_owned()),
        };
        if let Some(found) = found {
            report(param, bounds, arg, &found, diags);
        }
    }
}

fn report(param: &Param, bounds: &ParamBounds, arg: &Expr, found: &str, diags: &mut Diags) {
    let message = match bounds.code {
        Code::UnknownUvSet => format!("{found} is not the number of a uv set"),
        _ if bounds.values == Allowed::NotEmpty => format!("`{}` is empty", param.name),
        _ if bounds.values == Allowed::TagName && found.is_empty() => {
            format!("`{}` has no characters except wildcards", param.name)
        }
        _ if bounds.values == Allowed::TagName => format!("`{}` has wildcards", param.name),
        _ => format!("{found} is outside the values of `{}`", param.name),
    };
    let level = bounds.result.map_or(bounds.code.level(), |_| Level::Warning);
    let diag = diags.report_as(bounds.code, level, arg.span, message);
    diag.note(bounds.about);
    if bounds.values == Allowed::TagName && !found.is_empty() {
        diag.note(format!("the tag is `{found}`"));
    } else if let Some(result) = bounds.result {
        diag.note(result);
    }
}

/// Returns true if no number of an interval is allowed. Runs treat NaN as 0, with a fault.
fn is_outside(values: Allowed, number: Interval) -> bool {
    if number.is_odd() {
        return false;
    }
    match values {
        Allowed::Between(least, most) => number.hi < least || most < number.lo,
        Allowed::Whole(least, most) => {
            number.hi < least || most < number.lo || number.known().is_some_and(|number| number.fract() != 0.0)
        }
        Allowed::AtLeast(least) => number.hi < least,
        Allowed::Above(least) => number.hi <= least,
        Allowed::Inside(least, most) => number.hi <= least || most <= number.lo,
        Allowed::Sloped(most) => number.hi <= -most || most <= number.lo || number.known() == Some(0.0),
        Allowed::NotEmpty | Allowed::TagName | Allowed::TagQuery => false,
    }
}

/// Returns true if no element of an array is allowed. Components without a value have the element 0.
fn has_only_outside(values: Allowed, array: &Expr, facts: &AbstractState, flow: &DataFlow) -> bool {
    let is_out = |value: &Expr, facts: &AbstractState| {
        let is_single = !matches!(value.kind, ExprKind::Range(..));
        matches!(flow.value(value, facts), Value::Number(number) if is_single && is_outside(values, number))
    };
    match &array.kind {
        ExprKind::Array(rows) => {
            let mut elements = rows.iter().flatten().peekable();
            elements.peek().is_some() && elements.all(|element| is_out(element, facts))
        }
        ExprKind::Comp(comp) => {
            // Values are computed on the components.
            let component = facts.on_any_shape();
            is_outside(values, Interval::point(0.0)) && comp.arms.iter().all(|arm| is_out(&arm.2, &component))
        }
        _ => false,
    }
}

fn is_empty_text(arg: &Expr) -> bool {
    matches!(&arg.kind, ExprKind::Text(text) if text.is_empty())
}
