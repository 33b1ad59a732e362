//! The words of the language as documented items, to which rust-analyzer resolves the names in rules.

use cga_lang::ops::{ParamKind, all_functions, all_operations, functions, operations};
use cga_lang::reference::{Section, Word, entries, words as all};
use proc_macro2::{Ident, Span, TokenStream};
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::sync::LazyLock;

use crate::codegen::is_plain;

/// A module of items; names with dots are in modules.
#[derive(Default)]
struct Module {
    items: TokenStream,
    modules: BTreeMap<&'static str, Module>,
}

impl Module {
    /// The module that has a name with dots, and the last part of the name. `None` if Rust cannot have a part of it.
    fn of(&mut self, name: &'static str) -> Option<(&mut Self, Ident)> {
        let mut module = self;
        let (path, last) = name.rsplit_once('.').unwrap_or(("", name));
        for part in path.split('.').filter(|part| !part.is_empty()) {
            if !is_plain(part) {
                return None;
            }
            module = module.modules.entry(part).or_default();
        }
        is_plain(last).then(|| (module, hygienic(last)))
    }

    fn tokens(&self) -> TokenStream {
        let items = &self.items;
        let modules = self.modules.iter().map(|(name, module)| {
            let (name, tokens) = (hygienic(name), module.tokens());
            code!(pub mod #name { #tokens })
        });
        code!(#items #(#modules)*)
    }
}

fn hygienic(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// The meaning of a name alone as an argument.
pub(super) enum Argument {
    /// A word of the parameter; false if the parameter does not have it.
    Word(bool),
    /// A selector.
    Selector,
    /// A value.
    Value,
}

/// The meaning of the name `name` as an argument.
pub(super) fn argument(call: &str, number: usize, name: &str) -> Argument {
    let kinds = kinds(call, number);
    let is_word = kinds.iter().any(|kind| kind.has_word(name));
    if is_word || (!kinds.is_empty() && kinds.iter().all(|kind| kind.words().is_some())) {
        return Argument::Word(is_word);
    }
    let is_selector = kinds.iter().any(|kind| matches!(kind, ParamKind::Selector));
    if is_selector { Argument::Selector } else { Argument::Value }
}

/// Returns true if an argument can be a word.
pub(super) fn argument_words(call: &str, number: usize) -> bool {
    is_plain(call) && kinds(call, number).iter().any(|kind| kind.words().is_some())
}

/// Returns true if a table has the word.
pub(super) fn is_word(section: Section, name: &str) -> bool {
    static WORDS: LazyLock<HashSet<(Section, &'static str)>> =
        LazyLock::new(|| entries().into_iter().map(|entry| (entry.section, entry.name)).collect());
    WORDS.contains(&(section, name))
}

/// The module with the words of an argument.
pub(super) fn argument_module(call: &str, number: usize) -> Ident {
    hygienic(&module_name(call, number))
}

/// The kinds of an argument, in all rows of an operation and a function.
fn kinds(call: &str, number: usize) -> Vec<&'static ParamKind> {
    let rows = operations(call).map(|row| row.params).chain(functions(call).map(|row| row.params));
    rows.filter_map(|params| params.get(number)).map(|param| &param.kind).collect()
}

fn module_name(call: &str, number: usize) -> String {
    format!("{call}_{number}")
}

/// Modules of items, one for each table and one for each argument that takes words.
pub(crate) fn words() -> TokenStream {
    let mut tables: BTreeMap<&'static str, Module> = BTreeMap::new();
    let mut types = BTreeSet::new();
    for word in all() {
        if let Some((module, name)) = tables.entry(table(word.section)).or_default().of(word.name) {
            module.items.extend(item(&word, &name));
            types.extend(word.params.iter().flatten().map(|(_, kind)| *kind).chain(word.result));
        }
    }
    let tables = tables.iter().map(|(name, table)| {
        let (name, tokens) = (hygienic(name), table.tokens());
        code!(pub mod #name { use super::kinds::*; #tokens })
    });
    let types = types.into_iter().map(|kind| {
        let (name, ty) = (kind_name(kind), kind_type(kind));
        code!(pub type #name = #ty;)
    });
    let arguments = arguments();
    code! {
        #(#tables)*
        pub mod arguments { #arguments }
        pub mod kinds { #(#types)* }
    }
}

fn table(section: Section) -> &'static str {
    match section {
        Section::Syntax => "syntax",
        Section::Operation => "operations",
        Section::Selector => "selectors",
        Section::Function => "functions",
        Section::ShapeAttr => "attributes",
        Section::Annotation => "annotations",
    }
}

fn item(word: &Word, name: &Ident) -> TokenStream {
    let doc = &word.about;
    let Some(params) = &word.params else {
        return code!(#[doc = #doc] pub const #name: () = (););
    };
    let params = params.iter().filter(|(name, _)| is_plain(name)).map(|(name, kind)| {
        let (name, kind) = (hygienic(name), kind_name(kind));
        code!(#name: #kind)
    });
    let result = word.result.map(|kind| {
        let kind = kind_name(kind);
        code!(-> #kind)
    });
    code!(#[doc = #doc] pub fn #name(#(#params),*) #result { loop {} })
}

/// The name of a kind of argument as a type: `float_per_edge`.
fn kind_name(kind: &str) -> Ident {
    hygienic(&kind.replace(|c: char| !c.is_alphanumeric(), "_"))
}

fn kind_type(kind: &str) -> TokenStream {
    match kind {
        "float" => code!(f64),
        "bool" => code!(bool),
        "str" | "string" => code!(&'static ::core::primitive::str),
        _ => code!(()),
    }
}

/// The words of arguments, in a module for each argument.
fn arguments() -> TokenStream {
    let operations = all_operations().map(|row| (row.name, row.params));
    let functions = all_functions().map(|row| (row.name, row.params));
    let mut modules: BTreeMap<String, BTreeMap<&'static str, String>> = BTreeMap::new();
    for (call, params) in operations.chain(functions).filter(|(call, _)| is_plain(call)) {
        for (number, param) in params.iter().enumerate() {
            for word in param.kind.words().into_iter().flat_map(|words| words.current()) {
                let doc = format!("A word for `{}` of `{call}`.", param.name);
                modules.entry(module_name(call, number)).or_default().entry(word).or_insert(doc);
            }
        }
    }
    let modules = modules.iter().map(|(name, words)| {
        let (name, mut module) = (hygienic(name), Module::default());
        for (word, doc) in words {
            if let Some((module, word)) = module.of(word) {
                module.items.extend(code!(#[doc = #doc] pub const #word: () = ();));
            }
        }
        let tokens = module.tokens();
        code!(pub mod #name { #tokens })
    });
    modules.collect()
}
