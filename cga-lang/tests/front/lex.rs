//! `tests/data/lex`: text to tokens.

use cga_lang::syntax::lex::lex;
use std::fmt::Write;

#[test]
fn text_becomes_these_tokens() {
    crate::common::walk("lex", |text| {
        let lexed = lex(text);
        let mut out = String::new();
        for (token, range) in lexed.tokens.as_slice().iter().zip(&lexed.ranges) {
            let _ = writeln!(out, "{}..{} {token:?}", range.start, range.end);
        }
        (lexed.diags.clone(), lexed, Some(out))
    });
}

#[test]
fn every_byte_outside_tokens_is_white_space_or_comment() {
    let text = "\u{feff}A --> X. # c\r\n/* x */ B // y\n";
    let mut rest = text.to_owned();
    for range in lex(text).ranges.iter().rev() {
        rest.replace_range(range.clone(), "");
    }
    assert_eq!(rest, "\u{feff}   # c\r\n/* x */  // y\n");
}

#[test]
fn both_relative_signs_are_one_token() {
    assert_eq!(lex("s('1, '(a), 0)").tokens, lex("s(^1, ^(a), 0)").tokens);
}
