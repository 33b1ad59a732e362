//! The whole way from tokens to a grammar, in one call.

use crate::ast::{Ast, Body, Decl, Expr, ExprKind, Unary};
use crate::check::check;
use crate::code::Code;
use crate::diag::{Diag, Diags, Level};
use crate::ir::{Grammar, Type, Value};
use crate::lex::lex;
use crate::lower::lower;
use crate::ops::{functions, shape_attr};
use crate::parse::parse;
use crate::span::Span;
use crate::token::Tokens;
use std::collections::HashSet;
use std::ops::Range;

/// How strict to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Door {
    /// Rules among Rust: a call without a rule is an error.
    Inline,
    /// CGA text: a call without a rule is a leaf and a warning, as CGA documents.
    Text,
}

/// What became of some tokens.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The grammar; `None` when there was an error.
    pub grammar: Option<Grammar>,
    /// Every finding, in source order.
    pub diags: Vec<Diag>,
    /// The public names, errors or not.
    pub names: Skeleton,
}

/// The public names of a grammar, known even when it has errors.
#[derive(Clone, Debug, Default)]
pub struct Skeleton {
    /// Attributes, in source order, each name once.
    pub attrs: Vec<SkeletonAttr>,
}

/// An attribute of a grammar that may have errors.
#[derive(Clone, Debug)]
pub struct SkeletonAttr {
    /// As written.
    pub name: String,
    /// Its type, as far as it could be told.
    pub ty: Option<Type>,
    /// The default. Without errors the same as in [`ir::Attr`](crate::ir::Attr), else only if it is a literal.
    pub known: Option<Value>,
    /// Whether the default is computed for each initial shape. With errors a good guess.
    pub computed: bool,
    /// The name in its declaration.
    pub span: Span,
}

/// Compiles tokens.
pub fn compile(tokens: &Tokens, door: Door) -> Compiled {
    compile_with(tokens, door, &[])
}

/// Compiles tokens, with levels of findings for the grammar as a whole (`@Allow` and its like before the header).
pub fn compile_with(tokens: &Tokens, door: Door, levels: &[(Code, Level)]) -> Compiled {
    compile_after(tokens, door, levels, Vec::new())
}

/// Compiles tokens; `found` are the findings of whoever made them. An error among these leaves no grammar.
pub fn compile_after(tokens: &Tokens, door: Door, levels: &[(Code, Level)], found: Vec<Diag>) -> Compiled {
    let mut diags = Diags::new();
    diags.append(found);
    let ast = parse(tokens, &mut diags);
    let outcome = check(&ast, door, levels, &mut diags);
    let grammar = outcome.checked.map(|checked| lower(&checked, tokens));
    let names = skeleton(&ast, &outcome.attrs, grammar.as_ref());
    Compiled { grammar, diags: diags.finish(), names }
}

/// A compiled text.
#[derive(Clone, Debug)]
pub struct Source {
    /// The tokens.
    pub tokens: Tokens,
    /// Bytes of the text, one range a token: what [`render`](crate::snippet::render) needs.
    pub ranges: Vec<Range<usize>>,
    /// What became of it; findings about characters are among the others.
    pub compiled: Compiled,
}

/// Compiles CGA text.
pub fn compile_text(text: &str) -> Source {
    compile_text_with(text, &[])
}

/// Compiles CGA text, with levels of findings for the grammar as a whole.
pub fn compile_text_with(text: &str, levels: &[(Code, Level)]) -> Source {
    let lexed = lex(text);
    let compiled = compile_after(&lexed.tokens, Door::Text, levels, lexed.diags);
    Source { tokens: lexed.tokens, ranges: lexed.ranges, compiled }
}

fn skeleton(ast: &Ast, attrs: &[(&Decl, Option<Type>)], grammar: Option<&Grammar>) -> Skeleton {
    let mut list: Vec<SkeletonAttr> = Vec::new();
    let mut seen = HashSet::new();
    for (index, (decl, ty)) in attrs.iter().enumerate() {
        if !seen.insert(decl.name.text.as_str()) {
            continue;
        }
        let known = match grammar {
            Some(grammar) => grammar.attrs[index].known.clone(),
            None => decl.value().and_then(literal),
        };
        let computed = match grammar {
            Some(_) => known.is_none(),
            None => decl.value().is_some_and(|value| computed(value, ast, 0)),
        };
        list.push(SkeletonAttr { name: decl.name.text.clone(), ty: *ty, known, computed, span: decl.name.span });
    }
    Skeleton { attrs: list }
}

/// Whether a value depends on more than constants, as far as can be told without checks.
fn computed(value: &Expr, ast: &Ast, depth: u32) -> bool {
    let part = |value: &Expr| computed(value, ast, depth);
    match &value.kind {
        ExprKind::Number(_) | ExprKind::Bool(_) | ExprKind::Text(_) | ExprKind::Error => false,
        ExprKind::Name(name) => {
            let decl = ast.decls.iter().find(|decl| decl.name.text == name.text && decl.value().is_some());
            match decl {
                Some(decl) if matches!(decl.body, Body::Attr(_)) || DEEPEST < depth => true,
                Some(decl) => decl.value().is_some_and(|value| computed(value, ast, depth + 1)),
                // One that is not declared is another finding; the rest are attributes of the shape and draws.
                None => shape_attr(&name.text).is_some() || functions(&name.text).any(|row| !row.pure),
            }
        }
        ExprKind::Call(name, args) => !functions(&name.text).any(|row| row.pure) || args.iter().any(part),
        ExprKind::Host(_) | ExprKind::Path(..) | ExprKind::Chance(..) => true,
        _ => value.parts().into_iter().any(part),
    }
}

/// How far constants are followed.
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
