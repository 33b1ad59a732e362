//! `= r#"…"#`: rules in a string literal, or in several that `concat!` joins, in verbatim CGA.

use std::ops::Range;

use cga_lang::diag::Diag;
use cga_lang::syntax::lex::{MOST_BYTES, TOO_LONG, lex_joined};
use cga_lang::syntax::token::Tokens;
use proc_macro2::{Literal, Span};

use super::content::Content;
use super::problem::Problem;

/// Rules in string literals, as tokens.
#[derive(Clone, Debug)]
pub struct TextTokens {
    /// The tokens.
    pub tokens: Tokens,
    /// The diagnostics of reading them.
    pub found: Vec<Diag>,
    /// The place of the first literal.
    pub span: Span,
    /// The literals as written, at their position in their file.
    pub quoted: QuotedText,
}

/// A text that diagnostics quote.
#[derive(Clone, Debug)]
pub struct QuotedText {
    /// The path, as the user writes it.
    pub name: String,
    /// The text as written, with escapes, at its position in its file.
    pub written: String,
    /// For each token, its bytes in `written`.
    pub ranges: Vec<Range<usize>>,
}

/// Reads rules in string literals, one after the other.
///
/// # Errors
/// A literal is not a string, or the rules are too long.
pub fn read_text(literals: &[Literal]) -> Result<TextTokens, Problem> {
    let span = literals.first().map_or_else(Span::call_site, Literal::span);
    let (mut joined, mut borders) = (Joined::default(), Vec::new());
    for literal in literals {
        borders.push(joined.text.len());
        let Some(content) = Content::of(literal) else {
            let (place, help) = (literal.span(), "help: write \"…\" or r#\"…\"#");
            return Err(Problem::new(place, place, format!("the rules must be a string literal\n{help}")));
        };
        joined.push(&content, literal.span());
    }
    if MOST_BYTES < joined.text.len() {
        return Err(Problem::new(span, span, format!("the text cannot be read: {TOO_LONG}")));
    }
    let lexed = lex_joined(&joined.text, &borders);
    let name = span.file();
    // Editors' macro servers know no place.
    let name = if name.is_empty() { "rules".to_owned() } else { name };
    let ranges = lexed.ranges.iter().map(|range| joined.place(range)).collect();
    let quoted = QuotedText { name, written: joined.written, ranges };
    Ok(TextTokens { tokens: lexed.tokens, found: lexed.diags, span, quoted })
}

/// Literals one after the other.
#[derive(Default)]
struct Joined {
    /// The text after escapes are resolved.
    text: String,
    /// The literals as written. Blank lines and columns before each keep its position in its file.
    written: String,
    /// For each byte of `text`, the bytes of `written` its character takes.
    origin: Vec<Range<usize>>,
}

impl Joined {
    fn push(&mut self, content: &Content, span: Span) {
        let start = span.start();
        let line = 1 + self.written.matches('\n').count();
        self.written.push_str(&"\n".repeat(start.line.saturating_sub(line)));
        let column = self.written.rsplit('\n').next().map_or(0, |line| line.chars().count());
        self.written.push_str(&" ".repeat(start.column.saturating_sub(column)));
        let shift = self.written.len();
        self.origin.extend(content.origin.iter().map(|place| place.start + shift..place.end + shift));
        self.text.push_str(&content.text);
        self.written.push_str(&content.literal);
    }

    /// Where bytes of the text are written.
    fn place(&self, range: &Range<usize>) -> Range<usize> {
        let end = self.written.len();
        let first = self.origin.get(range.start).map_or(end, |place| place.start);
        let last = self.origin.get(range.end.saturating_sub(1)).map_or(end, |place| place.end);
        first..last.max(first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joined(literals: &[&str]) -> Joined {
        let mut joined = Joined::default();
        for literal in literals {
            let content = Content::of(&literal.parse().unwrap()).unwrap();
            joined.push(&content, Span::call_site());
        }
        joined
    }

    #[test]
    fn literals_are_joined_and_keep_their_places() {
        let joined = joined(&["\"Lot\\n -->\"", "r#\" \"ä\"#", "\" Wall.\""]);
        assert_eq!(joined.text, "Lot\n --> \"ä Wall.");
        for part in ["Lot", "-->", "ä", "Wall"] {
            let at = joined.text.find(part).unwrap();
            assert_eq!(&joined.written[joined.place(&(at..at + part.len()))], part);
        }
    }

    #[test]
    fn an_empty_range_stays_in_bounds() {
        let joined = joined(&["\"\""]);
        assert_eq!(joined.place(&(0..0)), 2..2);
    }
}
