//! Fixtures: CGA text whose findings stand as comments under the lines they belong to.
//!
//! ```text
//! Lot --> split(x) { A }
//! //                 ^ error[missing_size]: this slot has no size
//! //                 help: write `~1 : A` …
//! ```
//!
//! Carets in the first two columns cannot stand under the slashes; then the column stands behind them: `//0^^^`.
//! A first line `// inline` asks for the strictness of rules among Rust. A line `// file: name.cga` begins a file that
//! others may import; what stands before the first one is what is compiled. `CGA_BLESS=1` rewrites what is expected.

pub(crate) mod parts;
pub(crate) mod random;

use cga_lang::compile::{Compiled, Dialect, compile};
use cga_lang::diag::{Diag, Level};
use cga_lang::link::{NoFiles, Unit};
use cga_lang::snippet::{Lines, bytes};
use cga_lang::span::Span;
use cga_lang::syntax::ast::Ast;
use cga_lang::syntax::lex::{Lexed, lex};
use std::fmt::Write;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Every fixture of a folder, in order.
pub(crate) fn fixtures(folder: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(folder);
    let mut list: Vec<PathBuf> = fs::read_dir(&root)
        .unwrap_or_else(|error| panic!("{}: {error}", root.display()))
        .map(|entry| entry.expect("readable folder").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "cga"))
        .collect();
    list.sort();
    assert!(!list.is_empty(), "no fixtures in {}", root.display());
    list
}

/// Compares what a test made of a folder's fixtures; `make` gives the fixture with its findings and, if wanted, what
/// stands beside it.
pub(crate) fn walk(folder: &str, make: impl Fn(&str) -> (Vec<Diag>, Lexed, Option<String>)) {
    let bless = std::env::var_os("CGA_BLESS").is_some();
    let mut wrong = String::new();
    for path in fixtures(folder) {
        let stored = fs::read_to_string(&path).expect("readable fixture");
        let text = strip(&stored);
        let (diags, lexed, beside) = make(&text);
        let range = |span: Span| bytes(&text, &lexed.ranges, span);
        compare(&path, &stored, &annotate(&text, &range, &diags), bless, &mut wrong);
        if let Some(beside) = beside {
            let path = path.with_extension("out");
            let stored = fs::read_to_string(&path).unwrap_or_default();
            compare(&path, &stored, &beside, bless, &mut wrong);
        }
    }
    assert!(wrong.is_empty(), "{wrong}\nCGA_BLESS=1 accepts this");
}

fn compare(path: &Path, stored: &str, actual: &str, bless: bool, wrong: &mut String) {
    if stored == actual {
        return;
    }
    if bless {
        fs::write(path, actual).expect("writable fixture");
        return;
    }
    let first = stored.lines().zip(actual.lines()).position(|(a, b)| a != b);
    let first = first.unwrap_or_else(|| stored.lines().count().min(actual.lines().count()));
    let line = |text: &str| text.lines().nth(first).unwrap_or("(nothing)").to_owned();
    let _ = writeln!(wrong, "{}:{}", path.display(), first + 1);
    let _ = writeln!(wrong, "  expected: {}\n  found:    {}", line(stored), line(actual));
}

/// A fixture without its expectations.
pub(crate) fn strip(text: &str) -> String {
    let is_expectation = |line: &str| {
        line.strip_prefix("//").is_some_and(|rest| {
            let rest = rest.trim_start_matches([' ', '\t', '0', '1']);
            rest.starts_with('^') || rest.starts_with("note: ") || rest.starts_with("help: ")
        })
    };
    text.split_inclusive('\n').filter(|line| !is_expectation(line)).collect()
}

/// A tree without its places. Trees hold no text that looks like one.
pub(crate) fn shape(ast: &Ast) -> String {
    let mut out = String::new();
    let text = format!("{:?}", (&ast.head, &ast.version, &ast.imports, &ast.styles, &ast.decls));
    let mut rest = text.as_str();
    while let Some(start) = rest.find("Span {") {
        out.push_str(&rest[..start]);
        rest = rest[start..].split_once('}').expect("a span ends").1;
    }
    out + rest
}

/// The strictness a fixture asks for.
pub(crate) fn dialect(text: &str) -> Dialect {
    if text.starts_with("// inline") { Dialect::Inline } else { Dialect::Text }
}

/// Compiles a fixture in its dialect.
pub(crate) fn compiled(text: &str) -> (Compiled, Lexed) {
    let lexed = lex(text);
    let unit = Unit { found: lexed.diags.clone(), ..Unit::new(lexed.tokens.clone(), dialect(text)) };
    let compiled = compile(unit, &mut NoFiles, &[]);
    (compiled, lexed)
}

/// The text with its findings. `range` says which bytes belong to a span.
fn annotate(text: &str, range: &dyn Fn(Span) -> Range<usize>, diags: &[Diag]) -> String {
    let lines = Lines::new(text);
    let mut list: Vec<(usize, usize, &Diag)> = diags
        .iter()
        .map(|diag| {
            let start = range(diag.span).start;
            (lines.position(start).line, start, diag)
        })
        .collect();
    list.sort_by_key(|(line, start, _)| (*line, *start));
    let mut out = String::new();
    let mut list = list.into_iter().peekable();
    for (index, line) in text.split_inclusive('\n').enumerate() {
        let number = index + 1;
        out.push_str(line);
        while let Some((_, start, diag)) = list.next_if(|(at, ..)| *at <= number) {
            if !out.ends_with('\n') {
                out.push('\n');
            }
            let marked = text[range(diag.span)].lines().next().unwrap_or_default().chars().count().max(1);
            let column = lines.position(start).column - 1;
            let level = if diag.level == Level::Error { "error" } else { "warning" };
            let margin = if column < 2 { format!("//{column}") } else { format!("//{}", " ".repeat(column - 2)) };
            let _ = writeln!(out, "{margin}{} {level}[{}]: {}", "^".repeat(marked), diag.code.name(), diag.message);
            let margin = format!("//{}", " ".repeat(column.max(3) - 2));
            for note in diag.reasons() {
                let place = note.related.map(|span| lines.position(range(span).start).line);
                let place = place.map(|line| format!(" in line {line}")).unwrap_or_default();
                let _ = writeln!(out, "{margin}note: {}{place}", note.text);
            }
            for help in &diag.help {
                let _ = writeln!(out, "{margin}help: {help}");
            }
        }
    }
    out
}
