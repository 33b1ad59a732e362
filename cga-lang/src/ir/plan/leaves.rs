//! The names of leaves as numbers, so that sinks compare numbers.

use crate::ir::walk;
use crate::ir::{Childless, Grammar, Rule, Target};
use std::collections::HashMap;

/// The names of all leaves of a grammar, in the order of the rules.
#[derive(Clone, Debug, Default)]
pub struct LeafNames {
    names: Vec<String>,
    numbers: HashMap<String, u32>,
}

impl LeafNames {
    /// Numbers the names, in time linear in the size of the grammar.
    pub(super) fn new(grammar: &Grammar) -> Self {
        let mut leaves = LeafNames::default();
        for rule in &grammar.rules {
            if rule.leaf != Childless::Never {
                labels(rule).into_iter().for_each(|label| leaves.add(label));
            }
            walk::steps(&rule.body, &mut |step| {
                for target in walk::targets(step) {
                    if let Target::Leaf(name) = target {
                        leaves.add(name);
                    }
                }
            });
        }
        leaves
    }

    fn add(&mut self, name: &str) {
        if !self.numbers.contains_key(name) {
            self.numbers.insert(name.to_owned(), self.names.len() as u32);
            self.names.push(name.to_owned());
        }
    }

    /// By site of a rule, the number of its implicit leaves; one number if the rule is not shared.
    pub fn implicit(&self, rule: &Rule) -> Vec<u32> {
        labels(rule).into_iter().map(|label| self.number(label)).collect()
    }

    /// All names, by number.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The number of a name. A name without leaves has the largest number.
    pub fn number(&self, name: &str) -> u32 {
        self.numbers.get(name).copied().unwrap_or(u32::MAX)
    }
}

/// The names of the implicit leaves of a rule, by site.
fn labels(rule: &Rule) -> Vec<&str> {
    match rule.sites.is_empty() {
        true => vec![&rule.label],
        false => rule.sites.iter().map(|site| site.label.as_str()).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;

    #[test]
    fn leaves_are_numbered_in_the_order_of_rules() {
        let rules = "A --> split(x) { 1 : Wall. | ~1 : B | 1 : C }  B --> Glass. Wall.  C --> extrude(1)";
        let grammar = compile_text(rules).compiled.grammar.expect("good rules");
        let leaves = LeafNames::new(&grammar);
        assert_eq!(leaves.names(), ["A", "Wall", "Glass", "C"]);
        assert_eq!(leaves.implicit(&grammar.rules[2]), [3]);
        // Each path through `B` makes a child.
        assert_eq!(leaves.implicit(&grammar.rules[1]), [u32::MAX]);
    }
}
