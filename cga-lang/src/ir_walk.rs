//! Over the steps and expressions of a grammar.

use crate::ir::{Anew, Arg, CompArm, Expr, ExprKind, Grammar, Measure, Rule, RuleId, Selector, Step, Target};

/// Every step of a body, those in brackets and branches included.
pub fn steps<'g>(list: &'g [Step], visit: &mut dyn FnMut(&'g Step)) {
    for step in list {
        visit(step);
        match step {
            Step::Push(inner) => steps(inner, visit),
            Step::Case { arms, otherwise } => {
                arms.iter().for_each(|(_, inner)| steps(inner, visit));
                steps(otherwise, visit);
            }
            Step::Chance { arms, otherwise } => {
                arms.iter().for_each(|(_, inner)| steps(inner, visit));
                steps(otherwise, visit);
            }
            _ => {}
        }
    }
}

/// The rules that a body calls, each once, in the order of their numbers.
pub fn called(body: &[Step]) -> Vec<RuleId> {
    let mut list = Vec::new();
    steps(body, &mut |step| {
        list.extend(targets(step).into_iter().filter_map(|target| match target {
            Target::Rule { rule, .. } => Some(*rule),
            Target::Leaf(..) | Target::Nil => None,
        }));
    });
    list.sort_unstable();
    list.dedup();
    list
}

/// Every expression of a grammar, with its parts.
pub fn exprs<'g>(grammar: &'g Grammar, visit: &mut dyn FnMut(&'g Expr)) {
    grammar.attrs.iter().for_each(|attr| parts(&attr.default, visit));
    grammar.consts.iter().for_each(|it| parts(&it.value, visit));
    for function in &grammar.functions {
        function.locals.iter().for_each(|local| parts(local, visit));
        parts(&function.body, visit);
    }
    grammar.rules.iter().for_each(|rule| in_rule(rule, visit));
}

/// Every expression of a rule, with its parts.
pub fn in_rule<'g>(rule: &'g Rule, visit: &mut dyn FnMut(&'g Expr)) {
    rule.locals.iter().for_each(|local| parts(local, visit));
    steps(&rule.body, &mut |step| {
        in_step(step).into_iter().for_each(|expr| parts(expr, visit));
        for target in targets(step) {
            if let Target::Rule { args, .. } = target {
                args.iter().for_each(|arg| parts(arg, visit));
            }
        }
    });
}

macro_rules! of_steps {
    ($targets:ident, $in_step:ident, $iter:ident $(, $mutable:tt)?) => {
        /// The targets that a step hands shapes to.
        pub fn $targets(step: &$($mutable)? Step) -> Vec<&$($mutable)? Target> {
            match step {
                Step::Give(target) | Step::Anew(Anew { target, .. }) => vec![target],
                Step::Split(split) => split.slots.$iter().collect(),
                Step::Comp(comp) => comp.arms.$iter().map(|arm| &$($mutable)? arm.then).collect(),
                _ => Vec::new(),
            }
        }

        /// The expressions of a step itself, without those of its targets and of the steps in it.
        pub fn $in_step(step: &$($mutable)? Step) -> Vec<&$($mutable)? Expr> {
            match step {
                Step::Do(_, args, _) => args
                    .$iter()
                    .filter_map(|arg| match arg {
                        Arg::Value(value) => Some(value),
                        Arg::Length(size) => Some(&$($mutable)? size.value),
                        Arg::Word(_) => None,
                    })
                    .collect(),
                Step::SetAttr(_, value, _) | Step::SetShape(_, value, _) => vec![value],
                Step::Rust(_, args, _) => args.$iter().collect(),
                Step::Anew(anew) => anew.given.$iter().map(|(_, value)| value).collect(),
                Step::Split(split) => {
                    let set = match &$($mutable)? split.measure {
                        Measure::Texture(texture) => Some(&$($mutable)? texture.set),
                        Measure::Length | Measure::Area => None,
                    };
                    set.into_iter().chain(split.sizes.$iter().map(|size| &$($mutable)? size.value)).collect()
                }
                Step::Comp(comp) => comp
                    .arms
                    .$iter()
                    .filter_map(|arm| match &$($mutable)? arm.selector {
                        Selector::Index(asked) | Selector::When(asked) => Some(asked),
                        Selector::Word(_) => None,
                    })
                    .collect(),
                Step::Case { arms, .. } => arms.$iter().map(|(condition, _)| condition).collect(),
                Step::Give(_) | Step::Push(_) | Step::Chance { .. } | Step::Later(..) => Vec::new(),
            }
        }
    };
}

of_steps!(targets, in_step, iter);
of_steps!(targets_mut, in_step_mut, iter_mut, mut);

/// An expression and its parts.
pub fn parts<'g>(expr: &'g Expr, visit: &mut dyn FnMut(&'g Expr)) {
    visit(expr);
    for part in expr.parts() {
        parts(part, visit);
    }
}

macro_rules! parts {
    ($kind:expr, $iter:ident, $($mutable:tt)?) => {
        match $kind {
            ExprKind::Value(_)
            | ExprKind::Param(_)
            | ExprKind::Attr(_)
            | ExprKind::Const(_)
            | ExprKind::Host(_)
            | ExprKind::Shape(_)
            | ExprKind::Word(_)
            | ExprKind::Style(_)
            | ExprKind::Later(_) => Vec::new(),
            ExprKind::Call(_, args) | ExprKind::Builtin(_, args) | ExprKind::Rust(_, args) => args.$iter().collect(),
            ExprKind::Neg(a)
            | ExprKind::Not(a)
            | ExprKind::ToText(a)
            | ExprKind::File(a, _)
            | ExprKind::EachUnary(_, a) => {
                vec![&$($mutable)? **a]
            }
            ExprKind::Binary(_, a, b) | ExprKind::Each(_, a, b) => vec![&$($mutable)? **a, &$($mutable)? **b],
            ExprKind::Array(rows) => rows.$iter().flatten().collect(),
            ExprKind::Comp(comp) => {
                let parts = comp.arms.$iter().flat_map(|CompArm { selector, then, .. }| match selector {
                    Selector::Index(asked) | Selector::When(asked) => vec![asked, then],
                    Selector::Word(_) => vec![then],
                });
                parts.collect()
            }
            ExprKind::Range(base, step, limit) => {
                vec![&$($mutable)? **base, &$($mutable)? **step, &$($mutable)? **limit]
            }
            ExprKind::Index(array, indices) => [&$($mutable)? **array].into_iter().chain(indices.$iter()).collect(),
            ExprKind::Case(arms, otherwise) => {
                let arms = arms.$iter().flat_map(|(condition, value)| [condition, value]);
                arms.chain([&$($mutable)? **otherwise]).collect()
            }
            ExprKind::Chance(arms, otherwise) => {
                arms.$iter().map(|(_, value)| value).chain([&$($mutable)? **otherwise]).collect()
            }
        }
    };
}

impl Expr {
    /// The expressions it is made of, in the order of evaluation.
    pub fn parts(&self) -> Vec<&Expr> {
        parts!(&self.kind, iter,)
    }

    /// The same, to change them.
    pub(crate) fn parts_mut(&mut self) -> Vec<&mut Expr> {
        parts!(&mut self.kind, iter_mut, mut)
    }
}
