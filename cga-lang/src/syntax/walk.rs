//! The parts of expressions and operations of a tree.

use crate::syntax::ast::{BlockPart, Expr, ExprKind, Op, OpKind, SplitItem};

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

impl Op {
    /// The sequences of operations inside it, in writing order.
    pub fn bodies(&self) -> Vec<&[Op]> {
        let mut list = Vec::new();
        match &self.kind {
            OpKind::Push(inner) => list.push(inner.as_slice()),
            OpKind::Block(block) => {
                for part in &block.parts {
                    match part {
                        BlockPart::Slots(items, _) => slots(items, &mut list),
                        BlockPart::Sections(all, _) => list.extend(all.iter().map(|section| section.ops.as_slice())),
                        BlockPart::Arms(arms) => list.extend(arms.iter().map(|arm| arm.ops.as_slice())),
                        BlockPart::Ops(sides) => list.extend(sides.iter().map(Vec::as_slice)),
                    }
                }
            }
            OpKind::Case(arms, otherwise) => {
                list.extend(arms.iter().map(|(_, inner)| inner.as_slice()).chain([otherwise.as_slice()]));
            }
            OpKind::Chance(arms, otherwise) => {
                list.extend(arms.iter().map(|(_, inner)| inner.as_slice()).chain([otherwise.as_slice()]));
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
}

fn slots<'a>(items: &'a [SplitItem], list: &mut Vec<&'a [Op]>) {
    for item in items {
        match item {
            SplitItem::Slot(_, inner) => list.push(inner),
            SplitItem::Group(inner, _) => slots(inner, list),
        }
    }
}

/// Every operation of a sequence, each before those inside it.
pub fn ops<'a>(list: &'a [Op], visit: &mut dyn FnMut(&'a Op)) {
    for op in list {
        visit(op);
        op.bodies().into_iter().for_each(|inner| ops(inner, visit));
    }
}
