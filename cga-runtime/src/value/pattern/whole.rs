//! Patterns that must match a whole text, tried on many texts.

use super::{Pattern, Search};

/// A pattern for a whole text.
#[derive(Debug)]
pub(crate) struct Whole(Pattern);

impl Whole {
    /// Compiles a pattern. The error describes its fault.
    pub(crate) fn new(pattern: &str) -> Result<Self, String> {
        Pattern::whole(pattern).map(Whole)
    }

    /// Matches a text. Returns the result and the number of steps taken. A search that would take too long does not
    /// match.
    pub(crate) fn matches(&self, text: &str) -> (bool, u64) {
        let text: Vec<char> = text.chars().collect();
        let Ok(mut search) = Search::new(&self.0, &text) else { return (false, u64::MAX) };
        match search.find(0) {
            Ok(found) => (found.is_some(), search.steps()),
            Err(_) => (false, u64::MAX),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_left_over() {
        let matches = |pattern, text| Whole::new(pattern).expect("a pattern").matches(text).0;
        assert!(matches("a|ab", "ab") && matches("a|ab", "a") && matches("(?i)A.", "ab") && matches("", ""));
        assert!(!matches("a|ab", "abc") && !matches("b", "ab") && !matches("", "a") && !matches("a|b", "ab"));
        assert!(Whole::new("(").is_err());
        assert!(!matches("(?=(a|b)+c)*x", &"ab".repeat(10)));
    }
}
