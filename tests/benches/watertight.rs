//! The time of crack-free output: of the house front, the tower and the district, in buffers and as GLB files.
//!
//! `cargo bench -p cga-tests --bench watertight`

#[path = "../../benches/common/mod.rs"]
mod common;

use std::hint::black_box;
use std::time::Duration;

use cga::Model;
use cga::sink::buffers::Buffers;
use cga::sink::watertight::Watertight;
use cga_tests::drawn::{Drawn, drawn};
use common::clock::fastest;
use common::table::{Table, number};

/// The seconds for which each row is repeated.
const SECONDS: f64 = 4.0;

fn main() {
    let columns = [
        "model",
        "leaves",
        "triangles",
        "times as many",
        "run, ms",
        "buffers",
        "watertight buffers",
        "run and buffers, times",
        "to_glb",
        "watertight to_glb",
        "run and GLB, times",
    ];
    let mut table = Table::new("Crack-free output", &columns);
    let names = ["example front", "example tower", "example district"];
    drawn().iter().filter(|drawn| names.contains(&drawn.name.as_str())).for_each(|drawn| row(drawn, &mut table));
    table.print();
}

fn row(drawn: &Drawn, table: &mut Table) {
    let model = drawn.model(false);
    let [run, plain, tight, glb, tight_glb] = fastest(
        SECONDS,
        [
            &mut || drop(black_box(drawn.model(false))),
            &mut || {
                let mut buffers = Buffers::new();
                let _ = model.replay(&mut buffers);
                black_box(&buffers);
            },
            &mut || {
                let mut sink = Watertight::new(Buffers::new());
                let _ = model.replay(&mut sink);
                black_box(&sink.into_inner());
            },
            &mut || drop(black_box(model.to_glb())),
            &mut || drop(black_box(model.watertight().to_glb())),
        ],
    );
    let triangles = [&model, &model.watertight()].map(Model::triangle_count);
    let ms = |time: Duration| number(time.as_secs_f64() * 1e3, 2);
    let times = |tight: Duration, plain: Duration| number((run + tight).as_secs_f64() / (run + plain).as_secs_f64(), 1);
    let cells = [
        model.len().to_string(),
        triangles[0].to_string(),
        number(triangles[1] as f64 / triangles[0] as f64, 2),
        ms(run),
        ms(plain),
        ms(tight),
        times(tight, plain),
        ms(glb),
        ms(tight_glb),
        times(tight_glb, glb),
    ];
    table.row(&drawn.name, &cells);
}
