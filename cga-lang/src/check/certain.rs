//! Runs the checks that follow from what is known of shapes and values.

use super::flow::{Attrs, Calls, Facts, Flow, Site};
use super::readings::Readings;
use super::{Cx, arithmetic, branches, defaults, repeat, size};
use crate::diag::Diags;

pub(super) fn check(cx: &mut Cx) {
    let program = cx.globals.program;
    // With an error somewhere nobody knows who calls whom.
    let calls = (!cx.diags.has_errors()).then(|| Calls::new(&cx.globals, &cx.tables));
    let alone = Flow::new(&cx.globals, &cx.tables, None, Attrs::Accepted);
    let joined = Flow::new(&cx.globals, &cx.tables, calls.as_ref(), Attrs::Accepted);
    let mut readings = Readings::default();
    for (rule, item) in cx.globals.rules.iter().enumerate() {
        let mut diags = Diags::new();
        // A rule may be made for more than what its calls give it today; conditions in it are judged by what it says itself.
        alone.visit(&cx.globals, rule, &mut |site, facts| match site {
            Site::Split(_) => {}
            Site::Condition(condition) => branches::check(condition, facts, &alone, &cx.tables, &mut diags),
            Site::Value(value) => arithmetic::check(value, facts, &alone, &cx.tables, &mut diags),
            Site::Operation(row, args) => arithmetic::operation(row, args, facts, &alone, &mut diags),
        });
        // Nobody knows who else imports a file.
        let own = if program.roots.contains(&item.instance) { &joined } else { &alone };
        own.visit(&cx.globals, rule, &mut |site, facts| {
            if let Site::Split(slots) = site {
                size::check(slots, facts, &mut diags);
                repeat::check(slots, &mut diags);
            }
        });
        readings.add(program, item.decl.name.id(), diags.finish());
    }
    for item in cx.globals.values() {
        let mut diags = Diags::new();
        let facts = Facts::any(item.decl.params.len() + item.decl.locals.len());
        let locals = item.decl.locals.iter().map(|(_, value)| value).filter(|_| item.is_own());
        for value in locals.chain(item.value().map(|(value, _)| value)) {
            arithmetic::check(value, &facts, &alone, &cx.tables, &mut diags);
        }
        readings.add(program, item.decl.name.id(), diags.finish());
    }
    let certain = readings.agreed(program);
    let usual = calls.map_or_else(Vec::new, |calls| defaults::check(cx, &calls, &certain));
    cx.diags.append(certain);
    cx.diags.append(usual);
}
