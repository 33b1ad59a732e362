//! Over the expressions of a rule's body, to change them. Who only looks uses `ir_walk`.

use crate::ir::{Arg, Expr, ExprKind, Selector, Step, Target};

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
                split.sizes.iter_mut().for_each(|size| visit(&mut size.value));
                split.slots.iter_mut().for_each(|target| target_exprs(target, visit));
            }
            Step::Comp(comp) => {
                for arm in &mut comp.arms {
                    if let Selector::Index(index) = &mut arm.selector {
                        visit(index);
                    }
                    target_exprs(&mut arm.target, visit);
                }
            }
            Step::Push(steps) => exprs(steps, visit),
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
            Step::Nil(_) => {}
        }
    }
}

fn target_exprs(target: &mut Target, visit: &mut dyn FnMut(&mut Expr)) {
    if let Target::Rule { args, .. } = target {
        args.iter_mut().for_each(visit);
    }
}

/// The parameters an expression reads.
pub(super) fn params(expr: &mut Expr, visit: &mut dyn FnMut(&mut u32)) {
    match &mut expr.kind {
        ExprKind::Param(index) => visit(index),
        ExprKind::Call(_, args) | ExprKind::Builtin(_, args) | ExprKind::Rust(_, args) => {
            args.iter_mut().for_each(|arg| params(arg, visit));
        }
        ExprKind::Neg(a) | ExprKind::Not(a) | ExprKind::ToText(a) => params(a, visit),
        ExprKind::Binary(_, a, b) => {
            params(a, visit);
            params(b, visit);
        }
        ExprKind::Case(arms, otherwise) => {
            for (condition, value) in arms {
                params(condition, visit);
                params(value, visit);
            }
            params(otherwise, visit);
        }
        ExprKind::Chance(arms, otherwise) => {
            arms.iter_mut().for_each(|(_, value)| params(value, visit));
            params(otherwise, visit);
        }
        ExprKind::Value(_) | ExprKind::Attr(_) | ExprKind::Const(_) | ExprKind::Host(_) | ExprKind::Shape(_) => {}
    }
}
