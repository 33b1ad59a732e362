//! Queries for labels that no rule leaves.

use cga_split::suggest::nearest;

use super::instances::CommonDiags;
use crate::analysis::body;
use crate::diag::code::Code;
use crate::diag::{Diag, Diags};
use crate::ops::{Function, Uses};
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::syntax::ast::{Expr, ExprKind, Op, OpKind};
use crate::syntax::walk::{self, OpPart};
use crate::types::Type;

/// Reports queries of the same initial shape for a label that no rule leaves. Other initial shapes may have other grammars.
pub(crate) fn check(cx: &Context) -> Vec<Diag> {
    let Some(left) = left(cx) else { return Vec::new() };
    let mut common = CommonDiags::default();
    for item in &cx.globals.rules {
        let names = cx.tables.at(item.own);
        common.check(item, |diags| {
            for op in walk::ops(body(item)) {
                exprs(op).into_iter().for_each(|expr| queries(expr, names, &left, diags));
            }
            item.decl.locals.iter().for_each(|(_, local)| queries(local, names, &left, diags));
        });
    }
    for item in cx.globals.values() {
        let own = item.value().map_or(item.own, |(_, own)| own);
        let locals = item.decl.locals.iter().map(|(_, value)| value).filter(|_| item.is_own());
        common.check(item, |diags| {
            let values = locals.chain(item.value().map(|(value, _)| value));
            values.for_each(|value| queries(value, cx.tables.at(own), &left, diags));
        });
    }
    common.finish()
}

/// The labels that rules leave. `None` if there may be others: a label is computed, or files that import this one may leave them.
fn left<'a>(cx: &Context<'a, '_>) -> Option<Vec<&'a str>> {
    let mut left = Vec::new();
    for item in &cx.globals.rules {
        let names = cx.tables.at(item.own);
        for op in walk::ops(body(item)) {
            let OpKind::Call(name, args) = &op.kind else { continue };
            match (names.of(name), args.first()) {
                (Some(Use::Operation(row)), Some(arg)) if row.uses.has(Uses::LABELS) => match &arg.value.kind {
                    ExprKind::Text(text) => left.push(text.as_str()),
                    _ => return None,
                },
                _ => {}
            }
        }
    }
    (!cx.globals.program.may_be_imported()).then_some(left)
}

/// The expressions of an operation, without the operations inside it.
fn exprs(op: &Op) -> Vec<&Expr> {
    let mut list: Vec<&Expr> = match &op.kind {
        OpKind::Call(_, args) | OpKind::Path(_, args) | OpKind::Dynamic { args, .. } => {
            args.iter().map(|arg| &arg.value).collect()
        }
        OpKind::Block(block) => block.args.iter().map(|arg| &arg.value).collect(),
        _ => Vec::new(),
    };
    list.extend(op.parts().into_iter().filter_map(|part| match part {
        OpPart::Size(arg) | OpPart::Length(arg) => Some(&arg.value),
        OpPart::Depth(expr) | OpPart::Condition(expr) => Some(expr),
        OpPart::Arm(arm) => Some(&arm.selector),
        OpPart::Ops(_) => None,
    }));
    list
}

/// Checks the queries in an expression.
fn queries(expr: &Expr, names: Entries, left: &[&str], diags: &mut Diags) {
    if let ExprKind::Call(name, args) = &expr.kind
        && let Some(Use::Builtin(row)) = names.of(name)
        && let Some((label, arg)) = intra_label(row, args)
        && !left.contains(&label)
    {
        let diag = diags.report(Code::UnknownLabel, arg.span, format!("no rule leaves the label `{label}`"));
        diag.note("`intra` asks about shapes of the same initial shape, so the query finds none");
        if let Some(near) = nearest(label, left.iter().copied()) {
            diag.help(format!("did you mean \"{near}\"?"));
        }
    }
    expr.parts().into_iter().for_each(|part| queries(part, names, left, diags));
}

/// The label of a query of the same initial shape, and its argument. An empty label is reported elsewhere, or means all shapes.
fn intra_label<'e>(row: &Function, args: &'e [Expr]) -> Option<(&'e str, &'e Expr)> {
    if !row.uses.has(Uses::OCCLUSION) && !row.uses.has(Uses::CONTEXT) {
        return None;
    }
    let is_intra = |arg: &Expr| matches!(&arg.kind, ExprKind::Name(name) if name.text == "intra");
    let (_, arg) = row.params.iter().zip(args).find(|(param, _)| param.kind.ty() == Some(Type::Text))?;
    match &arg.kind {
        ExprKind::Text(label) if !label.is_empty() && args.first().is_some_and(is_intra) => Some((label, arg)),
        _ => None,
    }
}
