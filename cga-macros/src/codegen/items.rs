//! The public struct, the evaluated attributes, the calls that may wait, and the trait implementations.

use cga_lang::compile::SkeletonAttr;
use cga_lang::ir::{Attr, Global, RuleId, Type, Value};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{quote, quote_spanned};

use super::expr::{Place, value};
use super::names::field;
use super::{Cx, inner_type, local};
use crate::door::Source;
use crate::header::{Header, capture};

/// What the user's code sees of a grammar. Without `hidden` it is a skeleton that cannot run: there are errors.
pub(crate) struct Public {
    pub(crate) attrs: Vec<PublicAttr>,
    /// Handles of captured `#` values, in order, with the types the rules need.
    pub(crate) captures: Vec<(u32, Type)>,
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
    pub(super) fn of(attr: &Attr, source: &Source) -> Self {
        let about = if attr.doc.is_empty() { String::new() } else { format!("\n\n{}", attr.doc) };
        let default = match &attr.known {
            Some(known) => format!("default {}", show(known)),
            None => "`None` computes the default for each initial shape".into(),
        };
        PublicAttr {
            name: field(&attr.name, source.token(attr.span.first)),
            ty: attr.ty,
            known: attr.known.clone(),
            doc: format!("The attribute `{}`, {default}.{about}", attr.name),
        }
    }
}

impl PublicAttr {
    /// Of a grammar with errors: a number, where nothing better is known.
    pub(crate) fn known_so_far(attr: &SkeletonAttr, source: &Source) -> Self {
        PublicAttr {
            name: field(&attr.name, source.token(attr.span.first)),
            ty: attr.ty.unwrap_or(Type::Float),
            known: Some(attr.known.clone().unwrap_or(match attr.ty {
                Some(Type::Bool) => Value::Bool(false),
                Some(Type::Text) => Value::Text(String::new()),
                Some(Type::Float) | None => Value::Float(0.0),
            })),
            doc: format!("The attribute `{}`.", attr.name),
        }
    }
}

fn show(value: &Value) -> String {
    match value {
        Value::Float(number) => format!("`{number}`"),
        Value::Bool(truth) => format!("`{truth}`"),
        Value::Text(text) => format!("`{text:?}`"),
    }
}

/// The public struct and all that belongs to it.
pub(crate) fn public(public: &Public, header: &Header) -> TokenStream {
    let (name, visibility, attributes) = (header.ident(), &header.visibility, &header.attributes);
    let runtime = &header.runtime;
    let place = Span::mixed_site();
    let fields = public.attrs.iter().map(|attr| {
        let (name, doc, ty) = (&attr.name, &attr.doc, outer_type(attr.ty));
        match attr.known {
            Some(_) => quote_spanned!(place=> #[doc = #doc] pub #name: #ty),
            None => quote_spanned!(place=> #[doc = #doc] pub #name: ::core::option::Option<#ty>),
        }
    });
    let defaults: Vec<TokenStream> = public.attrs.iter().map(default_field).collect();
    let expression = header.name.is_none();
    let captures: Vec<_> = if expression { public.captures.clone() } else { Vec::new() };
    let capture_names: Vec<Ident> = (0..captures.len()).map(|at| local("captured_", at)).collect();
    let capture_types = captures.iter().map(|(_, ty)| match ty {
        Type::Text => quote_spanned!(place=> #runtime::Text),
        ty => inner_type(*ty),
    });
    let capture_values = captures.iter().map(|(handle, ty)| {
        let (convert, taken) = (host_conversion(*ty), capture(*handle));
        quote_spanned!(place=> #runtime::host::#convert(#taken))
    });
    let about = format!("The grammar `{}`.", header.label());
    let doc = if attributes.to_string().contains("doc") { TokenStream::new() } else { quote!(#[doc = #about]) };
    let methods = methods(public.hidden.is_some());
    let default_impl = (!expression).then(|| {
        quote_spanned! { place=>
            #[automatically_derived]
            impl ::core::default::Default for #name {
                fn default() -> Self {
                    #name { #(#defaults,)* }
                }
            }
        }
    });
    let hidden = &public.hidden;
    let value = expression.then(|| {
        quote_spanned!(place=> #name { #(#defaults,)* #(#capture_names: #capture_values,)* })
    });
    quote_spanned! { place=>
        #attributes
        #doc
        #[derive(::core::clone::Clone, ::core::fmt::Debug)]
        #visibility struct #name {
            #(#fields,)*
            #(#capture_names: #capture_types,)*
        }
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

/// `name: default`.
fn default_field(attr: &PublicAttr) -> TokenStream {
    let place = Span::mixed_site();
    let name = &attr.name;
    match &attr.known {
        None => quote_spanned!(place=> #name: ::core::option::Option::None),
        Some(Value::Text(text)) => quote_spanned!(place=> #name: ::std::string::String::from(#text)),
        Some(known) => {
            let known = value(known);
            quote_spanned!(place=> #name: #known)
        }
    }
}

/// The methods of the struct. Where there are errors they have the same signatures and no bodies to speak of.
fn methods(runs: bool) -> TokenStream {
    let place = Span::mixed_site();
    let body = |body: TokenStream| {
        if runs { body } else { quote_spanned!(place=> ::core::unreachable!("the rules have errors")) }
    };
    let generate = body(quote_spanned!(place=> cga_rt::generate(self, shape, &::core::default::Default::default())));
    let generate_from = body(quote_spanned! { place=>
        let settings = cga_rt::Settings {
            start: ::core::option::Option::Some(::std::string::String::from(rule)),
            ..::core::default::Default::default()
        };
        cga_rt::generate(self, shape, &settings)
    });
    let generate_with = body(quote_spanned!(place=> cga_rt::generate(self, shape, settings)));
    let generate_into = body(quote_spanned!(place=> cga_rt::run(self, shape, settings, sink)));
    let allow = quote_spanned!(place=> #[allow(dead_code, unused_variables, clippy::missing_errors_doc)]);
    quote_spanned! { place=>
        /// Runs the start rule on a shape, with default settings.
        #allow
        pub fn generate(&self, shape: &cga_rt::Shape) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
            #generate
        }

        /// Runs the rule of that name on a shape, with default settings.
        #allow
        pub fn generate_from(
            &self,
            rule: &::core::primitive::str,
            shape: &cga_rt::Shape,
        ) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
            #generate_from
        }

        /// Runs on a shape with settings: start rule, limits, assets.
        #allow
        pub fn generate_with(
            &self,
            shape: &cga_rt::Shape,
            settings: &cga_rt::Settings,
        ) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
            #generate_with
        }

        /// Runs on a shape and hands the leaves to a sink. This is the fast path: no model in between.
        #allow
        pub fn generate_into<Sink: cga_rt::Sink + ?::core::marker::Sized>(
            &self,
            shape: &cga_rt::Shape,
            settings: &cga_rt::Settings,
            sink: &mut Sink,
        ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
            #generate_into
        }
    }
}

/// The Rust type of a public field.
fn outer_type(ty: Type) -> TokenStream {
    match ty {
        Type::Text => quote_spanned!(Span::mixed_site()=> ::std::string::String),
        ty => inner_type(ty),
    }
}

/// The conversion of a Rust value.
pub(super) fn host_conversion(ty: Type) -> TokenStream {
    let place = Span::mixed_site();
    match ty {
        Type::Float => quote_spanned!(place=> ToFloat::to_float),
        Type::Bool => quote_spanned!(place=> ToBool::to_bool),
        Type::Text => quote_spanned!(place=> ToText::to_text),
    }
}

/// Attributes and constants of one run, and captured values.
pub(super) fn values(cx: &Cx<'_>) -> TokenStream {
    let attrs = cx.grammar.attrs.iter().enumerate().map(|(at, attr)| (local("attr_", at), inner_type(attr.ty)));
    let consts = cx.grammar.consts.iter().enumerate().map(|(at, it)| (local("const_", at), inner_type(it.ty)));
    let hosts = cx.grammar.hosts.iter().enumerate().filter(|_| cx.captured);
    let hosts = hosts.map(|(at, host)| (local("captured_", at), inner_type(host.ty)));
    let (names, types): (Vec<_>, Vec<_>) = attrs.chain(consts).chain(hosts).unzip();
    quote_spanned! { Span::mixed_site()=>
        #[derive(::core::default::Default)]
        #[allow(dead_code)]
        pub struct CgaValues { #(#names: #types,)* }
    }
}

/// One variant for each rule in a cycle.
pub(super) fn calls(cx: &Cx<'_>) -> TokenStream {
    let variants = cyclic(cx).map(|(id, params)| {
        let name = local("Rule", id.0 as usize);
        quote_spanned!(Span::mixed_site()=> #name(#(#params),*))
    });
    quote_spanned! { Span::mixed_site()=>
        #[allow(dead_code)]
        pub enum CgaCall { #(#variants,)* }
    }
}

/// Rules in cycles with the types of their parameters.
fn cyclic<'c>(cx: &'c Cx<'_>) -> impl Iterator<Item = (RuleId, Vec<TokenStream>)> + 'c {
    let rules = cx.grammar.rules.iter().enumerate().filter(|(_, rule)| rule.cycle.is_some());
    rules.map(|(at, rule)| (RuleId(at as u32), rule.params.iter().map(|param| inner_type(param.ty)).collect()))
}

/// The runtime's `Rules` and `Grammar`.
pub(super) fn rules_impl(cx: &Cx<'_>, header: &Header) -> TokenStream {
    let (name, label) = (header.ident(), header.label());
    let place = Span::mixed_site();
    let names = cx.grammar.rules.iter().map(|rule| &rule.name);
    let default = cx.grammar.start;
    let mut starts: Vec<RuleId> = (0..cx.grammar.rules.len() as u32).map(RuleId).collect();
    starts.retain(|id| cx.grammar.rules[id.0 as usize].startable);
    starts.sort_by_key(|id| (Some(*id) != default, *id));
    let start_names = starts.iter().map(|id| &cx.grammar.rules[id.0 as usize].name);
    let start_numbers = starts.iter().map(|id| Literal::u32_suffixed(id.0));
    let start_arms = starts.iter().map(|id| {
        let (number, rule) = (Literal::u32_suffixed(id.0), cx.rule(*id, place));
        quote_spanned!(place=> #number => CgaRules::#rule(g, cx, shape))
    });
    let resume_arms = cyclic(cx).map(|(id, params)| {
        let (variant, rule) = (local("Rule", id.0 as usize), cx.rule(id, place));
        let args: Vec<Ident> = (0..params.len()).map(|at| local("a", at)).collect();
        quote_spanned!(place=> CgaCall::#variant(#(#args),*) => CgaRules::#rule(g, cx, shape, #(#args),*))
    });
    let resume = if cyclic(cx).next().is_some() {
        quote_spanned!(place=> match call { #(#resume_arms,)* })
    } else {
        quote_spanned!(place=> match call {})
    };
    let checks = cx.grammar.attrs.iter().filter_map(check);
    let globals = cx.grammar.init.iter().map(|global| init(cx, *global));
    let captured = (0..cx.grammar.hosts.len()).filter(|_| cx.captured).map(|at| local("captured_", at));
    let captured = captured.map(|name| quote_spanned!(place=> g.#name = self.#name.clone();));
    let table = cx.grammar.attrs.iter().map(attribute);
    quote_spanned! { place=>
        #[automatically_derived]
        #[allow(unused_variables, unused_mut, unused_parens, unused_braces, unreachable_code, clippy::all, clippy::pedantic)]
        impl cga_rt::Rules for #name {
            type Values = CgaValues;
            type Call = CgaCall;
            const NAMES: &'static [&'static ::core::primitive::str] = &[#(#names),*];
            const STARTS: &'static [&'static ::core::primitive::str] = &[#(#start_names),*];
            const START_RULES: &'static [::core::primitive::u32] = &[#(#start_numbers),*];

            fn check(&self) -> ::core::result::Result<(), cga_rt::Error> {
                #(#checks)*
                ::core::result::Result::Ok(())
            }

            fn values(&self, env: &mut cga_rt::Env, initial: &cga_rt::Shape) -> CgaValues {
                let mut g = <CgaValues as ::core::default::Default>::default();
                #(#captured)*
                #(#globals)*
                g
            }

            fn start<Sink: cga_rt::Sink + ?::core::marker::Sized>(
                g: &CgaValues,
                cx: &mut cga_rt::Cx<'_, Sink, CgaCall>,
                rule: ::core::primitive::u32,
                shape: cga_rt::ShapeRef<'_>,
            ) -> cga_rt::Flow {
                match rule {
                    #(#start_arms,)*
                    _ => cga_rt::Flow::Continue(()),
                }
            }

            fn resume<Sink: cga_rt::Sink + ?::core::marker::Sized>(
                g: &CgaValues,
                cx: &mut cga_rt::Cx<'_, Sink, CgaCall>,
                shape: cga_rt::ShapeRef<'_>,
                call: CgaCall,
            ) -> cga_rt::Flow {
                #resume
            }
        }

        #[automatically_derived]
        impl cga_rt::Grammar for #name {
            fn name(&self) -> &'static ::core::primitive::str {
                #label
            }

            fn attributes(&self) -> &'static [cga_rt::Attribute] {
                &[#(#table),*]
            }

            fn start_rules(&self) -> &'static [&'static ::core::primitive::str] {
                <Self as cga_rt::Rules>::STARTS
            }

            fn derive(
                &self,
                shape: &cga_rt::Shape,
                settings: &cga_rt::Settings,
                sink: &mut dyn cga_rt::Sink,
            ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
                cga_rt::run(self, shape, settings, sink)
            }
        }
    }
}

/// Evaluates one attribute or constant.
fn init(cx: &Cx<'_>, global: Global) -> TokenStream {
    let place = Span::mixed_site();
    let (target, number, computed, given) = match global {
        Global::Attr(id) => {
            let attr = &cx.grammar.attrs[id.0 as usize];
            let field = field(&attr.name, cx.source.token(attr.span.first));
            let given = match (attr.ty, &attr.known) {
                (Type::Text, Some(_)) => quote_spanned!(place=> cga_rt::Text::from(self.#field.as_str())),
                (_, Some(_)) => quote_spanned!(place=> self.#field),
                (Type::Text, None) => quote_spanned!(place=> self.#field.as_deref().map(cga_rt::Text::from)),
                (_, None) => quote_spanned!(place=> self.#field),
            };
            let given = (given, attr.known.is_some());
            (local("attr_", id.0 as usize), id.0, &attr.default, Some(given))
        }
        // The streams of constants come after those of attributes.
        Global::Const(id) => {
            let number = cx.grammar.attrs.len() as u32 + id.0;
            (local("const_", id.0 as usize), number, &cx.grammar.consts[id.0 as usize].value, None)
        }
    };
    let number = Literal::u32_suffixed(number);
    let code = cx.expr(computed, &Place::function());
    let computed = quote_spanned! { place=> {
        let shape = &mut cga_rt::global(initial, #number);
        let g = &g;
        #code
    } };
    match given {
        Some((given, true)) => quote_spanned!(place=> g.#target = #given;),
        Some((given, false)) => quote_spanned! { place=>
            g.#target = match #given {
                ::core::option::Option::Some(value) => value,
                ::core::option::Option::None => #computed,
            };
        },
        None => quote_spanned!(place=> g.#target = #computed;),
    }
}

/// The check of a restricted range.
fn check(attr: &Attr) -> Option<TokenStream> {
    let place = Span::mixed_site();
    let range = attr.range.filter(|range| range.restricted && attr.ty == Type::Float)?;
    let (range, name, field) = (range_tokens(range), &attr.name, field(&attr.name, place));
    Some(match attr.known {
        Some(_) => quote_spanned!(place=> #range.check(#name, self.#field)?;),
        None => quote_spanned! { place=>
            if let ::core::option::Option::Some(value) = self.#field {
                #range.check(#name, value)?;
            }
        },
    })
}

fn range_tokens(range: cga_lang::ir::Range) -> TokenStream {
    let number = |number| value(&Value::Float(number));
    let (min, max, step, restricted) = (number(range.min), number(range.max), number(range.step), range.restricted);
    quote_spanned!(Span::mixed_site()=> cga_rt::Range { min: #min, max: #max, step: #step, restricted: #restricted })
}

/// A row of the attribute table.
fn attribute(attr: &Attr) -> TokenStream {
    let place = Span::mixed_site();
    let (name, group, about) = (&attr.name, &attr.group, &attr.doc);
    let kind = match attr.ty {
        Type::Float => quote_spanned!(place=> Float),
        Type::Bool => quote_spanned!(place=> Bool),
        Type::Text => quote_spanned!(place=> Text),
    };
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
    quote_spanned! { place=>
        cga_rt::Attribute { name: #name, default: cga_rt::Default::#kind(#default), range: #range, group: &[#(#group),*], about: #about }
    }
}
