//! Lines of OBJ and MTL files, with any line endings.

/// The message for UTF-16.
pub const UTF_16: &str = "this is UTF-16; it must be UTF-8";

/// The lines of a file, each with its number from 1. Lines may end in LF, CR LF or CR. Comments and byte order marks
/// are removed; concatenated files have such marks inside.
pub fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let ends = |line| str::strip_suffix(line, '\r').unwrap_or(line).split('\r');
    let plain = |line| without_comment(str::trim_start_matches(line, '\u{feff}')).trim();
    text.split('\n').flat_map(ends).enumerate().map(move |(index, line)| (index + 1, plain(line)))
}

/// Removes a comment. A `#` begins a comment at the start of a word; inside a word it is part of a name.
fn without_comment(line: &str) -> &str {
    let mut before = b' ';
    let begins = |byte: u8| std::mem::replace(&mut before, byte).is_ascii_whitespace() && byte == b'#';
    line.bytes().position(begins).map_or(line, |at| &line[..at])
}

/// Returns true if bytes are UTF-16, by a byte order mark or by the first letters.
pub fn is_utf16(bytes: &[u8]) -> bool {
    match *bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => true,
        [a, b, c, d, ..] => [a == 0, b == 0] == [c == 0, d == 0] && (a == 0) != (b == 0),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_in_three_ways_and_comments_nowhere_else() {
        let text = "\u{feff}\u{feff}a\r\n b # c \\\r# d\rg#1\t#e\n\n\u{feff}f\\\r\n";
        let found: Vec<_> = lines(text).filter(|(_, line)| !line.is_empty()).collect();
        assert_eq!(found, [(1, "a"), (2, "b"), (4, "g#1"), (6, "f\\")]);
    }

    #[test]
    fn utf_16_is_known_by_its_first_letters() {
        for text in ["v 0 0 0", "\u{feff}v 0 0 0", "# \u{e9}"] {
            let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
            let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
            assert!(is_utf16(&little) && is_utf16(&big) && !is_utf16(text.as_bytes()), "{text}");
        }
        assert!(!is_utf16(b"") && !is_utf16(b"\0\0\0\0"));
    }
}
