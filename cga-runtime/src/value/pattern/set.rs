//! Sets of characters.

/// A set of characters.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Set {
    /// First and last characters, unordered, possibly overlapping.
    ranges: Vec<(char, char)>,
    negated: bool,
    /// True if case is ignored.
    fold: bool,
}

const DIGIT: &[(char, char)] = &[('0', '9')];
const WORD: &[(char, char)] = &[('0', '9'), ('A', 'Z'), ('_', '_'), ('a', 'z')];
const SPACE: &[(char, char)] = &[('\t', '\r'), (' ', ' ')];
const LINE_END: &[(char, char)] = &[('\n', '\n')];

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
        Set { ranges: if line_ends { Vec::new() } else { LINE_END.to_vec() }, negated: true, fold: false }
    }

    /// `\d`, `\w` and `\s`, which are ASCII only; capital letters negate them.
    pub(super) fn class(letter: char) -> Option<Self> {
        let ranges = match letter.to_ascii_lowercase() {
            'd' => DIGIT,
            'w' => WORD,
            's' => SPACE,
            _ => return None,
        };
        Some(Set { ranges: ranges.to_vec(), negated: letter.is_ascii_uppercase(), fold: false })
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

    /// Adds the characters of another set to one that is not negated.
    pub(super) fn add(&mut self, other: &Set) {
        if !other.negated {
            self.ranges.extend_from_slice(&other.ranges);
            return;
        }
        let mut taken = other.ranges.clone();
        taken.sort_unstable();
        let mut free = '\0';
        for (first, last) in taken {
            if free < first {
                self.ranges.push((free, before(first)));
            }
            match after(last) {
                Some(next) => free = free.max(next),
                None => return,
            }
        }
        self.ranges.push((free, char::MAX));
    }

    pub(super) fn has(&self, c: char) -> bool {
        let mut found = inside(&self.ranges, c);
        if self.fold && !found {
            // Only for letters with a single counterpart.
            let single = |mut other: Box<dyn Iterator<Item = char>>| other.next().filter(|_| other.next().is_none());
            let small = single(Box::new(c.to_lowercase()));
            let capital = single(Box::new(c.to_uppercase()));
            found = [small, capital].into_iter().flatten().any(|other| inside(&self.ranges, other));
        }
        found != self.negated
    }
}

fn after(c: char) -> Option<char> {
    if c == '\u{d7ff}' { Some('\u{e000}') } else { char::from_u32(c as u32 + 1) }
}

fn before(c: char) -> char {
    if c == '\u{e000}' { '\u{d7ff}' } else { char::from_u32((c as u32).saturating_sub(1)).unwrap_or_default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_hold_what_they_say() {
        let space = Set::class('s').unwrap();
        assert!([' ', '\t', '\n', '\r'].into_iter().all(|c| space.has(c)) && !space.has('a'));
        assert!(!Set::class('S').unwrap().has(' ') && Set::class('S').unwrap().has('ü') && Set::class('q').is_none());
        assert!(Set::any(true).has('\n') && !Set::any(false).has('\n') && Set::any(false).has('x'));
        assert!(Set::one('a').fold(true).has('A') && Set::one('Ü').fold(true).has('ü') && !Set::one('a').has('A'));
        assert!(!Set::one('a').fold(true).negate(true).has('A'));
    }

    #[test]
    fn what_is_left_of_a_set_can_be_added() {
        let mut set = Set::default();
        set.add(&Set::class('D').unwrap());
        let all = ['\0', '/', '0', '9', ':', '\u{d7ff}', '\u{e000}', char::MAX];
        assert_eq!(all.map(|c| set.has(c)), [true, true, false, false, true, true, true, true]);
        let mut rest = Set::default();
        rest.add(&set.negate(true));
        assert_eq!(all.map(|c| rest.has(c)), [false, false, true, true, false, false, false, false]);
    }
}
