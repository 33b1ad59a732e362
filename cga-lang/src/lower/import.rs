//! `id(overrides).Rule(args)`: a rule of an import whose attributes start anew.

use super::Lower;
use crate::ast::{Arg, Name, Override};
use crate::check::Use;
use crate::ir::{AttrId, Step, Target};
use crate::link::InstanceId;
use crate::span::Span;

impl<'c> Lower<'c> {
    /// Works on a copy: there the attributes of the import get their values, the given ones first, and the rule goes on.
    pub(super) fn dynamic(
        &mut self,
        (import, overrides): (&'c Name, &'c [Override]),
        (rule, args): (&'c Name, &'c [Arg]),
        span: Span,
    ) -> Option<Step> {
        let program = self.checked.globals.program;
        let own = &program.instances[self.home];
        let target = own.dynamic.get(&import.id()).or(own.imports.get(&import.text)?.as_ref()).copied()?;
        let mut steps = Vec::new();
        let mut given = Vec::new();
        for own in overrides {
            if let Override::Value(name, value) = own
                && let Some(&attr) = self.checked.tables.targets.get(&name.id())
            {
                given.push(attr);
                steps.push(Step::SetAttr(AttrId(attr), self.folded(value), span));
            }
        }
        for &node in &self.checked.tables.order {
            let Some(item) = self.checked.globals.attrs.get(node) else { continue };
            if self.is_below(item.instance, target) && !given.contains(&(node as u32)) {
                let value = self.out.attrs[node].default.clone();
                steps.push(Step::SetAttr(AttrId(node as u32), value, span));
                given.push(node as u32);
            }
        }
        for attr in given {
            self.out.attrs[attr as usize].is_set = true;
        }
        steps.push(match self.used(rule)? {
            Use::Leaf => Step::Give(Target::Leaf(format!("{}.{}", import.text, rule.text), rule.span)),
            _ => Step::Give(self.successor(rule, args)?),
        });
        Some(Step::Push(steps))
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
