//! A block of houses around a courtyard.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A perimeter block: houses of different width and colour under one roof, shops at the street, a green courtyard.
    pub grammar Courtyard;

    /// The depth of the houses in metres.
    @Group("Block", 1) @Order(1) @Distance @Range(min = 8, max = 16)
    attr depth = 11
    /// The storeys above the shops.
    @Order(2) @Range(min = 2, max = 7, stepsize = 1)
    attr storeys = 4
    /// The slope of the roofs in degrees.
    @Order(3) @Angle @Range(min = 15, max = 55)
    attr slope = 36
    /// The width of a house in metres.
    @Order(4) @Distance @Range(min = 6, max = 24)
    attr house = 13
    /// The number of trees in the courtyard.
    @Group("Courtyard", 2) @Range(min = 1, max = 60)
    attr trees = 14
    @Group("Colours", 3) @Color
    attr tiles = "#a4604a"
    @Color
    attr grass = "#8fae63"

    const storey = 3.2
    const ground = 4
    const eaves = ground + storeys * storey

    plaster = 22% : "#e8d3a4" 20% : "#dcb48f" 18% : "#e9e2d2" 16% : "#c9cfc4" 12% : "#c98f6f" else : "#b9c3cd"
    shutter = 50% : "#4d6b5a" 30% : "#5d7080" else : "#7d4a3a"
    leaves = 40% : "#86ad60" 35% : "#6d9a57" else : "#a3c06c"

    @StartRule
    Block   --> Pavement offset(-3, inside) Plot
    Pavement --> extrude(0.15) color("#d6cfc2") texture("paving.png") set(material.normalmap, "paving_normal.png") set(material.roughnessmap, "paving_rough.png")
                modify(f) { side : setupProjection(0, scope.xy, 1.8, 1.6) projectUV(0) | all : setupProjection(0, world.xz, 1.8, 1.6) projectUV(0) } Pavement.
    Plot    --> t(0, 0.15, 0) shapeO(depth, depth, depth, depth) { shape : Ring | remainder : Court }

    // One mass and one roof for the whole ring, with chimneys along the ridge.
    Ring    --> [ extrude(eaves) comp(f) { side : Side | all : NIL } ]
                t(0, eaves, 0) roofHip(slope, 0.5) Roof
    Roof    --> [ comp(e) { ridge : alignScopeToAxes(y) Ridge } ] comp(f) { bottom : color("#efe6d4") Eaves. | all : Slope }
    Slope   --> [ setupProjection(0, scope.xy, 2, 2) color(tiles)
                texture("tile.png") set(material.normalmap, "tile_normal.png") set(material.roughnessmap, "tile_rough.png") projectUV(0) Tiles. ] Skylights
    Skylights -->
                split(x) { ~depth : NIL | { ~6 : split(x) { ~1 : NIL | 1.1 : split(y) { ^0.3 : NIL | 1.5 : Skylight | ~1 : NIL } | ~1 : NIL } }* | ~depth : NIL }
    Ridge   --> split(x) { { ~house : Chimney }* }
    Chimney --> s(rand(1, 2.2), 0, 0) center(x) t(0, -1, -0.4) s(^1, 2.4, 0.8) primitiveCube color("#8f5a48") Chimney.
                t(0, 2.4, 0) s(^1, 0.15, ^1) primitiveCube color("#c9bda6") Chimney.
    Skylight --> extrude(0.12) color("#5d7888") set(material.roughness, 0.1) Skylight.

    // The sides at the street and at the court are rows of houses.
    Side    --> split(x) { { ~house : House }* }
    House   --> color(plaster) setupProjection(0, scope.xy, 2.4, 2.4) Front(shutter)
    Wall    --> texture("plaster.png") set(material.normalmap, "plaster_normal.png") projectUV(0) Wall.
    Front(tint) --> split(y) { ground : Ground(tint) | { ~storey : Floor(tint) }* | 0.5 : Cornice }
    Cornice --> extrude(0.35) color("#f1e9da") Cornice.
    Floor(tint) --> split(x) { ~0.7 : Wall | { ~0.6 : Wall | 1.1 : Opening(tint) | ~0.6 : Wall }* | ~0.7 : Wall }
    Opening(tint) --> split(y) { 0.85 : Wall | 1.75 : Window(tint) | ~1 : Wall }
    Window(tint) --> [ t(0, -0.12, 0) s(scope.sx + 0.3, 0.12, 0) center(x) extrude(0.18) color("#f1e9da") Sill. ]
                [ Shutters(tint) ] [ Recess(0.2) ]
                t(0, 0, -0.2) split(x) { 0.08 : Frame | ~1 : Pane | 0.06 : Frame | ~1 : Pane | 0.08 : Frame }
    Shutters(tint) --> color(tint) s(scope.sx + 1, ^1, 0) center(x)
                split(x) { 0.48 : extrude(0.06) Shutter. | ~1 : NIL | 0.48 : extrude(0.06) Shutter. }
    Recess(deep) --> set(trim.vertical, false) t(0, 0, -deep) s(^1, ^1, deep) primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : Reveal. }
    Frame   --> color("#f6f1e6") extrude(0.08) Frame.
    Pane    --> color("#5a7381") set(material.roughness, 0.1) Glass.

    // A ground floor of stone: shops, some windows, and a door in the middle of each house.
    Ground(tint) --> split(x) { { ~4.2 : Shop(split.index == floor(split.total / 2), tint) }* }
    Shop(isEntrance, tint) -->
                case isEntrance : split(x) { ~1 : Pier | 1.5 : Door(tint) | ~1 : Pier }
                else : 75% : split(x) { 0.35 : Pier | ~1 : Display | 0.35 : Pier }
                       else : split(x) { ~1 : Pier | 1.3 : split(y) { 0.85 : Pier | 1.9 : Shopfront | ~1 : Pier } | ~1 : Pier }
    Pier    --> setupProjection(0, scope.xy, 2.7, 1.8) color("#e0d6c4") extrude(0.1) comp(f) { top : Stone | bottom : NIL | all : Pier. }
    Stone   --> texture("stone.png") set(material.normalmap, "stone_normal.png") set(material.roughnessmap, "stone_rough.png") projectUV(0) Stone.
    Display --> split(y) { 0.5 : Pier | ~1 : Shopfront | 0.25 : Awning | 0.65 : Pier }
    Shopfront --> [ Recess(0.25) ] t(0, 0, -0.25) split(x) { 0.06 : Frame | { ~1.4 : Pane | 0.06 : Frame }* }
    Awning  --> color(awning) roofShed(20) Awning.
    awning = 40% : "#a8473c" 30% : "#3f6b62" else : "#d8b15a"
    Door(tint) --> split(y) { 0.1 : Pier | 2.5 : [ Recess(0.25) ] t(0, 0, -0.25) color(tint) Door. | ~1 : Pier }

    // Gravel along the walls, grass in the middle.
    Court   --> [ extrude(0.1) color("#dccfb6") texture("asphalt.png") set(material.normalmap, "asphalt_normal.png") set(material.roughnessmap, "asphalt_rough.png")
                modify(f) { side : setupProjection(0, scope.xy, 3, 3) projectUV(0) | all : setupProjection(0, world.xz, 3, 3) projectUV(0) } Gravel. ]
                t(0, 0.1, 0) offset(-4, inside) [ extrude(0.15) color(grass) texture("grass.png") set(material.normalmap, "grass_normal.png")
                modify(f) { side : setupProjection(0, scope.xy, 4, 4) projectUV(0) | all : setupProjection(0, world.xz, 4, 4) projectUV(0) } Lawn. ]
                offset(-3, inside) scatter(surface, trees, uniform) { Tree }
    Tree    --> [ s(0.4, 2.6, 0.4) center(xz) primitiveCylinder(8) color("#8a6d50") scaleUV(0, 1, 3)
                texture("bark.png") set(material.normalmap, "bark_normal.png") Trunk. ]
                t(0, 2, 0) Crown(rand(3.4, 5.4))
    // A crown is a ball with tufts of leaves on it.
    Crown(size) --> color(leaves) s(size, size, size) center(xz) Balls(size)
    Balls(size) --> [ s(^0.7, ^0.75, ^0.7) center(xyz) primitiveSphere(10, 7) Leafy(2 * size) ]
                s(^0.76, ^0.74, ^0.76) center(xyz) primitiveSphere(10, 6) scatter(surface, 22, uniform) { Tuft(rand(0.26, 0.42) * size) }
    Tuft(size) --> s(size, 0.8 * size, size) center(xyz) r(scopeCenter, rand(-30, 30), rand(0, 90), rand(-30, 30)) primitiveSphere(6, 4) Leafy(2 * size)
    Leafy(n) --> scaleUV(0, n, n / 2) texture("leaves.png") set(material.normalmap, "leaves_normal.png") Crown.
}

pub fn scene() -> Scene<()> {
    let outline = [[0.0, 66.0], [68.0, 66.0], [82.0, 44.0], [82.0, 0.0], [0.0, 0.0]];
    Scene {
        name: "courtyard",
        title: "Courtyard block",
        sentence: "`shapeO` cuts a ring of any outline, and one hip roof covers it; its facades split into houses of their own colour.",
        rules: grammar_text(include_str!("courtyard.rs")),
        grammar: (),
        shapes: vec![Start::new("Block", Shape::footprint(&outline, &[]).expect("a simple outline").seed(5))],
        view: View {
            azimuth: 28.0,
            elevation: 38.0,
            region: Some([[1.0, 2.0, 2.0], [81.0, 20.0, 60.0]]),
            ..View::default()
        },
    }
}
