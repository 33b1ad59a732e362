//! Dynamic calls that replace rules: each needs an instance of its own.

use crate::syntax::ast::{Ast, Body, Decl, Name, OpKind, Override};
use crate::syntax::walk;

/// Calls `id( Rule --> … ).Name` in a tree, with the import's name.
pub(super) fn dynamic_calls(ast: &Ast) -> Vec<(Name, Vec<Override>)> {
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
    let Body::Rule(body) = &decl.body else { return };
    walk::ops(body, &mut |op| {
        if let OpKind::Dynamic { import, overrides, .. } = &op.kind
            && overrides.iter().any(|own| matches!(own, Override::Rule(_)))
        {
            found.push((import.clone(), overrides.clone()));
            rules(overrides, found);
        }
    });
}
