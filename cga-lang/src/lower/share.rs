//! One definition for all sites of a file that is imported several times.
//!
//! Each instance of a file is lowered on its own. The functions and rules of one declaration then become one, with the
//! site as a parameter. Attributes and constants stay separate, as each site has values of its own; a function without parameters
//! reads the value of the site.
//!
//! References in equal bodies come in the same order, so they are compared by position. Bodies that differ are a `case` on the
//! site. Definitions with different facts are not shared: code generation must not lose what it knows of one of them.

use super::merge::{interned, types};
use super::variant::{self, Variant, variants};
use crate::ir::facts::Facts;
use crate::ir::{
    AttrId, ConstId, Expr, ExprKind, Function, FunctionId, Grammar, Rule, RuleId, RuleSite, Step, Target, print, walk,
};
use std::collections::HashMap;

/// Definitions by declaration.
struct Groups {
    /// The number of the shared definition for each definition.
    numbers: Vec<usize>,
    /// The site of each definition.
    sites: Vec<u32>,
    /// The definitions of each number, by site.
    members: Vec<Vec<usize>>,
}

/// A reference in a function or rule.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Reference {
    Attr(AttrId),
    Const(ConstId),
    Function(FunctionId),
    Rule(RuleId),
}

/// The expression or successor that has a reference.
enum Referrer<'p> {
    /// An attribute, a constant or a call.
    Expr(&'p mut Expr),
    /// The rule of a successor.
    Rule(&'p mut RuleId, &'p mut Vec<u32>),
}

/// Visits all references in a definition, in one order.
type Visit<T> = fn(&mut T, &mut dyn FnMut(Reference, Referrer<'_>));

/// Shares definitions; returns true if there were some to share.
pub(super) fn share(grammar: &mut Grammar) -> bool {
    if !is_repeated(grammar) {
        return false;
    }
    let (functions, rules) = groups(grammar);
    let (function_texts, rule_texts) = texts(grammar, &functions, &rules);
    let mut shared = Shared { functions: &functions, rules: &rules, readers: HashMap::new(), made: Vec::new() };

    grammar.attrs.iter_mut().for_each(|it| shared.alone(&mut it.default));
    grammar.consts.iter_mut().for_each(|it| shared.alone(&mut it.value));
    for start in &mut grammar.starts {
        start.rule = RuleId(rules.numbers[start.rule.0 as usize] as u32);
    }
    let all = shared.variants(std::mem::take(&mut grammar.functions), &functions, &function_texts, in_function);
    grammar.functions = all.into_iter().map(|own| variant::function(own, ExprKind::Site)).collect();
    for (own, sites) in grammar.functions.iter_mut().zip(functions.shared()) {
        own.sites = sites.len() as u32;
    }
    let names: Vec<RuleSite> =
        grammar.rules.iter().map(|it| RuleSite { name: it.name.clone(), label: it.label.clone() }).collect();
    let all = shared.variants(std::mem::take(&mut grammar.rules), &rules, &rule_texts, in_rule);
    grammar.rules = all.into_iter().map(|own| variant::rule(own, ExprKind::Site)).collect();
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
fn groups(grammar: &Grammar) -> (Groups, Groups) {
    let facts = Facts::new(grammar);
    let functions = grammar.functions.iter().enumerate().map(|(at, it)| {
        let uses = facts.function(FunctionId(at as u32));
        format!("{:?} {:?} {:?} {uses:?} {}", it.span, it.ty, types(&it.params, &it.locals), it.recursive)
    });
    (Groups::new(functions), Groups::new(rule_keys(grammar, &facts).into_iter()))
}

/// The keys of rules: the declaration and the types, or the place in the rule around a block.
fn rule_keys(grammar: &Grammar, facts: &Facts) -> Vec<String> {
    let mut keys = vec![String::new(); grammar.rules.len()];
    let known = |at: usize| {
        let (rule, facts) = (&grammar.rules[at], facts.rule(RuleId(at as u32)));
        format!("{:?} {facts:?} {}", types(&rule.params, &rule.locals), rule.cycle.is_some())
    };
    let mut todo: Vec<usize> = (0..grammar.rules.len()).filter(|&at| !grammar.rules[at].block).collect();
    for &at in &todo {
        keys[at] = format!("{:?} {}", grammar.rules[at].span, known(at));
    }
    // The host program starts these by number, without a site.
    for start in &grammar.starts {
        keys[start.rule.0 as usize] = format!("start {}", start.rule.0);
    }
    while let Some(at) = todo.pop() {
        let mut number = 0;
        walk::steps(&grammar.rules[at].body, &mut |step| {
            for target in walk::targets(step) {
                if let Target::Rule { rule, .. } = target
                    && grammar.rules[rule.0 as usize].block
                {
                    let block = rule.0 as usize;
                    if keys[block].is_empty() {
                        keys[block] = format!("{number} {} in {}", known(block), keys[at]);
                        todo.push(block);
                    }
                    number += 1;
                }
            }
        });
    }
    keys
}

/// The texts of functions and rules, without the names of what they refer to: these are compared by position.
fn texts(grammar: &Grammar, functions: &Groups, rules: &Groups) -> (Vec<String>, Vec<String>) {
    let mut named = grammar.clone();
    named.attrs.iter_mut().for_each(|it| it.name = format!("a {:?}", it.ty));
    named.consts.iter_mut().for_each(|it| it.name = format!("a {:?}", it.ty));
    named.functions.iter_mut().zip(&functions.numbers).for_each(|(it, number)| it.name = format!("function {number}"));
    for (rule, number) in named.rules.iter_mut().zip(&rules.numbers) {
        rule.name = format!("rule {number}");
        rule.cycle = None;
    }
    let functions = named.functions.iter().map(|it| print::function(&named, it)).collect();
    let rules = named.rules.iter().map(|it| format!("{:?} {}", changed(it), print::rule(&named, it))).collect();
    (functions, rules)
}

/// The attributes that a rule sets, and the imports that it computes again.
fn changed(rule: &Rule) -> (Vec<AttrId>, Vec<u32>) {
    let (mut attrs, mut renewals) = (Vec::new(), Vec::new());
    walk::steps(&rule.body, &mut |step| match step {
        Step::SetAttr(id, ..) => attrs.push(*id),
        Step::Renew(call) => {
            attrs.extend(call.given.iter().map(|(id, _)| *id));
            renewals.push(call.renewal.0);
        }
        _ => {}
    });
    (attrs, renewals)
}

impl Groups {
    fn new(keys: impl Iterator<Item = String>) -> Self {
        let numbers = interned(keys);
        let mut members: Vec<Vec<usize>> = Vec::new();
        let mut sites = Vec::new();
        for (at, &number) in numbers.iter().enumerate() {
            members.resize(members.len().max(number + 1), Vec::new());
            sites.push(members[number].len() as u32);
            members[number].push(at);
        }
        Groups { numbers, sites, members }
    }

    /// The definitions of each number by site; none for one that is not shared.
    fn shared(&self) -> impl Iterator<Item = &[usize]> {
        self.members.iter().map(|members| if members.len() == 1 { &[][..] } else { members })
    }

    /// The shared definition for those of all sites of a caller, and the sites to pass to it.
    fn of(&self, list: impl Iterator<Item = usize>) -> (u32, Vec<u32>) {
        let (mut group, mut sites) = (0, Vec::new());
        for at in list {
            group = self.numbers[at];
            if 1 < self.members[group].len() {
                sites.push(self.sites[at]);
            }
        }
        (group as u32, sites)
    }
}

/// The shared definitions.
struct Shared<'g> {
    functions: &'g Groups,
    rules: &'g Groups,
    /// Functions that read the value of a site, by the values of all sites.
    readers: HashMap<Vec<Reference>, FunctionId>,
    /// These functions. They come after the others.
    made: Vec<Function>,
}

impl Shared<'_> {
    /// The variants of each shared definition, with references to shared definitions.
    fn variants<T: Clone>(
        &mut self,
        items: Vec<T>,
        groups: &Groups,
        texts: &[String],
        visit: Visit<T>,
    ) -> Vec<Vec<Variant<T>>> {
        let references = items.clone().into_iter().map(|mut item| {
            let mut list = Vec::new();
            visit(&mut item, &mut |reference, _| list.push(reference));
            list
        });
        let references: Vec<Vec<Reference>> = references.collect();
        let mut all = variants(items, &groups.numbers, &groups.sites, texts);
        for (variants, members) in all.iter_mut().zip(&groups.members) {
            for Variant { cases, own } in variants {
                // Sites of other variants have the references of the first site of this one.
                let first = members[cases[0] as usize];
                let sites = members.iter().zip(0..).map(|(at, site)| if cases.contains(&site) { *at } else { first });
                let sites: Vec<&Vec<Reference>> = sites.map(|at| &references[at]).collect();
                let mut number = 0;
                visit(own, &mut |_, referrer| {
                    let list: Vec<Reference> = sites.iter().map(|list| list[number]).collect();
                    self.refer(referrer, &list);
                    number += 1;
                });
            }
        }
        all
    }

    /// Changes the references of a value that is not shared.
    fn alone(&mut self, value: &mut Expr) {
        in_expr(value, &mut |reference, referrer| self.refer(referrer, &[reference]));
    }

    /// Changes a reference to the shared definition. `list` has the references of all sites.
    fn refer(&mut self, referrer: Referrer<'_>, list: &[Reference]) {
        match referrer {
            Referrer::Rule(rule, sites) => {
                let (number, passed) = self.rules.of(list.iter().filter_map(|it| it.rule()));
                (*rule, *sites) = (RuleId(number), passed);
            }
            Referrer::Expr(Expr { kind: ExprKind::Call(function, sites, _), .. }) => {
                let (number, passed) = self.functions.of(list.iter().filter_map(|it| it.function()));
                (*function, *sites) = (FunctionId(number), passed);
            }
            Referrer::Expr(expr) if list.iter().any(|it| *it != list[0]) => {
                let sites = (0..list.len() as u32).collect();
                expr.kind = ExprKind::Call(self.reader(list, expr), sites, Vec::new());
            }
            Referrer::Expr(_) => {}
        }
    }

    /// A function that reads the value of its site.
    fn reader(&mut self, list: &[Reference], expr: &Expr) -> FunctionId {
        if let Some(&known) = self.readers.get(list) {
            return known;
        }
        let mut values: Vec<(Reference, Variant<Expr>)> = Vec::new();
        for (reference, site) in list.iter().zip(0..) {
            let kind = match *reference {
                Reference::Attr(id) => ExprKind::Attr(id),
                Reference::Const(id) => ExprKind::Const(id),
                Reference::Function(_) | Reference::Rule(_) => continue,
            };
            match values.iter_mut().find(|(known, _)| known == reference) {
                Some((_, variant)) => variant.cases.push(site),
                None => values.push((*reference, Variant { cases: vec![site], own: Expr { kind, ..expr.clone() } })),
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

impl Reference {
    fn rule(self) -> Option<usize> {
        if let Reference::Rule(id) = self { Some(id.0 as usize) } else { None }
    }

    fn function(self) -> Option<usize> {
        if let Reference::Function(id) = self { Some(id.0 as usize) } else { None }
    }
}

fn in_expr(expr: &mut Expr, visit: &mut dyn FnMut(Reference, Referrer<'_>)) {
    walk::parts_mut(expr, &mut |part| {
        let reference = match part.kind {
            ExprKind::Attr(id) => Reference::Attr(id),
            ExprKind::Const(id) => Reference::Const(id),
            ExprKind::Call(id, ..) => Reference::Function(id),
            _ => return,
        };
        visit(reference, Referrer::Expr(part));
    });
}

fn in_function(function: &mut Function, visit: &mut dyn FnMut(Reference, Referrer<'_>)) {
    function.locals.iter_mut().for_each(|local| in_expr(local, visit));
    in_expr(&mut function.body, visit);
}

fn in_rule(rule: &mut Rule, visit: &mut dyn FnMut(Reference, Referrer<'_>)) {
    rule.locals.iter_mut().for_each(|local| in_expr(local, visit));
    walk::exprs_mut(&mut rule.body, &mut |expr| in_expr(expr, visit));
    walk::steps_mut(&mut rule.body, &mut |step| {
        for target in walk::targets_mut(step) {
            if let Target::Rule { rule, sites, .. } = target {
                visit(Reference::Rule(*rule), Referrer::Rule(rule, sites));
            }
        }
    });
}
