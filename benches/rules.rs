//! Rules as people write them: arguments, attributes with chance, colours that are drawn, beside the same rules with constants.
//!
//! `cargo bench --bench rules`. A town of 100 houses; the columns are the share of leaves that are replayed together, and the time of a
//! leaf without output, in buffers, and relative to the first row of the table.

mod common;
#[path = "rules/houses.rs"]
mod houses;

use std::ops::ControlFlow;
use std::sync::Arc;

use cga::glam::DAffine3;
use cga::sink::buffers::Buffers;
use cga::sink::{Filled, Replay};
use cga::{DynSession, Flow, Grammar, Leaf, Mesh, Model, Settings, Shape, Sink};
use common::clock::{fastest, nanoseconds_each};
use common::table::{Table, number};

/// The seconds for which each row is repeated.
const SECONDS: f64 = 0.5;

/// The number of houses.
const HOUSES: u32 = 100;

/// Counts leaves.
#[derive(Default)]
struct Counts {
    replayed: usize,
    others: usize,
}

impl Sink for Counts {
    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        self.replayed += replay.leaf_count();
        ControlFlow::Continue(())
    }

    fn filled(&mut self, _: &Filled<'_>) -> Flow {
        self.others += 1;
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        self.others += 1;
        ControlFlow::Continue(())
    }
}

/// The lots of the houses, of two to ten floors.
fn lots() -> Vec<Shape> {
    let lot = |number: u32| {
        let floors = f64::from(2 + (7 * number) % 9);
        let at = [20.0 * f64::from(number % 10), 0.0, 20.0 * f64::from(number / 10)];
        Shape::cuboid(13.5, 4.0 + 3.0 * floors, 11.0).at(at).seed(u64::from(number))
    };
    (0..HOUSES).map(lot).collect()
}

/// Runs all houses in one session.
fn run(session: &mut dyn DynSession, lots: &[Shape], sink: &mut dyn Sink) {
    for lot in lots {
        session.run(lot, sink).expect("no limit is reached");
    }
}

/// A table of grammars. The first row is the measure of the others; `each` is what is counted for the last column.
fn table(title: &str, each: Each, rows: &[(&str, Box<dyn Grammar>)]) {
    let last = match each {
        Each::Leaf => "no output / first row",
        Each::Window => "beyond the first row, ns a window",
    };
    let columns = ["rules", "templates, %", "no output, ns a leaf", "buffers, ns a leaf", "new buffers", last];
    let mut table = Table::new(title, &columns);
    let (lots, mut first) = (lots(), None);
    for (name, grammar) in rows {
        let new = || grammar.session(&Settings::default()).expect("the attributes are in their ranges");
        let mut counts = Counts::default();
        run(&mut *new(), &lots, &mut counts);
        let leaves = counts.replayed + counts.others;
        let mut out = Buffers::new();
        run(&mut *new(), &lots, &mut out);
        let best = fastest(
            SECONDS,
            [
                &mut || run(&mut *new(), &lots, &mut Counts::default()),
                &mut || {
                    out.clear();
                    run(&mut *new(), &lots, &mut out);
                },
                &mut || run(&mut *new(), &lots, &mut Buffers::new()),
            ],
        );
        let [alone, buffers, new_buffers] = best.map(|time| nanoseconds_each(time, leaves));
        let (first, windows) = *first.get_or_insert_with(|| (best[0], windows(&**grammar, &lots)));
        let compared = match each {
            Each::Leaf => number(best[0].as_secs_f64() / first.as_secs_f64(), 2),
            Each::Window => number(nanoseconds_each(best[0].saturating_sub(first), windows), 0),
        };
        let share = 100.0 * counts.replayed as f64 / leaves as f64;
        table.row(name, &[number(share, 1), number(alone, 1), number(buffers, 1), number(new_buffers, 1), compared]);
    }
    table.print();
}

/// What a table compares.
#[derive(Clone, Copy)]
enum Each {
    /// Rows with the same leaves.
    Leaf,
    /// Rows with another operation in each window.
    Window,
}

/// The number of windows.
fn windows(grammar: &dyn Grammar, lots: &[Shape]) -> usize {
    let mut model = Model::new();
    run(&mut *grammar.session(&Settings::default()).expect("the attributes are in their ranges"), lots, &mut model);
    model.leaves().filter(|leaf| leaf.rule() == "Window").count()
}

fn main() {
    table("Arguments", Each::Leaf, &houses::arguments());
    table("Colours", Each::Leaf, &houses::colours());
    table("Attributes with chance", Each::Leaf, &houses::chances());
    table("Operations in each window", Each::Window, &houses::operations());
}
