//! `@Name(…)`. Annotations never change the result of a grammar, so a mistake in one does not stop the build.

use super::{Parsed, Parser};
use crate::diag::Level;
use crate::diag::code::Code;
use crate::syntax::ast::{Annotation, AnnotationArg};
use crate::syntax::token::Sym;
use crate::syntax::words;

/// The annotation with a syntax of its own: braces and bare words.
const HANDLE: &str = "Handle";

impl Parser<'_> {
    /// Parses an annotation. Its arguments are `None` if they cannot be read, which is a warning where they have a
    /// meaning.
    pub(super) fn annotation(&mut self) -> Parsed<Option<Annotation>> {
        self.bump();
        let Some(name) = self.take_name() else {
            let failed = self.fail("the name of an annotation");
            // Many signs in a row are two mistakes, not one for each sign.
            while self.is(Sym::At) && self.nth_is(1, Sym::At) {
                self.bump();
            }
            return failed;
        };
        if !self.is(Sym::LParen) {
            return Ok(Some(Annotation { name, args: Some(Vec::new()) }));
        }
        let close = self.closing()?;
        let (args, found) = self.tried(|parser| parser.between_commas(Self::annotation_arg));
        if let (Some(first), true) = (found.first(), name.text != HANDLE && words::ANNOTATIONS.contains(&&*name.text)) {
            let diag = self.diags.report_as(Code::BadAnnotation, Level::Warning, first.span, first.message.clone());
            diag.note(format!("`@{}` is ignored", name.text));
            diag.help.clone_from(&first.help);
            if let Some(form) = form(&name.text).filter(|_| first.help.is_empty()) {
                diag.help(format!("write `{form}`"));
            }
        }
        self.deep = false;
        self.at = close + 1;
        Ok(Some(Annotation { name, args: args.ok().filter(|_| found.is_empty()) }))
    }

    fn annotation_arg(&mut self) -> Parsed<AnnotationArg> {
        let mut name = None;
        if self.nth_is_name(0) && self.nth_is(1, Sym::Assign) {
            name = self.take_name();
            self.bump();
        }
        Ok(AnnotationArg { name, value: self.expr()? })
    }
}

/// Returns the written form of an annotation with arguments.
fn form(name: &str) -> Option<&'static str> {
    Some(match name {
        "Range" => "@Range(min = 0, max = 10)",
        "Enum" => "@Enum(\"a\", \"b\")",
        "Group" => "@Group(\"Name\", 1)",
        "Order" => "@Order(1)",
        "Description" => "@Description(\"…\")",
        _ => return None,
    })
}
