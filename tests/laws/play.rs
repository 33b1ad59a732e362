//! Runs of grammars by all laws, and their differences.

use crate::laws::{Case, LAWS};
use crate::random::Random;
use crate::start;
use crate::write::prints_much;
use cga::{Grammar, Limits, Settings, Shape};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The runs of each grammar. Without optimisation each takes ten times as long.
pub(crate) const RUNS: u64 = if cfg!(debug_assertions) { 2 } else { 48 };

/// The counts of many runs.
#[derive(Default)]
pub(crate) struct Counts {
    pub(crate) grammars: usize,
    pub(crate) runs: usize,
    pub(crate) leaves: usize,
    /// Leaves from templates, in one of the runs of a law.
    pub(crate) replayed: usize,
    /// Runs with such leaves.
    pub(crate) with_templates: usize,
    pub(crate) prints: usize,
    pub(crate) faults: usize,
    /// Runs that a limit or the number of leaves ended.
    pub(crate) ended: usize,
    /// Grammars with a difference.
    pub(crate) broken: usize,
    /// The kinds of differences, each with the number of runs and the example that is nearest to the start.
    pub(crate) kinds: BTreeMap<String, (usize, Example)>,
}

/// A difference: how far from the start it was found, and a text about it.
type Example = (usize, String);

/// Plays grammars, each with its seed, and counts.
pub(crate) fn play<M: Fn() -> Box<dyn Grammar + Sync>>(grammars: &[(u64, M)]) -> Counts {
    let mut counts = Counts::default();
    for (seed, make) in grammars {
        let began = std::time::Instant::now();
        counts.grammars += 1;
        let mut broken = false;
        for number in 0..if prints_much(*seed) { RUNS.div_ceil(4) } else { RUNS } {
            for text in laws(*seed, make, number, &mut counts) {
                let (kind, far) = kind(&text);
                if tells() && (!broken || !counts.kinds.contains_key(&kind)) {
                    println!("seed {seed}: {text}");
                }
                let known = counts.kinds.entry(kind).or_insert((0, (usize::MAX, String::new())));
                known.0 += 1;
                if far < known.1.0 {
                    known.1 = (far, format!("seed {seed}: {text}"));
                }
                broken = true;
            }
        }
        counts.broken += usize::from(broken);
        if tells() {
            println!(
                "seed {seed}: {} ms, {} replayed{}",
                began.elapsed().as_millis(),
                counts.replayed,
                if broken { ", broken" } else { "" }
            );
        }
    }
    counts
}

/// Returns true if a line is printed after each grammar.
fn tells() -> bool {
    std::env::var_os("CGA_GRAMMARS").is_some()
}

/// The kind of a difference, and the first number in its text: how far from the start it is.
fn kind(text: &str) -> (String, usize) {
    let head = text.splitn(3, ": ").take(2).collect::<Vec<_>>().join(": ");
    let words: Vec<&str> = head.split(' ').collect();
    let number = words.iter().find_map(|word| word.trim_end_matches(',').parse().ok()).unwrap_or_default();
    // Rules have names in capitals, and places numbers: neither belongs to the kind.
    let general = |word: &&&str| !word.starts_with(|c: char| c.is_ascii_digit() || c.is_uppercase());
    (words.iter().filter(general).copied().collect::<Vec<_>>().join(" "), number)
}

/// Compares runs by all laws; tells what differs.
fn laws(seed: u64, make: &dyn Fn() -> Box<dyn Grammar + Sync>, number: u64, counts: &mut Counts) -> Vec<String> {
    let mut random = Random(seed << 32 | number);
    let mut grammar = make();
    let attributes = start::attributes(&mut *grammar, &mut random);
    let all = LAWS.iter().map(|law| law.shapes).max().unwrap_or(1);
    let (given, shapes): (Vec<String>, Vec<Shape>) = (0..all).map(|_| start::shape(&mut random)).unzip();
    // Grammars that print much take long.
    let shapes_made = if prints_much(seed) { 400 } else { 1000 };
    let limits = Limits { shapes: shapes_made, depth: 64, vertices: 20_000, ..Limits::default() };
    let settings = Settings { limits, assets: start::assets(), ..Settings::default() };
    let threads = random.below(12);
    let mut list = Vec::new();
    for law in LAWS {
        counts.runs += 1;
        let case =
            Case { grammar: &*grammar, settings: settings.clone(), shapes: &shapes[..law.shapes], number: threads };
        let place = || format!("run {number} on {} with {attributes}", given[..law.shapes].join(", "));
        let Ok((found, outcome)) = catch_unwind(AssertUnwindSafe(|| (law.holds)(&case))) else {
            list.push(format!("{}: panics: {}", law.name, place()));
            continue;
        };
        if let Some(left) = outcome {
            counts.leaves += left.model.len();
            counts.replayed += left.replayed;
            counts.with_templates += usize::from(0 < left.replayed);
            match &left.report {
                Ok(report) => {
                    counts.prints += report.prints().len();
                    counts.faults += report.faults().len();
                    counts.ended += usize::from(report.stopped);
                }
                Err(_) => counts.ended += 1,
            }
        }
        list.extend(found.map(|text| format!("{}: {text}\n    ({})", law.name, place())));
    }
    list
}

impl Counts {
    /// The differences, most frequent first.
    pub(crate) fn differences(&self) -> String {
        let mut list: Vec<_> = self.kinds.iter().collect();
        list.sort_by_key(|(_, (count, _))| std::cmp::Reverse(*count));
        let line =
            |(kind, (count, (_, text))): (&String, &(usize, Example))| format!("{count} runs, {kind}, as\n{text}\n\n");
        list.into_iter().map(line).collect()
    }

    /// A line of figures.
    pub(crate) fn summary(&self) -> String {
        let Counts { grammars, runs, leaves, replayed, with_templates, prints, faults, ended, broken, .. } = self;
        format!(
            "{grammars} grammars, {runs} comparisons of runs, {leaves} leaves, {replayed} replayed in {with_templates} runs, {prints} prints, {faults} faults, \
             {ended} runs cut short, {broken} grammars with differences"
        )
    }
}
