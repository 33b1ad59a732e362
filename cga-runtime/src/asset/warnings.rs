//! The warnings about a file, limited in number.

use crate::value::shown::escaped;
use crate::value::text::shortened_to;

/// The largest number of warnings of a file.
pub(super) const MOST: usize = 100;

/// The largest number of characters of a name in a warning.
const NAME: usize = 40;

/// The first warnings of a file.
#[derive(Default)]
pub(super) struct Warnings {
    list: Vec<String>,
    /// Warnings beyond [`MOST`].
    more: usize,
}

impl Warnings {
    /// Adds a sentence, or only counts it beyond the limit.
    pub(super) fn add(&mut self, sentence: impl FnOnce() -> String) {
        if self.list.len() < MOST {
            self.list.push(sentence());
        } else {
            self.more += 1;
        }
    }

    /// The sentences. Beyond the limit, the last sentence gives the number of the others.
    pub(super) fn finish(mut self) -> Vec<String> {
        if self.more != 0 {
            self.list.truncate(MOST - 1);
            self.list.push(format!("there are {} more warnings", self.more + 1));
        }
        self.list
    }
}

/// The start of a name, escaped for a message.
pub(super) fn short(name: &str) -> String {
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
    fn long_names_are_cut_between_characters() {
        assert_eq!(short("brick"), "brick");
        assert_eq!(short("brick\u{1b}[2J"), r"brick\u{1b}[2J");
        assert_eq!(short(&"ä".repeat(40)), "ä".repeat(40));
        assert_eq!(short(&"ä".repeat(1_000_000)), format!("{}…", "ä".repeat(40)));
    }
}
