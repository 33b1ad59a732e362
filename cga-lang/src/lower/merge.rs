//! Merges the styles of the compiled file: one definition for each declared name.
//!
//! Each style is lowered on its own, and the style of a run never changes. So definitions of one name become one definition.
//! Where they differ, it chooses by style: values are a `case` on the style, and so is the body of a rule.
//!
//! Definitions are *one name* if their kind, their name, their types and their number among equal ones of a style are equal.
//! References are compared by these numbers, so one pass finds all that differs. A block is a part of its rule: blocks of a name are one
//! only if they are equal.

use super::definition::{CanonicalForm, Definition, Reference};
use super::variant::variants;
use crate::graph::{components, is_cycle};
use crate::ir::{
    ChoiceValues, Expr, ExprKind, Function, Global, GlobalId, Grammar, Init, Param, Renewal, Rule, Type, walk,
};
use std::collections::HashMap;
use std::hash::Hash;

/// The style that each definition belongs to, by kind. Blocks have none: they follow the rules.
#[derive(Default)]
pub(super) struct DefinitionStyles {
    pub(super) globals: Vec<u32>,
    pub(super) functions: Vec<u32>,
    pub(super) rules: Vec<u32>,
}

/// The number of the merged definition for each definition, by kind.
struct Merged {
    globals: Vec<usize>,
    functions: Vec<usize>,
    renewals: Vec<usize>,
    rules: Vec<usize>,
}

/// Merges the styles of a grammar. `init` has the attributes and constants of each style.
pub(super) fn merge(grammar: &mut Grammar, owners: &DefinitionStyles, init: &[Vec<GlobalId>]) {
    let globals = globals(&grammar.globals, &owners.globals);
    let functions = functions(&grammar.functions, &owners.functions);
    let declared = &grammar.rules[..owners.rules.len()];
    let rules = numbers(declared, &owners.rules, |it| (it.label.clone(), types(&it.params, &it.locals)));
    let renewals = renewals(grammar, &globals);
    let mut merged = Merged { globals, functions, renewals, rules };
    merged.blocks(&grammar.rules);

    merged.definitions(&mut grammar.globals, &merged.globals, &owners.globals);
    merged.definitions(&mut grammar.functions, &merged.functions, &owners.functions);
    let mut owners = owners.rules.clone();
    owners.resize(grammar.rules.len(), 0);
    merged.definitions(&mut grammar.rules, &merged.rules, &owners);
    keep_first(&mut grammar.renewals, &merged.renewals);
    for attr in grammar.globals.iter_mut().filter_map(|global| global.attr.as_mut()) {
        if let Some(ChoiceValues::Attr(id)) = attr.choices.as_mut().map(|choices| &mut choices.values) {
            *id = merged.global(*id);
        }
    }
    for global in grammar.renewals.iter_mut().flat_map(|renewal| &mut renewal.globals) {
        *global = merged.global(*global);
    }
    grammar.starts.iter_mut().for_each(|start| renumber(&mut start.rule.0, &merged.rules));
    order(grammar, &merged, init);
}

/// The number of the merged definition for each attribute and constant.
pub(super) fn globals(globals: &[Global], owners: &[u32]) -> Vec<usize> {
    numbers(globals, owners, |it| (it.attr.is_some(), it.name.clone(), it.ty, it.public))
}

/// The number of the merged function for each function.
pub(super) fn functions(functions: &[Function], owners: &[u32]) -> Vec<usize> {
    numbers(functions, owners, |it| (it.name.clone(), it.ty, types(&it.params, &it.locals)))
}

/// Numbers definitions by key, and by number among the definitions of one key in their style.
fn numbers<T, K: Hash + Eq + Clone>(items: &[T], owners: &[u32], key: impl Fn(&T) -> K) -> Vec<usize> {
    let mut counts: HashMap<(u32, K), usize> = HashMap::new();
    let keys = items.iter().zip(owners).map(|(item, &style)| {
        let count = counts.entry((style, key(item))).or_insert(0);
        *count += 1;
        (key(item), *count)
    });
    interned(keys)
}

/// Numbers keys in the order in which they come first.
pub(super) fn interned<K: Hash + Eq>(keys: impl Iterator<Item = K>) -> Vec<usize> {
    let mut known = HashMap::new();
    keys.map(|key| {
        let next = known.len();
        *known.entry(key).or_insert(next)
    })
    .collect()
}

/// The types of the parameters that are given.
pub(super) fn types(params: &[Param], locals: &[Expr]) -> Vec<Type> {
    params[..params.len() - locals.len()].iter().map(|param| param.ty).collect()
}

/// Renewals of one number compute the same values again.
fn renewals(grammar: &Grammar, numbers: &[usize]) -> Vec<usize> {
    interned(grammar.renewals.iter().map(|renewal| {
        let mut globals: Vec<usize> = renewal.globals.iter().map(|global| numbers[global.0 as usize]).collect();
        globals.sort_unstable();
        (&renewal.import, globals)
    }))
}

fn keep_first<T>(items: &mut Vec<T>, numbers: &[usize]) {
    let (mut numbers, mut next) = (numbers.iter(), 0);
    items.retain(|_| {
        let is_first = numbers.next() == Some(&next);
        next += usize::from(is_first);
        is_first
    });
}

fn renumber(index: &mut u32, numbers: &[usize]) {
    *index = numbers[*index as usize] as u32;
}

impl Merged {
    fn global(&self, id: GlobalId) -> GlobalId {
        GlobalId(self.globals[id.0 as usize] as u32)
    }

    /// Changes a reference to the merged definition.
    fn refer(&self, reference: Reference<'_>) {
        match reference {
            Reference::Read(id, expr) => expr.kind = ExprKind::Global(self.global(id)),
            Reference::Call(id, _) => renumber(&mut id.0, &self.functions),
            Reference::Rule(id, _) => renumber(&mut id.0, &self.rules),
            Reference::Set(id) => *id = self.global(*id),
            Reference::Renewal(id) => renumber(&mut id.0, &self.renewals),
        }
    }

    /// Numbers the blocks after the declared rules.
    fn blocks(&mut self, rules: &[Rule]) {
        let declared = self.rules.len();
        self.rules.resize(rules.len(), 0);
        let mut known: HashMap<&str, Vec<(CanonicalForm, usize)>> = HashMap::new();
        // Blocks in a block come after it. Equal ones have the index of one of them until all are known.
        for (at, rule) in rules.iter().enumerate().skip(declared).rev() {
            let form = rule.form(&mut |reference| self.refer(reference));
            let list = known.entry(&rule.label).or_default();
            self.rules[at] = match list.iter().find(|(known, _)| *known == form) {
                Some((_, equal)) => *equal,
                None => {
                    list.push((form, at));
                    at
                }
            };
        }
        self.rules = interned(self.rules.iter());
    }

    /// Merges the definitions of a kind.
    fn definitions<T: Definition>(&self, list: &mut Vec<T>, numbers: &[usize], owners: &[u32]) {
        list.iter_mut().for_each(|it| it.references(&mut |reference| self.refer(reference)));
        let forms: Vec<CanonicalForm> = list.iter().map(|it| it.form(&mut |_| {})).collect();
        let merged = variants(std::mem::take(list), numbers, owners, &forms);
        *list = merged.into_iter().map(|variants| T::merged(variants, ExprKind::Style)).collect();
    }
}

/// Finds an order in which each attribute and constant is ready before it is used, in all styles. Where only different styles
/// close a cycle, its values are lazy.
fn order(grammar: &mut Grammar, merged: &Merged, init: &[Vec<GlobalId>]) {
    let mut styles: HashMap<GlobalId, Vec<u32>> = HashMap::new();
    for (style, list) in init.iter().enumerate() {
        for global in list {
            styles.entry(merged.global(*global)).or_default().push(style as u32);
        }
    }
    let count = grammar.globals.len();
    let needs = |values: &mut dyn Iterator<Item = &Expr>| {
        let mut list = Vec::new();
        for value in values {
            walk::parts(value, &mut |part| match part.kind {
                ExprKind::Global(id) => list.push(id.0 as usize),
                ExprKind::Call(id, ..) => list.push(count + id.0 as usize),
                _ => {}
            });
        }
        list.sort_unstable();
        list.dedup();
        list
    };
    let edges: Vec<Vec<usize>> = (grammar.globals.iter().map(|it| needs(&mut [&it.value].into_iter())))
        .chain(grammar.functions.iter().map(|it| needs(&mut it.locals.iter().chain([&it.body]))))
        .collect();
    let mut places: HashMap<GlobalId, usize> = HashMap::new();
    for component in components(&edges) {
        let is_cycle = is_cycle(&component, &edges);
        for node in component {
            let Some(own) = grammar.globals.get_mut(node) else {
                grammar.functions[node - count].recursive = is_cycle;
                continue;
            };
            own.lazy = is_cycle && own.known.is_none();
            let global = GlobalId(node as u32);
            places.insert(global, places.len());
            if let Some(styles) = styles.remove(&global) {
                let styles = Some(styles).filter(|styles| styles.len() < init.len());
                grammar.init.push(Init { global, styles });
            }
        }
    }
    for Renewal { globals, .. } in &mut grammar.renewals {
        globals.sort_by_key(|global| places.get(global).copied());
    }
}
