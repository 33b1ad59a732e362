//! A string literal: what it means, and where each of its characters is written.

use std::ops::Range;

use proc_macro2::Literal;

/// A string literal: what it means and how it is written.
pub(crate) struct Content {
    /// As written, quotes and escapes and all.
    pub(crate) literal: String,
    /// The text after its escapes are resolved.
    pub(crate) text: String,
    /// For each byte of `text`, the bytes of `literal` that its character takes.
    pub(crate) origin: Vec<Range<usize>>,
}

/// The value of a string literal; `None` for a literal of another kind.
pub fn value(literal: &Literal) -> Option<String> {
    Content::of(literal).map(|content| content.text)
}

impl Content {
    /// Reads a literal; `None` if it is not a plain string.
    pub(crate) fn of(literal: &Literal) -> Option<Self> {
        let literal = literal.to_string();
        let mut content = Content { text: String::new(), origin: Vec::new(), literal: String::new() };
        match literal.strip_prefix('r') {
            Some(rest) => {
                let hashes = rest.len() - rest.trim_start_matches('#').len();
                let inner = rest.get(hashes..rest.len().checked_sub(hashes)?)?;
                let inner = inner.strip_prefix('"')?.strip_suffix('"')?;
                let start = 2 + hashes;
                inner.char_indices().for_each(|(at, c)| content.push(c, start + at..start + at + c.len_utf8()));
            }
            None => content.unescape(literal.strip_prefix('"')?.strip_suffix('"')?)?,
        }
        Some(Content { literal, ..content })
    }

    fn push(&mut self, c: char, origin: Range<usize>) {
        self.origin.extend(std::iter::repeat_n(origin, c.len_utf8()));
        self.text.push(c);
    }

    /// Rust's escapes, one by one, so that every character keeps its place.
    fn unescape(&mut self, inner: &str) -> Option<()> {
        let mut at = 0;
        while let Some(c) = inner[at..].chars().next() {
            let (meant, taken) = match c {
                '\\' => escape(&inner[at..])?,
                c => (Some(c), c.len_utf8()),
            };
            if let Some(meant) = meant {
                // One more for the quote.
                self.push(meant, at + 1..at + 1 + taken);
            }
            at += taken;
        }
        Some(())
    }
}

/// The characters of an escape sequence, and its length in bytes.
fn escape(text: &str) -> Option<(Option<char>, usize)> {
    let code = |digits: &str| char::from_u32(u32::from_str_radix(digits, 16).ok()?);
    let kind = text.chars().nth(1)?;
    Some(match kind {
        'n' => (Some('\n'), 2),
        'r' => (Some('\r'), 2),
        't' => (Some('\t'), 2),
        '0' => (Some('\0'), 2),
        'x' => (Some(code(text.get(2..4)?)?), 4),
        'u' => {
            let end = text.find('}')?;
            (Some(code(&text.get(3..end)?.replace('_', ""))?), end + 1)
        }
        // A line end after a backslash takes the white space after it away.
        '\n' | '\r' => (None, text.len() - text[1..].trim_start_matches([' ', '\t', '\n', '\r']).len()),
        other => (Some(other), 1 + other.len_utf8()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn content(written: &str) -> Content {
        Content::of(&written.parse().unwrap()).unwrap()
    }

    /// The spelling of the last character of the first `part` in the text.
    fn last_written(content: &Content, part: &str) -> String {
        let end = content.text.find(part).unwrap() + part.len();
        content.literal[content.origin[end - 1].clone()].to_owned()
    }

    #[test]
    fn raw_strings_are_taken_as_they_are() {
        let content = content("r#\"a \\n \"b\"#");
        assert_eq!(content.text, "a \\n \"b");
        assert_eq!(last_written(&content, "b"), "b");
    }

    #[test]
    fn escapes_keep_their_places() {
        let content = content("\"a\\n\\u{e4}\\x41b\\\\c\"");
        assert_eq!(content.text, "a\näAb\\c");
        for (part, written) in
            [("a\n", "\\n"), ("ä", "\\u{e4}"), ("A", "\\x41"), ("b", "b"), ("\\", "\\\\"), ("c", "c")]
        {
            assert_eq!(last_written(&content, part), written);
        }
    }

    #[test]
    fn a_backslash_at_the_end_of_a_line_joins_lines() {
        let content = content("\"a \\\n   b\"");
        assert_eq!(content.text, "a b");
        assert_eq!(last_written(&content, "b"), "b");
    }

    #[test]
    fn other_literals_are_no_rules() {
        for other in ["b\"x\"", "'x'", "12", "c\"x\"", "br\"x\"", "\"x\"y"] {
            assert!(Content::of(&other.parse().unwrap()).is_none(), "{other}");
        }
    }
}
