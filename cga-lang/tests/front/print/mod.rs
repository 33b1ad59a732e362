//! A tree as CGA text, in either spelling. Brackets show how operators were grouped.
//!
//! The printed text parses to the same tree, unless the tree has a syntax error.

mod decl;
mod expr;
mod op;

use cga_lang::span::Span;
use cga_lang::syntax::ast::Ast;
use cga_lang::syntax::token::{Tok, Tokens};

/// The spelling of relative sizes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spelling {
    /// `'0.5`, as in CGA text.
    Text,
    /// `^0.5`, as among Rust.
    Inline,
}

/// The text of a tree, one declaration a line: imports first, then everything else in source order.
pub(crate) fn print(ast: &Ast, spelling: Spelling) -> String {
    let mut out =
        Printer { out: String::new(), spelling, imports: ast.imports.iter().map(|import| &*import.id.text).collect() };
    for annotation in &ast.head {
        out.annotation(annotation);
    }
    if let Some(version) = &ast.version {
        out.word("version ");
        push_quoted(&mut out.out, version);
        out.word("\n");
    }
    for import in &ast.imports {
        out.import(import);
    }
    let (mut style, mut known) = (0, 0);
    for decl in &ast.decls {
        if decl.style != style {
            style = decl.style;
            let new = known < style;
            // Those without declarations come on the way, so that all keep their numbers.
            ast.styles[known as usize..style.max(known) as usize].iter().for_each(|style| out.style(style));
            known = known.max(style);
            if !new {
                let name = style.checked_sub(1).map_or("Default", |index| &ast.styles[index as usize].name.text);
                out.word(&format!("style {name}\n"));
            }
        }
        out.decl(decl);
        out.word("\n");
    }
    ast.styles[known as usize..].iter().for_each(|style| out.style(style));
    out.out
}

struct Printer<'a> {
    out: String,
    spelling: Spelling,
    /// Their prefixes.
    imports: Vec<&'a str>,
}

impl Printer<'_> {
    fn word(&mut self, text: &str) {
        self.out.push_str(text);
    }

    fn list<T>(&mut self, items: &[T], between: &str, mut each: impl FnMut(&mut Self, &T)) {
        for (index, item) in items.iter().enumerate() {
            if index != 0 {
                self.word(between);
            }
            each(self, item);
        }
    }
}

/// Appends a string in quotes.
fn push_quoted(out: &mut String, text: &str) {
    let token: Tokens = std::iter::once(Tok::Str(text.to_owned())).collect();
    out.push_str(&token.text(Span { first: 0, last: 0 }, usize::MAX, '\''));
}
