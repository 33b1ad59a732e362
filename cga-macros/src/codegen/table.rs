//! The table of attributes and the list of start rules: everything annotations say, for user interfaces.

use cga_lang::ir::{AttrInfo, ChoiceValues, Choices, Grammar, Presentation, Range, Start, Value};
use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

use super::fields::Field;
use super::types::{self, value};

/// Returns true if a run has to check the value of the field.
pub(super) fn is_restricted(field: &Field<'_>) -> bool {
    field.attr.held_to_range().is_some() || field.attr.held_to_choices().is_some()
}

/// A row of the attribute table.
pub(super) fn attribute(field: &Field<'_>, grammar: &Grammar) -> TokenStream {
    let place = Span::mixed_site();
    let attr = field.attr;
    let (name, kind) = (&field.global.name, types::variant(field.global.ty));
    let default = match field.known {
        None => quote_spanned!(place=> ::core::option::Option::None),
        Some(known) => {
            let known = types::fixed(known);
            quote_spanned!(place=> ::core::option::Option::Some(#known))
        }
    };
    let mut row = quote_spanned!(place=> cga_rt::Attribute::new(#name, cga_rt::AttributeDefault::#kind(#default)));
    if let Some(name) = &attr.display_name {
        row.extend(quote_spanned!(place=> .display_name(#name)));
    }
    if let Some(range) = attr.range {
        let range = range_tokens(range);
        row.extend(quote_spanned!(place=> .range(#range)));
    }
    if let Some(choices) = &attr.choices {
        let choices = choices_tokens(choices, grammar);
        row.extend(quote_spanned!(place=> .choices(#choices)));
    }
    row.extend(presentation(attr));
    if !attr.group.names.is_empty() {
        let group = &attr.group.names;
        row.extend(quote_spanned!(place=> .group(&[#(#group),*])));
    }
    if let Some(order) = attr.group.order {
        let order = number(order);
        row.extend(quote_spanned!(place=> .group_order(#order)));
    }
    if !attr.doc.is_empty() {
        let about = &attr.doc;
        row.extend(quote_spanned!(place=> .about(#about)));
    }
    if let Some(order) = attr.order {
        let order = number(order);
        row.extend(quote_spanned!(place=> .order(#order)));
    }
    if attr.hidden {
        row.extend(quote_spanned!(place=> .hidden()));
    }
    row
}

fn number(number: f64) -> TokenStream {
    value(&Value::Float(number))
}

fn range_tokens(range: Range) -> TokenStream {
    let (min, max, step, restricted) = (number(range.min), number(range.max), number(range.step), range.restricted);
    quote_spanned!(Span::mixed_site()=> cga_rt::Range::new(#min, #max, #step, #restricted))
}

fn choices_tokens(choices: &Choices, grammar: &Grammar) -> TokenStream {
    let place = Span::mixed_site();
    let values = match &choices.values {
        ChoiceValues::Floats(list) => {
            let list = list.iter().copied().map(number);
            quote_spanned!(place=> cga_rt::ChoiceValues::Floats(&[#(#list),*]))
        }
        ChoiceValues::Texts(list) => quote_spanned!(place=> cga_rt::ChoiceValues::Texts(&[#(#list),*])),
        ChoiceValues::Attr(id) => {
            let name = &grammar.global(*id).name;
            quote_spanned!(place=> cga_rt::ChoiceValues::Attribute(#name))
        }
    };
    let (restricted, labels) = (choices.restricted, &choices.labels);
    let labels = (!labels.is_empty()).then(|| quote_spanned!(place=> .labels(&[#(#labels),*])));
    quote_spanned!(place=> cga_rt::Choices::new(#values, #restricted) #labels)
}

/// As what an attribute is shown.
fn presentation(attr: &AttrInfo) -> Option<TokenStream> {
    let place = Span::mixed_site();
    let kind = match &attr.presentation {
        Presentation::Plain => return None,
        Presentation::Angle => quote_spanned!(place=> Angle),
        Presentation::Percent => quote_spanned!(place=> Percent),
        Presentation::Distance => quote_spanned!(place=> Distance),
        Presentation::Color => quote_spanned!(place=> Color),
        Presentation::File(endings) => quote_spanned!(place=> File(&[#(#endings),*])),
        Presentation::Directory => quote_spanned!(place=> Directory),
        Presentation::MaterialFile => quote_spanned!(place=> MaterialFile),
    };
    Some(quote_spanned!(place=> .kind(cga_rt::AttributeKind::#kind)))
}

/// An entry of the list of start rules.
pub(super) fn start(start: &Start) -> TokenStream {
    let place = Span::mixed_site();
    let (name, about) = (&start.name, &start.doc);
    let about = (!about.is_empty()).then(|| quote_spanned!(place=> .about(#about)));
    let marked = start.marked.then(|| quote_spanned!(place=> .marked()));
    let hidden = start.hidden.then(|| quote_spanned!(place=> .hidden()));
    quote_spanned!(place=> cga_rt::StartRule::new(#name) #about #marked #hidden)
}
