//! Sets of characters.

/// A set of characters.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Set {
    /// First and last characters, unordered, possibly overlapping.
    ranges: Vec<(char, char)>,
    /// Classes such as `\D` in brackets.
    classes: Vec<Set>,
    negated: bool,
    /// True if case is ignored.
    fold: bool,
}

const DIGIT: &[(char, char)] = &[('0', '9')];
const WORD: &[(char, char)] = &[('0', '9'), ('A', 'Z'), ('_', '_'), ('a', 'z')];
const SPACE: &[(char, char)] = &[('\t', '\r'), (' ', ' ')];

/// Returns true if a character belongs to a word, as in `\w`.
pub(super) fn is_word(c: char) -> bool {
    inside(WORD, c)
}

fn inside(ranges: &[(char, char)], c: char) -> bool {
    ranges.iter().any(|&(first, last)| first <= c && c <= last)
}

impl Set {
    pub(super) fn one(c: char) -> Self {
        Set { ranges: vec![(c, c)], ..Set::default() }
    }

    /// Every character, or, for `.`, every character except line ends.
    pub(super) fn any(line_ends: bool) -> Self {
        let ranges = if line_ends { Vec::new() } else { vec![('\n', '\n')] };
        Set { ranges, negated: true, ..Set::default() }
    }

    /// `\d`, `\w` and `\s`, which are ASCII only; capital letters negate them.
    pub(super) fn class(letter: char) -> Option<Self> {
        let ranges = match letter.to_ascii_lowercase() {
            'd' => DIGIT,
            'w' => WORD,
            's' => SPACE,
            _ => return None,
        };
        Some(Set { ranges: ranges.to_vec(), negated: letter.is_ascii_uppercase(), ..Set::default() })
    }

    pub(super) fn fold(mut self, fold: bool) -> Self {
        self.fold = fold;
        self
    }

    pub(super) fn negate(mut self, negated: bool) -> Self {
        self.negated ^= negated;
        self
    }

    pub(super) fn add_range(&mut self, first: char, last: char) {
        self.ranges.push((first, last));
    }

    pub(super) fn add_class(&mut self, class: Set) {
        self.classes.push(class);
    }

    pub(super) fn has(&self, c: char) -> bool {
        let inside = |c: char| inside(&self.ranges, c) || self.classes.iter().any(|class| class.has(c));
        let mut found = inside(c);
        if self.fold && !found {
            // Only for letters with a single counterpart.
            let single = |mut other: Box<dyn Iterator<Item = char>>| other.next().filter(|_| other.next().is_none());
            let small = single(Box::new(c.to_lowercase()));
            let capital = single(Box::new(c.to_uppercase()));
            found = [small, capital].into_iter().flatten().any(inside);
        }
        found != self.negated
    }
}
