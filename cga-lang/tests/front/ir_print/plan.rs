//! Decisions on how rules run: in brackets after what they concern, or one line an item.

use super::Printer;
use cga_lang::ir::plan::{ChangeForm, MaterialChange, SlimChange, SplitForm, reads_first_scope};
use cga_lang::ir::{Block, FunctionId, GlobalId, Slots, Step, Target};

impl Printer<'_> {
    /// The stack that a function requests.
    pub(super) fn function_request(&mut self, id: FunctionId) {
        if let Some(bytes) = self.plan.function_stack.request(id) {
            self.line(&format!("  requests {bytes} bytes"));
        }
    }

    /// The word for a lazy attribute or constant, with the stack that its first read requests.
    pub(super) fn lazy(&self, id: GlobalId) -> String {
        format!("lazy [{} bytes]", self.plan.lazy_stack(id))
    }

    /// The decisions on a successor of the rule that is printed: the stack that the call requests, if the call is a hole in a
    /// template, and if `NIL` moves its neighbours.
    pub(super) fn call(&self, target: &Target) -> String {
        bracketed(&self.call_words(target))
    }

    fn call_words(&self, target: &Target) -> Vec<String> {
        let mut parts = Vec::new();
        if let Target::Rule { rule, .. } = target {
            if let Some(request) = self.plan.rule_stack.request(self.rule, *rule) {
                parts.push(format!("requests {} KB", request.stack));
                if request.levels != 0 {
                    parts.push(format!("level {}", request.levels));
                }
            }
            if self.plan.holes.is_hole(self.rule, *rule) {
                parts.push("hole".into());
            }
        }
        if self.plan.vanishes(target, self.rule) {
            parts.push("vanishes".into());
        }
        parts
    }

    /// By step, the form in which it changes the current shape: on the slim shape, and once a run, a site or a value if it is a
    /// material change. Without a note it works on a whole shape.
    pub(super) fn changes(&self, steps: &[Step]) -> Vec<String> {
        let mut notes = Vec::new();
        for steps in steps.chunk_by(|a, b| a.changes_shape() && b.changes_shape()) {
            let form = if steps[0].changes_shape() { self.plan.change_form(steps) } else { ChangeForm::Whole };
            match form {
                ChangeForm::Whole => notes.extend(steps.iter().map(|_| String::new())),
                ChangeForm::Slim(changes) => notes.extend(changes.iter().flat_map(|change| {
                    let note = match change {
                        SlimChange::Nothing | SlimChange::Scope => " [slim]",
                        SlimChange::Material(change) if !change.params.is_empty() => " [slim, once for each value]",
                        SlimChange::Material(MaterialChange { sites: 0, .. }) => " [slim, once a run]",
                        SlimChange::Material(_) => " [slim, once a site]",
                    };
                    std::iter::repeat_n(note.to_owned(), change.steps())
                })),
            }
        }
        notes
    }

    /// A note if steps remember the scope that they begin with.
    pub(super) fn first_scope(&self, steps: &[Step]) -> &'static str {
        if reads_first_scope(steps) { " [first scope]" } else { "" }
    }

    /// The form of a split, and if its parts get their number.
    pub(super) fn split(&self, block: &Block, slots: &Slots) -> String {
        let mut parts = Vec::new();
        match self.plan.split_form(block, self.rule) {
            SplitForm::Solved(_) => parts.push("solved".into()),
            SplitForm::InPlace => parts.push("in place".into()),
            SplitForm::Called => {}
        }
        if self.plan.needs_total(slots) {
            parts.push("total".into());
        }
        bracketed(&parts)
    }

    /// By slot, the decisions on its successor and on its parts: if a template is made of them, and if they need a seed or
    /// counters.
    pub(super) fn parts(&self, slots: &Slots) -> Vec<String> {
        let templates = self.plan.templates(slots, self.rule);
        let parts = slots.targets.iter().zip(templates).map(|(target, template)| {
            let needs = self.plan.part_needs(target);
            let words = [(template.is_some(), "template"), (needs.draws, "seed"), (needs.counts, "counters")];
            let words = words.into_iter().filter(|(is_so, _)| *is_so).map(|(_, word)| word.to_owned());
            bracketed(&self.call_words(target).into_iter().chain(words).collect::<Vec<_>>())
        });
        parts.collect()
    }
}

fn bracketed(parts: &[String]) -> String {
    if parts.is_empty() { String::new() } else { format!(" [{}]", parts.join(", ")) }
}
