//! The rules that led to a shape.

use std::rc::Rc;

use super::Env;
use crate::value::text::Text;

/// The number of rules that a trail names. Longer trails lose their middle, so that memory stays bounded.
const LONGEST_TRAIL: usize = 2048;

/// The rules that led to a deferred call, shared by all calls deferred below them.
#[derive(Debug)]
pub(crate) struct Trail {
    pub(super) before: Option<Rc<Trail>>,
    pub(super) rules: Box<[u32]>,
    /// The number of rules from the start rule on.
    depth: usize,
}

impl Drop for Trail {
    /// Drops the list in a loop: a deep recursion makes a long list, and a recursive drop would need as much stack.
    fn drop(&mut self) {
        let mut next = self.before.take();
        while let Some(mut trail) = next.and_then(Rc::into_inner) {
            next = trail.before.take();
        }
    }
}

impl Env {
    /// The trail so far, shared by deferred calls. It names at least one rule.
    pub(crate) fn keep_trail(&mut self) -> Rc<Trail> {
        if let Some(tree) = &mut self.tree {
            tree.wait(self.trail.len());
        }
        let level = self.trail.len();
        if let Some(keys) = self.keys() {
            keys.wait(level);
        }
        // A deferred block enters no rule.
        if let (Some(before), []) = (&self.before, self.trail.as_slice()) {
            return before.clone();
        }
        Rc::new(Trail { before: self.before.clone(), rules: self.trail.as_slice().into(), depth: self.depth() })
    }

    /// Returns to the trail of a deferred call.
    pub(crate) fn resume_trail(&mut self, trail: Rc<Trail>) {
        self.before = Some(trail);
        self.trail.clear();
        if let Some(tree) = &mut self.tree {
            tree.resume();
        }
        if let Some(keys) = self.keys() {
            keys.resume();
        }
    }

    /// The depth of the current shape in the tree of shapes: the number of rules from the start rule on.
    pub(super) fn depth(&self) -> usize {
        self.before.as_ref().map_or(0, |before| before.depth) + self.trail.len()
    }

    /// The rules that led here, from the start rule down.
    pub(super) fn trail(&self) -> Vec<Text> {
        let mut parts = vec![self.trail.as_slice()];
        let mut before = self.before.as_deref();
        while let Some(trail) = before {
            parts.push(&trail.rules);
            before = trail.before.as_deref();
        }
        let name = |&rule: &u32| self.rule_name(rule);
        let count: usize = parts.iter().map(|part| part.len()).sum();
        let rules = parts.into_iter().rev().flatten();
        if count <= LONGEST_TRAIL {
            return rules.map(name).collect();
        }
        let half = LONGEST_TRAIL / 2;
        let (head, tail) = (rules.clone().take(half), rules.skip(count - half));
        head.map(name).chain([Text::fixed("…")]).chain(tail.map(name)).collect()
    }
}
