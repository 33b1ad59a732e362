//! The public struct: its fields, defaults and methods.

use cga_lang::editor::public_names::PublicName;
use cga_lang::ir::{AttrInfo, Global, Range, Type, Value};
use cga_source::rust::Header;
use proc_macro2::{Ident, Span, TokenStream};

use super::fields::AttrField;
use super::names::{Taken, ident};
use super::{local, types};
use crate::output::{HostType, capture};
use crate::source::Source;

/// The public part of a grammar. Without `hidden` it is a stub that cannot run, for rules with errors.
pub(crate) struct Public {
    pub(crate) attrs: Vec<PublicAttr>,
    /// Types of captured `#` values, in the order of the rules.
    pub(crate) captures: Vec<HostType>,
    pub(crate) hidden: Option<TokenStream>,
}

/// A public field.
pub(crate) struct PublicAttr {
    pub(crate) name: Ident,
    pub(crate) ty: Type,
    /// The default; `None` when it is computed for each initial shape.
    pub(crate) known: Option<Value>,
    pub(crate) doc: String,
}

impl PublicAttr {
    pub(super) fn of(field: &AttrField<'_>) -> Self {
        PublicAttr {
            name: field.name.clone(),
            ty: field.global.ty,
            known: field.known.cloned(),
            doc: attr_doc(field.global, field.attr, field.known),
        }
    }
}

/// The documentation of an attribute: its default and range, then its doc comment.
pub(super) fn attr_doc(global: &Global, attr: &AttrInfo, known: Option<&Value>) -> String {
    let about = if attr.doc.is_empty() { String::new() } else { format!("\n\n{}", attr.doc) };
    let default = match known {
        Some(known) => format!("default `{}`", types::show(known)),
        None => "`None` computes the default for each initial shape".into(),
    };
    let limits = |range: Range| match (range.min.is_finite(), range.max.is_finite()) {
        (true, true) => format!(", range {} to {}", range.min, range.max),
        (true, false) => format!(", from {}", range.min),
        (false, true) => format!(", up to {}", range.max),
        (false, false) => String::new(),
    };
    format!("The attribute `{}`, {default}{}.{about}", global.name, attr.range.map(limits).unwrap_or_default())
}

impl PublicAttr {
    /// Of a grammar with errors: a number, where nothing better is known.
    pub(crate) fn known_so_far(attr: &PublicName, source: &Source, taken: &mut Taken) -> Self {
        let known = attr.known.clone().unwrap_or_else(|| types::nothing(attr.ty));
        PublicAttr {
            name: ident(&taken.field(&attr.name), source.token(attr.span.first)),
            ty: attr.ty.unwrap_or(Type::Float),
            known: (!attr.computed).then_some(known),
            doc: format!("The attribute `{}`.", attr.name),
        }
    }
}

/// The public struct and all that belongs to it.
pub(crate) fn public(public: &Public, header: &Header) -> TokenStream {
    let (name, visibility, attributes) = (header.ident(), &header.visibility, &header.attributes);
    let (runtime, conditions) = (&header.runtime, &header.conditions);
    // A grammar that cannot run reads no fields.
    let unread = public.hidden.is_none().then(|| code!(#[allow(dead_code)]));
    // Attributes are named by the rules, not by Rust's taste.
    let other_taste = public.attrs.iter().any(|attr| !is_snake_case(&attr.name.to_string()));
    let other_taste = other_taste.then(|| code!(#[allow(non_snake_case)]));
    let fields = public.attrs.iter().map(|attr| {
        let (name, doc, ty) = (&attr.name, &attr.doc, types::outer(attr.ty, runtime));
        let ty = match attr.known {
            Some(_) => ty,
            None => code!(::core::option::Option<#ty>),
        };
        code!(#[doc = #doc] #unread pub #name: #ty)
    });
    let defaults: Vec<TokenStream> = public.attrs.iter().map(|attr| default_field(attr, runtime)).collect();
    let captured: Vec<Ident> = (0..public.captures.len()).map(captured).collect();
    let captured_types = public.captures.iter().map(|ty| types::inner(ty.inside(), runtime));
    let about = format!("The grammar `{}`.", header.label());
    let doc = (!header.has_doc).then(|| code!(#[doc = #about]));
    let methods_doc = code! {
        #[doc = ""]
        #[doc = "[`generate`](Self::generate) runs it on a shape, [`generate_from`](Self::generate_from) from another rule, and"]
        #[doc = "[`generate_with`](Self::generate_with) with settings. [`run`](Self::run) fills a sink,"]
        #[doc = "[`generate_all`](Self::generate_all) takes many shapes, and [`session`](Self::session) runs one after another."]
    };
    let methods = methods();
    let expression = header.name.is_none();
    let default_impl = (!expression).then(|| {
        code! {
            #[automatically_derived]
            impl ::core::default::Default for #name {
                fn default() -> Self {
                    #name { #(#defaults,)* }
                }
            }
        }
    });
    let value = expression.then(|| {
        let taken = (0..public.captures.len()).map(capture);
        code!(#name { #(#defaults,)* #(#captured: #taken,)* })
    });
    let hidden = match &public.hidden {
        Some(hidden) => hidden.clone(),
        None => unrunnable(&name, &header.label()),
    };
    code! {
        #attributes
        #doc
        #methods_doc
        #other_taste
        #[derive(::core::clone::Clone, ::core::fmt::Debug)]
        #visibility struct #name {
            #(#fields,)*
            #(#captured: #captured_types,)*
        }
        #conditions
        const _: () = {
            use #runtime as cga_rt;
            #default_impl
            impl #name {
                #methods
            }
            #hidden
        };
        #value
    }
}

/// The runtime's traits for a grammar that has errors, for code that needs them.
fn unrunnable(name: &Ident, label: &str) -> TokenStream {
    code! {
        #[automatically_derived]
        impl cga_rt::Unrunnable for #name {}

        #[automatically_derived]
        impl cga_rt::Grammar for #name {
            fn name(&self) -> &::core::primitive::str {
                #label
            }

            fn attributes(&self) -> &[cga_rt::Attribute] {
                &[]
            }

            fn attribute_get(&self, _: ::core::primitive::usize) -> ::core::option::Option<cga_rt::Value> {
                ::core::option::Option::None
            }

            fn attribute_set(&mut self, _: ::core::primitive::usize, _: cga_rt::Value) {}

            fn attribute_reset(&mut self, _: ::core::primitive::usize) {}

            fn boxed(&self) -> cga_rt::Box<dyn cga_rt::Grammar + ::core::marker::Send + ::core::marker::Sync> {
                cga_rt::Box::new(::core::clone::Clone::clone(self))
            }

            fn used_values(
                &self,
                _: &cga_rt::Shape,
                _: &cga_rt::Settings,
            ) -> ::core::result::Result<cga_rt::Vec<(cga_rt::Text, cga_rt::Value)>, cga_rt::Error> {
                ::core::unreachable!("the rules have errors")
            }

            fn start_rules(&self) -> &[cga_rt::StartRule] {
                &[]
            }

            fn run(
                &self,
                _: &cga_rt::Shape,
                _: &cga_rt::Settings,
                _: &mut dyn cga_rt::Sink,
            ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
                ::core::unreachable!("the rules have errors")
            }
        }
    }
}

/// The field of a captured value.
pub(super) fn captured(number: usize) -> Ident {
    local("captured_", number)
}

/// A name that rustc's lint accepts.
fn is_snake_case(name: &str) -> bool {
    !name.trim_matches('_').contains("__") && !name.contains(char::is_uppercase)
}

/// `name: default`.
fn default_field(attr: &PublicAttr, runtime: &TokenStream) -> TokenStream {
    // Editors would show the place of the declaration twice.
    let mut name = attr.name.clone();
    name.set_span(Span::mixed_site());
    match &attr.known {
        None => code!(#name: ::core::option::Option::None),
        Some(known) => {
            let known = types::field(known, runtime);
            code!(#name: #known)
        }
    }
}

/// The methods of the struct, the same where there are errors: `cga_rt::Unrunnable` lets their bodies compile.
fn methods() -> TokenStream {
    let errors = code! {
        ///
        /// # Errors
        /// An error if a limit is reached, an attribute is out of its range, attributes need each other, the start rule does not exist, or
        /// the initial shape is refused.
    };
    code! {
        /// Runs the start rule on a shape, with default settings.
        #errors
        pub fn generate(&self, shape: &cga_rt::Shape) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
            cga_rt::generate(self, shape, &::core::default::Default::default())
        }

        /// Runs the rule of that name on a shape, with default settings.
        #errors
        pub fn generate_from(
            &self,
            rule: &::core::primitive::str,
            shape: &cga_rt::Shape,
        ) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
            cga_rt::generate_from(self, rule, shape)
        }

        /// Runs on a shape with settings: start rule, limits, assets.
        #errors
        pub fn generate_with(
            &self,
            shape: &cga_rt::Shape,
            settings: &cga_rt::Settings,
        ) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
            cga_rt::generate(self, shape, settings)
        }

        /// Runs on a shape and hands the leaves to a sink. This is the fast path: no model in between.
        #errors
        pub fn run<Sink: cga_rt::Sink + ?::core::marker::Sized>(
            &self,
            shape: &cga_rt::Shape,
            settings: &cga_rt::Settings,
            sink: &mut Sink,
        ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
            cga_rt::run(self, shape, settings, sink)
        }

        /// The old name of `run`.
        #errors
        #[deprecated(note = "call `run`")]
        pub fn generate_into<Sink: cga_rt::Sink + ?::core::marker::Sized>(
            &self,
            shape: &cga_rt::Shape,
            settings: &cga_rt::Settings,
            sink: &mut Sink,
        ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
            cga_rt::run(self, shape, settings, sink)
        }

        /// Opens a session: several runs with the same settings, which share what is made once.
        ///
        /// # Errors
        /// An attribute out of its range, no such start rule.
        pub fn session(
            &self,
            settings: &cga_rt::Settings,
        ) -> ::core::result::Result<cga_rt::Session<'_, Self>, cga_rt::Error> {
            cga_rt::Session::new(self, settings)
        }

        /// Runs on many shapes, in parallel with the feature `rayon`, and collects a model of each.
        ///
        /// # Errors
        /// The first error in the order of the shapes.
        #[inline]
        pub fn generate_all(
            &self,
            shapes: &[cga_rt::Shape],
            settings: &cga_rt::Settings,
        ) -> ::core::result::Result<cga_rt::Batches<cga_rt::Model>, cga_rt::RunError> {
            cga_rt::generate_all(self, shapes, settings)
        }

        /// Runs on many shapes, in parallel with the feature `rayon`, with a sink for each stretch of shapes.
        ///
        /// # Errors
        /// The first error in the order of the shapes.
        pub fn run_all<Sink: cga_rt::Sink + ::core::marker::Send>(
            &self,
            shapes: &[cga_rt::Shape],
            settings: &cga_rt::Settings,
            sink: impl ::core::ops::Fn(&cga_rt::Stretch) -> Sink + ::core::marker::Sync,
        ) -> ::core::result::Result<cga_rt::Batches<Sink>, cga_rt::RunError> {
            cga_rt::run_all(self, shapes, settings, sink)
        }

        /// The old name of `run_all`.
        ///
        /// # Errors
        /// The first error in the order of the shapes.
        #[deprecated(note = "call `run_all`")]
        pub fn generate_all_into<Sink: cga_rt::Sink + ::core::marker::Send>(
            &self,
            shapes: &[cga_rt::Shape],
            settings: &cga_rt::Settings,
            sink: impl ::core::ops::Fn(&cga_rt::Stretch) -> Sink + ::core::marker::Sync,
        ) -> ::core::result::Result<cga_rt::Batches<Sink>, cga_rt::RunError> {
            cga_rt::run_all(self, shapes, settings, sink)
        }
    }
}
