//! The parts of expressions and operations of a tree.

use crate::syntax::ast::{Arg, Arm, BlockPart, Expr, ExprKind, Op, OpKind, Section, SplitItem};

impl Expr {
    /// The expressions it is made of, in the order of evaluation.
    pub fn parts(&self) -> Vec<&Expr> {
        match &self.kind {
            ExprKind::Number(_)
            | ExprKind::Bool(_)
            | ExprKind::Text(_)
            | ExprKind::Name(_)
            | ExprKind::Host(_)
            | ExprKind::Error => Vec::new(),
            ExprKind::Call(_, args) | ExprKind::Path(_, args) => args.iter().collect(),
            ExprKind::Unary(_, a) | ExprKind::EachUnary(_, a) => vec![a],
            ExprKind::Binary(_, _, a, b) | ExprKind::Each(_, _, a, b) => vec![a, b],
            ExprKind::Chain(first, links) => {
                [&**first].into_iter().chain(links.iter().map(|link| &link.operand)).collect()
            }
            ExprKind::Case(arms, otherwise) => {
                let arms = arms.iter().flat_map(|(condition, value)| [condition, value]);
                arms.chain([&**otherwise]).collect()
            }
            ExprKind::Chance(arms, otherwise) => arms.iter().map(|(_, value)| value).chain([&**otherwise]).collect(),
            ExprKind::Array(rows) => rows.iter().flatten().collect(),
            ExprKind::Range(base, step, limit) => {
                [Some(base), step.as_ref(), Some(limit)].into_iter().flatten().map(|part| &**part).collect()
            }
            ExprKind::Index(array, indices) => [&**array].into_iter().chain(indices).collect(),
            ExprKind::Comp(comp) => {
                let arms = comp.arms.iter().flat_map(|(selector, _, value)| [selector, value]);
                comp.args.iter().chain(arms).collect()
            }
        }
    }
}

/// A part of an operation.
pub enum OpPart<'a> {
    /// The size of a slot.
    Size(&'a Arg),
    /// The length of a section.
    Length(&'a Arg),
    /// The depth of a section.
    Depth(&'a Expr),
    /// The condition of a branch.
    Condition(&'a Expr),
    /// An arm, whose operations are the next part.
    Arm(&'a Arm),
    /// A sequence of operations.
    Ops(&'a [Op]),
}

impl Op {
    /// The expressions and operations inside it, without its arguments, in writing order.
    pub fn parts(&self) -> Vec<OpPart<'_>> {
        let mut list = Vec::new();
        match &self.kind {
            OpKind::Push(inner) => list.push(OpPart::Ops(inner)),
            OpKind::Block(block) => block.parts.iter().for_each(|part| match part {
                BlockPart::Slots(items, _) => slots(items, &mut list),
                BlockPart::Sections(all, _) => list.extend(all.iter().flat_map(|Section { length, depth, ops }| {
                    [OpPart::Length(length), OpPart::Depth(depth), OpPart::Ops(ops)]
                })),
                BlockPart::Arms(arms) => {
                    list.extend(arms.iter().flat_map(|arm| [OpPart::Arm(arm), OpPart::Ops(&arm.ops)]))
                }
                BlockPart::Ops(sides) => list.extend(sides.iter().map(|ops| OpPart::Ops(ops))),
            }),
            OpKind::Case(arms, otherwise) => {
                list.extend(arms.iter().flat_map(|(condition, ops)| [OpPart::Condition(condition), OpPart::Ops(ops)]));
                list.push(OpPart::Ops(otherwise));
            }
            OpKind::Chance(arms, otherwise) => {
                list.extend(arms.iter().map(|(_, ops)| ops).chain([otherwise]).map(|ops| OpPart::Ops(ops)));
            }
            OpKind::Call(..)
            | OpKind::Dynamic { .. }
            | OpKind::Leaf(_)
            | OpKind::Nil
            | OpKind::Path(..)
            | OpKind::Error => {}
        }
        list
    }

    /// The sequences of operations inside it, in writing order.
    pub fn bodies(&self) -> impl DoubleEndedIterator<Item = &[Op]> {
        self.parts().into_iter().filter_map(|part| if let OpPart::Ops(ops) = part { Some(ops) } else { None })
    }
}

fn slots<'a>(items: &'a [SplitItem], list: &mut Vec<OpPart<'a>>) {
    for item in items {
        match item {
            SplitItem::Slot(size, ops) => list.extend([OpPart::Size(size), OpPart::Ops(ops)]),
            SplitItem::Group(inner, _) => slots(inner, list),
        }
    }
}

/// Every operation of a sequence, each before those inside it.
pub fn ops(list: &[Op]) -> impl Iterator<Item = &Op> {
    let mut open = vec![list.iter()];
    std::iter::from_fn(move || {
        while let Some(list) = open.last_mut() {
            if let Some(op) = list.next() {
                open.extend(op.bodies().rev().map(<[Op]>::iter));
                return Some(op);
            }
            open.pop();
        }
        None
    })
}
