//! A module for each context, with the names that fit it and the names that are used in it.
//!
//! rust-analyzer completes a name at its place in the expansion. It expands the rules with the name and without it, and looks in
//! the second expansion for the module before the name, at the same byte. So unknown names come first, one list
//! for each context, and each list ends with a long name that is always there. Nothing that a half-written name changes is
//! before them.

use cga_lang::editor::Context;
use cga_lang::editor::outline::{Part, PartKind, Word};
use cga_lang::reference::Section;
use proc_macro2::{Ident, Span, TokenStream};
use std::collections::BTreeMap;

use super::names::item;
use super::scopes::{Meaning, Scope};
use super::words::{Argument, argument, argument_module, argument_words, is_word};

/// A context.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Module {
    Operations,
    Annotations,
    Selectors,
    Values,
    /// The values of parts with parameters and local values of these names.
    ValuesOf(Vec<String>),
    /// The words of an argument.
    Words(String, usize),
}

/// The most names in one body: rust-analyzer passes over a body for each name in it.
const MOST_NAMES: usize = 16;

/// The most arguments that take words.
const MOST_ARGUMENTS: usize = 8;

/// The names that are used in a module: those with a meaning, and the others.
#[derive(Default)]
struct Uses {
    /// Leaves, which are declared where they are first used.
    leaves: BTreeMap<String, Ident>,
    known: Vec<TokenStream>,
    unknown: Vec<TokenStream>,
}

/// The unknown names, then all modules.
pub(super) fn modules(scope: &Scope<'_>) -> TokenStream {
    let all = uses(scope);
    // For the types of the parameters.
    let mut parts: BTreeMap<Vec<String>, &Part> = BTreeMap::new();
    for part in &scope.parts {
        parts.entry(locals(scope, part)).or_insert(part);
    }
    let inner: BTreeMap<&Vec<String>, usize> =
        parts.keys().enumerate().map(|(number, names)| (names, number)).collect();
    let name = |module: &Module| match module {
        Module::Operations => code!(operations),
        Module::Annotations => code!(annotations),
        Module::Selectors => code!(selectors),
        Module::Values => code!(values),
        Module::ValuesOf(names) => {
            let module = Ident::new(&format!("values_{}", inner.get(names).unwrap_or(&0)), Span::mixed_site());
            code!(#module)
        }
        Module::Words(call, number) => {
            let module = argument_module(call, *number);
            code!(#module)
        }
    };
    // In parentheses no semicolon is completed after a call.
    let unknown = all.iter().map(|(module, uses)| {
        let (module, list) = (name(module), &uses.unknown);
        code!(((#(#module::#list,)* #module::the_last_name_of_the_list_is_longer_than_names_in_rules));)
    });
    let modules = all.iter().map(|(module, uses)| {
        let (name, names, leaves) = (name(module), contents(scope, module, &parts), uses.leaves.values());
        let bodies = uses.known.chunks(MOST_NAMES).map(|names| code!(fn names() { (#(#names,)*); }));
        code!(mod #name { #names #(#[doc = "A leaf."] pub const #leaves: () = ();)* #(#bodies)* })
    });
    code! {
        fn unknown() { #(#unknown)* }
        #(#modules)*
    }
}

/// The names of a module, as items or imports.
fn contents(scope: &Scope<'_>, module: &Module, parts: &BTreeMap<Vec<String>, &Part>) -> TokenStream {
    let words = &scope.header.runtime;
    let items = |wanted: fn(PartKind) -> bool| -> TokenStream {
        scope.parts.iter().filter(|part| wanted(part.kind)).map(|part| item(scope, part)).collect()
    };
    match module {
        Module::Operations => {
            let rules = items(|kind| kind == PartKind::Rule);
            code!(pub use #words::words::operations::*; pub use #words::words::syntax::*; #rules)
        }
        Module::Annotations => code!(pub use #words::words::annotations::*;),
        Module::Selectors => code!(pub use #words::words::selectors::*;),
        Module::Values => {
            let own = items(|kind| matches!(kind, PartKind::Const | PartKind::Function));
            let attrs = scope.attrs().map(|token| scope.constant(token));
            code! {
                pub use #words::words::attributes::*;
                pub use #words::words::functions::*;
                pub use #words::words::syntax::*;
                #own
                #(#attrs)*
            }
        }
        Module::ValuesOf(names) => {
            let tokens = parts.get(names).into_iter().flat_map(|part| part.params.iter().chain(&part.locals));
            let params = tokens.map(|token| scope.constant(*token));
            code!(pub use super::values::*; #(#params)*)
        }
        Module::Words(call, number) => {
            let module = argument_module(call, *number);
            code!(pub use #words::words::arguments::#module::*;)
        }
    }
}

fn uses(scope: &Scope<'_>) -> BTreeMap<Module, Uses> {
    let mut all: BTreeMap<Module, Uses> = BTreeMap::new();
    for module in [Module::Operations, Module::Annotations, Module::Selectors, Module::Values] {
        all.entry(module).or_default();
    }
    for part in &scope.parts {
        let locals = locals(scope, part);
        let values = if locals.is_empty() { Module::Values } else { Module::ValuesOf(locals) };
        all.entry(values.clone()).or_default();
        for word in &part.words {
            let Some(name) = scope.plain(word.token) else { continue };
            for number in (0..MOST_ARGUMENTS).filter(|number| word.is_call && argument_words(name, *number)) {
                all.entry(Module::Words(name.to_owned(), number)).or_default();
            }
            let Some(meaning) = scope.meaning(part, word) else { continue };
            let (module, is_known) = module(scope, &values, word);
            let item = match meaning {
                // Their place is elsewhere.
                Meaning::Field | Meaning::Local => continue,
                Meaning::Item(name) => Some(scope.at(&name, word.token)),
                Meaning::Word => None,
            };
            let uses = all.entry(module.clone()).or_default();
            if word.is_leaf && !is_known && item.is_none() && !uses.leaves.contains_key(name) {
                uses.leaves.insert(name.to_owned(), scope.at(name, word.token));
                continue;
            }
            if is_known || item.is_some() || word.is_leaf {
                // Parameters are not in them.
                let module = if matches!(module, Module::ValuesOf(_)) { Module::Values } else { module };
                let path = item.map_or_else(|| path(scope, word), |item| code!(#item));
                all.entry(module).or_default().known.push(path);
            } else {
                let path = path(scope, word);
                // A function is completed without the arguments that are there.
                let call = (word.is_call && word.context != Context::Annotation).then(|| code!(()));
                all.entry(module).or_default().unknown.push(code!(#path #call));
            }
        }
    }
    all
}

/// The names of parameters and local values.
fn locals(scope: &Scope<'_>, part: &Part) -> Vec<String> {
    let tokens = part.params.iter().chain(&part.locals);
    tokens.filter_map(|token| scope.plain(*token).map(str::to_owned)).collect()
}

/// The module of a word of the language or of an unknown name. True if the module has it.
fn module(scope: &Scope<'_>, values: &Module, word: &Word) -> (Module, bool) {
    let name = scope.dotted(word);
    let is = |section| is_word(section, &name);
    let is_value = || is(Section::ShapeAttr) || is(Section::Function) || is(Section::Syntax);
    match word.context {
        Context::Operation => (Module::Operations, is(Section::Operation) || is(Section::Syntax)),
        Context::Selector => (Module::Selectors, is(Section::Selector)),
        Context::Annotation => (Module::Annotations, is(Section::Annotation)),
        Context::Value => (values.clone(), is_value()),
        Context::Argument { call, number } => {
            let call = scope.plain(call).unwrap_or_default();
            match argument(call, number, &name) {
                Argument::Word(is_known) => (Module::Words(call.to_owned(), number), is_known),
                Argument::Selector => (Module::Selectors, is(Section::Selector)),
                Argument::Value => (values.clone(), is_value()),
            }
        }
    }
}

/// A name with the names after its dots.
fn path(scope: &Scope<'_>, word: &Word) -> TokenStream {
    let names = std::iter::once(&word.token).chain(&word.fields);
    let names = names.map_while(|token| Some(scope.at(scope.plain(*token)?, *token)));
    code!(#(#names)::*)
}
