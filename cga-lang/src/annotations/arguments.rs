//! The arguments of one annotation.

use crate::diag::code::Code;
use crate::diag::{Diag, Level, Line};
use crate::dialect::Dialect;
use crate::ir::AttrGroup;
use crate::resolve::context::Context;
use crate::resolve::info::Hidden;
use crate::span::Span;
use crate::syntax::ast::{AnnotationArg, Expr, ExprKind, Unary};

pub(super) fn nothing(cx: &mut Context, name: &str, args: &[AnnotationArg]) {
    if let Some(first) = args.first() {
        wrong(cx, whole(first), format!("`@{name}` takes no arguments"));
    }
}

/// The span of an argument with its name.
pub(super) fn whole(arg: &AnnotationArg) -> Span {
    arg.name.as_ref().map_or(arg.value.span, |name| name.span.to(arg.value.span))
}

/// The only string argument of an annotation.
pub(super) fn text(cx: &mut Context, name: &str, span: Span, args: &[AnnotationArg]) -> Option<String> {
    match args {
        [AnnotationArg { name: None, value: Expr { kind: ExprKind::Text(text), .. } }] => Some(text.clone()),
        _ => {
            wrong(cx, span, format!("`@{name}` needs a string")).help(format!("write `@{name}(\"…\")`"));
            None
        }
    }
}

/// Arguments that must be strings. Other arguments are reported and left out.
pub(super) fn texts(cx: &mut Context, needs: &str, args: &[AnnotationArg]) -> Vec<String> {
    let mut list = Vec::with_capacity(args.len());
    for arg in args {
        match (&arg.name, &arg.value.kind) {
            (None, ExprKind::Text(text)) => list.push(text.clone()),
            _ => _ = wrong(cx, whole(arg), needs),
        }
    }
    list
}

/// `@Group("A", "B", order)`. Without arguments it ends the group.
pub(super) fn group_of(cx: &mut Context, args: &[AnnotationArg]) -> AttrGroup {
    let (order, names) = match args.split_last() {
        Some((AnnotationArg { name: None, value }, rest)) if number(value).is_some() => (number(value), rest),
        _ => (None, args),
    };
    let needs = "`@Group` takes strings, and optionally a number at the end";
    if let (Some(_), [], [arg]) = (order, names, args) {
        wrong(cx, whole(arg), needs);
        return AttrGroup::default();
    }
    AttrGroup { names: texts(cx, needs, names), order }
}

pub(super) fn hidden(cx: &mut Context, args: &[AnnotationArg]) -> Hidden {
    let mut names = Vec::with_capacity(args.len());
    for arg in args {
        match (&arg.name, &arg.value.kind) {
            (None, ExprKind::Name(name)) => names.push(name.text.clone()),
            (None, ExprKind::Text(text)) => names.push(text.clone()),
            _ => _ = wrong(cx, whole(arg), "`@Hidden` takes names of attributes of the import after it"),
        }
    }
    if args.is_empty() { Hidden::All } else { Hidden::Names(names) }
}

/// A number with its signs.
pub(super) fn number(value: &Expr) -> Option<f64> {
    match &value.kind {
        ExprKind::Number(value) => Some(*value),
        ExprKind::Unary(Unary::Minus, inner) => number(inner).map(|value| -value),
        ExprKind::Unary(Unary::Plus, inner) => number(inner),
        _ => None,
    }
}

/// Reports an annotation that cannot be read.
pub(super) fn refuse<T>(cx: &mut Context, span: Span, message: impl Into<Line>) -> Option<T> {
    wrong(cx, span, message);
    None
}

pub(super) fn wrong<'d>(cx: &'d mut Context, span: Span, message: impl Into<Line>) -> &'d mut Diag {
    // In text the checks are as lenient as CGA: annotations describe, they do not generate.
    let dialect = cx.globals.program.instances[cx.at].file.dialect;
    let level = if dialect == Dialect::Inline { Level::Error } else { Level::Warning };
    cx.diags.report_as(Code::BadAnnotation, level, span, message)
}
