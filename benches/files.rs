//! Models in memory, GLB files and meshes of models, which users make first, compared with copies of the same bytes.
//!
//! `cargo bench --bench files`; a word after `--` chooses scenes by a part of their name, as in `-- B(4)`.

mod common;
mod workloads;

use std::hint::black_box;
use std::io::Write as _;

use cga::Model;
use cga::sink::buffers::Buffers;
use cga::sink::meshes::Granularity;
use common::clock::{fastest, nanoseconds_each};
use common::table::{Table, number};
use workloads::{Raw, Scene};

/// The seconds for which each row is repeated.
const SECONDS: f64 = 2.0;

fn main() {
    let chosen = std::env::args().skip(1).find(|argument| !argument.starts_with("--"));
    let wanted = |scene: &dyn Scene| match &chosen {
        Some(chosen) => scene.name().contains(chosen.as_str()),
        None => scene.is_main(),
    };
    let columns = [
        "scene",
        "model, ns a leaf",
        "loop, new buffers",
        "buffers, new",
        "to_glb / copy",
        "write_glb / write",
        "meshes() / copy",
        "MB",
        "copy, ms",
        "faults: copy",
        "to_glb",
        "write_glb",
        "meshes()",
    ];
    let mut table = Table::new("Models and files", &columns);
    for mut scene in workloads::all().into_iter().filter(|scene| wanted(&**scene)) {
        row(&mut *scene, &mut table);
    }
    table.print();
}

fn row(scene: &mut dyn Scene, table: &mut Table) {
    workloads::check(scene);
    let mut model = Model::new();
    scene.model(&mut model);
    let leaves = model.len();
    let file = model.to_glb().expect("a file");
    let path = std::env::temp_dir().join(format!("cga-files-{}.glb", std::process::id()));
    let scene = std::cell::RefCell::new(scene);
    let [made, hand, buffers, copy, glb, plain, written, meshes] = fastest(
        SECONDS,
        [
            &mut || {
                let mut model = Model::new();
                scene.borrow_mut().model(&mut model);
                black_box(&model);
            },
            &mut || {
                let mut raw = Raw::default();
                scene.borrow_mut().by_hand(&mut raw);
                black_box(&raw);
            },
            &mut || {
                let mut buffers = Buffers::new();
                scene.borrow_mut().buffers(&mut buffers);
                black_box(&buffers);
            },
            &mut || drop(black_box(file.clone())),
            &mut || drop(black_box(model.to_glb())),
            // Both write new files: a file that replaces another one is on the disk before it gets the name.
            &mut || {
                let _ = std::fs::remove_file(&path);
                let mut out = std::fs::File::create(&path).expect("a file");
                out.write_all(&file).expect("room");
            },
            &mut || {
                let _ = std::fs::remove_file(&path);
                model.write_glb(&path).expect("room");
            },
            &mut || drop(black_box(model.meshes(Granularity::Material))),
        ],
    );
    let _ = std::fs::remove_file(&path);
    let each = |time| number(nanoseconds_each(time, leaves), 1);
    let ratio = |a: std::time::Duration, b: std::time::Duration| number(a.as_secs_f64() / b.as_secs_f64(), 2);
    let faults = [
        page_faults(|| drop(black_box(file.clone()))),
        page_faults(|| drop(black_box(model.to_glb()))),
        page_faults(|| model.write_glb(&path).expect("room")),
        page_faults(|| drop(black_box(model.meshes(Granularity::Material)))),
    ];
    let _ = std::fs::remove_file(&path);
    let mut cells =
        vec![each(made), each(hand), each(buffers), ratio(glb, copy), ratio(written, plain), ratio(meshes, copy)];
    cells.push(number(file.len() as f64 / 1e6, 1));
    cells.push(number(copy.as_secs_f64() * 1e3, 1));
    cells.extend(faults.map(|count| count.map_or("-".to_owned(), |count| count.to_string())));
    table.row(&scene.borrow().name(), &cells);
}

/// The minor page faults of some work, where the system counts them.
fn page_faults(work: impl FnOnce()) -> Option<u64> {
    let count = || {
        let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
        // The tenth field; the second one may contain spaces.
        stat.rsplit_once(')')?.1.split_whitespace().nth(7)?.parse::<u64>().ok()
    };
    let before = count()?;
    work();
    Some(count()? - before)
}
