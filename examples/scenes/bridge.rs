//! A stone bridge over a river.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A bridge of stone arches: each span is a block with a cylinder cut out of it.
    pub grammar Bridge;

    /// The desired width of an arch in metres. The length of the bridge determines the number of arches.
    @Group("Arches", 1) @Order(1) @Distance @Range(min = 8, max = 30)
    attr span = 15
    /// The height of an arch as a share of half its width: 1 is a half circle.
    @Order(2) @Percent @Range(min = 0.3, max = 1.2)
    attr rise = 0.85
    /// The width of a pier in metres.
    @Order(3) @Distance @Range(min = 2, max = 6)
    attr pier = 3.2
    /// The height of the piers below the arches in metres.
    @Order(4) @Distance @Range(min = 1, max = 12)
    attr springing = 3
    /// The width of the bridge in metres.
    @Group("Deck", 2) @Order(1) @Distance @Range(min = 5, max = 16)
    attr width = 9
    /// The distance between two lamps in metres.
    @Order(2) @Distance @Range(min = 6, max = 40)
    attr lamps = 13
    @Group("Colours", 3) @Color
    attr stone = "#e4d6b6"
    @Color
    attr trim = "#e4d8bd"
    @Color
    attr water = "#5d8fa3"

    leaves = 40% : "#86ad60" 35% : "#6d9a57" else : "#a3c06c"

    const ring = 0.9
    const bed = 3
    const bank = 13
    // The crown of the arches, and the road on it.
    arch = (span - pier) / 2 * rise
    road = springing + arch + ring + 0.7

    @StartRule
    Lot     --> split(x) { bank : Bank | ~1 : Water | bank : Bank }
                s(scope.sx - 0.1, 0, width) center(xz) Bridge
    Water   --> t(0, -bed, 0) extrude(bed - 0.4) color(water) set(material.roughness, 0.12) texture("water.png") set(material.normalmap, "water_normal.png")
                modify(f) { side : setupProjection(0, scope.xy, 6, 6) projectUV(0) | all : setupProjection(0, world.xz, 6, 6) projectUV(0) } Water.
    // Grass above walls of stone.
    Bank    --> [ t(0, -bed, 0) extrude(bed + 1) comp(f) { top : Grass | bottom : NIL | all : setupProjection(0, scope.xy, 2.7, 1.8) Stone } ]
                t(0, 1, 0) split(z) { ~1 : NIL | 14 : Grove | width + 16 : NIL | 14 : Grove | ~1 : NIL }
    Grass   --> setupProjection(0, world.xz, 4, 4) color("#8ba567") texture("grass.png") set(material.normalmap, "grass_normal.png") projectUV(0) Grass.
    Grove   --> scatter(surface, 6, uniform) { Tree(rand(3, 5.5)) }
    Tree(size) --> [ s(0.4, size * 0.6, 0.4) center(xz) primitiveCylinder(8) color("#8a6d50") scaleUV(0, 1, 4)
                texture("bark.png") set(material.normalmap, "bark_normal.png") Trunk. ]
                t(0, size * 0.45, 0) s(size, size * 1.1, size) center(xz) color(leaves) Crown(size)
    // A crown is a ball with tufts of leaves on it.
    Crown(size) --> [ s(^0.7, ^0.75, ^0.7) center(xyz) primitiveSphere(10, 7) Leafy(2 * size) ]
                s(^0.76, ^0.74, ^0.76) center(xyz) primitiveSphere(10, 6) scatter(surface, 22, uniform) { Tuft(rand(0.26, 0.42) * size) }
    Tuft(size) --> s(size, 0.8 * size, size) center(xyz) r(scopeCenter, rand(-30, 30), rand(0, 90), rand(-30, 30)) primitiveSphere(6, 4) Leafy(2 * size)
    Leafy(n) --> scaleUV(0, n, n / 2) texture("leaves.png") set(material.normalmap, "leaves_normal.png") Crown.

    Bridge  --> [ split(x) { bank : Abutment | pier / 2 : Half | { ~span - pier : Arch | pier : Pier }* | pier / 2 : Half | bank : Abutment } ]
                t(0, road, 0) [ extrude(0.35) color(trim) Slab. ]
                t(0, 0.35, 0) split(z) { 0.4 : Parapet | 1.4 : Walk | ~1 : Road | 1.4 : Walk | 0.4 : Parapet }
    Abutment --> extrude(road) Masonry
    // Courses of stone that continue along the bridge; the vaults have their own.
    Masonry --> comp(f) { bottom : NIL | object.front : setupProjection(0, world.xy, 2.7, 1.8) Stone | object.back : setupProjection(0, world.xy, 2.7, 1.8) Stone | all : setupProjection(0, scope.xy, 2.7, 1.8) Stone }
    Stone   --> color(stone) texture("stone.png") set(material.normalmap, "stone_normal.png") set(material.roughnessmap, "stone_rough.png") projectUV(0) Stone.

    // A span is a block minus a cylinder across it; a ring of cut stones marks the arch on both sides.
    Arch    --> [ subtract { t(0, springing, 0) extrude(road - springing) | Tube(0) } Masonry ]
                s(^1, 0, scope.sz + 0.3) center(z) subtract { Tube(ring) | Tube(-0.06) }
                alignScopeToAxes(y) split(y) { ^0.5 : NIL | ~1 : color(trim) Voussoirs. }
    // An elliptic cylinder across the bridge, wider than the arch by a margin.
    Tube(margin) --> t(-margin, springing - arch - margin, 0)
                s(scope.sx + 2 * margin, 2 * (arch + margin), scope.sz) primitiveCube rotateScope(90, 0, 0) primitiveCylinder(48) Tube.

    Half    --> t(0, -bed, 0) extrude(road + bed) Masonry
    // A pier with round cutwaters, which divide the stream, below pilasters.
    Pier    --> [ t(0, -bed, 0) extrude(road + bed) Masonry ]
                s(^1, 0, scope.sz + pier) center(z) split(z) { pier : Cutwater | ~1 : NIL | pier : Cutwater }
    Cutwater --> color(trim) s(^0.96, ^1, ^0.96) center(xz) [ t(0, -bed, 0) s(^1, springing + bed, ^1) primitiveCylinder(20) Cutwater. ]
                [ t(0, springing, 0) s(^1, 1.2, ^1) primitiveCone(20) Cap. ]
                s(^0.44, 0, ^0.56) center(xz) extrude(road) Pilaster.

    Parapet --> color(stone) [ extrude(0.2) Kerb. ] [ t(0, 0.95, 0) extrude(0.2) Rail. ]
                t(0, 0.2, 0) split(x) { 0.8 : Post | { ~6 : split(x) { { ~0.55 : Baluster }* } | 0.8 : Post }* }
    Post    --> extrude(0.85) Post.
    Baluster --> s(0.22, 0.75, 0.22) center(xz) primitiveCylinder(8) Baluster.
    Walk    --> [ extrude(0.15) color("#cfc8ba") texture("paving.png") set(material.normalmap, "paving_normal.png") set(material.roughnessmap, "paving_rough.png")
                modify(f) { side : setupProjection(0, scope.xy, 1.8, 1.6) projectUV(0) | all : setupProjection(0, world.xz, 1.8, 1.6) projectUV(0) } Walk. ]
                t(0, 0.15, 0) split(x) { ~lamps / 2 : NIL | { 0.2 : Lamp | ~lamps : NIL }* | 0.2 : Lamp | ~lamps / 2 : NIL }
    Lamp    --> color("#3b4245") [ s(0.16, 4, 0.16) center(xz) primitiveCylinder(8) Pole. ]
                t(0, 4, 0) s(0.55, 0.6, 0.55) center(xz) primitiveSphere(10, 8) color("#fbeecb") Light.
    Road    --> [ extrude(0.05) color("#77787c") texture("asphalt.png") set(material.normalmap, "asphalt_normal.png") set(material.roughnessmap, "asphalt_rough.png")
                modify(f) { side : setupProjection(0, scope.xy, 3, 3) projectUV(0) | all : setupProjection(0, world.xz, 3, 3) projectUV(0) } Asphalt. ]
                t(0, 0.07, 0) s(^1, 0, 0.14) center(z) split(x) { { 2 : color("#f2efe6") Mark. | ~2.5 : NIL }* }
}

pub fn scene() -> Scene<()> {
    Scene {
        name: "bridge",
        title: "Bridge",
        sentence: "A cylinder is cut out of each span, whatever its width; the length of the bridge determines the number of spans.",
        rules: grammar_text(include_str!("bridge.rs")),
        grammar: (),
        shapes: vec![Start::new("Lot", Shape::rectangle(110.0, 260.0))],
        view: View {
            azimuth: 38.0,
            elevation: 13.0,
            region: Some([[22.0, 2.0, 113.0], [92.0, 13.0, 137.0]]),
            ..View::default()
        },
    }
}
