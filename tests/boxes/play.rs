//! Runs of grammars in pairs, and what comes of them.

use crate::compare::{Outcome, Tolerance, difference};
use crate::pairs::PAIRS;
use crate::random::Random;
use crate::start;
use cga::glam::DAffine3;
use cga::{Cuboid, Flow, Grammar, Leaf, Limits, Mesh, Model, Quad, Settings, Shape, Sink};
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

/// Makes a grammar.
pub(crate) type Make = fn() -> Box<dyn Grammar>;

/// The runs of each grammar. Without optimisation each takes ten times as long.
pub(crate) const RUNS: u64 = if cfg!(debug_assertions) { 8 } else { 50 };

/// Leaves after which a run is stopped.
const MOST_LEAVES: usize = 200;

/// The counts of many runs.
#[derive(Default)]
pub(crate) struct Counts {
    pub(crate) grammars: usize,
    pub(crate) runs: usize,
    pub(crate) leaves: usize,
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

/// A model that takes some leaves only.
struct Few(Model);

impl Few {
    fn go_on(&self) -> Flow {
        if self.0.len() < MOST_LEAVES { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }
}

impl Sink for Few {
    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.0.quad(leaf, quad)?;
        self.go_on()
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.0.cuboid(leaf, cuboid)?;
        self.go_on()
    }

    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.0.instance(leaf, mesh, placement)?;
        self.go_on()
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.0.mesh(leaf, mesh, placement)?;
        self.go_on()
    }
}

/// Plays grammars, each with its seed, and counts.
pub(crate) fn play(grammars: &[(u64, Make)]) -> Counts {
    let mut counts = Counts::default();
    for (seed, make) in grammars {
        let began = std::time::Instant::now();
        counts.grammars += 1;
        let mut broken = false;
        for number in 0..RUNS {
            let Some(text) = pairs(*seed, *make, number, &mut counts) else { continue };
            let (kind, far) = kind(&text);
            let known = counts.kinds.entry(kind).or_insert((0, (usize::MAX, String::new())));
            known.0 += 1;
            if far < known.1.0 {
                known.1 = (far, format!("seed {seed}: {text}"));
            }
            broken = true;
        }
        counts.broken += usize::from(broken);
        if std::env::var_os("CGA_BOXES").is_some() {
            println!("seed {seed}: {} ms{}", began.elapsed().as_millis(), if broken { ", broken" } else { "" });
        }
    }
    counts
}

/// The kind of a difference, and the first number in its text: how far from the start it is.
fn kind(text: &str) -> (String, usize) {
    let head = text.split(": ").next().unwrap_or_default();
    let words: Vec<&str> = head.split(' ').collect();
    let number = words.iter().find_map(|word| word.trim_end_matches(',').parse().ok()).unwrap_or_default();
    // Rules have names in capitals, and places numbers: neither belongs to the kind.
    let general = |word: &&&str| !word.starts_with(|c: char| c.is_ascii_digit() || c.is_uppercase());
    (words.iter().filter(general).copied().collect::<Vec<_>>().join(" "), number)
}

/// Plays a run in all pairs; says what differs.
fn pairs(seed: u64, make: Make, number: u64, counts: &mut Counts) -> Option<String> {
    let mut random = Random(seed << 32 | number);
    let mut grammar = make();
    let attributes = start::attributes(&mut *grammar, &mut random);
    let (given, shape) = start::shape(&mut random);
    let size = shape.scope().size.abs().max_element();
    let tolerance = Tolerance { length: 1e-9 * size };
    for pair in PAIRS {
        counts.runs += 1;
        let played = catch_unwind(AssertUnwindSafe(|| (pair.shapes)(&shape).map(|shape| run(&*grammar, &shape))));
        let Ok([left, right]) = played else {
            return Some(format!("run {number} panics on {given} with {attributes}"));
        };
        counts.leaves += left.model.len();
        match &left.report {
            Ok(report) => {
                counts.prints += report.prints().len();
                counts.faults += report.faults.len();
                counts.ended += usize::from(report.stopped);
            }
            Err(_) => counts.ended += 1,
        }
        // Boxes count as vertices only when they become meshes, so that this limit alone may end one run of the two.
        let vertices = |run: &Outcome| run.report.as_ref().is_err_and(|error| error.starts_with("more vertices"));
        if vertices(&left) || vertices(&right) {
            continue;
        }
        if let Some(text) = difference(&left, &right, tolerance) {
            let [left, right] = pair.names;
            return Some(format!("{text}\n    ({left}, {right}; run {number} on {given} with {attributes})"));
        }
    }
    None
}

pub(crate) fn run(grammar: &dyn Grammar, shape: &Shape) -> Outcome {
    let limits = Limits { shapes: 1000, depth: 64, vertices: 20_000, ..Limits::default() };
    let mut few = Few(Model::new());
    let report = grammar.derive(shape, &Settings { limits, ..Settings::default() }, &mut few);
    Outcome { model: few.0, report: report.map_err(|error| error.to_string()) }
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
        let Counts { grammars, runs, leaves, prints, faults, ended, broken, .. } = self;
        format!(
            "{grammars} grammars, {runs} pairs of runs, {leaves} leaves, {prints} prints, {faults} faults, \
             {ended} runs cut short, {broken} grammars with differences"
        )
    }
}
