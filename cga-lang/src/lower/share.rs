//! What styles have in common, found again.
//!
//! Each style of the root has attributes, constants, functions and rules of its own at first. Those that mean the same
//! become one: all of a kind and a name are held to be the same until their text, with names of such groups in it, says
//! otherwise.

use crate::ir::{
    AttrId, ConstId, Expr, ExprKind, FunctionId, Global, Grammar, HostId, RenewalId, RuleId, Step, Target,
};
use crate::{ir_print, ir_walk};
use std::collections::{HashMap, HashSet};

/// Characters of text after which nothing is shared: each round, which writes all items, finds differences one call
/// further away.
const MOST_TEXT: usize = 400_000_000;

/// The group of each item, by kind.
#[derive(Default, PartialEq)]
struct Groups {
    attrs: Vec<usize>,
    consts: Vec<usize>,
    functions: Vec<usize>,
    renewals: Vec<usize>,
    rules: Vec<usize>,
}

/// Makes one of what means the same in several styles. Each is kept where it stands first.
pub(super) fn share(grammar: &mut Grammar) {
    share_hosts(grammar);
    if grammar.init.len() < 2 {
        return;
    }
    let Some(groups) = groups(grammar) else { return };
    let (attrs, consts) = (kept(&groups.attrs), kept(&groups.consts));
    let (functions, rules) = (kept(&groups.functions), kept(&groups.rules));
    retain(&mut grammar.attrs, &attrs);
    retain(&mut grammar.consts, &consts);
    retain(&mut grammar.functions, &functions);
    let renewals = kept(&groups.renewals);
    retain(&mut grammar.rules, &rules);
    retain(&mut grammar.renewals, &renewals);
    let expr = |expr: &mut Expr| match &mut expr.kind {
        ExprKind::Attr(id) => *id = AttrId(attrs[id.0 as usize].0),
        ExprKind::Const(id) => *id = ConstId(consts[id.0 as usize].0),
        ExprKind::Call(id, _) => *id = FunctionId(functions[id.0 as usize].0),
        _ => {}
    };
    let global = |global| match global {
        Global::Attr(id) => Global::Attr(AttrId(attrs[id.0 as usize].0)),
        Global::Const(id) => Global::Const(ConstId(consts[id.0 as usize].0)),
    };
    exprs(grammar, &expr);
    for renewal in &mut grammar.renewals {
        renewal.globals.iter_mut().for_each(|own| *own = global(*own));
    }
    for rule in &mut grammar.rules {
        ir_walk::steps_mut(&mut rule.body, &mut |step| {
            match step {
                Step::SetAttr(id, ..) => *id = AttrId(attrs[id.0 as usize].0),
                Step::Anew(anew) => {
                    anew.given.iter_mut().for_each(|(id, _)| *id = AttrId(attrs[id.0 as usize].0));
                    anew.renewal = RenewalId(renewals[anew.renewal.0 as usize].0);
                }
                _ => {}
            }
            for target in ir_walk::targets_mut(step) {
                if let Target::Rule { rule, .. } = target {
                    *rule = RuleId(rules[rule.0 as usize].0);
                }
            }
        });
    }
    for start in &mut grammar.starts {
        start.rule = RuleId(rules[start.rule.0 as usize].0);
    }
    for list in &mut grammar.init {
        let mut seen = HashSet::new();
        *list = list.iter().map(|own| global(*own)).filter(|own| seen.insert(*own)).collect();
    }
}

/// A Rust value is the same one in every style.
fn share_hosts(grammar: &mut Grammar) {
    let mut first: HashMap<(u32, crate::ir::Type), u32> = HashMap::new();
    let mut kept = Vec::new();
    let mut numbers = Vec::with_capacity(grammar.hosts.len());
    for host in std::mem::take(&mut grammar.hosts) {
        let number = *first.entry((host.handle, host.ty)).or_insert(kept.len() as u32);
        if number as usize == kept.len() {
            kept.push(host);
        }
        numbers.push(number);
    }
    let changed = kept.len() < numbers.len();
    grammar.hosts = kept;
    if changed {
        exprs(grammar, &|expr: &mut Expr| {
            if let ExprKind::Host(id) = &mut expr.kind {
                *id = HostId(numbers[id.0 as usize]);
            }
        });
    }
}

/// Which items mean the same; `None` if that takes too long to find out.
fn groups(grammar: &Grammar) -> Option<Groups> {
    let mut named = grammar.clone();
    let mut groups = Groups::default();
    // Names tell apart what must not become one in any case; those of rules have their style in front.
    for rule in &mut named.rules {
        rule.name.clone_from(&rule.label);
    }
    let attrs: Vec<String> = grammar.attrs.iter().map(|attr| format!("{} {}", attr.name, attr.public)).collect();
    let mut written = 0;
    while written < MOST_TEXT {
        let texts = ir_print::items(&named);
        written += texts.len();
        let own = |names: Vec<&String>, texts: Vec<String>| -> Vec<usize> {
            let mut numbers: HashMap<(&String, String), usize> = HashMap::new();
            names
                .into_iter()
                .zip(texts)
                .map(|key| {
                    let next = numbers.len();
                    *numbers.entry(key).or_insert(next)
                })
                .collect()
        };
        let found = Groups {
            attrs: own(attrs.iter().collect(), texts.attrs),
            consts: own(grammar.consts.iter().map(|it| &it.name).collect(), texts.consts),
            functions: own(grammar.functions.iter().map(|it| &it.name).collect(), texts.functions),
            renewals: own(grammar.renewals.iter().map(|it| &it.import).collect(), texts.renewals),
            rules: own(grammar.rules.iter().map(|it| &it.label).collect(), texts.rules),
        };
        if found == groups {
            return Some(groups);
        }
        for (at, it) in named.attrs.iter_mut().enumerate() {
            it.name = format!("attr {}", found.attrs[at]);
        }
        for (at, it) in named.consts.iter_mut().enumerate() {
            it.name = format!("const {}", found.consts[at]);
        }
        for (at, it) in named.functions.iter_mut().enumerate() {
            it.name = format!("function {}", found.functions[at]);
        }
        for (at, it) in named.renewals.iter_mut().enumerate() {
            it.import = format!("renewal {}", found.renewals[at]);
        }
        for (at, it) in named.rules.iter_mut().enumerate() {
            it.name = format!("rule {}", found.rules[at]);
        }
        groups = found;
    }
    None
}

/// For each item its new number, and whether it is kept.
fn kept(groups: &[usize]) -> Vec<(u32, bool)> {
    let mut numbers: HashMap<usize, u32> = HashMap::new();
    groups
        .iter()
        .map(|group| {
            let next = numbers.len() as u32;
            let number = *numbers.entry(*group).or_insert(next);
            (number, number == next)
        })
        .collect()
}

fn retain<T>(items: &mut Vec<T>, kept: &[(u32, bool)]) {
    let mut kept = kept.iter();
    items.retain(|_| kept.next().is_some_and(|(_, kept)| *kept));
}

/// Every expression with its parts.
fn exprs(grammar: &mut Grammar, change: &dyn Fn(&mut Expr)) {
    fn parts(expr: &mut Expr, change: &dyn Fn(&mut Expr)) {
        change(expr);
        expr.parts_mut().into_iter().for_each(|part| parts(part, change));
    }
    grammar.attrs.iter_mut().for_each(|it| parts(&mut it.default, change));
    grammar.consts.iter_mut().for_each(|it| parts(&mut it.value, change));
    for function in &mut grammar.functions {
        function.locals.iter_mut().for_each(|local| parts(local, change));
        parts(&mut function.body, change);
    }
    for rule in &mut grammar.rules {
        rule.locals.iter_mut().for_each(|local| parts(local, change));
        ir_walk::exprs_mut(&mut rule.body, &mut |expr| parts(expr, change));
    }
}
