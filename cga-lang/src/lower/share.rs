//! One definition for all sites of a file that is imported several times.
//!
//! Each instance of a file is lowered on its own. The functions and rules of one declaration then become one, with the
//! site as a parameter. Attributes and constants stay separate, as each site has values of its own; a function without parameters
//! reads the value of the site.
//!
//! References in equal bodies come in the same order, so they are compared by position. Bodies that differ are a `case` on the
//! site. Definitions with different facts are not shared: code generation must not lose what it knows of one of them.

use super::definition::{CanonicalForm, Definition, Reference, Variant};
use super::merge::{interned, types};
use super::variant::{self, variants};
use crate::ir::facts::Facts;
use crate::ir::{Expr, ExprKind, Function, FunctionId, GlobalId, Grammar, RuleId, RuleSite, Target, walk};
use std::collections::HashMap;
use std::hash::Hash;

/// Definitions by declaration.
struct SiteGroups {
    /// The number of the shared definition for each definition.
    numbers: Vec<usize>,
    /// The site of each definition.
    sites: Vec<u32>,
    /// The definitions of each number, by site.
    members: Vec<Vec<usize>>,
}

/// Shares definitions; returns true if there were some to share.
pub(super) fn share(grammar: &mut Grammar) -> bool {
    if !is_repeated(grammar) {
        return false;
    }
    let (functions, rules) = groups(grammar);
    let mut shared =
        SharedDefinitions { functions: &functions, rules: &rules, readers: HashMap::new(), made: Vec::new() };

    // Values of one site each.
    for global in &mut grammar.globals {
        global.references(&mut |reference| {
            let index = reference.index();
            shared.refer(reference, &[index]);
        });
    }
    for start in &mut grammar.starts {
        start.rule = RuleId(rules.numbers[start.rule.0 as usize] as u32);
    }
    shared.definitions(&mut grammar.functions, &functions);
    for (own, sites) in grammar.functions.iter_mut().zip(functions.shared()) {
        own.sites = sites.len() as u32;
    }
    let names: Vec<RuleSite> =
        grammar.rules.iter().map(|it| RuleSite { name: it.name.clone(), label: it.label.clone() }).collect();
    shared.definitions(&mut grammar.rules, &rules);
    for (own, sites) in grammar.rules.iter_mut().zip(rules.shared()) {
        own.sites = sites.iter().map(|&rule| names[rule].clone()).collect();
        own.cycle = None;
    }
    grammar.functions.append(&mut shared.made);
    true
}

/// Returns true if some declaration has several definitions.
fn is_repeated(grammar: &Grammar) -> bool {
    let declared = grammar.rules.iter().filter(|rule| !rule.block).map(|rule| rule.span.first);
    let mut names: Vec<u32> = declared.chain(grammar.functions.iter().map(|it| it.span.first)).collect();
    names.sort_unstable();
    names.windows(2).any(|pair| pair[0] == pair[1])
}

/// The functions and the rules by declaration.
fn groups(grammar: &Grammar) -> (SiteGroups, SiteGroups) {
    let facts = Facts::new(grammar);
    let functions = grammar.functions.iter().enumerate().map(|(at, it)| {
        let uses = facts.function(FunctionId(at as u32));
        (it.span.first, it.ty, types(&it.params, &it.locals), uses, it.recursive)
    });
    (SiteGroups::new(functions), SiteGroups::new(rule_keys(grammar, &facts).into_iter()))
}

/// The part of a rule's key that tells which rule it is.
#[derive(PartialEq, Eq, Hash)]
enum RuleIdentity {
    /// The name token of its declaration. All instances of a file share its tokens.
    Declared(u32),
    /// A rule that the host program starts by number, without a site.
    Start(RuleId),
    /// A block: the key of the rule around it, and its number among the blocks of that rule.
    Block { parent: Option<usize>, number: usize },
}

/// The keys of rules, as numbers. Rules with equal keys have the same identity, types and facts.
fn rule_keys(grammar: &Grammar, facts: &Facts) -> Vec<Option<usize>> {
    let mut known = HashMap::new();
    let mut key = |at: usize, identity: RuleIdentity| {
        let (rule, facts) = (&grammar.rules[at], facts.rule(RuleId(at as u32)));
        let next = known.len();
        Some(*known.entry((identity, types(&rule.params, &rule.locals), *facts, rule.cycle.is_some())).or_insert(next))
    };
    let mut keys = vec![None; grammar.rules.len()];
    let mut todo: Vec<usize> = (0..grammar.rules.len()).filter(|&at| !grammar.rules[at].block).collect();
    for &at in &todo {
        keys[at] = key(at, RuleIdentity::Declared(grammar.rules[at].span.first));
    }
    for start in &grammar.starts {
        let at = start.rule.0 as usize;
        keys[at] = key(at, RuleIdentity::Start(start.rule));
    }
    while let Some(at) = todo.pop() {
        let mut number = 0;
        walk::steps(&grammar.rules[at].body, &mut |step| {
            for target in walk::targets(step) {
                if let Target::Rule { rule, .. } = target
                    && grammar.rules[rule.0 as usize].block
                {
                    let block = rule.0 as usize;
                    if keys[block].is_none() {
                        keys[block] = key(block, RuleIdentity::Block { parent: keys[at], number });
                        todo.push(block);
                    }
                    number += 1;
                }
            }
        });
    }
    keys
}

impl SiteGroups {
    fn new<K: Hash + Eq>(keys: impl Iterator<Item = K>) -> Self {
        let numbers = interned(keys);
        let mut members: Vec<Vec<usize>> = Vec::new();
        let mut sites = Vec::new();
        for (at, &number) in numbers.iter().enumerate() {
            members.resize(members.len().max(number + 1), Vec::new());
            sites.push(members[number].len() as u32);
            members[number].push(at);
        }
        SiteGroups { numbers, sites, members }
    }

    /// The definitions of each number by site; none for one that is not shared.
    fn shared(&self) -> impl Iterator<Item = &[usize]> {
        self.members.iter().map(|members| if members.len() == 1 { &[][..] } else { members })
    }

    /// The shared definition for the definitions of all sites of a caller, and the sites to pass to it.
    fn of(&self, list: &[u32]) -> (u32, Vec<u32>) {
        let (mut group, mut sites) = (0, Vec::new());
        for at in list.iter().map(|index| *index as usize) {
            group = self.numbers[at];
            if 1 < self.members[group].len() {
                sites.push(self.sites[at]);
            }
        }
        (group as u32, sites)
    }
}

/// The shared definitions.
struct SharedDefinitions<'g> {
    functions: &'g SiteGroups,
    rules: &'g SiteGroups,
    /// Functions that read the value of a site, by the values of all sites.
    readers: HashMap<Vec<u32>, FunctionId>,
    /// These functions. They come after the others.
    made: Vec<Function>,
}

impl SharedDefinitions<'_> {
    /// Shares the definitions of a kind, and changes their references to shared definitions.
    fn definitions<T: Definition>(&mut self, list: &mut Vec<T>, groups: &SiteGroups) {
        let items = std::mem::take(list);
        let forms: Vec<CanonicalForm> =
            items.iter().map(|it| it.form(&mut |reference| self.blank(reference))).collect();
        let references = items.iter().map(|it| {
            let mut list = Vec::new();
            it.clone().references(&mut |reference| list.push(reference.index()));
            list
        });
        let references: Vec<Vec<u32>> = references.collect();
        let mut all = variants(items, &groups.numbers, &groups.sites, &forms);
        for (variants, members) in all.iter_mut().zip(&groups.members) {
            for Variant { cases, own } in variants {
                // Sites of other variants have the references of the first site of this one.
                let first = members[cases[0] as usize];
                let sites = members.iter().zip(0..).map(|(at, site)| if cases.contains(&site) { *at } else { first });
                let sites: Vec<&Vec<u32>> = sites.map(|at| &references[at]).collect();
                let mut number = 0;
                own.references(&mut |reference| {
                    let list: Vec<u32> = sites.iter().map(|list| list[number]).collect();
                    self.refer(reference, &list);
                    number += 1;
                });
            }
        }
        *list = all.into_iter().map(|variants| T::merged(variants, ExprKind::Site)).collect();
    }

    /// Changes a reference so that definitions with references to one shared definition have one form. Values that are read
    /// are compared by position.
    fn blank(&self, reference: Reference<'_>) {
        match reference {
            Reference::Read(_, expr) => expr.kind = ExprKind::Global(GlobalId(0)),
            Reference::Call(id, _) => id.0 = self.functions.numbers[id.0 as usize] as u32,
            Reference::Rule(id, _) => id.0 = self.rules.numbers[id.0 as usize] as u32,
            Reference::Set(_) | Reference::Renewal(_) => {}
        }
    }

    /// Changes a reference to the shared definition. `list` has the references of all sites.
    fn refer(&mut self, reference: Reference<'_>, list: &[u32]) {
        match reference {
            Reference::Call(id, sites) => (id.0, *sites) = self.functions.of(list),
            Reference::Rule(id, sites) => (id.0, *sites) = self.rules.of(list),
            Reference::Read(id, expr) if list.iter().any(|it| *it != id.0) => {
                let sites = (0..list.len() as u32).collect();
                expr.kind = ExprKind::Call(self.reader(list, expr), sites, Vec::new());
            }
            Reference::Read(..) | Reference::Set(_) | Reference::Renewal(_) => {}
        }
    }

    /// A function that reads the value of its site.
    fn reader(&mut self, list: &[u32], expr: &Expr) -> FunctionId {
        if let Some(&known) = self.readers.get(list) {
            return known;
        }
        let mut values: Vec<(u32, Variant<Expr>)> = Vec::new();
        for (&index, site) in list.iter().zip(0..) {
            let kind = ExprKind::Global(GlobalId(index));
            match values.iter_mut().find(|(known, _)| *known == index) {
                Some((_, variant)) => variant.cases.push(site),
                None => values.push((index, Variant { cases: vec![site], own: Expr { kind, ..expr.clone() } })),
            }
        }
        let values = values.into_iter().map(|(_, variant)| variant).collect();
        let id = FunctionId((self.functions.members.len() + self.made.len()) as u32);
        self.made.push(Function {
            name: "of_site".into(),
            params: Vec::new(),
            locals: Vec::new(),
            ty: expr.ty,
            body: variant::chosen(values, ExprKind::Site),
            recursive: false,
            sites: list.len() as u32,
            span: expr.span,
        });
        self.readers.insert(list.to_vec(), id);
        id
    }
}
