//! Diagnostics of rules as data, for programs that show them in their own way.

use cga_lang::compile::Compiled;
use cga_lang::diag::{Diag, Level};
use cga_lang::snippet::{Position, Quote, render_in};
use cga_lang::span::Span;

/// An error or a warning about rules that are loaded at run time.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct RuleDiagnostic {
    /// True for an error, false for a warning.
    pub is_error: bool,
    /// The name of the diagnostic, as [`RuleLoader::allow`](crate::RuleLoader::allow) takes it.
    pub code: &'static str,
    /// The problem in one sentence.
    pub message: String,
    /// The corrections that the compiler proposes.
    pub help: Vec<String>,
    /// The rule file.
    pub file: String,
    /// The line of the first character, from 1.
    pub line: usize,
    /// The column of the first character, from 1 and in characters.
    pub column: usize,
    /// The line of the end.
    pub end_line: usize,
    /// The column after the last character.
    pub end_column: usize,
    /// The diagnostic as the compiler shows it: with its place, its line of the rules, and notes.
    pub text: String,
}

impl RuleDiagnostic {
    pub(crate) fn new<'t>(compiled: &Compiled, quote: &dyn Fn(usize) -> Option<Quote<'t>>, diag: &Diag) -> Self {
        let (number, first) = compiled.locate(diag.span.first);
        let mut place = Position { line: 1, column: 1 };
        let mut end = place;
        let mut file = compiled.files.get(number).map_or_else(String::new, |file| file.name.clone());
        if let Some(quote) = quote(number) {
            let last = compiled.locate(diag.span.last).1.max(first);
            let bytes = quote.bytes(Span { first, last });
            (place, end) = (quote.lines.position(bytes.start), quote.lines.position(bytes.end));
            file = quote.name.to_owned();
        }
        RuleDiagnostic {
            is_error: diag.level == Level::Error,
            code: diag.code.name(),
            message: diag.message.to_string(),
            help: diag.help.iter().map(ToString::to_string).collect(),
            file,
            line: place.line,
            column: place.column,
            end_line: end.line,
            end_column: end.column,
            text: render_in(compiled, quote, diag),
        }
    }
}
