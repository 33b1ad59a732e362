//! The names of leaves as numbers, so that sinks compare numbers.

use std::collections::HashMap;

use cga_lang::ir::walk;
use cga_lang::ir::{Childless, Grammar, Rule, Target};
use proc_macro2::{Literal, TokenStream};

use super::site;

/// The names of all leaves of a grammar, in the order of the rules.
pub(super) struct LeafNames {
    names: Vec<String>,
    numbers: HashMap<String, u32>,
}

impl LeafNames {
    pub(super) fn new(grammar: &Grammar) -> Self {
        let mut leaves = LeafNames { names: Vec::new(), numbers: HashMap::new() };
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

    /// The number of the implicit leaves of a rule.
    pub(super) fn implicit(&self, rule: &Rule) -> TokenStream {
        let numbers = labels(rule).into_iter().map(|label| self.numbers.get(label).copied().unwrap_or(u32::MAX));
        site::of_site(&numbers.collect::<Vec<_>>())
    }

    /// All names, by number.
    pub(super) fn names(&self) -> &[String] {
        &self.names
    }

    /// The number of a name.
    pub(super) fn number(&self, name: &str) -> Literal {
        Literal::u32_suffixed(self.numbers.get(name).copied().unwrap_or(u32::MAX))
    }
}

/// The names of the implicit leaves of a rule, by site.
fn labels(rule: &Rule) -> Vec<&str> {
    match rule.sites.is_empty() {
        true => vec![&rule.label],
        false => rule.sites.iter().map(|site| site.label.as_str()).collect(),
    }
}
