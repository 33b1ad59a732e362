//! Draws the worked examples of the documents as sheets, `out/documented-*.png`: a picture each, its rules and the pieces
//! that come out. The rules are those that `tests/documented.rs` checks.
//!
//! `cargo run --release --example documented` also cuts a ball; `-- mesh.obj` cuts that mesh instead.

#[path = "../tests/documented/pages/mod.rs"]
mod pages;
#[path = "documented/real_mesh.rs"]
mod real_mesh;
#[path = "documented/sheet.rs"]
mod sheet;

use std::error::Error;
use std::path::Path;

use cga::mesh::Bounds;
use cga::sink::picture::{Camera, Image};
use cga::{Model, Settings, Shape};

use pages::example::Example;
use pages::{comp, cutting, meshes, split_operation, subdivision_once, subdivision_repeat};
use sheet::Cell;

/// One view for all pictures of a sheet, so that they can be compared: x runs to the right and away, as on the pages.
fn camera(bounds: Bounds) -> Camera {
    Camera { margin: 0.04, ..Camera::auto(bounds) }.looking_from(-33.0, 22.0).field_of_view(12.0)
}

/// What a row of boxes of that size fills, the highest box included.
fn row(length: f64, height: f64, depth: f64) -> Camera {
    camera(Shape::cuboid(length, height, depth).to_mesh().bounds())
}

fn cell(example: &Example, settings: &Settings, camera: Camera, measured: fn(&Model) -> String) -> Cell {
    let model = example.model(settings);
    let rules = example.rules.split("\n\n").next().unwrap_or_default().trim_end();
    let caption = format!("{}\n\n{rules}\n\n{}", example.title, measured(&model));
    Cell { model, camera, borders: true, caption }
}

/// `2 x X 3 | Y 0.5`, the pieces from the low end on: how many, the rule, the length. Of very many only how many.
fn lengths(model: &Model) -> String {
    if 30 < model.len() {
        return counts(model);
    }
    let mut runs: Vec<(usize, String)> = Vec::new();
    for leaf in model.leaves() {
        let piece = format!("{} {}", leaf.rule(), short(leaf.size().x));
        match runs.last_mut() {
            Some((count, last)) if *last == piece => *count += 1,
            _ => runs.push((1, piece)),
        }
    }
    let shown = runs.iter().map(|(count, piece)| match count {
        1 => piece.clone(),
        _ => format!("{count} x {piece}"),
    });
    shown.collect::<Vec<_>>().join(" | ")
}

fn counts(model: &Model) -> String {
    model.counts().iter().map(|(rule, count)| format!("{count} {rule}")).collect::<Vec<_>>().join(", ")
}

fn short(number: f64) -> String {
    let text = format!("{number:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn main() -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all("out")?;
    let plain = Settings::default();
    let save = |name: &str, image: Image| -> Result<(), Box<dyn Error>> {
        let path = format!("out/documented-{name}.png");
        image.write_png(&path)?;
        println!("wrote {path}");
        Ok(())
    };
    let sheet = |examples: &[Example], camera: Camera| {
        let cells: Vec<Cell> = examples.iter().map(|example| cell(example, &plain, camera, lengths)).collect();
        sheet::draw(&cells, 3)
    };
    save("split-operation", sheet(split_operation::ALL, row(10.0, 3.0, 1.0)))?;
    save("subdivision-once", sheet(subdivision_once::ALL, row(5.0, 2.0, 1.0)))?;
    save("subdivision-repeat", sheet(subdivision_repeat::ALL, row(10.0, 3.0, 1.0)))?;

    // The cylinder, and the same rules on a hollow one.
    let tube = cutting::settings_with(meshes::lying_tube(cutting::SIDES, [0.3, 0.5], 4.0));
    let view = row(10.0, 3.0, 2.0);
    let mut cells: Vec<Cell> =
        cutting::ALL.iter().map(|example| cell(example, &cutting::settings(), view, lengths)).collect();
    cells.push(cell(&cutting::cylinder_cut::EXAMPLE, &tube, view, lengths));
    if let Some(last) = cells.last_mut() {
        last.caption = last.caption.replacen('\n', ", on a hollow cylinder\n", 1);
    }
    save("cutting", sheet::draw(&cells, 2))?;

    let views = comp::ALL.iter().map(|example| {
        let bounds = example.model(&plain).bounds();
        cell(example, &plain, Camera::auto(bounds).looking_from(-33.0, 30.0).field_of_view(16.0), counts)
    });
    save("comp", sheet::draw(&views.collect::<Vec<_>>(), 2))?;

    let path = std::env::args_os().nth(1);
    save("real-mesh", sheet::draw(&real_mesh::cells(path.as_deref().map(Path::new))?, 2))
}
