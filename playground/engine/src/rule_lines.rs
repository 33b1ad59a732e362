//! The lines of a rule text that declare or write a name.

use std::collections::BTreeMap;

/// The lines of a name, counted from 1.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct NameLines {
    /// The lines of its declarations: rules with other parameters have the same name.
    declared: Vec<usize>,
    /// The lines that write it.
    written: Vec<usize>,
}

impl NameLines {
    /// The declarations, or for a leaf without a rule the lines that write it.
    pub(crate) fn shown(&self) -> &[usize] {
        if self.declared.is_empty() { &self.written } else { &self.declared }
    }
}

/// A piece of a rule text. Comments and texts in quotes are left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Piece<'t> {
    Name(&'t str),
    Open,
    Close,
    Arrow,
    Other(char),
}

/// The lines of all names of a text.
pub(crate) fn rule_lines(text: &str) -> BTreeMap<&str, NameLines> {
    let pieces = pieces(text);
    let mut lines: BTreeMap<&str, NameLines> = BTreeMap::new();
    for (at, (piece, line)) in pieces.iter().enumerate() {
        let Piece::Name(name) = *piece else { continue };
        // `scope.sx`: the second part is not a name of its own.
        if at != 0 && pieces[at - 1].0 == Piece::Other('.') && !ends_a_leaf(&pieces, at - 1) {
            continue;
        }
        let list = lines.entry(name).or_default();
        let list = if is_declared(&pieces[at + 1..]) { &mut list.declared } else { &mut list.written };
        if list.last() != Some(line) {
            list.push(*line);
        }
    }
    lines
}

/// True if the dot ends a leaf: names after it are separate.
fn ends_a_leaf(pieces: &[(Piece<'_>, usize)], dot: usize) -> bool {
    match dot.checked_sub(1).map(|before| pieces[before].0) {
        // Leaves begin with a capital letter by custom; names with dots of CGA do not.
        Some(Piece::Name(name)) => name.starts_with(char::is_uppercase),
        _ => true,
    }
}

/// True if the pieces after a name make it a declared rule: parameters, perhaps local values, and an arrow.
fn is_declared(mut rest: &[(Piece<'_>, usize)]) -> bool {
    rest = after_brackets(rest);
    if let [(Piece::Name("with"), _), after @ ..] = rest {
        rest = after_brackets(after);
    }
    matches!(rest.first(), Some((Piece::Arrow, _)))
}

/// The pieces after a pair of brackets, if they begin with one.
fn after_brackets<'p, 't>(pieces: &'p [(Piece<'t>, usize)]) -> &'p [(Piece<'t>, usize)] {
    let mut depth = 0usize;
    for (at, (piece, _)) in pieces.iter().enumerate() {
        match piece {
            Piece::Open => depth += 1,
            Piece::Close => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return if at == 0 { pieces } else { &pieces[at + 1..] };
        }
    }
    &[]
}

fn pieces(text: &str) -> Vec<(Piece<'_>, usize)> {
    let mut list = Vec::new();
    let (mut rest, mut line) = (text, 1);
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '"' => quoted(rest),
            '/' if rest.starts_with("//") => to_line_end(rest),
            '/' if rest.starts_with("/*") => rest.find("*/").map_or(rest.len(), |end| end + 2),
            '#' => to_line_end(rest),
            '-' if rest.starts_with("-->") => {
                list.push((Piece::Arrow, line));
                3
            }
            first if first.is_alphabetic() || first == '_' => {
                let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
                list.push((Piece::Name(&rest[..end]), line));
                end
            }
            // `1.5`: its dot does not belong to a name.
            first if first.is_ascii_digit() => {
                rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len())
            }
            first => {
                match first {
                    '(' => list.push((Piece::Open, line)),
                    ')' => list.push((Piece::Close, line)),
                    first if first.is_whitespace() => {}
                    first => list.push((Piece::Other(first), line)),
                }
                first.len_utf8()
            }
        };
        line += rest[..length].matches('\n').count();
        rest = &rest[length..];
    }
    list
}

/// The length of a text in quotes.
fn quoted(rest: &str) -> usize {
    let mut is_escaped = false;
    for (at, c) in rest.char_indices().skip(1) {
        if c == '"' && !is_escaped {
            return at + 1;
        }
        is_escaped = c == '\\' && !is_escaped;
    }
    rest.len()
}

fn to_line_end(rest: &str) -> usize {
    rest.find('\n').unwrap_or(rest.len())
}

#[cfg(test)]
mod tests {
    use super::rule_lines;

    fn shown(text: &str, name: &str) -> Vec<usize> {
        rule_lines(text).get(name).map(|lines| lines.shown().to_vec()).unwrap_or_default()
    }

    #[test]
    fn a_rule_has_the_line_of_its_declaration() {
        let text = "/// Wall --> no rule\nLot --> Wall(1, (2)) Glass.\nWall(a, b) with ( c := (a + b) )\n  --> Wall.\n\
                    Wall(a) --> Brick. t(0, 0, 1.5) Brick.";
        assert_eq!(shown(text, "Lot"), [2]);
        assert_eq!(shown(text, "Wall"), [3, 5]);
        assert_eq!(shown(text, "Glass"), [2]);
        assert_eq!(shown(text, "Brick"), [5]);
        assert!(shown(text, "Roof").is_empty());
    }

    #[test]
    fn comments_and_texts_have_no_names() {
        let text = "# Roof\n#Roof\nA --> print(\"Roof \\\" Roof\") /* Roof\n Roof */ color(\"#ff0000\") B // Roof\n\
                    C --> Roof # Roof\nD --> #Roof";
        assert_eq!(shown(text, "Roof"), [5]);
        assert_eq!(shown(text, "B"), [4]);
        assert_eq!(shown(text, "C"), [5]);
    }

    #[test]
    fn parts_of_names_with_dots_are_left_out() {
        let text = "A --> s(scope.sx, 1, 1) Glass. sx\nB --> Glass.Wall";
        assert_eq!(shown(text, "sx"), [1]);
        assert_eq!(shown(text, "scope"), [1]);
        assert_eq!(shown(text, "Wall"), [2]);
    }

    #[test]
    fn broken_texts_end() {
        for text in ["", "\"", "/*", "A(", "A((((", "A with (", "-->", "1.", ".", "#", "A --> \"\\"] {
            rule_lines(text);
        }
    }
}
