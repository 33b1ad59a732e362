//! Draws a house of the gallery with light and shadow, without a window and without an engine: `wgpu.png`.
//!
//! `Model::meshes` gives one mesh for each material.

mod draw;
mod gallery;
mod gpu;
#[cfg(test)]
mod tests;

use std::error::Error;

use cga::sink::meshes::Granularity;
use cga::sink::picture::Image;

fn main() -> Result<(), Box<dyn Error>> {
    let model = gallery::model()?;
    // Nearby, single pixels would show through the walls where storeys meet.
    let meshes = model.watertight().meshes(Granularity::Material);
    let rgba = pollster::block_on(draw::draw(&meshes))?;
    Image { width: draw::WIDTH as usize, height: draw::HEIGHT as usize, rgba }.write_indexed_png("wgpu.png")?;
    println!("wrote wgpu.png: {} leaves", model.len());
    Ok(())
}
