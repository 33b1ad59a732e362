//! The rules whose leaves are joined again (*Shape recomposition*). `NIL` in these rules moves its neighbours.

use crate::ir::{Grammar, RuleId, StepKind, Target, walk};
use std::collections::HashSet;

/// The rules that operands reach whose shapes are reconnected.
pub(super) fn recomposed(grammar: &Grammar) -> HashSet<RuleId> {
    let mut todo = Vec::new();
    for rule in &grammar.rules {
        walk::steps(&rule.body, &mut |step| {
            if let StepKind::Block(block) = &step.kind
                && block.recomposes()
            {
                todo.extend(walk::targets(step).into_iter().filter_map(|target| match target {
                    Target::Rule { rule, .. } => Some(*rule),
                    Target::Leaf(_) | Target::Nil => None,
                }));
            }
        });
    }
    let (mut met, calls) = (HashSet::new(), walk::calls(grammar, |_| true));
    while let Some(rule) = todo.pop() {
        if met.insert(rule) {
            todo.extend(calls[rule.0 as usize].iter().map(|called| RuleId(*called as u32)));
        }
    }
    met
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;

    #[test]
    fn operands_are_recomposed_with_the_rules_below_them() {
        let rules = "A --> inline(recompose) { B } C  B --> split(x) { 1 : NIL | ~1 : D }  C --> D  D --> X.";
        let grammar = compile_text(rules).compiled.grammar.expect("good rules");
        let mut names: Vec<&str> = Vec::new();
        for rule in recomposed(&grammar) {
            names.push(&grammar.rules[rule.0 as usize].name);
        }
        names.sort_unstable();
        assert_eq!(names, ["B", "D"]);
        let plain =
            compile_text("A --> union { B | C } X.  B --> NIL  C --> NIL").compiled.grammar.expect("good rules");
        assert!(recomposed(&plain).is_empty());
    }
}
