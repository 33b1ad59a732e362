//! Spellings of other languages: units after numbers, colours without quotation marks.

/// Units that may follow a number, with the factor to metres or degrees.
const UNITS: &[(&str, f64)] = &[
    ("m", 1.0),
    ("cm", 0.01),
    ("mm", 0.001),
    ("km", 1000.0),
    ("ft", 0.3048),
    ("inch", 0.0254),
    ("deg", 1.0),
    // The suffix of a float in languages like C.
    ("f", 1.0),
    ("F", 1.0),
];

/// The limit of the search for a bracket in bytes; it keeps the lexer linear.
const FARTHEST: usize = 500;

/// The note that CGA has no units.
pub const NO_UNITS: &str = "there are no units: lengths are metres, angles are degrees";

/// Converts a number with a unit, if the unit is known.
pub fn without_unit(number: f64, unit: &str) -> Option<f64> {
    let (_, factor) = UNITS.iter().find(|(own, _)| *own == unit)?;
    // The rounding keeps the digits that a person would write.
    Some((number * factor * 1e9).round() / 1e9)
}

/// The length of a colour like `#ff0000` at the beginning of a text.
pub(super) fn colour(text: &str) -> Option<usize> {
    let digits = text.strip_prefix('#')?;
    let end = digits.find(|c| !super::continues_name(c)).unwrap_or(digits.len());
    let is_colour = matches!(end, 3 | 6 | 8) && digits[..end].bytes().all(|byte| byte.is_ascii_hexdigit());
    is_colour.then_some(1 + end)
}

/// The text between single quotation marks at the beginning of a text: a word, several words, or the name of a file.
pub(super) fn single_quotes(text: &str) -> Option<&str> {
    let text = text.strip_prefix('\'').filter(|text| text.starts_with(super::starts_name))?;
    let end = text.find(|c| !(super::continues_name(c) || matches!(c, ' ' | '.' | '/' | '-' | ':')))?;
    let rest = text[end..].strip_prefix('\'')?;
    (!rest.starts_with(super::continues_name)).then_some(&text[..end])
}

/// Returns true if a colour must have been meant as text. As a comment, it would hide the closing bracket or the
/// value of a declaration. `rest` is the text after it.
pub(super) fn is_no_comment(rest: &str, in_brackets: bool) -> bool {
    let (line, below) = rest.split_at(rest.find(['\n', '\r']).unwrap_or(rest.len()));
    if in_brackets { line.contains([')', ']']) && !closes(below) } else { begins_declaration(below) }
}

/// Returns true if a bracket that is open before the text is closed in it, or may be.
fn closes(text: &str) -> bool {
    let (mut open, mut passed) = (1, 0);
    for line in text.split(['\n', '\r']) {
        let line = code(line);
        if line.contains("-->") {
            return false;
        }
        for c in line.chars() {
            match c {
                '(' | '[' => open += 1,
                ')' | ']' => open -= 1,
                _ => {}
            }
            if open == 0 {
                return true;
            }
        }
        passed += line.len();
        if FARTHEST < passed {
            return true;
        }
    }
    false
}

/// Returns true if the first line that is not empty begins a declaration, or if all lines are empty.
fn begins_declaration(text: &str) -> bool {
    let Some(line) = text.split(['\n', '\r']).map(|line| code(line).trim()).find(|line| !line.is_empty()) else {
        return true;
    };
    let word = line.split(|c| !super::continues_name(c)).next().unwrap_or_default();
    let behind = line[word.len()..].trim_start();
    line.contains("-->")
        || line.starts_with('@')
        || matches!(word, "attr" | "const" | "import" | "style")
        || (!word.is_empty() && behind.starts_with('=') && !behind.starts_with("=="))
}

/// A line without its comment. Strings count as code.
fn code(line: &str) -> &str {
    let mut quoted = false;
    for (at, c) in line.char_indices() {
        match c {
            '"' => quoted = !quoted,
            '#' if !quoted => return &line[..at],
            '/' if !quoted && line[at..].starts_with("//") => return &line[..at],
            _ => {}
        }
    }
    line
}
