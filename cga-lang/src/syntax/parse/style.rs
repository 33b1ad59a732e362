//! `style Name extends Base`: a section of the file.

use super::{Parsed, Parser};
use crate::diag::code::Code;
use crate::syntax::ast::{Annotation, Ast, DEFAULT, StyleDecl};
use crate::syntax::token::Sym;

impl Parser<'_> {
    /// Parses a style from the word `style`. Returns the number of the style that begins.
    pub(super) fn style(&mut self, ast: &mut Ast, annotations: Vec<Annotation>) -> Parsed<u32> {
        self.bump();
        let name = self.plain_name("a style")?;
        let mut base = None;
        if self.is_word("extends") && !self.nth_is(1, Sym::Arrow) {
            self.bump();
            base = if self.at_border() { None } else { self.take_name() };
            match &base {
                Some(base) => self.no_dollar(base, "a style"),
                None => _ = self.expected("the name of a style"),
            }
        }
        if self.is(Sym::LBrace) {
            self.syntax(self.at, "a style has no braces")
                .help("leave out the braces: a style ends at the next `style`");
            self.bump();
        }
        // To extend `Default` has no effect.
        let base = base.filter(|base| base.text != DEFAULT);
        if name.text == DEFAULT {
            if let Some(base) = base {
                self.diags.report(Code::Syntax, base.span, "the style `Default` extends no other");
            }
            return Ok(0);
        }
        let next = ast.styles.len() as u32 + 1;
        let number = *self.styles.entry(name.text.clone()).or_insert(next);
        if number == next {
            ast.styles.push(StyleDecl { annotations, name, base });
            return Ok(number);
        }
        let style = &mut ast.styles[number as usize - 1];
        style.annotations.extend(annotations);
        let known = style.base.as_ref().map_or(DEFAULT, |base| &base.text);
        if let Some(base) = base.filter(|base| base.text != known) {
            let message = format!("style `{}` already extends `{known}`", name.text);
            self.diags.report(Code::Syntax, base.span, message).related("first named", style.name.span);
        }
        Ok(number)
    }
}
