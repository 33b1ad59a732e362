//! Lines and columns of a text.

use std::ops::Range;

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
    /// The number of characters that begin before each block of [`BLOCK`] bytes: a file may have one long line.
    before: Vec<usize>,
}

/// The number of bytes in which characters are counted one by one.
const BLOCK: usize = 256;

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
        let starts = (0..bytes.len()).filter(|&at| is_end(at)).map(|at| at + 1).collect();
        let mut count = 0;
        let blocks = bytes.chunks(BLOCK).map(|block| {
            let before = count;
            count += characters(block);
            before
        });
        Lines { text, starts, before: blocks.collect() }
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
        let start = start + mark(&self.text[start..byte]);
        Position { line: before + 1, column: self.characters_before(byte) - self.characters_before(start) + 1 }
    }

    /// Returns the bytes of the line of a byte, without its end and without the mark of an encoding before it.
    pub(super) fn line(&self, byte: usize) -> Range<usize> {
        let before = self.starts.partition_point(|&start| start <= byte);
        let start = before.checked_sub(1).map_or(0, |line| self.starts[line]);
        let end = self.starts.get(before).map_or(self.text.len(), |&next| {
            let line = &self.text[start..next];
            next - (line.len() - line.trim_end_matches(['\n', '\r']).len())
        });
        (start + mark(&self.text[start..end])).min(end)..end
    }

    /// The number of characters that begin before a byte.
    fn characters_before(&self, byte: usize) -> usize {
        let block = byte / BLOCK;
        let before = self.before.get(block).or(self.before.last()).copied().unwrap_or_default();
        let first = block.min(self.before.len().saturating_sub(1)) * BLOCK;
        before + characters(&self.text.as_bytes()[first..byte])
    }
}

/// The number of characters that begin in some bytes of a text.
fn characters(bytes: &[u8]) -> usize {
    bytes.iter().filter(|byte| (**byte & 0b1100_0000) != 0b1000_0000).count()
}

/// The length of the marks of an encoding at the start of a line.
fn mark(line: &str) -> usize {
    line.len() - line.trim_start_matches('\u{feff}').len()
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

    /// Lines as long as a file may be are found as fast as short ones; see `snippet::tests`.
    #[test]
    fn positions_are_counted_from_the_start_of_the_line() {
        let mut text = "\u{feff}".to_owned();
        for number in 0..700 {
            text.push_str(
                ["a", "ä", "🏠", "\t", "b\n", "\r\n", "\r"][number * number % 61 % if number < 300 { 4 } else { 7 }],
            );
        }
        let lines = Lines::new(&text);
        for (byte, _) in text.char_indices() {
            let before = &text[..byte];
            let ends = before.replace("\r\n", " \n").replace('\r', "\n");
            // Between `\r` and `\n` the line has not ended.
            let ends =
                if before.ends_with('\r') && text[byte..].starts_with('\n') { &ends[..ends.len() - 1] } else { &ends };
            let start = ends.rfind('\n').map_or(0, |end| end + 1);
            let column = before[start..].trim_start_matches('\u{feff}').chars().count() + 1;
            assert_eq!(lines.position(byte), Position { line: 1 + ends.matches('\n').count(), column }, "{byte}");
            let line = lines.line(byte);
            let rest = text[line.start..].find(['\n', '\r']).map_or(text.len(), |end| line.start + end);
            assert!(line.end == rest && line.start <= byte.max(line.start), "{byte}");
        }
    }
}
