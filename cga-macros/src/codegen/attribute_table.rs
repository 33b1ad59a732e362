//! The table of attributes and the list of start rules: everything annotations say, for user interfaces.

use cga_lang::ir::facts::Queries;
use cga_lang::ir::{AttrInfo, ChoiceValues, Choices, Grammar, Presentation, Range, Start, Value};
use proc_macro2::{Literal, TokenStream};

use super::fields::AttrField;
use super::types::{self, value};

/// Returns true if a run has to check the value of the field.
pub(super) fn is_restricted(field: &AttrField<'_>) -> bool {
    field.attr.held_to_range().is_some() || field.attr.held_to_choices().is_some()
}

/// A row of the attribute table.
pub(super) fn attribute(field: &AttrField<'_>, grammar: &Grammar) -> TokenStream {
    let attr = field.attr;
    let (name, kind) = (&field.global.name, types::variant(field.global.ty));
    let mut row = match field.known {
        None => code!(cga_rt::Attribute::computed(#name, cga_rt::ValueType::#kind)),
        Some(known) => {
            let known = value(known);
            code!(cga_rt::Attribute::new(#name, cga_rt::Value::#kind(#known)))
        }
    };
    if let Some(name) = &attr.display_name {
        row.extend(code!(.display_name(#name)));
    }
    if let Some(range) = attr.range {
        let range = range_tokens(range);
        row.extend(code!(.range(#range)));
    }
    if let Some(choices) = &attr.choices {
        let choices = choices_tokens(choices, grammar);
        row.extend(code!(.choices(#choices)));
    }
    row.extend(presentation(attr));
    if !attr.group.names.is_empty() {
        let group = &attr.group.names;
        row.extend(code!(.group([#(#group),*])));
    }
    if let Some(order) = attr.group.order {
        let order = number(order);
        row.extend(code!(.group_order(#order)));
    }
    if !attr.doc.is_empty() {
        let about = &attr.doc;
        row.extend(code!(.about(#about)));
    }
    if let Some(order) = attr.order {
        let order = number(order);
        row.extend(code!(.order(#order)));
    }
    if attr.hidden {
        row.extend(code!(.hidden()));
    }
    row
}

fn number(number: f64) -> TokenStream {
    value(&Value::Float(number))
}

fn range_tokens(range: Range) -> TokenStream {
    let (min, max, step, restricted) = (number(range.min), number(range.max), number(range.step), range.restricted);
    code!(cga_rt::Range::new(#min, #max, #step, #restricted))
}

fn choices_tokens(choices: &Choices, grammar: &Grammar) -> TokenStream {
    let values = match &choices.values {
        ChoiceValues::Floats(list) => {
            let list = list.iter().copied().map(number);
            code!(cga_rt::ChoiceValues::Floats(cga_rt::list([#(#list),*])))
        }
        ChoiceValues::Texts(list) => code!(cga_rt::ChoiceValues::Texts(cga_rt::texts(&[#(#list),*]))),
        ChoiceValues::Attr(id) => {
            let name = &grammar.global(*id).name;
            code!(cga_rt::ChoiceValues::Attribute(cga_rt::Text::fixed(#name)))
        }
    };
    let (restricted, labels) = (choices.restricted, &choices.labels);
    let labels = (!labels.is_empty()).then(|| code!(.labels([#(#labels),*])));
    code!(cga_rt::Choices::new(#values, #restricted) #labels)
}

/// As what an attribute is shown.
fn presentation(attr: &AttrInfo) -> Option<TokenStream> {
    let kind = match &attr.presentation {
        Presentation::Plain => return None,
        Presentation::Angle => code!(Angle),
        Presentation::Percent => code!(Percent),
        Presentation::Distance => code!(Distance),
        Presentation::Color => code!(Color),
        Presentation::File(endings) => code!(File(cga_rt::texts(&[#(#endings),*]))),
        Presentation::Directory => code!(Directory),
        Presentation::MaterialFile => code!(MaterialFile),
    };
    Some(code!(.kind(cga_rt::AttributeKind::#kind)))
}

/// An entry of the list of start rules.
pub(super) fn start(start: &Start) -> TokenStream {
    let (name, about) = (&start.name, &start.doc);
    let about = (!about.is_empty()).then(|| code!(.about(#about)));
    let marked = start.marked.then(|| code!(.marked()));
    let hidden = start.hidden.then(|| code!(.hidden()));
    code!(cga_rt::StartRule::new(#name) #about #marked #hidden)
}

/// The entry of a start rule, with the queries that a run from it can reach.
pub(super) fn entry(start: &Start, queries: Queries) -> TokenStream {
    let [rule, style] = [start.rule.0, start.style].map(Literal::u32_unsuffixed);
    let queries = Literal::u8_unsuffixed(queries.bits());
    code!((#rule, #style, #queries))
}
