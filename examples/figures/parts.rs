//! The picture of `cga-geometry`: a body in 27 closed parts, from its example.

use std::error::Error;
use std::sync::Arc;

use cga::sink::picture::Picture;
use cga::{Settings, Shape, cga};

#[path = "../../cga-geometry/examples/puzzle.rs"]
#[allow(dead_code)]
mod puzzle;

cga! {
    grammar Parts;

    Part --> color(tint()) Part.

    tint = 25% : "#d9825b" 25% : "#e3b261" 25% : "#7fa088" else : "#5c7f9c"
}

/// Draws the picture.
pub(crate) fn draw(path: &str) -> Result<(), Box<dyn Error>> {
    let mesh = Arc::new(puzzle::common::bumps(144, 72)?);
    let parts = puzzle::moved_apart(&mesh, &puzzle::puzzle(&mesh));
    let shapes: Vec<Shape> = (0..).zip(parts).map(|(k, (name, part))| Shape::mesh(part).named(name).seed(k)).collect();
    let model = Parts::default().generate_all(&shapes, &Settings::default())?.to_model();
    Picture::new(1000, 760).looking_from(-32.0, 24.0).render(&model).write_png(path)?;
    Ok(())
}
