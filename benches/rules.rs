//! Rules as people write them: arguments, attributes with chance, colours that are drawn, beside the same rules with constants, and the
//! scenes of the gallery.
//!
//! `cargo bench --bench rules`; words after `--` choose rows by parts of their names, as in `-- bridge temple`. With `-- --instructions` it
//! counts the instructions of the scenes instead.
//!
//! A town of 100 houses; the columns are the share of leaves that are replayed together, and the time of a leaf without output, in
//! buffers, and relative to the first row of the table.

mod common;
#[path = "rules/houses.rs"]
mod houses;
#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code, unreachable_pub, reason = "the pictures of the scenes are made elsewhere")]
mod scenes;

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::rc::Rc;
use std::sync::Arc;

use cga::glam::DAffine3;
use cga::sink::buffers::Buffers;
use cga::sink::{Filled, Replay};
use cga::{Cuboid, DynSession, Flow, Grammar, Leaf, Mesh, Model, Settings, Shape, Sink};
use common::clock::{fastest, nanoseconds_each};
use common::instructions::{Work, counted};
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

impl Counts {
    fn leaves(&self) -> usize {
        self.replayed + self.others
    }
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

    fn cuboid(&mut self, _: &Leaf<'_>, _: &Cuboid) -> Flow {
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

/// Passes the leaves of all shapes of a row to a sink.
type Run<'a> = dyn Fn(&mut dyn Sink) + 'a;

/// The name and the shapes of a row.
struct Subject<'a> {
    name: String,
    run: Box<Run<'a>>,
}

/// All houses of each grammar, in one session.
fn towns<'a>(grammars: &'a [(&'a str, Box<dyn Grammar>)], lots: &'a [Shape]) -> Vec<Subject<'a>> {
    let subject = |(name, grammar): &'a (&str, Box<dyn Grammar>)| {
        let run = move |sink: &mut dyn Sink| {
            let mut session = grammar.session(&Settings::default()).expect("the attributes are in their ranges");
            lots.iter().for_each(|lot| drop(session.run(lot, sink).expect("no limit is reached")));
        };
        Subject { name: (*name).to_owned(), run: Box::new(run) }
    };
    grammars.iter().map(subject).collect()
}

/// The scenes of the gallery, with a session for each start rule.
fn gallery<'a>(scenes: &'a [scenes::Scene]) -> Vec<Subject<'a>> {
    let subject = |scene: &'a scenes::Scene| {
        let scenes::Scene { name, grammar, shapes, .. } = scene;
        let run = move |sink: &mut dyn Sink| {
            let mut sessions: BTreeMap<&str, Box<dyn DynSession + '_>> = BTreeMap::new();
            for placed in shapes {
                let session = sessions.entry(placed.rule).or_insert_with(|| {
                    let (start, assets) = (Some(placed.rule.to_owned()), scenes::materials::single_pixels());
                    let settings = Settings { start, assets, ..Settings::default() };
                    grammar.session(&settings).expect("the attributes are in their ranges")
                });
                session.run(&placed.shape, sink).expect("no limit is reached");
            }
        };
        Subject { name: (*name).to_owned(), run: Box::new(run) }
    };
    scenes.iter().map(subject).collect()
}

/// A table of subjects. The first row is the measure of the others; `each` is what the last column counts.
fn table(title: &str, each: Each, subjects: &[Subject<'_>]) {
    let last = match each {
        Each::Leaf => "no output / first row",
        Each::Window => "beyond the first row, ns a window",
        Each::Triangle => "buffers, ns a triangle",
    };
    let columns = ["rules", "templates, %", "no output, ns a leaf", "buffers, ns a leaf", "new buffers", last];
    let mut table = Table::new(title, &columns);
    let mut first = None;
    let wanted: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    for Subject { name, run } in subjects {
        if !wanted.is_empty() && !wanted.iter().any(|word| name.contains(word.as_str())) {
            continue;
        }
        let mut counts = Counts::default();
        run(&mut counts);
        let leaves = counts.leaves();
        let mut out = Buffers::new();
        run(&mut out);
        let triangles = out.triangle_count();
        let best = fastest(
            SECONDS,
            [
                &mut || run(&mut Counts::default()),
                &mut || {
                    out.clear();
                    run(&mut out);
                },
                &mut || run(&mut Buffers::new()),
            ],
        );
        let [alone, buffers, new_buffers] = best.map(|time| nanoseconds_each(time, leaves));
        let (first, windows) = *first.get_or_insert_with(|| (best[0], windows(run)));
        let compared = match each {
            Each::Leaf => number(best[0].as_secs_f64() / first.as_secs_f64(), 2),
            Each::Window => number(nanoseconds_each(best[0].saturating_sub(first), windows), 0),
            Each::Triangle => number(nanoseconds_each(best[1], triangles), 1),
        };
        let share = 100.0 * counts.replayed as f64 / leaves as f64;
        let times = [alone, buffers, new_buffers].map(|time| number(time, 1));
        let cells: Vec<String> = [number(share, 1)].into_iter().chain(times).chain([compared]).collect();
        table.row(name, &cells);
    }
    table.print();
}

/// The unit in which a table compares its rows.
#[derive(Clone, Copy)]
enum Each {
    /// Rows with the same leaves.
    Leaf,
    /// Rows with another operation in each window.
    Window,
    /// Rows of their own.
    Triangle,
}

/// The number of windows.
fn windows(run: &Run<'_>) -> usize {
    let mut model = Model::new();
    run(&mut model);
    model.leaves().filter(|leaf| leaf.rule() == "Window").count()
}

/// The derivation of each scene without output, counted in instructions.
fn works(subjects: Vec<Subject<'static>>) -> Vec<Work> {
    let work = |Subject { name, run }| {
        let run: Rc<Run<'static>> = Rc::from(run);
        Work::new(&name, move || {
            let mut counts = Counts::default();
            run(&mut counts);
            let run = run.clone();
            (counts.leaves(), move || run(&mut Counts::default()))
        })
    };
    subjects.into_iter().map(work).collect()
}

fn main() {
    let scenes: &'static [scenes::Scene] = scenes::scenes().leak();
    if counted("Scenes of the gallery", "leaf", &works(gallery(scenes))) {
        return;
    }
    let lots = lots();
    table("Arguments", Each::Leaf, &towns(&houses::arguments(), &lots));
    table("Colours", Each::Leaf, &towns(&houses::colours(), &lots));
    table("Attributes with chance", Each::Leaf, &towns(&houses::chances(), &lots));
    table("Operations in each window", Each::Window, &towns(&houses::operations(), &lots));
    table("Scenes of the gallery", Each::Triangle, &gallery(scenes));
}
