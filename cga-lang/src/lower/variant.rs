//! Definitions that differ by case: by the style of the run, or by the site of a shared definition.
//!
//! They become one definition. Its value is a `case` with one branch for each variant, and so is the body of a rule.

use super::childless;
use super::definition::{CanonicalForm, CaseCondition, Definition, Variant};
use crate::ir::{Expr, ExprKind, Function, Global, Param, Rule, Step, StepKind, Type, Value, walk};
use crate::span::Span;
use std::cmp::Reverse;

/// The definitions of each number: equal forms are one definition. The last one holds in most cases, and in all cases that are not listed.
pub(super) fn variants<T>(
    items: Vec<T>,
    numbers: &[usize],
    owners: &[u32],
    forms: &[CanonicalForm],
) -> Vec<Vec<Variant<T>>> {
    let mut all: Vec<Vec<(&CanonicalForm, Variant<T>)>> = Vec::new();
    for (((own, &number), &case), form) in items.into_iter().zip(numbers).zip(owners).zip(forms) {
        if number == all.len() {
            all.push(Vec::new());
        }
        let list = &mut all[number];
        match list.iter_mut().find(|(known, _)| *known == form) {
            Some((_, variant)) => variant.cases.push(case),
            None => list.push((form, Variant { cases: vec![case], own })),
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
fn first<T: Clone>(variants: &[Variant<T>]) -> T {
    let first = variants.iter().min_by_key(|variant| variant.cases[0]);
    first.expect("each number has a definition").own.clone()
}

impl Definition for Global {
    fn values(&mut self) -> Vec<&mut Expr> {
        vec![&mut self.value]
    }

    fn merged(variants: Vec<Variant<Global>>, when: CaseCondition) -> Global {
        let own = first(&variants);
        let known = own.known.filter(|_| variants.len() == 1);
        let is_set = variants.iter().any(|variant| variant.own.is_set);
        let values = variants.into_iter().map(|it| Variant { cases: it.cases, own: it.own.value });
        Global { value: chosen(values.collect(), when), known, is_set, ..own }
    }
}

impl Definition for Function {
    fn params(&self) -> &[Param] {
        &self.params
    }

    fn values(&mut self) -> Vec<&mut Expr> {
        self.locals.iter_mut().chain([&mut self.body]).collect()
    }

    fn merged(mut variants: Vec<Variant<Function>>, when: CaseCondition) -> Function {
        let own = first(&variants);
        let (params, locals) = locals(&mut variants, |it| &mut it.locals, when);
        let values = variants.into_iter().map(|it| Variant { cases: it.cases, own: it.own.body });
        Function { body: chosen(values.collect(), when), params, locals, ..own }
    }
}

impl Definition for Rule {
    fn params(&self) -> &[Param] {
        &self.params
    }

    fn values(&mut self) -> Vec<&mut Expr> {
        self.locals.iter_mut().collect()
    }

    fn steps(&mut self) -> &mut [Step] {
        &mut self.body
    }

    fn merged(mut variants: Vec<Variant<Rule>>, when: CaseCondition) -> Rule {
        if variants.len() == 1 {
            return variants.remove(0).own;
        }
        let own = first(&variants);
        let (params, locals) = locals(&mut variants, |it| &mut it.locals, when);
        let mut bodies: Vec<(Expr, Vec<Step>)> =
            variants.into_iter().map(|it| (is_case(it.cases, own.span, when), it.own.body)).collect();
        let otherwise = bodies.pop().map(|(_, body)| body).unwrap_or_default();
        let body = vec![Step { kind: StepKind::Case { arms: bodies, otherwise }, span: own.span }];
        Rule { leaf: childless::of(&body), body, params, locals, ..own }
    }
}

/// The value of the case in force; the last one holds otherwise.
pub(super) fn chosen(mut values: Vec<Variant<Expr>>, when: CaseCondition) -> Expr {
    let otherwise = values.pop().expect("each number has a definition").own;
    if values.is_empty() {
        return otherwise;
    }
    let (ty, span) = (otherwise.ty, otherwise.span);
    let arms = values.into_iter().map(|it| (is_case(it.cases, span, when), it.own)).collect();
    Expr { kind: ExprKind::Case(arms, Box::new(otherwise)), ty, span }
}

fn is_case(cases: Vec<u32>, span: Span, when: CaseCondition) -> Expr {
    Expr { kind: when(cases), ty: Type::Bool, span }
}

/// The parameters and locals of variants together. Each variant keeps its locals; the locals of other variants are not computed.
fn locals<T: Definition>(
    variants: &mut [Variant<T>],
    locals: fn(&mut T) -> &mut Vec<Expr>,
    when: CaseCondition,
) -> (Vec<Param>, Vec<Expr>) {
    if let [only] = variants {
        return (only.own.params().to_vec(), std::mem::take(locals(&mut only.own)));
    }
    let (mut params, mut all) = (Vec::new(), Vec::new());
    for Variant { cases, own } in variants {
        let given = own.params().len() - locals(own).len();
        if params.is_empty() {
            params.extend_from_slice(&own.params()[..given]);
        }
        params.extend_from_slice(&own.params()[given..]);
        let before = all.len() as u32;
        own.exprs(&mut |expr| {
            walk::params_mut(expr, &mut |index| *index += if *index < given as u32 { 0 } else { before });
        });
        all.extend(std::mem::take(locals(own)).into_iter().map(|value| {
            let (ty, span) = (value.ty, value.span);
            let unused = Expr { kind: ExprKind::Value(unused(ty)), ty, span };
            let arms = vec![(is_case(cases.clone(), span, when), value)];
            Expr { kind: ExprKind::Case(arms, Box::new(unused)), ty, span }
        }));
    }
    (params, all)
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
