//! `comp(f) { selector : operations | selector = operations }`.

use super::{Parsed, Parser, Reported};
use crate::ast::{ArmMode, Comp, CompArm, Name, OpKind};
use crate::token::Sym;

impl Parser<'_> {
    /// Behind the word `comp`.
    pub(super) fn comp(&mut self, name: Name) -> Parsed<OpKind> {
        if !self.is(Sym::LParen) {
            self.expected("`(`").help("write `comp(f) { … }`");
            return Err(Reported);
        }
        let args = self.args()?;
        if !self.is(Sym::LBrace) {
            self.expected("`{`").help("write `comp(f) { selector : operations | … }`");
            return Err(Reported);
        }
        let arms = self.between_bars(Self::arm)?;
        Ok(OpKind::Comp(Comp { name, args, arms }))
    }

    fn arm(&mut self) -> Parsed<CompArm> {
        let selector = self.expr()?;
        let together = self.eat(Sym::Assign);
        if together && self.is(Sym::Colon) {
            let span = self.span_at(self.at - 1).to(self.span());
            self.unsupported(span, "the operator `=:` is");
            self.bump();
        } else if !together && !self.eat(Sym::Colon) {
            return self.fail("`:` or `=` after the selector");
        }
        let ops = self.ops(false)?;
        let mode = if together { ArmMode::Together } else { ArmMode::Each };
        Ok(CompArm { selector, mode, ops })
    }
}
