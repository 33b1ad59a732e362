//! The size of a file.

use cga_lang::syntax::ast::{Ast, BlockPart, Body, OpKind};
use cga_lang::syntax::walk;

/// The numbers of rules, splits and comps in a file.
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
            for op in walk::ops(ops) {
                let OpKind::Block(block) = &op.kind else { continue };
                match block.parts.first() {
                    Some(BlockPart::Slots(..)) => counts.splits += 1,
                    Some(BlockPart::Arms(_)) => counts.comps += 1,
                    _ => {}
                }
            }
        }
    }
    counts
}
