//! A pavilion by the water.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A pavilion on a terrace: a thin roof on slender columns, walls of glass and marble, and a pool.
    pub grammar Pavilion;

    /// The height of the rooms in metres.
    @Group("Roof", 1) @Order(1) @Distance @Range(min = 2.4, max = 6)
    attr height = 3.6
    /// The thickness of the roof in metres.
    @Order(2) @Distance @Range(min = 0.15, max = 1)
    attr roof = 0.34
    /// The distance from the columns to the edge of the roof in metres.
    @Order(3) @Distance @Range(min = 0, max = 4)
    attr overhang = 2
    /// The distance between two columns in metres.
    @Group("Plan", 2) @Order(1) @Distance @Range(min = 3, max = 9)
    attr spacing = 5.4
    /// The width of the pool with its rim in metres.
    @Order(2) @Distance @Range(min = 4, max = 16)
    attr pool = 8.5
    /// The side of a slab of the terrace in metres.
    @Order(3) @Distance @Range(min = 0.6, max = 2.4)
    attr slab = 1.1
    @Group("Colours", 3) @Color
    attr travertine = "#dccfb6"
    @Color
    attr marble = "#47705a"
    @Color
    attr water = "#4fa3b0"

    const podium = 0.9
    tone = 40% : travertine 35% : "#d5c6aa" else : "#e3d8c2"
    leaves = 35% : "#7da25e" 30% : "#8ab065" else : "#98bd70"

    @StartRule
    Lot     --> [ extrude(0.2) comp(f) { top : Lawn | bottom : NIL | all : color("#7b6248") Soil. } ]
                t(0, 0.2, 0) [ Trees ] offset(-4, inside) Terrace
    Lawn    --> setupProjection(0, world.xz, 4, 4) color("#8fae69") texture("grass.png") set(material.normalmap, "grass_normal.png") projectUV(0) Lawn.
    Trees   --> split(z) { 4 : split(x) { { ~7 : scatter(surface, 2, uniform) { Tree } }* } | ~1 : NIL }

    // Steps, the pool and the building on one podium.
    Terrace --> [ split(x) { ~1 : NIL | 5 : t(0, 0, ^1) s(^1, podium, 2.1) primitiveCube Stairs | ~1 : NIL } ]
                split(x) { pool : Water | ~1 : Court }
    Water   --> [ offset(-1.6, inside) extrude(podium - 0.5) color("#39575c") Basin. ]
                [ t(0, podium - 0.16, 0) offset(-1.6, inside) color(water) set(material.roughness, 0.05) Water. ]
                split(z) { 1.6 : Rim | ~1 : split(x) { 1.6 : Rim | ~1 : NIL | 1.6 : Rim } | 1.6 : Rim }
    Rim     --> [ extrude(podium - 0.05) color(travertine) Podium. ] t(0, podium - 0.05, 0) Paving
    Court   --> [ extrude(podium - 0.05) color(travertine) Podium. ] t(0, podium - 0.05, 0) [ Paving ]
                t(0, 0.05, 0) offset(-3, inside) House
    Paving  --> split(z) { { ~slab : split(x) { { ~slab : color(tone) extrude(0.05) Slab. }* } }* }
    Stairs  --> color(travertine) split(y) { { ~0.18 : Tread(1 - split.index / split.total) }* }
    Tread(length) --> split(z) { ^length : Tread. | ~1 : NIL }

    // Columns below the roof; walls of glass between them and screens of marble that slide past.
    House   --> [ Columns ]
                [ t(0, height, 0) s(scope.sx + 2 * overhang, 0, scope.sz + 2 * overhang) center(xz) extrude(roof) color("#e6e2da") Roof. ]
                [ offset(-0.9, inside) comp(fe) { front : Glazing(true) | right : Glazing(false) | left : Glazing(false) | back : Marble } ]
                [ split(x) { ~2 : NIL | 0.25 : Screen | ~3 : NIL } ] Furniture
    Columns --> split(z) { 0.28 : Row | { ~spacing : NIL | 0.28 : Row }* }
    Row     --> split(x) { 0.28 : Column | { ~spacing : NIL | 0.28 : Column }* }
    // A column is a cross of two plates of chrome.
    Column  --> s(^1, height, ^1) primitiveCube color("#cfd6da") set(material.metallic, 0.8) set(material.roughness, 0.1)
                [ s(^1, ^1, ^0.2) center(xz) Plate. ] s(^0.2, ^1, ^1) center(xz) Plate.
    // The door of two leaves is the third bay from the left, beside the stairs.
    Glazing(isFront) --> alignScopeToAxes(y) s(^1, height, 0.08) primitiveCube split(x) { 0.06 : Bar | { ~2.7 : Bay(isFront && split.index == 5) | 0.06 : Bar }* }
    Bay(isDoor) --> case isDoor : split(y) { 2.3 : split(x) { ~1 : Leaf | 0.02 : s(^1, ^1, 0.03) center(z) Bar | ~1 : Leaf } | 0.06 : Bar | ~1 : Pane } else : Pane
    Leaf    --> split(x) { 0.1 : Bar | ~1 : split(y) { 0.25 : Bar | ~1 : Pane | 0.1 : Bar } | 0.1 : Bar }
    Bar     --> color("#3a3f42") Bar.
    Pane    --> split(y) { 0.06 : Bar | ~1 : s(^1, ^1, 0.02) center(z) color("#a9c6cc") set(material.opacity, 0.2) Glass. | 0.06 : Bar }
    Marble  --> alignScopeToAxes(y) s(^1, height, 0.25) primitiveCube split(x) { { ~2.2 : Panel(marble) }* }
    Panel(tint) --> split(y) { ~1 : color(tint) set(material.roughness, 0.35) Marble. | ~1 : color(tint) set(material.roughness, 0.35) Marble. }
    Screen  --> s(^1, height, ^0.7) center(z) primitiveCube split(z) { { ~2.2 : Panel("#a8683a") }* }
    Furniture --> split(x) { ~1 : NIL | 3.4 : s(^1, 0, 3.4) center(z) Chairs | ^0.12 : NIL }
    Chairs  --> split(z) { 0.85 : Chair | ~1 : s(1.2, 0.4, 1.2) center(xz) primitiveCube color("#f2efe8") Table. | 0.85 : Chair }
    Chair   --> split(x) { { 0.8 : s(^1, 0.42, ^1) primitiveCube color("#f7f4ec") Cushion. | 0.25 : NIL }* }
    Tree    --> [ s(0.35, 3, 0.35) center(xz) primitiveCylinder(8) color("#8a6d50") scaleUV(0, 1, 4)
                texture("bark.png") set(material.normalmap, "bark_normal.png") Trunk. ] t(0, 2.2, 0) Crown(rand(3, 4.6))
    // A crown is a ball with tufts of leaves on it.
    Crown(size) --> s(size, size * 1.1, size) center(xz) Balls(size)
    Balls(size) --> [ s(^0.7, ^0.75, ^0.7) center(xyz) primitiveSphere(10, 7) color("#6f9352") Leafy(2 * size) ]
                s(^0.76, ^0.74, ^0.76) center(xyz) primitiveSphere(10, 6) scatter(surface, 22, uniform) { Tuft(rand(0.26, 0.42) * size) }
    Tuft(size) --> s(size, 0.8 * size, size) center(xyz) r(scopeCenter, rand(-30, 30), rand(0, 90), rand(-30, 30)) primitiveSphere(6, 4) color(leaves) Leafy(2 * size)
    Leafy(n) --> scaleUV(0, n, n / 2) texture("leaves.png") set(material.normalmap, "leaves_normal.png") Crown.
}

pub fn scene() -> Scene<()> {
    Scene {
        name: "pavilion",
        title: "Pavilion",
        sentence: "One outline gives podium, columns, glass and roof; paving, panes and columns fit themselves to any size.",
        rules: grammar_text(include_str!("pavilion.rs")),
        grammar: (),
        shapes: vec![Start::new("Lot", Shape::rectangle(44.0, 26.0).seed(2))],
        view: View {
            azimuth: -35.0,
            elevation: 9.0,
            field_of_view: 34.0,
            sun_azimuth: -30.0,
            sun_elevation: 36.0,
            region: Some([[6.0, 0.0, 3.0], [38.0, 5.5, 19.0]]),
            ..View::default()
        },
    }
}
