//! What stands in expressions: division by zero, texture layers that do not exist, conditions that are always the same.

use super::flow::{Facts, Flow, Turn, Value};
use super::{Cx, Use, branches, colour};
use crate::ast::{Arg, Binary, Expr, ExprKind};
use crate::code::Code;
use crate::diag::Diags;
use crate::ops::{Operation, Param};

/// The last texture layer (*texturing*: from 0 on).
const LAST_LAYER: f64 = 9.0;

/// Looks at an expression and its parts.
pub(super) fn check(expr: &Expr, facts: &Facts, flow: &Flow, cx: &Cx, diags: &mut Diags) {
    match &expr.kind {
        ExprKind::Binary(op @ (Binary::Div | Binary::Rem), _, _, right)
            if flow.value(right, facts).number().known() == Some(0.0) =>
        {
            let what = if *op == Binary::Div { "this divides by zero" } else { "the remainder of zero is no number" };
            let diag = diags.report(Code::DivisionByZero, right.span, what);
            diag.note("the result is no number: operations take it as 0, with a fault");
        }
        ExprKind::Case(arms, other) => return case(arms, other, facts, (facts, &mut Vec::new()), flow, cx, diags),
        ExprKind::Call(name, args) => {
            if let Some(Use::Builtin(row)) = cx.tables.of(name) {
                layers(row.params, args.iter(), facts, flow, diags);
                let args: Vec<&Expr> = args.iter().collect();
                colour::check(cx.globals.program, row.params, &args, facts, flow, diags);
            }
        }
        _ => {}
    }
    // What stands in a comp is computed on each component.
    let component = matches!(expr.kind, ExprKind::Comp(_)).then(|| facts.on_any_shape());
    let facts = component.as_ref().unwrap_or(facts);
    expr.parts().into_iter().for_each(|part| check(part, facts, flow, cx, diags));
}

/// Looks at a `case`. `first` is what was known where its first condition stands, with the conditions since: it may stand
/// behind the `else` of another.
fn case<'e>(
    arms: &'e [(Expr, Expr)],
    other: &'e Expr,
    facts: &Facts,
    (first, before): (&Facts, &mut Vec<&'e Expr>),
    flow: &Flow,
    cx: &Cx,
    diags: &mut Diags,
) {
    // What is never computed may be anything.
    let mut left = Some(facts.clone());
    for (at, (condition, value)) in arms.iter().enumerate() {
        let Some(here) = left else { return };
        let is_last = at + 1 == arms.len();
        branches::check(&Turn { condition, before, is_last, first }, &here, flow, cx, diags);
        before.push(condition);
        check(condition, &here, flow, cx, diags);
        if let Some(inside) = flow.known.past(condition, true, here.clone()) {
            check(value, &inside, flow, cx, diags);
        }
        left = flow.known.past(condition, false, here);
    }
    match (left, &other.kind) {
        (Some(here), ExprKind::Case(arms, other)) => case(arms, other, &here, (first, before), flow, cx, diags),
        (Some(here), _) => check(other, &here, flow, cx, diags),
        (None, _) => {}
    }
}

/// Looks at the arguments of an operation.
pub(super) fn operation(row: &Operation, args: &[Arg], facts: &Facts, flow: &Flow, diags: &mut Diags) {
    layers(row.params, args.iter().map(|arg| &arg.value), facts, flow, diags);
}

/// Texture layers are numbered.
fn layers<'e>(params: &[Param], args: impl Iterator<Item = &'e Expr>, facts: &Facts, flow: &Flow, diags: &mut Diags) {
    for (_, arg) in params.iter().zip(args).filter(|(param, _)| param.name.starts_with("uvSet")) {
        uv_set(arg, facts, flow, diags);
    }
}

/// Looks at the number of a uv set.
pub(super) fn uv_set(arg: &Expr, facts: &Facts, flow: &Flow, diags: &mut Diags) {
    if let Value::Number(number) = flow.value(arg, facts)
        && !number.is_odd()
        && (number.hi < 0.0 || LAST_LAYER < number.lo)
    {
        let shown = number.known().map_or_else(|| "this".to_owned(), super::size::shown);
        let diag = diags.report(Code::UnknownUvSet, arg.span, format!("{shown} is not the number of a uv set"));
        diag.note("uv sets are numbered from 0 to 9");
    }
}
