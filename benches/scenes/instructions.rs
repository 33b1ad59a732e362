//! Instructions of the scenes.

use std::hint::black_box;

use cga::Model;
use cga::sink::buffers::Buffers;
use cga::sink::gltf::Glb;
use cga::sink::obj::Obj;
use cga::sink::stats::Stats;

use crate::common::instructions::{can_count, count, twice};
use crate::common::table::{Table, number};
use crate::workloads::{self, Fold, Raw, Scene};
use crate::{ratio_cells, ratios};

const WAYS: [&str; 3] = ["by hand", "buffers", "terminals"];

/// The other sinks. Each run makes a new sink, and writes its bytes if it has any.
const SINKS: [&str; 5] = ["new buffers", "model", "GLB bytes", "OBJ text", "stats"];

/// Prints a row for each scene.
pub(crate) fn print(scenes: &[Box<dyn Scene>]) {
    let mut table = ratios("Scenes: instructions", "instructions a terminal");
    if !can_count() {
        table.note("Not counted: `valgrind` is not installed.");
        return table.print();
    }
    for scene in scenes {
        let terminals = scene.expected().terminals;
        let each = WAYS.map(|way| count(&[&scene.name(), way]) as f64 / terminals as f64);
        table.row(&scene.name(), &ratio_cells(terminals, each, 0));
    }
    table.print();
    sinks(scenes);
}

fn sinks(scenes: &[Box<dyn Scene>]) {
    let mut table = Table::new("Scenes: other sinks, instructions a terminal", &[&["scene"], &SINKS[..]].concat());
    for scene in scenes {
        let terminals = scene.expected().terminals;
        let cells = SINKS.map(|way| number(count(&[&scene.name(), way]) as f64 / terminals as f64, 0));
        table.row(&scene.name(), &cells);
    }
    table.print();
}

/// The child process: one scene in one implementation.
pub(crate) fn run(scene: &str, way: &str) {
    let mut scene = workloads::all().into_iter().find(|other| other.name() == scene).expect("a scene of this name");
    let expected = scene.expected();
    let (vertices, indices) = (expected.vertices, 3 * expected.triangles);
    match WAYS.iter().position(|name| *name == way) {
        Some(0) => {
            let mut out = Raw::with_capacity(vertices, indices);
            twice(&mut || {
                out.clear();
                scene.by_hand(&mut out);
            });
        }
        Some(1) => {
            let mut out = Buffers::with_capacity(vertices, indices);
            twice(&mut || {
                out.clear();
                scene.buffers(&mut out);
            });
        }
        _ if way == SINKS[0] => twice(&mut || {
            let mut out = Buffers::new();
            scene.buffers(&mut out);
            black_box(out);
        }),
        _ if way == SINKS[1] => twice(&mut || {
            let mut model = Model::new();
            scene.model(&mut model);
            black_box(model);
        }),
        _ if way == SINKS[2] => twice(&mut || {
            let mut glb = Glb::new();
            scene.glb(&mut glb);
            black_box(glb.into_bytes().expect("it fits"));
        }),
        _ if way == SINKS[3] => twice(&mut || {
            let mut obj = Obj::new(std::io::sink(), "scene.mtl");
            scene.obj(&mut obj);
            black_box(obj.finish().expect("nothing fails"));
        }),
        _ if way == SINKS[4] => twice(&mut || {
            let mut stats = Stats::new();
            scene.stats(&mut stats);
            black_box(stats.checksum());
        }),
        _ => twice(&mut || {
            let mut fold = Fold::default();
            scene.fold(&mut fold);
            black_box(fold.sum);
        }),
    }
}
