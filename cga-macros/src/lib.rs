//! The `cga!` macro: CGA shape-grammar rules inside Rust. Use it through the crate `cga`, whose documentation tells the
//! whole story.
//!
//! This crate is a thin shell: `door` turns what the user wrote into tokens, `cga-lang` reads and checks them, `report`
//! shows the findings and `codegen` writes Rust.
#![forbid(unsafe_code)]

mod codegen;
mod door;
mod header;
mod report;
mod skeleton;

use cga_lang::compile::compile_with;
use proc_macro2::TokenStream;

/// Checks CGA rules and turns them into Rust.
///
/// Three ways to give the rules:
///
/// - inline: `cga! { pub grammar Tower; Lot --> extrude(24) … }`;
/// - as text: `cga! { pub grammar Tower = r#"Lot --> s('1, 24, '1) …"#; }`;
/// - in a file below the package: `cga! { pub grammar Tower in "rules/tower.cga"; }`.
///
/// Without the `grammar` header the macro is an expression: a value that has captured its `#` values.
#[proc_macro]
pub fn cga(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand(input.into()).into()
}

fn expand(input: TokenStream) -> TokenStream {
    let (header, body) = header::read(input);
    let source = match door::open(&header, body) {
        Ok(source) => source,
        Err(problem) => return problem.to_tokens(&header),
    };
    let compiled = compile_with(source.tokens(), source.strictness(), &header.levels);
    let findings: Vec<_> = source.findings().iter().chain(&compiled.diags).cloned().collect();
    let findings = report::findings(&findings, &source);
    let output = match &compiled.grammar {
        Some(grammar) if !findings.has_errors => codegen::grammar(grammar, &header, &source),
        _ => skeleton::grammar(&compiled, &header, &source),
    };
    header.wrap(&source, &findings.tokens, output)
}
