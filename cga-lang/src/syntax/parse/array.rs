//! `[a, b; c, d]`, and `[i]` after a value.

use super::expr::Part;
use super::{Parsed, Parser, Reported};
use crate::syntax::ast::{Expr, ExprKind};
use crate::syntax::token::{Sym, Tok};

impl Parser<'_> {
    /// Parses an array from its `[` (*array initialization function*).
    pub(super) fn array(&mut self) -> Parsed<Part> {
        let start = self.at;
        let close = self.closing()?;
        self.bump();
        let (mut rows, mut deepest) = (vec![Vec::new()], 0);
        if self.at == close {
            self.expected("a value")
                .help("write `floatArray`, `boolArray` or `stringArray` for an array without elements");
            return Err(Reported);
        }
        loop {
            let (entry, depth) = self.bracketed(false, Self::entry)?;
            deepest = deepest.max(depth);
            if let Some(row) = rows.last_mut() {
                row.push(entry);
            }
            if self.at == close {
                break;
            }
            if self.is(Sym::Semi) {
                rows.push(Vec::new());
            } else if !self.is(Sym::Comma) {
                return self.fail("`,`, `;` or `]`");
            }
            self.bump();
            if !self.tick() {
                return Err(Reported);
            }
        }
        self.at = close + 1;
        let depth = self.deepen(deepest)?;
        Ok((Expr { kind: ExprKind::Array(rows), span: self.span_from(start) }, depth))
    }

    /// Parses the `[ … ]` after a value that begins at `start` (*index operator*).
    pub(super) fn index(&mut self, (array, depth): Part, start: usize) -> Parsed<Part> {
        let close = self.closing()?;
        self.bump();
        let (mut indices, mut deepest) = (Vec::new(), depth);
        while self.tick() {
            if 2 <= indices.len() {
                self.syntax(self.at, "an array has rows and columns, no third index").help("write `a[row, column]`");
                return Err(Reported);
            }
            let (index, depth) = self.bracketed(false, Self::entry)?;
            deepest = deepest.max(depth);
            indices.push(index);
            if self.at == close {
                break;
            }
            if !self.eat(Sym::Comma) {
                return self.fail("`,` or `]`");
            }
        }
        self.at = close + 1;
        let depth = self.deepen(deepest)?;
        Ok((Expr { kind: ExprKind::Index(Box::new(array), indices), span: self.span_from(start) }, depth))
    }

    /// Reports the `..` of a range that begins at `start`.
    fn dots<T>(&mut self, start: usize) -> Parsed<T> {
        let base = self.written(start, self.at);
        let limit = match self.nth(2) {
            Some(Tok::Sym(Sym::Assign)) => self.written(self.at + 3, self.at + 4),
            // A range in Rust does not include the limit after `..`.
            Some(Tok::Number(limit)) => (limit - 1.0).to_string(),
            Some(Tok::Ident(limit))
                if matches!(self.nth(3), Some(Tok::Sym(Sym::Comma | Sym::Semi | Sym::RBracket))) =>
            {
                format!("{limit} - 1")
            }
            _ => "…".into(),
        };
        let span = self.span().to(self.span_at(self.at + 1));
        self.syntax_over(self.at, span, "`..` is not an operator")
            .note("a range in an array includes its last number")
            .help(format!("write `{base}:{limit}`"));
        Err(Reported)
    }

    /// Parses a value, `base : limit` or `base : step : limit` (*colon operator*).
    fn entry(&mut self) -> Parsed<Part> {
        let start = self.at;
        let (base, mut deepest) = self.deep_expr()?;
        if self.is(Sym::Dot) && self.nth_is(1, Sym::Dot) {
            return self.dots(start);
        }
        if !self.eat(Sym::Colon) {
            return Ok((base, deepest));
        }
        let (mut limit, depth) = self.deep_expr()?;
        deepest = deepest.max(depth);
        let mut step = None;
        if self.eat(Sym::Colon) {
            let (last, depth) = self.deep_expr()?;
            deepest = deepest.max(depth);
            step = Some(Box::new(std::mem::replace(&mut limit, last)));
        }
        let depth = self.deepen(deepest)?;
        let kind = ExprKind::Range(Box::new(base), step, Box::new(limit));
        Ok((Expr { kind, span: self.span_from(start) }, depth))
    }
}
