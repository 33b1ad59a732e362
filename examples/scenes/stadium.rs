//! A football stadium.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A bowl of stands around a pitch, under a ring of glass on columns.
    pub grammar Stadium;

    /// The rows of the lower tier.
    @Group("Stands", 1) @Order(1) @Range(min = 4, max = 24, stepsize = 1)
    attr lower = 14
    /// The rows of the upper tier.
    @Order(2) @Range(min = 0, max = 24, stepsize = 1)
    attr upper = 12
    /// The height of a step of the upper tier in metres; the lower tier is half as steep.
    @Order(3) @Distance @Range(min = 0.4, max = 1)
    attr rise = 0.75
    /// The number of sides of the oval.
    @Order(4) @Range(min = 16, max = 120, stepsize = 8)
    attr sides = 72
    /// The share of the stands below the roof.
    @Group("Roof", 2) @Order(1) @Percent @Range(min = 0.2, max = 1)
    attr cover = 0.85
    /// The share of light that the glass lets through.
    @Order(2) @Percent @Range(min = 0, max = 1)
    attr clearness = 0.6
    @Group("Colours", 3) @Color
    attr seats = "#c23b3b"
    @Color
    attr stripe = "#f1ede4"
    @Color
    attr grass = "#74b55c"

    const run = 0.85
    // Between the tiers is a row of boxes.
    const boxes = 3.2
    const below = 2 + lower * rise / 2
    const top = below + boxes + upper * rise
    const depth = (lower + upper) * run
    // The roof falls from its inner ring to the columns.
    const fall = cover * depth * sin(8)
    const eaves = top + 6
    height(n) = case n < upper : top - n * rise else : below - (n - upper) * rise / 2

    @StartRule
    Lot     --> [ extrude(0.2) color("#dad5ca") texture("paving.png") set(material.normalmap, "paving_normal.png") set(material.roughnessmap, "paving_rough.png")
                modify(f) { side : setupProjection(0, scope.xy, 3.6, 3.2) projectUV(0) | all : setupProjection(0, world.xz, 3.6, 3.2) projectUV(0) } Plaza. ]
                t(0, 0.2, 0) s(scope.sx - 24, 0, scope.sz - 24) center(xz) primitiveDisk(sides) deleteUV(0) Oval
    Oval    --> Row(0)
                [ extrude(top + 1) comp(f) { side : Facade(comp.index) | all : NIL } ]
                t(0, eaves + fall, 0) offset(-cover * depth, border) comp(f) { all : Roof(comp.index) }

    // A row is a step along the edge; the next row is inside it, one step lower.
    Row(n)  --> case n < lower + upper : offset(-run) comp(f) { border : Step(n, comp.index) | inside : Row(n + 1) }
                else                   : Arena
    Step(n, sector) --> extrude(height(n)) comp(f) { top : color(tint(n, sector)) Seats. | all : color("#d9d6d0") Concrete. }
    tint(n, sector) = case sector % 6 == 0 || n == upper : "#d9d6d0"
                      case sector % 6 == 3 && n > upper  : stripe
                      else                               : seats

    // The field is smaller than the largest rectangle, so its corners are clear of the stands.
    Arena   --> alignScopeToAxes(y) [ t(0, 0.02, 0) color("#b9735a") Track. ] innerRectangle(scope) { shape : Field | remainder : NIL }
    Field   --> t(0, 0.05, 0) s(^0.92, 0, ^0.92) center(xz) [ color(grass) split(x) { { ~8 : Grass(split.index % 2) }* } ]
                s(scope.sx - 4, 0, scope.sz - 4) center(xz) color(stripe) t(0, 0.05, 0)
                [ Outline ] [ split(x) { ~1 : NIL | 0.4 : Line. | ~1 : NIL } ]
                [ s(18.3, 0, 18.3) center(xz) primitiveDisk(40) Outline ]
                split(x) { 16.5 : Box | ~1 : NIL | 16.5 : Box }
    Grass(dark) --> setupProjection(0, world.xz, 4, 4) texture("grass.png") set(material.normalmap, "grass_normal.png") projectUV(0) Mown(dark)
    Mown(dark) --> case dark == 1 : color("#5f9d4c") Grass. else : Grass.
    Box     --> s(^1, 0, 40.3) center(z) Outline
    Outline --> offset(-0.4, border) Line.

    // Columns and bands of metal outside, one bay for each side of the oval.
    Facade(n) --> split(y) { 6.5 : Gate(n) | { 0.5 : NIL | ~1.1 : color("#e8e6e1") extrude(0.5) Band. }* }
    Gate(n) --> split(x) { 0.7 : color("#8d9297") extrude(1.2) Pier. | ~1 : t(0, 0, 0.05) color(case n % 4 == 1 : seats else : "#46535b") Gate. }

    // A panel of glass with a rim for each bay, and a column at every third.
    Roof(n) --> [ r(-8, 0, 0) color("#e6eef0") [ set(material.opacity, 1 - clearness) Glass. ]
                  offset(-0.3, border) color("#f4f3ef") extrude(0.4) Rim. ]
                [ case n % 3 == 0 : Column else : NIL ]
    Column  --> set(trim.vertical, false) alignScopeToAxes(y) t(0, -eaves - fall, 0) s(0.9, eaves, 0.9) primitiveCylinder(12) color("#f4f3ef") Column.
}

pub fn scene() -> Scene<()> {
    Scene {
        name: "stadium",
        title: "Stadium",
        sentence: "A recursive rule offsets the oval inwards, one step for each row of seats, and the roof is one more offset.",
        rules: grammar_text(include_str!("stadium.rs")),
        grammar: (),
        shapes: vec![Start::new("Lot", Shape::rectangle(210.0, 170.0))],
        view: View {
            azimuth: 28.0,
            elevation: 30.0,
            region: Some([[14.0, 0.0, 12.0], [196.0, 27.0, 148.0]]),
            ..View::default()
        },
    }
}
