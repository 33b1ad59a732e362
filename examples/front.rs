//! A house front with piers, set-back windows and a cornice: `docs/front.png`.
//!
//! `cargo run --release --example front`

use cga::sink::picture::Picture;
use cga::{Error, Grammar, Model, Settings, Shape, cga};

cga! {
    grammar House;
    attr height = 17
    Lot     --> extrude(height) split(y) { 4 : Walls("#31424c", true) | 0.35 : Ledge | { ~3.2 : Walls("#56788c", false) }* | 0.6 : Cornice }
    Ledge   --> s(scope.sx + 0.8, ^1, scope.sz + 0.8) center(xz) color("#8c4a3a") Ledge.
    Cornice --> s(^1.05, ^1, ^1.07) center(xz) color("#8c4a3a") Cornice.
    Walls(tint, hasDoor) --> color("#cdb892") comp(f) { front : Floor(tint, hasDoor) | side : Floor(tint, false) }
    Floor(tint, hasDoor) -->
        split(x) { 0.5 : Wall. | { 0.7 : Pier | ~2.4 : Bay(tint, hasDoor && split.index == (split.total - 1) / 2) }* | 0.7 : Pier | 0.5 : Wall. }
    Pier    --> color("#e3d5bb") extrude(0.22) Pier.
    Bay(tint, isEntrance) -->
        case isEntrance : split(y) { 2.5 : Door | ~1 : Window(tint) | 0.35 : Wall. }
        else            : split(y) { 0.8 : Wall. | ~1 : Window(tint) | 0.35 : Wall. }
    Door    --> [ t(0, 0, -0.2) color("#6b3226") Door. ] color("#f5f1e6") split(x) { 0.1 : Frame | ~1 : NIL | 0.06 : Frame | ~1 : NIL | 0.1 : Frame }
    Window(tint) --> [ t(0, 0, -0.2) color(tint) Glass. ] color("#f5f1e6") split(x) { 0.1 : Frame | ~1 : Bars | 0.1 : Frame }
    Bars    --> split(y) { 0.1 : Frame | ~2 : NIL | 0.08 : Frame | ~1 : NIL | 0.1 : Frame }
    Frame   --> t(0, 0, -0.2) extrude(0.26) Frame.
}

/// The grammar, for programs that compare it with others.
pub(crate) fn house(height: f64) -> Box<dyn Grammar> {
    Box::new(House { height })
}

/// The house of the picture.
pub(crate) fn model(settings: &Settings) -> Result<Model, Error> {
    house(20.0).generate_with(&Shape::rectangle(16.0, 11.0), settings)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = model(&Settings::default())?;
    std::fs::create_dir_all("docs")?;
    Picture::new(1000, 700).looking_from(28.0, 14.0).render(&model).write_indexed_png("docs/front.png")?;
    println!("wrote docs/front.png");
    Ok(())
}
