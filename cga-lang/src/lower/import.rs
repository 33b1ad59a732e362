//! `id(overrides).Rule(args)`: a rule of an import whose attributes are computed again.

use super::Lower;
use crate::check::Checked;
use crate::ir::{GlobalId, Renew, Renewal, RenewalId, Step, Target};
use crate::link::InstanceId;
use crate::resolve::tables::Use;
use crate::syntax::ast::{Arg, Name, Override};

impl<'c> Lower<'c> {
    /// Works on a copy: there the attributes and constants of the import get their values, and the rule goes on.
    pub(super) fn dynamic(
        &mut self,
        (import, overrides): (&'c Name, &'c [Override]),
        (rule, args): (&'c Name, &'c [Arg]),
    ) -> Option<Step> {
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
        Some(Step::Renew(Renew { given, renewal, target }))
    }

    /// The attributes and constants that are computed again with an instance; equal for all calls.
    fn renewal(&mut self, target: InstanceId, import: &str) -> RenewalId {
        if let Some(&known) = self.renewals.get(&target) {
            return known;
        }
        let below = self.below.take().unwrap_or_else(|| Below::new(self.checked));
        let needed = |id: GlobalId| {
            let own = self.out.global(id);
            own.attr.is_some() || self.is_needed(id) && own.known.is_none()
        };
        let globals = below.globals(target, needed);
        self.below = Some(below);
        for id in &globals {
            self.out.globals[id.0 as usize].is_set = true;
        }
        let id = RenewalId(self.out.renewals.len() as u32);
        self.out.renewals.push(Renewal { import: import.into(), globals });
        self.renewals.insert(target, id);
        id
    }
}

/// The items and imports of each instance.
pub(super) struct Below {
    /// Its attributes and constants, with their places in the order of the program.
    own: Vec<Vec<(usize, GlobalId)>>,
    imported: Vec<Vec<InstanceId>>,
}

impl Below {
    fn new(checked: &Checked) -> Self {
        let globals = &checked.globals;
        let instances = &globals.program.instances;
        let mut below = Below { own: vec![Vec::new(); instances.len()], imported: vec![Vec::new(); instances.len()] };
        for (id, instance) in instances.iter().enumerate() {
            if let Some(parent) = instance.parent {
                below.imported[parent].push(id);
            }
        }
        for (place, &node) in checked.tables.order.iter().enumerate() {
            let item = globals.attrs.get(node).or_else(|| globals.consts.get(node - globals.attrs.len()));
            if let Some(item) = item {
                below.own[item.instance].push((place, GlobalId(node as u32)));
            }
        }
        below
    }

    /// The needed attributes and constants of an instance and of what it imports.
    fn globals(&self, target: InstanceId, needed: impl Fn(GlobalId) -> bool) -> Vec<GlobalId> {
        let (mut found, mut open) = (Vec::new(), vec![target]);
        while let Some(instance) = open.pop() {
            found.extend(self.own[instance].iter().filter(|(_, global)| needed(*global)));
            open.extend(&self.imported[instance]);
        }
        found.sort_unstable_by_key(|(place, _)| *place);
        found.into_iter().map(|(_, global)| global).collect()
    }
}
