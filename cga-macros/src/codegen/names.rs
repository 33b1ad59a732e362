//! Names of the generated functions and fields: as in the rules where that is possible, unique in any case.

use std::collections::HashSet;

use cga_lang::ir::{FunctionId, Grammar, RuleId};
use proc_macro2::{Ident, Span};

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

    /// The function of a rule, with the span of a use.
    pub(super) fn rule(&self, rule: RuleId, place: Span) -> Ident {
        ident(&self.rules[rule.0 as usize], place)
    }

    /// The function of a function, with the span of a use.
    pub(super) fn function(&self, function: FunctionId, place: Span) -> Ident {
        ident(&self.functions[function.0 as usize], place)
    }
}

fn unique(name: &str, taken: &mut HashSet<String>) -> String {
    // `Facade/2` is `Facade_2`.
    let plain: String = name.chars().map(|c| if c.is_alphanumeric() || c == '_' { c } else { '_' }).collect();
    let plain = if NEVER.contains(&plain.as_str()) { plain + "_" } else { plain };
    let mut candidate = plain.clone();
    let mut number = 1;
    while !taken.insert(candidate.clone()) {
        number += 1;
        candidate = format!("{plain}_{number}");
    }
    candidate
}

/// A name as Rust takes it, as little changed as possible: `r#type`, and `self_` for the words that cannot be raw.
pub(super) fn ident(name: &str, place: Span) -> Ident {
    if NEVER.contains(&name) {
        Ident::new(&format!("{name}_"), place)
    } else if RESERVED.contains(&name) {
        Ident::new_raw(name, place)
    } else {
        Ident::new(name, place)
    }
}

/// Words that cannot be names even with `r#`.
const NEVER: &[&str] = &["_", "self", "Self", "super", "crate"];

/// Words that Rust keeps for itself, in any edition.
const RESERVED: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn", "else", "enum",
    "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move",
    "mut", "override", "priv", "pub", "ref", "return", "static", "struct", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_kept_where_rust_allows_it() {
        let shown = |name| ident(name, Span::call_site()).to_string();
        assert_eq!(
            ["Lot", "type", "gen", "self", "union", "Vec"].map(shown),
            ["Lot", "r#type", "r#gen", "self_", "union", "Vec"]
        );
    }

    #[test]
    fn overloads_and_blocks_get_names_of_their_own() {
        let mut taken = HashSet::new();
        let names = ["A", "A", "A_2", "A/1", "A_1", "self", "self_"].map(|name| unique(name, &mut taken));
        assert_eq!(names, ["A", "A_2", "A_2_2", "A_1", "A_1_2", "self_", "self__2"]);
    }
}
