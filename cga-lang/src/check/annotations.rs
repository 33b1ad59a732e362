//! What annotations say about attributes, and which rule comes first.

use super::{Cx, Door};
use crate::ast::{Annotation, AnnotationArg, Ast, Body, Expr, ExprKind, Unary};
use crate::code::Code;
use crate::diag::Level;
use crate::ir::Range;
use crate::span::Span;
use crate::suggest::nearest;
use crate::words::ANNOTATIONS;

/// What annotations and comments say about an attribute.
#[derive(Clone, Debug, Default)]
pub(crate) struct AttrInfo {
    pub(crate) range: Option<Range>,
    pub(crate) group: Vec<String>,
    pub(crate) doc: String,
    pub(crate) order: Option<f64>,
    pub(crate) hidden: bool,
}

pub(super) fn read(cx: &mut Cx, ast: &Ast) {
    let mut group: Vec<String> = Vec::new();
    let mut start = None;
    let mut rules = 0;
    for annotation in &ast.head {
        known(cx, annotation);
    }
    for decl in &ast.decls {
        let mut info = AttrInfo::default();
        let mut descriptions: Vec<String> = Vec::new();
        for annotation in &decl.annotations {
            known(cx, annotation);
            let Some(args) = &annotation.args else { continue };
            match annotation.name.text.as_str() {
                "Range" => info.range = range(cx, annotation.name.span, args),
                "Group" => group = texts(args),
                "Order" => info.order = args.first().and_then(|arg| number(&arg.value)),
                "Hidden" => info.hidden = args.is_empty(),
                "Description" => descriptions.append(&mut texts(args)),
                "StartRule" => match &decl.body {
                    Body::Rule(_) if decl.params.is_empty() => start = start.or(Some(rules)),
                    Body::Rule(_) => {
                        let message = format!("`{}` has parameters, so a run cannot begin with it", decl.name.text);
                        wrong(cx, annotation.name.span, message);
                    }
                    _ => wrong(cx, annotation.name.span, "only a rule can be the start rule".into()),
                },
                _ => {}
            }
        }
        match &decl.body {
            Body::Attr(_) => {
                info.group.clone_from(&group);
                info.doc = if descriptions.is_empty() { decl.docs.join("\n") } else { descriptions.join("\n") };
                cx.tables.attrs.push(info);
            }
            Body::Rule(_) => rules += 1,
            _ => {}
        }
    }
    let first = cx.globals.rules.iter().position(|rule| rule.params.is_empty()).map(|index| index as u32);
    cx.tables.start = start.or(first);
    if let (None, Some(rule)) = (cx.tables.start, cx.globals.rules.first()) {
        let message = format!("`{}` has parameters, and so has every rule: no run can begin", rule.name.text);
        cx.diags.report(Code::NoStartRule, rule.name.span, message);
    }
}

fn known(cx: &mut Cx, annotation: &Annotation) {
    let name = annotation.name.text.as_str();
    if !ANNOTATIONS.contains(&name) {
        cx.diags
            .report(Code::UnknownAnnotation, annotation.name.span, format!("unknown annotation `@{name}`"))
            .suggest(nearest(name, ANNOTATIONS.iter().copied()).map(|near| format!("@{near}")));
    }
}

fn wrong(cx: &mut Cx, span: Span, message: String) {
    // In text they are as forgiving as CGA: they describe, they do not generate.
    let level = if cx.door == Door::Inline { Level::Error } else { Level::Warning };
    cx.diags.report_as(Code::BadAnnotation, level, span, message);
}

fn texts(args: &[AnnotationArg]) -> Vec<String> {
    let text = |arg: &AnnotationArg| match &arg.value.kind {
        ExprKind::Text(text) => Some(text.clone()),
        _ => None,
    };
    args.iter().filter_map(text).collect()
}

fn number(value: &Expr) -> Option<f64> {
    match &value.kind {
        ExprKind::Number(value) => Some(*value),
        ExprKind::Unary(Unary::Minus, inner) => number(inner).map(|value| -value),
        ExprKind::Unary(Unary::Plus, inner) => number(inner),
        _ => None,
    }
}

fn range(cx: &mut Cx, whole: Span, args: &[AnnotationArg]) -> Option<Range> {
    if args.iter().any(|arg| matches!(arg.value.kind, ExprKind::Text(_))) {
        // A list of strings is the old spelling of `@Enum`.
        return None;
    }
    let (mut min, mut max, mut step, mut restricted) = (None, None, 0.0, true);
    for (index, arg) in args.iter().enumerate() {
        let name = match &arg.name {
            Some(name) => name.text.as_str(),
            None => ["min", "max", "stepsize", "restricted"].get(index).copied().unwrap_or_default(),
        };
        let place = arg.name.as_ref().map_or(arg.value.span, |name| name.span);
        if name == "restricted" {
            match arg.value.kind {
                ExprKind::Bool(value) => restricted = value,
                _ => wrong(cx, arg.value.span, "`restricted` is `true` or `false`".into()),
            }
            continue;
        }
        if !matches!(name, "min" | "max" | "stepsize") {
            wrong(cx, place, "`@Range` has `min`, `max`, `stepsize` and `restricted`".into());
            return None;
        }
        let Some(value) = number(&arg.value) else {
            wrong(cx, arg.value.span, format!("`{name}` must be a number"));
            return None;
        };
        match name {
            "min" => min = Some(value),
            "max" => max = Some(value),
            _ => step = value,
        }
    }
    match (min, max) {
        (Some(min), Some(max)) if min <= max => Some(Range { min, max, step, restricted }),
        (Some(min), Some(max)) => {
            wrong(cx, whole, format!("this range is empty: {max} is less than {min}"));
            None
        }
        _ => {
            wrong(cx, whole, "`@Range` needs `min` and `max`".into());
            None
        }
    }
}
