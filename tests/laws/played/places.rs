//! Where what rules print stands among what findings are about.

use crate::played::write::FIRST_MARK;
use cga_lang::span::Span;
use cga_lang::syntax::ast::{Arg, Ast, Binary, Block, BlockPart, Body, Expr, ExprKind, Op, OpKind, Prefix, SplitItem};
use cga_lang::syntax::walk::ops;
use std::ops::Range;

/// The places of a grammar, each with the numbers that a run prints when it comes by.
#[derive(Default)]
pub(crate) struct Places {
    pub(crate) branches: Vec<Branch>,
    pub(crate) splits: Vec<Divided>,
    pub(crate) arms: Vec<Arm>,
    pub(crate) rules: Vec<Rule>,
    pub(crate) quotients: Vec<(Span, u32)>,
}

/// A condition.
pub(crate) struct Branch {
    pub(crate) condition: Span,
    /// The marks that are printed where it is true.
    pub(crate) then: Vec<u32>,
    /// The marks that are printed where it is false.
    pub(crate) otherwise: Vec<u32>,
}

/// A split.
pub(crate) struct Divided {
    pub(crate) number: u32,
    /// The rule that contains the split.
    pub(crate) rule: String,
    pub(crate) axis: Span,
    pub(crate) slots: Vec<Slot>,
    /// The slots of groups with `*`, from outside in.
    pub(crate) groups: Vec<Range<usize>>,
}

/// A slot of a split.
pub(crate) struct Slot {
    pub(crate) number: u32,
    pub(crate) size: Span,
    pub(crate) prefix: Option<Prefix>,
}

/// An arm of a comp.
pub(crate) struct Arm {
    pub(crate) selector: Span,
    pub(crate) own: Vec<u32>,
    /// The marks that are printed in all arms of the comp.
    pub(crate) all: Vec<u32>,
}

/// A rule.
pub(crate) struct Rule {
    pub(crate) name: Span,
    pub(crate) text: String,
    pub(crate) marks: Vec<u32>,
}

impl Places {
    pub(crate) fn new(ast: &Ast) -> Places {
        let mut places = Places::default();
        for decl in &ast.decls {
            match &decl.body {
                Body::Function(value) => places.value(value),
                Body::Rule(list) => {
                    let (name, text) = (decl.name.span, decl.name.text.clone());
                    places.rules.push(Rule { name, text, marks: marks(list) });
                    let first = places.splits.len();
                    places.steps(list);
                    places.splits[first..].iter_mut().for_each(|split| split.rule.clone_from(&decl.name.text));
                }
                _ => {}
            }
        }
        places
    }

    fn steps(&mut self, list: &[Op]) {
        let mut seen = None;
        for op in list {
            match &op.kind {
                OpKind::Call(name, args) if name.text == "set" => seen = args.get(1).and_then(|arg| number(&arg.value)),
                OpKind::Call(name, args) if name.text == "print" => args.iter().for_each(|arg| self.value(&arg.value)),
                OpKind::Case(arms, otherwise) => {
                    let bodies = arms.iter().map(|(_, ops)| marks(ops)).chain([marks(otherwise)]).collect();
                    self.branches(arms.iter().map(|(condition, _)| condition.span), bodies);
                }
                OpKind::Block(block) => match block.parts.as_slice() {
                    [BlockPart::Slots(items, star)] => {
                        let number = seen.take();
                        self.splits.extend(number.map(|number| Divided::new(block, (items, *star), number)));
                    }
                    [BlockPart::Arms(arms)] => {
                        let all: Vec<u32> = arms.iter().flat_map(|arm| marks(&arm.ops)).collect();
                        for arm in arms {
                            let (selector, own) = (arm.selector.span, marks(&arm.ops));
                            self.arms.push(Arm { selector, own, all: all.clone() });
                        }
                    }
                    _ => {}
                },
                _ => {}
            }
            op.bodies().for_each(|inner| self.steps(inner));
        }
    }

    /// Conditions and quotients in what is printed.
    fn value(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Case(arms, otherwise) => {
                let values = || arms.iter().map(|(_, value)| value).chain([&**otherwise]);
                let bodies: Vec<Vec<u32>> = values().map(numbers).collect();
                // Others decide about numbers alone.
                if bodies.iter().all(|body| !body.is_empty()) {
                    self.branches(arms.iter().map(|(condition, _)| condition.span), bodies);
                    values().for_each(|value| self.value(value));
                }
            }
            ExprKind::Call(name, args) if name.text == "quotient" => {
                if let [_, Expr { kind: ExprKind::Binary(Binary::Div | Binary::Rem, _, _, divisor), .. }] = &args[..] {
                    self.quotients.extend(number(expr).map(|number| (divisor.span, number)));
                }
            }
            _ => {}
        }
    }

    /// Conditions, and what is printed behind each, and where none holds.
    fn branches(&mut self, conditions: impl Iterator<Item = Span>, bodies: Vec<Vec<u32>>) {
        for (index, condition) in conditions.enumerate() {
            let (then, otherwise) = (bodies[index].clone(), bodies[index + 1..].concat());
            self.branches.push(Branch { condition, then, otherwise });
        }
    }
}

impl Divided {
    fn new(split: &Block, (items, star): (&[SplitItem], bool), number: u32) -> Divided {
        let axis = split.args.first().map_or(split.name.span, |arg| arg.span);
        let mut divided = Divided { number, rule: String::new(), axis, slots: Vec::new(), groups: Vec::new() };
        divided.items(items, star);
        divided
    }

    fn items(&mut self, items: &[SplitItem], star: bool) {
        let (first, group) = (self.slots.len(), self.groups.len());
        if star {
            self.groups.push(first..first);
        }
        for item in items {
            match item {
                SplitItem::Slot(Arg { prefix, span, .. }, inner) => {
                    let number = inner.first().and_then(printed).expect("a piece says that it is there");
                    self.slots.push(Slot { number, size: *span, prefix: prefix.map(|(prefix, _)| prefix) });
                }
                SplitItem::Group(inner, star) => self.items(inner, *star),
            }
        }
        if star {
            self.groups[group] = first..self.slots.len();
        }
    }
}

/// The marks that steps print.
fn marks(list: &[Op]) -> Vec<u32> {
    let mut found = Vec::new();
    for op in ops(list) {
        if let OpKind::Call(name, args) = &op.kind
            && name.text == "print"
        {
            args.iter().for_each(|arg| found.extend(numbers(&arg.value)));
        }
    }
    found
}

/// The number that a step prints.
fn printed(op: &Op) -> Option<u32> {
    match &op.kind {
        OpKind::Call(name, args) if name.text == "print" => number(&args.first()?.value),
        _ => None,
    }
}

/// The places that a value may stand for.
fn numbers(expr: &Expr) -> Vec<u32> {
    match &expr.kind {
        ExprKind::Case(arms, otherwise) => {
            arms.iter().map(|(_, value)| value).chain([&**otherwise]).flat_map(numbers).collect()
        }
        _ => number(expr).into_iter().collect(),
    }
}

/// The place that a value stands for.
fn number(expr: &Expr) -> Option<u32> {
    match &expr.kind {
        ExprKind::Number(number) if f64::from(FIRST_MARK) <= *number => Some(*number as u32),
        ExprKind::Call(name, args) if ["seen", "piece", "quotient"].contains(&name.text.as_str()) => {
            number(args.first()?)
        }
        ExprKind::Binary(Binary::Add, _, left, _) => number(left),
        _ => None,
    }
}
