//! A diagnostic with its place and source line, for sources with text.
//!
//! ```text
//! warning[undefined_rule]: there is no rule `Wal`
//!  --> rules/tower.cga:3:22
//!   |
//! 3 | Lot --> extrude(3) Wal
//!   |                    ^^^
//!   = help: did you mean `Wall`?
//! ```

use crate::diag::{Diag, Level};
use crate::span::Span;
use std::borrow::Cow;
use std::ops::Range;

mod lines;
mod program;

pub use lines::{Lines, Position};
pub use program::render_in;

/// A text that diagnostics are quoted from.
#[derive(Clone, Copy, Debug)]
pub struct Quote<'t> {
    /// The name in messages.
    pub name: &'t str,
    /// The text with the starts of its lines.
    pub lines: &'t Lines<'t>,
    /// The byte ranges of its tokens.
    pub ranges: &'t [Range<usize>],
}

impl Quote<'_> {
    /// Returns the bytes of a span.
    pub fn bytes(&self, span: Span) -> Range<usize> {
        bytes(self.lines.text(), self.ranges, span)
    }

    /// Returns the place where a span begins.
    pub fn start(&self, span: Span) -> Position {
        self.lines.position(self.bytes(span).start)
    }
}

/// A diagnostic as text, without a newline at the end.
pub fn render(quote: Quote<'_>, diag: &Diag) -> String {
    let related = |span| Some(format!("line {}", quote.start(span).line));
    format!("{}\n{}", headline(diag), place(quote, diag.span, diag, &related))
}

/// The first line of a diagnostic.
fn headline(diag: &Diag) -> String {
    let level = match diag.level {
        Level::Error => "error",
        Level::Warning | Level::Allow => "warning",
    };
    format!("{level}[{}]: {}", diag.code.name(), diag.message)
}

/// The place, notes and help of a diagnostic: [`render`] without the first line. `span` is its place in this text.
/// `related` names a second place: "line 3", or "line 3 of lib.cga".
pub fn place(quote: Quote<'_>, span: Span, diag: &Diag, related: &dyn Fn(Span) -> Option<String>) -> String {
    let (text, bytes) = (quote.lines.text(), quote.bytes(span));
    let at = quote.lines.position(bytes.start);
    let line = quote.lines.line(bytes.start);
    let margin = " ".repeat(at.line.to_string().len());
    let (before, marked, after) = split_line(text, &line, &bytes);
    let before = clip_front(before);
    let marked = clip_back(marked);
    let after = clip_back(after);
    let carets = "^".repeat(marked.chars().count().max(1));
    let mut out = format!("{margin}--> {}:{}:{}\n{margin} |\n", quote.name, at.line, at.column);
    out.push_str(&format!("{} | {before}{marked}{after}\n{margin} | {}{carets}", at.line, blank(&before)));
    for note in diag.reasons() {
        out.push_str(&format!("\n{margin} = note: {}", note.text));
        if let Some(line) = note.related.and_then(related) {
            out.push_str(&format!(" in {line}"));
        }
    }
    for help in &diag.help {
        out.push_str(&format!("\n{margin} = help: {help}"));
    }
    out
}

/// The bytes of a span, or the end of the text without tokens.
pub fn bytes(text: &str, ranges: &[Range<usize>], span: Span) -> Range<usize> {
    let last = ranges.get(span.last as usize).or(ranges.last());
    let (Some(first), Some(last)) = (ranges.get(span.first as usize).or(ranges.last()), last) else {
        return text.len()..text.len();
    };
    let start = border(text, first.start);
    start..border(text, last.end).max(start)
}

/// The nearest character boundary at or before a byte.
fn border(text: &str, byte: usize) -> usize {
    (0..=byte.min(text.len())).rev().find(|&byte| text.is_char_boundary(byte)).unwrap_or(0)
}

/// The parts of the line before, inside and after `bytes`.
fn split_line<'t>(text: &'t str, line: &Range<usize>, bytes: &Range<usize>) -> (&'t str, &'t str, &'t str) {
    let start = bytes.start.clamp(line.start, line.end);
    let end = bytes.end.clamp(start, line.end);
    let end = start + text[start..end].trim_end().len();
    (&text[line.start..start], &text[start..end], text[end..line.end].trim_end())
}

/// The maximum length of each part of a line around the carets, in characters.
const LONGEST: usize = 120;

fn clip_front(text: &str) -> Cow<'_, str> {
    match text.char_indices().rev().nth(LONGEST) {
        Some((at, _)) => Cow::Owned(format!("…{}", &text[at..])),
        None => Cow::Borrowed(text),
    }
}

fn clip_back(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(LONGEST) {
        Some((at, _)) => Cow::Owned(format!("{}…", &text[..at])),
        None => Cow::Borrowed(text),
    }
}

/// White space as wide as the text. Tabs stay tabs, because their displayed width is unknown.
fn blank(text: &str) -> String {
    text.chars().map(|c| if c == '\t' { '\t' } else { ' ' }).collect()
}

#[cfg(test)]
mod tests {
    use super::{Lines, Quote, render};
    use crate::compile::compile_text;
    use crate::diag::Diags;
    use crate::diag::code::Code;
    use crate::span::Span;
    use crate::syntax::lex::lex;

    fn shown(text: &str) -> String {
        let source = compile_text(text);
        let quote = Quote { name: "a.cga", lines: &Lines::new(text), ranges: &source.ranges };
        let list = source.compiled.diags.iter().map(|diag| render(quote, diag));
        list.collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn shows_the_line_with_carets_under_the_guilty_token() {
        let text = "# ein Haus\r\nLot -->\r\n\tprint(\"grün\") extrud(3)\r\nextrude2 --> NIL\r\n";
        assert_eq!(
            shown(text),
            "warning[undefined_rule]: there is no rule `extrud`\n --> a.cga:3:16\n  |\n3 | \tprint(\"grün\") extrud(3)\n  \
             | \t              ^^^^^^\n  = note: it becomes a leaf named `extrud`\n  = help: did you mean `extrude`?"
        );
    }

    #[test]
    fn names_the_line_of_a_second_place() {
        assert_eq!(
            shown("\u{feff}A --> NIL\nA --> NIL"),
            "error[duplicate_name]: rule `A` is declared twice\n --> a.cga:2:1\n  |\n2 | A --> NIL\n  | ^\n  = note: \
             first declared in line 1"
        );
    }

    #[test]
    fn lines_may_end_in_old_ways() {
        assert_eq!(
            shown("A --> NIL\r\rA --> NIL\rB --> NIL"),
            "error[duplicate_name]: rule `A` is declared twice\n --> a.cga:3:1\n  |\n3 | A --> NIL\n  | ^\n  = note: \
             first declared in line 1"
        );
    }

    #[test]
    fn thousands_of_findings_in_one_long_line_are_shown() {
        // With a search of the line for each finding, this took as many steps as the square of the length.
        let rules = "Lot --> Wäll ".repeat(60_000);
        let lexed = lex(&rules);
        let lines = Lines::new(&rules);
        let quote = Quote { name: "a.cga", lines: &lines, ranges: &lexed.ranges };
        let mut diags = Diags::new();
        for number in 0..5_000 {
            diags.report(Code::UndefinedRule, Span::one(3 * number + 2), format!("rule {number} is missing"));
        }
        let shown: Vec<String> = diags.finish().iter().map(|diag| render(quote, diag)).collect();
        assert!(shown[4_999].contains(" --> a.cga:1:64996\n") && shown[4_999].contains("\n1 | …"), "{}", shown[4_999]);
        assert!(shown.iter().all(|text| text.contains(" --> a.cga:1:") && text.len() < 1000));
    }

    #[test]
    fn a_text_without_tokens_has_a_place() {
        assert!(super::bytes("# x", &[], crate::span::Span::default()).is_empty());
    }
}
