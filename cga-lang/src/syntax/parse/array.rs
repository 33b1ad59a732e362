//! `[a, b; c, d]`, and `[i]` after a value.

use super::{Parsed, Parser, Reported};
use crate::syntax::ast::{Expr, ExprKind};
use crate::syntax::token::{Sym, Tok};

impl Parser<'_> {
    /// Parses an array from its `[` (*array initialization function*).
    pub(super) fn array(&mut self) -> Parsed<Expr> {
        let start = self.at;
        let close = self.closing()?;
        self.bump();
        let (mut rows, mut row) = (Vec::new(), Vec::new());
        if self.at == close {
            let help = "write `floatArray`, `boolArray` or `stringArray` for an array without elements";
            return Err(self.expected("a value").help(help).into());
        }
        loop {
            row.push(self.bracketed(false, Self::entry)?);
            if self.at == close {
                break;
            }
            if self.is(Sym::Semi) {
                rows.push(std::mem::take(&mut row));
            } else if !self.is(Sym::Comma) {
                return self.fail("`,`, `;` or `]`");
            }
            self.bump();
            if !self.tick() {
                return Err(Reported);
            }
        }
        self.at = close + 1;
        rows.push(row);
        self.node(ExprKind::Array(rows), start)
    }

    /// Parses the `[ … ]` after a value that begins at `start` (*index operator*).
    pub(super) fn index(&mut self, array: Expr, start: usize) -> Parsed<Expr> {
        let close = self.closing()?;
        self.bump();
        let mut indices = Vec::new();
        while self.tick() {
            if 2 <= indices.len() {
                let diag = self.syntax(self.at, "an array has rows and columns, no third index");
                return Err(diag.help("write `a[row, column]`").into());
            }
            indices.push(self.bracketed(false, Self::entry)?);
            if self.at == close {
                break;
            }
            if !self.eat(Sym::Comma) {
                return self.fail("`,` or `]`");
            }
        }
        self.at = close + 1;
        self.node(ExprKind::Index(Box::new(array), indices), start)
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
        let diag = self.syntax_over(self.at, span, "`..` is not an operator");
        diag.note("a range in an array includes its last number");
        Err(diag.help(format!("write `{base}:{limit}`")).into())
    }

    /// Parses a value, `base : limit` or `base : step : limit` (*colon operator*).
    fn entry(&mut self) -> Parsed<Expr> {
        let start = self.at;
        let base = self.expr()?;
        if self.is(Sym::Dot) && self.nth_is(1, Sym::Dot) {
            return self.dots(start);
        }
        if !self.eat(Sym::Colon) {
            return Ok(base);
        }
        let mut limit = Box::new(self.expr()?);
        let mut step = None;
        if self.eat(Sym::Colon) {
            step = Some(std::mem::replace(&mut limit, Box::new(self.expr()?)));
        }
        self.node(ExprKind::Range(Box::new(base), step, limit), start)
    }
}
