//! `id(overrides).Rule(args)`: a rule of an import whose attributes start anew.

use super::Lower;
use crate::ast::{Arg, Name, Override};
use crate::check::Use;
use crate::ir::{Attr, AttrId, ConstId, Expr, ExprKind, Global, Step, Target};
use crate::link::InstanceId;
use crate::span::Span;
use std::collections::HashMap;

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
        for (instance, attr) in self.values_in_order() {
            if self.is_below(instance, target) && !given.contains(&attr.0) {
                let value = self.out.attrs[attr.0 as usize].default.clone();
                steps.push(Step::SetAttr(attr, value, span));
                given.push(attr.0);
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

    /// Attributes, and constants that became some, in an order in which each is ready before it is used.
    fn values_in_order(&self) -> Vec<(InstanceId, AttrId)> {
        let globals = &self.checked.globals;
        let order = self.checked.tables.order.iter().filter_map(|&node| match globals.attrs.get(node) {
            Some(item) => Some((item.instance, AttrId(node as u32))),
            None => {
                let constant = node - globals.attrs.len();
                let attr = self.renewed.get(&ConstId(constant as u32))?;
                Some((globals.consts[constant].instance, *attr))
            }
        });
        order.collect()
    }

    /// Constants of an import that starts anew are computed anew too, unless their value is known anyway: from here on
    /// they are attributes.
    pub(super) fn renew_constants(&mut self) {
        let globals = &self.checked.globals;
        for (index, item) in globals.consts.iter().enumerate() {
            let own = &self.out.consts[index];
            let renewed = self.checked.tables.renewed.iter().any(|&target| self.is_below(item.instance, target));
            if own.known.is_some() || !renewed {
                continue;
            }
            let id = AttrId(self.out.attrs.len() as u32);
            self.renewed.insert(ConstId(index as u32), id);
            self.out.attrs.push(Attr::hidden(own.name.clone(), own.value.clone(), own.span));
        }
        if self.renewed.is_empty() {
            return;
        }
        let renewed = &self.renewed;
        let out = &mut self.out;
        let values = out.attrs.iter_mut().map(|attr| &mut attr.default);
        let functions = out.functions.iter_mut().flat_map(|own| own.locals.iter_mut().chain([&mut own.body]));
        for value in values.chain(out.consts.iter_mut().map(|own| &mut own.value)).chain(functions) {
            rename(value, renewed);
        }
        for global in out.init.iter_mut().flatten() {
            if let Global::Const(id) = global
                && let Some(&attr) = renewed.get(id)
            {
                *global = Global::Attr(attr);
            }
        }
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

/// Reads constants that became attributes as such.
fn rename(expr: &mut Expr, renewed: &HashMap<ConstId, AttrId>) {
    if let ExprKind::Const(id) = &expr.kind
        && let Some(&attr) = renewed.get(id)
    {
        expr.kind = ExprKind::Attr(attr);
    }
    for part in expr.parts_mut() {
        rename(part, renewed);
    }
}
