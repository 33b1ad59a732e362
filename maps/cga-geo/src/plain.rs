//! Texts of files for messages.

use std::fmt::Write as _;

/// A text on one line for a terminal: at most a number of characters, without control characters and without marks that change the direction
/// of writing.
///
/// ```
/// assert_eq!(cga_geo::plain::plain("a\u{1b}[2Jb\nc", 80), "a\\u{1b}[2Jb\\nc");
/// assert_eq!(cga_geo::plain::plain("Lindenstraße", 6), "Linden…");
/// ```
pub fn plain(text: &str, most: usize) -> String {
    let mut out = String::new();
    for (count, character) in text.chars().enumerate() {
        if count == most {
            out.push('…');
            break;
        }
        if character.is_control() || is_mark(character) {
            let _ = write!(out, "{}", character.escape_default());
        } else {
            out.push(character);
        }
    }
    out
}

/// Characters without a shape that change how a terminal shows others.
fn is_mark(character: char) -> bool {
    matches!(character, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}

/// The first names of a list for a message, in backticks.
pub fn names<'n>(names: impl IntoIterator<Item = &'n str>) -> String {
    const MOST: usize = 12;
    let names: Vec<&str> = names.into_iter().collect();
    let shown: Vec<String> = names.iter().take(MOST).map(|name| format!("`{}`", plain(name, 40))).collect();
    let more = names.len().saturating_sub(MOST);
    let rest = if more == 0 { String::new() } else { format!(" and {more} more") };
    shown.join(", ") + &rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_and_lists_are_cut() {
        assert_eq!(plain(&"x".repeat(1 << 20), 3), "xxx…");
        assert_eq!(plain("\u{202e}\u{9b}1m\t", 10), "\\u{202e}\\u{9b}1m\\t");
        assert_eq!(names(["a", "b"]), "`a`, `b`");
        let many: Vec<String> = (0..20).map(|number| number.to_string()).collect();
        assert!(names(many.iter().map(String::as_str)).ends_with("`11` and 8 more"));
    }
}
