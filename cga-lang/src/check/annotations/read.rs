//! The arguments of one annotation.

use super::{Group, Hidden, Notes, wrong};
use crate::ast::{AnnotationArg, Expr, ExprKind, Unary};
use crate::check::Cx;
use crate::code::Code;
use crate::ir::Presentation;
use crate::span::Span;

impl Notes {
    /// Takes in what an annotation says. `group` is the one that counts from here on.
    pub(super) fn read(
        &mut self,
        cx: &mut Cx,
        name: &'static str,
        span: Span,
        args: &[AnnotationArg],
        group: &mut Group,
    ) {
        match name {
            "Range" => self.limits.range(cx, span, args),
            "Enum" => self.limits.choices(cx, span, args),
            "Group" => *group = group_of(cx, args),
            "Order" => match args {
                [AnnotationArg { name: None, value }] if number(value).is_some() => self.info.order = number(value),
                _ => _ = wrong(cx, span, "`@Order` needs a number".into()).help("write `@Order(1)`"),
            },
            "Hidden" => {
                self.hidden = hidden(cx, args);
                self.names = matches!(&self.hidden, Hidden::Names(names) if !names.is_empty()).then_some(span);
            }
            "Description" => self.descriptions.extend(text(cx, name, span, args)),
            "DisplayName" => self.info.display_name = text(cx, name, span, args),
            "RuleFileDescription" => {
                if let Some(text) = text(cx, name, span, args) {
                    cx.tables.about = text;
                }
            }
            "Angle" => self.present(cx, name, span, args, Presentation::Angle),
            "Percent" => self.present(cx, name, span, args, Presentation::Percent),
            "Distance" => self.present(cx, name, span, args, Presentation::Distance),
            "Color" => self.present(cx, name, span, args, Presentation::Color),
            "Directory" => self.present(cx, name, span, args, Presentation::Directory),
            "MaterialFile" => self.present(cx, name, span, args, Presentation::MaterialFile),
            "File" => {
                let list = texts(cx, "a file extension is a string, as in `@File(\"jpg\")`", args);
                self.present(cx, name, span, &[], Presentation::File(list));
            }
            "StartRule" => {
                nothing(cx, name, args);
                self.start = Some(span);
            }
            "InPolygon" | "InMesh" | "InLine" | "InPoint" | "InPointCloud" => nothing(cx, name, args),
            // The place of a rule in the visual editor (*annotations*, 2015).
            "Location" => {
                let diag = cx.diags.report(Code::OldSpelling, span, "`@Location` is an old annotation without effect");
                diag.help("leave it out");
            }
            // `@Out` and `@Handle` are for programs that we are not; `levels` reads the rest.
            _ => {}
        }
    }

    fn present(&mut self, cx: &mut Cx, name: &str, span: Span, args: &[AnnotationArg], how: Presentation) {
        nothing(cx, name, args);
        match self.presented {
            Some(first) if self.info.presentation != how => {
                let message = format!("`@{name}` has no effect: something else says how this is shown");
                wrong(cx, span, message).related("said", first);
            }
            _ => (self.info.presentation, self.presented) = (how, Some(span)),
        }
    }
}

fn nothing(cx: &mut Cx, name: &str, args: &[AnnotationArg]) {
    if let Some(first) = args.first() {
        wrong(cx, whole(first), format!("`@{name}` takes no arguments"));
    }
}

/// An argument with its name.
pub(super) fn whole(arg: &AnnotationArg) -> Span {
    arg.name.as_ref().map_or(arg.value.span, |name| name.span.to(arg.value.span))
}

/// The one string that an annotation takes.
fn text(cx: &mut Cx, name: &str, span: Span, args: &[AnnotationArg]) -> Option<String> {
    match args {
        [AnnotationArg { name: None, value: Expr { kind: ExprKind::Text(text), .. } }] => Some(text.clone()),
        _ => {
            wrong(cx, span, format!("`@{name}` needs a string")).help(format!("write `@{name}(\"…\")`"));
            None
        }
    }
}

/// Arguments that must be strings; the others are reported and left out.
fn texts(cx: &mut Cx, needs: &str, args: &[AnnotationArg]) -> Vec<String> {
    let mut list = Vec::with_capacity(args.len());
    for arg in args {
        match (&arg.name, &arg.value.kind) {
            (None, ExprKind::Text(text)) => list.push(text.clone()),
            _ => _ = wrong(cx, whole(arg), needs.to_owned()),
        }
    }
    list
}

/// `@Group("A", "B", order)`; without arguments it ends the group.
fn group_of(cx: &mut Cx, args: &[AnnotationArg]) -> Group {
    let (order, names) = match args.split_last() {
        Some((AnnotationArg { name: None, value }, rest)) if number(value).is_some() => (number(value), rest),
        _ => (None, args),
    };
    let needs = "`@Group` has strings, and perhaps a number at the end";
    if let (Some(_), [], [arg]) = (order, names, args) {
        wrong(cx, whole(arg), needs.to_owned());
        return Group::default();
    }
    Group { names: texts(cx, needs, names), order }
}

fn hidden(cx: &mut Cx, args: &[AnnotationArg]) -> Hidden {
    let mut names = Vec::with_capacity(args.len());
    for arg in args {
        match (&arg.name, &arg.value.kind) {
            (None, ExprKind::Name(name)) => names.push(name.text.clone()),
            (None, ExprKind::Text(text)) => names.push(text.clone()),
            _ => _ = wrong(cx, whole(arg), "`@Hidden` has names of attributes of the import behind it".into()),
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
