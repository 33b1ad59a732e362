//! The house of the README: `cargo run --release --example hello` writes `docs/house.png`.

use cga::sink::picture::Picture;
use cga::{Error, Model, Settings, Shape, cga};

cga! {
    grammar House;
    attr height = 9
    Lot    --> extrude(height) color("#e8dcc0") comp(f) { front : Front | side : Facade | top : roofHip(35, 0.6) color("#9c4a36") Roof. }
    Front  --> split(x) { ~1 : Facade | 2.4 : split(y) { 0.6 : color("#8d8a83") extrude(1) Step. | { ~3 : Level(split.index) }* } | ~1 : Facade }
    Level(n) --> case n == 1 : split(y) { 2.3 : Door | ~1 : Wall. } else : Bay
    Door   --> split(x) { ~1 : Wall. | 1.1 : color("#5b4636") extrude(0.06) Door. | ~1 : Wall. }
    Facade --> split(y) { 0.6 : color("#8d8a83") Plinth. | { ~3 : split(x) { 0.6 : Wall. | { ~2.4 : Bay }* | 0.6 : Wall. } }* }
    Bay    --> offset(-0.6) comp(f) { inside : Window | border : Wall. }
    Window --> offset(-0.1) comp(f) { inside : color("#55788c") Glass. | border : color("#fbf8f1") extrude(0.08) Frame. }
}

/// The house of the picture.
pub(crate) fn model(settings: &Settings) -> Result<Model, Error> {
    House { height: 12.0 }.generate_with(&Shape::rectangle(14.0, 10.0), settings)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = model(&Settings::default())?;
    std::fs::create_dir_all("docs")?;
    Picture::new(900, 560).looking_from(30.0, 12.0).render(&model).write_indexed_png("docs/house.png")?;
    println!("wrote docs/house.png with {} parts", model.len());
    Ok(())
}
