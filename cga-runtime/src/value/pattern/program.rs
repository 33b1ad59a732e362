//! The steps of a compiled pattern.

use super::parse::{Assertion, RegexNode, parse};
use super::set::Set;

/// The largest number of steps, so that `(((a{99}){99}){99})` does not exhaust the memory.
const MOST_STEPS: usize = 5000;

/// A step at a position in the text.
#[derive(Debug)]
pub(super) enum Instruction {
    /// Consumes one character of the set, forwards or backwards.
    Over {
        set: Set,
        back: bool,
    },
    /// Continues only at such a position.
    At(Assertion),
    /// Continues at `first` and, if that fails, at `second`. Forks are numbered.
    Fork {
        first: usize,
        second: usize,
        number: usize,
    },
    Jump(usize),
    /// Runs the following steps up to `end` separately. Continues at `end` if they match, or if they do not
    /// (`negated`).
    Look {
        end: usize,
        negated: bool,
    },
    /// The end of the pattern: a match.
    Match,
}

/// A regular expression.
#[derive(Debug)]
pub(crate) struct Regex {
    pub(super) steps: Vec<Instruction>,
    pub(super) forks: usize,
}

impl Regex {
    /// Compiles a pattern. The error describes its fault.
    pub(crate) fn new(pattern: &str) -> Result<Self, String> {
        Regex::of(&parse(pattern)?)
    }

    /// Compiles a pattern that must match the whole text.
    pub(crate) fn whole(pattern: &str) -> Result<Self, String> {
        Regex::of(&RegexNode::Sequence(vec![
            RegexNode::At(Assertion::TextStart),
            parse(pattern)?,
            RegexNode::At(Assertion::TextEnd),
        ]))
    }

    fn of(node: &RegexNode) -> Result<Self, String> {
        let mut made = Regex { steps: Vec::new(), forks: 0 };
        made.node(node, false)?;
        made.push(Instruction::Match)?;
        Ok(made)
    }

    fn push(&mut self, step: Instruction) -> Result<usize, String> {
        if self.steps.len() == MOST_STEPS {
            return Err("it is too large".to_owned());
        }
        self.steps.push(step);
        Ok(self.steps.len() - 1)
    }

    /// A fork with unknown targets.
    fn fork(&mut self) -> Result<usize, String> {
        let number = self.forks;
        self.forks += 1;
        self.push(Instruction::Fork { first: 0, second: 0, number })
    }

    /// Sets a fork's targets: the steps after it and the next step to be added.
    fn close(&mut self, fork: usize, lazy: bool) {
        let (inside, behind) = (fork + 1, self.steps.len());
        if let Some(Instruction::Fork { first, second, .. }) = self.steps.get_mut(fork) {
            (*first, *second) = if lazy { (behind, inside) } else { (inside, behind) };
        }
    }

    /// Adds the steps of a node. With `back` they match the text before the position, from right to left.
    fn node(&mut self, node: &RegexNode, back: bool) -> Result<(), String> {
        match node {
            RegexNode::Set(set) => _ = self.push(Instruction::Over { set: set.clone(), back })?,
            RegexNode::At(place) => _ = self.push(Instruction::At(*place))?,
            RegexNode::Sequence(nodes) if back => nodes.iter().rev().try_for_each(|node| self.node(node, back))?,
            RegexNode::Sequence(nodes) => nodes.iter().try_for_each(|node| self.node(node, back))?,
            RegexNode::Either(nodes) => self.either(nodes, back)?,
            RegexNode::Repeat { node, least, most, lazy } => self.repeat(node, *least, *most, *lazy, back)?,
            RegexNode::Look { node, ahead, negated } => {
                let look = self.push(Instruction::Look { end: 0, negated: *negated })?;
                self.node(node, !ahead)?;
                self.push(Instruction::Match)?;
                self.steps[look] = Instruction::Look { end: self.steps.len(), negated: *negated };
            }
        }
        Ok(())
    }

    fn either(&mut self, nodes: &[RegexNode], back: bool) -> Result<(), String> {
        let mut jumps = Vec::new();
        for (i, node) in nodes.iter().enumerate() {
            if i + 1 == nodes.len() {
                self.node(node, back)?;
                break;
            }
            let fork = self.fork()?;
            self.node(node, back)?;
            jumps.push(self.push(Instruction::Jump(0))?);
            self.close(fork, false);
        }
        for jump in jumps {
            self.steps[jump] = Instruction::Jump(self.steps.len());
        }
        Ok(())
    }

    fn repeat(
        &mut self,
        node: &RegexNode,
        least: u32,
        most: Option<u32>,
        lazy: bool,
        back: bool,
    ) -> Result<(), String> {
        for _ in 0..least {
            let before = self.steps.len();
            self.node(node, back)?;
            // An empty node stays empty when repeated.
            if self.steps.len() == before {
                break;
            }
        }
        let Some(most) = most else {
            let fork = self.fork()?;
            self.node(node, back)?;
            self.push(Instruction::Jump(fork))?;
            self.close(fork, lazy);
            return Ok(());
        };
        let forks = (least..most).map(|_| self.fork().and_then(|fork| self.node(node, back).map(|()| fork)));
        let forks: Vec<usize> = forks.collect::<Result<_, _>>()?;
        for fork in forks {
            self.close(fork, lazy);
        }
        Ok(())
    }
}
