//! Arguments outside the documented values of their parameters.

use cga_split::tags;

use super::elements::{Element, elements};
use super::numbers::shown;
use crate::analysis::interval::Interval;
use crate::analysis::{AbstractState, DataFlow, Value};
use crate::diag::code::Code;
use crate::diag::{Diag, Diags, Level};
use crate::ops::{Allowed, Param, ParamBounds};
use crate::resolve::context::Context;
use crate::span::Span;
use crate::syntax::ast::{Expr, ExprKind};

/// Reports the arguments of a call that are out of bounds for all their possible values.
pub(crate) fn check(
    params: &[Param],
    args: &[&Expr],
    facts: &AbstractState,
    flow: &DataFlow,
    cx: &Context,
    diags: &mut Diags,
) {
    let is_word =
        |word: &str| params.iter().zip(args).any(|(param, arg)| param.kind.has_word(word) && arg.word() == Some(word));
    for (param, arg) in params.iter().zip(args) {
        let Some(bounds) = param.bounds.map(|bounds| bounds.in_call(is_word)) else { continue };
        let found = match (bounds.values, flow.value(arg, facts)) {
            (Allowed::NotEmpty, _) => is_empty_text(arg).then(|| "this text".to_owned()),
            (Allowed::TagName, _) => match &arg.kind {
                ExprKind::Text(text) => Some(tags::name(text)).filter(|name| name.is_empty() || name != text),
                _ => None,
            },
            (values, Value::Number(number)) => is_outside(values, number).then(|| told(number)),
            _ => {
                array(param, bounds, arg, facts, flow, cx, diags);
                None
            }
        };
        if let Some(found) = found {
            report(param, bounds, arg.span, &found, diags);
        }
    }
}

/// Reports an array of which every element is out of bounds, or else its elements that are.
fn array(
    param: &Param,
    bounds: &ParamBounds,
    arg: &Expr,
    facts: &AbstractState,
    flow: &DataFlow,
    cx: &Context,
    diags: &mut Diags,
) {
    let list = elements(arg, facts, flow, cx);
    let is_out = |element: &Element, values: Allowed| element.number.is_some_and(|number| is_outside(values, number));
    if !list.is_empty() && list.iter().all(|element| is_out(element, bounds.values)) {
        report(param, bounds, arg.span, "every element", diags);
        return;
    }
    let bounds = bounds.of_element();
    for element in list.iter().filter(|element| is_out(element, bounds.values)) {
        let (Some(number), Some(span)) = (element.number, element.span) else { continue };
        if span.is_in(arg.span) {
            report(param, bounds, span, &told(number), diags);
        } else {
            report(param, bounds, arg.span, &told(number), diags).related("the element is", span);
            // Further elements have the same place.
            break;
        }
    }
}

/// The number that is out of bounds, for a message.
fn told(number: Interval) -> String {
    number.known().map_or_else(|| "this".to_owned(), shown)
}

fn report<'d>(param: &Param, bounds: &ParamBounds, span: Span, found: &str, diags: &'d mut Diags) -> &'d mut Diag {
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
    let diag = diags.report_as(bounds.code, level, span, message);
    diag.note(bounds.about);
    if bounds.values == Allowed::TagName && !found.is_empty() {
        diag.note(format!("the tag is `{found}`"));
    } else if let Some(result) = bounds.result {
        diag.note(result);
    }
    diag
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

fn is_empty_text(arg: &Expr) -> bool {
    matches!(&arg.kind, ExprKind::Text(text) if text.is_empty())
}
