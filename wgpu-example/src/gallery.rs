//! The corner house of the gallery, with its rules in `examples/scenes/corner.rs`.
#![allow(dead_code, reason = "the gallery uses the rest")]

#[path = "../../examples/scenes/corner.rs"]
mod corner;
#[path = "../../examples/materials/mod.rs"]
mod materials;
#[path = "../../examples/scenes/scene.rs"]
mod scene;

use cga::Model;
use corner::{Corner, scene};

pub(crate) fn model() -> Result<Model, cga::Error> {
    scene().with(Box::new(Corner::default())).model()
}
