//! Which parts that repeat are derived once and replayed, and which calls they leave out.

use std::cell::Cell;
use std::collections::HashSet;

use cga_lang::ir::plan::RunPlan;
use cga_lang::ir::walk;
use cga_lang::ir::{Block, BlockParts, Grammar, Item, RuleId, StepKind, Target};

/// The templates of a grammar.
pub(super) struct TemplatePlan {
    /// Calls that are left out while a template is made: from a rule to another.
    holes: HashSet<(RuleId, RuleId)>,
    /// Rules that are left out somewhere.
    left_out: HashSet<RuleId>,
    /// Places with a template so far.
    places: Cell<u32>,
}

impl TemplatePlan {
    pub(super) fn new(grammar: &Grammar, plan: &RunPlan<'_>) -> Self {
        let is_open =
            |from: RuleId, to: RuleId| !plan.facts.rule(to).own_rigid || plan.rule_stack.request(from, to).is_some();
        let mut todo: Vec<RuleId> = Vec::new();
        for (at, rule) in grammar.rules.iter().enumerate() {
            walk::steps(&rule.body, &mut |step| {
                if let StepKind::Block(Block { parts: BlockParts::Slots(slots), .. }) = &step.kind {
                    let repeated = slots.targets.iter().zip(in_groups(&slots.pattern)).filter(|(_, is_in)| *is_in);
                    todo.extend(repeated.filter_map(|(target, _)| root(target, RuleId(at as u32), plan)));
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
        TemplatePlan { holes, left_out, places: Cell::new(0) }
    }

    /// Returns true if a call may be met while a template is made, and is left out then.
    pub(super) fn is_hole(&self, from: RuleId, to: RuleId) -> bool {
        self.holes.contains(&(from, to))
    }

    /// Returns true if a call of a rule is left out somewhere.
    pub(super) fn may_be_left_out(&self, rule: RuleId) -> bool {
        self.left_out.contains(&rule)
    }

    /// The first number of `count` more places with a template.
    pub(super) fn places(&self, count: u32) -> u32 {
        let place = self.places.get();
        self.places.set(place + count);
        place
    }
}

/// The rule of a slot in a group, if a template can be made of it: a rigid one without arguments that never waits.
pub(super) fn root(target: &Target, from: RuleId, plan: &RunPlan<'_>) -> Option<RuleId> {
    match target {
        Target::Rule { rule, args, .. } if args.is_empty() && plan.facts.rule(*rule).own_rigid => {
            plan.rule_stack.request(from, *rule).is_none().then_some(*rule)
        }
        _ => None,
    }
}

/// Returns true if each slot of a pattern is in a group.
pub(super) fn in_groups(pattern: &[Item]) -> impl Iterator<Item = bool> {
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
