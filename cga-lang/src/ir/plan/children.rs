//! Numbers of children, from which their seeds follow.
//!
//! The children of a rule are numbered from 0, in the order of its steps. The branches of a `case` go on from the same number. A
//! bracket is one child, and its own children are numbered from 0.

use super::RunPlan;
use crate::ir::{Block, BlockParts, RuleId, Step, StepKind};
use crate::ops::Uses;

impl Step {
    /// The number of child numbers that a step takes, if it makes children.
    pub fn children(&self) -> u32 {
        match &self.kind {
            StepKind::Block(Block { parts: BlockParts::Operands(targets), .. }) => targets.len() as u32,
            _ => 1,
        }
    }
}

impl RunPlan<'_> {
    /// Returns true if the rule or a rule that it reaches draws random numbers, so that its shape needs a seed.
    pub fn draws(&self, rule: RuleId) -> bool {
        self.facts.rule(rule).below.has(Uses::DRAWS)
    }

    /// Returns true if a part that becomes the rule needs a seed of its own: the part is the successor itself. A block is
    /// a step of the rule around it, so it keeps the seed of the part.
    pub fn reseeds(&self, rule: RuleId) -> bool {
        !self.grammar.rules[rule.0 as usize].block && self.draws(rule)
    }
}
