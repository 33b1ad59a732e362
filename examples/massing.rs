//! The largest volumes that lots allow, and the buildings in them: `massing.glb` and `massing.png`.
//!
//! `cargo run --release --example massing`: ten lots of the same size, each with other operations that make masses.

use std::error::Error;

use cga::sink::picture::Picture;
use cga::{Model, Settings, Shape, cga};

cga! {
    /// Ten ways to fill a lot, one for each start rule.
    pub grammar Massing;

    /// The distance between buildings and the edge of the lot, in metres.
    @Range(min = 0, max = 6)
    attr margin = 3
    /// The height of a storey in metres.
    @Range(min = 2.5, max = 5)
    attr storey = 3.4
    attr stone = "#e9e3d6"
    attr tiles = "#9a5a44"
    attr lawn = "#a9b98a"
    attr glass = "#7d9bab"

    leaves = 40% : "#6d8f4e" 35% : "#587d46" else : "#86a05a"

    /// The volume that the rules of a town allow: upright to a base height, then leaning back.
    @StartRule
    Envelope --> Lot offset(-margin, inside) envelope(normal, 46, 18, 62, 10, 70, 13, 78, 13, 78) Storeys

    /// Two wings at the street and a garden behind them.
    @StartRule
    Corner --> Lot offset(-margin, inside) shapeL(11, 11) { shape : Wings(15) | remainder : Garden(14) }

    /// Three wings around a court that is open to the back.
    @StartRule
    Court --> Lot offset(-margin, inside) shapeU(10, 9, 9) { shape : Wings(18) | remainder : Garden(8) }

    /// Four wings around a courtyard, under one hip roof.
    @StartRule
    Block --> Lot offset(-margin, inside) shapeO(9, 9, 9, 9) { shape : Wings(21) | remainder : Garden(5) }

    /// A tower whose storeys step back.
    @StartRule
    Steps --> Lot offset(-margin, inside) Step(5, 16)
    Step(count, height) -->
        case count > 0 :
            extrude(height) [ Storeys ]
            comp(f) { top : setback(3) { all : Terrace | remainder : Step(count - 1, height * 0.8) } }
        else : color("#c9a24b") taper(9) Spire.

    Terrace --> color(lawn) extrude(0.3) Terrace.

    /// Everything that is inserted by an inlined rule is one shape afterwards, and has one colour.
    @StartRule
    Hall --> Lot offset(-margin, inside) inline { Naves } color("#d8cdbb") Hall.
    Naves --> split(x) { { ~11 : Nave }* }
    Nave --> extrude(9) comp(f) { side : Wall. | top : roofGable(38) Roof. }

    /// A shaft whose slices turn and shrink; they are joined at the points that they had in common.
    @StartRule
    Twist --> Lot offset(-7, inside) extrude(58) inline(recompose) { split(y) { ^0.05 : Slice }* } Storeys
    Slice --> modify(f, noAlign) { top : Turned(split.index + 1) }
    Turned(n) --> r(0, n * 4.5, 0) s(^(1 - n * 0.02), ^1, ^(1 - n * 0.02)) center(xz)

    /// A block of houses of random depth and height along the street, around a garden.
    @StartRule
    Row --> Lot offset(-margin, inside)
            splitAndSetbackPerimeter(0) { ~9 : rand(8, 11) : House(rand(9, 16)) }* { remainder : Garden(6) }
    House(height) --> color(front) extrude(height) comp(f) { side : Front. | top : color(tiles) roofHip(24) Roof. }
    front = 30% : "#e6d3b1" 25% : "#c9d1c8" 25% : "#d9b8a0" else : "#eadfca"

    /// A pavilion between trees that gather around it.
    @StartRule
    Park --> Lot Lawn scatter(surface, 46, gaussian, center, ^0.3) { Tree } Pavilion
    Pavilion --> s(9, ^1, 9) center(xz) primitiveDisk(10) extrude(4)
                 comp(f) { side : Wall. | top : color(tiles) roofHip(28, 1.2) Roof. }

    /// Stalls of a market, strewn over the square.
    @StartRule
    Market --> Lot scatter(surface, 38, uniform) { r(0, rand(360), 0) Stall } NIL
    Stall --> s(2.2, 2.1, 2.8) primitiveCube center(xz)
              comp(f) { top : s(^1.3, ^1.3, 0) center(xy) color(awning) roofGable(30) Awning. | side : Side. }
    awning = 30% : "#b5483c" 30% : "#d9a441" 20% : "#4b7a8c" else : "#f2efe6"

    // The ground of a lot.
    Lot    --> t(0, -0.3, 0) extrude(0.3) color("#cfc9bd") Ground.
    Lawn   --> t(0, 0.05, 0) color(lawn) Lawn.
    Garden(trees) --> Lawn offset(-2, inside) scatter(surface, trees, uniform) { Tree }
    Tree   --> Trunk t(0, 1.6, 0) Crown(rand(2, 3.6))
    Trunk  --> s(0.35, 2, 0.35) primitiveCylinder(8) center(xz) color("#6b5138") Trunk.
    Crown(size) --> s(size, size * 1.25, size) primitiveSphere(10, 7) center(xz) color(leaves) Crown.

    // A mass with floors, and one with a roof.
    Storeys --> split(y) { { ~storey : Storey }* }
    Storey --> split(y) { ~1 : color(glass) Storey. | 0.4 : color(stone) Slab. }
    Wings(height) --> [ extrude(height) Storeys ] t(0, height, 0) color(tiles) roofHip(27, 0.6) Roof.
}

/// The side of a lot and the distance between two, in metres.
const LOT: f64 = 44.0;
const STREET: f64 = 14.0;

/// The start rules and their lots, in two rows.
pub(crate) fn lots() -> impl Iterator<Item = (&'static str, Shape)> {
    let starts = ["Envelope", "Steps", "Twist", "Block", "Hall", "Corner", "Park", "Court", "Row", "Market"];
    starts.into_iter().enumerate().map(|(number, start)| {
        let [column, row] = [number % 5, number / 5].map(|at| at as f64 * (LOT + STREET));
        (start, Shape::rectangle(LOT, LOT).at([column, 0.0, row]).seed(number as u64))
    })
}

/// The building on each lot, with the name of its start rule.
pub(crate) fn models(settings: &Settings) -> Result<Vec<(&'static str, Model)>, cga::Error> {
    let grammar = Massing::default();
    let made = lots().map(|(start, lot)| Ok((start, grammar.generate_with(&lot.start(start), settings)?)));
    made.collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut model = Model::new();
    for (start, made) in models(&Settings::default())? {
        for fault in made.faults() {
            println!("{start}: {fault}");
        }
        println!("{start}: {} parts, {:.0} m³", made.leaves().len(), made.volume());
        model.append(&made);
    }
    Picture::new(1600, 1000).looking_from(-28.0, 32.0).render(&model).write_png("massing.png")?;
    model.write_glb("massing.glb")?;
    println!("{} triangles", model.triangle_count());
    println!("wrote massing.glb and massing.png");
    Ok(())
}
