//! The table of attributes, and the checks of their ranges.

use cga_lang::ir::{Attr, Range, Type, Value};
use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

use super::names::ident;
use super::types::{self, value};

/// The check of a restricted range.
pub(super) fn check(attr: &Attr) -> Option<TokenStream> {
    let place = Span::mixed_site();
    let allowed = attr.range.filter(|range| range.restricted && attr.ty == Type::Float)?;
    let (range, name, field) = (range_tokens(allowed), &attr.name, ident(&attr.name, place));
    Some(match &attr.known {
        // Old files have defaults outside of their ranges: as long as nobody changes it, such a one is no mistake.
        Some(Value::Float(known)) if !(allowed.min <= *known && *known <= allowed.max) => {
            let known = value(&Value::Float(*known));
            quote_spanned!(place=> if self.#field != #known { #range.check(#name, self.#field)?; })
        }
        Some(_) => quote_spanned!(place=> #range.check(#name, self.#field)?;),
        None => quote_spanned! { place=>
            if let ::core::option::Option::Some(value) = self.#field {
                #range.check(#name, value)?;
            }
        },
    })
}

fn range_tokens(range: Range) -> TokenStream {
    let number = |number| value(&Value::Float(number));
    let (min, max, step, restricted) = (number(range.min), number(range.max), number(range.step), range.restricted);
    quote_spanned!(Span::mixed_site()=> cga_rt::Range { min: #min, max: #max, step: #step, restricted: #restricted })
}

/// A row of the attribute table.
pub(super) fn attribute(attr: &Attr) -> TokenStream {
    let place = Span::mixed_site();
    let (name, group, about) = (&attr.name, &attr.group, &attr.doc);
    let kind = types::variant(attr.ty);
    let default = match &attr.known {
        None => quote_spanned!(place=> ::core::option::Option::None),
        Some(Value::Text(text)) => quote_spanned!(place=> ::core::option::Option::Some(#text)),
        Some(known) => {
            let known = value(known);
            quote_spanned!(place=> ::core::option::Option::Some(#known))
        }
    };
    let range = match attr.range {
        None => quote_spanned!(place=> ::core::option::Option::None),
        Some(range) => {
            let range = range_tokens(range);
            quote_spanned!(place=> ::core::option::Option::Some(#range))
        }
    };
    let order = match attr.order {
        None => quote_spanned!(place=> ::core::option::Option::None),
        Some(number) => {
            let number = value(&Value::Float(number));
            quote_spanned!(place=> ::core::option::Option::Some(#number))
        }
    };
    let hidden = attr.hidden;
    quote_spanned! { place=>
        cga_rt::Attribute {
            name: #name,
            default: cga_rt::Default::#kind(#default),
            range: #range,
            group: &[#(#group),*],
            about: #about,
            order: #order,
            hidden: #hidden,
        }
    }
}
