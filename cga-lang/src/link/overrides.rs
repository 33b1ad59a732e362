//! Dynamic calls that replace rules. Each needs its own instance.

use crate::syntax::ast::{Ast, Body, Decl, Name, OpKind, Override};
use crate::syntax::walk;

/// Returns the calls `id( Rule --> … ).Name` in a tree, with the name of the import.
pub(super) fn dynamic_calls(ast: &Ast) -> Vec<(Name, Vec<Override>)> {
    let mut found = Vec::new();
    ast.decls.iter().for_each(|decl| rule(decl, &mut found));
    ast.imports.iter().flat_map(|import| &import.overrides).for_each(|list| rules(list, &mut found));
    found
}

/// Collects the calls in the bodies of overriding rules.
fn rules(list: &[Override], found: &mut Vec<(Name, Vec<Override>)>) {
    for own in list {
        if let Override::Rule(decl) = own {
            rule(decl, found);
        }
    }
}

fn rule(decl: &Decl, found: &mut Vec<(Name, Vec<Override>)>) {
    let Body::Rule(body) = &decl.body else { return };
    for op in walk::ops(body) {
        if let OpKind::Dynamic { import, overrides, .. } = &op.kind
            && overrides.iter().any(|own| matches!(own, Override::Rule(_)))
        {
            found.push((import.clone(), overrides.clone()));
            rules(overrides, found);
        }
    }
}
