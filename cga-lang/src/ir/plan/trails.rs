//! The names of rules as numbers for trails: one for each site of a rule.

use crate::ir::{Grammar, RuleId};
use std::ops::Range;

/// The numbers of rules in trails.
#[derive(Clone, Debug, Default)]
pub struct TrailNumbers {
    /// By rule, its numbers: one for each site.
    numbers: Vec<Range<u32>>,
    names: Vec<String>,
}

impl TrailNumbers {
    /// Numbers the rules in their order.
    pub(super) fn new(grammar: &Grammar) -> Self {
        let mut trails = TrailNumbers::default();
        for rule in &grammar.rules {
            let first = trails.names.len() as u32;
            match rule.sites.is_empty() {
                true => trails.names.push(rule.name.clone()),
                false => trails.names.extend(rule.sites.iter().map(|site| site.name.clone())),
            }
            trails.numbers.push(first..trails.names.len() as u32);
        }
        trails
    }

    /// The numbers of a rule, one for each site; one number if the rule is not shared.
    pub fn of(&self, rule: RuleId) -> Range<u32> {
        self.numbers[rule.0 as usize].clone()
    }

    /// The names of rules, by number.
    pub fn names(&self) -> &[String] {
        &self.names
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;

    #[test]
    fn rules_and_blocks_are_numbered_in_their_order() {
        let rules = "A --> split(x) { 1 : s(1, 2, 3) X. | ~1 : B }  B --> X.";
        let grammar = compile_text(rules).compiled.grammar.expect("good rules");
        let trails = TrailNumbers::new(&grammar);
        assert_eq!(trails.names(), ["A", "B", "A/1"]);
        assert_eq!((trails.of(RuleId(0)), trails.of(RuleId(2))), (0..1, 2..3));
    }
}
