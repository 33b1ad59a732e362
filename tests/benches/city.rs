//! Cities of 10,000 and 100,000 lots whose rules ask about their neighbours, streamed: lots a second, and the peak of memory.
//!
//! `cargo bench -p cga-tests --bench city`. The models are dropped as they come. A counting allocator counts the bytes of a run beside the list of
//! initial shapes. Runs use all cores.

#[path = "../../benches/common/mod.rs"]
mod common;

use std::ops::ControlFlow;
use std::time::Instant;

use cga::{Grammar, Model, Scene, Settings, Shape, cga};
use common::table::{Table, number};
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The houses of a row. Rows are 20 m from each other.
const ROW: usize = 50;

cga! {
    grammar Houses;
    @StartRule
    Plain    --> extrude(height) comp(f) { side : Facade | top : Roof. }
    Facade   --> split(y) { { ~3 : split(x) { { ~1.5 : Window. }* } }* }
    @StartRule
    Touching --> extrude(height) comp(f) { side : Asking | top : Roof. }
    Asking   --> split(y) { { ~3 : split(x) { { ~1.5 : Tile }* } }* }
    Tile     --> case touches(inter) : Wall. else : Window.
    @StartRule
    Counting --> extrude(height) label("house") Counted
    Counted  --> case contextCount(inter, "house") > 1000 : City. else : Village.
    @StartRule
    Ranked   --> extrude(height) label("house") Compared
    Compared --> case contextCompare(inter, "house", world.highest) < 10 : Tower. else : House.
    @StartRule
    Near     --> case p(0.01) : label("church") Church. else : Asks
    Asks     --> case minimumDistance(inter, "church") < 50 : Inn. else : House.
    height   = 3 * rint(rand(2, 6))
}

/// A city. Turned lots are turned by different angles.
fn city(count: usize, is_turned: bool) -> Vec<Shape> {
    let lot = |at: usize| {
        let (row, column) = ((at / ROW) as f64, (at % ROW) as f64);
        let place = [6.0 * column + 320.0 * (row % 40.0), 0.0, 20.0 * (row / 40.0).floor()];
        if !is_turned {
            return Shape::rectangle(6.0, 10.0).at(place).seed(at as u64);
        }
        let (sin, cos) = libm::sincos(at as f64);
        let corner = |x: f64, z: f64| [place[0] + x * cos + z * sin, place[2] - x * sin + z * cos];
        let outline = [corner(0.0, 3.0), corner(4.0, 3.0), corner(4.0, 0.0), corner(0.0, 0.0)];
        Shape::footprint(&outline, &[]).expect("a rectangle").seed(at as u64)
    };
    (0..count).map(lot).collect()
}

fn main() {
    let columns = ["rules", "lots", "leaves", "lots a second", "peak, MB", "peak, bytes a lot"];
    let mut table = Table::new("Cities whose lots ask about each other, streamed", &columns);
    let houses = Houses::default();
    let rows = [
        ("no queries", "Plain", false),
        ("`touches(inter)` in each tile", "Touching", false),
        ("`contextCount(inter)`", "Counting", false),
        ("`contextCompare(inter)`", "Ranked", false),
        ("`minimumDistance(inter)`, turned lots", "Near", true),
    ];
    for (name, start, is_turned) in rows {
        for count in [10_000, 100_000] {
            let lots = city(count, is_turned);
            let settings = Settings { start: Some(start.to_owned()), ..Settings::default() };
            let scene = Scene::new(&houses as &(dyn Grammar + Sync), &lots);
            let before = MEMORY.current_usage();
            MEMORY.reset_peak_usage();
            let (begin, mut leaves) = (Instant::now(), 0);
            let take = |_: usize, model: Model| {
                leaves += model.len();
                ControlFlow::Continue(())
            };
            scene.generate_each(&settings, take).expect("no limit is reached");
            let (seconds, peak) = (begin.elapsed().as_secs_f64(), MEMORY.peak_usage() - before);
            let cells = [
                count.to_string(),
                leaves.to_string(),
                number(count as f64 / seconds, 0),
                number(peak as f64 / 1e6, 1),
                number(peak as f64 / count as f64, 0),
            ];
            table.row(name, &cells);
        }
    }
    table.note("Labels of the whole city stay until the end; closed shapes and models do not.");
    table.print();
}
