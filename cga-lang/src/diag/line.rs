//! Lines of diagnostics.

use std::fmt;

/// The sign of relative sizes in the lines of diagnostics. Sources spell it differently, so the sign is not a
/// character of any source.
pub const RELATIVE: char = '\u{FDD0}';

/// A line of a diagnostic: lower case, no full stop, names and code in backticks.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Line(String);

impl Line {
    /// The line with the source's sign of relative sizes.
    pub fn spelled(&self, relative: char) -> String {
        self.0.replace(RELATIVE, relative.encode_utf8(&mut [0; 4]))
    }
}

impl fmt::Display for Line {
    /// Writes the line in the spelling of text sources.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.spelled('\''))
    }
}

impl From<String> for Line {
    fn from(text: String) -> Line {
        Line(text)
    }
}

impl From<&str> for Line {
    fn from(text: &str) -> Line {
        Line(text.to_owned())
    }
}

/// Names in backticks, with commas between them.
pub(crate) fn quoted(names: impl IntoIterator<Item = impl fmt::Display>) -> String {
    names.into_iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// " by way of" the other names of a cycle, if there are any.
pub(crate) fn by_way_of(names: impl IntoIterator<Item = impl fmt::Display>) -> String {
    let names = quoted(names);
    if names.is_empty() { names } else { format!(" by way of {names}") }
}

/// A number of things: "no arguments", "1 argument", "2 arguments".
pub(crate) fn count(number: usize, thing: &str) -> String {
    match number {
        0 => format!("no {thing}s"),
        1 => format!("1 {thing}"),
        _ => format!("{number} {thing}s"),
    }
}

#[cfg(test)]
mod tests {
    use super::{Line, RELATIVE};

    #[test]
    fn relative_sizes_are_spelled_as_the_source_spells_them() {
        let line = Line::from(format!("write `{RELATIVE}0.3` for 30 % of the rule's scope"));
        assert_eq!(line.spelled('^'), "write `^0.3` for 30 % of the rule's scope");
        assert_eq!(line.to_string(), "write `'0.3` for 30 % of the rule's scope");
    }
}
