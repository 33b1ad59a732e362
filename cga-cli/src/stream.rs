//! The standard streams. A reader may stop reading, as `head` does: the rest is dropped, and the command goes on.

use std::borrow::Cow;
use std::fmt::Display;
use std::io::{ErrorKind, IsTerminal as _, Result, Write, stderr, stdout};

/// A stream whose reader may stop reading.
pub(crate) struct Stream<W>(pub(crate) W);

impl<W: Write> Write for Stream<W> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        match self.0.write(bytes) {
            Err(why) if why.kind() == ErrorKind::BrokenPipe => Ok(bytes.len()),
            written => written,
        }
    }

    fn flush(&mut self) -> Result<()> {
        match self.0.flush() {
            Err(why) if why.kind() == ErrorKind::BrokenPipe => Ok(()),
            flushed => flushed,
        }
    }
}

/// Writes a line to standard error. A failure cannot be reported anywhere.
pub(crate) fn say(line: impl Display) {
    let _ = writeln!(stderr().lock(), "{}", visible(&line.to_string()));
}

/// A text for a person. Rules, maps and names of files may have characters that move the cursor of a terminal, change its colours or
/// turn the direction of writing. They are written as in Rust: `\u{1b}`.
pub(crate) fn visible(text: &str) -> Cow<'_, str> {
    let is_hidden = |c: char| {
        let turns =
            matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        turns || (c.is_control() && !matches!(c, '\n' | '\t'))
    };
    if !text.contains(is_hidden) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_hidden(c) { shown.extend(c.escape_default()) } else { shown.push(c) }
    }
    Cow::Owned(shown)
}

/// A [`visible`] text on one line.
pub(crate) fn visible_line(text: &str) -> String {
    visible(text).replace('\n', "\\n")
}

/// Writes lines that rules print to standard output: as they are to a file or a pipe, as [`visible`] text to a terminal.
///
/// # Errors
/// A sentence about the output.
pub(crate) fn print_lines(text: &str) -> std::result::Result<(), String> {
    if stdout().is_terminal() { print(&visible(text)) } else { print(text) }
}

/// Writes a text to standard output.
///
/// # Errors
/// A sentence about the output.
pub(crate) fn print(text: &str) -> std::result::Result<(), String> {
    let mut out = Stream(stdout().lock());
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|why| unwritten(&why))
}

/// The sentence for standard output that cannot be written.
pub(crate) fn unwritten(why: &std::io::Error) -> String {
    format!("cannot write to standard output: {why}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characters_that_act_on_a_terminal_are_shown() {
        assert_eq!(visible("Lot:\n\tbrück `窓` e\u{301}"), "Lot:\n\tbrück `窓` e\u{301}");
        assert_eq!(visible("\u{1b}[31mred\r\u{9b}2J\0\u{7f}"), "\\u{1b}[31mred\\r\\u{9b}2J\\u{0}\\u{7f}");
        assert_eq!(visible("a\u{202e}b\u{2066}c\u{2028}d\u{200f}"), "a\\u{202e}b\\u{2066}c\\u{2028}d\\u{200f}");
    }
}
