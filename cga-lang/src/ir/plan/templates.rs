//! The repeated parts that are derived once and replayed, and the calls that they leave out.
//!
//! A *template* is made of a repeated part if the result of its rule depends on a few values alone: the size of its shape, the arguments
//! of its rule, attributes and constants. A call below the part that depends on more, or that requests stack, is a *hole*: each
//! repetition calls it.
//!
//! A part repeats if it is in a group of a split. So does a part of a rule that such parts call each time, on shapes of the same size: a
//! window of a bay that is drawn. Of those, templates are made if they are meshes, which take longer to make than to find.

use super::rule_stack::RuleStack;
use crate::ir::facts::{Facts, Reads, TemplateNeeds, closure};
use crate::ir::walk;
use crate::ir::{Block, BlockParts, GlobalId, Grammar, Item, RuleId, Slots, StepKind, Target};
use std::collections::HashSet;

/// A repeated part of which a template is made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TemplateRoot {
    /// Its rule.
    pub rule: RuleId,
    /// The attributes and constants whose values the template depends on, besides the arguments of the rule.
    pub reads: Vec<GlobalId>,
    /// True if it also depends on values that other runs may not have.
    pub is_of_run: bool,
    /// Its other needs.
    pub needs: TemplateNeeds,
}

/// The holes in templates.
#[derive(Clone, Debug, Default)]
pub struct TemplateHoles {
    /// Calls that are left out while a template is made: from a rule to another.
    holes: HashSet<(RuleId, RuleId)>,
    /// Rules that are left out somewhere.
    left_out: HashSet<RuleId>,
    /// By rule, the attributes and constants that a template of it reads.
    reads: Vec<Reads>,
    /// By rule, the other needs of a template of it.
    needs: Vec<TemplateNeeds>,
    /// Rules that are called again and again on shapes of the same size, with the same arguments, while no template is made.
    frequent: HashSet<RuleId>,
}

impl TemplateHoles {
    /// Finds the holes, in time linear in the size of the grammar.
    pub(super) fn new(grammar: &Grammar, facts: &Facts, stack: &RuleStack) -> Self {
        let is_open =
            |from: RuleId, to: RuleId| facts.rule(to).own_template.is_none() || stack.request(from, to).is_some();
        let calls = walk::calls(grammar, |_| true);
        let kept_calls: Vec<Vec<usize>> = (0..)
            .zip(&calls)
            .map(|(from, called)| {
                called.iter().copied().filter(|to| !is_open(RuleId(from), RuleId(*to as u32))).collect()
            })
            .collect();
        let rules = (0..grammar.rules.len()).map(|rule| facts.rule(RuleId(rule as u32)));
        let (reads, needs): (Vec<Reads>, Vec<TemplateNeeds>) =
            rules.map(|rule| (rule.own_reads, rule.own_template.unwrap_or_default())).unzip();
        let (reads, needs) = (closure(&kept_calls, &reads), closure(&kept_calls, &needs));
        let mut found = TemplateHoles { reads, needs, ..TemplateHoles::default() };
        found.frequent = found.find_frequent(grammar, facts, is_open);
        let mut todo: Vec<RuleId> = Vec::new();
        each_split(grammar, |rule, slots| {
            todo.extend(found.roots(slots, rule, facts, stack).flatten().map(|root| root.rule));
        });
        let mut met: HashSet<RuleId> = HashSet::new();
        while let Some(rule) = todo.pop() {
            if !met.insert(rule) {
                continue;
            }
            for called in calls[rule.0 as usize].iter().map(|called| RuleId(*called as u32)) {
                if is_open(rule, called) {
                    found.holes.insert((rule, called));
                } else {
                    todo.push(called);
                }
            }
        }
        found.left_out = found.holes.iter().map(|(_, rule)| *rule).collect();
        found
    }

    /// Finds the frequent rules: from the parts in groups on, through rules that are even.
    fn find_frequent(
        &self,
        grammar: &Grammar,
        facts: &Facts,
        is_open: impl Fn(RuleId, RuleId) -> bool,
    ) -> HashSet<RuleId> {
        // Each rule with whether it is called while a template is made.
        let mut todo: Vec<(RuleId, bool)> = Vec::new();
        each_split(grammar, |from, slots| {
            for (target, _) in slots.targets.iter().zip(in_groups(&slots.pattern)).filter(|(_, is_in)| *is_in) {
                if let Some(rule) = facts.rule(from).is_even.then(|| called_alike(target, facts)).flatten() {
                    todo.push((rule, !is_open(from, rule)));
                }
            }
        });
        let mut met: HashSet<(RuleId, bool)> = HashSet::new();
        while let Some((rule, is_kept)) = todo.pop() {
            if !met.insert((rule, is_kept)) || !facts.rule(rule).is_even {
                continue;
            }
            walk::steps(&grammar.rules[rule.0 as usize].body, &mut |step| {
                let called = walk::targets(step).into_iter().filter_map(|target| called_alike(target, facts));
                todo.extend(called.map(|called| (called, is_kept && !is_open(rule, called))));
            });
        }
        met.into_iter().filter(|(rule, is_kept)| !is_kept && facts.rule(*rule).is_even).map(|(rule, _)| rule).collect()
    }

    /// Returns true if the call may be reached while a template is made, and is left out then.
    pub fn is_hole(&self, from: RuleId, to: RuleId) -> bool {
        self.holes.contains(&(from, to))
    }

    /// Returns true if a call of the rule is left out somewhere.
    pub(super) fn may_be_left_out(&self, rule: RuleId) -> bool {
        self.left_out.contains(&rule)
    }

    /// By slot, the template: of a rigid rule that repeats, without a request of stack, with arguments that equal parts have in common.
    pub(super) fn roots(
        &self,
        slots: &Slots,
        from: RuleId,
        facts: &Facts,
        stack: &RuleStack,
    ) -> impl Iterator<Item = Option<TemplateRoot>> {
        slots.targets.iter().zip(in_groups(&slots.pattern)).map(move |(target, is_in_group)| {
            let rule = called_alike(target, facts)?;
            let (reads, needs) = (self.reads[rule.0 as usize], self.needs[rule.0 as usize]);
            let is_template = (is_in_group || (self.frequent.contains(&from) && needs.whole))
                && facts.rule(rule).own_template.is_some()
                && stack.request(from, rule).is_none()
                && !reads.has(Reads::SHAPE);
            is_template.then(|| TemplateRoot {
                rule,
                reads: facts.listed(reads).collect(),
                is_of_run: reads.has(Reads::RUN),
                needs,
            })
        })
    }
}

/// The rule of a successor whose arguments are the same on equal parts.
fn called_alike(target: &Target, facts: &Facts) -> Option<RuleId> {
    let Target::Rule { rule, args, .. } = target else { return None };
    args.iter().all(|arg| facts.expr(arg).is_rigid()).then_some(*rule)
}

/// Calls `visit` with the rule and the slots of each split.
fn each_split<'g>(grammar: &'g Grammar, mut visit: impl FnMut(RuleId, &'g Slots)) {
    for (at, rule) in grammar.rules.iter().enumerate() {
        walk::steps(&rule.body, &mut |step| {
            if let StepKind::Block(Block { parts: BlockParts::Slots(slots), .. }) = &step.kind {
                visit(RuleId(at as u32), slots);
            }
        });
    }
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

    /// The roots of templates by rule, as `rule: root`, with the attributes and constants that they read, and the holes, as
    /// `caller → callee`.
    fn templates(rules: &str) -> (Vec<String>, Vec<String>) {
        let grammar = compile_text(rules).compiled.grammar.expect("good rules");
        let (facts, stack) = (Facts::new(&grammar), RuleStack::new(&grammar));
        let holes = TemplateHoles::new(&grammar, &facts, &stack);
        let name = |rule: RuleId| grammar.rules[rule.0 as usize].name.as_str();
        let mut list = Vec::new();
        for (at, rule) in grammar.rules.iter().enumerate() {
            walk::steps(&rule.body, &mut |step| {
                if let StepKind::Block(Block { parts: BlockParts::Slots(slots), .. }) = &step.kind {
                    let found = holes.roots(slots, RuleId(at as u32), &facts, &stack).flatten();
                    list.extend(found.map(|root| {
                        let reads = root.reads.iter().map(|id| format!(" {}", grammar.global(*id).name));
                        let of_run = if root.is_of_run { " run" } else { "" };
                        format!("{}: {}{}{of_run}", rule.name, name(root.rule), reads.collect::<String>())
                    }));
                }
            });
        }
        let mut holes: Vec<String> =
            holes.holes.iter().map(|(from, to)| format!("{} → {}", name(*from), name(*to))).collect();
        holes.sort();
        (list, holes)
    }

    #[test]
    fn a_template_is_made_of_rigid_parts_in_groups() {
        let rules = "A --> split(x) { 1 : B | { ~1 : B | 1 : X. }* }  B --> X.";
        assert_eq!(templates(rules), (vec!["A: B".to_owned()], vec![]));
        let rules = "A --> split(x) { { ~1 : B | { 1 : C }* }* | 1 : B }  B --> s(split.index, 1, 1) X.  C --> X.";
        assert_eq!(templates(rules), (vec!["A: C".to_owned()], vec![]));
    }

    #[test]
    fn a_template_depends_on_arguments_that_equal_parts_have_in_common() {
        let rules = "A --> split(x) { { ~1 : C(2) | 1 : C(scope.sy) | 1 : C(split.index) | 1 : C(rand(1)) }* }  C(n) --> s(n, 1, 1) X.";
        assert_eq!(templates(rules), (vec!["A: C".to_owned(); 2], vec![]));
    }

    #[test]
    fn a_template_depends_on_the_attributes_that_differ_and_are_read() {
        let rules = "attr fixed = 1  attr drawn = rand(1)  attr other = drawn  attr held = 2  f = other
            A --> set(held, 3) split(x) { { ~1 : B | ~1 : C | ~1 : D | ~1 : E }* }
            B --> s(fixed, 1, 1) C  C --> s(f, held, 1) X.  D --> E  E --> s(rand(1), drawn, 1) X.";
        let found = ["A: B other held", "A: C other held", "A: D"].map(str::to_owned).to_vec();
        assert_eq!(templates(rules), (found, vec!["D → E".to_owned()]));
        let rules = "attr a = case b > 1 : b else : 1  attr b = case scope.sx > 2 : 1 else : a  A --> split(x) { { ~1 : B }* }  B --> s(a, 1, 1) X.";
        assert_eq!(templates(rules), (vec!["A: B run".to_owned()], vec![]));
    }

    #[test]
    fn a_call_that_depends_on_more_than_the_size_is_a_hole() {
        let rules =
            "A --> split(x) { { ~1 : B }* }  B --> C D  C --> 30% : X. else : Y.  D --> split(y) { ~1 : E }  E --> C";
        assert_eq!(templates(rules), (vec!["A: B".to_owned()], vec!["B → C".to_owned(), "E → C".to_owned()]));
    }

    #[test]
    fn a_part_of_a_rule_that_is_called_again_and_again_is_a_template_if_it_is_a_mesh() {
        let rules = |bay: &str| {
            format!(
                "A --> split(x) {{ {{ ~1 : Bay }}* }}  Bay --> {bay}
                Window --> primitiveCylinder(8) X.  Plain --> color(1, 0, 0) X.  Sized(n) --> s(n, 1, 1) Window"
            )
        };
        let roots = |bay: &str| templates(&rules(bay)).0;
        let of = |roots: &[&str]| roots.iter().map(|root| (*root).to_owned()).collect::<Vec<_>>();
        let bay = "split(x) { ~1 : Plain | 1 : split(y) { ~1 : Window | 1 : Plain } | 1 : Sized(2) }";
        assert_eq!(roots(bay), of(&["A: Bay"]));
        // Bays that are drawn are holes, and so is a part with a drawn argument.
        let found = of(&["Bay: Bay/1", "Bay: Sized", "Bay/1: Window"]);
        assert_eq!(roots(&format!("30% : {bay} else : X.")), found);
        assert_eq!(roots(&bay.replace("1 : Plain }", "1 : Sized(rand(2)) }")), of(&["A: Bay", "Bay/1: Window"]));
        // The size differs each time, or the look.
        assert_eq!(roots(&format!("s(rand(1), 1, 1) {bay}")), of(&[]));
        assert_eq!(roots(&format!("color(rand(1), 0, 0) {bay}")), of(&[]));
        assert_eq!(roots("split(x) { rand(1) : Window | ~1 : X. }"), of(&[]));
        // A rule that does not repeat has none.
        let rules = "A --> split(x) { ~1 : B | 1 : C }  B --> 30% : split(y) { ~1 : C } else : X.  C --> primitiveCylinder(8) X.";
        assert_eq!(templates(rules), (vec![], vec![]));
    }

    #[test]
    fn a_call_that_requests_stack_is_a_hole() {
        let rules = "A --> split(x) { { ~1 : B }* }  B --> case scope.sx > 1 : s('0.5, '1, '1) B else : X.";
        assert_eq!(templates(rules), (vec!["A: B".to_owned()], vec!["B → B".to_owned()]));
        let rules = "A --> split(x) { { ~1 : A }* | 1 : X. }";
        assert_eq!(templates(rules), (vec![], vec![]));
    }
}
