//! Fences around a garden.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A garden with a fence of another kind on each side: iron between stone piers, pickets, boards, a hedge.
    pub grammar Fence;

    /// The kind of the fence at the front.
    @Group("Kinds", 1) @Order(1) @Enum("iron", "pickets", "boards", "hedge")
    attr front = "iron"
    /// The kind on the left.
    @Order(2) @Enum("iron", "pickets", "boards", "hedge")
    attr left = "hedge"
    /// The kind on the right.
    @Order(3) @Enum("iron", "pickets", "boards", "hedge")
    attr right = "pickets"
    /// The kind at the back.
    @Order(4) @Enum("iron", "pickets", "boards", "hedge")
    attr back = "boards"
    /// The height of the fences in metres.
    @Group("Size", 2) @Order(1) @Distance @Range(min = 0.8, max = 2.4)
    attr height = 1.3
    /// The distance between two posts in metres.
    @Order(2) @Distance @Range(min = 1, max = 5)
    attr spacing = 2.4
    /// The width of the gate in metres.
    @Order(3) @Distance @Range(min = 1, max = 5)
    attr gate = 3
    @Group("Colours", 3) @Color
    attr stone = "#d6cab4"
    @Color
    attr paint = "#f4f1e8"
    @Color
    attr metal = "#2b3236"

    timber = 40% : "#a97a50" 35% : "#9d7048" else : "#b58860"
    leaves = 50% : "#7da25e" else : "#8fb56c"
    petals = 30% : "#d65a6c" 30% : "#e8c14a" 20% : "#8f6bb0" else : "#f2efe6"

    @StartRule
    Lot     --> [ t(0, -0.3, 0) offset(0.3, inside) extrude(0.3) comp(f) { top : Lawn | bottom : NIL | all : color("#7b6248") Soil. } ]
                [ split(z) { 0.9 : NIL | ~1 : split(x) { ~1 : NIL | gate : Path | ~1 : NIL } } ]
                [ offset(-0.9) comp(f) { border : Bed(comp.index) | inside : NIL } ]
                [ t(^0.2, 0, ^0.35) Tree(3.2) ] [ t(^0.76, 0, ^0.3) Tree(2.4) ]
                comp(fe) { front : Entrance | left : Side(left) | right : Side(right) | back : Side(back) }
    Lawn    --> setupProjection(0, world.xz, 4, 4) color("#86a862") texture("grass.png") set(material.normalmap, "grass_normal.png") projectUV(0) Lawn.
    Tree(size) --> s(size, 0, size) [ s(0.24, size * 0.7, 0.24) center(xz) primitiveCylinder(8) scaleUV(0, 1, 3) color("#8a6d50")
                texture("bark.png") set(material.normalmap, "bark_normal.png") Trunk. ]
                t(0, size * 0.5, 0) s(^1, size * 0.9, ^1) primitiveSphere(10, 6) scatter(volume, 45, uniform) { Bush(size * rand(0.25, 0.4)) }
    Path    --> split(z) { { ~0.8 : split(x) { { ~0.8 : s(^0.94, ^1, ^0.94) center(xz) extrude(0.03) color("#c8bfae") Flag. }* } }* }

    // Each edge becomes a box as high as the fence, which is then split into posts and panels.
    Entrance --> split(x) { ~1 : Side(front) | gate : Gate | ~1 : Side(front) }
    Side(kind) --> set(trim.vertical, false) alignScopeToAxes(y) s(^1, height, 0.4) t(0, 0, -0.2) primitiveCube Run(kind)
    Run(kind) -->
        case kind == "iron"    : split(x) { 0.4 : Pier | { ~spacing * 1.3 : Iron | 0.4 : Pier }* }
        case kind == "pickets" : split(x) { 0.1 : Post(paint) | { ~spacing : Pickets | 0.1 : Post(paint) }* }
        case kind == "boards"  : split(x) { 0.12 : Post("#7d5a3c") | { ~spacing : Boards | 0.12 : Post("#7d5a3c") }* }
        else                   : Hedge
    Post(tint) --> s(^1, height + 0.12, scope.sx) center(z) color(tint) Post. comp(f) { top : roofPyramid(byHeight, 0.09) Cap. }

    // Iron bars with points, on a low wall between stone piers with balls.
    Pier    --> color(stone) [ s(^1, height + 0.25, ^1) Pier. ]
                t(0, height + 0.25, 0) [ s(^1.25, 0.1, ^1.25) center(xz) Cap. ]
                t(0, 0.1, 0) s(^0.8, 0.32, ^0.8) center(xz) primitiveSphere(14, 10) Ball.
    Iron    --> split(y) { 0.4 : Plinth | ~1 : Bars }
    Plinth  --> s(^1, ^1, 0.28) center(z) color(stone) split(y) { ~1 : Wall. | 0.07 : s(^1, ^1, 0.36) center(z) Coping. }
    Bars    --> color(metal) s(^1, ^1, 0.03) center(z) [ split(y) { 0.08 : NIL | 0.05 : Rail. | ~1 : NIL | 0.05 : Rail. | 0.15 : NIL } ]
                split(x) { ~0.06 : NIL | { 0.03 : Bar | ~0.11 : NIL }* }
    Bar     --> [ split(y) { ~1 : Bar. | 0.12 : NIL } ] t(0, scope.sy - 0.12, 0) s(0.06, 0.16, 0.06) center(xz) primitiveCone(4) Point.

    // Pickets are higher in the middle of a panel, in a curve of cosines.
    Pickets --> color(paint)
                [ s(^1, ^1, 0.05) t(0, 0, 0.15) split(y) { 0.22 : NIL | 0.09 : Rail. | ~1 : NIL | 0.09 : Rail. | 0.3 : NIL } ]
                s(^1, ^1, 0.025) t(0, 0, 0.2) split(x) { ~0.05 : NIL | { 0.085 : Picket(split.index / split.total) | ~0.055 : NIL }* }
    Picket(at) --> split(y) { 0.06 : NIL | height * (0.82 + 0.16 * sin(180 * at)) : Slat. | 0.07 : Slope | ~1 : NIL }
    Slope   --> Slat.

    // Boards of many browns, which overlap a little.
    Boards  --> split(y) { 0.06 : NIL | { ~0.16 : Plank }* | 0.04 : Rail }
    Plank   --> color(timber) s(^1, ^0.93, 0.03) center(z) r(scopeCenter, 6, 0, 0) Plank.
    Rail    --> color("#7d5a3c") s(^1, ^1, 0.14) center(z) Rail.

    // A hedge and a crown are full of small spheres.
    Hedge   --> s(^1, ^0.8, 0.7) center(z) [ s(^1, ^0.9, ^0.7) center(xz) color("#6f9656") texture("leaves.png") set(material.normalmap, "leaves_normal.png")
                modify(f) { all : setupProjection(0, scope.xy, 1, 1) projectUV(0) } Hedge. ]
                scatter(volume, rint(scope.sx * 14), uniform) { Bush(rand(0.25, 0.45)) }
    Bush(size) --> s(size, size, size) center(xyz) primitiveSphere(7, 5) scaleUV(0, 2.5 * size, 1.2 * size) color(leaves)
                texture("leaves.png") set(material.normalmap, "leaves_normal.png") Leaves.

    // Two wings of iron, ajar, on piers.
    Gate    --> set(trim.vertical, false) alignScopeToAxes(y) s(^1, height + 0.15, 0.4) t(0, 0, -0.2)
                split(x) { ^0.5 : Wing(28) | ^0.5 : mirrorScope(true, false, false) Wing(-28) }
    Wing(angle) --> s(^0.98, ^1, 0.04) t(0, 0.1, 0.18) r(0, angle, 0) primitiveCube color(metal)
                [ split(x) { 0.06 : Stile. | ~1 : split(y) { 0.06 : Rail. | ~1 : NIL | 0.05 : Rail. | 0.3 : NIL | 0.06 : Rail. } | 0.06 : Stile. } ]
                split(x) { 0.06 : NIL | { ~0.12 : NIL | 0.03 : Bar. }* | ~0.1 : NIL }

    // Flowers along the fences.
    Bed(n)  --> case n == 0 : NIL else : [ t(0, 0, 0.01) color("#6e5440") Soil. ] scatter(surface, rint(geometry.area * 7), uniform) { Flower }
    Flower  --> alignScopeToAxes(y) s(0.16, rand(0.15, 0.4), 0.16) [ primitiveCone(6) color("#5f8a48") Stalk. ] t(0, ^0.8, 0) s(0.15, 0.1, 0.15) primitiveSphere(7, 5) color(petals) Flower.
}

pub fn scene() -> Scene<()> {
    Scene {
        name: "fence",
        title: "Fences",
        sentence: "Each edge of the lot has its own kind of fence, and the length of a side decides the number of panels.",
        rules: grammar_text(include_str!("fence.rs")),
        grammar: (),
        shapes: vec![Start::new("Lot", Shape::rectangle(16.0, 11.0).seed(2))],
        view: View {
            azimuth: 30.0,
            elevation: 19.0,
            region: Some([[-0.4, 0.2, 0.0], [16.2, 3.6, 10.2]]),
            ..View::default()
        },
    }
}
