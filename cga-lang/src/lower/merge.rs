//! Merges the styles of the compiled file: one definition for each declared name.
//!
//! Each style is lowered on its own, and the style of a run never changes. So definitions of one name become one definition.
//! Where they differ, it chooses by style: values are a `case` on the style, and so is the body of a rule.
//!
//! Definitions are *one name* if their kind, their name, their types and their number among equal ones of a style are equal.
//! References are compared by name, so one pass finds all that differs. A block is a part of its rule: blocks of a name are one
//! only if they are equal.

use super::variant::{attr, constant, function, rule, variants};
use crate::graph::{components, is_cycle};
use crate::ir::{
    AttrId, ChoiceValues, ConstId, Expr, ExprKind, Function, FunctionId, Global, Grammar, Init, Param, Renewal,
    RenewalId, RuleId, Step, Target, Type, print, walk,
};
use std::collections::HashMap;
use std::hash::Hash;

/// The style that each definition belongs to, by kind. Blocks have none: they follow the rules.
#[derive(Default)]
pub(super) struct Owners {
    pub(super) attrs: Vec<u32>,
    pub(super) consts: Vec<u32>,
    pub(super) functions: Vec<u32>,
    pub(super) rules: Vec<u32>,
}

/// The number of the merged definition for each definition, by kind.
struct Merged {
    attrs: Vec<usize>,
    consts: Vec<usize>,
    functions: Vec<usize>,
    renewals: Vec<usize>,
    rules: Vec<usize>,
}

/// Merges the styles of a grammar. `init` has the attributes and constants of each style.
pub(super) fn merge(grammar: &mut Grammar, owners: &Owners, init: &[Vec<Global>]) {
    let mut named = grammar.clone();
    let attrs = numbers(&grammar.attrs, &owners.attrs, |attr| (attr.name.clone(), attr.ty, attr.public));
    let consts = numbers(&grammar.consts, &owners.consts, |it| (it.name.clone(), it.ty));
    let functions = functions(&grammar.functions, &owners.functions);
    let declared = &grammar.rules[..owners.rules.len()];
    let rules = numbers(declared, &owners.rules, |it| (it.label.clone(), types(&it.params, &it.locals)));
    // In texts, references are by number.
    named.attrs.iter_mut().zip(&attrs).for_each(|(it, number)| it.name = format!("attr {number}"));
    named.consts.iter_mut().zip(&consts).for_each(|(it, number)| it.name = format!("const {number}"));
    named.functions.iter_mut().zip(&functions).for_each(|(it, number)| it.name = format!("function {number}"));
    named.rules.iter_mut().zip(&rules).for_each(|(it, number)| it.name = format!("rule {number}"));
    let renewals = renewals(grammar, &attrs, &consts);
    named.renewals.iter_mut().zip(&renewals).for_each(|(it, number)| it.import = format!("renewal {number}"));
    let (rules, texts) = blocks(&mut named, rules);
    let merged = Merged { attrs, consts, functions, renewals, rules };

    let text = |value: &Expr| print::expr(&named, value);
    let attrs = std::mem::take(&mut grammar.attrs);
    let attr_texts: Vec<String> = attrs.iter().map(|attr| text(&attr.default)).collect();
    grammar.attrs = variants(attrs, &merged.attrs, &owners.attrs, &attr_texts)
        .into_iter()
        .map(|it| attr(it, ExprKind::Style))
        .collect();
    let consts = std::mem::take(&mut grammar.consts);
    let const_texts: Vec<String> = consts.iter().map(|it| text(&it.value)).collect();
    grammar.consts = variants(consts, &merged.consts, &owners.consts, &const_texts)
        .into_iter()
        .map(|it| constant(it, ExprKind::Style))
        .collect();
    let function_texts: Vec<String> = named.functions.iter().map(|it| print::function(&named, it)).collect();
    let functions = std::mem::take(&mut grammar.functions);
    let functions = variants(functions, &merged.functions, &owners.functions, &function_texts);
    grammar.functions = functions.into_iter().map(|it| function(it, ExprKind::Style)).collect();
    let mut owners = owners.rules.clone();
    owners.resize(grammar.rules.len(), 0);
    let rules = variants(std::mem::take(&mut grammar.rules), &merged.rules, &owners, &texts);
    grammar.rules = rules.into_iter().map(|it| rule(it, ExprKind::Style)).collect();
    keep_first(&mut grammar.renewals, &merged.renewals);

    refer(grammar, &merged);
    order(grammar, &merged, init);
}

/// The number of the merged function for each function.
pub(super) fn functions(functions: &[Function], owners: &[u32]) -> Vec<usize> {
    numbers(functions, owners, |it| (it.name.clone(), it.ty, types(&it.params, &it.locals)))
}

/// Numbers definitions by key, and by number among those of one key in their style.
pub(super) fn numbers<T, K: Hash + Eq + Clone>(items: &[T], owners: &[u32], key: impl Fn(&T) -> K) -> Vec<usize> {
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
fn renewals(grammar: &Grammar, attrs: &[usize], consts: &[usize]) -> Vec<usize> {
    interned(grammar.renewals.iter().map(|renewal| {
        let number = |global: &Global| match *global {
            Global::Attr(id) => attrs[id.0 as usize],
            Global::Const(id) => attrs.len() + consts[id.0 as usize],
        };
        let mut globals: Vec<usize> = renewal.globals.iter().map(number).collect();
        globals.sort_unstable();
        (&renewal.import, globals)
    }))
}

/// Numbers the blocks after the declared rules, and returns the texts of all rules.
fn blocks(named: &mut Grammar, declared: Vec<usize>) -> (Vec<usize>, Vec<String>) {
    let (first, count) = (declared.len(), named.rules.len());
    let mut texts = vec![String::new(); count];
    let mut known: HashMap<(String, String), usize> = HashMap::new();
    let mut blocks = vec![0; count - first];
    // Blocks in a block come after it.
    for at in (first..count).rev() {
        let own = &mut named.rules[at];
        own.name.clear();
        let label = own.label.clone();
        let text = print::rule(named, &named.rules[at]);
        let next = known.len();
        blocks[at - first] = *known.entry((label, text)).or_insert(next);
        named.rules[at].name = format!("block {}", blocks[at - first]);
    }
    for (text, rule) in texts.iter_mut().zip(&named.rules[..first]) {
        *text = print::rule(named, rule);
    }
    let numbers = declared.into_iter().map(|rule| (false, rule)).chain(blocks.into_iter().map(|block| (true, block)));
    (interned(numbers), texts)
}

fn keep_first<T>(items: &mut Vec<T>, numbers: &[usize]) {
    let (mut numbers, mut next) = (numbers.iter(), 0);
    items.retain(|_| {
        let is_first = numbers.next() == Some(&next);
        next += usize::from(is_first);
        is_first
    });
}

/// Changes all references to the merged definitions.
fn refer(grammar: &mut Grammar, merged: &Merged) {
    let attr = |id: &mut AttrId| *id = AttrId(merged.attrs[id.0 as usize] as u32);
    let constant = |id: &mut ConstId| *id = ConstId(merged.consts[id.0 as usize] as u32);
    let rule = |id: &mut RuleId| *id = RuleId(merged.rules[id.0 as usize] as u32);
    walk::all_exprs_mut(grammar, &mut |expr| match &mut expr.kind {
        ExprKind::Attr(id) => attr(id),
        ExprKind::Const(id) => constant(id),
        ExprKind::Call(id, ..) => *id = FunctionId(merged.functions[id.0 as usize] as u32),
        _ => {}
    });
    for own in &mut grammar.attrs {
        if let Some(ChoiceValues::Attr(id)) = own.info.choices.as_mut().map(|choices| &mut choices.values) {
            attr(id);
        }
    }
    for global in grammar.renewals.iter_mut().flat_map(|renewal| &mut renewal.globals) {
        *global = merged.global(*global);
    }
    for own in &mut grammar.rules {
        walk::steps_mut(&mut own.body, &mut |step| {
            match step {
                Step::SetAttr(id, ..) => attr(id),
                Step::Renew(call) => {
                    call.given.iter_mut().for_each(|(id, _)| attr(id));
                    call.renewal = RenewalId(merged.renewals[call.renewal.0 as usize] as u32);
                }
                _ => {}
            }
            for target in walk::targets_mut(step) {
                if let Target::Rule { rule: id, .. } = target {
                    rule(id);
                }
            }
        });
    }
    grammar.starts.iter_mut().for_each(|start| rule(&mut start.rule));
}

impl Merged {
    fn global(&self, global: Global) -> Global {
        match global {
            Global::Attr(id) => Global::Attr(AttrId(self.attrs[id.0 as usize] as u32)),
            Global::Const(id) => Global::Const(ConstId(self.consts[id.0 as usize] as u32)),
        }
    }
}

/// Finds an order in which each attribute and constant is ready before it is used, in all styles. Where only different styles
/// close a cycle, its values are lazy.
fn order(grammar: &mut Grammar, merged: &Merged, init: &[Vec<Global>]) {
    let mut styles: HashMap<Global, Vec<u32>> = HashMap::new();
    for (style, list) in init.iter().enumerate() {
        for global in list {
            styles.entry(merged.global(*global)).or_default().push(style as u32);
        }
    }
    let (attrs, consts) = (grammar.attrs.len(), grammar.consts.len());
    let needs = |values: &mut dyn Iterator<Item = &Expr>| {
        let mut list = Vec::new();
        for value in values {
            walk::parts(value, &mut |part| match part.kind {
                ExprKind::Attr(id) => list.push(id.0 as usize),
                ExprKind::Const(id) => list.push(attrs + id.0 as usize),
                ExprKind::Call(id, ..) => list.push(attrs + consts + id.0 as usize),
                _ => {}
            });
        }
        list.sort_unstable();
        list.dedup();
        list
    };
    let edges: Vec<Vec<usize>> = (grammar.attrs.iter().map(|it| needs(&mut [&it.default].into_iter())))
        .chain(grammar.consts.iter().map(|it| needs(&mut [&it.value].into_iter())))
        .chain(grammar.functions.iter().map(|it| needs(&mut it.locals.iter().chain([&it.body]))))
        .collect();
    let mut places: HashMap<Global, usize> = HashMap::new();
    for component in components(&edges) {
        let is_cycle = is_cycle(&component, &edges);
        for node in component {
            let global = if let Some(attr) = grammar.attrs.get_mut(node) {
                attr.lazy = is_cycle;
                Global::Attr(AttrId(node as u32))
            } else if let Some(own) = grammar.consts.get_mut(node - attrs) {
                own.lazy = is_cycle && own.known.is_none();
                Global::Const(ConstId((node - attrs) as u32))
            } else {
                grammar.functions[node - attrs - consts].recursive = is_cycle;
                continue;
            };
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
