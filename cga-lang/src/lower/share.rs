//! One definition for all sites of a file that is imported several times.
//!
//! Each instance of a file is lowered on its own. The functions and rules of one declaration then become one, which is told its
//! site by its caller. Attributes and constants stay apart, as each site has values of its own. A function without parameters
//! reads the one of the site.
//!
//! References in equal bodies come in the same order, so they are compared by position. Bodies that differ are a `case` on the
//! site. Definitions with different facts are not shared: code generation must not lose what it knows of one of them.

use std::collections::HashMap;

use crate::facts::Facts;
use crate::ir::{AttrId, ConstId, Expr, ExprKind, Function, FunctionId, Grammar, Rule, RuleId, RuleSite, Step, Target};
use crate::{ir_print, ir_walk};

use super::merge::{interned, types};
use super::variant::{self, Variant, variants};

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

/// Shares definitions; returns true if there were some to share.
pub(super) fn share(grammar: &mut Grammar) -> bool {
    if !is_repeated(grammar) {
        return false;
    }
    let facts = Facts::new(grammar);
    let functions = Groups::new(grammar.functions.iter().enumerate().map(|(at, it)| {
        let uses = facts.function(FunctionId(at as u32));
        format!("{:?} {:?} {:?} {uses:?} {}", it.span, it.ty, types(&it.params, &it.locals), it.recursive)
    }));
    let rules = Groups::new(rule_keys(grammar, &facts).into_iter());
    let mut named = grammar.clone();
    named.attrs.iter_mut().for_each(|it| it.name = format!("a value of type {:?}", it.ty));
    named.consts.iter_mut().for_each(|it| it.name = format!("a value of type {:?}", it.ty));
    named.functions.iter_mut().zip(&functions.numbers).for_each(|(it, number)| it.name = format!("function {number}"));
    for (number, (rule, group)) in named.rules.iter_mut().zip(&rules.numbers).enumerate() {
        rule.name = format!("rule {group}");
        rule.cycle = None;
        // What is set is part of the text.
        let (attrs, renewals) = changed(&grammar.rules[number]);
        rule.label = format!("sets {attrs:?}, computes {renewals:?} again");
    }
    let function_texts: Vec<String> = named.functions.iter().map(|it| ir_print::function(&named, it)).collect();
    let rule_texts: Vec<String> =
        named.rules.iter().map(|it| format!("{}{}", it.label, ir_print::rule(&named, it))).collect();

    let names: Vec<RuleSite> =
        grammar.rules.iter().map(|it| RuleSite { name: it.name.clone(), label: it.label.clone() }).collect();
    let mut shared = Shared { functions, rules, first: 0, readers: HashMap::new(), made: Vec::new() };
    shared.first = shared.functions.members.len();
    let refs = |walk: &mut dyn FnMut(&mut dyn FnMut(Place<'_>))| {
        let mut list = Vec::new();
        walk(&mut |place| list.push(place.reference()));
        list
    };
    let function_refs: Vec<Vec<Reference>> =
        named.functions.iter_mut().map(|it| refs(&mut |visit| in_function(it, visit))).collect();
    let rule_refs: Vec<Vec<Reference>> =
        named.rules.iter_mut().map(|it| refs(&mut |visit| in_rule(it, visit))).collect();

    grammar.attrs.iter_mut().for_each(|it| in_expr(&mut it.default, &mut |place| shared.alone(place)));
    grammar.consts.iter_mut().for_each(|it| in_expr(&mut it.value, &mut |place| shared.alone(place)));
    for start in &mut grammar.starts {
        start.rule = RuleId(shared.rules.numbers[start.rule.0 as usize] as u32);
    }
    let old = std::mem::take(&mut grammar.functions);
    for (group, mut variants) in shared.functions.variants(old, &function_texts).into_iter().enumerate() {
        let members = shared.functions.members[group].clone();
        for variant in &mut variants {
            let lists = lists(&members, &variant.cases, &function_refs);
            let mut lists = lists.iter();
            in_function(&mut variant.own, &mut |place| shared.refer(place, lists.next()));
        }
        let sites = if members.len() == 1 { 0 } else { members.len() as u32 };
        grammar.functions.push(Function { sites, ..variant::function(variants, ExprKind::Site) });
    }
    let old = std::mem::take(&mut grammar.rules);
    for (group, mut variants) in shared.rules.variants(old, &rule_texts).into_iter().enumerate() {
        let members = shared.rules.members[group].clone();
        for variant in &mut variants {
            let lists = lists(&members, &variant.cases, &rule_refs);
            let mut lists = lists.iter();
            in_rule(&mut variant.own, &mut |place| shared.refer(place, lists.next()));
        }
        let sites = members.iter().filter(|_| 1 < members.len()).map(|&rule| names[rule].clone()).collect();
        grammar.rules.push(Rule { sites, cycle: None, ..variant::rule(variants, ExprKind::Site) });
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
        ir_walk::steps(&grammar.rules[at].body, &mut |step| {
            for target in ir_walk::targets(step) {
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

/// The attributes that a rule sets, and the imports that it computes again.
fn changed(rule: &Rule) -> (Vec<AttrId>, Vec<u32>) {
    let (mut attrs, mut renewals) = (Vec::new(), Vec::new());
    ir_walk::steps(&rule.body, &mut |step| match step {
        Step::SetAttr(id, ..) => attrs.push(*id),
        Step::Anew(anew) => {
            attrs.extend(anew.given.iter().map(|(id, _)| *id));
            renewals.push(anew.renewal.0);
        }
        _ => {}
    });
    (attrs, renewals)
}

/// For each reference of a variant, the references of all sites. Sites of other variants have that of its first site.
fn lists(members: &[usize], cases: &[u32], refs: &[Vec<Reference>]) -> Vec<Vec<Reference>> {
    let of = |site: u32| &refs[members[site as usize]];
    let list = |at: usize| {
        let site = |site: u32| if cases.contains(&site) { of(site)[at] } else { of(cases[0])[at] };
        (0..members.len() as u32).map(site).collect()
    };
    (0..of(cases[0]).len()).map(list).collect()
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

    fn variants<T>(&self, items: Vec<T>, texts: &[String]) -> Vec<Vec<Variant<T>>> {
        variants(items, &self.numbers, &self.sites, texts)
    }

    /// The shared definition for those of all sites, and the site to tell it.
    fn of(&self, list: &[usize]) -> (u32, Vec<u32>) {
        let group = self.numbers[list[0]];
        let is_shared = 1 < self.members[group].len();
        let sites = list.iter().filter(|_| is_shared).map(|&at| self.sites[at]);
        (group as u32, sites.collect())
    }
}

/// The shared definitions.
struct Shared {
    functions: Groups,
    rules: Groups,
    /// The number of the first function in `made`.
    first: usize,
    /// Functions that read the value of a site.
    readers: HashMap<Vec<Reference>, FunctionId>,
    made: Vec<Function>,
}

impl Shared {
    /// Changes a reference of a value that is not shared.
    fn alone(&mut self, place: Place<'_>) {
        let reference = place.reference();
        self.refer(place, Some(&vec![reference]));
    }

    /// Changes a reference to the shared definition. `list` has the references of all sites.
    fn refer(&mut self, place: Place<'_>, list: Option<&Vec<Reference>>) {
        let Some(list) = list else { return };
        match place {
            Place::Rule(rule, sites) => {
                let rules: Vec<usize> = list.iter().filter_map(|it| it.rule()).collect();
                let (number, told) = self.rules.of(&rules);
                (*rule, *sites) = (RuleId(number), told);
            }
            Place::Expr(expr) => match &mut expr.kind {
                ExprKind::Call(id, sites, _) => {
                    let functions: Vec<usize> = list.iter().filter_map(|it| it.function()).collect();
                    let (number, told) = self.functions.of(&functions);
                    (*id, *sites) = (FunctionId(number), told);
                }
                _ if list.iter().any(|it| *it != list[0]) => {
                    let reader = self.reader(list, expr);
                    expr.kind = ExprKind::Call(reader, (0..list.len() as u32).collect(), Vec::new());
                }
                _ => {}
            },
        }
    }

    /// A function that reads the value of its site.
    fn reader(&mut self, list: &[Reference], expr: &Expr) -> FunctionId {
        if let Some(&known) = self.readers.get(list) {
            return known;
        }
        let mut values: Vec<Variant<Expr>> = Vec::new();
        let mut by_value: HashMap<Reference, usize> = HashMap::new();
        for (site, reference) in list.iter().enumerate() {
            let kind = match *reference {
                Reference::Attr(id) => ExprKind::Attr(id),
                Reference::Const(id) => ExprKind::Const(id),
                Reference::Function(_) | Reference::Rule(_) => continue,
            };
            let next = values.len();
            let at = *by_value.entry(*reference).or_insert(next);
            if at == next {
                values.push(Variant { cases: Vec::new(), own: Expr { kind, ..expr.clone() } });
            }
            values[at].cases.push(site as u32);
        }
        let id = FunctionId((self.first + self.made.len()) as u32);
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

/// The place of a reference.
enum Place<'p> {
    /// An attribute, a constant or a call.
    Expr(&'p mut Expr),
    Rule(&'p mut RuleId, &'p mut Vec<u32>),
}

impl Place<'_> {
    fn reference(&self) -> Reference {
        match self {
            Place::Rule(rule, _) => Reference::Rule(**rule),
            Place::Expr(expr) => match expr.kind {
                ExprKind::Attr(id) => Reference::Attr(id),
                ExprKind::Call(id, ..) => Reference::Function(id),
                ExprKind::Const(id) => Reference::Const(id),
                _ => unreachable!("places are references"),
            },
        }
    }
}

/// The references in an expression.
fn in_expr(expr: &mut Expr, visit: &mut dyn FnMut(Place<'_>)) {
    ir_walk::parts_mut(expr, &mut |part| {
        if matches!(part.kind, ExprKind::Attr(_) | ExprKind::Const(_) | ExprKind::Call(..)) {
            visit(Place::Expr(part));
        }
    });
}

fn in_function(function: &mut Function, visit: &mut dyn FnMut(Place<'_>)) {
    function.locals.iter_mut().for_each(|local| in_expr(local, visit));
    in_expr(&mut function.body, visit);
}

fn in_rule(rule: &mut Rule, visit: &mut dyn FnMut(Place<'_>)) {
    rule.locals.iter_mut().for_each(|local| in_expr(local, visit));
    ir_walk::exprs_mut(&mut rule.body, &mut |expr| in_expr(expr, visit));
    ir_walk::steps_mut(&mut rule.body, &mut |step| {
        for target in ir_walk::targets_mut(step) {
            if let Target::Rule { rule, sites, .. } = target {
                visit(Place::Rule(rule, sites));
            }
        }
    });
}
