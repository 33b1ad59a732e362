//! A city of 288 lots, each with a kind and a height, as the rows of a map have them: `lots.glb` and `lots.png`.

use std::error::Error;

use cga::{Batches, Grammars, Model, RunError, Settings, Shape, cga};

cga! {
    /// A house in a garden.
    grammar House;
    /// The height of the eaves in metres.
    @Range(min = 2.5, max = 40, restricted = true)
    attr height = 6
    wall = 40% : "#e6d3b1" 30% : "#d9b8a0" else : "#cfc6bd"
    roof = 60% : "#9a5a44" else : "#5d5f63"

    @StartRule
    Lot    --> offset(-2.5) comp(f) { inside : House | border : color("#8aa465") Lawn. }
    House  --> color(wall) extrude(height) comp(f) { side : Facade | top : color(roof) roofHip(34, 0.4) Roof. }
    Facade --> split(y) { { ~3 : split(x) { ~0.6 : Wall. | { ~2.8 : Bay }* | ~0.6 : Wall. } }* }
    Bay    --> split(x) { ~1 : Wall. | 1.1 : split(y) { ~0.9 : Wall. | ~1.4 : Window | ~0.6 : Wall. } | ~1 : Wall. }
    Window --> [ Recess(0.15) ] t(0, 0, -0.15) color("#5b7583") Glass.
    Recess(depth) --> set(trim.vertical, false) t(0, 0, -depth) s(^1, ^1, depth) primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : Reveal. }
}

cga! {
    /// A block with shops on the ground floor and a flat roof.
    grammar Block;
    /// The height in metres.
    @Range(min = 6, max = 80, restricted = true)
    attr height = 15
    wall = 50% : "#b9a58e" 30% : "#a7a9a5" else : "#9c6b56"

    @StartRule
    Lot    --> offset(-0.8) comp(f) { inside : Block | border : color("#b7b2a8") Pavement. }
    Block  --> color(wall) extrude(height) comp(f) { side : Facade | top : Roof }
    Facade --> split(y) { 4 : Shops | { ~3.2 : Floor }* | 0.8 : Wall. }
    Shops  --> split(x) { ~0.4 : Wall. | { ~3.6 : Glass(0.3) | 0.4 : Wall. }* }
    Floor  --> split(x) { ~0.4 : Wall. | { ~1.9 : split(y) { ~0.8 : Wall. | ~2 : Glass(0.2) | ~0.3 : Wall. } | 0.4 : Wall. }* }
    Glass(depth) --> [ Recess(depth) ] t(0, 0, -depth) color("#4f6672") Glass.
    Recess(depth) --> set(trim.vertical, false) t(0, 0, -depth) s(^1, ^1, depth) primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : Reveal. }
    Roof   --> color("#8d8f8c") offset(-0.4) comp(f) { inside : Roof. | border : color("#cfc9bd") extrude(0.7) Parapet. }
}

cga! {
    /// A lawn with trees.
    grammar Park;
    /// The height of the trees in metres.
    @Range(min = 2, max = 40, restricted = true)
    attr height = 8

    @StartRule
    Lot    --> color("#7f9f5b") [ Lawn. ] offset(-height / 4, inside) scatter(surface, geometry.area / 10, gaussian) { Tree(height * rand(0.6, 1)) }
    Tree(h) --> [ s(0.3, h * 0.5, 0.3) center(xz) primitiveCylinder(8) color("#6b5240") Trunk. ]
                t(0, h * 0.3, 0) s(h * 0.5, h * 0.7, h * 0.5) center(xz) primitiveSphere(12, 8) color("#5f8148") Crown.
}

cga! {
    /// The ground between the lots.
    grammar Land;
    Lot --> color("#8b8c8f") extrude(0.1) Street.
}

/// The buildings on all lots, and the ground below them.
pub(crate) fn model(settings: &Settings) -> Result<Batches<Model>, RunError> {
    let lot = |number: u32| {
        let (column, row) = (number % 24, number / 24);
        let place = [column * 16 + column / 4 * 12, 0, row * 20 + row / 2 * 12].map(f64::from);
        let lot = Shape::rectangle(16.0, 20.0).at(place).seed(number.into()).named(format!("lot {number}"));
        lot.grammar(["House", "Block", "House", "Park"][number as usize * 7 / 3 % 4])
            .attribute("height", 6 + number % 13)
    };
    let land = Shape::rectangle(468.0, 324.0).at([-12.0, -0.2, -12.0]).grammar("Land");
    let lots: Vec<Shape> = (0..288).map(lot).chain([land]).collect();
    let city =
        Grammars::new().with(Land::default()).with(House::default()).with(Block::default()).with(Park::default());
    city.generate_all(&lots, settings)
}

fn main() -> Result<(), Box<dyn Error>> {
    let models = model(&Settings::default())?;
    models.write_glb("lots.glb")?;
    models.write_png("lots.png")?;
    Ok(())
}
