//! Rules that no run gets to.
//!
//! A host program may begin with any rule without parameters, marked or not. A file may be imported by others, and there
//! nothing is said.

use super::Cx;
use super::flow::{Calls, body};
use super::readings::Readings;
use crate::ast::Role;
use crate::code::Code;
use crate::diag::{Diag, Diags};

/// Looks for them, where nobody can import the rules.
pub(super) fn check(cx: &Cx, calls: &Calls) -> Vec<Diag> {
    let (globals, program) = (&cx.globals, cx.globals.program);
    if calls.starts.is_empty() || program.may_be_imported() {
        return Vec::new();
    }
    let reached = reached(cx, calls);
    // Whoever calls what is not reached is to blame; in a cycle the first.
    let mut called = vec![false; globals.rules.len()];
    for (caller, callees) in calls.edges.iter().enumerate().filter(|(caller, _)| !reached[*caller]) {
        callees.iter().filter(|callee| caller < **callee).for_each(|&callee| called[callee] = true);
    }
    let mut readings = Readings::default();
    for (rule, item) in globals.rules.iter().enumerate() {
        if !program.roots.contains(&item.instance) {
            continue;
        }
        let mut diags = Diags::new();
        if !reached[rule] && !called[rule] && !body(item).is_empty() {
            let name = &item.decl.name;
            let message = format!("rule `{}` is never reached", name.text);
            let diag = diags.report(Code::RuleNotReached, name.span, message);
            diag.note("no rule that a run gets to calls it, and no run begins with a rule that has parameters");
        }
        readings.add(program, item.decl.name.id(), diags.finish());
    }
    readings.agreed(program)
}

/// By rule: whether a run gets there.
fn reached(cx: &Cx, calls: &Calls) -> Vec<bool> {
    let globals = &cx.globals;
    let mut reached = vec![false; globals.rules.len()];
    let mut open = calls.starts.clone();
    for (rule, item) in globals.rules.iter().enumerate() {
        // What replaces or goes on with rules of imports is called from there.
        let outward = item.decl.role != Role::Plain || item.decl.name.text.contains('.') || item.home != item.instance;
        if item.decl.params.is_empty() || outward {
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
