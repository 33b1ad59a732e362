//! The main use: from rules to a tower, `tower.glb` and `tower.png`.
//!
//! `cargo run --release --example tower`

use std::error::Error;
use std::time::Instant;

use cga::{Model, Settings, Shape, cga};

cga! {
    /// An office tower on a podium. Every storey is a slab of the mass, and every window has frames and set-back
    /// glass.
    pub grammar Tower;

    /// The height of the whole building in metres.
    @Range(min = 30, max = 200)
    attr height = 74
    /// The height of a storey in metres.
    @Range(min = 2.6, max = 5)
    attr storey = 3.3
    /// The desired width of a bay, in metres. The façade determines the number of bays.
    @Range(min = 1.5, max = 6)
    attr bay = 2.6
    attr stone = "#d9cdb8"
    attr metal = "#3d4348"

    const podium = 9.2
    const crown = 5
    glass = 12% : "#f3d58a" 20% : "#5d7f92" else : "#48697d"

    // The mass: podium, shaft and crown, each a solid cut from the previous one.
    @StartRule
    Lot     --> extrude(height) split(y) { podium : Podium | ~1 : Shaft | crown : Crown }
    Podium  --> split(y) { ~1 : Arcade | 0.5 : Ledge(1.02) }
    Shaft   --> s(^0.84, ^1, ^0.84) center(xz)
                split(y) { { ~storey : Storey }* | 0.5 : Ledge(1.04) }
    Storey  --> split(y) { 0.28 : Band | ~1 : comp(f) { side : Facade } }
    Band    --> s(^1.02, ^1, ^1.02) center(xz) color(stone) Band.
    Ledge(overhang) --> s(^overhang, ^1, ^overhang) center(xz) color(stone) Ledge.
    Crown   --> s(^0.66, ^1, ^0.66) center(xz)
                split(y) { ~1 : comp(f) { side : Louvres } | 0.35 : Ledge(1.06) | 0.001 : Roof }
    Roof    --> s(^0.5, 2.2, ^0.4) center(xz) color(metal) Plant.

    // Ground floor: an arcade of shops behind piers.
    Arcade  --> comp(f) { side : Shopfront | top : color(stone) Terrace. }
    Shopfront --> split(x) { 0.9 : Pier | { ~4.2 : Shop | 0.9 : Pier }* }
    Pier    --> t(0, 0, -0.9) extrude(1.1) color(stone) Pier.
    Shop    --> split(y) { ~1 : Display | 1.6 : Sign }
    Sign    --> t(0, 0, -0.5) extrude(0.55) color(stone) Fascia.
    Display --> t(0, 0, -0.8)
                split(x) { ~1 : Pane("#6f8a94") | 0.1 : Mullion | ~1 : Pane("#6f8a94") | 0.1 : Mullion | ~1 : Pane("#6f8a94") }
    Mullion --> extrude(0.12) color(metal) Mullion.

    // A storey of the shaft: bays between slender piers.
    Facade  --> split(x) { 0.35 : Fin | { ~bay : Bay | 0.35 : Fin }* }
    Fin     --> t(0, 0, -0.3) extrude(0.5) color(stone) Fin.
    Bay     --> split(y) { 0.75 : Spandrel | ~1 : Window }
    Spandrel --> t(0, 0, -0.15) color(metal) Spandrel.
    Window  --> t(0, 0, -0.25)
                split(x) { 0.07 : Frame | ~1 : Sash | 0.07 : Frame }
    Sash    --> split(y) { 0.07 : Frame | ~3 : Pane(glass) | 0.06 : Frame | ~1 : Pane(glass) | 0.07 : Frame }
    Frame   --> extrude(0.12) color(metal) Frame.
    Pane(tint) --> color(tint) set(material.roughness, 0.15) Glass.
    Louvres --> t(0, 0, -0.1) split(y) { { ~0.32 : Slat | 0.2 : color(metal) Gap. }* }
    Slat    --> extrude(0.25) color(stone) Slat.
}

/// A block with cut corners. Its first edge is at the street.
pub(crate) fn lot() -> Result<Shape, cga::Error> {
    let outline =
        [[4.0, 24.0], [28.0, 24.0], [32.0, 20.0], [32.0, 4.0], [28.0, 0.0], [4.0, 0.0], [0.0, 4.0], [0.0, 20.0]];
    Ok(Shape::footprint(&outline, &[])?.seed(7))
}

/// The tower on its lot.
pub(crate) fn model(settings: &Settings) -> Result<Model, cga::Error> {
    Tower::default().generate_with(&lot()?, settings)
}

fn main() -> Result<(), Box<dyn Error>> {
    let begin = Instant::now();
    let model = model(&Settings::default())?;
    let took = begin.elapsed();

    for fault in model.faults() {
        eprintln!("fault: {fault}");
    }
    model.write_glb("tower.glb")?;
    model.write_png("tower.png")?;
    println!("{} shapes, {} leaves", model.report().shapes, model.leaves().len());
    println!("{} triangles in {:.2} ms", model.triangle_count(), took.as_secs_f64() * 1e3);
    println!("wrote tower.glb and tower.png");
    Ok(())
}
