//! Text from rules, files and the host in messages.

use crate::value::text::shortened;

/// The text, shortened and [escaped](escaped) for a message.
pub(crate) fn shown(text: &str) -> String {
    escaped(&shortened(text))
}

/// The text as a message quotes it, between backticks on one line. Line ends, the escapes of terminals and other characters that are
/// not printable are written as in Rust (`\n`, `\u{1b}`), with backslashes doubled, and a backtick does not end the quotation.
pub(crate) fn escaped(text: &str) -> String {
    // Between backticks the other quotes stay.
    text.escape_debug().to_string().replace("\\'", "'").replace("\\\"", "\"").replace('`', "\\`")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_of_a_message_stays_on_its_line() {
        assert_eq!(escaped("maps/brick wall #2 (ä, 窓).png"), "maps/brick wall #2 (ä, 窓).png");
        assert_eq!(escaped("it's \"x\""), "it's \"x\"");
        assert_eq!(escaped("a\r\nb\t\u{1b}[31mc\0"), r"a\r\nb\t\u{1b}[31mc\0");
        assert_eq!(escaped(r"a\'b"), r"a\\'b");
        assert_eq!(escaped("a` is fine; `b"), r"a\` is fine; \`b");
        // A line end of Unicode, and a mark that turns the direction of writing.
        assert_eq!(escaped("a\u{2028}b\u{202e}c"), r"a\u{2028}b\u{202e}c");
    }

    #[test]
    fn long_text_is_cut_before_it_is_escaped() {
        assert_eq!(shown(&"\n".repeat(100)), format!("{}…", "\\n".repeat(80)));
    }
}
