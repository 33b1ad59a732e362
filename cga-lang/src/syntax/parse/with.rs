//! `with ( name := value … )`: values that a declaration computes once.

use super::{Parsed, Parser, Reported};
use crate::diag::code::Code;
use crate::syntax::ast::{Expr, ExprKind, Name};
use crate::syntax::token::{Sym, Tok};

impl Parser<'_> {
    /// Parses the locals of a declaration, if it has any. Locals that cannot be read are left out.
    pub(super) fn locals(&mut self) -> Parsed<Vec<(Name, Expr)>> {
        let mut locals = Vec::new();
        if !self.is_word("with") || !self.nth_is(1, Sym::LParen) {
            return Ok(locals);
        }
        self.bump();
        let close = self.closing()?;
        self.bump();
        if self.at == close {
            self.expected("the name of a local").help("write `with ( name := value )`");
        }
        while self.at < close && self.tick() {
            match self.bracketed(false, Self::local) {
                Ok(local) => locals.push(local),
                Err(Reported) => self.skip_to_local(close),
            }
            if let Some(Tok::Sym(sym @ (Sym::Comma | Sym::Semi))) = self.peek()
                && self.at < close
            {
                self.syntax(self.at, "locals have no separator").help(format!("leave out the `{}`", sym.text()));
                self.bump();
            }
        }
        self.at = close + 1;
        Ok(locals)
    }

    fn local(&mut self) -> Parsed<(Name, Expr)> {
        let name = self.plain_name("a local")?;
        self.not_a_keyword(&name);
        if self.is(Sym::Colon) && self.nth_is(1, Sym::Assign) {
            self.at += 2;
        } else if self.is(Sym::Assign) {
            self.syntax(self.at, "the value of a local follows `:=`").help(format!("write `{} :=`", name.text));
            self.bump();
        } else {
            return self.fail("`:=`");
        }
        let value = self.expr()?;
        // *CGA changelog 2021.1*.
        if let Some(comp) = comp_in(&value) {
            self.diags
                .report(Code::Syntax, comp.span, "a local value cannot hold a `comp`")
                .help("declare a function for it, and call that here");
        }
        Ok((name, value))
    }

    fn skip_to_local(&mut self, close: usize) {
        while self.at < close && !(self.nth_is_name(0) && self.nth_is(1, Sym::Colon) && self.nth_is(2, Sym::Assign)) {
            self.at = self.layout.close(self.at).unwrap_or(self.at) + 1;
        }
    }
}

/// Returns the first `comp` in an expression.
fn comp_in(expr: &Expr) -> Option<&Expr> {
    if matches!(expr.kind, ExprKind::Comp(_)) {
        return Some(expr);
    }
    expr.parts().into_iter().find_map(comp_in)
}
