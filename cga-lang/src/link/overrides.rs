//! Dynamic calls that replace rules: each needs an instance of its own.

use crate::ast::{Ast, Block, BlockPart, Body, Decl, Name, Op, OpKind, Override, SplitItem};

/// Calls `id( Rule --> … ).Name` in a tree, with the import's name.
pub(crate) fn dynamic_calls(ast: &Ast) -> Vec<(Name, Vec<Override>)> {
    let mut found = Vec::new();
    ast.decls.iter().for_each(|decl| rule(decl, &mut found));
    ast.imports.iter().flat_map(|import| &import.overrides).for_each(|list| rules(list, &mut found));
    found
}

/// The rules that overrides put in the place of others are bodies too.
fn rules(list: &[Override], found: &mut Vec<(Name, Vec<Override>)>) {
    for own in list {
        if let Override::Rule(decl) = own {
            rule(decl, found);
        }
    }
}

fn rule(decl: &Decl, found: &mut Vec<(Name, Vec<Override>)>) {
    if let Body::Rule(body) = &decl.body {
        ops(body, found);
    }
}

fn ops(list: &[Op], found: &mut Vec<(Name, Vec<Override>)>) {
    for op in list {
        match &op.kind {
            OpKind::Dynamic { import, overrides, .. } => {
                if overrides.iter().any(|own| matches!(own, Override::Rule(_))) {
                    found.push((import.clone(), overrides.clone()));
                    rules(overrides, found);
                }
            }
            OpKind::Push(inner) => ops(inner, found),
            OpKind::Split(split) => items(&split.items, found),
            OpKind::Comp(comp) => comp.arms.iter().for_each(|arm| ops(&arm.ops, found)),
            OpKind::Block(own) => block(own, found),
            OpKind::Case(arms, otherwise) => {
                arms.iter().for_each(|(_, inner)| ops(inner, found));
                ops(otherwise, found);
            }
            OpKind::Chance(arms, otherwise) => {
                arms.iter().for_each(|(_, inner)| ops(inner, found));
                ops(otherwise, found);
            }
            OpKind::Call(..) | OpKind::Leaf(_) | OpKind::Nil | OpKind::Path(..) | OpKind::Error => {}
        }
    }
}

fn items(list: &[SplitItem], found: &mut Vec<(Name, Vec<Override>)>) {
    for item in list {
        match item {
            SplitItem::Slot(_, inner) => ops(inner, found),
            SplitItem::Group(inner, _) => items(inner, found),
        }
    }
}

fn block(block: &Block, found: &mut Vec<(Name, Vec<Override>)>) {
    for part in &block.parts {
        match part {
            BlockPart::Slots(list, _) => items(list, found),
            BlockPart::Sections(list, _) => list.iter().for_each(|section| ops(&section.ops, found)),
            BlockPart::Arms(arms) => arms.iter().for_each(|arm| ops(&arm.ops, found)),
            BlockPart::Ops(list) => list.iter().for_each(|inner| ops(inner, found)),
        }
    }
}
