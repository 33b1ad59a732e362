//! Draws the worked examples of the documents as sheets, `out/documented-*.png`: for each a picture, its rules and
//! the resulting pieces. `tests/documented.rs` checks these rules. The sheets mark scopes and pivots where the
//! pictures of the pages do: x red, y green, z blue.
//!
//! The pages are *split operation*, *split attribute*, *splitArea operation*, *Subdivision split*, *comp operation*
//! the pages of roofs, and, with the test texture, the pages on texture coordinates and primitives.
//!
//! `cargo run --release --example documented` also cuts a ball; `-- mesh.obj` cuts that mesh instead.

#[path = "documented/borders.rs"]
mod borders;
#[path = "documented/captions.rs"]
mod captions;
#[path = "documented/marks.rs"]
mod marks;
#[path = "../tests/documented/pages/mod.rs"]
mod pages;
#[path = "documented/real_mesh.rs"]
mod real_mesh;
#[path = "documented/sheet.rs"]
mod sheet;
#[path = "documented/textured.rs"]
mod textured;

use std::error::Error;
use std::path::Path;

use cga::mesh::Bounds;
use cga::sink::picture::{Camera, Image};
use cga::{Model, Settings, Shape};

use captions::{areas, counts, heights, lengths, numbered};
use pages::example::{Example, Mark};
use pages::{cutting, meshes};
use sheet::Cell;

/// The share of the model below which pieces are not drawn: about a tenth of a pixel.
const THINNEST: f64 = 1e-4;

/// One view for all pictures of a sheet, so that they are comparable. x runs to the right and away, as on the pages.
fn camera(bounds: Bounds) -> Camera {
    Camera { margin: 0.04, ..Camera::auto(bounds) }.looking_from(-33.0, 22.0).field_of_view(12.0)
}

/// The view of a row of boxes of that size, the highest box included.
fn row(length: f64, height: f64, depth: f64) -> Camera {
    camera(Shape::cuboid(length, height, depth).to_mesh().bounds())
}

/// The view from above, x to the right and z down.
fn plan(bounds: Bounds) -> Camera {
    Camera::auto(bounds).looking_from(0.0, 90.0).orthographic()
}

fn cell(example: &Example, settings: &Settings, camera: Camera, measured: fn(&Model) -> String) -> Cell {
    let model = example.model(settings);
    let rules = example.rules.split("\n\n").next().unwrap_or_default().trim_end();
    let caption = format!("{}\n\n{rules}\n\n{}", example.title, measured(&model));
    Cell { model: marks::marked(&visible(&model), example), camera, borders: true, caption }
}

/// The model without pieces that are far thinner along x than a pixel. The last piece of a recursive split has no
/// colour, and its end would hide the coloured pieces next to it.
fn visible(model: &Model) -> Model {
    let mut out = Model::new();
    let least = model.bounds().size().max_element() * THINNEST;
    for leaf in model.leaves().filter(|leaf| least <= leaf.size().x.abs() || leaf.size().x == 0.0) {
        let _ = leaf.replay(&mut out);
    }
    out
}

/// A cell of the page *comp operation*.
fn comp_cell(example: &Example, settings: &Settings) -> Cell {
    let bounds = marks::marked(&example.model(settings), example).bounds();
    let view = match example.marks.contains(&Mark::FromAbove) {
        true => plan(bounds),
        false => Camera::auto(bounds).looking_from(azimuth(example), 30.0).field_of_view(16.0),
    };
    cell(example, settings, view, counts)
}

/// The angle of the view. The page shows façades and edges from the front right, other examples from the front left.
fn azimuth(example: &Example) -> f64 {
    let from_the_right = [Mark::InitialPivot, Mark::Pivots("Right"), Mark::Initial];
    if from_the_right.iter().any(|mark| example.marks.contains(mark)) { 40.0 } else { -33.0 }
}

fn area_cell(example: &Example, settings: &Settings) -> Cell {
    let bounds = marks::marked(&example.model(settings), example).bounds();
    let cell = cell(example, settings, plan(bounds), areas);
    Cell { model: borders::with_scopes(&cell.model, 0.003 * bounds.size().x), ..cell }
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
    save("split-operation", sheet(pages::split_operation::ALL, row(10.0, 3.0, 1.0)))?;
    save("subdivision-once", sheet(pages::subdivision_once::ALL, row(5.0, 2.0, 1.0)))?;
    save("subdivision-repeat", sheet(pages::subdivision_repeat::ALL, row(10.0, 3.0, 1.0)))?;

    let measures: [fn(&Model) -> String; 2] = [numbered, heights];
    let cells = pages::split_attribute::ALL.iter().zip(measures).map(|(example, measured)| {
        let bounds = example.model(&plain).bounds();
        cell(example, &plain, camera(bounds), measured)
    });
    save("split-attribute", sheet::draw(&cells.collect::<Vec<_>>(), 2))?;

    let cells: Vec<Cell> = pages::split_area::ALL.iter().map(|example| area_cell(example, &plain)).collect();
    save("split-area", sheet::draw(&cells, 3))?;

    // The cylinder, and the same rules on a hollow cylinder.
    let tube = cutting::settings_with(meshes::lying_tube(cutting::SIDES, [0.3, 0.5], 4.0));
    let view = camera(cutting::cylinder::EXAMPLE.model(&cutting::settings()).bounds());
    let mut cells: Vec<Cell> =
        cutting::ALL.iter().map(|example| cell(example, &cutting::settings(), view, lengths)).collect();
    cells.push(cell(&cutting::cylinder_cut::EXAMPLE, &tube, view, lengths));
    if let Some(last) = cells.last_mut() {
        last.caption = last.caption.replacen('\n', ", on a hollow cylinder\n", 1);
    }
    save("cutting", sheet::draw(&cells, 2))?;

    for (name, examples, columns) in [("comp", pages::comp::ALL, 3), ("components", pages::components::ALL, 4)] {
        let cells: Vec<Cell> = examples.iter().map(|example| comp_cell(example, &plain)).collect();
        save(name, sheet::draw(&cells, columns))?;
    }

    let cells: Vec<Cell> = pages::roofs::ALL.iter().map(|example| comp_cell(example, &plain)).collect();
    save("roofs", sheet::draw(&cells, 4))?;
    let cells: Vec<Cell> = pages::scattering::ALL.iter().map(|example| comp_cell(example, &plain)).collect();
    save("scatter", sheet::draw(&cells, 3))?;

    let cells: Vec<Cell> = pages::setback::ALL.iter().map(|example| comp_cell(example, &plain)).collect();
    save("setback", sheet::draw(&cells, 5))?;

    let cells: Vec<Cell> = pages::tags::ALL.iter().map(|example| comp_cell(example, &plain)).collect();
    save("tags", sheet::draw(&cells, 5))?;

    let cells: Vec<Cell> = pages::mass::ALL.iter().map(|example| comp_cell(example, &cutting::settings())).collect();
    save("mass", sheet::draw(&cells, 4))?;

    let cells: Vec<Cell> =
        pages::recompose::ALL.iter().map(|example| comp_cell(example, &cutting::settings())).collect();
    save("recompose", sheet::draw(&cells, 4))?;
    for (name, examples) in [("boolean", pages::boolean::ALL), ("boolean-table", pages::boolean_table::ALL)] {
        let cells: Vec<Cell> = examples.iter().map(|example| comp_cell(example, &plain)).collect();
        save(name, sheet::draw(&cells, 4))?;
    }

    let cells: Vec<Cell> = pages::mesh_operations::ALL.iter().map(|example| comp_cell(example, &plain)).collect();
    save("mesh-operations", sheet::draw(&cells, 2))?;
    let cells: Vec<Cell> = pages::normals::ALL.iter().map(|example| comp_cell(example, &plain)).collect();
    save("normals", sheet::draw(&cells, 4))?;
    let cells: Vec<Cell> = pages::cleanup::ALL.iter().map(|example| comp_cell(example, &plain)).collect();
    save("cleanup", sheet::draw(&cells, 3))?;

    save("texturing", sheet::draw(&textured::texturing(&plain), 4))?;
    save("primitives", sheet::draw(&textured::primitives(&plain), 4))?;

    let path = std::env::args_os().nth(1);
    save("real-mesh", sheet::draw(&real_mesh::cells(path.as_deref().map(Path::new))?, 2))
}
