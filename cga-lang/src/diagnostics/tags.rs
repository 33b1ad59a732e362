//! Queries for tags that no operation gives.

use cga_split::suggest::nearest;
use cga_split::tags::{self, WILDCARDS};

use crate::analysis::body;
use crate::diag::Diags;
use crate::diag::code::Code;
use crate::ops::{self, Allowed, Param};
use crate::resolve::context::Context;
use crate::resolve::tables::{GivenTags, Use};
use crate::syntax::ast::{Expr, ExprKind, OpKind};
use crate::syntax::walk;

/// The tags that the rules of a program give.
pub(crate) fn given(cx: &Context) -> GivenTags {
    let mut given = GivenTags { names: Vec::new(), has_others: cx.globals.program.may_be_imported() };
    for item in &cx.globals.rules {
        let names = cx.tables.at(item.own);
        for op in walk::ops(body(item)) {
            let OpKind::Call(name, args) = &op.kind else { continue };
            let Some(Use::Operation(row)) = names.of(name) else { continue };
            for (_, arg) in row.params.iter().zip(args).filter(|(param, _)| has(param, Allowed::TagName)) {
                match &arg.value.kind {
                    ExprKind::Text(text) => given.names.push(tags::name(text)),
                    _ => given.has_others = true,
                }
            }
        }
    }
    given
}

/// Reports queries that are nearly the tag of an operation, and match no tag of operations or rules.
pub(crate) fn check(params: &[Param], args: &[&Expr], given: &GivenTags, diags: &mut Diags) {
    for (param, arg) in params.iter().zip(args) {
        let ExprKind::Text(query) = &arg.kind else { continue };
        if !has(param, Allowed::TagQuery) || given.has_others || query.contains(WILDCARDS) {
            continue;
        }
        let is_given = given.names.iter().any(|tag| tags::matches(query, tag));
        if is_given || ops::tags().any(|tag| tags::matches(query, tag)) {
            continue;
        }
        // The tags of operations, and what is above them.
        let mut meant: Vec<&str> = ops::tags().flat_map(above).collect();
        meant.sort_unstable();
        meant.dedup();
        if let Some(near) = nearest(query, meant) {
            let diag = diags.report(Code::UnknownTag, arg.span, format!("no operation gives the tag `{query}`"));
            diag.note("only an initial shape could have it");
            diag.help(format!("did you mean \"{near}\"?"));
        }
    }
}

fn has(param: &Param, values: Allowed) -> bool {
    param.bounds.is_some_and(|bounds| bounds.values == values)
}

/// A tag and the tags above it.
fn above(tag: &'static str) -> impl Iterator<Item = &'static str> {
    tag.match_indices('.').map(|(end, _)| &tag[..end]).chain([tag])
}
