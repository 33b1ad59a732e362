//! Rules that ask about other shapes, beside the same rules without a query.
//!
//! `cargo bench --bench queries`. Twenty terraces of twenty houses, each with a tile for every window. In the first table a terrace is an
//! initial shape, in the second a house is one. A rule with a query has no templates, and a query of its own initial shape needs one more
//! derivation. So the rules without a query have two rows: with templates, and with each repetition derived at its place.

mod common;

use std::hint::black_box;

use cga::parallel::run_all;
use cga::sink::stats::Stats;
use cga::{Grammar, Repeats, Scene, Settings, Shape, cga};
use common::clock::{fastest, nanoseconds_each};
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
type Row<'a> = (&'a str, &'a dyn Fn() -> u64);

/// The runs of lots one after the other.
fn alone(grammar: &dyn Grammar, lots: &[Shape], settings: &Settings) -> u64 {
    let mut session = grammar.session(settings).expect("good settings");
    lots.iter().map(|lot| session.run(lot, &mut Stats::new()).expect("no limit is reached").leaves).sum()
}

/// A table of rows. Times are divided by the times of the two first ones.
fn table(title: &str, [first, second, others @ ..]: [Row<'_>; 4]) {
    let columns = ["rules", "leaves", "ns a leaf", "in place = 1", "templates = 1"];
    let mut table = Table::new(title, &columns);
    for row in [first, second].iter().chain(&others) {
        let leaves = row.1();
        let [templates, in_place, own] = fastest(
            SECONDS,
            [&mut || _ = black_box(first.1()), &mut || _ = black_box(second.1()), &mut || _ = black_box(row.1())],
        )
        .map(|time| nanoseconds_each(time, leaves as usize));
        table.row(row.0, &[leaves.to_string(), number(own, 1), number(own / in_place, 2), number(own / templates, 2)]);
    }
    table.print();
}

fn main() {
    let (kept, in_place) = (Settings::default(), Settings { repeats: Repeats::Direct, ..Settings::default() });
    let place = |terrace: usize| [0.0, 0.0, 20.0 * terrace as f64];
    let terraces: Vec<Shape> = (0..HOUSES)
        .map(|at| Shape::rectangle(6.0 * HOUSES as f64, 10.0).at(place(at)).seed(at as u64).start("Terrace"))
        .collect();
    let house = |at: usize| {
        let [_, _, z] = place(at / HOUSES);
        Shape::rectangle(6.0, 10.0).at([6.0 * (at % HOUSES) as f64, 0.0, z]).seed(at as u64).start("House")
    };
    let houses: Vec<Shape> = (0..HOUSES * HOUSES).map(house).collect();
    let (plain, touching, counting, party) =
        (Plain::default(), Touching::default(), Counting::default(), Party::default());
    table(
        "Queries of the same initial shape",
        [
            ("none, with templates", &|| alone(&plain, &terraces, &kept)),
            ("none, in place", &|| alone(&plain, &terraces, &in_place)),
            ("`contextCount(intra)` in each tile", &|| alone(&counting, &terraces, &kept)),
            ("`touches(intra)` in each tile", &|| alone(&touching, &terraces, &kept)),
        ],
    );
    let all = |grammar: &(dyn Grammar + Sync), settings: &Settings| {
        run_all(grammar, &houses, settings, |_| Stats::new()).expect("no limit is reached").report().leaves
    };
    let scene = |grammar: &(dyn Grammar + Sync)| {
        Scene::new(grammar, &houses).run(&kept, |_| Stats::new()).expect("no limit is reached").report().leaves
    };
    table(
        "Queries of neighbours",
        [
            ("none, with templates", &|| all(&plain, &kept)),
            ("none, in place", &|| all(&plain, &in_place)),
            ("none, in a `Scene`", &|| scene(&plain)),
            ("`touches(inter)` in each tile", &|| scene(&party)),
        ],
    );
}
