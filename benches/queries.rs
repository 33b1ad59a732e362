//! Rules that ask about other shapes, beside the same rules without a query.
//!
//! `cargo bench --bench queries`, with `-- --instructions` instructions instead of times. Twenty terraces of twenty houses, each with a tile for every window. In the first table a terrace is an
//! initial shape, in the second a house is one. A rule with a query has no templates, and a query of its own initial shape needs one more
//! derivation. So the rules without a query have two rows: with templates, and with each repetition derived at its place.

mod common;

use std::hint::black_box;

use cga::parallel::run_all;
use cga::sink::stats::Stats;
use cga::{Grammar, Repeats, Scene, Settings, Shape, cga};
use common::clock::{fastest, nanoseconds_each};
use common::instructions::{Work, counted};
use common::table::{Table, number};

/// The seconds for which each row is repeated.
const SECONDS: f64 = 1.0;

/// The houses of a terrace, and the number of terraces.
const HOUSES: usize = 20;

cga! {
    grammar Plain;
    @StartRule
    Terrace --> split(x) { ~6 : House }*
    @StartRule
    House  --> extrude(3 * rint(rand(2, 6))) comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { { ~3 : Floor }* }
    Floor  --> split(x) { { ~1.5 : Tile }* }
    Tile   --> Window.
}

cga! {
    grammar Touching;
    Terrace --> split(x) { ~6 : House }*
    House  --> extrude(3 * rint(rand(2, 6))) comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { { ~3 : Floor }* }
    Floor  --> split(x) { { ~1.5 : Tile }* }
    Tile   --> case touches(intra) : Wall. else : Window.
}

cga! {
    grammar Counting;
    Terrace --> split(x) { ~6 : House }*
    House  --> extrude(3 * rint(rand(2, 6))) label("house") comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { { ~3 : Floor }* }
    Floor  --> split(x) { { ~1.5 : Tile }* }
    Tile   --> case contextCount(intra, "house") < 20 : Wall. else : Window.
}

cga! {
    grammar Party;
    House  --> extrude(3 * rint(rand(2, 6))) comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { { ~3 : Floor }* }
    Floor  --> split(x) { { ~1.5 : Tile }* }
    Tile   --> case touches(inter) : Wall. else : Window.
}

/// A row: the name and a run that returns the number of leaves.
type Row = (&'static str, fn() -> Box<dyn FnMut() -> u64>);

/// The rows of a table. The times of others are divided by the times of the first two.
type Rows = [Row; 4];

/// The rules without a query in a terrace, and rules that ask about their own terrace.
const OWN: Rows = [
    ("none, with templates", || alone(Plain::default(), Repeats::default())),
    ("none, in place", || alone(Plain::default(), Repeats::Direct)),
    ("`contextCount(intra)` in each tile", || alone(Counting::default(), Repeats::default())),
    ("`touches(intra)` in each tile", || alone(Touching::default(), Repeats::default())),
];

/// The rules without a query for each house, and rules that ask about the houses beside.
const NEIGHBOURS: Rows = [
    ("none, houses with templates", || all(Plain::default(), Repeats::default())),
    ("none, houses in place", || all(Plain::default(), Repeats::Direct)),
    ("none, houses in a `Scene`", || scene(Plain::default())),
    ("`touches(inter)` in each tile", || scene(Party::default())),
];

/// Settings with a way to repeat parts.
fn settings(repeats: Repeats) -> Settings {
    Settings { repeats, ..Settings::default() }
}

/// The low corner of a terrace.
fn place(terrace: usize) -> [f64; 3] {
    [0.0, 0.0, 20.0 * terrace as f64]
}

/// The run of the terraces one after the other.
fn alone(grammar: impl Grammar + 'static, repeats: Repeats) -> Box<dyn FnMut() -> u64> {
    let terrace =
        |at: usize| Shape::rectangle(6.0 * HOUSES as f64, 10.0).at(place(at)).seed(at as u64).start("Terrace");
    let terraces: Vec<Shape> = (0..HOUSES).map(terrace).collect();
    let settings = settings(repeats);
    Box::new(move || {
        let mut session = grammar.session(&settings).expect("good settings");
        terraces.iter().map(|lot| session.run(lot, &mut Stats::new()).expect("no limit is reached").leaves).sum()
    })
}

/// The houses of all terraces.
fn houses() -> Vec<Shape> {
    let house = |at: usize| {
        let [_, _, z] = place(at / HOUSES);
        Shape::rectangle(6.0, 10.0).at([6.0 * (at % HOUSES) as f64, 0.0, z]).seed(at as u64).start("House")
    };
    (0..HOUSES * HOUSES).map(house).collect()
}

/// The run of the houses, each for itself.
fn all(grammar: impl Grammar + Sync + 'static, repeats: Repeats) -> Box<dyn FnMut() -> u64> {
    let (houses, settings) = (houses(), settings(repeats));
    Box::new(move || {
        run_all(&grammar, &houses, &settings, |_| Stats::new()).expect("no limit is reached").report().leaves
    })
}

/// The run of a scene of houses.
fn scene(grammar: impl Grammar + Sync + 'static) -> Box<dyn FnMut() -> u64> {
    let (houses, settings) = (houses(), Settings::default());
    Box::new(move || {
        let scene = Scene::new(&grammar, &houses);
        scene.run(&settings, |_| Stats::new()).expect("no limit is reached").report().leaves
    })
}

/// A table of rows.
fn table(title: &str, rows: Rows) {
    let columns = ["rules", "leaves", "ns a leaf", "in place = 1", "templates = 1"];
    let mut table = Table::new(title, &columns);
    let [mut first, mut second] = [rows[0], rows[1]].map(|(_, make)| make());
    for (name, make) in rows {
        let mut run = make();
        let leaves = run();
        let [templates, in_place, own] = fastest(
            SECONDS,
            [&mut || _ = black_box(first()), &mut || _ = black_box(second()), &mut || _ = black_box(run())],
        )
        .map(|time| nanoseconds_each(time, leaves as usize));
        table.row(name, &[leaves.to_string(), number(own, 1), number(own / in_place, 2), number(own / templates, 2)]);
    }
    table.print();
}

fn main() {
    let works = OWN.into_iter().chain(NEIGHBOURS).map(|(name, make)| {
        Work::new(name, move || {
            let mut run = make();
            (run() as usize, move || _ = black_box(run()))
        })
    });
    if counted("Queries", "leaf", &works.collect::<Vec<_>>()) {
        return;
    }
    table("Queries of the same initial shape", OWN);
    table("Queries of neighbours", NEIGHBOURS);
}
