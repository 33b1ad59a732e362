//! Over the steps and expressions of a grammar.

use crate::ir::{
    Arg, Arm, Block, BlockParts, Expr, ExprKind, Function, Grammar, Renew, Rule, Selector, Step, StepKind, Target,
};

macro_rules! step_walkers {
    ($($life:lifetime)?, $iter:ident, [$($mutable:tt)?], $(#[$about:meta])* $steps:ident, $targets:ident, $exprs:ident, $args:ident) => {
        /// Every step of a body, with the steps in brackets and branches.
        $(#[$about])*
        pub fn $steps$(<$life>)?(
            list: &$($life)? $($mutable)? [Step],
            visit: &mut dyn FnMut(&$($life)? $($mutable)? Step),
        ) {
            for step in list {
                visit(step);
                match & $($mutable)? step.kind {
                    StepKind::Push(inner) => $steps(inner, visit),
                    StepKind::Case { arms, otherwise } => {
                        arms.$iter().for_each(|(_, inner)| $steps(inner, visit));
                        $steps(otherwise, visit);
                    }
                    StepKind::Do(..)
                    | StepKind::SetAttr(..)
                    | StepKind::SetShape(..)
                    | StepKind::Rust(..)
                    | StepKind::Give(_)
                    | StepKind::Block(_)
                    | StepKind::Renew(_) => {}
                }
            }
        }

        /// The successors of a step.
        $(#[$about])*
        pub fn $targets(step: & $($mutable)? Step) -> Vec<& $($mutable)? Target> {
            match & $($mutable)? step.kind {
                StepKind::Give(target) | StepKind::Renew(Renew { target, .. }) => vec![target],
                StepKind::Block(Block { parts: BlockParts::Slots(slots), .. }) => slots.targets.$iter().collect(),
                StepKind::Block(Block { parts: BlockParts::Arms(arms), .. }) => {
                    arms.$iter().map(|arm| & $($mutable)? arm.then).collect()
                }
                StepKind::Block(Block { parts: BlockParts::Sections(parts), .. }) => {
                    let rest = parts.rest.$iter().map(|arm| & $($mutable)? arm.then);
                    parts.slots.targets.$iter().chain(rest).collect()
                }
                StepKind::Block(Block { parts: BlockParts::Each(target), .. }) => vec![target],
                StepKind::Block(Block { parts: BlockParts::Operands(targets), .. }) => targets.$iter().collect(),
                StepKind::Do(..)
                | StepKind::SetAttr(..)
                | StepKind::SetShape(..)
                | StepKind::Rust(..)
                | StepKind::Push(_)
                | StepKind::Case { .. } => Vec::new(),
            }
        }

        /// The expressions of a step itself, without the arguments of its successors.
        $(#[$about])*
        pub fn $exprs(step: & $($mutable)? Step) -> Vec<& $($mutable)? Expr> {
            match & $($mutable)? step.kind {
                StepKind::Do(_, args) => args.$iter().filter_map($args).collect(),
                StepKind::SetAttr(_, value) | StepKind::SetShape(_, value) => vec![value],
                StepKind::Rust(_, args) => args.$iter().collect(),
                StepKind::Renew(call) => call.given.$iter().map(|(_, value)| value).collect(),
                StepKind::Block(block) => {
                    let mut list: Vec<_> = block.args.$iter().filter_map($args).collect();
                    match & $($mutable)? block.parts {
                        BlockParts::Slots(slots) => list.extend(slots.sizes.$iter().map(|size| & $($mutable)? size.value)),
                        BlockParts::Arms(arms) => list.extend(arms.$iter().filter_map(|arm| match & $($mutable)? arm.selector {
                            Selector::Index(asked) | Selector::When(asked) => Some(asked),
                            Selector::Word(_) => None,
                        })),
                        BlockParts::Sections(parts) => {
                            list.extend(parts.slots.sizes.$iter().map(|size| & $($mutable)? size.value));
                            list.extend(& $($mutable)? parts.depths);
                        }
                        BlockParts::Each(_) | BlockParts::Operands(_) => {}
                    }
                    list
                }
                StepKind::Case { arms, .. } => arms.$iter().map(|(condition, _)| condition).collect(),
                StepKind::Give(_) | StepKind::Push(_) => Vec::new(),
            }
        }

        fn $args(arg: & $($mutable)? Arg) -> Option<& $($mutable)? Expr> {
            match arg {
                Arg::Value(value) => Some(value),
                Arg::Length(size) => Some(& $($mutable)? size.value),
                Arg::Word(_) => None,
            }
        }
    };
}

step_walkers!('g, iter, [], steps, targets, in_step, of_arg);
step_walkers!(, iter_mut, [mut], /// To change them.
    steps_mut, targets_mut, in_step_mut, of_arg_mut);

/// Every expression in a body, to change it, without its parts.
pub(crate) fn exprs_mut(list: &mut [Step], visit: &mut dyn FnMut(&mut Expr)) {
    steps_mut(list, &mut |step| {
        in_step_mut(step).into_iter().for_each(&mut *visit);
        for target in targets_mut(step) {
            if let Target::Rule { args, .. } = target {
                args.iter_mut().for_each(&mut *visit);
            }
        }
    });
}

/// The parameters that an expression reads, to change them.
pub(crate) fn params_mut(expr: &mut Expr, visit: &mut dyn FnMut(&mut u32)) {
    parts_mut(expr, &mut |part| {
        if let ExprKind::Param(index) = &mut part.kind {
            visit(index);
        }
    });
}

pub(crate) fn parts_mut(expr: &mut Expr, visit: &mut dyn FnMut(&mut Expr)) {
    visit(expr);
    for part in expr.parts_mut() {
        parts_mut(part, visit);
    }
}

/// By rule, the rules that its steps hand shapes to, each once, in order. Only steps that `from` accepts count.
pub fn calls(grammar: &Grammar, from: impl Fn(&Step) -> bool) -> Vec<Vec<usize>> {
    let called = |rule: &Rule| {
        let mut list = Vec::new();
        steps(&rule.body, &mut |step| {
            list.extend(targets(step).into_iter().filter_map(|target| match target {
                Target::Rule { rule, .. } if from(step) => Some(rule.0 as usize),
                Target::Rule { .. } | Target::Leaf(..) | Target::Nil => None,
            }));
        });
        list.sort_unstable();
        list.dedup();
        list
    };
    grammar.rules.iter().map(called).collect()
}

/// The functions that a function calls, by number, each as often as it does.
pub fn called_functions(function: &Function) -> Vec<usize> {
    let mut list = Vec::new();
    for value in function.locals.iter().chain([&function.body]) {
        parts(value, &mut |part| {
            if let ExprKind::Call(id, ..) = part.kind {
                list.push(id.0 as usize);
            }
        });
    }
    list
}

/// Every expression of a grammar, with its parts.
pub fn exprs<'g>(grammar: &'g Grammar, visit: &mut dyn FnMut(&'g Expr)) {
    grammar.globals.iter().for_each(|it| parts(&it.value, visit));
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
            | ExprKind::Global(_)
            | ExprKind::Host(_)
            | ExprKind::Shape(_)
            | ExprKind::Word(_)
            | ExprKind::Style(_)
            | ExprKind::Site(_)
            | ExprKind::Chance { .. } => Vec::new(),
            ExprKind::Call(_, _, args) | ExprKind::Builtin(_, args) | ExprKind::Rust(_, args) => args.$iter().collect(),
            ExprKind::Neg(a)
            | ExprKind::Not(a)
            | ExprKind::ToText(a)
            | ExprKind::File(a, _)
            | ExprKind::EachUnary(_, a) => {
                vec![&$($mutable)? **a]
            }
            ExprKind::Binary(_, a, b) | ExprKind::Each(_, a, b) => vec![&$($mutable)? **a, &$($mutable)? **b],
            ExprKind::Chain(first, links) => {
                [&$($mutable)? **first].into_iter().chain(links.$iter().map(|(_, operand)| operand)).collect()
            }
            ExprKind::Array(rows) => rows.$iter().flatten().collect(),
            ExprKind::Comp(comp) => {
                let parts = comp.arms.$iter().flat_map(|Arm { selector, then, .. }| match selector {
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
        }
    };
}

impl Expr {
    /// The expressions it is made of, in the order of evaluation.
    pub fn parts(&self) -> Vec<&Expr> {
        parts!(&self.kind, iter,)
    }

    /// The parts, mutably.
    pub(crate) fn parts_mut(&mut self) -> Vec<&mut Expr> {
        parts!(&mut self.kind, iter_mut, mut)
    }
}
