//! Lines and columns of a text.

use super::border;

/// A place in a text for people: lines and columns count from 1, columns in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position {
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
}

/// The starts of the lines of a text, computed once for all places.
///
/// ```
/// use cga_lang::snippet::{Lines, Position};
///
/// let lines = Lines::new("Lot -->\n  NIL");
/// assert_eq!(lines.position(10), Position { line: 2, column: 3 });
/// ```
#[derive(Clone, Debug)]
pub struct Lines<'t> {
    text: &'t str,
    /// The first byte of each line after the first.
    starts: Vec<usize>,
}

impl<'t> Lines<'t> {
    /// Finds the lines of a text. Old files end them with `\r`, or mix the endings.
    pub fn new(text: &'t str) -> Self {
        let bytes = text.as_bytes();
        // No other character contains these bytes.
        let is_end = |at: usize| match bytes[at] {
            b'\n' => true,
            b'\r' => bytes.get(at + 1) != Some(&b'\n'),
            _ => false,
        };
        Lines { text, starts: (0..bytes.len()).filter(|&at| is_end(at)).map(|at| at + 1).collect() }
    }

    /// Returns the text.
    pub fn text(&self) -> &'t str {
        self.text
    }

    /// Returns the line and column of a byte. A byte after the end of the text has the place of the end.
    pub fn position(&self, byte: usize) -> Position {
        let byte = border(self.text, byte);
        let before = self.starts.partition_point(|&start| start <= byte);
        let start = before.checked_sub(1).map_or(0, |line| self.starts[line]);
        let column = self.text[start..byte].trim_start_matches('\u{feff}').chars().count() + 1;
        Position { line: before + 1, column }
    }
}

#[cfg(test)]
mod tests {
    use super::{Lines, Position};

    #[test]
    fn lines_end_in_every_way() {
        let text = "a\rb\r\nc\nd\n\re";
        let lines = Lines::new(text);
        let places = ["a", "b", "c", "d", "e"].map(|name| lines.position(text.find(name).unwrap()));
        assert_eq!(places.map(|place| (place.line, place.column)), [(1, 1), (2, 1), (3, 1), (4, 1), (6, 1)]);
    }

    #[test]
    fn the_end_of_a_line_belongs_to_it() {
        let lines = Lines::new("ab\r\nc");
        let places = [2, 3, 4, 5, 9].map(|byte| lines.position(byte));
        assert_eq!(places.map(|place| (place.line, place.column)), [(1, 3), (1, 4), (2, 1), (2, 2), (2, 2)]);
    }

    #[test]
    fn columns_count_characters() {
        let lines = Lines::new("\u{feff}ä🏠b");
        assert_eq!(lines.position(9), Position { line: 1, column: 3 });
        assert_eq!(lines.position(6), Position { line: 1, column: 2 }, "inside the house");
        assert_eq!(Lines::new("").position(3), Position { line: 1, column: 1 });
    }
}
