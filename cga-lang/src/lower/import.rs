//! `id(overrides).Rule(args)`: a rule of an import whose attributes are computed again.

use super::Lower;
use crate::ir::{GlobalId, Renew, Renewal, RenewalId, StepKind, Target};
use crate::link::InstanceId;
use crate::resolve::tables::Use;
use crate::syntax::ast::{Arg, Name, Override};
use std::iter::successors;

impl<'c> Lower<'c> {
    /// Works on a copy: there the attributes and constants of the import get their values, and the rule goes on.
    pub(super) fn dynamic(
        &mut self,
        (import, overrides): (&'c Name, &'c [Override]),
        (rule, args): (&'c Name, &'c [Arg]),
    ) -> Option<StepKind> {
        let program = self.checked.globals.program;
        let own = &program.instances[program.home(self.own)];
        let target = own.dynamic.get(&import.id()).or(own.imports.get(&import.text)?.as_ref()).copied()?;
        let mut given = Vec::new();
        for own in overrides {
            if let Override::Value(name, value) = own
                && let Some(&attr) = self.checked.tables.targets.get(&(self.own, name.id()))
            {
                given.push((GlobalId(attr), self.folded(value)));
                self.out.globals[attr as usize].is_set = true;
            }
        }
        let renewal = self.renewal(target, &import.text);
        let target = match self.used(rule)? {
            Use::Leaf => Target::Leaf(format!("{}.{}", import.text, rule.text)),
            _ => self.successor(rule, args)?,
        };
        Some(StepKind::Renew(Renew { given, renewal, target }))
    }

    /// The attributes and constants that are computed again with an instance; equal for all calls.
    fn renewal(&mut self, target: InstanceId, import: &str) -> RenewalId {
        if let Some(&known) = self.renewals.get(&target) {
            return known;
        }
        let globals = self.renewed(target);
        for id in &globals {
            self.out.globals[id.0 as usize].is_set = true;
        }
        let id = RenewalId(self.out.renewals.len() as u32);
        self.out.renewals.push(Renewal { import: import.into(), globals });
        self.renewals.insert(target, id);
        id
    }

    /// The needed attributes and constants of an instance and of its imports, each after those that it uses.
    fn renewed(&self, target: InstanceId) -> Vec<GlobalId> {
        let globals = &self.checked.globals;
        let parent = |id: &InstanceId| globals.program.instances[*id].parent;
        let is_renewed = |id: &GlobalId| {
            let node = id.0 as usize;
            let item = globals.attrs.get(node).or_else(|| globals.consts.get(node - globals.attrs.len()));
            let is_below = item.is_some_and(|item| successors(Some(item.instance), parent).any(|id| id == target));
            is_below && (node < globals.attrs.len() || self.is_needed(*id) && self.out.global(*id).known.is_none())
        };
        self.checked.tables.order.iter().map(|node| GlobalId(*node as u32)).filter(is_renewed).collect()
    }
}
