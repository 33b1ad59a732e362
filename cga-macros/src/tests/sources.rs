//! Equal rules are equal, whichever source they come from.

use std::fs;
use std::path::{Path, PathBuf};

use super::ir_print;
use super::print::{Spelling, print};
use cga_lang::compile::{Dialect, compile};
use cga_lang::diag::Diags;
use cga_lang::link::{Files, Unit, candidates};
use cga_lang::syntax::lex::lex;
use cga_lang::syntax::parse::parse;
use cga_lang::syntax::token::Tokens;
use cga_source::rust::read_inline;
use proc_macro2::TokenStream;

/// Every rule file of the language's tests and of the facade's.
fn corpus() -> Vec<PathBuf> {
    let root = root();
    let mut folders = vec![root.join("tests/rules"), root.join("cga-lang/tests/data")];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("readable folder") {
            let path = entry.expect("readable folder").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "cga") {
                files.push(path);
            }
        }
    }
    files.sort();
    files
}

pub(super) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The package of the tests: paths in its rules start in its folder.
fn package() -> PathBuf {
    root().join("tests")
}

/// Imported files, below the folder of the tests' package.
pub(super) struct Below;

impl Files for Below {
    fn open(&mut self, path: &str, from: &str) -> Result<Unit, String> {
        let found = candidates(path, from).into_iter().find(|name| package().join(name).is_file());
        let name = found.ok_or("there is no such file in the package")?;
        let text = fs::read_to_string(package().join(&name)).map_err(|error| error.to_string())?;
        let lexed = lex(&text);
        Ok(Unit { name, tokens: lexed.tokens, dialect: Dialect::Text, found: lexed.diags })
    }
}

/// Both readings of some tokens: the grammar, or else the findings.
fn meaning(tokens: &Tokens, path: &Path) -> String {
    let name = path.strip_prefix(package()).or(path.strip_prefix(root())).expect("below the root");
    let name = name.to_string_lossy().replace('\\', "/");
    let unit = Unit { name, tokens: tokens.clone(), dialect: Dialect::Text, found: Vec::new() };
    let compiled = compile(unit, &mut Below, &[]);
    match &compiled.grammar {
        Some(grammar) => ir_print::print(grammar),
        None => compiled.diags.iter().map(|diag| format!("{}: {}\n", diag.code.name(), diag.message)).collect(),
    }
}

#[test]
fn both_sources_mean_the_same_over_a_corpus() {
    let mut compared = 0;
    for path in corpus() {
        let text = fs::read_to_string(&path).expect("readable rules");
        let mut diags = Diags::new();
        let ast = parse(&lex(&text).tokens, &mut diags);
        if diags.finish().iter().any(|diag| diag.code.level() == cga_lang::diag::Level::Error) {
            // Text with a syntax error is not printed as it was written.
            continue;
        }
        let (verbatim, inline) = (print(&ast, Spelling::Text), print(&ast, Spelling::Inline));
        let stream: TokenStream =
            inline.parse().unwrap_or_else(|error| panic!("{}: {error}\n{inline}", path.display()));
        let source = read_inline(stream);
        assert_eq!(source.found, [], "{}", path.display());
        let (text, tokens) = (meaning(&lex(&verbatim).tokens, &path), meaning(&source.tokens, &path));
        assert!(text == tokens, "{}\n{inline}\n--- text\n{text}\n--- tokens\n{tokens}", path.display());
        compared += 1;
    }
    assert!(30 < compared, "{compared}");
}

#[test]
fn both_sources_read_the_same_tokens() {
    let text = "@Range(min = 1) attr a = -1.5e3 - 2 f(x) = x == 1 && !(x != 2) || x <= 3 && x >= 4 % 5
        A(a) --> case a>1:[s('1,~2,\"\\\"\")]X. else:split(x){'a:A(1)|{~1:NIL}*|2:crate::b::c(3)X.} 30% : A else : B
        Lot --> [ t(0,-1,0) ] comp(f){side:A=B|top=C.}";
    let inline = text.replace("'1", "^1");
    let source = read_inline(inline.parse().expect("Rust tokens"));
    assert_eq!(source.tokens, lex(text).tokens);
}

#[test]
fn dots_mean_the_same_wherever_they_stand() {
    for text in [
        "a .+ b .- c.*d./e.%f .&& g.||h .== i.!=j .< k.<=l.>m .>= n",
        ".-a .+b .!c .--d - .5 -.5 (.5) [.5,.25;.1] x=.5 .5e3",
        "1.==1 0..3 [0..10] [0..n] 1. ==1 1.+2 1. + 2 1.*2 1.%2 1.&&2 1.||2 1.!=2 1.<2 1.>=2 1..==1 1..+2 1.0.+2 1.5.==2",
        "X.5 X. 5 X .5 X. Y X.Y a.b.c 1.a 2.a.b",
        "x:=1 y := -2 front=:X front =: X a=-1 [0:2] [4:-1:2] [1:0.5:3] a[i] a[1,2] a==[1]",
        "a$b a$1 a$ b a$$c$2d a$1. a$b. a$b$2. B",
        "lib.start lib(h=3,Roof-->X).Lot(1) start(20)",
    ] {
        let source = read_inline(text.parse().expect("Rust tokens"));
        assert_eq!(source.tokens, lex(text).tokens, "{text}");
    }
}

#[test]
fn symbols_stay_whole_in_tokens_that_a_macro_took_apart() {
    // `macro_rules!` hands `-->` on as `-` and `->`.
    let stream: TokenStream = "A - -> B. C --> D.".parse().expect("Rust tokens");
    let source = read_inline(stream);
    assert_eq!(source.tokens, lex("A --> B. C --> D.").tokens);
}
