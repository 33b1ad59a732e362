//! A checked grammar → Rust. No decisions and no errors here: `cga_lang::lower` has made them all.
//!
//! The output is the public struct and one anonymous const with everything else in it: the evaluated attributes, the
//! calls that may wait, and one function a rule, generic over the sink. Local names are hygienic; rule functions carry
//! the span of their definition so that editors find them.

mod comp;
mod expr;
mod items;
mod names;
mod rule;
mod split;

use cga_lang::ir::{Grammar, RuleId, Type};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote_spanned;

use crate::door::Source;
use crate::header::Header;

pub(crate) use items::{Public, PublicAttr, public};

/// What every part of the generator looks things up in.
struct Cx<'a> {
    grammar: &'a Grammar,
    source: &'a Source,
    names: names::Names,
    /// Whether `#` values were captured, as in the expression form.
    captured: bool,
}

/// Writes a grammar.
pub(crate) fn grammar(grammar: &Grammar, header: &Header, source: &Source) -> TokenStream {
    let cx = Cx { grammar, source, names: names::Names::new(grammar), captured: header.name.is_none() };
    let (values, call) = (items::values(&cx), items::calls(&cx));
    let (rules, functions) = (rule::rules(&cx), rule::functions(&cx));
    let implementation = items::rules_impl(&cx, header);
    let place = Span::mixed_site();
    let hidden = quote_spanned! { place=>
        #values
        #call
        /// The rules and functions, one function each.
        struct CgaRules;
        #[allow(
            non_snake_case, dead_code, unused_variables, unused_mut, unused_assignments, unused_parens, unused_braces,
            unused_labels, unreachable_code, unreachable_pub, clippy::all, clippy::pedantic
        )]
        impl CgaRules {
            #rules
            #functions
        }
        #implementation
    };
    let public = Public {
        attrs: grammar.attrs.iter().map(|attr| PublicAttr::of(attr, source)).collect(),
        captures: grammar.hosts.iter().map(|host| (host.handle, host.ty)).collect(),
        hidden: Some(hidden),
    };
    items::public(&public, header)
}

/// The Rust type of a value inside the rules.
fn inner_type(ty: Type) -> TokenStream {
    let place = Span::mixed_site();
    match ty {
        Type::Float => quote_spanned!(place=> ::core::primitive::f64),
        Type::Bool => quote_spanned!(place=> ::core::primitive::bool),
        Type::Text => quote_spanned!(place=> cga_rt::Text),
    }
}

impl Cx<'_> {
    /// A function of the hidden impl, with the span of a use.
    fn rule(&self, rule: RuleId, place: Span) -> Ident {
        Ident::new(self.names.rule(rule), place)
    }
}

/// A local of the generated code, by number.
fn local(prefix: &str, number: usize) -> Ident {
    Ident::new(&format!("{prefix}{number}"), Span::mixed_site())
}
