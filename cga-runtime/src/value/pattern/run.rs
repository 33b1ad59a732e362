//! Runs the steps of a pattern over a text.

use super::parse::Assertion;
use super::program::{Instruction, Regex};
use super::set::is_word;

/// The largest number of positions times forks. The memory takes one bit for each.
const MOST_STATES: usize = 1 << 24;
/// The largest number of steps in one search. A match of a whole text is one search.
const MOST_STEPS: u64 = 50_000_000;

/// The error for a text that is too long for a pattern, or for a pattern that takes too long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TooLong;

impl Regex {
    /// Matches a text. Returns the result and the number of steps taken. A search that would take too long does not
    /// match.
    pub(crate) fn matches(&self, text: &str) -> (bool, u64) {
        let text: Vec<char> = text.chars().collect();
        let Ok(mut search) = RegexSearch::new(self, &text) else { return (false, u64::MAX) };
        match search.find(0) {
            Ok(found) => (found.is_some(), search.steps),
            Err(_) => (false, u64::MAX),
        }
    }
}

/// A search of a text for matches of a pattern.
pub(crate) struct RegexSearch<'a> {
    pattern: &'a Regex,
    text: &'a [char],
    /// The forks that are running or have failed, by position and number. The result of a fork depends on these two
    /// alone, so it is not tried again. This keeps patterns such as `(a+)+b` from taking exponential time.
    tried: Vec<u64>,
    /// The number of steps taken so far.
    steps: u64,
}

impl<'a> RegexSearch<'a> {
    pub(crate) fn new(pattern: &'a Regex, text: &'a [char]) -> Result<Self, TooLong> {
        let states = (text.len() + 1).saturating_mul(pattern.forks);
        if MOST_STATES < states {
            return Err(TooLong);
        }
        Ok(RegexSearch { pattern, text, tried: vec![0; states.div_ceil(64)], steps: 0 })
    }

    /// The start and end of the first match that begins at `from` or later.
    pub(crate) fn find(&mut self, from: usize) -> Result<Option<(usize, usize)>, TooLong> {
        for start in from..=self.text.len() {
            if let Some(end) = self.run(0, start)? {
                return Ok(Some((start, end)));
            }
        }
        Ok(None)
    }

    /// The end of the match of the steps from `step` on that begins at `place`.
    fn run(&mut self, step: usize, place: usize) -> Result<Option<usize>, TooLong> {
        let mut waiting = vec![(step, place)];
        let mut marked = Vec::new();
        'next: while let Some((mut step, mut place)) = waiting.pop() {
            loop {
                self.steps += 1;
                if MOST_STEPS < self.steps {
                    return Err(TooLong);
                }
                match &self.pattern.steps[step] {
                    Instruction::Over { set, back } => {
                        let character = if *back { place.checked_sub(1) } else { Some(place) };
                        match character.and_then(|at| self.text.get(at)) {
                            Some(c) if set.has(*c) => place = if *back { place - 1 } else { place + 1 },
                            _ => continue 'next,
                        }
                        step += 1;
                    }
                    Instruction::At(what) if self.at(*what, place) => step += 1,
                    Instruction::At(_) => continue 'next,
                    Instruction::Fork { first, second, number } => {
                        let state = place * self.pattern.forks + number;
                        let (word, bit) = (&mut self.tried[state / 64], 1 << (state % 64));
                        if *word & bit != 0 {
                            continue 'next;
                        }
                        *word |= bit;
                        marked.push(state as u32);
                        waiting.push((*second, place));
                        step = *first;
                    }
                    Instruction::Jump(to) => step = *to,
                    Instruction::Look { end, negated } => {
                        let (end, negated) = (*end, *negated);
                        if self.run(step + 1, place)?.is_some() == negated {
                            continue 'next;
                        }
                        step = end;
                    }
                    Instruction::Match => {
                        // Some of these forks lead to a match, so later runs must try them again.
                        for state in marked {
                            self.tried[state as usize / 64] &= !(1 << (state % 64));
                        }
                        return Ok(Some(place));
                    }
                }
            }
        }
        Ok(None)
    }

    fn at(&self, what: Assertion, place: usize) -> bool {
        let before = place.checked_sub(1).and_then(|at| self.text.get(at));
        let behind = self.text.get(place);
        let word = |c: Option<&char>| c.is_some_and(|c| is_word(*c));
        match what {
            Assertion::TextStart => before.is_none(),
            Assertion::TextEnd => behind.is_none(),
            Assertion::LineStart => before.is_none_or(|c| *c == '\n'),
            Assertion::LineEnd => behind.is_none_or(|c| *c == '\n'),
            Assertion::WordEdge => word(before) != word(behind),
            Assertion::NoWordEdge => word(before) == word(behind),
        }
    }
}
