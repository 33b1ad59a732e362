//! The values that an attribute may have: `@Range`, `@Enum`, and the lists that `@Range` had before 2017.1.

use super::arguments::{number, refuse, whole, wrong};
use crate::diag::code::Code;
use crate::ir::{AttrInfo, ChoiceValues, Choices, GlobalId, Presentation, Range, Type};
use crate::resolve::context::Context;
use crate::resolve::globals::Namespace;
use crate::resolve::tables::Use;
use crate::span::Span;
use crate::suggest::nearest;
use crate::syntax::ast::{AnnotationArg, Decl, Expr, ExprKind};

/// The annotated values and their places.
#[derive(Default)]
pub(super) struct AllowedValues {
    range: Option<(Range, Span)>,
    choices: Option<(Choices, Span)>,
    /// `valuesAttr`: the attribute that has the values.
    source: Option<(GlobalId, Span)>,
}

/// The maximum number of values listed in a message.
const MOST_SHOWN: usize = 6;

const BOUNDS: [&str; 4] = ["min", "max", "stepsize", "restricted"];

impl AllowedValues {
    /// Reads `@Range(min=…, max=…)`, positional arguments in old files, or a list of values, optionally with labels.
    pub(super) fn range(&mut self, cx: &mut Context, span: Span, args: &[AnnotationArg]) {
        let is_text = |arg: &AnnotationArg| arg.name.is_none() && matches!(arg.value.kind, ExprKind::Text(_));
        let names: Option<Vec<&str>> = args.iter().map(|arg| Some(arg.name.as_ref()?.text.as_str())).collect();
        let labels = names.is_some_and(|names| !names.is_empty() && !are_bounds(&names));
        // Three numbers without names are values (*annotations*, 2017.0). The step was added with the names in
        // 2017.1.
        let numbers = 2 < args.len() && args.iter().all(|arg| arg.name.is_none() && number(&arg.value).is_some());
        if labels || numbers || args.iter().any(is_text) {
            let (lists, restricted) = (args.iter().collect::<Vec<_>>(), true);
            if let Some(values) = values(cx, "Range", &lists) {
                if args.iter().all(|arg| arg.name.is_none()) {
                    old_list(cx, span, &values);
                }
                let label = |arg: &AnnotationArg| arg.name.as_ref().map(|name| name.text.clone());
                let labels = args.iter().filter_map(label).collect();
                self.choices = Some((Choices { values, labels, restricted }, span));
            }
        } else if let Some(range) = bounds(cx, span, args) {
            self.range = Some((range, span));
        }
    }

    /// Reads `@Enum(value, …, restricted=…)` or `@Enum(valuesAttr=name, restricted=…)`.
    pub(super) fn choices(&mut self, cx: &mut Context, span: Span, args: &[AnnotationArg]) {
        let (mut list, mut source, mut restricted) = (Vec::new(), None, true);
        for arg in args {
            match arg.name.as_ref().map(|name| name.text.as_str()) {
                None => list.push(arg),
                Some("restricted") => restricted = truth(cx, &arg.value).unwrap_or(restricted),
                Some("valuesAttr") => source = Some(&arg.value),
                Some(name) => {
                    let near = nearest(name, ["restricted", "valuesAttr"]);
                    let message = "`@Enum` takes values, `valuesAttr` and `restricted`";
                    wrong(cx, whole(arg), message).suggest(near);
                    return;
                }
            }
        }
        let values = match (source, &list[..]) {
            (None, []) => {
                wrong(cx, span, "`@Enum` needs values").help("write `@Enum(1, 2)` or `@Enum(\"a\", \"b\")`");
                return;
            }
            (None, list) => values(cx, "Enum", list),
            (Some(source), []) => attribute(cx, source).map(|id| {
                self.source = Some((id, source.span));
                ChoiceValues::Attr(id)
            }),
            (Some(source), _) => {
                wrong(cx, source.span, "`@Enum` takes either values or `valuesAttr`");
                return;
            }
        };
        self.choices = values.map(|values| (Choices { values, labels: Vec::new(), restricted }, span));
    }

    /// Stores the limits that fit the type of an attribute. An unknown type causes no further diagnostics.
    pub(super) fn settle(self, cx: &mut Context, decl: &Decl, ty: Option<Type>, info: &mut AttrInfo) {
        let element = ty.map(Type::element);
        let unsuited = |cx: &mut Context, span: Span, what: &str| {
            let (name, ty) = (&decl.name.text, ty.map_or("", Type::word));
            wrong(cx, span, format!("{what}, but `{name}` is a {ty}"));
        };
        if let Some((range, span)) = self.range {
            match element {
                None | Some(Type::Float) => info.range = Some(range),
                Some(_) => unsuited(cx, span, "`@Range` is for a float"),
            }
        }
        if let Some((choices, span)) = self.choices {
            let needs = match choices.values {
                ChoiceValues::Floats(_) => Some(Type::Float),
                ChoiceValues::Texts(_) => Some(Type::Text),
                ChoiceValues::Attr(id) => {
                    let source = cx.globals.attrs.get(id.0 as usize);
                    source.and_then(|item| item.ty(&cx.tables)).map(Type::element)
                }
            };
            let is_truth = |text: &String| text == "true" || text == "false";
            match (element, needs) {
                // Rule files list the values of a bool, although these are implied.
                (Some(Type::Bool), _) if matches!(&choices.values, ChoiceValues::Texts(texts) if texts.iter().all(is_truth)) =>
                    {}
                (Some(Type::Bool), _) => unsuited(cx, span, "values to choose from are for a float or a string"),
                (Some(own), Some(needs)) if own != needs => {
                    let span = self.source.map_or(span, |(_, span)| span);
                    unsuited(cx, span, &format!("these values are for a {}", needs.word()));
                }
                _ => info.choices = Some(choices),
            }
        }
        stray_default(cx, decl, info);
        // Unrestricted sliders (*annotations*), unless a range is given.
        let max = match info.presentation {
            Presentation::Angle => 360.0,
            Presentation::Percent => 1.0,
            _ => return,
        };
        if info.choices.is_none() {
            info.range = info.range.or(Some(Range { min: 0.0, max, step: 0.0, restricted: false }));
        }
    }
}

/// Reports values in a `@Range` (*CGA changelog 2017.1*).
fn old_list(cx: &mut Context, span: Span, values: &ChoiceValues) {
    let Some(list) = written(values) else { return };
    let diag = cx.diags.report(Code::OldSpelling, span, "`@Range` with values is an old spelling");
    diag.help(format!("write `@Enum({})`", beginning(&list)));
}

/// A list as it is written, without its end if it is long.
fn beginning(list: &[String]) -> String {
    if list.len() <= MOST_SHOWN { list.join(", ") } else { format!("{}, …", list[..MOST_SHOWN].join(", ")) }
}

/// The values of a list as rules write them.
fn written(values: &ChoiceValues) -> Option<Vec<String>> {
    match values {
        ChoiceValues::Floats(list) => Some(list.iter().map(f64::to_string).collect()),
        ChoiceValues::Texts(list) => Some(list.iter().map(|text| format!("{text:?}")).collect()),
        ChoiceValues::Attr(_) => None,
    }
}

/// Reports a default outside the restricted values.
fn stray_default(cx: &mut Context, decl: &Decl, info: &AttrInfo) {
    let Some(value) = decl.value() else { return };
    let known = number(value);
    let stray = info.held_to_range().zip(known).filter(|(range, known)| *known < range.min || range.max < *known);
    let name = &decl.name.text;
    let (message, near) = match (stray, info.held_to_choices(), &value.kind) {
        (Some((range, _)), ..) => {
            (format!("the default of `{name}` is not between {} and {}", range.min, range.max), None)
        }
        (_, Some(ChoiceValues::Texts(list)), ExprKind::Text(text)) if !list.contains(text) => {
            let near = nearest(text, list.iter().map(String::as_str)).map(|near| format!("did you mean \"{near}\"?"));
            (format!("the default of `{name}` is not one of its allowed values"), near)
        }
        (_, Some(ChoiceValues::Floats(list)), _) if known.is_some_and(|known| !list.contains(&known)) => {
            (format!("the default of `{name}` is not one of its allowed values"), None)
        }
        _ => return,
    };
    let allowed = info.held_to_choices().and_then(written);
    let diag = cx.diags.report(Code::StrayDefault, value.span, message);
    if let Some(list) = allowed.filter(|_| stray.is_none()) {
        diag.note(format!("the allowed values are {}", beginning(&list)));
    }
    diag.note("a host program that sets another value cannot set the default again");
    if let Some(near) = near {
        diag.help(near);
    }
}

/// Returns true if the names were meant as bounds of a range and not as labels of its values.
fn are_bounds(names: &[&str]) -> bool {
    let like =
        |name: &&str| ["min", "max", "step", "restrict"].iter().any(|bound| name.to_lowercase().starts_with(bound));
    names.iter().any(|name| BOUNDS.contains(name)) || names.iter().all(like)
}

fn truth(cx: &mut Context, value: &Expr) -> Option<bool> {
    match value.kind {
        ExprKind::Bool(value) => Some(value),
        _ => refuse(cx, value.span, "`restricted` is `true` or `false`"),
    }
}

/// Reads values that are all numbers or all strings.
fn values(cx: &mut Context, annotation: &str, args: &[&AnnotationArg]) -> Option<ChoiceValues> {
    let (mut floats, mut texts) = (Vec::new(), Vec::new());
    for arg in args {
        match (number(&arg.value), &arg.value.kind) {
            (Some(value), _) if texts.is_empty() => floats.push(value),
            (None, ExprKind::Text(text)) if floats.is_empty() => texts.push(text.clone()),
            _ => {
                let message = format!("the values of `@{annotation}` are all numbers or all strings");
                return refuse(cx, arg.value.span, message);
            }
        }
    }
    Some(if texts.is_empty() { ChoiceValues::Floats(floats) } else { ChoiceValues::Texts(texts) })
}

/// The attribute that `valuesAttr` names.
fn attribute(cx: &mut Context, value: &Expr) -> Option<GlobalId> {
    let ExprKind::Name(name) = &value.kind else {
        return refuse(cx, value.span, "`valuesAttr` takes the name of an attribute");
    };
    match cx.globals.value(cx.at, &name.text) {
        Some(Use::Attr(index)) => Some(GlobalId(index)),
        Some(_) => refuse(cx, value.span, format!("`{}` is not an attribute", name.text)),
        None if cx.globals.is_lost(cx.at, &name.text) => None,
        None => {
            let near = nearest(&name.text, cx.globals.near(cx.at, Namespace::Attrs));
            wrong(cx, value.span, format!("unknown attribute `{}`", name.text)).suggest(near);
            None
        }
    }
}

fn bounds(cx: &mut Context, span: Span, args: &[AnnotationArg]) -> Option<Range> {
    let (mut min, mut max, mut step, mut restricted) = (None, None, 0.0, true);
    for (index, arg) in args.iter().enumerate() {
        let name = match &arg.name {
            Some(name) => name.text.as_str(),
            None => BOUNDS.get(index).copied().unwrap_or_default(),
        };
        if name == "restricted" {
            restricted = truth(cx, &arg.value).unwrap_or(restricted);
            continue;
        }
        if !matches!(name, "min" | "max" | "stepsize") {
            let place = arg.name.as_ref().map_or(arg.value.span, |name| name.span);
            let near = nearest(name, BOUNDS);
            wrong(cx, place, "`@Range` takes `min`, `max`, `stepsize` and `restricted`").suggest(near);
            return None;
        }
        let Some(value) = number(&arg.value) else {
            return refuse(cx, arg.value.span, format!("`{name}` must be written as a number"));
        };
        match name {
            "min" => min = Some(value),
            "max" => max = Some(value),
            _ if value < 0.0 => _ = wrong(cx, arg.value.span, "`stepsize` cannot be negative"),
            _ => step = value,
        }
    }
    match (min, max) {
        (Some(min), Some(max)) if min <= max => Some(Range { min, max, step, restricted }),
        (Some(min), Some(max)) => {
            let last = args.last().map_or(span, |arg| arg.value.span);
            let place = args.first().map_or(span, |arg| arg.name.as_ref().map_or(arg.value.span, |name| name.span));
            wrong(cx, place.to(last), format!("this range is empty: {max} is less than {min}"))
                .help(format!("write `@Range(min = {max}, max = {min})`"));
            None
        }
        _ => refuse(cx, span, "`@Range` needs `min` and `max`"),
    }
}
