//! `= r#"…"#`: rules in a string literal, in verbatim CGA.

use std::ops::Range;

use cga_lang::diag::Diag;
use cga_lang::lex::lex;
use cga_lang::token::Tokens;
use proc_macro2::{Literal, Span, TokenStream};

use super::{Place, Problem, Source, TextPlace};

pub(super) fn read(literal: &Literal) -> Result<Source, Problem> {
    let span = literal.span();
    let Some(content) = Content::of(literal) else {
        return Err(Problem::new(span, "the rules are a plain string literal: \"…\" or r#\"…\"#"));
    };
    let lexed = lex(&content.text);
    let start = span.start();
    let name = span.file();
    // Editors' macro servers know no place.
    let name = if name.is_empty() { "rules".to_owned() } else { name };
    // Blank lines and columns before it put the literal where it stands in its file.
    let before = "\n".repeat(start.line.saturating_sub(1)) + &" ".repeat(start.column);
    let shift = |range: &Range<usize>| {
        let place = content.written(range);
        place.start + before.len()..place.end + before.len()
    };
    let ranges = lexed.ranges.iter().map(shift).collect();
    let place = TextPlace { name, written: before.clone() + &content.literal, ranges };
    Ok(source(lexed.tokens, lexed.diags, span, place, TokenStream::new()))
}

/// A source behind a literal.
pub(super) fn source(
    tokens: Tokens,
    findings: Vec<Diag>,
    span: Span,
    text: TextPlace,
    tracking: TokenStream,
) -> Source {
    Source { tokens, findings, hosts: Vec::new(), place: Place::Text { span, text, tracking } }
}

/// The value of a string literal.
pub(super) fn value(literal: &Literal) -> Option<String> {
    Content::of(literal).map(|content| content.text)
}

/// A string literal: what it means and how it is written.
struct Content {
    literal: String,
    text: String,
    /// For each byte of `text`, the byte of `literal` it comes from; one more for the end.
    origin: Vec<usize>,
}

impl Content {
    fn of(literal: &Literal) -> Option<Self> {
        let written = literal.to_string();
        let raw = written.strip_prefix('r').map(|rest| rest.trim_start_matches('#'));
        match raw {
            Some(rest) if rest.starts_with('"') => {
                let hashes = written.len() - 1 - rest.len();
                let (from, to) = (2 + hashes, written.len().checked_sub(1 + hashes)?);
                let text = written.get(from..to)?.to_owned();
                Some(Content { origin: (from..=to).collect(), text, literal: written })
            }
            _ => Self::unescape(written),
        }
    }

    /// Rust's escapes, one by one, so that every character keeps its place.
    fn unescape(written: String) -> Option<Self> {
        let inner = written.strip_prefix('"')?.strip_suffix('"')?;
        let (mut text, mut origin) = (String::new(), Vec::new());
        let mut chars = inner.char_indices().peekable();
        while let Some((at, c)) = chars.next() {
            let meant = if c != '\\' {
                c
            } else {
                match chars.next()?.1 {
                    'n' => '\n',
                    'r' => '\r',
                    't' => '\t',
                    '0' => '\0',
                    'x' => {
                        let digits: String = chars.by_ref().take(2).map(|(_, c)| c).collect();
                        char::from_u32(u32::from_str_radix(&digits, 16).ok()?)?
                    }
                    'u' => {
                        let digits: String = chars.by_ref().map(|(_, c)| c).skip(1).take_while(|c| *c != '}').collect();
                        char::from_u32(u32::from_str_radix(&digits.replace('_', ""), 16).ok()?)?
                    }
                    '\n' | '\r' => {
                        // A line end after a backslash takes the white space after it away.
                        while chars.next_if(|(_, c)| c.is_whitespace()).is_some() {}
                        continue;
                    }
                    other => other,
                }
            };
            origin.extend(std::iter::repeat_n(at + 1, meant.len_utf8()));
            text.push(meant);
        }
        origin.push(written.len() - 1);
        Some(Content { literal: written, text, origin })
    }

    /// Where bytes of the text stand in the literal.
    fn written(&self, range: &Range<usize>) -> Range<usize> {
        let at = |byte: usize| self.origin.get(byte).copied().unwrap_or(self.literal.len());
        let end = if range.end == range.start { at(range.start) } else { at(range.end - 1) + 1 };
        // The end of a character, not its first byte.
        let end = (end..=self.literal.len()).find(|&end| self.literal.is_char_boundary(end)).unwrap_or(end);
        at(range.start)..end
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn content(written: &str) -> Content {
        Content::of(&written.parse().unwrap()).unwrap()
    }

    #[test]
    fn raw_strings_are_taken_as_they_are() {
        let content = content("r#\"a \\n \"b\"#");
        assert_eq!(content.text, "a \\n \"b");
        assert_eq!(&content.literal[content.written(&(5..7))], "\"b");
    }

    #[test]
    fn escapes_keep_their_places() {
        let content = content("\"a\\n\\u{e4}\\x41b\\\\c\"");
        assert_eq!(content.text, "a\näAb\\c");
        let at = content.text.find('b').unwrap();
        assert_eq!(&content.literal[content.written(&(at..at + 1))], "b");
        let at = content.text.find('c').unwrap();
        assert_eq!(&content.literal[content.written(&(at..at + 1))], "c");
    }

    #[test]
    fn other_literals_are_no_rules() {
        for other in ["b\"x\"", "'x'", "12", "c\"x\""] {
            assert!(Content::of(&other.parse().unwrap()).is_none(), "{other}");
        }
    }
}
