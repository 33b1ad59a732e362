//! What other languages write and CGA does not: units behind numbers, colours that are no text.

/// Units people put behind a number, and what one of them is in metres or degrees.
const UNITS: &[(&str, f64)] = &[
    ("m", 1.0),
    ("cm", 0.01),
    ("mm", 0.001),
    ("km", 1000.0),
    ("ft", 0.3048),
    ("inch", 0.0254),
    ("deg", 1.0),
    // How languages like C mark a number with a fraction.
    ("f", 1.0),
    ("F", 1.0),
];

/// Bytes looked through for a bracket; a bound keeps this linear.
const FARTHEST: usize = 500;

/// Why there are no units.
pub const NO_UNITS: &str = "there are no units: lengths are metres, angles are degrees";

/// What a number with a unit behind it is without one, if it is a unit.
pub fn without_unit(number: f64, unit: &str) -> Option<f64> {
    let (_, factor) = UNITS.iter().find(|(own, _)| *own == unit)?;
    // As many digits as somebody would write.
    Some((number * factor * 1e9).round() / 1e9)
}

/// The length of a colour like `#ff0000` that a text begins with.
pub(super) fn colour(text: &str) -> Option<usize> {
    let digits = text.strip_prefix('#')?;
    let end = digits.find(|c| !super::continues_name(c)).unwrap_or(digits.len());
    let is_colour = matches!(end, 3 | 6 | 8) && digits[..end].bytes().all(|byte| byte.is_ascii_hexdigit());
    is_colour.then_some(1 + end)
}

/// Whether what stands behind a colour must have been meant as text: as a comment it would swallow the bracket that
/// closes the one before it, or the value of a declaration.
pub(super) fn is_no_comment(rest: &str, in_brackets: bool) -> bool {
    let (line, below) = rest.split_at(rest.find(['\n', '\r']).unwrap_or(rest.len()));
    if in_brackets { line.contains([')', ']']) && !closes(below) } else { begins_declaration(below) }
}

/// Whether a bracket is closed, or may be, that stands open before a text.
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

/// Whether the first line that is not empty begins a declaration, or there is none.
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

/// A line without its comment. Text counts as code.
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
