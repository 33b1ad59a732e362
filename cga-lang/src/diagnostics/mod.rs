//! Runs the checks that depend on known facts about shapes and values.

mod arithmetic;
mod assets;
mod blocks;
mod bounds;
mod branches;
mod colour;
mod dead_code;
mod defaults;
mod edges;
mod elements;
mod faces;
mod idle_queries;
mod indices;
mod instances;
mod labels;
pub(crate) mod levels;
mod lost_labels;
mod numbers;
mod operands;
mod reachability;
mod repeat;
mod shadowing;
mod size;
mod start;
mod switch;
pub(crate) mod tags;
mod termination;
mod texture;
mod unused;

use crate::analysis::{AbstractState, Attrs, Calls, DataFlow, Evaluator, Site};
use crate::diag::{Basis, Diag, Diags};
use crate::diagnostics::instances::CommonDiags;
use crate::diagnostics::texture::Projected;
use crate::ops::ParamKind;
use crate::resolve::context::Context;
use crate::syntax::ast::Expr;

pub(crate) fn check(cx: &mut Context) {
    cx.tables.levels = branches::levels(cx);
    cx.tables.given_tags = tags::given(cx);
    let program = cx.globals.program;
    // With an error anywhere, the calls are not known.
    let calls = (!cx.diags.has_errors()).then(|| Calls::new(&cx.globals, &cx.tables));
    let known = Evaluator::new(&cx.globals, &cx.tables, Attrs::Accepted);
    let alone = DataFlow::new(&cx.globals, &known, None);
    let values = DataFlow::of_values(&cx.globals, &known);
    let joined = DataFlow::new(&cx.globals, &known, calls.as_ref());
    let projected = Projected::new(cx, &alone);
    let mut common = CommonDiags::default();
    for (rule, item) in cx.globals.rules.iter().enumerate() {
        common.check(item, |diags| {
            // A rule may be written for more than its current calls, and rules may test sizes that they have set.
            // Conditions are therefore judged by values and other conditions only.
            values.visit(&cx.globals, rule, &mut |site, facts| {
                assets::check(site, facts, cx, diags);
                match site {
                    Site::Split(_) | Site::Sections(_) | Site::TextureSplit(..) => {}
                    Site::Components(row, block) => indices::check(row, block, facts, &values, diags),
                    Site::Condition(turn) => branches::check(turn, facts, &values, cx, diags),
                    Site::Value(value) => arithmetic::check(value, facts, &values, cx, diags),
                    Site::Operation(row, args) => {
                        for (param, image) in row.params.iter().zip(*args) {
                            texture::carried(&image.value, param.kind, projected, facts, diags);
                        }
                        texture::changed(row, args, projected, (facts, &values), diags);
                        edges::widths(row, args, facts, &values, cx, diags);
                        let args: Vec<&Expr> = args.iter().map(|arg| &arg.value).collect();
                        bounds::check(row.params, &args, facts, &values, cx, diags);
                        tags::check(row.params, &args, &cx.tables.given_tags, diags);
                        colour::check(program, row.params, &args, facts, &values, diags);
                    }
                    Site::Set(row, value) => {
                        texture::carried(value, row.kind, projected, facts, diags);
                        if row.kind == ParamKind::Color {
                            colour::text(program, value, diags);
                        }
                    }
                }
            });
            // The files that import this one are unknown.
            let is_root = program.roots.contains(&item.instance);
            let mut list = divisions(rule, if is_root { &joined } else { &alone }, projected, cx);
            if is_root && !list.is_empty() {
                let anyway = divisions(rule, &alone, projected, cx);
                let is_so = |diag: &Diag| anyway.iter().any(|other| (other.code, other.span) == (diag.code, diag.span));
                for diag in list.iter_mut().filter(|diag| joined.is_called(rule) && !is_so(diag)) {
                    diag.basis =
                        Basis::Calls { rule: item.decl.name.text.clone(), begins: item.decl.params.is_empty() };
                }
            }
            diags.append(list);
        });
    }
    for item in cx.globals.values() {
        let own = item.value().map_or(item.own, |(_, own)| own);
        let facts = AbstractState::any(own, item.decl.params.len() + item.decl.locals.len());
        let locals = item.decl.locals.iter().map(|(_, value)| value).filter(|_| item.is_own());
        common.check(item, |diags| {
            for value in locals.chain(item.value().map(|(value, _)| value)) {
                arithmetic::check(value, &facts, &values, cx, diags);
                assets::expression(value, &facts, cx, diags);
            }
        });
    }
    let certain = common.finish();
    let mut found = vec![blocks::check(cx), dead_code::check(cx), labels::check(cx)];
    found.extend([lost_labels::check(cx), idle_queries::check(cx)]);
    if let Some(calls) = &calls {
        found.push(defaults::check(cx, calls, &certain));
        found.extend([reachability::check(cx, calls), start::check(cx, calls)]);
        found.extend([termination::check(cx, calls), unused::check(cx)]);
    }
    cx.diags.append(certain);
    found.into_iter().for_each(|list| cx.diags.append(list));
}

/// The diagnostics about the splits of a rule.
fn divisions(rule: usize, flow: &DataFlow, projected: Projected, cx: &Context) -> Vec<Diag> {
    let mut diags = Diags::new();
    flow.visit(&cx.globals, rule, &mut |site, facts| match site {
        Site::Split(slots) => {
            size::check(slots, facts, &cx.tables, &mut diags);
            repeat::check(slots, &mut diags);
        }
        Site::Sections(slots) => {
            size::check(slots, facts, &cx.tables, &mut diags);
            size::depths(slots, facts, &cx.tables, &mut diags);
            repeat::check(slots, &mut diags);
        }
        Site::Components(row, block) => faces::check(row, block, facts, &cx.tables, &mut diags),
        Site::TextureSplit(split, Some(set)) => texture::check(split, *set, projected, facts, &mut diags),
        _ => {}
    });
    diags.finish()
}
