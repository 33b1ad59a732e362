//! A checked grammar → Rust. No errors here. `cga_lang::lower` decides what the rules mean, and `cga_lang::ir::plan` how they run.
//! Code generation writes this as Rust. It numbers the places of templates and the functions of material changes in the order in
//! which it writes them: equal code is one function, and user code can be part of it.
//!
//! The output is the public struct and one anonymous const with everything else in it: the evaluated attributes, the
//! calls that may wait, and one function a rule. A sink is behind `dyn`, so rules are compiled once. Local names are hygienic; code
//! has the location of its rules, which debuggers and backtraces show.

mod access;
mod arms;
mod attribute_table;
mod expr;
mod fields;
mod items;
mod lazy;
mod names;
mod operands;
mod operation;
mod public;
mod rule;
#[cfg(feature = "live")]
mod rule_source;
mod sections;
mod site;
mod split;
mod state;
mod types;

use std::cell::{Cell, RefCell};

use cga_lang::ir::facts::LeftShapes;
use cga_lang::ir::plan::RunPlan;
use cga_lang::ir::{ExprKind, Grammar, HostId, Param, RuleId, Type};
use cga_source::rust::Header;
use proc_macro2::{Ident, Literal, Span, TokenStream};

use crate::location;
use crate::output::{HostType, Output};
use crate::source::Source;

pub(crate) use names::Taken;
#[cfg(test)]
pub(crate) use names::is_local;
pub(crate) use names::is_plain;
pub(crate) use public::{Public, PublicAttr, public};

/// The tables that all parts of the generator use.
struct Generator<'a> {
    grammar: &'a Grammar,
    source: &'a Source,
    names: names::ItemNames,
    plan: RunPlan<'a>,
    /// True if blocks tell when they are entered and left.
    tells_parts: bool,
    /// By rule, the shapes that it can leave for queries; empty if there are no queries.
    left_shapes: Vec<LeftShapes>,
    /// True if `#` values are captured, as in the expression form.
    captured: bool,
    /// The required type of each `#` value.
    hosts: Vec<HostType>,
    /// The number of attributes. Constants come after them.
    attrs: u32,
    /// The attributes of renewals, by name.
    renewed: Vec<String>,
    /// Places with a template so far.
    places: Cell<u32>,
    material_changes: RefCell<site::MaterialChanges>,
    params: RefCell<names::ParamNames>,
}

/// Writes a grammar.
pub(crate) fn grammar(grammar: &Grammar, header: &Header, source: &Source) -> Output {
    let (names, plan) = (names::ItemNames::new(grammar), RunPlan::new(grammar));
    let (hosts, renewed) = (host_types(grammar), state::renewed(grammar));
    let cx = Generator {
        grammar,
        source,
        names,
        tells_parts: plan.tells_parts(),
        left_shapes: plan.left_shapes(),
        plan,
        captured: header.name.is_none(),
        hosts,
        attrs: grammar.globals.iter().filter(|global| global.attr.is_some()).count() as u32,
        renewed,
        places: Cell::default(),
        material_changes: RefCell::default(),
        params: RefCell::new(names::ParamNames::new(source.hosts().iter().map(|host| &host.expr))),
    };
    let (values, call) = (items::values(&cx), items::calls(&cx));
    let (rules, functions) = (rule::rules(&cx), rule::functions(&cx));
    let resume = items::resume(&cx);
    let renewals = cx.renewals();
    let lazy = cx.lazy_functions();
    let material_changes = cx.material_changes();
    let of_values = [&renewals, &lazy, &material_changes]
        .iter()
        .any(|code| !code.is_empty())
        .then(|| code!(#[allow(dead_code, clippy::all, clippy::pedantic, clippy::nursery)] impl CgaValues { #lazy #renewals #material_changes }));
    let implementation = items::rules_impl(&cx, header);
    let imports = cx.params.borrow().imports();
    let hidden = code! {
        #imports
        #values
        #of_values
        #call
        /// The rules and functions, one function each.
        enum CgaRules {}
        // Named and used by the rules, at the user's own tokens.
        #[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
        impl CgaRules {
            #rules
            #functions
            #resume
        }
        #implementation
    };
    let public = Public {
        attrs: public_attrs(grammar, source),
        captures: if cx.captured { cx.hosts.clone() } else { Vec::new() },
        hidden: Some(hidden),
    };
    let captures = grammar.hosts.iter().zip(&cx.hosts).map(|(host, ty)| (host.handle, Some(*ty))).collect();
    Output { code: public::public(&public, header), captures }
}

/// The public fields of a grammar, for code that cannot run.
pub(crate) fn public_attrs(grammar: &Grammar, source: &Source) -> Vec<PublicAttr> {
    fields::of(grammar, source).iter().map(PublicAttr::of).collect()
}

/// The required type of a `#` value: the type that the rules infer, or any type if it is only converted to text.
fn host_types(grammar: &Grammar) -> Vec<HostType> {
    let mut types: Vec<HostType> = grammar.hosts.iter().map(|host| HostType::Is(host.ty)).collect();
    cga_lang::ir::walk::exprs(grammar, &mut |expr| {
        if let ExprKind::ToText(inner) = &expr.kind
            && let ExprKind::Host(HostId(id)) = inner.kind
        {
            types[id as usize] = HostType::Shown;
        }
    });
    types
}

/// The Rust type of a value inside the rules.
fn inner_type(ty: Type) -> TokenStream {
    types::inner(ty, &code!(cga_rt))
}

impl Generator<'_> {
    /// Without the feature `live`, grammars do not know where they come from.
    #[cfg(not(feature = "live"))]
    fn rule_source(&self, _: &Header) -> TokenStream {
        TokenStream::new()
    }

    /// Writes code at the location of its rules. Rules of a string or a file have the location of the literal.
    fn at<T>(&self, span: cga_lang::span::Span, write: impl FnOnce() -> T) -> T {
        location::at(self.source.token(span.first), write)
    }

    /// Begins a rule or function with these parameters and locals.
    fn name_params(&self, params: &[Param]) {
        self.params.borrow_mut().begin(params);
    }

    /// A parameter or local of the rule or function that is written.
    fn param(&self, number: usize) -> Ident {
        self.params.borrow().param(number, location::current())
    }

    /// The number of a leaf's name.
    fn leaf(&self, name: &str) -> Literal {
        Literal::u32_suffixed(self.plan.leaves.number(name))
    }

    /// A function of the hidden impl, with the span of a use.
    fn rule(&self, rule: RuleId, place: Span) -> Ident {
        self.names.rule(rule, place)
    }
}

/// A name of the generated code or of the runtime, with the span of [`code!`].
fn hygienic(name: &str) -> Ident {
    Ident::new(name, location::current())
}

/// A local of the generated code, by number.
fn local(prefix: &str, number: usize) -> Ident {
    hygienic(&format!("{prefix}{number}"))
}
