//! The table of attributes, and the checks of their ranges.

use cga_lang::ir::{Range, Type, Value};
use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

use super::fields::Field;
use super::types::{self, value};

/// The checks of what annotations restrict.
pub(super) fn checks(field: &Field<'_>) -> Vec<TokenStream> {
    range_check(field).into_iter().collect()
}

/// The check of a restricted range.
fn range_check(field: &Field<'_>) -> Option<TokenStream> {
    let place = Span::mixed_site();
    let (attr, own) = (field.attr, &field.name);
    let allowed = attr.range.filter(|range| range.restricted && attr.ty == Type::Float)?;
    let (range, name) = (range_tokens(allowed), &attr.name);
    Some(match field.known {
        // Old files have defaults outside of their ranges: as long as nobody changes it, such a one is no mistake.
        Some(Value::Float(known)) if !(allowed.min <= *known && *known <= allowed.max) => {
            let known = value(&Value::Float(*known));
            quote_spanned!(place=> if self.#own != #known { #range.check(#name, self.#own)?; })
        }
        Some(_) => quote_spanned!(place=> #range.check(#name, self.#own)?;),
        None => quote_spanned! { place=>
            if let ::core::option::Option::Some(value) = self.#own {
                #range.check(#name, value)?;
            }
        },
    })
}

fn range_tokens(range: Range) -> TokenStream {
    let number = |number| value(&Value::Float(number));
    let (min, max, step, restricted) = (number(range.min), number(range.max), number(range.step), range.restricted);
    quote_spanned!(Span::mixed_site()=> cga_rt::Range::new(#min, #max, #step, #restricted))
}

/// A row of the attribute table.
pub(super) fn attribute(field: &Field<'_>) -> TokenStream {
    let place = Span::mixed_site();
    let attr = field.attr;
    let (name, kind) = (&attr.name, types::variant(attr.ty));
    let default = match field.known {
        None => quote_spanned!(place=> ::core::option::Option::None),
        Some(known) => {
            let known = types::fixed(known);
            quote_spanned!(place=> ::core::option::Option::Some(#known))
        }
    };
    let mut row = quote_spanned!(place=> cga_rt::Attribute::new(#name, cga_rt::Default::#kind(#default)));
    if let Some(range) = attr.range {
        let range = range_tokens(range);
        row.extend(quote_spanned!(place=> .range(#range)));
    }
    if !attr.group.is_empty() {
        let group = &attr.group;
        row.extend(quote_spanned!(place=> .group(&[#(#group),*])));
    }
    if !attr.doc.is_empty() {
        let about = &attr.doc;
        row.extend(quote_spanned!(place=> .about(#about)));
    }
    if let Some(order) = attr.order {
        let order = value(&Value::Float(order));
        row.extend(quote_spanned!(place=> .order(#order)));
    }
    if attr.hidden {
        row.extend(quote_spanned!(place=> .hidden()));
    }
    row
}
