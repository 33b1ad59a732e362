//! Facts, one line an item.

use super::Printer;
use cga_lang::ir::facts::{RuleFacts, Uses};

impl Printer<'_> {
    /// The uses of a function, unless there are none.
    pub(super) fn uses(&mut self, uses: Uses) {
        if !uses.is_none() {
            self.line(&format!("  uses {}", list(uses)));
        }
    }

    /// The facts of a rule, unless it uses nothing: then it is rigid. `below` is left out where it is the same.
    pub(super) fn rule_facts(&mut self, facts: &RuleFacts) {
        let mut parts = Vec::new();
        if !facts.own.is_none() {
            parts.push(format!("uses {}", list(facts.own)));
        }
        if facts.below != facts.own {
            parts.push(format!("below {}", list(facts.below)));
        }
        if facts.rigid && !parts.is_empty() {
            parts.push("rigid".into());
        }
        if !parts.is_empty() {
            self.line(&format!("  {}", parts.join("; ")));
        }
    }
}

fn list(uses: Uses) -> String {
    uses.names().collect::<Vec<_>>().join(", ")
}
