//! Over the expressions of a rule's body, to change them. Who only looks uses `ir_walk`.

use crate::ir::{Arg, Expr, ExprKind, Grammar, Measure, Selector, Step, Target};

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

/// What a step hands shapes to.
pub(super) fn targets(step: &mut Step) -> Vec<&mut Target> {
    match step {
        Step::Give(target) => vec![target],
        Step::Anew(anew) => vec![&mut anew.target],
        Step::Split(split) => split.slots.iter_mut().collect(),
        Step::Comp(comp) => comp.arms.iter_mut().map(|arm| &mut arm.then).collect(),
        _ => Vec::new(),
    }
}

/// Every expression that stands in a body, without its parts.
pub(super) fn exprs(steps: &mut [Step], visit: &mut dyn FnMut(&mut Expr)) {
    for step in steps {
        match step {
            Step::Do(_, args, _) => args.iter_mut().for_each(|arg| match arg {
                Arg::Value(value) => visit(value),
                Arg::Length(size) => visit(&mut size.value),
                Arg::Word(_) => {}
            }),
            Step::SetAttr(_, value, _) | Step::SetShape(_, value, _) => visit(value),
            Step::Rust(_, args, _) => args.iter_mut().for_each(&mut *visit),
            Step::Give(target) => target_exprs(target, visit),
            Step::Split(split) => {
                if let Measure::Texture(texture) = &mut split.measure {
                    visit(&mut texture.set);
                }
                split.sizes.iter_mut().for_each(|size| visit(&mut size.value));
                split.slots.iter_mut().for_each(|target| target_exprs(target, visit));
            }
            Step::Comp(comp) => {
                for arm in &mut comp.arms {
                    if let Selector::Index(asked) | Selector::When(asked) = &mut arm.selector {
                        visit(asked);
                    }
                    target_exprs(&mut arm.then, visit);
                }
            }
            Step::Push(steps) => exprs(steps, visit),
            Step::Anew(anew) => {
                anew.given.iter_mut().for_each(|(_, value)| visit(value));
                target_exprs(&mut anew.target, visit);
            }
            Step::Case { arms, otherwise } => {
                for (condition, steps) in arms {
                    visit(condition);
                    exprs(steps, visit);
                }
                exprs(otherwise, visit);
            }
            Step::Chance { arms, otherwise } => {
                arms.iter_mut().for_each(|(_, steps)| exprs(steps, visit));
                exprs(otherwise, visit);
            }
            Step::Later(..) => {}
        }
    }
}

fn target_exprs(target: &mut Target, visit: &mut dyn FnMut(&mut Expr)) {
    if let Target::Rule { args, .. } = target {
        args.iter_mut().for_each(visit);
    }
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
