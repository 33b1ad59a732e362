//! Runs, with any attributes on any shapes, and what was printed in them.

use crate::random::Random;
use cga::glam::DAffine3;
use cga::{
    Attribute, ChoiceValues, Error, Flow, Grammar, Leaf, Limits, Mesh, Report, Settings, Shape, Sink, Text, Value,
    ValueType,
};
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Leaves after which a run is stopped.
const MOST_LEAVES: usize = 300;

/// The rules that runs begin with, some more often.
const STARTS: [&str; 10] = ["Lot", "Lot", "Lot", "Lot", "Lot", "Lot", "Side", "Side", "Round", "Many"];

/// Values for attributes without a range. Many are NaN, for which all comparisons are false.
const WILD: [f64; 22] = [
    0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    3.0,
    5.0,
    10.0,
    17.3,
    1e-3,
    1e-7,
    100.0,
    1e6,
    -20.0,
    1e300,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.25,
    4.0,
    f64::NAN,
    f64::NAN,
];

/// The sizes of most initial shapes.
const LENGTHS: [f64; 8] = [1.0, 2.0, 5.0, 10.0, 20.0, 0.5, 3.0, 7.3];

/// Rare sizes of initial shapes.
const EXTREMES: [f64; 7] = [0.0, 0.1, 100.0, 1e-4, 1e5, 1e-9, 1e12];

/// The observations of a run.
#[derive(Default)]
pub(crate) struct Run {
    /// The shape and the attributes of the run, as text.
    pub(crate) given: String,
    /// True if all attributes had their defaults.
    pub(crate) usual: bool,
    /// True if the run began with the start rule on a level footprint.
    pub(crate) is_lot: bool,
    /// True if the run reached its end, so that all its prints are here.
    pub(crate) whole: bool,
    /// The rules on the way to the limit that ended it. Then nothing that was printed is known.
    pub(crate) limit: Option<Vec<Text>>,
    /// The places it came by.
    pub(crate) marks: BTreeSet<u32>,
    pub(crate) splits: Vec<Seen>,
    pub(crate) quotients: Vec<(u32, f64)>,
}

/// A split of a run.
pub(crate) struct Seen {
    pub(crate) number: u32,
    /// A random number, to tell it from others.
    pub(crate) id: f64,
    /// Of the shape along the axis.
    pub(crate) extent: f64,
    /// Of its slots, as far as they do not depend on chance.
    pub(crate) sizes: Vec<Option<f64>>,
    pub(crate) pieces: Vec<Piece>,
}

/// A piece of a split.
pub(crate) struct Piece {
    pub(crate) number: u32,
    pub(crate) length: f64,
    pub(crate) index: f64,
    pub(crate) total: f64,
}

/// Counts leaves.
struct Count(usize);

impl Sink for Count {
    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        self.0 += 1;
        if self.0 < MOST_LEAVES { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }
}

/// Runs a grammar.
pub(crate) fn run(grammar: &mut dyn Grammar, random: &mut Random, usual: bool) -> Run {
    let (given, shape) = prepare(grammar, random, usual);
    let start = random.pick(&STARTS);
    let is_lot = *start == "Lot" && (given.starts_with("on a rectangle") || given.starts_with("on an L"));
    let mut run = Run { given: format!("{start} {given}"), usual, is_lot, ..Run::default() };
    match derive(grammar, start, &shape, &mut Count(0)) {
        Ok(report) => {
            run.whole = !report.stopped && report.prints_left_out() == 0;
            report.prints().iter().for_each(|print| run.hear(&print.to_string()));
        }
        Err(Error::Limit { trail, .. }) => run.limit = Some(trail),
        Err(error) => panic!("{error}, in {}", run.given),
    }
    run
}

/// Runs a rule, within limits.
pub(crate) fn derive(grammar: &dyn Grammar, start: &str, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error> {
    let settings = Settings { start: Some(start.into()), limits: limits(), ..Settings::default() };
    grammar.run(shape, &settings, sink)
}

/// The limits of runs.
pub(crate) fn limits() -> Limits {
    Limits { shapes: 5000, depth: 64, vertices: 50_000, waiting: 5000, prints: 5000, ..Limits::default() }
}

/// Sets attributes, if they are not to be as usual, and makes an initial shape; says what.
pub(crate) fn prepare(grammar: &mut dyn Grammar, random: &mut Random, usual: bool) -> (String, Shape) {
    let attributes = if usual { "defaults".into() } else { attributes(grammar, random) };
    let (name, shape) = shape(random);
    let seed = random.next();
    (format!("on {name}, seed {seed}, with {attributes}"), shape.seed(seed))
}

/// Sets attributes to anything that is accepted; says what.
fn attributes(grammar: &mut dyn Grammar, random: &mut Random) -> String {
    let mut given = Vec::new();
    for attribute in &grammar.attributes().to_vec() {
        if attribute.name == "at" || random.below(4) == 0 {
            continue;
        }
        let value = value(attribute, random);
        if grammar.set(&attribute.name, value.clone()).is_ok() {
            given.push(format!("{} = {value:?}", attribute.name));
        }
    }
    given.join(", ")
}

fn value(attribute: &Attribute, random: &mut Random) -> Value {
    match (attribute.ty, attribute.range, attribute.choices.as_ref().map(|choices| &choices.values)) {
        (ValueType::Bool, ..) => Value::Bool(random.below(2) == 0),
        (_, _, Some(ChoiceValues::Texts(list))) => Value::Text(random.pick(list).clone()),
        (_, _, Some(ChoiceValues::Floats(list))) => Value::Float(*random.pick(list)),
        (_, Some(range), _) if range.restricted => {
            Value::Float(range.min + (range.max - range.min) * random.below(5) as f64 / 4.0)
        }
        _ => Value::Float(*random.pick(&WILD)),
    }
}

fn shape(random: &mut Random) -> (String, Shape) {
    let list: &[f64] = if random.below(4) == 0 { &EXTREMES } else { &LENGTHS };
    let [a, b, c] = [0; 3].map(|_| *random.pick(list));
    let (wide, deep) = (a.max(0.1), b.max(0.1));
    match random.below(10) {
        0..4 => (format!("a rectangle {a} × {b}"), Shape::rectangle(a, b)),
        4 | 5 => (format!("a box {a} × {b} × {c}"), Shape::cuboid(a, b, c)),
        6 | 7 => {
            let corner = [wide / 2.0, deep / 2.0];
            let outline = [[0.0, 0.0], [wide, 0.0], [wide, corner[1]], corner, [corner[0], deep], [0.0, deep]];
            let shape = Shape::footprint(&outline, &[]).expect("an outline");
            (format!("an L of {wide} × {deep}"), shape)
        }
        8 => (format!("a line by {wide}, {b}, {c}"), Shape::line([0.0; 3], [wide, b, c]).expect("a line")),
        _ => ("a point".into(), Shape::point([1.0, 2.0, 3.0])),
    }
}

impl Run {
    /// Takes in what was printed.
    fn hear(&mut self, line: &str) {
        let mut parts = line.split(';');
        let word = parts.next().unwrap_or_default();
        if let Ok(mark) = word.parse::<u32>() {
            self.marks.insert(mark);
            return;
        }
        let parts: Vec<Option<f64>> = parts.map(|part| part.parse().ok()).collect();
        let float = |at: usize| parts[at].expect("a number");
        let number = float(0) as u32;
        self.marks.insert(number);
        match word {
            "split" => {
                let (id, extent) = (float(1), float(2).abs());
                self.splits.push(Seen { number, id, extent, sizes: parts[3..].to_vec(), pieces: Vec::new() });
            }
            "piece" => {
                let piece = Piece { number, length: float(1).abs(), index: float(2), total: float(3) };
                let own =
                    self.splits.iter_mut().rev().find(|seen| (f64::from(seen.number), seen.id) == (float(5), float(6)));
                own.expect("its split was printed").pieces.push(piece);
            }
            _ => self.quotients.push((number, float(1))),
        }
    }
}
