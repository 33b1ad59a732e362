//! `@Name(…)`.

use super::{Parsed, Parser};
use crate::ast::{Annotation, AnnotationArg};
use crate::token::{Sym, Tok};
use crate::words;

impl Parser<'_> {
    /// One annotation; `None` when its arguments are wrong, which is reported.
    pub(super) fn annotation(&mut self) -> Parsed<Option<Annotation>> {
        self.bump();
        let Some(name) = self.take_name() else { return self.fail("the name of an annotation") };
        if !self.is(Sym::LParen) {
            return Ok(Some(Annotation { name, args: Some(Vec::new()) }));
        }
        let close = self.closing()?;
        let args = if words::READ_ANNOTATIONS.contains(&name.text.as_str()) {
            self.bump();
            self.annotation_args(close).ok()
        } else {
            None
        };
        self.at = close + 1;
        Ok(Some(Annotation { name, args }))
    }

    fn annotation_args(&mut self, close: usize) -> Parsed<Vec<AnnotationArg>> {
        let mut args = Vec::new();
        while self.at < close && self.tick() {
            let mut name = None;
            if matches!(self.peek(), Some(Tok::Ident(_))) && self.nth_is(1, Sym::Assign) {
                name = self.take_name();
                self.bump();
            }
            let value = self.value()?;
            args.push(AnnotationArg { name, value });
            if self.at < close && !self.eat(Sym::Comma) {
                return self.fail("`,` or `)`");
            }
        }
        Ok(args)
    }
}
