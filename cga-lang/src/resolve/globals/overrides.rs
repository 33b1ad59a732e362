//! Values and rules that importing files give to imported files.

use super::{Declared, Globals, Initializer};
use crate::link::{InstanceId, Key, Program};
use crate::syntax::ast::{Expr, Override, Role};
use std::collections::{HashMap, HashSet};

/// Values of attributes in imports of an imported file, by instance and name, with the instance that has the value.
type Deep<'a> = HashMap<(InstanceId, &'a str), (&'a Expr, InstanceId)>;

impl<'a> Globals<'a> {
    /// Applies the overrides once all declarations are known.
    pub(super) fn take_overrides(&mut self) {
        let attrs = self.attrs.iter().enumerate();
        // The first attribute with a name counts.
        let by_name: HashMap<_, _> =
            attrs.rev().map(|(index, item)| ((item.instance, item.decl.name.text.as_str()), index as u32)).collect();
        let deep = deep(self.program);
        let mut replacing = HashMap::new();
        // Importing files come before imported files.
        for instance in 0..self.program.instances.len() {
            self.override_attrs(instance, &by_name, &deep);
            self.override_rules(instance, &mut replacing);
        }
    }

    /// Overrides the attributes of an imported file that get their values from the importing one.
    fn override_attrs(&mut self, id: InstanceId, by_name: &HashMap<(InstanceId, &str), u32>, deep: &Deep<'a>) {
        let instance = &self.program.instances[id];
        let Some(layer) = instance.layers.first() else { return };
        let list = self.program.overrides(layer);
        let written = written(list);
        // They are in the order of their instances.
        let first = self.attrs.partition_point(|item| item.instance < id);
        for index in first..self.attrs.partition_point(|item| item.instance <= id) {
            let item = &self.attrs[index];
            // Only attributes of the style `Default` are overridden.
            if item.decl.style != 0 {
                continue;
            }
            let name = item.decl.name.text.as_str();
            let init = match written.get(name) {
                _ if deep.contains_key(&(id, name)) => {
                    let (value, home) = deep[&(id, name)];
                    Initializer::Override(value, home)
                }
                Some(Override::Value(_, value)) => Initializer::Override(value, layer.home),
                Some(_) => continue,
                None if list.is_some_and(<[_]>::is_empty) => continue,
                None => match by_name.get(&(layer.home, name)) {
                    Some(outer) => Initializer::Flows(*outer),
                    None => continue,
                },
            };
            let mut origin = item.clone();
            origin.origin = true;
            self.attrs[index].init = init;
            self.names[id].origins.insert(name, self.consts.len() as u32);
            self.consts.push(origin);
        }
    }

    /// Replaces extensions by rules of the importing file.
    fn override_rules(&mut self, id: InstanceId, replacing: &mut HashMap<Key, u32>) {
        let instance = &self.program.instances[id];
        if instance.layers.is_empty() {
            return;
        }
        // Only rules of the style `Default` are overridden (*import*). Rules of the style in force stay.
        let (mut extensions, mut in_style) = (HashSet::new(), HashSet::new());
        for decl in &instance.file.ast.decls {
            if decl.role == Role::Extension {
                extensions.insert(decl.form());
            }
            if decl.style != 0 && instance.styles.rank(decl.style).is_some() {
                in_style.insert(decl.name.text.as_str());
            }
        }
        for layer in &instance.layers {
            for decl in self.program.overrides(layer).into_iter().flatten().filter_map(|own| match own {
                Override::Rule(decl) => Some(decl),
                _ => None,
            }) {
                let name = decl.name.text.as_str();
                let index = *replacing.entry((layer.home, decl.name.id())).or_insert_with(|| {
                    self.rules.push(Declared {
                        decl,
                        instance: id,
                        home: layer.home,
                        own: layer.home,
                        name: format!("{}{name}", instance.prefix),
                        init: Initializer::Own,
                        rank: 0,
                        origin: false,
                    });
                    self.rules.len() as u32 - 1
                });
                // An override without a fitting extension is an error and changes no calls.
                if extensions.contains(&decl.form()) && !in_style.contains(name) {
                    self.names[id].replaced.insert(name, index);
                }
            }
        }
    }
}

/// The overrides of attributes by name. The first one of a name counts.
fn written(list: Option<&[Override]>) -> HashMap<&str, &Override> {
    let mut found = HashMap::new();
    for own in list.into_iter().flatten() {
        if let Override::Keep(name) | Override::Value(name, _) = own {
            found.entry(name.text.as_str()).or_insert(own);
        }
    }
    found
}

/// The values in `id : "file" (inner.name = value)`. The outermost value of an attribute counts.
fn deep(program: &Program) -> Deep<'_> {
    let mut found = HashMap::new();
    for (id, instance) in program.instances.iter().enumerate() {
        let Some(layer) = instance.layers.first() else { continue };
        for own in program.overrides(layer).into_iter().flatten() {
            let Override::Value(path, value) = own else { continue };
            let Some((imports, name)) = path.text.rsplit_once('.') else { continue };
            let target = imports.split('.').try_fold(id, |at, import| *program.instances[at].imports.get(import)?);
            if let Some(target) = target {
                found.entry((target, name)).or_insert((value, layer.home));
            }
        }
    }
    found
}
