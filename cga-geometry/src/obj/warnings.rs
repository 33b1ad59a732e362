//! The warnings about a file, limited in number.

/// The largest number of warnings of a file.
const MOST: usize = 100;

/// The largest number of characters of a name in a warning.
const NAME: usize = 40;

/// The first warnings of a file.
#[derive(Clone, Debug, Default)]
pub struct Warnings {
    list: Vec<String>,
    /// Warnings beyond [`MOST`].
    more: usize,
}

impl Warnings {
    /// Adds a sentence, or only counts it beyond the limit.
    pub fn add(&mut self, sentence: impl FnOnce() -> String) {
        if self.list.len() < MOST {
            self.list.push(sentence());
        } else {
            self.more += 1;
        }
    }

    /// The sentences. Beyond the limit, the last sentence gives the number of the others.
    pub fn finish(mut self) -> Vec<String> {
        if self.more != 0 {
            self.list.truncate(MOST - 1);
            self.list.push(format!("there are {} more warnings", self.more + 1));
        }
        self.list
    }
}

/// The text, shortened to a number of characters.
pub fn shortened_to(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// The text as a message quotes it, between backticks on one line. Line ends, the escapes of terminals and other characters that are
/// not printable are written as in Rust (`\n`, `\u{1b}`), with backslashes doubled, and a backtick does not end the quotation.
pub fn escaped(text: &str) -> String {
    // Between backticks the other quotes stay.
    text.escape_debug().to_string().replace("\\'", "'").replace("\\\"", "\"").replace('`', "\\`")
}

/// The start of a name, escaped for a message.
pub fn short(name: &str) -> String {
    escaped(&shortened_to(name, NAME))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warnings_beyond_the_limit_are_counted() {
        for count in [0, 1, MOST - 1, MOST] {
            let mut warnings = Warnings::default();
            (0..count).for_each(|i| warnings.add(|| i.to_string()));
            assert_eq!(warnings.finish().len(), count);
        }
        let mut warnings = Warnings::default();
        (0..1_000).for_each(|i| warnings.add(|| i.to_string()));
        let list = warnings.finish();
        assert_eq!((list.len(), list[98].as_str(), list[99].as_str()), (MOST, "98", "there are 901 more warnings"));
    }

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
    fn long_names_are_cut_between_characters() {
        assert_eq!(short("brick"), "brick");
        assert_eq!(short("brick\u{1b}[2J"), r"brick\u{1b}[2J");
        assert_eq!(short(&"ä".repeat(40)), "ä".repeat(40));
        assert_eq!(short(&"ä".repeat(1_000_000)), format!("{}…", "ä".repeat(40)));
    }
}
