//! `id(overrides).Rule(args)`: a rule of an import whose attributes start anew.

use super::Lower;
use crate::ast::{Arg, Name, Override};
use crate::check::Use;
use crate::ir::{Anew, AttrId, ConstId, Global, Step, Target};
use crate::link::InstanceId;
use crate::span::Span;

impl<'c> Lower<'c> {
    /// Works on a copy: there the attributes and constants of the import get their values, and the rule goes on.
    pub(super) fn dynamic(
        &mut self,
        (import, overrides): (&'c Name, &'c [Override]),
        (rule, args): (&'c Name, &'c [Arg]),
        span: Span,
    ) -> Option<Step> {
        let program = self.checked.globals.program;
        let own = &program.instances[self.home];
        let target = own.dynamic.get(&import.id()).or(own.imports.get(&import.text)?.as_ref()).copied()?;
        let mut given = Vec::new();
        for own in overrides {
            if let Override::Value(name, value) = own
                && let Some(&attr) = self.checked.tables.targets.get(&name.id())
            {
                given.push((AttrId(attr), self.folded(value)));
                self.out.attrs[attr as usize].is_set = true;
            }
        }
        let mut computed = Vec::new();
        let attrs = self.out.attrs.len();
        for &node in &self.checked.tables.order {
            let globals = &self.checked.globals;
            if let Some(item) = globals.attrs.get(node) {
                let id = AttrId(node as u32);
                if self.is_below(item.instance, target) && given.iter().all(|(own, _)| *own != id) {
                    let own = &mut self.out.attrs[node];
                    own.is_set = true;
                    computed.push((Global::Attr(id), own.default.clone()));
                }
            } else if let Some(index) = node.checked_sub(attrs)
                && let Some(item) = globals.consts.get(index)
                && self.is_below(item.instance, target)
                && self.is_needed(index)
            {
                let own = &mut self.out.consts[index];
                if own.known.is_none() {
                    own.is_set = true;
                    computed.push((Global::Const(ConstId(index as u32)), own.value.clone()));
                }
            }
        }
        let target = match self.used(rule)? {
            Use::Leaf => Target::Leaf(format!("{}.{}", import.text, rule.text), rule.span),
            _ => self.successor(rule, args)?,
        };
        Some(Step::Anew(Anew { given, computed, target, span }))
    }

    /// Whether an instance is another one or imported by it.
    fn is_below(&self, mut instance: InstanceId, of: InstanceId) -> bool {
        loop {
            if instance == of {
                return true;
            }
            match self.checked.globals.program.instances[instance].parent {
                Some(parent) => instance = parent,
                None => return false,
            }
        }
    }
}
