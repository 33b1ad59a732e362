//! Findings with their places in the text.

use std::ops::Range;

use cga_lang::compile::compile_text;
use cga_lang::diag::Level;
use cga_lang::snippet::{Lines, bytes};
use serde::ser::{Serialize, SerializeStruct, Serializer};

/// A diagnostic of a rule text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// True for an error, false for a warning.
    pub is_error: bool,
    /// The name of its code: a heading of `docs/diagnostics.md`.
    pub code: &'static str,
    /// The problem.
    pub message: String,
    /// The place, counted in UTF-16 units as JavaScript counts.
    pub place: Range<usize>,
    /// The line, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
    /// The reasons.
    pub notes: Vec<String>,
    /// The text to type.
    pub help: Vec<String>,
}

impl Serialize for Finding {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Finding { is_error, code, message, place, line, column, notes, help } = self;
        let mut fields = serializer.serialize_struct("Finding", 9)?;
        fields.serialize_field("level", if *is_error { "error" } else { "warning" })?;
        fields.serialize_field("code", code)?;
        fields.serialize_field("message", message)?;
        fields.serialize_field("start", &place.start)?;
        fields.serialize_field("end", &place.end)?;
        fields.serialize_field("line", line)?;
        fields.serialize_field("column", column)?;
        fields.serialize_field("notes", notes)?;
        fields.serialize_field("help", help)?;
        fields.end()
    }
}

/// The findings of a text, in its order.
pub fn findings(text: &str) -> Vec<Finding> {
    let source = compile_text(text);
    let (units, lines) = (Units::new(text), Lines::new(text));
    let diags = source.compiled.diags.iter().filter(|diag| diag.level != Level::Allow);
    let list = diags.map(|diag| {
        let range = bytes(text, &source.ranges, diag.span);
        let start = lines.position(range.start);
        let note = |note: cga_lang::diag::Note| match note.related {
            Some(span) => {
                let line = lines.position(bytes(text, &source.ranges, span).start).line;
                format!("{} in line {line}", note.text)
            }
            None => note.text.to_string(),
        };
        Finding {
            is_error: diag.level == Level::Error,
            code: diag.code.name(),
            message: diag.message.to_string(),
            place: units.at(range.start)..units.at(range.end),
            line: start.line,
            column: start.column,
            notes: diag.reasons().map(note).collect(),
            help: diag.help.iter().map(ToString::to_string).collect(),
        }
    });
    list.collect()
}

/// The UTF-16 units before places of a text.
struct Units<'t> {
    text: &'t str,
    /// The units before every 1,024th byte, or before the character around it.
    marks: Vec<usize>,
}

/// The bytes between two marks.
const STEP: usize = 1024;

impl<'t> Units<'t> {
    fn new(text: &'t str) -> Self {
        let (mut marks, mut units) = (Vec::with_capacity(text.len() / STEP + 1), 0);
        for (byte, c) in text.char_indices() {
            while marks.len() * STEP < byte + c.len_utf8() {
                marks.push(units);
            }
            units += c.len_utf16();
        }
        Units { text, marks }
    }

    /// The units before a byte at the border of a character.
    fn at(&self, byte: usize) -> usize {
        let Some(last) = self.marks.len().checked_sub(1) else { return 0 };
        let mark = last.min(byte / STEP);
        let start = (0..=mark * STEP).rev().find(|&start| self.text.is_char_boundary(start)).unwrap_or(0);
        self.marks[mark] + self.text[start..byte.max(start)].chars().map(char::len_utf16).sum::<usize>()
    }
}

#[cfg(test)]
mod tests {
    use super::{STEP, Units, findings};

    #[test]
    fn a_finding_has_its_place_in_utf16() {
        let text = "# 🏠 Häuser\nLot --> print(\"🏠\") extrude(3) Wal\nWall --> NIL\n";
        let list = findings(text);
        let found = list.iter().find(|finding| finding.code == "undefined_rule").expect("a finding");
        let units: Vec<u16> = text.encode_utf16().collect();
        assert_eq!(String::from_utf16_lossy(&units[found.place.clone()]), "Wal");
        assert_eq!((found.line, found.is_error), (2, false));
        assert_eq!(found.help[0], "did you mean `Wall`?");
    }

    #[test]
    fn units_are_those_of_javascript() {
        for unit in ["a", "ä", "漢", "🏠", "ab漢🏠ä"] {
            let text = unit.repeat(3 * STEP / unit.len() + 5);
            let units = Units::new(&text);
            for (byte, _) in text.char_indices().chain([(text.len(), ' ')]) {
                assert_eq!(units.at(byte), text[..byte].encode_utf16().count(), "{unit} at {byte}");
            }
        }
        assert_eq!(Units::new("").at(0), 0);
    }

    #[test]
    fn a_second_place_is_named_by_its_line() {
        let list = findings("A --> NIL\nA --> NIL");
        assert_eq!((list[0].code, list[0].is_error), ("duplicate_name", true));
        assert_eq!(list[0].notes, ["first declared in line 1"]);
    }

    #[test]
    fn right_rules_have_no_findings() {
        assert_eq!(findings("Lot --> extrude(3) Mass."), []);
        assert_eq!(findings(""), findings(" "));
    }
}
