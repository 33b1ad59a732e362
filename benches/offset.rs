//! Outlines moved inwards until nothing is left, and roofs, which are made by the same wavefront.
//!
//! `cargo bench --bench offset`, with `-- --instructions` instructions instead of times. The time is proportional to the square of the number of corners, both for separate
//! and for simultaneous events.

mod common;

use std::f64::consts::TAU;
use std::hint::black_box;

use cga::sink::stats::Stats;
use cga::{Settings, Shape, cga};
use common::clock::{fastest, nanoseconds_each};
use common::instructions::{Work, counted};
use common::table::{Table, number};

cga! {
    /// The border faces of an offset that sweeps a whole lot.
    grammar Swept;

    Lot --> offset(-10, border) Border.
}

cga! {
    /// Roofs over a lot.
    grammar Roofs;

    @StartRule
    Hip --> roofHip(30) Roof.
    @StartRule
    HipOver --> roofHip(30, 0.5) Roof.
    @StartRule
    Gable --> roofGable(30) Roof.
    @StartRule
    GableOver --> roofGable(30, 0.5, 0.3) Roof.
}

/// Pseudo-random numbers from 0 to 1.
fn mixed(i: u32) -> f64 {
    let mixed = (u64::from(i) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    ((mixed ^ mixed >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 11) as f64 / (1u64 << 53) as f64
}

/// A loop around the origin, with a radius for each corner.
fn around(corners: u32, radius: impl Fn(u32) -> f64) -> Vec<[f64; 2]> {
    let angle = |i: u32| TAU * f64::from(i) / f64::from(corners);
    (0..corners).map(|i| [libm::cos(angle(i)), libm::sin(angle(i))].map(|c| radius(i) * c)).collect()
}

/// Two parallel walls, each of many edges.
fn corridor(corners: u32) -> Vec<[f64; 2]> {
    let half = corners / 2;
    let end = f64::from(half - 1);
    let wall = |far: bool| move |i: u32| if far { [end - f64::from(i), 8.0] } else { [f64::from(i), 0.0] };
    (0..half).map(wall(false)).chain((0..half).map(wall(true))).collect()
}

/// Moves an outline inwards until nothing is left.
fn sweep(lot: &Shape) {
    let mut stats = Stats::new();
    let report = Swept::default().run(lot, &Settings::default(), &mut stats).expect("no limit is reached");
    assert!(report.faults().is_empty(), "{:?}", report.faults());
    black_box(stats);
}

/// Builds the roof of a rule.
fn roof(lot: &Shape, rule: &str) {
    let mut stats = Stats::new();
    let settings = Settings { start: Some(rule.to_string()), ..Settings::default() };
    let report = Roofs::default().run(lot, &settings, &mut stats).expect("no limit is reached");
    assert!(report.faults().is_empty(), "{rule}: {:?}", report.faults());
    black_box(stats);
}

fn row(table: &mut Table, name: &str, outline: &[[f64; 2]]) {
    let lot = Shape::footprint(outline, &[]).expect("a polygon");
    let mut work = || sweep(&lot);
    let [best] = fastest(0.5, [&mut work]);
    let corners = outline.len();
    let whole = nanoseconds_each(best, 1);
    let [us, a_pair] = [whole / 1e3, whole / (corners * corners) as f64];
    table.row(name, &[number(a_pair, 1), corners.to_string(), number(us, 1)]);
}

/// The time of each roof over an outline, in microseconds.
fn roofs(table: &mut Table, name: &str, outline: &[[f64; 2]]) {
    let lot = Shape::footprint(outline, &[]).expect("a polygon");
    let times = ["Hip", "HipOver", "Gable", "GableOver"].map(|rule| {
        let mut work = || roof(&lot, rule);
        let [best] = fastest(0.25, [&mut work]);
        number(nanoseconds_each(best, 1) / 1e3, 1)
    });
    let mut cells = vec![outline.len().to_string()];
    cells.extend(times);
    table.row(name, &cells);
}

const NOTCHED: [[f64; 2]; 6] = [[0.0, 0.0], [9.0, 0.0], [9.0, 3.0], [6.0, 3.0], [6.0, 5.0], [0.0, 5.0]];

const WINGS: [[f64; 2]; 8] =
    [[0.0, 0.0], [14.0, 1.0], [13.5, 8.0], [9.0, 7.7], [8.6, 13.0], [5.0, 12.8], [5.3, 9.0], [-0.5, 8.6]];

/// The work of which instructions are counted.
fn works() -> Vec<Work> {
    let star = around(100, |i| 4.0 + mixed(i));
    let disk = around(100, |_| 5.0);
    let outlines = [("notch", NOTCHED.to_vec()), ("wings", WINGS.to_vec()), ("star", star), ("disk", disk)];
    let of = |(name, outline): (&str, Vec<[f64; 2]>)| {
        let corners = outline.len();
        let lot = Shape::footprint(&outline, &[]).expect("a polygon");
        let swept = lot.clone();
        let sweep = Work::new(&format!("offset: {name}"), move || {
            let lot = swept.clone();
            (corners, move || sweep(&lot))
        });
        let roofs = ["Hip", "GableOver"].map(|rule| {
            let lot = lot.clone();
            Work::new(&format!("{rule}: {name}"), move || {
                let lot = lot.clone();
                (corners, move || roof(&lot, rule))
            })
        });
        [sweep].into_iter().chain(roofs)
    };
    outlines.into_iter().flat_map(of).collect()
}

fn main() {
    if counted("Offsets and roofs", "corner", &works()) {
        return;
    }
    let mut table = Table::new("Offset of a face", &["face", "ns a pair of corners", "corners", "us"]);
    row(&mut table, "rectangle with a notch", &NOTCHED);
    for corners in [100, 1_000, 5_000] {
        row(&mut table, "disk: all at once", &around(corners, |_| 5.0));
        row(&mut table, "corridor: all at once", &corridor(corners));
        row(&mut table, "star: one by one", &around(corners, |i| 4.0 + mixed(i)));
    }
    table.print();
    let mut table = Table::new("Roofs", &["face", "corners", "hip us", "with overhang", "gable us", "with overhangs"]);
    roofs(&mut table, "rectangle", &[[0.0, 0.0], [12.0, 0.0], [12.0, 8.0], [0.0, 8.0]]);
    roofs(&mut table, "house with a wing", &WINGS);
    roofs(&mut table, "star", &around(45, |i| 10.0 + 4.0 * mixed(i)));
    roofs(&mut table, "disk", &around(1_000, |_| 50.0));
    roofs(&mut table, "corridor", &corridor(1_000));
    roofs(&mut table, "star", &around(1_000, |i| 40.0 + 10.0 * mixed(i)));
    table.print();
}
