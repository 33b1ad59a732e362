//! The materials of the gallery as images: `out/materials`, and a picture of all of them, `docs/gallery/materials.png`.
//!
//! `cargo run --release --example materials`
//!
//! Rules of the gallery name these images. Give them to a run with `Assets::below("out/materials")`.

#[path = "materials/mod.rs"]
mod library;

use std::error::Error;
use std::path::Path;

use cga::sink::picture::{Lines, Picture};
use cga::{Model, Settings, Shape, cga};

cga! {
    /// A block for each material.
    @Allow(missing_asset)
    grammar Samples;

    const names = ["brick_red", "brick_brown", "brick_yellow", "stone", "plaster", "paving", "tile", "slate", "grass", "asphalt", "bark", "leaves", "water"]
    const tints = ["#ffffff", "#ffffff", "#ffffff", "#e0d6c2", "#e8cfa4", "#cfc8bb", "#b5593f", "#66707c", "#8aa862", "#6a6b70", "#7d6249", "#7da052", "#5d8fa3"]
    family(name) = case find(name, "_", 0) < 0 : name else : substring(name, 0, find(name, "_", 0))

    @StartRule
    Lot      --> split(z) { 2 : Row(7, 6, 2.6) | 1.2 : NIL | 2 : Row(0, 7, 1.3) }
    Row(first, count, height) --> s(count * 2.3, ^1, ^1) center(x) split(x) { { 2 : Sample(first + split.index / 2, height) | 0.3 : NIL }* }
    Sample(n, height) --> extrude(height) color(tints[n]) Look(names[n])
    Look(name) --> texture(name + ".png") set(material.normalmap, family(name) + "_normal.png") set(material.roughnessmap, family(name) + "_rough.png") Body
    Body     --> comp(f) { front : setupProjection(0, scope.xy, 1.8, 1.2) projectUV(0) Wall. | all : setupProjection(0, scope.xy, 1.8, 1.8) projectUV(0) Wall. }
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new("out/materials");
    std::fs::create_dir_all(folder)?;
    for (name, image) in library::images() {
        image.write_png(folder.join(name))?;
    }
    let settings = Settings { assets: library::assets(), ..Settings::default() };
    let model: Model = Samples::default().generate_with(&Shape::rectangle(16.0, 5.2), &settings)?;
    model.faults().iter().for_each(|fault| eprintln!("fault: {fault}"));
    let mut picture = Picture::new(1200, 640).looking_from(20.0, 24.0);
    picture.lines = Lines::None;
    picture.render(&model).write_indexed_png("docs/gallery/materials.png")?;
    println!("wrote out/materials and docs/gallery/materials.png");
    Ok(())
}
