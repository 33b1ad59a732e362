//! The form in which a split runs, and the properties of parts that their successors read.

use super::RunPlan;
use crate::ir::{Block, BlockParts, ExprKind, Item, RuleId, Size, Slots, Solved, Target, Value};
use crate::ops::{Braces, Measure, Uses};

/// The form in which a split runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SplitForm<'s> {
    /// The pieces are known: they come from a list.
    Solved(&'s Solved),
    /// The split is laid out in the rule, and the compiler of the back end folds constants. The sizes are constant, and the slots
    /// few and without groups.
    InPlace,
    /// The runtime goes through the pattern.
    Called,
}

/// The properties of a part that its successor reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PartNeeds {
    /// True if the successor draws random numbers.
    pub draws: bool,
    /// True if it reads `split.index` or `split.total`.
    pub counts: bool,
}

/// The largest number of slots that are laid out in a rule.
const FEW_SLOTS: usize = 3;

impl RunPlan<'_> {
    /// The form of a split of a rule.
    pub fn split_form<'s>(&self, block: &'s Block, rule: RuleId) -> SplitForm<'s> {
        let BlockParts::Slots(slots) = &block.parts else { return SplitForm::Called };
        // A list cannot distinguish the repetitions of a group from the repetitions of a group around it.
        if let Some(solved) = slots.solved.as_ref().filter(|_| !has_nested_groups(&slots.pattern)) {
            return SplitForm::Solved(solved);
        }
        let is_along_axis = matches!(block.row.braces, Braces::Slots(Measure::Length));
        if is_along_axis && self.is_small(slots, rule) { SplitForm::InPlace } else { SplitForm::Called }
    }

    /// Returns true for few slots of constant sizes in a recursive rule. Such rules run most often. Rules that repeat have
    /// templates, and the code of other rules would be large for the gain.
    fn is_small(&self, slots: &Slots, rule: RuleId) -> bool {
        let is_constant =
            |size: &Size| matches!(size.value.kind, ExprKind::Value(Value::Float(value)) if value.is_finite());
        self.grammar.rules[rule.0 as usize].cycle.is_some()
            && slots.targets.len() <= FEW_SLOTS
            && slots.pattern.len() == slots.targets.len()
            && slots.sizes.iter().all(is_constant)
            && self.templates(slots, rule).iter().all(Option::is_none)
    }

    /// The properties of a part that becomes `target`.
    pub fn part_needs(&self, target: &Target) -> PartNeeds {
        let uses = self.facts.target(target);
        PartNeeds { draws: uses.has(Uses::DRAWS), counts: !uses.counters().is_none() }
    }

    /// Returns true if a successor of the slots reads `split.total`.
    pub fn needs_total(&self, slots: &Slots) -> bool {
        slots.targets.iter().any(|target| self.facts.target(target).has(Uses::TOTAL))
    }
}

/// Returns true if a group is in another one.
fn has_nested_groups(pattern: &[Item]) -> bool {
    pattern.iter().enumerate().any(|(at, item)| match item {
        Item::Repeat(len) => pattern[at + 1..].iter().take(*len as usize).any(|item| matches!(item, Item::Repeat(_))),
        Item::Slot => false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;
    use crate::ir::{StepKind, walk};

    /// The forms of the splits of the rule `A`: `s`olved, in `p`lace, `c`alled.
    fn forms(rules: &str) -> String {
        let grammar = compile_text(rules).compiled.grammar.expect("good rules");
        let (plan, mut forms) = (RunPlan::new(&grammar), String::new());
        walk::steps(&grammar.rules[0].body, &mut |step| {
            if let StepKind::Block(block) = &step.kind {
                forms.push(match plan.split_form(block, RuleId(0)) {
                    SplitForm::Solved(_) => 's',
                    SplitForm::InPlace => 'p',
                    SplitForm::Called => 'c',
                });
            }
        });
        forms
    }

    #[test]
    fn few_constant_slots_of_a_cycle_are_in_place() {
        let cycle = |split: &str| forms(&format!("A --> case scope.sx > 1 : {split} else : NIL"));
        assert_eq!(cycle("split(x) { '0.5 : A | ~1 : X. }"), "p");
        assert_eq!(cycle("split(x) { '0.5 : A | ~1 : X. | ~1 : X. | ~1 : X. }"), "c");
        assert_eq!(cycle("split(x) { '0.5 : A | { ~1 : X. }* }"), "c");
        assert_eq!(cycle("split(x) { scope.sy : A | ~1 : X. }"), "c");
        assert_eq!(cycle("splitArea(x) { '0.5 : A | ~1 : X. }"), "c");
        assert_eq!(forms("A --> split(x) { '0.5 : B | ~1 : X. }  B --> X."), "c");
    }

    #[test]
    fn a_list_of_pieces_has_no_nested_groups() {
        assert_eq!(forms("A --> s(9, 1, 1) split(x) { { 1 : X. | ~1 : Y. }* | 2 : X. }"), "s");
        assert_eq!(forms("A --> s(9, 1, 1) split(x) { { 1 : X. | { 2 : Y. }* }* | 2 : X. }"), "c");
    }

    #[test]
    fn parts_need_what_their_successors_read() {
        let rules = "A --> split(x) { 1 : B | 1 : C | 1 : D(split.total) | 1 : X. }
            B --> 30% : X. else : Y.  C --> s(split.index, 1, 1) X.  D(n) --> s(n, 1, 1) X.";
        let grammar = compile_text(rules).compiled.grammar.expect("good rules");
        let plan = RunPlan::new(&grammar);
        let StepKind::Block(Block { parts: BlockParts::Slots(slots), .. }) = &grammar.rules[0].body[0].kind else {
            panic!("a split")
        };
        let needs = slots.targets.iter().map(|target| plan.part_needs(target));
        let needs: Vec<(bool, bool)> = needs.map(|needs| (needs.draws, needs.counts)).collect();
        assert_eq!(needs, [(true, false), (false, true), (false, true), (false, false)]);
        assert!(plan.needs_total(slots));
    }
}
