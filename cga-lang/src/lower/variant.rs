//! Definitions that differ by case: by the style of the run, or by the site of a shared definition.
//!
//! They become one definition. Its value is a `case` with one branch for each variant, and so is the body of a rule.

use super::childless;
use crate::ir::{Attr, Const, Expr, ExprKind, Function, Param, Rule, Step, Type, Value, walk};
use crate::span::Span;
use std::cmp::Reverse;

/// The condition that holds in some cases: [`ExprKind::Style`] or [`ExprKind::Site`].
type When = fn(Vec<u32>) -> ExprKind;

/// A definition that holds in some cases.
pub(super) struct Variant<T> {
    pub(super) cases: Vec<u32>,
    pub(super) own: T,
}

/// The definitions of each number: those with one text are one. The last one is that of most cases, and holds otherwise.
pub(super) fn variants<T>(items: Vec<T>, numbers: &[usize], owners: &[u32], texts: &[String]) -> Vec<Vec<Variant<T>>> {
    let mut all: Vec<Vec<(&str, Variant<T>)>> = Vec::new();
    for (((own, &number), &case), text) in items.into_iter().zip(numbers).zip(owners).zip(texts) {
        if number == all.len() {
            all.push(Vec::new());
        }
        let list = &mut all[number];
        match list.iter_mut().find(|(known, _)| *known == text) {
            Some((_, variant)) => variant.cases.push(case),
            None => list.push((text, Variant { cases: vec![case], own })),
        }
    }
    let sorted = all.into_iter().map(|list| {
        let mut list: Vec<Variant<T>> = list.into_iter().map(|(_, variant)| variant).collect();
        list.sort_by_key(|variant| (variant.cases.len(), Reverse(variant.cases[0])));
        list
    });
    sorted.collect()
}

/// The definition of the first case, for all that does not depend on it.
fn first<T>(variants: &[Variant<T>]) -> &T {
    let first = variants.iter().min_by_key(|variant| variant.cases[0]);
    &first.expect("each number has a definition").own
}

pub(super) fn attr(mut variants: Vec<Variant<Attr>>, when: When) -> Attr {
    let own = first(&variants).clone();
    let known = own.known.clone().filter(|_| variants.len() == 1);
    let is_set = variants.iter().any(|variant| variant.own.is_set);
    let values = variants.drain(..).map(|it| Variant { cases: it.cases, own: it.own.default });
    Attr { default: chosen(values.collect(), when), known, is_set, ..own }
}

pub(super) fn constant(mut variants: Vec<Variant<Const>>, when: When) -> Const {
    let own = first(&variants).clone();
    let known = own.known.clone().filter(|_| variants.len() == 1);
    let is_set = variants.iter().any(|variant| variant.own.is_set);
    let values = variants.drain(..).map(|it| Variant { cases: it.cases, own: it.own.value });
    Const { value: chosen(values.collect(), when), known, is_set, ..own }
}

pub(super) fn function(mut variants: Vec<Variant<Function>>, when: When) -> Function {
    let own = first(&variants).clone();
    let (params, locals) =
        locals(&mut variants, |it| (&it.params, &mut it.locals), |it, change| change(&mut it.body), when);
    let values = variants.into_iter().map(|it| Variant { cases: it.cases, own: it.own.body });
    Function { body: chosen(values.collect(), when), params, locals, ..own }
}

pub(super) fn rule(mut variants: Vec<Variant<Rule>>, when: When) -> Rule {
    if variants.len() == 1 {
        return variants.remove(0).own;
    }
    let own = first(&variants).clone();
    let each = |it: &mut Rule, change: &mut dyn FnMut(&mut Expr)| walk::exprs_mut(&mut it.body, change);
    let (params, locals) = locals(&mut variants, |it| (&it.params, &mut it.locals), each, when);
    let mut bodies: Vec<(Expr, Vec<Step>)> =
        variants.into_iter().map(|it| (is_case(it.cases, own.span, when), it.own.body)).collect();
    let otherwise = bodies.pop().map(|(_, body)| body).unwrap_or_default();
    let body = vec![Step::Case { arms: bodies, otherwise }];
    Rule { leaf: childless::of(&body), body, params, locals, ..own }
}

/// The value of the case in force; the last one holds otherwise.
pub(super) fn chosen(mut values: Vec<Variant<Expr>>, when: When) -> Expr {
    let otherwise = values.pop().expect("each number has a definition").own;
    if values.is_empty() {
        return otherwise;
    }
    let (ty, span) = (otherwise.ty, otherwise.span);
    let arms = values.into_iter().map(|it| (is_case(it.cases, span, when), it.own)).collect();
    Expr { kind: ExprKind::Case(arms, Box::new(otherwise)), ty, span }
}

fn is_case(cases: Vec<u32>, span: Span, when: When) -> Expr {
    Expr { kind: when(cases), ty: Type::Bool, span }
}

/// The parameters and locals of variants together. Each variant keeps its locals; those of other variants are not computed.
fn locals<T>(
    variants: &mut [Variant<T>],
    parts: impl Fn(&mut T) -> (&Vec<Param>, &mut Vec<Expr>),
    exprs: impl Fn(&mut T, &mut dyn FnMut(&mut Expr)),
    when: When,
) -> (Vec<Param>, Vec<Expr>) {
    if let [only] = variants {
        let (params, locals) = parts(&mut only.own);
        return (params.clone(), std::mem::take(locals));
    }
    let (mut all_params, mut all) = (Vec::new(), Vec::new());
    for variant in variants {
        let (params, locals) = parts(&mut variant.own);
        let given = (params.len() - locals.len()) as u32;
        if all_params.is_empty() {
            all_params.extend_from_slice(&params[..given as usize]);
        }
        all_params.extend_from_slice(&params[given as usize..]);
        let before = all.len() as u32;
        let mut moved = |expr: &mut Expr| {
            walk::params_mut(expr, &mut |index| *index += if *index < given { 0 } else { before });
        };
        let mut own = std::mem::take(locals);
        own.iter_mut().for_each(&mut moved);
        exprs(&mut variant.own, &mut moved);
        all.extend(own.into_iter().map(|value| {
            let (ty, span) = (value.ty, value.span);
            let unused = Expr { kind: ExprKind::Value(unused(ty)), ty, span };
            let arms = vec![(is_case(variant.cases.clone(), span, when), value)];
            Expr { kind: ExprKind::Case(arms, Box::new(unused)), ty, span }
        }));
    }
    (all_params, all)
}

/// A value that is never read.
fn unused(ty: Type) -> Value {
    match ty {
        Type::Float => Value::Float(0.0),
        Type::Bool => Value::Bool(false),
        Type::Text => Value::Text(String::new()),
        _ => Value::Array(vec![vec![unused(ty.element())]]),
    }
}
