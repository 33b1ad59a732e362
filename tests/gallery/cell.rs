//! A picture of a model with its rules, and the views of the pages.

use cga::mesh::Bounds;
use cga::sink::picture::{Camera, Image, Lines, Picture};
use cga::{Model, Settings, Shape};

use super::borders;
use super::captions::{areas, counts};
use super::marks;
use crate::pages::example::{Example, Mark};

/// A picture, and the text beside it.
pub struct Cell {
    pub title: &'static str,
    pub rules: &'static str,
    /// The rules that the page gives once for all its examples.
    pub further: &'static str,
    /// The measures of the pieces.
    pub measured: String,
    pub model: Model,
    pub camera: Camera,
    /// The size of the picture in pixels.
    pub size: [usize; 2],
    /// True to draw the borders of all faces, and all lines strongly.
    pub borders: bool,
}

/// The size of most pictures.
const SMALL: [usize; 2] = [480, 270];
/// The size of pictures whose numbers can be read.
pub const LARGE: [usize; 2] = [544, 306];

/// One colour in place of the sky, so that faces and lines stand out, and files are small.
const BACKDROP: [f32; 3] = [0.78, 0.79, 0.80];

/// The share of the model below which pieces are not drawn: about a tenth of a pixel.
const THINNEST: f64 = 1e-4;

impl Cell {
    pub fn new(example: &Example, model: Model, camera: Camera) -> Self {
        let (title, (rules, further)) = (example.title, example.shown_and_further());
        Cell { title, rules, further, measured: String::new(), model, camera, size: SMALL, borders: false }
    }

    #[allow(dead_code, reason = "the test of the text draws nothing")]
    pub fn picture(&self) -> Image {
        let [width, height] = self.size;
        let mut picture = Picture::new(width, height);
        picture.style.backdrop = [BACKDROP; 2];
        if self.borders {
            picture.lines = Lines::Faces;
            picture.style.line_opacity = 0.9;
        }
        picture.camera(self.camera).render(&self.model)
    }
}

/// One view for all pictures of a chapter, so that they are comparable. x runs to the right and away, as on the pages.
pub fn camera(bounds: Bounds) -> Camera {
    Camera { margin: 0.04, ..Camera::auto(bounds) }.looking_from(-33.0, 22.0).field_of_view(12.0)
}

/// The view of a row of boxes of that size, the highest box included.
pub fn row(length: f64, height: f64, depth: f64) -> Camera {
    camera(Shape::cuboid(length, height, depth).to_mesh().bounds())
}

/// The view from above, x to the right and z down.
fn plan(bounds: Bounds) -> Camera {
    Camera::auto(bounds).looking_from(0.0, 90.0).orthographic()
}

pub fn cell(example: &Example, settings: &Settings, camera: Camera, measured: fn(&Model) -> String) -> Cell {
    let model = example.model(settings);
    let marked = marks::marked(&visible(&model), example);
    Cell { borders: true, measured: measured(&model), ..Cell::new(example, marked, camera) }
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

/// A cell in the view of the page *comp operation*.
pub fn comp_cell(example: &Example, settings: &Settings) -> Cell {
    let bounds = marks::marked(&example.model(settings), example).bounds();
    let view = match example.marks.contains(&Mark::FromAbove) {
        true => plan(bounds),
        false => {
            let (azimuth, elevation) = direction(example);
            Camera::auto(bounds).looking_from(azimuth, elevation).field_of_view(16.0)
        }
    };
    // Lines would hide how normals shade facets.
    let borders = !example.title.contains("Normals operation") || example.marks.contains(&Mark::Backs);
    Cell { borders, ..cell(example, settings, view, counts) }
}

/// The azimuth and the elevation of the view. The page shows façades and edges from the front right, other examples from the front left.
fn direction(example: &Example) -> (f64, f64) {
    let own = example
        .marks
        .iter()
        .find_map(|mark| if let Mark::From(azimuth, elevation) = *mark { Some((azimuth, elevation)) } else { None });
    let from_the_right = [Mark::InitialPivot, Mark::Pivots("Right"), Mark::Initial];
    let is_from_the_right = from_the_right.iter().any(|mark| example.marks.contains(mark));
    own.unwrap_or(if is_from_the_right { (40.0, 30.0) } else { (-33.0, 30.0) })
}

pub fn area_cell(example: &Example, settings: &Settings) -> Cell {
    let bounds = marks::marked(&example.model(settings), example).bounds();
    let cell = cell(example, settings, plan(bounds), areas);
    Cell { model: borders::with_scopes(&cell.model, 0.003 * bounds.size().x), ..cell }
}
