//! The forms in which findings are printed.

use std::io::{Result, Write};

use cga_lang::compile::Compiled;
use cga_lang::diag::{Diag, Level};
use cga_lang::snippet::{Position, Quote, render_in};
use cga_lang::span::Span;
use serde_json::json;

use crate::stream::{visible, visible_line};

/// A form of the findings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Format {
    /// Text with source lines.
    Full,
    /// One line for each finding.
    Short,
    /// A JSON object for each finding.
    Json,
}

/// Returns the word for the level of a finding.
fn word(level: Level) -> &'static str {
    match level {
        Level::Error => "error",
        Level::Warning | Level::Allow => "warning",
    }
}

/// Prints a finding.
pub(crate) fn write<'t>(
    format: Format,
    compiled: &Compiled,
    quote: &dyn Fn(usize) -> Option<Quote<'t>>,
    diag: &Diag,
    out: &mut dyn Write,
) -> Result<()> {
    if format == Format::Full {
        return writeln!(out, "{}\n", visible(&render_in(compiled, quote, diag)));
    }
    let place = place(compiled, quote, diag.span);
    let (level, code) = (word(diag.level), diag.code.name());
    if format == Format::Short {
        let (file, Position { line, column }) = (&place.file, place.start);
        let line = format!("{file}:{line}:{column}: {level}[{code}]: {}", diag.message);
        return writeln!(out, "{}", visible_line(&line));
    }
    let notes: Vec<_> = diag
        .reasons()
        .map(|note| match note.related.map(|span| self::place(compiled, quote, span)) {
            Some(at) => json!({"message": note.text.to_string(), "place": at.json()}),
            None => json!({"message": note.text.to_string()}),
        })
        .collect();
    let help: Vec<String> = diag.help.iter().map(ToString::to_string).collect();
    let object = json!({
        "level": level,
        "code": code,
        "message": diag.message.to_string(),
        "place": place.json(),
        "notes": notes,
        "help": help,
    });
    writeln!(out, "{object}")
}

/// The place of a finding. Lines and columns count from 1, columns in characters; the end is behind the last character.
struct SourceRange {
    file: String,
    start: Position,
    end: Position,
}

impl SourceRange {
    fn json(&self) -> serde_json::Value {
        let SourceRange { file, start, end } = self;
        json!({
            "file": file,
            "line": start.line,
            "column": start.column,
            "end_line": end.line,
            "end_column": end.column,
        })
    }
}

fn place<'t>(compiled: &Compiled, quote: &dyn Fn(usize) -> Option<Quote<'t>>, span: Span) -> SourceRange {
    let (file, first) = compiled.locate(span.first);
    let Some(quote) = quote(file) else {
        let file = compiled.files.get(file).map_or_else(String::new, |file| file.name.clone());
        let start = Position { line: 1, column: 1 };
        return SourceRange { file, start, end: start };
    };
    let last = compiled.locate(span.last).1.max(first);
    let bytes = quote.bytes(Span { first, last });
    let [start, end] = [bytes.start, bytes.end].map(|byte| quote.lines.position(byte));
    SourceRange { file: quote.name.to_owned(), start, end }
}
