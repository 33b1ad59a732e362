//! The examples with texture coordinates, drawn with the test texture.

use cga::mesh::Bounds;
use cga::sink::picture::Camera;
use cga::{Settings, Shape};

use crate::pages::example::Example;
use crate::pages::{primitives, texturing};
use crate::sheet::Cell;

/// The pages *split operation* (UV split), *tileUV*, *setupProjection*, *texture* and *rotateUV operation*.
pub(crate) fn texturing(settings: &Settings) -> Vec<Cell> {
    texturing::ALL.iter().map(|example| cell(example, settings)).collect()
}

/// The page *primitive operations*. The lot is drawn below, as on the page.
pub(crate) fn primitives(settings: &Settings) -> Vec<Cell> {
    let cells = primitives::ALL.iter().map(|example| {
        let model = example.model(settings);
        let view = |bounds: Bounds| from(bounds, 33.0, 30.0);
        Cell { camera: view(model.bounds()), caption: caption(example), model, borders: true }
    });
    cells.collect()
}

fn cell(example: &Example, settings: &Settings) -> Cell {
    let mut model = example.model(settings);
    for shape in further(example) {
        let other = (example.run)(&shape, settings).unwrap_or_else(|error| panic!("{}: {error}", example.title));
        let _ = other.replay(&mut model);
    }
    let bounds = model.bounds();
    let camera = match example.title {
        title if title.starts_with("tileUV") => Camera::auto(bounds).looking_from(0.0, 90.0).orthographic(),
        title if title.contains("Global") => from(bounds, 0.0, 60.0),
        title if title.contains("Streets") => from(bounds, 20.0, 45.0),
        title if title.contains("w-coordinate") => from(bounds, 30.0, 15.0),
        title if title.contains("Scope vs.") => from(bounds, 0.0, 0.0),
        _ => from(bounds, 30.0, 20.0),
    };
    Cell { model, camera, borders: true, caption: caption(example) }
}

/// The other shapes of the page's picture: a smaller façade, the second segment of the street.
fn further(example: &Example) -> Vec<Shape> {
    match example.title {
        title if title.contains("UV Split Basics") => vec![Shape::rectangle(9.0, 5.0).at([24.0, 0.0, 3.0])],
        title if title.contains("UV Split on Streets") => texturing::two_segments().into_iter().skip(1).collect(),
        _ => Vec::new(),
    }
}

fn from(bounds: Bounds, azimuth: f64, elevation: f64) -> Camera {
    Camera { margin: 0.04, ..Camera::auto(bounds) }.looking_from(azimuth, elevation).field_of_view(20.0)
}

fn caption(example: &Example) -> String {
    let rules = example.rules.split("\n\n").next().unwrap_or_default().trim_end();
    format!("{}\n\n{rules}", example.title)
}
