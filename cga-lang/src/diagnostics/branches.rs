//! Conditions that are always true or always false.

use super::numbers::{is_bound, range};
use super::switch::is_switch;
use crate::analysis::{AbstractState, CaseBranch, DataFlow, Value};
use crate::diag::code::Code;
use crate::diag::{Detail, Diag, Diags};
use crate::hash::FastMap;
use crate::ir::ChoiceValues;
use crate::link::InstanceId;
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::suggest::nearest;
use crate::syntax::ast::{Binary, Expr, ExprKind, Unary};
use crate::syntax::token::{Sym, Tok};
use std::collections::HashSet;

/// Checks a condition of a `case`.
pub(crate) fn check(turn: &CaseBranch, facts: &AbstractState, flow: &DataFlow, cx: &Context, diags: &mut Diags) {
    let condition = turn.condition;
    let Some(truth) = flow.value(condition, facts).truth() else {
        // A part of the condition may still be wrong.
        if let Some(stray) = unlisted(condition, facts.own, cx)
            && let Some(truth) = flow.value(stray.part, facts).truth()
        {
            stray.report(always(stray.part, truth, diags));
        }
        return again(turn, facts.own, cx, diags);
    };
    if is_decided_by_switch(condition, truth, facts, flow, cx) {
        return;
    }
    // A condition that names the last possibility is not reported, because `else` is required after it.
    if truth && turn.is_last && flow.value(condition, turn.first).truth().is_none() {
        return;
    }
    let diag = always(condition, truth, diags);
    let mut notes = Vec::new();
    if let Some(stray) = unlisted(condition, facts.own, cx).filter(|stray| stray.part.span == bare(condition).span) {
        stray.report(diag);
    } else {
        reasons(condition, truth, facts, flow, "here", &mut notes);
    }
    notes.dedup();
    for note in notes {
        diag.note(note);
    }
    diag.note(if truth { "the branches after it are never taken" } else { "this branch is never taken" });
}

fn always<'d>(condition: &Expr, truth: bool, diags: &'d mut Diags) -> &'d mut Diag {
    let word = if truth { "true" } else { "false" };
    let diag = diags.report(Code::CaseAlways, condition.span, format!("this condition is always {word}"));
    diag.detail = Detail::Condition(truth);
    diag
}

/// A comparison of an attribute with a text that the attribute never has.
struct Stray<'e> {
    part: &'e Expr,
    attr: &'e str,
    text: &'e str,
    /// The text that was probably meant.
    near: Option<&'e str>,
}

impl Stray<'_> {
    fn report(&self, diag: &mut Diag) {
        let Stray { attr, text, .. } = self;
        diag.note(format!("\"{text}\" is not one of the allowed values of `{attr}`"));
        diag.help(match self.near {
            Some(near) => format!("did you mean \"{near}\"?"),
            None => format!("write one of the values in its annotation, or add \"{text}\" there"),
        });
    }
}

/// A condition without its leading `!`.
fn bare(condition: &Expr) -> &Expr {
    match &condition.kind {
        ExprKind::Unary(Unary::Not, operand) => bare(operand),
        _ => condition,
    }
}

/// Searches a condition for such a comparison.
fn unlisted<'e>(condition: &'e Expr, own: InstanceId, cx: &'e Context) -> Option<Stray<'e>> {
    let (name, text) = match &condition.kind {
        ExprKind::Unary(Unary::Not, operand) => return unlisted(operand, own, cx),
        ExprKind::Binary(Binary::And | Binary::Or, _, left, right) => {
            return unlisted(left, own, cx).or_else(|| unlisted(right, own, cx));
        }
        ExprKind::Chain(..) => return condition.parts().into_iter().find_map(|part| unlisted(part, own, cx)),
        ExprKind::Binary(Binary::Eq | Binary::Ne, _, left, right) => match (&left.kind, &right.kind) {
            (ExprKind::Name(name), ExprKind::Text(text)) | (ExprKind::Text(text), ExprKind::Name(name)) => (name, text),
            _ => return None,
        },
        _ => return None,
    };
    let Some(Use::Attr(attr)) = cx.tables.at(own).of(name) else { return None };
    let ChoiceValues::Texts(list) = cx.tables.attrs.get(attr as usize)?.held_to_choices()? else { return None };
    let near = nearest(text, list.iter().map(String::as_str));
    (!list.contains(text)).then_some(Stray { part: condition, attr: &name.text, text, near })
}

/// Reports a condition that has already failed, word for word.
fn again(turn: &CaseBranch, own: InstanceId, cx: &Context, diags: &mut Diags) {
    let condition = turn.condition;
    let Some(first) = turn.before.find(condition.span) else { return };
    if !is_settled(condition, cx.tables.at(own)) {
        return;
    }
    let diag = always(condition, false, diags);
    diag.related("the same condition comes before it", first.span);
    diag.note("this branch is never taken");
}

/// Returns true if an expression always has the same value on one shape: it uses no chance and no Rust code.
pub(super) fn is_settled(expr: &Expr, names: Entries) -> bool {
    let own = match &expr.kind {
        ExprKind::Name(name) | ExprKind::Call(name, _) => match names.of(name) {
            Some(Use::Builtin(row)) => row.is_settled(),
            Some(Use::Function(_)) | None => false,
            Some(_) => true,
        },
        ExprKind::Path(..) | ExprKind::Host(_) | ExprKind::Chance(..) | ExprKind::Error => false,
        _ => true,
    };
    own && expr.parts().into_iter().all(|part| is_settled(part, names))
}

/// Collects the known values of the compared operands, if these decide the condition.
fn reasons(
    condition: &Expr,
    truth: bool,
    facts: &AbstractState,
    flow: &DataFlow,
    place: &str,
    notes: &mut Vec<String>,
) {
    match &condition.kind {
        ExprKind::Unary(Unary::Not, operand) => reasons(operand, !truth, facts, flow, place, notes),
        ExprKind::Binary(op @ (Binary::And | Binary::Or), _, left, right) => {
            let mut is_told = false;
            for side in [left, right] {
                if flow.value(side, facts).truth() == Some(truth) {
                    reasons(side, truth, facts, flow, place, notes);
                    is_told = true;
                }
            }
            // Otherwise the value of one side follows from the other.
            let goes_on = *op == Binary::And;
            if !is_told && let Some(facts) = flow.known.past(left, goes_on, facts.clone()) {
                let place =
                    if goes_on { "where the part before it is true" } else { "where the part before it is false" };
                reasons(right, truth, &facts, flow, place, notes);
            }
        }
        ExprKind::Binary(_, _, left, right) => {
            for side in [left, right] {
                if let (ExprKind::Name(name), Some(here)) = (&side.kind, told(side, facts, flow)) {
                    notes.push(format!("`{}` is {here} {place}", name.text));
                }
            }
        }
        ExprKind::Name(name) => {
            notes.extend(told(condition, facts, flow).map(|here| format!("`{}` is {here} {place}", name.text)));
        }
        _ => {}
    }
}

/// A value in a message, if something is known about it.
fn told(expr: &Expr, facts: &AbstractState, flow: &DataFlow) -> Option<String> {
    match flow.value(expr, facts) {
        Value::Number(number) if is_bound(number.lo) || is_bound(number.hi) => {
            Some(format!("{}{}", range(number), if number.may_be_nan() { ", or NaN" } else { "" }))
        }
        Value::Truth(Some(truth)) => Some(truth.to_string()),
        Value::Text(set) => flow.known.told(set),
        _ => None,
    }
}

/// Returns true if a switch decides a condition.
fn is_decided_by_switch(condition: &Expr, truth: bool, facts: &AbstractState, flow: &DataFlow, cx: &Context) -> bool {
    let decides = |side: &Expr, truth: bool| {
        flow.value(side, facts).truth() == Some(truth) && is_decided_by_switch(side, truth, facts, flow, cx)
    };
    match &condition.kind {
        ExprKind::Unary(Unary::Not, operand) => decides(operand, !truth),
        // One side is enough, or one of the two sides that are needed.
        ExprKind::Binary(Binary::And | Binary::Or, _, left, right) => decides(left, truth) || decides(right, truth),
        ExprKind::Chain(..) => condition.parts().into_iter().any(|part| decides(part, truth)) || is_literal(condition),
        ExprKind::Binary(Binary::Lt | Binary::Le | Binary::Gt | Binary::Ge, _, left, right) => {
            is_level(left, right, facts.own, cx) || is_level(right, left, facts.own, cx)
        }
        _ => is_switch(condition, cx.tables.at(facts.own)) || is_literal(condition),
    }
}

/// Returns true if an order comparison tests a switch. One kind is a constant against zero, which turns a part off
/// (`overhang > 0`). The other is a constant that the rules compare several times and do not use otherwise (`lod > 1`,
/// `lod > 2`).
fn is_level(constant: &Expr, bound: &Expr, own: InstanceId, cx: &Context) -> bool {
    let (ExprKind::Name(name) | ExprKind::Call(name, _), ExprKind::Number(bound)) = (&constant.kind, &bound.kind)
    else {
        return false;
    };
    let names = cx.tables.at(own);
    match names.of(name) {
        Some(Use::Function(_)) => *bound == 0.0 && is_switch(constant, names),
        Some(Use::Const(index)) => *bound == 0.0 || cx.tables.levels.contains(&index),
        _ => false,
    }
}

/// The constants that are used more than once, always in a comparison with a number.
pub(crate) fn levels(cx: &Context) -> HashSet<u32> {
    let tokens = cx.globals.program.tokens.as_slice();
    let at = |token: u32, step: i64| usize::try_from(i64::from(token) + step).ok().and_then(|at| tokens.get(at));
    let compares = |token: u32, step: i64| {
        use Sym::{EqEq, Greater, GreaterEq, Less, LessEq, NotEq};
        let compared = matches!(at(token, step), Some(Tok::Sym(EqEq | NotEq | Less | LessEq | Greater | GreaterEq)));
        compared && matches!(at(token, 2 * step), Some(Tok::Number(_)))
    };
    let mut counts: FastMap<u32, Option<u32>> = FastMap::default();
    for (&(_, token), found) in &cx.tables.uses {
        if let Use::Const(index) = found {
            let is_compared = compares(token, 1) || compares(token, -1);
            let count = counts.entry(*index).or_insert(Some(0));
            *count = count.filter(|_| is_compared).map(|count| count + 1);
        }
    }
    counts.into_iter().filter(|(_, count)| 1 < count.unwrap_or(0)).map(|(index, _)| index).collect()
}

/// Returns true if an expression has no names: `1 == 1` is a switch, too.
fn is_literal(expr: &Expr) -> bool {
    matches!(
        expr.kind,
        ExprKind::Number(_)
            | ExprKind::Bool(_)
            | ExprKind::Text(_)
            | ExprKind::Unary(..)
            | ExprKind::Binary(..)
            | ExprKind::Chain(..)
    ) && expr.parts().into_iter().all(is_literal)
}
