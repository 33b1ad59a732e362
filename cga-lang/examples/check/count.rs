//! How much a file does.

use cga_lang::ast::{Ast, BlockPart, Body, Op, OpKind, SplitItem};

/// Numbers of what stands in a file.
#[derive(Clone, Copy, Default)]
pub(crate) struct Counts {
    pub(crate) rules: usize,
    pub(crate) splits: usize,
    pub(crate) comps: usize,
}

pub(crate) fn count(ast: &Ast) -> Counts {
    let mut counts = Counts::default();
    for decl in &ast.decls {
        if let Body::Rule(ops) = &decl.body {
            counts.rules += 1;
            counts.ops(ops);
        }
    }
    counts
}

impl Counts {
    fn ops(&mut self, list: &[Op]) {
        for op in list {
            match &op.kind {
                OpKind::Split(split) => {
                    self.splits += 1;
                    self.items(&split.items);
                }
                OpKind::Comp(comp) => {
                    self.comps += 1;
                    comp.arms.iter().for_each(|arm| self.ops(&arm.ops));
                }
                OpKind::Block(block) => block.parts.iter().for_each(|part| self.part(part)),
                OpKind::Push(inner) => self.ops(inner),
                OpKind::Case(arms, otherwise) => {
                    arms.iter().for_each(|(_, inner)| self.ops(inner));
                    self.ops(otherwise);
                }
                OpKind::Chance(arms, otherwise) => {
                    arms.iter().for_each(|(_, inner)| self.ops(inner));
                    self.ops(otherwise);
                }
                _ => {}
            }
        }
    }

    fn items(&mut self, list: &[SplitItem]) {
        for item in list {
            match item {
                SplitItem::Slot(_, inner) => self.ops(inner),
                SplitItem::Group(inner, _) => self.items(inner),
            }
        }
    }

    fn part(&mut self, part: &BlockPart) {
        match part {
            BlockPart::Slots(list, _) => self.items(list),
            BlockPart::Sections(list, _) => list.iter().for_each(|section| self.ops(&section.ops)),
            BlockPart::Arms(arms) => arms.iter().for_each(|arm| self.ops(&arm.ops)),
            BlockPart::Ops(list) => list.iter().for_each(|inner| self.ops(inner)),
        }
    }
}
