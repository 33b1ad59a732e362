//! Decoding of rule files. Old files have the encoding of the editor that wrote them.

use std::borrow::Cow;

/// The maximum number of bytes of rules in one place. Checks take up to 500 bytes of memory for each of them. Published rule files are
/// smaller.
pub const MOST_BYTES: usize = 1_000_000;

/// The reason why rules with more bytes are not read.
pub const TOO_LONG: &str = "it has more than 1 MB; divide the rules into files that are imported";

/// Decodes a rule file. Text is UTF-8; invalid bytes are read as Windows-1252, the usual encoding of older editors. A
/// byte order mark selects UTF-16. Decoding never fails and removes the byte order mark.
///
/// ```
/// use cga_lang::syntax::lex::decode;
///
/// assert_eq!(decode(b"\xef\xbb\xbf# H\xc3\xb6he"), "# Höhe");
/// assert_eq!(decode(b"# H\xf6he"), "# Höhe");
/// assert_eq!(decode(b"\xff\xfeA\0"), "A");
/// ```
pub fn decode(bytes: &[u8]) -> Cow<'_, str> {
    match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => utf_8(rest),
        [0xff, 0xfe, rest @ ..] => Cow::Owned(utf_16(rest, u16::from_le_bytes)),
        [0xfe, 0xff, rest @ ..] => Cow::Owned(utf_16(rest, u16::from_be_bytes)),
        _ => utf_8(bytes),
    }
}

/// Decodes piece by piece, because a file may have been edited in several encodings.
fn utf_8(bytes: &[u8]) -> Cow<'_, str> {
    if let Ok(text) = std::str::from_utf8(bytes) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(bytes.len() + bytes.len() / 8);
    for chunk in bytes.utf8_chunks() {
        out.push_str(chunk.valid());
        out.extend(chunk.invalid().iter().map(|&byte| windows_1252(byte)));
    }
    Cow::Owned(out)
}

fn utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let units = bytes.chunks(2).map(|pair| match *pair {
        [first, second] => unit([first, second]),
        // An odd byte at the end.
        _ => 0xfffd,
    });
    char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}

/// Latin-1, with letters and signs in place of its control characters.
fn windows_1252(byte: u8) -> char {
    const HIGH: [char; 32] = [
        '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘',
        '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
    ];
    match byte {
        0x80..0xa0 => HIGH[usize::from(byte - 0x80)],
        _ => char::from(byte),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utf_8_is_not_copied() {
        for text in ["", "Lot --> NIL", "# größer ≥ 窗 😀", "\u{0}\u{7f}"] {
            assert!(matches!(decode(text.as_bytes()), Cow::Borrowed(same) if same == text), "{text}");
        }
    }

    #[test]
    fn a_byte_order_mark_goes() {
        assert_eq!(decode(b"\xef\xbb\xbf"), "");
        assert_eq!(decode(b"\xff\xfe"), "");
        assert_eq!(decode(b"\xfe\xff\x00A\x00\xe4"), "Aä");
        assert_eq!(decode(b"\xff\xfeA\x00\xe4\x00=\xd8\x00\xde"), "Aä😀");
    }

    #[test]
    fn broken_utf_16_is_shown_as_such() {
        assert_eq!(decode(b"\xff\xfeA\x00\x00\xd8B\x00"), "A\u{fffd}B");
        assert_eq!(decode(b"\xff\xfeA\x00B"), "A\u{fffd}");
    }

    #[test]
    fn other_bytes_are_windows_1252() {
        assert_eq!(decode(b"# gr\xf6\xdfer \x80 \x93x\x94 \x81"), "# größer € “x” \u{81}");
        // Both encodings in one file.
        assert_eq!(decode(b"# \xc3\xa4 \xe4 \xe2\x82\xac \x80"), "# ä ä € €");
        // A character cut off at the end.
        assert_eq!(decode(b"A\xe2\x82"), "Aâ‚");
    }

    #[test]
    fn every_byte_gives_one_character() {
        let all: Vec<u8> = (0x80..=0xff).collect();
        assert_eq!(decode(&all).chars().count(), 128);
    }
}
