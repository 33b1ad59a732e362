//! Rules that no run reaches.
//!
//! A host program may begin with any rule without parameters, marked or not. A file may be imported by other files;
//! in such a file, only rules are reported that continue a leaf of an import that does not exist.

use super::instances::CommonDiags;
use crate::analysis::{Calls, body, reach};
use crate::diag::code::Code;
use crate::diag::{Basis, Diag};
use crate::resolve::context::Context;
use crate::resolve::globals::{Declared, Namespace};
use crate::resolve::info::RuleInfo;
use crate::suggest::nearest;
use crate::syntax::ast::Role;

/// Finds these rules, if the file cannot be imported.
pub(crate) fn check(cx: &Context, calls: &Calls) -> Vec<Diag> {
    let (globals, program) = (&cx.globals, cx.globals.program);
    let mut reached = if calls.starts.is_empty() || program.may_be_imported() {
        vec![true; globals.rules.len()]
    } else {
        reached(cx, calls)
    };
    let callers = calls.callers();
    for (rule, item) in globals.rules.iter().enumerate() {
        reached[rule] &= !callers[rule].is_empty() || missing_import(cx, item).is_none();
    }
    // The caller of an unreached rule is reported; in a cycle the first rule.
    let mut called = vec![false; globals.rules.len()];
    for (caller, callees) in calls.edges.iter().enumerate().filter(|(caller, _)| !reached[*caller]) {
        callees.iter().filter(|callee| caller < **callee).for_each(|&callee| called[callee] = true);
    }
    let is_marked = |item: &Declared| info(cx, item).is_some_and(|info| info.marked);
    let has_start = globals.rules.iter().any(|item| is_root(cx, item) && is_marked(item));
    let mut common = CommonDiags::default();
    for (rule, item) in globals.rules.iter().enumerate() {
        if !program.roots.contains(&item.instance) {
            continue;
        }
        common.check(item, |diags| {
            if has_start && !program.may_be_imported() && is_uncalled(cx, &callers, rule) {
                let name = &item.decl.name;
                let diag = diags.report(Code::RuleNotReached, name.span, format!("no rule calls `{}`", name.text));
                diag.basis = Basis::Start;
                if let Some(start) = calls.starts.first().map(|start| &globals.rules[*start].decl.name) {
                    diag.related(format!("runs begin with `{}`, which is marked `@StartRule`", start.text), start.span);
                }
                diag.help("write `@StartRule` before it as well, or `@Hidden`, if runs begin with it");
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

/// Returns true for a rule without parameters that no other rule calls and no annotation names.
pub(super) fn is_uncalled(cx: &Context, callers: &[Vec<usize>], rule: usize) -> bool {
    let item = &cx.globals.rules[rule];
    let is_named = info(cx, item).is_some_and(|info| info.marked || info.hidden);
    let is_called = callers[rule].iter().any(|caller| *caller != rule);
    is_root(cx, item) && item.decl.params.is_empty() && !is_named && !is_called && !body(item).is_empty()
}

/// The annotations of a rule.
pub(super) fn info<'a>(cx: &'a Context, item: &Declared) -> Option<&'a RuleInfo> {
    cx.tables.rules.get(&item.key())
}

/// Returns true for a rule that is declared in the file itself.
fn is_root(cx: &Context, item: &Declared) -> bool {
    cx.globals.program.roots.contains(&item.instance) && !is_outward(item)
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
    let mut starts = calls.starts.clone();
    for (rule, item) in cx.globals.rules.iter().enumerate() {
        if item.decl.params.is_empty() || is_outward(item) {
            starts.push(rule);
        }
    }
    reach(&calls.edges, starts)
}
