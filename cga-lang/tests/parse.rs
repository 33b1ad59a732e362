//! `tests/data/parse`: tokens to tree, shown with a bracket around every operator.

mod common;

use cga_lang::diag::Diags;
use cga_lang::lex::lex;
use cga_lang::parse::parse;
use cga_lang::print::{Spelling, print};
use std::fs;

#[test]
fn tokens_become_these_trees() {
    common::walk("parse", |text| {
        let lexed = lex(text);
        let mut diags = Diags::new();
        let ast = parse(&lexed.tokens, &mut diags);
        (diags.finish(), lexed, Some(print(&ast, Spelling::Text)))
    });
}

#[test]
fn a_printed_tree_reads_as_the_same_tree_in_either_spelling() {
    for folder in ["parse", "check", "lower"] {
        for path in common::fixtures(folder) {
            let text = common::strip(&fs::read_to_string(&path).expect("readable fixture"));
            let mut diags = Diags::new();
            let first = print(&parse(&lex(&text).tokens, &mut diags), Spelling::Text);
            if !diags.finish().is_empty() {
                continue;
            }
            for spelling in [Spelling::Text, Spelling::Inline] {
                let mut diags = Diags::new();
                let ast = parse(&lex(&first).tokens, &mut diags);
                let again = print(&parse(&lex(&print(&ast, spelling)).tokens, &mut diags), Spelling::Text);
                assert_eq!(diags.finish(), [], "{}", path.display());
                assert_eq!(again, first, "{}", path.display());
            }
        }
    }
}
