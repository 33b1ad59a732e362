//! Runs that begin with a part of a later rule, because no rule is marked.
//!
//! The first rule without parameters begins a run if no rule is marked. Where another rule leads to it and no rule calls
//! that other rule, the first one is a helper.

use super::reachability::{info, is_uncalled};
use crate::analysis::{Calls, body, reach};
use crate::diag::code::Code;
use crate::diag::{Basis, Diag, Diags};
use crate::resolve::context::Context;
use crate::syntax::ast::{Op, OpKind};

/// Finds a rule that no rule calls and that leads to the start rule, unless it is another name of the start rule.
pub(crate) fn check(cx: &Context, calls: &Calls) -> Vec<Diag> {
    let (Some(&root), Some(&Some(start))) = (cx.globals.program.roots.first(), cx.tables.starts.first()) else {
        return Vec::new();
    };
    let start = start as usize;
    let rules = || cx.globals.rules.iter().enumerate().filter(|(_, item)| item.instance == root && item.home == root);
    if rules().any(|(_, item)| info(cx, item).is_some_and(|info| info.marked)) {
        return Vec::new();
    }
    let callers = calls.callers();
    let leads_there = reach(&callers, vec![start]);
    let found = rules()
        .find(|(rule, _)| leads_there[*rule] && is_uncalled(cx, &callers, *rule) && !is_alias(cx, calls, *rule, start));
    let mut diags = Diags::new();
    if let Some((_, other)) = found {
        let (first, other) = (&cx.globals.rules[start].decl.name, &other.decl.name);
        let message = format!("runs begin with `{}`, the first rule, and do not reach `{}`", first.text, other.text);
        let diag = diags.report(Code::UnmarkedStart, first.span, message);
        diag.basis = Basis::Start;
        diag.note("no rule is marked as the start");
        diag.related(format!("`{}`, which no rule calls, leads to `{}`", other.text, first.text), other.span);
        diag.help(format!(
            "write `@StartRule` before `{}`, or before `{}` if runs begin with it",
            other.text, first.text
        ));
    }
    diags.finish()
}

/// Returns true if a rule is another name of the start rule: its only step is the call, so both give the same.
fn is_alias(cx: &Context, calls: &Calls, mut rule: usize, start: usize) -> bool {
    // A cycle ends at the number of rules.
    for _ in 0..calls.edges.len() {
        if rule == start {
            return true;
        }
        match (body(&cx.globals.rules[rule]), &calls.edges[rule][..]) {
            ([Op { kind: OpKind::Call(..), .. }], [next]) => rule = *next,
            _ => return false,
        }
    }
    false
}
