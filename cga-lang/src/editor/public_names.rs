//! The public names of a grammar, known even if it has errors. The rest of a program can use these.

use crate::ir::{Global, Grammar, Type, Value};
use crate::link::Program;
use crate::ops::{functions, shape_attr};
use crate::resolve::globals::Declared;
use crate::span::Span;
use crate::syntax::ast::{Ast, Body, Expr, ExprKind, Unary};
use std::collections::{HashMap, HashSet};

/// An attribute of a grammar that may have errors.
#[derive(Clone, Debug)]
pub struct PublicName {
    /// The name as written.
    pub name: String,
    /// Its type, if known.
    pub ty: Option<Type>,
    /// The default. Without errors it is the default in [`Global`], otherwise it is only known for a literal.
    pub known: Option<Value>,
    /// True if the default is computed for each initial shape. With errors this is an estimate.
    pub computed: bool,
    /// The name in its declaration.
    pub span: Span,
}

/// The attributes, in source order, each name once.
pub(crate) fn public_names(
    program: &Program,
    attrs: &[(Declared, Option<Type>)],
    grammar: Option<&Grammar>,
) -> Vec<PublicName> {
    let mut list: Vec<PublicName> = Vec::new();
    let mut seen = HashSet::new();
    let lowered = grammar.iter().flat_map(|grammar| grammar.globals.iter().rev());
    let lowered: HashMap<&str, &Global> =
        lowered.filter(|global| global.attr.is_some()).map(|attr| (attr.name.as_str(), attr)).collect();
    for (item, ty) in attrs {
        if !seen.insert(item.name.as_str()) {
            continue;
        }
        let lowered = lowered.get(item.name.as_str());
        let own = item.decl.value().filter(|_| item.is_own());
        let known = match lowered {
            Some(attr) => attr.known.clone(),
            None => own.and_then(literal),
        };
        let computed = match lowered {
            Some(_) => known.is_none(),
            None => own.is_none_or(|value| computed(value, &program.instances[item.home].file.ast, 0)),
        };
        list.push(PublicName { name: item.name.clone(), ty: *ty, known, computed, span: item.decl.name.span });
    }
    list
}

/// Returns true if a value depends on more than constants, according to the tree alone.
fn computed(value: &Expr, ast: &Ast, depth: u32) -> bool {
    let part = |value: &Expr| computed(value, ast, depth);
    match &value.kind {
        ExprKind::Number(_) | ExprKind::Bool(_) | ExprKind::Text(_) | ExprKind::Error => false,
        ExprKind::Name(name) => {
            let decl = ast.decls.iter().find(|decl| decl.name.text == name.text && decl.value().is_some());
            match decl {
                Some(decl) if matches!(decl.body, Body::Attr(_)) || DEEPEST < depth => true,
                Some(decl) => decl.value().is_some_and(|value| computed(value, ast, depth + 1)),
                // An unknown name has its own diagnostic; the remaining names are attributes of the shape and random
                // draws.
                None => shape_attr(&name.text).is_some() || functions(&name.text).any(|row| !row.pure),
            }
        }
        ExprKind::Call(name, args) => !functions(&name.text).any(|row| row.pure) || args.iter().any(part),
        ExprKind::Host(_) | ExprKind::Path(..) | ExprKind::Chance(..) => true,
        _ => value.parts().into_iter().any(part),
    }
}

/// The maximum depth to which constants are followed.
const DEEPEST: u32 = 32;

fn literal(value: &Expr) -> Option<Value> {
    match &value.kind {
        ExprKind::Number(value) => Some(Value::Float(*value)),
        ExprKind::Bool(value) => Some(Value::Bool(*value)),
        ExprKind::Text(text) => Some(Value::Text(text.clone())),
        ExprKind::Unary(Unary::Minus, inner) => match literal(inner)? {
            Value::Float(value) => Some(Value::Float(-value)),
            _ => None,
        },
        _ => None,
    }
}
