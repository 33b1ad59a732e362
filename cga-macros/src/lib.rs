//! The `cga!` macro: CGA shape-grammar rules inside Rust. Use it through the crate `cga`, whose documentation tells the
//! whole story.
//!
//! This crate is a thin shell: `source` turns what the user wrote into tokens, `cga-lang` reads and checks them, `report`
//! shows the diagnostics and `codegen` writes Rust.
#![forbid(unsafe_code)]

/// Tokens of generated code at the current location, as with `quote!`. Local names are hygienic, and other names mean what they mean
/// at the macro call.
macro_rules! code {
    ($($tokens:tt)*) => {
        quote::quote_spanned!(crate::location::current()=> $($tokens)*)
    };
}

mod codegen;

mod editor;
mod input;
mod location;
mod output;
mod report;
mod source;
mod stub;

use proc_macro2::TokenStream;

use input::Input;

/// Checks CGA rules and turns them into Rust.
///
/// # Three ways to give the rules
///
/// - inline: `cga! { pub grammar Tower; Lot --> extrude(24) … }`;
/// - as text: `cga! { pub grammar Tower = r#"Lot --> s('1, 24, '1) …"#; }`, or several literals in `concat!(…)`;
/// - in a file: `cga! { pub grammar Tower in "rules/tower.cga"; }`. The path counts from the folder of the package's
///   `Cargo.toml`, and the build follows changes of the file.
///
/// Without the `grammar` header the macro is an expression: `let rules = cga! { Lot --> extrude(#height) … };`. Its `#`
/// values are evaluated once, from left to right, and kept, as a closure would. Its attributes are fields:
/// `rules.height = 40.0`.
///
/// # Differences between inline rules and rule files
///
/// - Relative sizes are written `^0.5` and `^(a + b)`. Rust reads `'0.5` as a broken lifetime and stops with an error of
///   its own beside ours; `'(a + b)` it reads as a character without its end, before the macro is asked. `'name` works.
/// - Comments begin with `//`.
/// - A call that matches no rule is an error, not a leaf: write `Name.` for a leaf.
/// - `#name` and `#(expression)` put a Rust value into a rule: a number, a `bool`, text, or an array of these (slices,
///   vectors, Rust arrays, `cga::Array`).
///
/// # All sources of rules
///
/// - Arrays are `cga::Array<T>` in fields and in Rust functions (`&Array<f64>`); a `#` value may be an array, a `Vec` or a
///   slice. The type of a `#` value, and of the result of a Rust function, follows from its use; without a use that
///   decides, it is a number.
/// - `import lib : "lib.cga"` looks beside the importing file, then in the folders above it, up to the package's. In rules
///   inline or in a string paths count from the package's folder. An attribute `height` of the import is the field
///   `lib_height`.
/// - `style Modern` begins a style: its rules start as `Modern$Lot`.
/// - `path::to::function(a, b)` calls a Rust function. It gets `f64`, `bool` and `&str`, of arrays `&cga::Array<f64>`,
///   `&cga::Array<bool>` and `&cga::Array<cga::Text>`. It gives a number, a `bool`, text, or an array of these as `#name`
///   would. In the place of an operation it gets `&mut Shape` before its arguments, and gives `()` or
///   `Result<(), Fault>`. Paths count from where the macro is called; there is at least one `::` in them.
/// - The rules say which type a Rust value has, `#name` or what a function gives. Where they leave it open, as in
///   `print(#name)`, it is a number, and in `[#name, 2]` one element; `float`, `bool`, `str`, `floatArray`, `boolArray` and
///   `stringArray` say it: `print(stringArray(#names))`.
/// - `@Allow(code)`, `@Warn(code)` and `@Deny(code)` before a rule or the header set the level of diagnostics. Warnings
///   are shown by way of rustc's lint `deprecated`.
/// - `#[cga(crate = path)]` before the header says where the crate `cga` is when it has another name. Other attributes
///   go to the struct, `#[cfg(…)]` to all that is made.
/// - Attributes become fields of the same name, raw where Rust keeps the word for itself (`r#type`); `self`, `Self`,
///   `super` and `crate` get a line at the end (`self_`).
#[proc_macro]
pub fn cga(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand(input.into()).into()
}

/// Checks CGA rules and turns them into Rust.
///
/// - inline: `cga! { pub grammar Tower; Lot --> extrude(24) … }`;
/// - as text: `cga! { pub grammar Tower = r#"Lot --> s('1, 24, '1) …"#; }`;
/// - in a file: `cga! { pub grammar Tower in "rules/tower.cga"; }`;
/// - without a name, as an expression: `let rules = cga! { Lot --> extrude(#height) … };`.
///
/// Inline, relative sizes are written `^0.5`, comments begin with `//`, and a leaf is written `Name.`. The documentation of the macro
/// `cga::cga` has the rest.
#[doc(hidden)]
#[proc_macro]
pub fn cga_for_editors(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    editor::expand(input.into()).into()
}

/// The words of the language as items, for rust-analyzer.
#[doc(hidden)]
#[proc_macro]
pub fn words_for_editors(_: proc_macro::TokenStream) -> proc_macro::TokenStream {
    editor::words().into()
}

fn expand(input: TokenStream) -> TokenStream {
    let Input { header, source, compiled } = match Input::read(input) {
        Ok(input) => input,
        Err(problem) => return problem,
    };
    let findings = report::findings(&compiled.diags, &source);
    let output = match &compiled.grammar {
        Some(grammar) if !findings.has_errors => codegen::grammar(grammar, &header, &source),
        _ => stub::grammar(stub::fields(&compiled, &source), &header, &source),
    };
    output::wrap(&header, &source, &findings.tokens, &output)
}

#[cfg(test)]
mod tests;
