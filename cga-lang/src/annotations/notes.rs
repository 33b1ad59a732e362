//! The annotations before one declaration, import or style.

use super::arguments::{group_of, hidden, nothing, number, text, texts, wrong};
use super::limits::AllowedValues;
use crate::diag::code::Code;
use crate::ir::{AttrGroup, AttrInfo, Presentation, Type};
use crate::resolve::context::Context;
use crate::resolve::info::Hidden;
use crate::span::Span;
use crate::syntax::ast::{AnnotationArg, Decl};

/// The annotations of one place.
#[derive(Default)]
pub(super) struct Notes {
    pub(super) info: AttrInfo,
    limits: AllowedValues,
    /// The annotation that defines the presentation of the attribute.
    presented: Option<Span>,
    pub(super) descriptions: Vec<String>,
    pub(super) start: Option<Span>,
    pub(super) hidden: Hidden,
    /// The annotation with names of an import.
    pub(super) names: Option<Span>,
}

impl Notes {
    /// Reads an annotation. `group` is the current group, and is updated.
    pub(super) fn read(
        &mut self,
        cx: &mut Context,
        name: &'static str,
        span: Span,
        args: &[AnnotationArg],
        group: &mut AttrGroup,
    ) {
        match name {
            "Range" => self.limits.range(cx, span, args),
            "Enum" => self.limits.choices(cx, span, args),
            "Group" => *group = group_of(cx, args),
            "Order" => match args {
                [AnnotationArg { name: None, value }] if number(value).is_some() => self.info.order = number(value),
                _ => _ = wrong(cx, span, "`@Order` needs a number").help("write `@Order(1)`"),
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
            // `@Out` and `@Handle` are for other programs; `levels` reads the rest.
            _ => {}
        }
    }

    fn present(&mut self, cx: &mut Context, name: &str, span: Span, args: &[AnnotationArg], how: Presentation) {
        nothing(cx, name, args);
        match self.presented {
            Some(first) if self.info.presentation != how => {
                let message = format!("`@{name}` has no effect: another annotation defines how this is shown");
                wrong(cx, span, message).related("said", first);
            }
            _ => (self.info.presentation, self.presented) = (how, Some(span)),
        }
    }

    /// The description, otherwise the doc comments.
    pub(super) fn doc(&self, decl: &Decl) -> String {
        if self.descriptions.is_empty() { decl.docs.join("\n") } else { self.descriptions.join("\n") }
    }

    /// The information about an attribute that fits its type.
    pub(super) fn attribute(self, cx: &mut Context, decl: &Decl, group: &AttrGroup) -> AttrInfo {
        let doc = self.doc(decl);
        let Notes { mut info, limits, presented, hidden, .. } = self;
        info.group.clone_from(group);
        info.doc = doc;
        info.hidden = hidden == Hidden::All;
        let ty = cx.tables.at(cx.at).ty(&decl.name);
        if let (Some(ty), Some(span)) = (ty, presented) {
            let needs = match info.presentation {
                Presentation::Plain => ty.element(),
                Presentation::Angle | Presentation::Percent | Presentation::Distance => Type::Float,
                _ => Type::Text,
            };
            if needs != ty.element() {
                let message = format!("this is for a {}, but `{}` is a {}", needs.word(), decl.name.text, ty.word());
                wrong(cx, span, message);
                info.presentation = Presentation::Plain;
            }
        }
        limits.settle(cx, decl, ty, &mut info);
        info
    }
}
