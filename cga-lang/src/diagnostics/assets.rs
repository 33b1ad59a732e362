//! Files that rules name and the package does not have; groups and materials that an asset does not have.

use crate::analysis::{AbstractState, Site};
use crate::diag::code::Code;
use crate::diag::{Diags, quoted};
use crate::link::Asset;
use crate::ops::{AssetNames, FileUse, Function, ParamKind};
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::suggest::nearest;
use crate::syntax::ast::{Expr, ExprKind};
use crate::syntax::token::Tok;
use cga_split::files::places;

/// Checks a site of a rule.
pub(crate) fn check(site: &Site, facts: &AbstractState, cx: &Context, diags: &mut Diags) {
    let names = cx.tables.at(facts.own);
    match site {
        Site::Operation(row, args) => {
            row.params.iter().zip(*args).for_each(|(param, arg)| named(&arg.value, param.kind, names, cx, diags));
        }
        Site::Set(row, value) => named(value, row.kind, names, cx, diags),
        Site::Value(value) => expression(value, facts, cx, diags),
        _ => {}
    }
}

/// Checks an expression and its parts.
pub(crate) fn expression(expr: &Expr, facts: &AbstractState, cx: &Context, diags: &mut Diags) {
    let names = cx.tables.at(facts.own);
    if let ExprKind::Call(name, args) = &expr.kind
        && let Some(Use::Builtin(row)) = names.of(name)
    {
        row.params.iter().zip(args).for_each(|(param, arg)| named(arg, param.kind, names, cx, diags));
        if let ([list, text], Some(token)) = (args.as_slice(), facts.asset) {
            within(list, text, token, names, cx, diags);
        }
    }
    expr.parts().into_iter().for_each(|part| expression(part, facts, cx, diags));
}

/// The file name that an expression is: a string, or a constant with a string.
fn text<'c>(expr: &'c Expr, names: Entries, cx: &'c Context) -> Option<&'c str> {
    match &expr.kind {
        ExprKind::Text(text) => Some(text),
        ExprKind::Name(name) => match names.of(name)? {
            Use::Const(index) => match &cx.globals.consts[index as usize].value()?.0.kind {
                ExprKind::Text(text) => Some(text),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    }
}

/// Checks an argument or value that may be the name of a file.
fn named(value: &Expr, kind: ParamKind, names: Entries, cx: &Context, diags: &mut Diags) {
    if !matches!(kind, ParamKind::Image(_) | ParamKind::File(FileUse::Read | FileUse::Inserted)) {
        return;
    }
    let Some(name) = text(value, names, cx) else { return };
    let program = cx.globals.program;
    match program.asset(name, value.span.first) {
        Some(Asset::Missing(beside)) => {
            let message = format!("there is no file `{name}` in the package");
            let diag = diags.report(Code::MissingAsset, value.span, message);
            let places = places(name, program.folder(value.span.first)).unwrap_or_default();
            match places.as_slice() {
                [] => {}
                [place] => _ = diag.note(format!("`{place}` does not exist")),
                [places @ .., last] => _ = diag.note(format!("neither {} nor `{last}` exists", quoted(places))),
            }
            let mut names: Vec<&str> = beside.iter().map(String::as_str).collect();
            names.sort_unstable();
            match nearest(name, names) {
                Some(near) => diag.help(format!("did you mean \"{near}\"?")),
                None => {
                    diag.help("add the file; if runs take their assets from elsewhere, write `@Allow(missing_asset)`")
                }
            };
        }
        Some(Asset::Mesh { has_faces: false, .. }) if kind == ParamKind::File(FileUse::Inserted) => {
            let diag = diags.report(Code::MissingAsset, value.span, format!("`{name}` has no faces"));
            diag.note("a run inserts a box instead, with a fault");
        }
        _ => {}
    }
}

/// Checks the name of a group or material that is searched in the names of the geometry.
fn within(list: &Expr, text: &Expr, token: u32, entries: Entries, cx: &Context, diags: &mut Diags) {
    let (ExprKind::Name(query) | ExprKind::Call(query, _), ExprKind::Text(wanted)) = (&list.kind, &text.kind) else {
        return;
    };
    let file = match cx.globals.program.tokens.as_slice().get(token as usize) {
        Some(Tok::Str(file)) => file,
        _ => return,
    };
    let Some(Asset::Mesh { has_faces: true, groups, materials }) = cx.globals.program.asset(file, token) else {
        return;
    };
    let Some(Use::Builtin(Function { names: Some(names), .. })) = entries.of(query) else { return };
    let (names, what) = match names {
        AssetNames::Groups => (groups, "group"),
        AssetNames::Materials => (materials, "material"),
    };
    if names.contains(wanted) {
        return;
    }
    let diag = diags.report(Code::UnknownGroup, text.span, format!("`{file}` has no {what} \"{wanted}\""));
    match (nearest(wanted, names.iter().map(String::as_str)), names.as_slice()) {
        (Some(near), _) => diag.help(format!("did you mean \"{near}\"?")),
        (None, []) => diag.note(format!("it has no {what} at all")),
        (None, names) => {
            let all: Vec<String> = names.iter().take(6).map(|name| format!("\"{name}\"")).collect();
            diag.note(format!("it has {}{}", all.join(", "), if names.len() > 6 { ", …" } else { "" }))
        }
    };
}
