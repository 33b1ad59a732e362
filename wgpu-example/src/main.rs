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

fn main() -> Result<(), Box<dyn Error>> {
    let model = gallery::model()?;
    // Nearby, single pixels would show through the walls where storeys meet.
    let meshes = model.watertight().meshes(Granularity::Material);
    let pixels = pollster::block_on(draw::draw(&meshes))?;
    let mut png = png::Encoder::new(std::fs::File::create("wgpu.png")?, draw::WIDTH, draw::HEIGHT);
    png.set_color(png::ColorType::Rgba);
    png.write_header()?.write_image_data(&pixels)?;
    println!("wrote wgpu.png: {} leaves", model.len());
    Ok(())
}
