//! Instructions instead of times: equal numbers in every run, even on a busy machine.
//!
//! Each scene runs in a child process under callgrind: once to warm up, then once inside [`counted_by_callgrind`],
//! the only function that callgrind counts.

use std::hint::black_box;
use std::process::Command;

use cga::Model;
use cga::sink::buffers::Buffers;
use cga::sink::gltf::Glb;
use cga::sink::obj::Obj;
use cga::sink::stats::Stats;

use crate::common::table::{Table, number};
use crate::workloads::{self, Fold, Raw, Scene};
use crate::{ratio_cells, ratios};

/// The first argument of the child process.
pub(crate) const CHILD: &str = "--counted";

const WAYS: [&str; 3] = ["by hand", "buffers", "terminals"];

/// The other sinks. Each run makes a new sink, and writes its bytes if it has any.
const SINKS: [&str; 5] = ["new buffers", "model", "GLB bytes", "OBJ text", "stats"];

/// Prints a row for each scene.
pub(crate) fn print(scenes: &[Box<dyn Scene>]) {
    let mut table = ratios("Scenes: instructions", "instructions a terminal");
    if Command::new("valgrind").arg("--version").output().is_err() {
        table.note("Not counted: `valgrind` is not installed.");
        return table.print();
    }
    for scene in scenes {
        let terminals = scene.expected().terminals;
        let each = WAYS.map(|way| count(&scene.name(), way) as f64 / terminals as f64);
        table.row(&scene.name(), &ratio_cells(terminals, each, 0));
    }
    table.print();
    sinks(scenes);
}

fn sinks(scenes: &[Box<dyn Scene>]) {
    let mut table = Table::new("Scenes: other sinks, instructions a terminal", &[&["scene"], &SINKS[..]].concat());
    for scene in scenes {
        let terminals = scene.expected().terminals;
        let cells = SINKS.map(|way| number(count(&scene.name(), way) as f64 / terminals as f64, 0));
        table.row(&scene.name(), &cells);
    }
    table.print();
}

/// The number of instructions of one run.
fn count(scene: &str, way: &str) -> u64 {
    let program = std::env::current_exe().expect("the path of this program");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=*counted_by_callgrind*"])
        .arg(program)
        .args([CHILD, scene, way])
        .output()
        .expect("valgrind runs");
    let text = String::from_utf8_lossy(&output.stderr);
    let collected = text.lines().find_map(|line| line.split_once("Collected :")?.1.trim().parse().ok());
    collected.unwrap_or_else(|| panic!("callgrind counted nothing for {scene} {way}:\n{text}"))
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

fn twice(work: &mut dyn FnMut()) {
    work();
    counted_by_callgrind(work);
}

/// Callgrind finds this function by its name.
#[inline(never)]
fn counted_by_callgrind(work: &mut dyn FnMut()) {
    work();
    // Not a tail call: that would leave the function before the work is done.
    black_box(());
}
