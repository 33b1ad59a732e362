//! The parts of a JSON text: of the whole text, or line by line where each object has a line of its own.
//!
//! A broken line of such a file is one broken part, whatever its braces are.

use std::io::{BufRead, Cursor, Read as _};

use super::json_objects::{JsonObjects, MOST_BYTES, Part};

/// The byte before each text of a sequence (RFC 8142).
const SEPARATOR: u8 = 0x1e;

/// The parts of a text.
pub(super) enum JsonRecords<R> {
    /// Objects that may have any number of lines.
    Whole(JsonObjects<R>),
    /// Lines, or texts of a sequence.
    Lines(Lines<R>),
}

/// Lines, one by one.
pub(super) struct Lines<R> {
    input: R,
    /// The byte between two lines.
    separator: u8,
    /// The parts of the line that was read last.
    line: Option<JsonObjects<Cursor<Vec<u8>>>>,
    /// True if the line ends with its separator.
    is_ended: bool,
}

impl<R: BufRead> JsonRecords<R> {
    /// `is_lines` is true if the name of the file promises an object a line; other files with a line for each object are found by their first
    /// two lines.
    pub(super) fn new(mut input: R, is_lines: bool) -> Self {
        // An error is found again by the next read.
        let begin = input.fill_buf().unwrap_or_default();
        match separator(begin, is_lines) {
            Some(separator) => JsonRecords::Lines(Lines { input, separator, line: None, is_ended: true }),
            None => JsonRecords::Whole(JsonObjects::new(input)),
        }
    }
}

/// The byte between the lines of a text with an object a line, by its begin.
fn separator(begin: &[u8], is_lines: bool) -> Option<u8> {
    let text = begin.strip_prefix("\u{feff}".as_bytes()).unwrap_or(begin).trim_ascii_start();
    if text.first() == Some(&SEPARATOR) {
        return Some(SEPARATOR);
    }
    let end = text.iter().position(|byte| *byte == b'\n').unwrap_or(text.len());
    let (first, rest) = (&text[..end], text[end..].trim_ascii_start());
    let parts: Vec<Part> = JsonObjects::new(first).collect();
    let is_object = matches!(parts[..], [Part::Object(_)]);
    let opens_list =
        parts.iter().any(|part| matches!(part, Part::Head(_))) && matches!(parts.last(), Some(Part::End(_)));
    let is_found = match rest.first() {
        Some(b'{') => is_object || is_lines && !opens_list,
        // Without a second line in the buffer, the name counts.
        None => is_lines && !opens_list,
        Some(_) => is_lines && is_object,
    };
    is_found.then_some(b'\n')
}

impl<R: BufRead> Lines<R> {
    /// Reads the next line. False at the end of the file.
    fn read(&mut self) -> Result<bool, Part> {
        let mut line = Vec::new();
        let read = self.input.by_ref().take(MOST_BYTES as u64).read_until(self.separator, &mut line);
        read.map_err(|why| Part::End(why.to_string()))?;
        self.is_ended = line.last() == Some(&self.separator);
        if line.len() == MOST_BYTES && !self.is_ended {
            self.skip().map_err(|why| Part::End(why.to_string()))?;
            return Err(Part::Broken(format!("a line has more than {} MB", MOST_BYTES >> 20)));
        }
        let is_line = !line.is_empty();
        self.line = is_line.then(|| JsonObjects::of_line(Cursor::new(line)));
        Ok(is_line)
    }

    /// Skips the rest of a line.
    fn skip(&mut self) -> std::io::Result<()> {
        loop {
            let buffer = self.input.fill_buf()?;
            let end = buffer.iter().position(|byte| *byte == self.separator);
            let count = end.map_or(buffer.len(), |end| end + 1);
            self.input.consume(count);
            if end.is_some() || count == 0 {
                return Ok(());
            }
        }
    }
}

impl<R: BufRead> Iterator for Lines<R> {
    type Item = Part;

    fn next(&mut self) -> Option<Part> {
        loop {
            match self.line.as_mut().and_then(Iterator::next) {
                Some(Part::End(why)) if self.is_ended => return Some(Part::Broken(why)),
                Some(part) => return Some(part),
                None => match self.read() {
                    Ok(true) => {}
                    Ok(false) => return None,
                    Err(part) => return Some(part),
                },
            }
        }
    }
}

impl<R: BufRead> Iterator for JsonRecords<R> {
    type Item = Part;

    fn next(&mut self) -> Option<Part> {
        match self {
            JsonRecords::Whole(objects) => objects.next(),
            JsonRecords::Lines(lines) => lines.next(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(text: &str, is_lines: bool) -> Vec<String> {
        let shown = |part| match part {
            Part::Head(_) => "head".to_owned(),
            Part::Object(text) => String::from_utf8_lossy(&text).into_owned(),
            Part::Broken(why) => format!("broken: {why}"),
            Part::End(why) => format!("end: {why}"),
        };
        JsonRecords::new(text.as_bytes(), is_lines).map(shown).collect()
    }

    const BROKEN: &str = "broken: the line ends inside of this object";

    #[test]
    fn a_broken_line_is_one_part() {
        let text = "{\"a\": 1}\n{\"b\": {\"c\": \n\n{\"d\": 2}\nhello\n{\"e\": \"x}\n{\"f\": 3}\n";
        let hello = "broken: the line is not GeoJSON: it does not begin with `{`";
        let expected = ["{\"a\": 1}", BROKEN, "{\"d\": 2}", hello, BROKEN, "{\"f\": 3}"];
        assert_eq!(parts(text, true), expected);
        assert_eq!(parts(text, false), expected);
        // Only the name tells that the first line is broken.
        assert_eq!(parts("{\"a\": \n{\"d\": 2}\n", true), [BROKEN, "{\"d\": 2}"]);
        assert_eq!(parts("hello\n{\"d\": 2}\n", true)[1], "{\"d\": 2}");
    }

    #[test]
    fn texts_of_a_sequence_may_have_several_lines() {
        let text = "\u{1e}{\"a\":\n1}\n\u{1e}{\"b\":\n\u{1e}{\n\"c\": 1}\n";
        assert_eq!(parts(text, false), ["{\"a\":\n1}", BROKEN, "{\n\"c\": 1}"]);
    }

    #[test]
    fn a_last_line_without_its_end_ends_the_file() {
        assert_eq!(parts("{}\n{}\n{\"a\":", true)[2], "end: the line ends inside of this object");
        assert_eq!(parts("{}\n{}\n{\"a\":1}", true)[2], "{\"a\":1}");
    }

    #[test]
    fn a_collection_is_read_whole_whatever_its_name_promises() {
        for text in [
            "{\"features\": [\n{\"a\": 1},\n{\"a\": 2}\n]}\n",
            "{\n\"features\": [{\"a\": 1}, {\"a\": 2}]}",
            "{\"features\": [{\"a\": 1}, {\"a\": 2}]}",
        ] {
            for is_lines in [true, false] {
                assert_eq!(parts(text, is_lines), ["head", "{\"a\": 1}", "{\"a\": 2}"], "{text}");
            }
        }
        assert_eq!(parts("", true), [""; 0]);
    }
}
