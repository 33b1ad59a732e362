//! Workloads A, B, B2 and D: the cost of a grammar relative to a hand-written loop with the same output.
//!
//! `cargo bench --bench scenes` prints times; `-- --instructions` counts instructions instead. Any other argument
//! selects the scenes whose name contains it, as in `-- "A(40"`.

mod common;
#[path = "scenes/instructions.rs"]
mod instructions;
mod workloads;

use std::time::Duration;

use cga::Model;
use cga::sink::buffers::Buffers;
use cga::sink::gltf::Glb;
use common::clock::{fastest, nanoseconds_each};
use common::table::{Table, number};
use workloads::{Fold, Raw, Scene};

/// The seconds for which each scene is repeated.
const SECONDS: f64 = 1.0;

fn main() {
    // Cargo adds `--bench`.
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    if let [first, scene, way] = &arguments[..]
        && first == common::instructions::CHILD
    {
        return instructions::run(scene, way);
    }
    let chosen = arguments.iter().find(|argument| !argument.starts_with("--"));
    let wanted = |scene: &dyn Scene| chosen.is_none_or(|chosen| scene.name().contains(chosen));
    let mut scenes: Vec<_> = workloads::all().into_iter().filter(|scene| wanted(&**scene)).collect();
    if arguments.iter().any(|argument| argument == "--instructions") {
        scenes.retain(|scene| chosen.is_some() || scene.is_main());
        return instructions::print(&scenes);
    }
    times(&mut scenes);
    sinks(&mut scenes);
}

/// A table with a row for each scene: the ratios, then the absolute costs.
fn ratios(title: &str, unit: &str) -> Table {
    let columns = [
        "scene",
        "buffers / by hand",
        "terminals only / by hand",
        "terminals",
        &format!("by hand, {unit}"),
        &format!("buffers, {unit}"),
        &format!("terminals only, {unit}"),
    ];
    Table::new(title, &columns)
}

/// The cells of a row. `each` is the cost of one terminal by hand, into buffers, and without buffers.
fn ratio_cells(terminals: usize, each: [f64; 3], digits: usize) -> Vec<String> {
    let [hand, buffers, fold] = each;
    let mut cells = vec![number(buffers / hand, 2), number(fold / hand, 2), terminals.to_string()];
    cells.extend(each.map(|value| number(value, digits)));
    cells
}

fn times(scenes: &mut [Box<dyn Scene>]) {
    let mut table = ratios("Scenes: time", "ns a terminal");
    let mut growth = Growth::default();
    for scene in scenes {
        let expected = scene.expected();
        workloads::check(&mut **scene);
        // Large enough that no run must grow them.
        let (vertices, indices) = (expected.vertices, 3 * expected.triangles);
        let mut raw = Raw::with_capacity(vertices, indices);
        let mut out = Buffers::with_capacity(vertices, indices);
        let shared = std::cell::RefCell::new(&mut **scene);
        let best = fastest(
            SECONDS,
            [
                &mut || {
                    raw.clear();
                    shared.borrow_mut().by_hand(&mut raw);
                },
                &mut || {
                    out.clear();
                    shared.borrow_mut().buffers(&mut out);
                },
                &mut || shared.borrow_mut().fold(&mut Fold::default()),
            ],
        );
        let each = best.map(|time: Duration| nanoseconds_each(time, expected.terminals));
        let name = shared.borrow().name();
        table.row(&name, &ratio_cells(expected.terminals, each, 1));
        growth.add(&name, each);
    }
    table.print();
    growth.print();
}

/// The cost of a terminal at increasing sizes of a workload.
#[derive(Default)]
struct Growth(Vec<(String, Vec<[f64; 3]>)>);

impl Growth {
    /// Adds the next size of a workload.
    fn add(&mut self, scene: &str, each: [f64; 3]) {
        let workload = scene.split('(').next().unwrap_or(scene);
        match self.0.last_mut() {
            Some((last, sizes)) if last == workload => sizes.push(each),
            _ => self.0.push((workload.to_owned(), vec![each])),
        }
    }

    fn print(&self) {
        let columns =
            ["workload", "by hand, largest / smallest", "buffers", "terminals only", "buffers, ns a terminal by size"];
        let mut table = Table::new("Scenes: growth", &columns);
        for (workload, sizes) in self.0.iter().filter(|(_, sizes)| 1 < sizes.len()) {
            let (small, large) = (sizes[0], sizes[sizes.len() - 1]);
            let mut cells: Vec<String> = (0..3).map(|way| number(large[way] / small[way], 2)).collect();
            cells.push(sizes.iter().map(|each| number(each[1], 1)).collect::<Vec<_>>().join(", "));
            table.row(workload, &cells);
        }
        table.print();
    }
}

/// Measures models and files, relative to the hand-written loop that fills buffers.
fn sinks(scenes: &mut [Box<dyn Scene>]) {
    let columns = ["scene", "model / by hand", "GLB / by hand", "by hand, ns a terminal", "model, ns", "GLB bytes, ns"];
    let mut table = Table::new("Scenes: other sinks", &columns);
    for scene in scenes.iter_mut().filter(|scene| scene.is_main()) {
        let expected = scene.expected();
        let mut raw = Raw::with_capacity(expected.vertices, 3 * expected.triangles);
        let shared = std::cell::RefCell::new(&mut **scene);
        let best = fastest(
            SECONDS,
            [
                &mut || {
                    raw.clear();
                    shared.borrow_mut().by_hand(&mut raw);
                },
                &mut || {
                    let mut model = Model::new();
                    shared.borrow_mut().model(&mut model);
                    assert_eq!(model.len(), expected.terminals);
                },
                &mut || {
                    let mut glb = Glb::new();
                    shared.borrow_mut().glb(&mut glb);
                    let bytes = glb.into_bytes().expect("it fits");
                    assert!(12 * expected.triangles < bytes.len());
                },
            ],
        );
        let [hand, model, glb] = best.map(|time| nanoseconds_each(time, expected.terminals));
        let cells = [number(model / hand, 1), number(glb / hand, 1), number(hand, 1), number(model, 1), number(glb, 1)];
        let name = shared.borrow().name();
        table.row(&name, &cells);
    }
    table.print();
}
