//! A Doric temple.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A Doric temple. The height of its columns decides all other sizes, as in the orders of the books.
    pub grammar Temple;

    /// The height of the columns in metres.
    @Group("Order", 1) @Order(1) @Distance @Range(min = 4, max = 14)
    attr column = 8.4
    /// The height of a column in diameters of its foot.
    @Order(2) @Range(min = 4, max = 9)
    attr slimness = 5.6
    /// The space from axis to axis, in diameters. The outline determines the number of columns.
    @Order(3) @Range(min = 1.8, max = 4)
    attr spacing = 2.4
    /// The diameter of a column at its head, as a share of its diameter at the foot.
    @Order(4) @Percent @Range(min = 0.6, max = 1)
    attr diminution = 0.76
    /// The slope of the roof in degrees.
    @Order(5) @Angle @Range(min = 8, max = 30)
    attr pitch = 15
    /// The number of steps.
    @Group("Steps", 2) @Range(min = 1, max = 8, stepsize = 1)
    attr steps = 3
    @Group("Colours", 3) @Color
    attr marble = "#efe6d3"
    @Color
    attr paint = "#3f6f93"
    @Color
    attr tiles = "#c08a68"

    foot = column / slimness
    step = foot * 0.24
    // From axis to axis. The spaces along a side are an odd number, so one is before the door.
    axes(length) = length / odd(length / (foot * spacing))
    odd(number) = 2 * rint((number - 1) / 2) + 1

    @StartRule
    Lot     --> color(marble) Step(steps)
    // Each step is smaller than the one below by a tread on all sides.
    Step(n) --> case n > 0 : [ extrude(step) Step. ] t(0, step, 0) offset(-step * 1.3, inside) Step(n - 1)
                else       : Floor
    Floor   --> [ offset(-foot * 2.6, inside) Cella ]
                [ Colonnade ]
                t(0, column, 0) offset(foot * 0.05, inside) Entablature

    // Columns along all edges: a ring of squares, and a column in each.
    Colonnade --> split(z) { foot : Row | ~1 : split(x) { foot : Wing | ~1 : NIL | foot : Wing } | foot : Row }
    Row     --> split(x) { foot : Column | { ~axes(scope.sx - foot) - foot : NIL | foot : Column }* }
    Wing    --> split(z) { ~axes(scope.sz + foot) - foot : NIL | { foot : Column | ~axes(scope.sz + foot) - foot : NIL }* }

    // A shaft of twenty flat flutes swells a little: each third is less steep than the one above it.
    Column  --> [ s(^1, column - foot * 0.5, ^1) primitiveCylinder(20)
                  inline(recompose) { split(y) { ^0.34 : Drum(1, 0.97) | ^0.33 : Drum(0.97, 0.89) | ~1 : Drum(0.89, diminution) } } Shaft. ]
                t(0, column - foot * 0.5, 0) [ Echinus ] t(0, foot * 0.25, 0) s(^1.16, foot * 0.25, ^1.16) center(xz) primitiveCube Abacus.
    Drum(low, high) --> s(^low, ^1, ^low) center(xz) modify(f) { top : s(^(high / low), ^(high / low), ^1) center(xy) }
    Echinus --> s(^(diminution), foot * 0.25, ^(diminution)) center(xz) primitiveCylinder(20)
                modify(f) { top : s(^(1.1 / diminution), ^(1.1 / diminution), ^1) center(xy) } Echinus.

    // Architrave, frieze and cornice; then the gable roof with its pediments.
    Entablature --> [ offset(-foot * 0.1, inside) extrude(foot * 0.75) Architrave. ]
                t(0, foot * 0.75, 0) [ extrude(foot * 0.8) comp(f) { side : Frieze | all : Frieze. } ]
                t(0, foot * 0.8, 0) offset(foot * 0.35, inside) [ extrude(foot * 0.22) Cornice. ]
                t(0, foot * 0.22, 0) roofGable(pitch, foot * 0.1, foot * 0.1) Roof
    // A triglyph over the axis of each column, and one over each space.
    Frieze  --> split(x) { foot * 0.3 : Metope | foot * 0.5 : Triglyph | { ~axes(scope.sx - foot * 1.1) / 2 - foot * 0.5 : Metope | foot * 0.5 : Triglyph }* | foot * 0.3 : Metope }
    Metope  --> color("#f3ecdd") Metope.
    Triglyph --> color(paint) [ Ground. ] extrude(foot * 0.08) split(x) { ~1 : Glyph. | ~0.6 : NIL | ~1 : Glyph. | ~0.6 : NIL | ~1 : Glyph. }
    Roof    --> comp(f) { vertical : Pediment | bottom : Soffit. | all : setupProjection(0, scope.xy, 2, 2) color(tiles) extrude(foot * 0.1)
                texture("tile.png") set(material.normalmap, "tile_normal.png") set(material.roughnessmap, "tile_rough.png") modify(f) { top : projectUV(0) | all : setupProjection(0, scope.xy, 2, 2) projectUV(0) } Tiles. }
    Pediment --> [ offset(-foot * 0.3, border) extrude(foot * 0.25) Geison. ] color("#9c4f42") Tympanum.

    // The walls of the cella, with a door at the front.
    Cella   --> extrude(column) comp(f) { front : Porch | side : Wall | all : NIL }
    Wall    --> setupProjection(0, scope.xy, 2.7, 1.8) texture("stone.png") set(material.normalmap, "stone_normal.png") set(material.roughnessmap, "stone_rough.png") projectUV(0) Wall.
    Porch   --> split(x) { ~1 : Wall | ^0.32 : split(y) { ^0.72 : Door | ~1 : Wall } | ~1 : Wall }
    Door    --> offset(-foot * 0.2)
                comp(f) { border : extrude(foot * 0.12) Frame. | inside : [ Recess(0.4) ] t(0, 0, -0.4) color("#6d4a2e") split(x) { ~1 : Leaf. | 0.06 : extrude(0.05) Leaf. | ~1 : Leaf. } }
    Recess(depth) --> set(trim.vertical, false) t(0, 0, -depth) s(^1, ^1, depth) primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : Reveal. }
}

pub fn scene() -> Scene<()> {
    Scene {
        name: "temple",
        title: "Temple",
        sentence: "All sizes follow from the column, so another order is a change of three numbers.",
        rules: grammar_text(include_str!("temple.rs")),
        grammar: (),
        shapes: vec![Start::new("Lot", Shape::rectangle(22.4, 50.0))],
        view: View {
            azimuth: 34.0,
            elevation: 9.0,
            region: Some([[-0.8, 0.5, 0.0], [23.2, 15.5, 48.0]]),
            ..View::default()
        },
    }
}
