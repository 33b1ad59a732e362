//! A dungeon.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A dungeon without a roof: corridors divide the lot into rooms, and chance decides what is in them.
    pub grammar Dungeon;

    /// The number of divisions by corridors on the way from the whole lot to a room.
    @Group("Plan", 1) @Order(1) @Range(min = 0, max = 7, stepsize = 1)
    attr divisions = 4
    /// The width of a corridor in metres.
    @Order(2) @Distance @Range(min = 1.5, max = 4)
    attr corridor = 2.2
    /// The least width of a room in metres.
    @Order(3) @Distance @Range(min = 4, max = 10)
    attr least = 6
    /// The height of the walls in metres.
    @Order(4) @Distance @Range(min = 1, max = 5)
    attr height = 2.4
    /// The share of rooms with a treasure.
    @Group("Rooms", 2) @Percent @Range(min = 0, max = 1)
    attr treasure = 0.25
    @Group("Colours", 3) @Color
    attr stone = "#bfb6a8"
    @Color
    attr floor = "#aa9f90"

    const wall = 0.5
    const wood = "#8a5f3a"

    // Each corridor begins and ends at an earlier one, so all rooms are connected. A room has doors to the sides with a corridor.
    @StartRule
    Lot     --> [ t(0, -0.3, 0) extrude(0.3) comp(f) { top : setupProjection(0, world.xz, 1.8, 1.6) Stone(floor, "paving") | bottom : NIL | all : setupProjection(0, scope.xy, 2, 1.4) Stone(stone, "stone") } ]
                Part(0, false, false, false, false)
    Part(n, left, right, back, front) -->
        case n < divisions && scope.sx >= scope.sz && scope.sx > 2 * least + corridor :
            split(x) { ~rand(1, 1.6) : Part(n + 1, left, true, back, front) | corridor : NIL | ~rand(1, 1.6) : Part(n + 1, true, right, back, front) }
        case n < divisions && scope.sz > 2 * least + corridor :
            split(z) { ~rand(1, 1.6) : Part(n + 1, left, right, back, true) | corridor : NIL | ~rand(1, 1.6) : Part(n + 1, left, right, true, front) }
        else :
            [ split(z) { wall : Side(back) | ~1 : split(x) { wall : Turned(left) | ~1 : NIL | wall : Turned(right) } | wall : Side(front) } ]
            offset(-wall, inside) Room

    // A wall with a doorway in its middle.
    Side(opens) --> case opens : split(x) { ~1 : Wall | 0.35 : Post | 1.3 : Doorway | 0.35 : Post | ~1 : Wall } else : Wall
    Turned(opens) --> case opens : split(z) { ~1 : Wall | 0.35 : Post | 1.3 : Doorway | 0.35 : Post | ~1 : Wall } else : Wall
    Wall    --> extrude(height) comp(f) { bottom : NIL | all : setupProjection(0, scope.xy, 2, 1.4) Stone(stone, "stone") }
    Post    --> extrude(height + 0.25) color("#b3aa9b") Post.
    Doorway --> t(0, height - 0.1, 0) extrude(0.35) color("#b3aa9b") Lintel.
    Stone(tint, material) --> color(tint) texture(material + ".png") set(material.normalmap, material + "_normal.png") set(material.roughnessmap, material + "_rough.png") projectUV(0) Stone.

    // Torches on the floor of every room, and one of four things.
    Room    --> [ offset(-0.5, inside) comp(v) { all : Torch } ]
                Inside(rand)
    rand    = rand(0, 1)
    Inside(chance) -->
        case geometry.area < 14            : NIL
        case chance < treasure             : s(2.4, 0, 1.8) center(xz) Hoard
        case chance < treasure + 0.2       : offset(-1.2, inside) Pool
        case chance < treasure + 0.4       : offset(-1, inside) Tombs
        case chance < treasure + 0.6       : offset(-1.2, inside) Pillars
        else                               : s(2.6, 0, 1.2) center(xz) Table
    Torch   --> alignScopeToAxes(y) [ s(0.12, 1.5, 0.12) center(xz) primitiveCylinder(8) color(wood) Pole. ]
                t(0, 1.5, 0) [ s(0.3, 0.2, 0.3) center(xz) primitiveCylinder(8) color("#3b3d40") Bowl. ]
                t(0, 0.15, 0) s(0.24, 0.5, 0.24) center(xz) primitiveCone(8) color("#ffb43c") set(material.emissive.r, 1) set(material.emissive.g, 0.6) Flame.
    Hoard   --> [ extrude(0.15) color("#b3aa9b") Dais. ]
                t(0, 0.15, 0) [ s(1.1, 0.5, 0.7) center(xz) primitiveCube color(wood) Chest ]
                scatter(surface, 60, uniform) { Coin }
    Chest   --> Chest. comp(f) { top : roofGable(35, 0.06) color("#6e4a2c") Lid. }
    Coin    --> s(0.16, rand(0.03, 0.12), 0.16) center(xz) primitiveCylinder(8) color("#e8bd46") set(material.metallic, 0.8) set(material.roughness, 0.3) Coin.
    Pool    --> [ offset(-0.35, border) extrude(0.35) color("#b3aa9b") Rim. ]
                offset(-0.35, inside) extrude(0.2) color("#4f7f74") texture("water.png") set(material.normalmap, "water_normal.png") set(material.roughness, 0.1)
                modify(f) { side : setupProjection(0, scope.xy, 6, 6) projectUV(0) | all : setupProjection(0, world.xz, 6, 6) projectUV(0) } Water.
    Tombs   --> split(x) { { ~2.4 : split(z) { { ~3.8 : Tomb }* } }* }
    Tomb    --> s(1, 0, 2) center(xz) [ extrude(0.7) color("#a49b8e") Tomb. ] t(-0.08, 0.7, -0.08) s(1.16, 0, 2.16) extrude(0.16) color("#beb6a8") Slab.
    Pillars --> split(x) { 0.8 : Row | { ~2.4 : NIL | 0.8 : Row }* }
    Row     --> split(z) { 0.8 : Pillar | { ~2.4 : NIL | 0.8 : Pillar }* }
    Pillar  --> [ extrude(0.25) color("#b3aa9b") Base. ] s(^0.75, height, ^0.75) center(xz) primitiveCylinder(14) color("#a49b8e") Pillar.
    Table   --> [ t(0, 0.75, 0) extrude(0.08) color(wood) Board. ] [ split(x) { 0.3 : NIL | 0.12 : Leg | ~1 : NIL | 0.12 : Leg | 0.3 : NIL } ]
                t(0, 0.4, -0.7) s(^1, 0, 0.35) extrude(0.08) color("#7a5433") Bench.
    Leg     --> s(^1, 0, ^0.8) center(z) extrude(0.75) color("#6e4a2c") Leg.
}

pub fn scene() -> Scene<()> {
    Scene {
        name: "dungeon",
        title: "Dungeon",
        sentence: "For games: corridors divide a lot into rooms that are all connected, and chance fills them.",
        rules: grammar_text(include_str!("dungeon.rs")),
        grammar: (),
        shapes: vec![Start::new("Lot", Shape::rectangle(46.0, 32.0).seed(7))],
        view: View { azimuth: 24.0, elevation: 44.0, ..View::default() },
    }
}
