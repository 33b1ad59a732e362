//! The examples with texture coordinates, drawn with the test texture.

use std::sync::Arc;

use cga::glam::DVec3;
use cga::mesh::Bounds;
use cga::sink::picture::Camera;
use cga::{Color, Leaf, Material, Model, Quad, Scope, Settings, Shape, Sink, Text};

use super::cell::{Cell, LARGE};
use crate::pages::example::Example;
use crate::pages::{primitives, texturing};

cga::cga! {
    /// The initial shape, in grey.
    grammar Initial;
    Start --> color("#70747a") Initial.
}

/// The cells of the pages *split operation* (UV split), *tileUV*, *setupProjection*, *texture* and *rotateUV
/// operation*.
pub fn texturing(settings: &Settings) -> Vec<Cell> {
    texturing::ALL.iter().map(|example| cell(example, settings)).collect()
}

/// The cells of the page *primitive operations*. The lot is drawn below, as on the page.
pub fn primitives(settings: &Settings) -> Vec<Cell> {
    let cells = primitives::ALL.iter().map(|example| {
        let mut model = example.model(settings);
        put_below(&mut model, (example.start)(), settings);
        let view = |bounds: Bounds| from(bounds, 33.0, 30.0);
        let camera = view(model.bounds());
        Cell::new(example, model, camera)
    });
    cells.collect()
}

fn cell(example: &Example, settings: &Settings) -> Cell {
    let mut model = example.model(settings);
    for shape in further(example) {
        let other = (example.run)(&shape, settings).unwrap_or_else(|error| panic!("{}: {error}", example.title));
        let _ = other.replay(&mut model);
    }
    if example.title.ends_with("bands") {
        texturing::two_segments().into_iter().for_each(|shape| put_below(&mut model, shape, settings));
    }
    let bounds = model.bounds();
    if has_borders(example) {
        model = outlined(&model, 0.002 * bounds.size().max_element());
    }
    let camera = match example.title {
        title if title.starts_with("tileUV") => Camera::auto(bounds).looking_from(0.0, 90.0).orthographic(),
        title if title.contains("Global") => from(bounds, 0.0, 60.0),
        title if title.contains("Streets") => from(bounds, 20.0, 45.0),
        title if title.contains("w-coordinate") => from(bounds, 30.0, 15.0),
        title if title.contains("Scope vs.") => from(bounds, 0.0, 0.0),
        _ => from(bounds, 30.0, 20.0),
    };
    Cell { size: LARGE, ..Cell::new(example, model, camera) }
}

/// The other shapes in the page's picture: a smaller façade, the second segment of the street.
fn further(example: &Example) -> Vec<Shape> {
    match example.title {
        title if title.contains("UV Split Basics") => vec![Shape::rectangle(9.0, 5.0).at([24.0, 0.0, 3.0])],
        title if title.contains("UV Split on Streets") => texturing::two_segments().into_iter().skip(1).collect(),
        _ => Vec::new(),
    }
}

/// Draws an initial shape in grey, a little below its results.
fn put_below(model: &mut Model, shape: Shape, settings: &Settings) {
    let below = Initial::default().generate_with(&shape.at([0.0, -0.1, 0.0]), settings);
    let _ = below.expect("an initial shape").replay(model);
}

/// Returns true if the page's picture shows the borders of the pieces or of the faces.
fn has_borders(example: &Example) -> bool {
    ["UV Split", "Street Tiling", "Global"].iter().any(|title| example.title.contains(title))
}

/// The model with black strips of that width along all edges, inside the faces.
fn outlined(model: &Model, width: f64) -> Model {
    let mut out = Model::new();
    let _ = model.replay(&mut out);
    let mut black = Material::default();
    black.color = Some(Color::new(0.0, 0.0, 0.0));
    let material = Arc::new(black);
    for leaf in model.leaves() {
        let (mesh, placement) = leaf.mesh();
        for face in mesh.faces() {
            let corner = |at: usize| placement.transform_point3(mesh.points()[mesh.corners()[at] as usize]);
            let points: Vec<DVec3> = face.corner_range().map(corner).collect();
            let normal = placement.transform_vector3(face.normal()).normalize_or_zero();
            for (from, to) in points.iter().zip(points.iter().cycle().skip(1)) {
                let (along, lift) = (*to - *from, normal * width);
                let strip = Quad::new(*from + 0.2 * lift, along, normal.cross(along.normalize_or_zero()) * width);
                let scope = Scope { origin: strip.origin, ..leaf.scope() };
                let _ = out.quad(&Leaf::new(&Text::fixed("Edge"), &material, &scope), &strip);
            }
        }
    }
    out
}

fn from(bounds: Bounds, azimuth: f64, elevation: f64) -> Camera {
    Camera { margin: 0.04, ..Camera::auto(bounds) }.looking_from(azimuth, elevation).field_of_view(20.0)
}
