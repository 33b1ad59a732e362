//! The objects of a JSON text, one after another, without the text in memory.
//!
//! Each object is cut out by its braces, so a feature that is not JSON, for example with `NaN`, does not end the file.

use std::io::{BufRead, ErrorKind};

/// The most bytes of one object.
pub(super) const MOST_BYTES: usize = 256 << 20;

/// An element of the list `features`, or an object outside of such a list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// The text up to the list `features`, closed so that it is JSON.
    Head(Vec<u8>),
    /// The text of an object.
    Object(Vec<u8>),
    /// The reason why an element is not an object. Others may follow.
    Broken(String),
    /// The reason why the text ends here.
    End(String),
}

/// The objects of a text.
pub(super) struct JsonObjects<R> {
    input: R,
    /// The bytes of the object or of the head.
    text: Vec<u8>,
    /// True inside of the list `features`.
    is_list: bool,
    /// True after the first part.
    is_begun: bool,
    /// True after the end of the text or a reason to stop.
    is_over: bool,
    /// The name of the text in reasons: a file or a line.
    kind: &'static str,
}

impl<R: BufRead> JsonObjects<R> {
    pub(super) fn new(input: R) -> Self {
        JsonObjects { input, text: Vec::new(), is_list: false, is_begun: false, is_over: false, kind: "file" }
    }

    /// The objects of a line.
    pub(super) fn of_line(input: R) -> Self {
        JsonObjects { kind: "line", ..JsonObjects::new(input) }
    }

    fn byte(&mut self) -> Result<Option<u8>, String> {
        loop {
            match self.input.fill_buf() {
                Ok([]) => return Ok(None),
                Ok(bytes) => {
                    let byte = bytes[0];
                    self.input.consume(1);
                    return Ok(Some(byte));
                }
                Err(why) if why.kind() == ErrorKind::Interrupted => {}
                Err(why) => return Err(why.to_string()),
            }
        }
    }

    /// The next byte that is not a space, a comma, a mark of an encoding or the separator of records.
    fn begin(&mut self) -> Result<Option<u8>, String> {
        loop {
            match self.byte()? {
                Some(b' ' | b'\t' | b'\r' | b'\n' | b',' | 0x1e | 0xef | 0xbb | 0xbf) => {}
                other => return Ok(other),
            }
        }
    }

    /// Reads the rest of an object after its first brace. Returns true at the end, and false where its list `features` begins.
    fn object(&mut self) -> Result<bool, String> {
        let (mut depth, mut in_text, mut escaped, mut name_begins, mut key) = (1usize, false, false, 0, Vec::new());
        loop {
            let byte = self.byte()?.ok_or_else(|| format!("the {} ends inside of this object", self.kind))?;
            if MOST_BYTES <= self.text.len() {
                return Err(format!("an object has more than {} MB", MOST_BYTES >> 20));
            }
            self.text.push(byte);
            if in_text {
                match byte {
                    _ if escaped => escaped = false,
                    b'\\' => escaped = true,
                    b'"' => {
                        in_text = false;
                        if depth == 1 {
                            key = self.text[name_begins..self.text.len() - 1].to_vec();
                        }
                    }
                    _ => {}
                }
                continue;
            }
            match byte {
                b'"' => (in_text, name_begins) = (true, self.text.len()),
                b'[' if depth == 1 && key == b"features" && !self.is_list => return Ok(false),
                b'{' | b'[' => depth += 1,
                b'}' | b']' => {
                    depth -= 1;
                    if depth == 0 {
                        return Ok(true);
                    }
                }
                _ => {}
            }
        }
    }

    /// Skips an element of the list that begins with a byte and is not an object, up to the next comma or the end of the list.
    fn skip(&mut self, first: u8) -> Result<(), String> {
        let (mut depth, mut in_text, mut escaped) = (usize::from(first == b'['), first == b'"', false);
        loop {
            let at_end = match self.input.fill_buf().map_err(|why| why.to_string())?.first() {
                None => return Err(self.ends_in_list()),
                Some(_) if in_text => false,
                Some(b',') => depth == 0,
                Some(b']' | b'}') if depth == 0 => true,
                Some(_) => false,
            };
            if at_end {
                return Ok(());
            }
            match self.byte()? {
                _ if escaped => escaped = false,
                Some(b'\\') => escaped = in_text,
                Some(b'"') => in_text = !in_text,
                Some(b'[' | b'{') if !in_text => depth += 1,
                Some(b']' | b'}') if !in_text => depth -= 1,
                _ => {}
            }
        }
    }

    fn part(&mut self) -> Result<Option<Part>, String> {
        let mut first = self.begin()?;
        while self.is_list && first == Some(b']') {
            // Another list may follow in this object, and another object after it.
            self.text.clear();
            self.text.push(b'{');
            self.is_list = false;
            self.is_list = !self.object()?;
            first = self.begin()?;
        }
        match first {
            None if self.is_list => Err(self.ends_in_list()),
            None => Ok(None),
            Some(b'{') => {
                self.text.clear();
                self.text.push(b'{');
                let is_whole = self.object()?;
                let mut text = std::mem::take(&mut self.text);
                if is_whole {
                    return Ok(Some(Part::Object(text)));
                }
                self.is_list = true;
                text.extend(b"]}");
                Ok(Some(Part::Head(text)))
            }
            Some(first) if self.is_list => {
                self.skip(first)?;
                Ok(Some(Part::Broken("it is not an object".to_owned())))
            }
            Some(_) if self.is_begun => Err("the text after this place is not an object of JSON".to_owned()),
            Some(_) => Err(format!("the {} is not GeoJSON: it does not begin with `{{`", self.kind)),
        }
    }

    fn ends_in_list(&self) -> String {
        format!("the {} ends inside of its list of features", self.kind)
    }
}

impl<R: BufRead> Iterator for JsonObjects<R> {
    type Item = Part;

    fn next(&mut self) -> Option<Part> {
        if self.is_over {
            return None;
        }
        match self.part() {
            Ok(part) => {
                self.is_over |= part.is_none();
                self.is_begun = true;
                part
            }
            Err(why) => {
                self.is_over = true;
                Some(Part::End(why))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(text: &str) -> Vec<String> {
        let shown = |part| match part {
            Part::Head(text) => format!("head {}", String::from_utf8_lossy(&text)),
            Part::Object(text) => String::from_utf8_lossy(&text).into_owned(),
            Part::Broken(why) => format!("broken: {why}"),
            Part::End(why) => format!("end: {why}"),
        };
        JsonObjects::new(text.as_bytes()).map(shown).collect()
    }

    #[test]
    fn features_are_cut_out_of_their_list() {
        let text = "\u{feff}{\"a\": {\"features\": [1]}, \"features\": [ {\"b\": \"}\\\"\"}, 7, [1, {}], {\"c\": NaN} ], \"d\": 1}";
        let expected = [
            "head {\"a\": {\"features\": [1]}, \"features\": []}",
            "{\"b\": \"}\\\"\"}",
            "broken: it is not an object",
            "broken: it is not an object",
            "{\"c\": NaN}",
        ];
        assert_eq!(parts(text), expected);
    }

    #[test]
    fn objects_may_follow_each_other_without_a_list() {
        assert_eq!(parts("{\"a\": 1}\n{\"b\": [2]}\n"), ["{\"a\": 1}", "{\"b\": [2]}"]);
        assert_eq!(parts(""), [""; 0]);
    }

    #[test]
    fn what_follows_a_list_is_read() {
        let collection = "{\"features\": [{\"a\": 1}], \"d\": [2]}";
        let (head, one) = ("head {\"features\": []}", "{\"a\": 1}");
        assert_eq!(parts(&format!("{one}{collection}\n{collection}{one}")), [one, head, one, head, one, one]);
        assert_eq!(parts("{\"features\": [{\"a\": 1}], \"features\": [{\"a\": 1}]}"), [head, one, one]);
        assert_eq!(parts("{\"features\": [] ").last().unwrap(), "end: the file ends inside of this object");
        assert_eq!(parts(&format!("{{{}\"b\": 1}}", "\"features\": [],".repeat(50_000))), [head]);
    }

    #[test]
    fn a_file_that_ends_early_ends_with_a_reason() {
        assert_eq!(
            parts("{\"features\": [{\"a\": 1}").last().unwrap(),
            "end: the file ends inside of its list of features"
        );
        assert_eq!(parts("{\"features\": [{\"a\": 1").last().unwrap(), "end: the file ends inside of this object");
        assert_eq!(parts("hello"), ["end: the file is not GeoJSON: it does not begin with `{`"]);
        assert_eq!(parts("{} hello").last().unwrap(), "end: the text after this place is not an object of JSON");
    }
}
