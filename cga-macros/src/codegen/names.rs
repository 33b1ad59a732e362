//! Names of the generated functions: as in the rules where that is possible, unique in any case.

use std::collections::HashSet;

use cga_lang::ir::{FunctionId, Grammar, RuleId};

/// One name for each rule and function.
pub(super) struct Names {
    rules: Vec<String>,
    functions: Vec<String>,
}

impl Names {
    pub(super) fn new(grammar: &Grammar) -> Self {
        let mut taken = HashSet::new();
        // Written rules first: they keep their names, and overloads and blocks give way.
        let rules = grammar.rules.iter().map(|rule| unique(&rule.name, &mut taken)).collect();
        let functions = grammar.functions.iter().map(|function| unique(&function.name, &mut taken)).collect();
        Names { rules, functions }
    }

    pub(super) fn rule(&self, rule: RuleId) -> &str {
        &self.rules[rule.0 as usize]
    }

    pub(super) fn function(&self, function: FunctionId) -> &str {
        &self.functions[function.0 as usize]
    }
}

fn unique(name: &str, taken: &mut HashSet<String>) -> String {
    let plain = identifier(name);
    let mut candidate = plain.clone();
    let mut number = 1;
    while !taken.insert(candidate.clone()) {
        number += 1;
        candidate = format!("{plain}_{number}");
    }
    candidate
}

/// `Facade/2` as `Facade_2`; words that Rust keeps for itself get a line at the end.
fn identifier(name: &str) -> String {
    let plain: String = name.chars().map(|c| if c.is_alphanumeric() || c == '_' { c } else { '_' }).collect();
    if plain == "_" || syn::parse_str::<syn::Ident>(&plain).is_err() { format!("{plain}_") } else { plain }
}

/// A field of the public struct: raw where Rust keeps the word for itself.
pub(crate) fn field(name: &str, place: proc_macro2::Span) -> proc_macro2::Ident {
    if syn::parse_str::<syn::Ident>(name).is_ok() {
        return proc_macro2::Ident::new(name, place);
    }
    let plain = identifier(name);
    // Four words cannot even be raw.
    if matches!(name, "self" | "Self" | "super" | "crate" | "_") || plain != format!("{name}_") {
        proc_macro2::Ident::new(&plain, place)
    } else {
        proc_macro2::Ident::new_raw(name, place)
    }
}
