//! Rules that were changed at random: whatever they are, there is no panic, every run ends, and the limits hold.
//!
//! `CGA_MUTATED=1000000` plays so many instead of the number that runs always play.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use cga::{Error, Grammar, Limits, Model, RuleFile, Settings, Shape};
use cga_lang::syntax::lex::lex;
use cga_tests::inline;
use cga_tests::tree::root;

#[path = "../../cga-lang/tests/front/common/random.rs"]
mod random;
use random::Random;

/// The number of texts that are played always.
const TEXTS: usize = 3000;

/// Numbers that rules rarely expect.
const NUMBERS: [&str; 12] = ["0", "1", "-1", "0.5", "3", "1e9", "1e300", "-0.001", "1e-9", "255", "10000000", "(0/0)"];

/// Words and signs that change much.
const WORDS: [&str; 24] = [
    "*",
    "~",
    "'",
    ":",
    "|",
    "{",
    "}",
    "[",
    "]",
    "case",
    "else",
    "NIL",
    "X.",
    "scope.sx",
    "split.index",
    "rand(3)",
    "all",
    "comp(f)",
    "split(x)",
    "extrude(2)",
    "set(material.opacity, 0.5)",
    "inline",
    "offset(1)",
    "@StartRule",
];

/// The texts that are changed: small grammars of tests and pages, as text.
fn corpus() -> Vec<String> {
    let mut list = Vec::new();
    for folder in ["tests/language", "tests/pages", "tests/shapes"] {
        let entries = fs::read_dir(root().join(folder)).expect("a folder");
        let mut paths: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
        paths.sort();
        for path in paths.iter().filter(|path| path.extension().is_some_and(|end| end == "rs")) {
            let source = fs::read_to_string(path).expect("a source");
            list.extend(inline::grammars(&source).into_iter().map(|grammar| grammar.rules));
            // Rules in raw strings.
            let strings = source.split("r##\"").skip(1).filter_map(|rest| rest.split("\"##").next());
            list.extend(strings.map(str::to_owned));
        }
    }
    list.retain(|text| text.len() < 1500 && RuleFile::from_text(text).is_ok());
    list
}

/// A text with a few changed tokens.
fn mutated(text: &str, random: &mut Random) -> String {
    let mut text = text.to_owned();
    for _ in 0..=random.below(3) {
        let ranges = lex(&text).ranges;
        if ranges.is_empty() {
            break;
        }
        let at = random.pick(&ranges).clone();
        let token = text[at.clone()].to_owned();
        // Mostly a token of the same kind, so that most texts are still rules.
        let kind = |token: &str| token.chars().next().map(|first| (first.is_ascii_digit(), first.is_alphabetic()));
        let alike: Vec<_> = ranges.iter().filter(|range| kind(&text[(*range).clone()]) == kind(&token)).collect();
        let other = text[(*random.pick(&alike)).clone()].to_owned();
        let new = match random.below(12) {
            0 => String::new(),
            1 => format!("{token} {token}"),
            2 => (*random.pick(&WORDS)).to_owned(),
            3..8 if token.starts_with(|first: char| first.is_ascii_digit()) => (*random.pick(&NUMBERS)).to_owned(),
            _ => other,
        };
        text.replace_range(at, &format!(" {new} "));
    }
    text
}

/// Loads and runs rules. Returns whether they could be loaded.
fn play(text: &str, random: &mut Random) -> bool {
    let limits = Limits { shapes: 200, depth: 50, vertices: 5000, calls: 20_000, waiting: 100, ..Limits::default() };
    let settings = Settings { limits, ..Settings::default() };
    let Ok(rules) = RuleFile::from_text(text) else { return false };
    let seed = random.next() >> 40;
    for shape in [Shape::rectangle(8.0, 5.0), Shape::cuboid(6.0, 4.0, 9.0)] {
        let mut model = Model::new();
        match rules.run(&shape.seed(seed), &settings, &mut model) {
            Ok(report) => assert!(report.shapes <= 200, "{report:?}"),
            Err(Error::Limit { .. } | Error::Cycle { .. } | Error::Attribute { .. } | Error::StartRule { .. }) => {}
            Err(error) => panic!("{error}"),
        }
    }
    true
}

#[test]
fn changed_rules_do_no_harm() {
    let count = std::env::var("CGA_MUTATED").map_or(TEXTS, |count| count.parse().expect("a number of texts"));
    let (corpus, mut loaded, mut slowest) = (corpus(), 0, (0.0, String::new()));
    assert!(100 < corpus.len(), "{} texts", corpus.len());
    for number in 0..count {
        let random = &mut Random(number as u64);
        let text = mutated(random.pick::<String>(&corpus), random);
        let begin = Instant::now();
        let played = catch_unwind(AssertUnwindSafe(|| play(&text, random)));
        loaded += usize::from(played.unwrap_or_else(|_| panic!("text {number} panics:\n{text}")));
        let seconds = begin.elapsed().as_secs_f64();
        if slowest.0 < seconds {
            slowest = (seconds, text);
        }
    }
    println!("{loaded} of {count} texts run; the slowest takes {:.2} s:\n{}", slowest.0, slowest.1);
    // Otherwise the test would only test the checks.
    assert!(count / 10 < loaded, "{loaded} of {count} texts run");
}
