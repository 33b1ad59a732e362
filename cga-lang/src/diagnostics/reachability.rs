//! Rules that no run reaches.
//!
//! A host program may begin with any rule without parameters, marked or not. A file may be imported by other files;
//! in such a file, only rules are reported that continue a leaf of an import that does not exist.

use super::instances::CommonDiags;
use crate::analysis::{Calls, body};
use crate::diag::code::Code;
use crate::diag::{Basis, Diag};
use crate::resolve::context::Context;
use crate::resolve::globals::{Declared, Namespace};
use crate::suggest::nearest;
use crate::syntax::ast::Role;
use std::collections::HashSet;

/// Finds these rules, if the file cannot be imported.
pub(crate) fn check(cx: &Context, calls: &Calls) -> Vec<Diag> {
    let (globals, program) = (&cx.globals, cx.globals.program);
    let mut reached = if calls.starts.is_empty() || program.may_be_imported() {
        vec![true; globals.rules.len()]
    } else {
        reached(cx, calls)
    };
    let is_called: HashSet<usize> = calls.edges.iter().flatten().copied().collect();
    for (rule, item) in globals.rules.iter().enumerate() {
        reached[rule] &= is_called.contains(&rule) || missing_import(cx, item).is_none();
    }
    // The caller of an unreached rule is reported; in a cycle the first rule.
    let mut called = vec![false; globals.rules.len()];
    for (caller, callees) in calls.edges.iter().enumerate().filter(|(caller, _)| !reached[*caller]) {
        callees.iter().filter(|callee| caller < **callee).for_each(|&callee| called[callee] = true);
    }
    let uncalled = uncalled(cx, calls);
    let skipped = skipped(cx, calls);
    let mut common = CommonDiags::default();
    for (rule, item) in globals.rules.iter().enumerate() {
        if !program.roots.contains(&item.instance) {
            continue;
        }
        common.check(item, |diags| {
            if uncalled.contains(&rule) {
                let name = &item.decl.name;
                let diag = diags.report(Code::RuleNotReached, name.span, format!("no rule calls `{}`", name.text));
                diag.basis = Basis::Start;
                if let Some(start) = calls.starts.first().map(|start| &globals.rules[*start].decl.name) {
                    diag.related(format!("runs begin with `{}`, which is marked `@StartRule`", start.text), start.span);
                }
                diag.help("write `@StartRule` before it as well, or `@Hidden`, if runs begin with it");
            }
            if let Some((start, _)) = skipped.filter(|(_, caller)| *caller == rule) {
                let (name, start) = (&item.decl.name, &globals.rules[start].decl.name);
                let message =
                    format!("runs begin with `{}`, the first rule, and no rule calls `{}`", start.text, name.text);
                let diag = diags.report(Code::RuleNotReached, name.span, message);
                diag.basis = Basis::Start;
                diag.related(format!("no rule is marked, and the first one is `{}`", start.text), start.span);
                diag.help("write `@StartRule` before the rule that runs begin with");
            }
            if !reached[rule] && !called[rule] && !body(item).is_empty() {
                let name = &item.decl.name;
                let message = format!("rule `{}` is never reached", name.text);
                let diag = diags.report(Code::RuleNotReached, name.span, message);
                match missing_import(cx, item) {
                    Some(import) => {
                        diag.note(format!("there is no import `{import}`, and no rule here calls `{}`", name.text));
                        match nearest(import, globals.near(item.instance, Namespace::Imports)) {
                            Some(near) => diag.suggest(Some(near.to_owned())),
                            None => diag.help(format!("import a file: `import {import} : \"{import}.cga\"`")),
                        };
                    }
                    None => {
                        diag.note(
                            "no rule that a run reaches calls it, and no run begins with a rule that has parameters",
                        );
                    }
                }
            }
        });
    }
    common.finish()
}

/// The rules without parameters that no rule calls and no annotation names, if another rule is marked as the start.
fn uncalled(cx: &Context, calls: &Calls) -> HashSet<usize> {
    let program = cx.globals.program;
    let mut others: HashSet<usize> = HashSet::new();
    for (caller, callees) in calls.edges.iter().enumerate() {
        others.extend(callees.iter().filter(|callee| **callee != caller));
    }
    let info = |item: &Declared| cx.tables.rules.get(&item.key());
    let is_root = |item: &Declared| program.roots.contains(&item.instance) && !is_outward(item);
    let is_marked = |item: &Declared| is_root(item) && info(item).is_some_and(|info| info.marked);
    if program.may_be_imported() || !cx.globals.rules.iter().any(is_marked) {
        return HashSet::new();
    }
    let rules = cx.globals.rules.iter().enumerate();
    let alone = rules.filter(|(rule, item)| {
        let is_named = info(item).is_some_and(|info| info.marked || info.hidden);
        is_root(item) && item.decl.params.is_empty() && !is_named && !others.contains(rule) && !body(item).is_empty()
    });
    alone.map(|(rule, _)| rule).collect()
}

/// The first rule, with which runs begin as no rule is marked, and the first later rule that leads to it and that no rule calls: the
/// first rule looks like a helper.
fn skipped(cx: &Context, calls: &Calls) -> Option<(usize, usize)> {
    let (globals, program) = (&cx.globals, cx.globals.program);
    let info = |rule: usize| cx.tables.rules.get(&globals.rules[rule].key());
    let is_root =
        |rule: usize| program.roots.contains(&globals.rules[rule].instance) && !is_outward(&globals.rules[rule]);
    let rules = 0..globals.rules.len();
    if program.may_be_imported() || rules.clone().any(|rule| info(rule).is_some_and(|info| info.marked)) {
        return None;
    }
    let start = *calls.starts.first()?;
    let is_called =
        |rule: usize| (0..).zip(&calls.edges).any(|(caller, callees)| caller != rule && callees.contains(&rule));
    let leads_there = |from: usize| {
        let (mut seen, mut open) = (vec![false; globals.rules.len()], vec![from]);
        while let Some(rule) = open.pop() {
            if !std::mem::replace(&mut seen[rule], true) {
                open.extend(&calls.edges[rule]);
            }
        }
        seen[start]
    };
    let mut later = rules.filter(|&rule| start < rule && is_root(rule) && globals.rules[rule].decl.params.is_empty());
    let found =
        later.find(|&rule| !info(rule).is_some_and(|info| info.hidden) && !is_called(rule) && leads_there(rule));
    found.map(|found| (start, found))
}

/// Returns true if a rule replaces or continues a rule of an import, and is called from there.
fn is_outward(item: &Declared) -> bool {
    item.decl.role != Role::Plain || item.decl.name.text.contains('.') || item.home != item.instance
}

/// The import before the name of a rule, if the file has no such import.
fn missing_import<'a>(cx: &Context<'a, '_>, item: &Declared<'a>) -> Option<&'a str> {
    let program = cx.globals.program;
    let (import, _) = item.decl.name.text.split_once('.')?;
    let is_known = program.instances[item.instance].imports.contains_key(import);
    (!is_known && !cx.globals.is_lost(item.instance, import)).then_some(import)
}

/// Returns true for each rule that a run reaches.
fn reached(cx: &Context, calls: &Calls) -> Vec<bool> {
    let globals = &cx.globals;
    let mut reached = vec![false; globals.rules.len()];
    let mut open = calls.starts.clone();
    for (rule, item) in globals.rules.iter().enumerate() {
        if item.decl.params.is_empty() || is_outward(item) {
            open.push(rule);
        }
    }
    while let Some(rule) = open.pop() {
        if !std::mem::replace(&mut reached[rule], true) {
            open.extend(&calls.edges[rule]);
        }
    }
    reached
}
