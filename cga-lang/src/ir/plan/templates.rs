//! The repeated parts that are derived once and replayed, and the calls that they leave out.
//!
//! A *template* is made of a repeated part if the result of its rule depends on the size of its shape alone. A call below the part
//! that depends on more, or that requests stack, is a *hole*: each repetition calls it.

use super::rule_stack::RuleStack;
use crate::ir::facts::Facts;
use crate::ir::walk;
use crate::ir::{Block, BlockParts, Grammar, Item, RuleId, Slots, StepKind, Target};
use std::collections::HashSet;

/// The holes in templates.
#[derive(Clone, Debug, Default)]
pub struct TemplateHoles {
    /// Calls that are left out while a template is made: from a rule to another.
    holes: HashSet<(RuleId, RuleId)>,
    /// Rules that are left out somewhere.
    left_out: HashSet<RuleId>,
}

impl TemplateHoles {
    /// Finds the holes, in time linear in the size of the grammar.
    pub(super) fn new(grammar: &Grammar, facts: &Facts, stack: &RuleStack) -> Self {
        let is_open = |from: RuleId, to: RuleId| !facts.rule(to).own_rigid || stack.request(from, to).is_some();
        let mut todo: Vec<RuleId> = Vec::new();
        for (at, rule) in grammar.rules.iter().enumerate() {
            walk::steps(&rule.body, &mut |step| {
                if let StepKind::Block(Block { parts: BlockParts::Slots(slots), .. }) = &step.kind {
                    todo.extend(roots(slots, RuleId(at as u32), facts, stack).flatten());
                }
            });
        }
        let (mut met, mut holes): (HashSet<RuleId>, HashSet<(RuleId, RuleId)>) = Default::default();
        let calls = walk::calls(grammar, |_| true);
        while let Some(rule) = todo.pop() {
            if !met.insert(rule) {
                continue;
            }
            for called in calls[rule.0 as usize].iter().map(|called| RuleId(*called as u32)) {
                if is_open(rule, called) {
                    holes.insert((rule, called));
                } else {
                    todo.push(called);
                }
            }
        }
        let left_out = holes.iter().map(|(_, rule)| *rule).collect();
        TemplateHoles { holes, left_out }
    }

    /// Returns true if the call may be reached while a template is made, and is left out then.
    pub fn is_hole(&self, from: RuleId, to: RuleId) -> bool {
        self.holes.contains(&(from, to))
    }

    /// Returns true if a call of the rule is left out somewhere.
    pub(super) fn may_be_left_out(&self, rule: RuleId) -> bool {
        self.left_out.contains(&rule)
    }
}

/// By slot, the rule of which a template is made: a rigid one in a group, without arguments and without a request of stack.
pub(super) fn roots(
    slots: &Slots,
    from: RuleId,
    facts: &Facts,
    stack: &RuleStack,
) -> impl Iterator<Item = Option<RuleId>> {
    slots.targets.iter().zip(in_groups(&slots.pattern)).map(move |(target, is_in_group)| match target {
        Target::Rule { rule, args, .. } if is_in_group && args.is_empty() && facts.rule(*rule).own_rigid => {
            stack.request(from, *rule).is_none().then_some(*rule)
        }
        _ => None,
    })
}

/// By slot of a pattern, true if it is in a group.
fn in_groups(pattern: &[Item]) -> impl Iterator<Item = bool> {
    // Items left in the outermost group.
    let mut inside = 0;
    pattern.iter().filter_map(move |item| {
        let is_in = 0 < inside;
        inside -= u32::from(is_in);
        match item {
            Item::Repeat(len) => {
                inside = inside.max(*len);
                None
            }
            Item::Slot => Some(is_in),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;

    /// The roots of templates by rule, as `rule: root`, and the holes, as `caller → callee`.
    fn templates(rules: &str) -> (Vec<String>, Vec<String>) {
        let grammar = compile_text(rules).compiled.grammar.expect("good rules");
        let (facts, stack) = (Facts::new(&grammar), RuleStack::new(&grammar));
        let name = |rule: RuleId| grammar.rules[rule.0 as usize].name.as_str();
        let mut list = Vec::new();
        for (at, rule) in grammar.rules.iter().enumerate() {
            walk::steps(&rule.body, &mut |step| {
                if let StepKind::Block(Block { parts: BlockParts::Slots(slots), .. }) = &step.kind {
                    let found = roots(slots, RuleId(at as u32), &facts, &stack).flatten();
                    list.extend(found.map(|root| format!("{}: {}", rule.name, name(root))));
                }
            });
        }
        let holes = TemplateHoles::new(&grammar, &facts, &stack).holes;
        let mut holes: Vec<String> =
            holes.iter().map(|(from, to)| format!("{} → {}", name(*from), name(*to))).collect();
        holes.sort();
        (list, holes)
    }

    #[test]
    fn a_template_is_made_of_rigid_parts_in_groups() {
        let rules = "A --> split(x) { 1 : B | { ~1 : B | 1 : C(2) | 1 : X. }* }  B --> X.  C(n) --> s(n, 1, 1) X.";
        assert_eq!(templates(rules), (vec!["A: B".to_owned()], vec![]));
        let rules = "A --> split(x) { { ~1 : B | { 1 : C }* }* | 1 : B }  B --> s(split.index, 1, 1) X.  C --> X.";
        assert_eq!(templates(rules), (vec!["A: C".to_owned()], vec![]));
    }

    #[test]
    fn a_call_that_depends_on_more_than_the_size_is_a_hole() {
        let rules =
            "A --> split(x) { { ~1 : B }* }  B --> C D  C --> 30% : X. else : Y.  D --> split(y) { ~1 : E }  E --> C";
        assert_eq!(templates(rules), (vec!["A: B".to_owned()], vec!["B → C".to_owned(), "E → C".to_owned()]));
    }

    #[test]
    fn a_call_that_requests_stack_is_a_hole() {
        let rules = "A --> split(x) { { ~1 : B }* }  B --> case scope.sx > 1 : s('0.5, '1, '1) B else : X.";
        assert_eq!(templates(rules), (vec!["A: B".to_owned()], vec!["B → B".to_owned()]));
        let rules = "A --> split(x) { { ~1 : A }* | 1 : X. }";
        assert_eq!(templates(rules), (vec![], vec![]));
    }
}
