//! The steps and expressions of a rule's body, to change them.

use crate::ir::{Expr, ExprKind, Grammar, Step, Target};
use crate::ir_walk::{in_step_mut, targets_mut};

/// Every step of a body, those in brackets and branches included.
pub(super) fn steps(list: &mut [Step], visit: &mut dyn FnMut(&mut Step)) {
    for step in list {
        visit(step);
        match step {
            Step::Push(inner) => steps(inner, visit),
            Step::Case { arms, otherwise } => {
                arms.iter_mut().for_each(|(_, inner)| steps(inner, visit));
                steps(otherwise, visit);
            }
            Step::Chance { arms, otherwise } => {
                arms.iter_mut().for_each(|(_, inner)| steps(inner, visit));
                steps(otherwise, visit);
            }
            _ => {}
        }
    }
}

/// Every expression of a body, without its parts.
pub(super) fn exprs(body: &mut [Step], visit: &mut dyn FnMut(&mut Expr)) {
    steps(body, &mut |step| {
        in_step_mut(step).into_iter().for_each(&mut *visit);
        for target in targets_mut(step) {
            if let Target::Rule { args, .. } = target {
                args.iter_mut().for_each(&mut *visit);
            }
        }
    });
}

/// Every expression of a grammar, with its parts.
pub(super) fn all_exprs(grammar: &mut Grammar, change: &dyn Fn(&mut Expr)) {
    fn parts(expr: &mut Expr, change: &dyn Fn(&mut Expr)) {
        change(expr);
        expr.parts_mut().into_iter().for_each(|part| parts(part, change));
    }
    grammar.attrs.iter_mut().for_each(|it| parts(&mut it.default, change));
    grammar.consts.iter_mut().for_each(|it| parts(&mut it.value, change));
    for function in &mut grammar.functions {
        function.locals.iter_mut().for_each(|local| parts(local, change));
        parts(&mut function.body, change);
    }
    for rule in &mut grammar.rules {
        rule.locals.iter_mut().for_each(|local| parts(local, change));
        exprs(&mut rule.body, &mut |expr| parts(expr, change));
    }
}

/// The parameters an expression reads.
pub(super) fn params(expr: &mut Expr, visit: &mut dyn FnMut(&mut u32)) {
    if let ExprKind::Param(index) = &mut expr.kind {
        visit(index);
    }
    for part in expr.parts_mut() {
        params(part, visit);
    }
}
