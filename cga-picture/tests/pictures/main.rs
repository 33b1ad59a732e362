//! Pictures from outside: what they show, the leaves at their pixels, bad input, files.

mod files;
mod hostile;
mod looks;

use cga_picture::glam::{DVec3, Vec3};
use cga_picture::{Bounds, Camera, Face, Lines, Paint, PaintId, Renderer, Scene, Viewpoint};

/// The two triangles of a rectangle.
const HALVES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

/// The corners of an upright square of 2 metres about the y axis, with its front to +z.
fn square(z: f64) -> [DVec3; 4] {
    [[-1.0, 0.0], [1.0, 0.0], [1.0, 2.0], [-1.0, 2.0]].map(|[x, y]| DVec3::new(x, y, z))
}

fn color(r: f32, g: f32, b: f32) -> Paint {
    Paint { color: Vec3::new(r, g, b), ..Paint::default() }
}

/// Adds a square as a leaf.
fn add(scene: &mut Scene, z: f64, paint: PaintId, leaf: u32) {
    scene.add_face(&Face { leaf, ..Face::new(&square(z), &HALVES, DVec3::Z, paint) });
}

/// A view from the front that the square at 0 fills, with nothing else.
fn front(side: usize) -> Renderer {
    let camera = Camera { margin: 0.0, ..Camera::auto(Bounds::of(square(0.0))).looking_from(0.0, 0.0).orthographic() };
    Renderer { view: Viewpoint::Camera(camera), ground: false, lines: Lines::None, ..Renderer::new(side, side) }
}
