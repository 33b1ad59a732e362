//! Slots: `{ size : operations | … }*`.

use super::report::AFTER_SIZE;
use super::{Parsed, Parser};
use crate::diag::RELATIVE;
use crate::diag::code::Code;
use crate::syntax::ast::SplitItem;
use crate::syntax::token::{Sym, Tok};

impl Parser<'_> {
    /// Parses slots from the `{`. Returns true with them if a `*` follows.
    pub(super) fn slots(&mut self) -> Parsed<(Vec<SplitItem>, bool)> {
        let items = self.between_bars(Some("size : operations"), Self::slot)?;
        Ok((items, self.eat(Sym::Star)))
    }

    fn slot(&mut self) -> Parsed<SplitItem> {
        if self.is(Sym::LBrace) {
            let (items, repeat) = self.slots()?;
            return Ok(SplitItem::Group(items, repeat));
        }
        if matches!(self.peek(), Some(Tok::Ident(_) | Tok::Path(_) | Tok::Sym(Sym::LBracket)))
            && !self.slot_has(|token| token.is(Sym::Colon))
        {
            return self.missing_size();
        }
        if let Some(Tok::Number(percent)) = self.peek()
            && self.at_percent()
            && !self.slot_has(|token| token.ident() == Some("else"))
        {
            let span = self.span().to(self.span_at(self.at + 1));
            let share = (percent * 1e6).round() / 1e8;
            let diag = self.diags.report(Code::Syntax, span, "the size of a slot cannot be a percentage");
            return Err(diag.help(format!("write `{RELATIVE}{share}`")).into());
        }
        let size = self.sized(true)?;
        if !self.eat(Sym::Colon) && !self.slipped_colon("the size") {
            let is_body = matches!(self.peek(), Some(Tok::Ident(_) | Tok::Path(_)))
                && self.number_with_unit().is_none()
                && !self.slot_has(|token| token.is(Sym::Colon));
            let reported = self.expected(AFTER_SIZE).into();
            if !is_body {
                return Err(reported);
            }
        }
        let ops = self.ops(false)?;
        Ok(SplitItem::Slot(size, ops))
    }

    /// Returns true if a token follows before the slot ends.
    fn slot_has(&self, wanted: impl Fn(&Tok) -> bool) -> bool {
        let mut at = self.at;
        while let Some(token) = self.layout.at(at) {
            match token {
                token if wanted(token) => return true,
                Tok::Sym(Sym::Bar | Sym::RBrace | Sym::RBracket | Sym::RParen) => return false,
                Tok::Sym(Sym::LBrace | Sym::LBracket | Sym::LParen) => match self.layout.close(at) {
                    Some(close) => at = close,
                    None => return true,
                },
                _ => {}
            }
            at += 1;
        }
        true
    }

    fn missing_size<T>(&mut self) -> Parsed<T> {
        let span = self.span();
        let diag = self.diags.report(Code::MissingSize, span, "this slot has no size");
        // *CGA changelog 2015.0*.
        diag.note("versions before 2015 allowed it, and `~1` was meant");
        Err(diag.help("put `~1 :` before it to share what is left, or a size in metres and `:`").into())
    }
}
