//! The checks against runs: random rules are compiled as any others and run with random attributes on random shapes. A claim
//! of a diagnostic ("never", "always") must hold in every run.

#[allow(deprecated, reason = "findings are warnings of this kind")]
mod grammars;
mod judge;
mod places;
mod run;
mod tails;
mod write;

use crate::random::Random;
use cga::Grammar;
use cga_lang::compile::{Dialect, compile};
use cga_lang::diag::code::Code;
use cga_lang::diag::{Basis, Diags, Level};
use cga_lang::link::{NoFiles, Unit};
use cga_lang::snippet::{Lines, Quote, render};
use cga_lang::syntax::lex::lex;
use cga_lang::syntax::parse::parse;
use judge::{Verdict, judge};
use places::Places;
use run::{prepare, run};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::ops::Range;
use std::panic::catch_unwind;
use std::path::Path;

/// Makes a grammar.
type Make = fn() -> Box<dyn Grammar>;

/// The seeds of the grammars that are in the repository.
const SEEDS: Range<u64> = 100..118;

/// Runs of each grammar.
const RUNS: u64 = 40;

/// The least number of findings of each kind that runs must judge. Fewer would prove nothing.
const LEAST: [(Code, usize); 18] = [
    (Code::SizeNotPositive, 10),
    (Code::SlotNeverMade, 10),
    (Code::FloatWithoutSpace, 3),
    (Code::SlotAlwaysCut, 2),
    (Code::SharesBeyondWhole, 2),
    (Code::SizesBeyondExtent, 2),
    (Code::GapLeft, 3),
    (Code::FlatSplit, 2),
    (Code::RepeatNoProgress, 3),
    (Code::TooManyPieces, 5),
    (Code::RepeatOnce, 3),
    (Code::RepeatSliver, 2),
    (Code::CaseAlways, 20),
    (Code::RuleNotReached, 10),
    (Code::EndlessRules, 5),
    (Code::SelectorHidden, 10),
    (Code::NoEffect, 10),
    (Code::DivisionByZero, 5),
];

/// The seeds to play: `CGA_PLAY=1000..1200` for others.
fn seeds() -> Range<u64> {
    let Ok(text) = std::env::var("CGA_PLAY") else { return SEEDS };
    let seed = |text: &str| text.parse().expect("`CGA_PLAY` is two numbers with `..` between them");
    let (first, end) = text.split_once("..").unwrap_or((&text, ""));
    seed(first)..seed(end)
}

#[test]
fn the_grammars_are_those_of_their_seeds() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("played");
    let mut files = vec![(folder.join("grammars.rs"), list())];
    files.extend(seeds().map(|seed| (folder.join(format!("rules/{seed}.cga")), write::write(seed))));
    if std::env::var_os("CGA_BLESS").is_some() {
        for entry in fs::read_dir(folder.join("rules")).expect("the rules") {
            fs::remove_file(entry.expect("an entry").path()).expect("a file of rules");
        }
        files.iter().for_each(|(path, text)| fs::write(path, text).expect("a file of the repository"));
    }
    for (path, text) in files {
        let now = fs::read_to_string(&path).unwrap_or_default();
        assert!(now == text, "{} is not what is written today; CGA_BLESS=1 accepts this", path.display());
    }
}

/// The text of `grammars.rs`.
fn list() -> String {
    let mut text = String::from("//! The grammars that are played. `CGA_BLESS=1` writes this file.\n\n");
    text += "use crate::played::Make;\nuse cga::cga;\n\n/// Each with the seed it is written with.\n";
    text += "pub(crate) const ALL: &[(u64, Make)] = &[\n";
    seeds().for_each(|seed| text += &format!("    ({seed}, || Box::new(G{seed}::default())),\n"));
    text += "];\n\n";
    for seed in seeds() {
        let levels = "@Warn(repeat_no_progress, endless_rules)";
        text += &format!("cga! {{ {levels} pub grammar G{seed} in \"played/rules/{seed}.cga\"; }}\n");
    }
    text
}

#[test]
fn what_the_checks_call_never_or_always_is_so_in_every_run() {
    let mut counts = BTreeMap::new();
    let mut broken = String::new();
    for (seed, make) in grammars::ALL {
        play(*seed, *make, &mut counts, &mut broken);
    }
    println!("of each kind of findings, how many a run came to: {counts:#?}");
    assert!(broken.is_empty(), "{broken}");
    for (code, least) in LEAST.iter().filter(|_| seeds() == SEEDS) {
        let count = counts.get(code).copied().unwrap_or_default();
        assert!(*least <= count, "{}: {count} times is too few to say anything; {counts:?}", code.name());
    }
}

/// Counts what was put to the proof, and says what is not so.
fn play(seed: u64, make: Make, counts: &mut BTreeMap<Code, usize>, broken: &mut String) {
    let text = write::write(seed);
    // Rules with an error of these kinds can run, so the errors become warnings.
    let levels = [(Code::RepeatNoProgress, Level::Warning), (Code::EndlessRules, Level::Warning)];
    let lexed = lex(&text);
    let compiled = compile(Unit::new(lexed.tokens.clone(), Dialect::Text), &mut NoFiles, &levels);
    let mut diags = Diags::new();
    let places = Places::new(&parse(&lexed.tokens, &mut diags));
    assert!(diags.finish().is_empty(), "{text}");
    let random = |number| Random(seed << 32 | number);
    let usual = |number| number % 4 == 0;
    let mut runs = Vec::new();
    for number in 0..RUNS {
        match catch_unwind(|| run(&mut *make(), &mut random(number), usual(number))) {
            Ok(run) => runs.push(run),
            Err(_) => {
                let (given, _) = prepare(&mut *make(), &mut random(number), usual(number));
                let _ = writeln!(broken, "seed {seed}, {given}: the run panics\n");
            }
        }
    }
    for diag in &compiled.diags {
        let defaults = matches!(diag.basis, Basis::Defaults(_) | Basis::Lot(Some(_)));
        let lots = matches!(diag.basis, Basis::Lot(_));
        let mut verdicts: Vec<(String, Verdict)> = match diag.code {
            Code::NoEffect => (0..RUNS).map(|number| tails::judge(make, &mut random(number), usual(number))).collect(),
            _ => {
                let runs = runs.iter().filter(|run| (run.usual || !defaults) && (run.is_lot || !lots));
                runs.map(|run| (run.given.clone(), judge(diag, &places, run))).collect()
            }
        };
        let proved = verdicts.iter().any(|(_, verdict)| *verdict == Verdict::So);
        *counts.entry(diag.code).or_default() += usize::from(proved);
        verdicts.retain(|(_, verdict)| matches!(verdict, Verdict::Broken(_)));
        if let Some((given, Verdict::Broken(why))) = verdicts.first() {
            let (name, lines) = (&format!("{seed}.cga"), &Lines::new(&text));
            let finding = render(Quote { name, lines, ranges: &lexed.ranges }, diag);
            let _ = writeln!(broken, "{finding}\nnot so in {} runs, as in {given}: {why}\n", verdicts.len());
        }
    }
}

#[cfg(feature = "eval")]
#[test]
fn loaded_rules_give_the_same_as_compiled_rules() {
    let settings = cga::Settings { limits: run::limits(), ..cga::Settings::default() };
    for (seed, make) in grammars::ALL {
        let rules = crate::loaded::load(&format!("G{seed}"), &write::write(*seed));
        for number in 0..4 {
            let outcome = |grammar: &mut dyn Grammar| {
                let (given, shape) = prepare(grammar, &mut Random(100 * seed + number), number == 0);
                format!("{given}\n{}", crate::outcome::outcome(grammar, &shape, &settings))
            };
            let (compiled, loaded) = (outcome(&mut *make()), outcome(&mut rules.clone()));
            assert!(compiled == loaded, "seed {seed}:\n{compiled}\n{loaded}");
        }
    }
}
