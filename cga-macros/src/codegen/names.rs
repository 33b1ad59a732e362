//! Names of the generated functions and fields: as in the rules where that is possible, unique in any case.

use std::collections::{BTreeSet, HashMap, HashSet};

use cga_lang::ir::{FunctionId, Grammar, Param, RuleId};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};

/// One name for each rule and function.
pub(super) struct ItemNames {
    rules: Vec<String>,
    functions: Vec<String>,
}

impl ItemNames {
    pub(super) fn new(grammar: &Grammar) -> Self {
        let mut taken = Taken::default();
        // Written rules first: they keep their names, and overloads and blocks give way.
        let rules = grammar.rules.iter().map(|rule| taken.numbered(&rule.name)).collect();
        let functions = grammar.functions.iter().map(|function| taken.numbered(&function.name)).collect();
        ItemNames { rules, functions }
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

/// The names of parameters and locals of rules and functions, which debuggers show.
#[derive(Default)]
pub(super) struct ParamNames {
    /// The words of the user's Rust expressions in the rules.
    words: HashSet<String>,
    /// The names that were given.
    given: BTreeSet<String>,
    /// The names of the rule or function that is written, by number.
    current: Vec<String>,
}

impl ParamNames {
    pub(super) fn new<'a>(expressions: impl Iterator<Item = &'a TokenStream>) -> Self {
        let mut names = ParamNames::default();
        expressions.for_each(|expression| add_words(expression, &mut names.words));
        names
    }

    /// Begins a rule or function. Its names are locals among the locals of the generated code, so a name that is taken gets a
    /// `_` at the end.
    pub(super) fn begin(&mut self, params: &[Param]) {
        let mut taken = Taken::default();
        if !params.is_empty() {
            taken.all.extend(LOCALS.iter().map(|name| (*name).to_owned()));
        }
        let is_free = |name: &str| !is_numbered(name) && !self.words.contains(name);
        let free = |name: &str| if is_free(name) { name.to_owned() } else { format!("{name}_") };
        self.current = params.iter().map(|param| taken.field(&free(&param.name))).collect();
        self.given.extend(self.current.iter().cloned());
    }

    /// A parameter or local of the rule or function that is written.
    pub(super) fn param(&self, number: usize, place: Span) -> Ident {
        ident(&self.current[number], place)
    }

    /// An import for each name. Rust takes a name in a pattern for the constant, the static or the unit struct that has it;
    /// functions it lets a pattern hide, and a function in the generated block hides what the user has outside.
    pub(super) fn imports(&self) -> TokenStream {
        if self.given.is_empty() {
            return TokenStream::new();
        }
        let names = self.given.iter().map(|name| ident(name, Span::mixed_site()));
        code!(#[allow(unused_imports)] use {#(cga_rt::hidden as #names),*};)
    }
}

fn add_words(code: &TokenStream, words: &mut HashSet<String>) {
    for token in code.clone() {
        match token {
            TokenTree::Group(group) => add_words(&group.stream(), words),
            TokenTree::Ident(word) => _ = words.insert(word.to_string().trim_start_matches("r#").to_owned()),
            _ => {}
        }
    }
}

/// Names that are taken already.
#[derive(Default)]
pub(crate) struct Taken {
    all: HashSet<String>,
    /// By name, the last number that was tried: none before it is free.
    numbers: HashMap<String, u32>,
    /// The same for fields: the last candidate.
    last: HashMap<String, String>,
}

impl Taken {
    /// For rules and functions: `Facade/2` is `Facade_2`, and `Facade_2_2` if there is one already.
    fn numbered(&mut self, name: &str) -> String {
        let plain = escaped(name.chars().map(|c| if c.is_alphanumeric() || c == '_' { c } else { '_' }).collect());
        let number = self.numbers.entry(plain.clone()).or_insert(0);
        loop {
            *number += 1;
            let candidate = if *number == 1 { plain.clone() } else { format!("{plain}_{number}") };
            if self.all.insert(candidate.clone()) {
                return candidate;
            }
        }
    }

    /// For fields: `imp.height` is `imp_height`, and `imp_height_` if there is one already.
    pub(super) fn field(&mut self, name: &str) -> String {
        let plain = escaped(name.replace(['.', '$'], "_"));
        let last = self.last.entry(plain.clone()).or_insert(plain);
        while !self.all.insert(last.clone()) {
            last.push('_');
        }
        last.clone()
    }
}

/// `self_` for the words that cannot be raw: what [`ident`] makes of them.
fn escaped(name: String) -> String {
    if NEVER.contains(&name.as_str()) { name + "_" } else { name }
}

/// A name as Rust takes it, as little changed as possible: `r#type`, and `self_` for the words that cannot be raw.
pub(super) fn ident(name: &str, place: Span) -> Ident {
    if NEVER.contains(&name) {
        Ident::new(&escaped(name.into()), place)
    } else if RESERVED.contains(&name) {
        Ident::new_raw(name, place)
    } else {
        Ident::new(name, place)
    }
}

/// Returns true if a name is a plain identifier in every edition of Rust.
pub(crate) fn is_plain(name: &str) -> bool {
    !NEVER.contains(&name) && !RESERVED.contains(&name) && syn::parse_str::<Ident>(name).is_ok()
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

/// The locals of generated code, and the constants beside them.
const LOCALS: &[&str] = &[
    "PATTERN",
    "SIZES",
    "SPLIT",
    "again",
    "arm",
    "arms",
    "at_most",
    "axis",
    "base",
    "bases",
    "begun",
    "candidate",
    "changed",
    "childless",
    "cx",
    "division",
    "env",
    "extent",
    "file",
    "flow",
    "g",
    "has_parts",
    "lengths",
    "made",
    "operand",
    "operands",
    "own",
    "part",
    "pieces",
    "renewed",
    "rest",
    "row",
    "sections",
    "shape",
    "site",
    "sizes",
    "slim",
    "slot",
    "so_far",
    "value",
    "whole",
];

/// Locals of generated code with a number at the end: `a0`.
const NUMBERED: &[&str] = &["a", "given_", "last"];

/// Returns true for `a0`.
fn is_numbered(name: &str) -> bool {
    let start = name.trim_end_matches(|c: char| c.is_ascii_digit());
    start != name && NUMBERED.contains(&start)
}

/// Returns true for a local of generated code.
#[cfg(test)]
pub(crate) fn is_local(name: &str) -> bool {
    LOCALS.contains(&name) || is_numbered(name)
}

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
        let mut taken = Taken::default();
        let names = ["A", "A", "A_2", "A/1", "A_1", "self", "self_", "A"].map(|name| taken.numbered(name));
        assert_eq!(names, ["A", "A_2", "A_2_2", "A_1", "A_1_2", "self_", "self__2", "A_3"]);
    }

    #[test]
    fn parameters_keep_names_that_are_free() {
        let params_of = |names: &[&str]| {
            let param = |name: &&str| Param { name: (*name).into(), ty: cga_lang::ir::Type::Float };
            let mut given = ParamNames::new([quote::quote!(OFFSET + r#gen(1))].iter());
            given.begin(&names.iter().map(param).collect::<Vec<_>>());
            given.current
        };
        assert_eq!(params_of(&["width", "a", "last", "i2", "match"]), ["width", "a", "last", "i2", "match"]);
        assert_eq!(params_of(&["cx", "cx_", "self", "W", "a0"]), ["cx_", "cx__", "self_", "W", "a0_"]);
        assert_eq!(params_of(&["OFFSET", "gen", "r"]), ["OFFSET_", "gen_", "r"]);
        assert_eq!(params_of(&["x", "x", "x_", "shape$1"]), ["x", "x_", "x__", "shape_1"]);
    }

    #[test]
    fn fields_are_told_apart() {
        let mut taken = Taken::default();
        let names = ["self_", "self", "a.b", "a_b_", "a_b", "a$b", "type"].map(|name| taken.field(name));
        assert_eq!(names, ["self_", "self__", "a_b", "a_b_", "a_b__", "a_b___", "type"]);
    }

    #[test]
    fn a_name_that_thousands_have_is_numbered_at_once() {
        let mut taken = Taken::default();
        let last = (0..100_000).map(|_| taken.numbered("A")).last();
        assert_eq!(last.as_deref(), Some("A_100000"));
    }
}
