//! Finds the rules of a grammar in the text of a Rust file.

use std::collections::BTreeMap;
use std::ops::Range;
use std::thread;

use cga_lang::compile::Dialect;
use cga_lang::diag::code::Code;
use cga_lang::diag::{Diag, Level};
use cga_lang::syntax::token::Tokens;
use proc_macro2::{Span, TokenStream, TokenTree};

use super::header::{Header, RulesText, read};
use super::literal::read_text;
use super::problem::Problem;
use super::tokens::{Host, InlineTokens, read_inline};

/// The deepest nesting of brackets in rules.
const MOST_NESTED: usize = 256;

/// The stack of the thread that reads: nested brackets take some of it.
const STACK: usize = 16 << 20;

/// The rules of a grammar in a Rust file: inline, or in string literals.
#[derive(Clone, Debug)]
pub struct RustRules {
    /// The tokens.
    pub tokens: Tokens,
    /// For each token, its bytes in the file.
    pub ranges: Vec<Range<usize>>,
    /// The diagnostics of reading the tokens.
    pub found: Vec<Diag>,
    /// The dialect: inline rules are strict.
    pub dialect: Dialect,
    /// The Rust values in the rules by handle, as [`shown`] writes them.
    pub hosts: Vec<String>,
    /// The levels of diagnostics before the header.
    pub levels: Vec<(Code, Level)>,
}

/// Finds the rules of a grammar, `cga! { grammar Name; … }`, in the text of a Rust file.
///
/// # Errors
/// A sentence: the text is not Rust, or it does not have exactly one grammar of that name with its rules.
pub fn find_rules(text: &str, grammar: &str) -> Result<RustRules, String> {
    // A thread of its own: places of tokens are kept in memory as long as the thread lives.
    let read = || find(text, grammar);
    thread::scope(|scope| {
        let thread = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, read);
        let thread = thread.map_err(|why| format!("a thread cannot be started: {why}"))?;
        thread.join().unwrap_or_else(|_| Err("it cannot be read".to_owned()))
    })
}

/// Rust tokens as text, with one space between two tokens. Equal tokens have equal texts, whatever made them.
pub fn shown(stream: &TokenStream) -> String {
    let mut parts = Vec::new();
    for token in stream.clone() {
        match token {
            TokenTree::Group(group) => {
                let inner = shown(&group.stream());
                parts.push(match group.delimiter() {
                    proc_macro2::Delimiter::Parenthesis => format!("({inner})"),
                    proc_macro2::Delimiter::Brace => format!("{{{inner}}}"),
                    proc_macro2::Delimiter::Bracket => format!("[{inner}]"),
                    proc_macro2::Delimiter::None => inner,
                });
            }
            other => parts.push(other.to_string()),
        }
    }
    parts.join(" ")
}

fn find(text: &str, grammar: &str) -> Result<RustRules, String> {
    // The places of tokens count from the text after the mark of its encoding.
    let mark = text.len() - text.trim_start_matches('\u{feff}').len();
    let stream: TokenStream = text[mark..].parse().map_err(|why: proc_macro2::LexError| {
        let start = why.span().start();
        format!("the Rust code cannot be read at line {}, column {}", start.line, start.column + 1)
    })?;
    let mut found = calls(stream).into_iter().filter_map(|call| {
        let (header, body) = read(call);
        (header.name.is_some() && header.label() == grammar).then_some((header, body))
    });
    let Some((header, body)) = found.next() else {
        return Err(format!(
            "it has no `cga! {{ grammar {grammar}; … }}`; after a move of the rules, build the program again"
        ));
    };
    if found.next().is_some() {
        return Err(format!(
            "it has several grammars of the name `{grammar}`; give each its own name, and build the program again"
        ));
    }
    rules(text, mark, &header, body)
}

/// The tokens between the brackets of macro calls, wherever they are.
fn calls(stream: TokenStream) -> Vec<TokenStream> {
    let mut calls = Vec::new();
    let mut groups = vec![stream];
    while let Some(stream) = groups.pop() {
        // The number of tokens of a call that were read: a name and `!`.
        let mut read = 0;
        for token in stream {
            read = match token {
                TokenTree::Group(group) => {
                    if read == 2 {
                        calls.push(group.stream());
                    }
                    groups.push(group.stream());
                    0
                }
                TokenTree::Ident(_) => 1,
                TokenTree::Punct(sign) if read == 1 && sign.as_char() == '!' => 2,
                TokenTree::Punct(_) | TokenTree::Literal(_) => 0,
            };
        }
    }
    calls
}

fn rules(text: &str, mark: usize, header: &Header, body: Result<RulesText, Problem>) -> Result<RustRules, String> {
    let place = |span: Span| span.byte_range().start + mark..span.byte_range().end + mark;
    let at = |problem: &Problem| {
        let start = problem.first.start();
        format!("line {}, column {}: {}", start.line, start.column + 1, problem.message)
    };
    let levels = header.levels.clone();
    match body.map_err(|problem| at(&problem))? {
        RulesText::Inline(stream) => {
            if !is_flat(stream.clone()) {
                return Err(format!("the rules have more than {MOST_NESTED} brackets in one another"));
            }
            let InlineTokens { tokens, found, spans, hosts, .. } = read_inline(stream);
            let ranges =
                spans.iter().map(|(first, last)| place(*first).start..place(*last).end.max(place(*first).start));
            let hosts = hosts.iter().map(|Host { expr, .. }| shown(expr)).collect();
            Ok(RustRules { tokens, ranges: ranges.collect(), found, dialect: Dialect::Inline, hosts, levels })
        }
        RulesText::Text(literals) => {
            let rules = read_text(&literals).map_err(|problem| at(&problem))?;
            let ranges = in_file(text, &rules.quoted.written, &rules.quoted.ranges);
            let (tokens, found) = (rules.tokens, rules.found);
            Ok(RustRules { tokens, ranges, found, dialect: Dialect::Text, hosts: Vec::new(), levels })
        }
        RulesText::File(_) => Err("the rules are in a file now; build the program again".to_owned()),
    }
}

/// Returns true if brackets are not nested too deeply.
fn is_flat(stream: TokenStream) -> bool {
    let mut groups = vec![(stream, 0)];
    while let Some((stream, depth)) = groups.pop() {
        if MOST_NESTED < depth {
            return false;
        }
        let inner = stream.into_iter().filter_map(|token| match token {
            TokenTree::Group(group) => Some((group.stream(), depth + 1)),
            _ => None,
        });
        groups.extend(inner);
    }
    true
}

/// Ranges in a file, from ranges in a text with the same lines and columns, in characters.
fn in_file(file: &str, written: &str, ranges: &[Range<usize>]) -> Vec<Range<usize>> {
    let lines = |text: &str| -> BTreeMap<usize, usize> {
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1));
        starts.enumerate().collect()
    };
    let starts = lines(file);
    let own = lines(written);
    let own: Vec<usize> = own.into_values().collect();
    let moved = |byte: usize| {
        let line = own.partition_point(|start| *start <= byte).saturating_sub(1);
        let column = written.get(own[line]..byte).map_or(0, |before| before.chars().count());
        let start = starts.get(&line).copied().unwrap_or(file.len());
        let rest = file[start..].trim_start_matches('\u{feff}');
        let start = file.len() - rest.len();
        rest.char_indices().nth(column).map_or(file.len(), |(at, _)| start + at)
    };
    ranges.iter().map(|range| moved(range.start)..moved(range.end)).collect()
}

#[cfg(test)]
mod tests {
    use cga_lang::syntax::lex::lex;

    use super::*;

    const FILE: &str = "//! Bäume\nuse cga::cga;\r\nmod inner {\n    cga::cga! {\n        /// Ein Haus.\n        @Deny(undefined_rule)\n        \
                        pub(crate) grammar House;\n        Lot --> s(^0.5, #(a + b), #c) \"ä\".\n    }\n}\n\
                        cga! { grammar Text = concat!(\"Lot --> \", r#\"s('0.5)\nX.\"#); }\n";

    /// The spelling of each token in the file.
    fn spellings<'t>(text: &'t str, rules: &RustRules) -> Vec<&'t str> {
        rules.ranges.iter().map(|range| &text[range.clone()]).collect()
    }

    #[test]
    fn inline_rules_are_found_with_the_places_of_their_tokens() {
        for text in [FILE.to_owned(), format!("\u{feff}{FILE}")] {
            let rules = find_rules(&text, "House").expect("rules");
            assert_eq!(
                (rules.dialect, rules.hosts.clone()),
                (Dialect::Inline, vec!["(a + b)".to_owned(), "c".to_owned()])
            );
            assert_eq!(rules.levels, [(Code::UndefinedRule, Level::Error)]);
            let spelled = ["Lot", "-->", "s", "(", "^", "0.5", ",", "#(a + b)", ",", "#c", ")", "\"ä\"", "."];
            assert_eq!(spellings(&text, &rules), spelled);
        }
    }

    #[test]
    fn rules_in_strings_are_found_with_the_places_of_their_tokens() {
        for text in [FILE.to_owned(), format!("\u{feff}{FILE}"), FILE.replace('\n', "\r\n").replace("\r\r", "\r")] {
            let rules = find_rules(&text, "Text").expect("rules");
            assert_eq!(rules.tokens, lex("Lot --> s('0.5) X.").tokens);
            assert_eq!(spellings(&text, &rules), ["Lot", "-->", "s", "(", "'", "0.5", ")", "X", "."]);
        }
    }

    #[test]
    fn other_files_have_a_reason() {
        let deep = format!("cga! {{ grammar House; Lot --> {}1{} }}", "(".repeat(300), ")".repeat(300));
        let deepest = "(".repeat(200_000) + &")".repeat(200_000);
        for (text, why) in [
            ("", "it has no `cga! { grammar House; … }`"),
            (&deepest, "it has no `cga! { grammar House; … }`"),
            (
                "cga! { grammar House; A --> B. } cga! { grammar House; A --> B. }",
                "it has several grammars of the name `House`",
            ),
            ("fn main() {\n  cga! { grammar House; ", "the Rust code cannot be read at line 2, column "),
            ("cga! { grammar House in \"a.cga\"; }", "the rules are in a file now"),
            ("cga! {\n grammar House = 3; }", "line 2, column 18: the rules must be a string literal"),
            (&deep, "the rules have more than 256 brackets in one another"),
        ] {
            let found = find_rules(text, "House").map(drop).expect_err("a reason");
            assert!(found.contains(why), "{found}");
        }
    }

    /// Files are read while they are being written, so every part of one is read somehow.
    #[test]
    fn the_parts_of_a_file_are_read_without_a_panic() {
        for (at, _) in FILE.char_indices() {
            for part in [&FILE[..at], &FILE[at..]] {
                for name in ["House", "Text"] {
                    assert_ne!(find_rules(part, name).err().as_deref(), Some("it cannot be read"), "{part}");
                }
            }
        }
    }
}
