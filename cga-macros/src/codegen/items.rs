//! The items besides the public struct: evaluated attributes, calls that may wait, and the trait implementations.

use std::collections::HashMap;

use cga_lang::ir::walk;
use cga_lang::ir::{ExprKind, Global, GlobalId, RuleId, Type};
use cga_source::rust::Header;
use proc_macro2::{Ident, Literal, Span, TokenStream};

use super::access::Access;
use super::expr::is_one_of;
use super::fields::AttrField;
use super::public::captured;
use super::rule::given;
use super::{Generator, attribute_table, fields, hygienic, inner_type, local, site, types};

/// Attributes and constants of one run, and captured values.
pub(super) fn values(cx: &Generator<'_>) -> TokenStream {
    let field = |lazy: bool, ty: Type| {
        let ty = inner_type(ty);
        if lazy { code!(cga_rt::Lazy<#ty>) } else { ty }
    };
    let globals = cx.grammar.globals.iter().zip(0..);
    let globals = globals.map(|(it, id)| (cx.global_name(GlobalId(id)), field(it.lazy, it.ty)));
    let origin = cx.has_lazy().then(|| (hygienic("origin"), code!(cga_rt::Origin)));
    // Renewals of imports open a cycle on a copy.
    let copied = cx.renews_lazy().then(|| code!(#[derive(::core::clone::Clone)]));
    let style = cx.asks_for_style().then(|| (hygienic("style"), code!(::core::primitive::u32)));
    let hosts = cx.hosts.iter().enumerate().filter(|_| cx.captured);
    let hosts = hosts.map(|(at, ty)| (captured(at), inner_type(ty.inside())));
    let (names, types): (Vec<_>, Vec<_>) =
        globals.chain(style).chain(origin).chain(hosts).chain(cx.held_fields()).unzip();
    code! {
        #copied
        #[derive(::core::default::Default)]
        pub struct CgaValues { #(#names: #types,)* }
    }
}

/// One variant for each rule that a call may have to wait for, or that a template leaves out. Grammars without such a rule share a
/// type of the runtime, and so the functions of the runtime that are generic over it.
pub(super) fn calls(cx: &Generator<'_>) -> TokenStream {
    let variants = waiting(cx).map(|(id, params)| {
        let name = local("Rule", id.0 as usize);
        code!(#name(#(#params),*))
    });
    let variants: Vec<TokenStream> = variants.collect();
    if variants.is_empty() {
        return code!(
            type CgaCall = cga_rt::NoCall;
        );
    }
    code! {
        #[derive(::core::clone::Clone)]
        pub enum CgaCall { #(#variants,)* }
    }
}

/// Rules whose calls may have to wait or may be left out, with the types of their parameters.
fn waiting<'c>(cx: &'c Generator<'_>) -> impl Iterator<Item = (RuleId, Vec<TokenStream>)> + 'c {
    let rules = cx.grammar.rules.iter().enumerate().map(|(at, rule)| (RuleId(at as u32), rule));
    let rules = rules.filter(|(id, _)| cx.plan.may_run_later(*id));
    rules.map(|(id, rule)| {
        let site = site::param(rule.sites.len()).map(|(_, ty)| ty);
        (id, site.into_iter().chain(given(&rule.params, &rule.locals)).collect())
    })
}

impl Generator<'_> {
    /// Returns true if something depends on the style of the run.
    fn asks_for_style(&self) -> bool {
        let mut asks = false;
        walk::exprs(self.grammar, &mut |expr| asks |= matches!(expr.kind, ExprKind::Style(_)));
        asks
    }
}

/// The function that runs a call that waited or was left out.
pub(super) fn resume(cx: &Generator<'_>) -> TokenStream {
    let resume_arms = waiting(cx).map(|(id, params)| {
        let (variant, rule) = (local("Rule", id.0 as usize), cx.rule(id, Span::mixed_site()));
        let args: Vec<Ident> = (0..params.len()).map(|at| local("a", at)).collect();
        code!(CgaCall::#variant(#(#args),*) => CgaRules::#rule(g, cx, shape, #(#args),*))
    });
    code! {
        fn cga_resume(
            g: &CgaValues,
            cx: &mut cga_rt::Cx<'_, CgaCall>,
            shape: &cga_rt::ShapeRef<'_>,
            call: CgaCall,
        ) -> cga_rt::Flow {
            match call { #(#resume_arms,)* }
        }
    }
}

/// The runtime's `Rules` and `Grammar`.
pub(super) fn rules_impl(cx: &Generator<'_>, header: &Header) -> TokenStream {
    let (name, label) = (header.ident(), header.label());
    let names = cx.plan.trails.names();
    let leaves = cx.plan.leaves.names();
    let has_tags = cx.plan.has_tags();
    let starts = &cx.grammar.starts;
    let start_rows = starts.iter().map(attribute_table::start);
    let entries =
        starts.iter().zip(cx.plan.start_queries()).map(|(start, queries)| attribute_table::entry(start, queries));
    // Styles may share a rule.
    let mut start_rules: Vec<RuleId> = starts.iter().map(|start| start.rule).collect();
    start_rules.sort_unstable();
    start_rules.dedup();
    let start_arms = start_rules.into_iter().map(|rule| {
        let (number, rule) = (Literal::u32_suffixed(rule.0), cx.rule(rule, Span::mixed_site()));
        code!(#number => CgaRules::#rule(g, cx, shape))
    });
    let fields = fields::of(cx.grammar, cx.source);
    let check = if fields.iter().any(attribute_table::is_restricted) {
        code!(cga_rt::check(self))
    } else {
        code!(::core::result::Result::Ok(()))
    };
    let by_name = fields::by_name(&fields);
    let (held, globals) = (cx.hold_fields(&by_name), initial_values(cx, &by_name));
    let origin = cx.has_lazy().then(|| code!(g.origin = cga_rt::Origin::initial(initial);));
    let (get_arms, set_arms) = fields::arms(&fields);
    let (reset_arms, used) = (fields::reset_arms(&fields), fields.iter().map(|field| used_value(cx, field)));
    let captured = (0..cx.grammar.hosts.len()).filter(|_| cx.captured).map(captured);
    let captured = captured.map(|name| code!(g.#name = ::core::clone::Clone::clone(&self.#name);));
    let attribute_names = fields.iter().map(|field| &field.global.name);
    let table = fields.iter().map(|field| attribute_table::attribute(field, cx.grammar));
    let source = cx.rule_source(header);
    let about = &cx.grammar.about;
    let about = (!about.is_empty()).then(|| {
        code! {
            fn about(&self) -> &::core::primitive::str {
                #about
            }
        }
    });
    code! {
        #[automatically_derived]
        impl cga_rt::Checked for #name {}

        #[automatically_derived]
        impl cga_rt::Rules for #name {
            type Values = CgaValues;
            type Call = CgaCall;

            fn tables(&self) -> &cga_rt::RuleTables {
                static TABLES: cga_rt::LazyLock<cga_rt::RuleTables> = cga_rt::LazyLock::new(|| cga_rt::RuleTables {
                    name: cga_rt::Text::fixed(#label),
                    rules: cga_rt::names(&[#(#names),*]),
                    leaves: cga_rt::names(&[#(#leaves),*]),
                    tags: #has_tags,
                    starts: cga_rt::list([#(#start_rows),*]),
                    entries: cga_rt::entries(&[#(#entries),*]),
                    attributes: cga_rt::texts(&[#(#attribute_names),*]),
                });
                &TABLES
            }

            fn check(&self) -> ::core::result::Result<(), cga_rt::Error> {
                #check
            }

            fn values(
                &self,
                env: &mut cga_rt::Env,
                initial: &cga_rt::Shape,
                style: ::core::primitive::u32,
            ) -> CgaValues {
                let mut g = <CgaValues as ::core::default::Default>::default();
                #(#captured)*
                #origin
                #held
                #globals
                g
            }

            fn used(
                g: &CgaValues,
                style: ::core::primitive::u32,
                each: &mut dyn ::core::ops::FnMut(::core::option::Option<cga_rt::Value>),
            ) {
                #(each(#used);)*
            }

            fn start(
                g: &CgaValues,
                cx: &mut cga_rt::Cx<'_, CgaCall>,
                rule: ::core::primitive::u32,
                shape: &cga_rt::ShapeRef<'_>,
            ) -> cga_rt::Flow {
                match rule {
                    #(#start_arms,)*
                    _ => cga_rt::Flow::Continue(()),
                }
            }

            fn resume(
                g: &CgaValues,
                cx: &mut cga_rt::Cx<'_, CgaCall>,
                shape: &cga_rt::ShapeRef<'_>,
                call: CgaCall,
            ) -> cga_rt::Flow {
                CgaRules::cga_resume(g, cx, shape, call)
            }
        }

        #[automatically_derived]
        impl cga_rt::Grammar for #name {
            fn name(&self) -> &::core::primitive::str {
                #label
            }

            #about

            fn attributes(&self) -> &[cga_rt::Attribute] {
                static ATTRIBUTES: cga_rt::LazyLock<cga_rt::Vec<cga_rt::Attribute>> =
                    cga_rt::LazyLock::new(|| cga_rt::list([#(#table),*]));
                &ATTRIBUTES
            }

            fn attribute_get(&self, index: ::core::primitive::usize) -> ::core::option::Option<cga_rt::Value> {
                match index {
                    #(#get_arms)*
                    _ => ::core::option::Option::None,
                }
            }

            fn attribute_set(&mut self, index: ::core::primitive::usize, value: cga_rt::Value) {
                match index {
                    #(#set_arms)*
                    _ => {}
                }
            }

            fn attribute_reset(&mut self, index: ::core::primitive::usize) {
                match index {
                    #(#reset_arms)*
                    _ => {}
                }
            }

            #source

            fn boxed(&self) -> cga_rt::Box<dyn cga_rt::Grammar + ::core::marker::Send + ::core::marker::Sync> {
                cga_rt::Box::new(::core::clone::Clone::clone(self))
            }

            fn used_values(
                &self,
                shape: &cga_rt::Shape,
                settings: &cga_rt::Settings,
            ) -> ::core::result::Result<cga_rt::Vec<(cga_rt::Text, cga_rt::Value)>, cga_rt::Error> {
                cga_rt::used_values(self, shape, settings)
            }

            fn start_rules(&self) -> &[cga_rt::StartRule] {
                &cga_rt::Rules::tables(self).starts
            }

            fn run(
                &self,
                shape: &cga_rt::Shape,
                settings: &cga_rt::Settings,
                sink: &mut dyn cga_rt::Sink,
            ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
                cga_rt::run(self, shape, settings, sink)
            }

            fn session<'g>(
                &'g self,
                settings: &cga_rt::Settings,
            ) -> ::core::result::Result<cga_rt::Box<dyn cga_rt::DynSession + 'g>, cga_rt::Error> {
                cga_rt::open(self, settings)
            }
        }
    }
}

/// The value of an attribute in a run; `None` if the style does not have it.
fn used_value(cx: &Generator<'_>, field: &AttrField<'_>) -> TokenStream {
    let mut value = code!(::core::option::Option::None);
    let own = |id: GlobalId| {
        let global = cx.grammar.global(id);
        global.public && global.attr.is_some() && global.name == field.global.name
    };
    for init in cx.grammar.init.iter().filter(|init| own(init.global)) {
        let name = cx.global_name(init.global);
        let found = code!(cga_rt::Evaluated::value(&g.#name));
        value = match &init.styles {
            None => found,
            Some(styles) => {
                let is_style = is_one_of(styles, &code!(style));
                code!(if #is_style { #found } else { #value })
            }
        };
    }
    value
}

/// Evaluates the attributes and constants of the style in force.
fn initial_values(cx: &Generator<'_>, fields: &HashMap<&str, &AttrField<'_>>) -> TokenStream {
    let style = cx.asks_for_style().then(|| code!(g.style = style;));
    let lazy = cx.grammar.init.iter().filter(|init| cx.is_lazy(init.global));
    let given = lazy.filter_map(|init| Some(cx.lazy_given(init.global, field(cx, fields, init.global)?)));
    let values = cx.grammar.init.chunk_by(|a, b| a.styles == b.styles).map(|inits| {
        let values = inits.iter().map(|own| init(cx, fields, own.global));
        match &inits[0].styles {
            Some(styles) => {
                let is_style = is_one_of(styles, &code!(style));
                code!(if #is_style { #(#values)* })
            }
            None => values.collect(),
        }
    });
    style.into_iter().chain(given).chain(values).collect()
}

/// The field of an attribute that has one.
fn field<'f, 'g>(
    cx: &Generator<'_>,
    fields: &HashMap<&str, &'f AttrField<'g>>,
    id: GlobalId,
) -> Option<&'f AttrField<'g>> {
    let global = cx.grammar.global(id);
    fields.get(global.name.as_str()).copied().filter(|_| global.public)
}

/// Evaluates one attribute or constant.
fn init(cx: &Generator<'_>, fields: &HashMap<&str, &AttrField<'_>>, id: GlobalId) -> TokenStream {
    if cx.is_lazy(id) {
        let value = cx.lazy_value(id, &code!(&g), &code!(env));
        return code!(cga_rt::computed(#value););
    }
    let (target, field) = (cx.global_name(id), field(cx, fields, id));
    let global @ Global { value, known, .. } = cx.grammar.global(id);
    let number = Literal::u32_suffixed(global.stream());
    let code = cx.expr(value, &Access::function());
    let computed = match known {
        Some(known) => types::value(known),
        None => code! { {
            let shape = &mut cga_rt::global(initial, #number);
            let g = &g;
            #code
        } },
    };
    match field {
        Some(field) if field.known.is_some() => {
            let given = field.value();
            code!(g.#target = #given;)
        }
        Some(field) => {
            let given = field.value();
            code! {
                g.#target = match #given {
                    ::core::option::Option::Some(value) => value,
                    ::core::option::Option::None => #computed,
                };
            }
        }
        None => code!(g.#target = #computed;),
    }
}
