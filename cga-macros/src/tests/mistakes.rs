//! `mistakes.txt`: mistakes that users of CityEngine and beginners in Rust make. The first diagnostic of each underlines
//! the guilty token, and its lines name the fix.
//!
//! ```text
//! == an axis in upper case
//! both:
//! Lot --> split(«X») { ~1 : A. }
//! says: `x`
//! ```
//!
//! `«…»` marks the guilty token. `inline:` and `text:` separate two spellings, `says inline:` and `says text:` two fixes;
//! `;` separates the words that must occur. `--nocapture` prints every first diagnostic.

use std::fmt::Write;
use std::ops::Range;

use cga_lang::compile::{Dialect, compile};
use cga_lang::diag::Diag;
use cga_lang::link::{Files, Unit};
use cga_lang::snippet::bytes;
use cga_lang::syntax::lex::lex;
use cga_source::rust::read_inline;
use proc_macro2::{Span, TokenStream};

use crate::source::Source;

/// The number of mistakes that must have a good diagnostic.
const LEAST: usize = 40;

/// One mistake as one source spells it.
#[derive(Default)]
struct Spelling {
    /// The rules, without the marks.
    rules: String,
    /// The bytes of the guilty token.
    guilty: Range<usize>,
    /// The words that the diagnostic must contain.
    words: Vec<String>,
}

struct Mistake {
    title: String,
    inline: Spelling,
    text: Spelling,
}

/// A library that exists, for the imports.
struct Library;

impl Files for Library {
    fn open(&mut self, path: &str, _: &str) -> Result<Unit, String> {
        let lexed = lex("Roof --> X.\n");
        let unit = Unit { name: path.into(), tokens: lexed.tokens, dialect: Dialect::Text, found: lexed.diags };
        if path == "lib.cga" { Ok(unit) } else { Err("there is no such file".into()) }
    }
}

fn mistakes() -> Vec<Mistake> {
    let text = include_str!("mistakes.txt").strip_prefix("== ").expect("a title");
    text.split("\n== ").map(mistake).collect()
}

fn mistake(block: &str) -> Mistake {
    let (title, rest) = block.split_once('\n').expect("a title");
    let (mut inline, mut text) = (Spelling::default(), Spelling::default());
    let (mut to_inline, mut to_text) = (false, false);
    for line in rest.lines() {
        let words = |list: &str| list.split("; ").map(|word| word.trim().to_owned()).collect::<Vec<_>>();
        match line.split_once(':') {
            Some(("both", "")) => (to_inline, to_text) = (true, true),
            Some(("inline", "")) => (to_inline, to_text) = (true, false),
            Some(("text", "")) => (to_inline, to_text) = (false, true),
            Some(("says", list)) => (inline.words, text.words) = (words(list), words(list)),
            Some(("says inline", list)) => inline.words = words(list),
            Some(("says text", list)) => text.words = words(list),
            _ => {
                let spellings = [(to_inline, &mut inline), (to_text, &mut text)];
                for (_, spelling) in spellings.into_iter().filter(|(wanted, _)| *wanted) {
                    spelling.rules += line;
                    spelling.rules.push('\n');
                }
            }
        }
    }
    for spelling in [&mut inline, &mut text] {
        let (before, marked) = spelling.rules.split_once('«').unwrap_or_else(|| panic!("{title}: no mark"));
        let (guilty, after) = marked.split_once('»').unwrap_or_else(|| panic!("{title}: no end of the mark"));
        spelling.guilty = before.len()..before.len() + guilty.len();
        spelling.rules = format!("{before}{guilty}{after}");
        assert!(!spelling.words.is_empty(), "{title}: no words");
    }
    Mistake { title: title.into(), inline, text }
}

/// The first diagnostic of inline rules, with the bytes that it underlines.
fn first_inline(rules: &str) -> Option<(Diag, Range<usize>)> {
    let stream: TokenStream = rules.parse().expect("Rust tokens");
    let source = Source::inline(read_inline(stream), Span::call_site());
    let diag = compile(source.unit(), &mut Library, &[]).diags.into_iter().next()?;
    let (first, last) = source.span(diag.span);
    // Spans count characters of the text of their own parse, which are bytes here.
    Some((diag, first.byte_range().start..last.byte_range().end))
}

/// The same of rules in a text.
fn first_in_text(rules: &str) -> Option<(Diag, Range<usize>)> {
    let lexed = lex(rules);
    let unit = Unit { name: String::new(), tokens: lexed.tokens, dialect: Dialect::Text, found: lexed.diags };
    let diag = compile(unit, &mut Library, &[]).diags.into_iter().next()?;
    let range = bytes(rules, &lexed.ranges, diag.span);
    Some((diag, range))
}

/// Returns true if a diagnostic is good; otherwise writes the reason to `out`.
fn is_good(spelling: &Spelling, first: Option<(Diag, Range<usize>)>, is_inline: bool, out: &mut String) -> bool {
    let Some((diag, range)) = first else {
        let _ = writeln!(out, "  nothing is reported");
        return false;
    };
    let sign = if is_inline { '^' } else { '\'' };
    let lines = std::iter::once(diag.message.clone()).chain(diag.reasons().map(|note| note.text));
    let lines: Vec<String> = lines.chain(diag.help.clone()).map(|line| line.spelled(sign)).collect();
    let shown = lines.join("\n    ");
    let _ = writeln!(out, "  `{}`: {shown}", &spelling.rules[range.clone()]);
    let missing: Vec<&String> = spelling.words.iter().filter(|word| !shown.contains(word.as_str())).collect();
    let is_marked = range == spelling.guilty;
    if !is_marked {
        let _ = writeln!(out, "  BAD: should underline `{}`", &spelling.rules[spelling.guilty.clone()]);
    }
    if !missing.is_empty() {
        let _ = writeln!(out, "  BAD: does not name {missing:?}");
    }
    is_marked && missing.is_empty()
}

#[test]
fn mistakes_are_underlined_and_name_their_fix() {
    let (list, mut good, mut out) = (mistakes(), 0, String::new());
    for Mistake { title, inline, text } in &list {
        let _ = writeln!(out, "{title}");
        let inline = is_good(inline, first_inline(&inline.rules), true, &mut out);
        let text = is_good(text, first_in_text(&text.rules), false, &mut out);
        good += usize::from(inline && text);
    }
    println!("{out}{good} of {} are good", list.len());
    assert_eq!(list.len(), 40);
    assert!(LEAST <= good, "only {good} of {}:\n{out}", list.len());
}
