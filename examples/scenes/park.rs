//! A park.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A park on a lot of any outline: paths to a round pond, lawns between them, trees, benches, flower beds.
    pub grammar Park;

    /// The number of paths that meet at the pond.
    @Group("Paths", 1) @Order(1) @Range(min = 1, max = 8, stepsize = 1)
    attr paths = 3
    /// The width of the paths in metres.
    @Order(2) @Distance @Range(min = 1.5, max = 8)
    attr width = 3.6
    /// The radius of the square around the pond in metres.
    @Order(3) @Distance @Range(min = 6, max = 24)
    attr square = 15
    /// The trees on a hundred square metres of lawn.
    @Group("Plants", 2) @Order(1) @Range(min = 0.1, max = 4)
    attr density = 1.5
    /// The share of trees that have needles.
    @Order(2) @Percent @Range(min = 0, max = 1)
    attr needles = 0.25
    @Group("Colours", 3) @Color
    attr grass = "#8fb162"
    @Color
    attr gravel = "#d9cbb0"
    @Color
    attr water = "#5b96ab"

    leaves = 35% : "#7da85e" 30% : "#8fba66" 20% : "#a5c266" else : "#c2be5a"
    autumn = 12% : "#e0a04a" else : leaves
    petals = 30% : "#d65a6c" 30% : "#e8c14a" 20% : "#8f6bb0" else : "#f2efe6"

    @StartRule
    Lot     --> [ t(0, -0.3, 0) extrude(0.3) color(gravel) texture("asphalt.png") set(material.normalmap, "asphalt_normal.png") set(material.roughnessmap, "asphalt_rough.png")
                modify(f) { side : setupProjection(0, scope.xy, 3, 3) projectUV(0) | all : setupProjection(0, world.xz, 3, 3) projectUV(0) } Gravel. ]
                [ subtract { offset(-width, inside) | Ways(scope.sx + scope.sz) } comp(f) { all : Lawn } ]
                Middle
    // A disk for the square and strips for the paths: their area is cut out of the lawn.
    Ways(length) --> [ s(2 * square, 0, 2 * square) center(xz) primitiveDisk(40) Way. ] Path(length, paths)
    Path(length, n) --> case n == 0 : NIL
                else : [ s(length, 0, width) center(xz) r(scopeCenter, 0, 180 * n / paths + 15, 0) primitiveQuad Way. ] Path(length, n - 1)

    // Each piece of lawn has a kerb and trees that keep away from it.
    Lawn    --> alignScopeToAxes(y) [ offset(-0.25) comp(f) { border : extrude(0.28) color("#b9ad97") Kerb. | inside : extrude(0.22) color(grass) texture("grass.png") set(material.normalmap, "grass_normal.png")
                modify(f) { side : setupProjection(0, scope.xy, 4, 4) projectUV(0) | all : setupProjection(0, world.xz, 4, 4) projectUV(0) } Lawn. } ]
                t(0, 0.22, 0) Planted
    Planted --> case geometry.area < 60 : NIL
                else : [ offset(-3.5, inside) scatter(surface, ceil(density * geometry.area / 100), uniform) { Tree(rand(0.7, 1.2)) } ]
                       offset(-1.2, inside) scatter(surface, ceil(geometry.area / 40), uniform) { Shrub }
    Shrub   --> s(rand(0.6, 1.5), rand(0.4, 1), rand(0.6, 1.5)) center(xz) primitiveSphere(9, 6) scaleUV(0, 3, 1.5) color(leaves)
                texture("leaves.png") set(material.normalmap, "leaves_normal.png") Shrub.

    Tree(k) --> case p(needles) : s(3.6 * k, 9 * k, 3.6 * k) center(xz) Fir
                else            : s(5.6 * k, 7.5 * k, 5.6 * k) center(xz) color(autumn) Oak
    Fir     --> [ s(0.4, ^0.2, 0.4) center(xz) primitiveCylinder(8) color("#5f4630") Trunk. ]
                t(0, ^0.14, 0) s(^1, ^0.86, ^1) color("#5c8f68") Whorls(3)
    // Cones, each smaller and higher than the one below.
    Whorls(n) --> case n == 0 : NIL
                else : [ s(^1, ^0.62, ^1) primitiveCone(11) scaleUV(0, 6, 3) texture("leaves.png") set(material.normalmap, "leaves_normal.png") Needles. ] t(0, ^0.34, 0) s(^0.74, ^0.66, ^0.74) center(xz) Whorls(n - 1)
    Oak     --> [ s(0.5, ^0.4, 0.5) center(xz) primitiveCylinder(8) color("#8a6d50") scaleUV(0, 1, 3)
                texture("bark.png") set(material.normalmap, "bark_normal.png") Trunk. ]
                t(0, ^0.28, 0) s(^1, ^0.72, ^1) Balls
    // A crown is a ball with tufts of leaves on it.
    Balls   --> [ s(^0.7, ^0.75, ^0.7) center(xyz) primitiveSphere(10, 7) Leafy(9) ]
                s(^0.78, ^0.66, ^0.78) center(xyz) primitiveSphere(10, 6) scatter(surface, 20, uniform) { Tuft(rand(1.5, 2.5)) }
    Tuft(size) --> s(size, 0.8 * size, size) center(xyz) r(scopeCenter, rand(-30, 30), rand(0, 90), rand(-30, 30)) primitiveSphere(6, 4) Leafy(2 * size)
    Leafy(n) --> scaleUV(0, n, n / 2) texture("leaves.png") set(material.normalmap, "leaves_normal.png") Crown.

    // The square: a pond with a rim and a fountain, flower beds and benches around it.
    Middle  --> s(2 * square, 0, 2 * square) center(xz)
                [ s(^0.62, 0, ^0.62) center(xz) primitiveDisk(48) Pond ]
                s(^0.84, 0, ^0.84) center(xz) primitiveDisk(24) comp(e) { all : Around(comp.index) }
    Pond    --> [ extrude(0.25) color(water) set(material.roughness, 0.08) texture("water.png") set(material.normalmap, "water_normal.png")
                modify(f) { side : setupProjection(0, scope.xy, 6, 6) projectUV(0) | all : setupProjection(0, world.xz, 6, 6) projectUV(0) } Water. ] [ offset(0.6, border) reverseNormals extrude(0.5) color("#cfc3ad") Rim. ]
                [ s(5, 0.7, 5) center(xz) primitiveCylinder(24) color("#cfc3ad") Basin. ]
                [ s(0.8, 2.4, 0.8) center(xz) primitiveCylinder(12) color("#cfc3ad") Stem. ]
                [ t(0, 2.4, 0) s(2.6, 0.35, 2.6) center(xz) primitiveCylinder(24) color("#cfc3ad") Basin. ]
                t(0, 2.7, 0) s(0.9, 2.6, 0.9) center(xz) primitiveCone(10) color("#dfeef2") set(material.opacity, 0.5) Jet.
    Around(n) --> case n % 4 == 0 : alignScopeToAxes(y) s(2.2, 0, 0.7) center(x) Bench
                case n % 4 == 2 : alignScopeToAxes(y) s(^1, 0, 1.6) primitiveQuad Bed
                else            : NIL
    Bench   --> color("#9a6a42") [ split(x) { 0.12 : Foot | ~1 : NIL | 0.12 : Foot } ] [ t(0, 0.42, 0) s(^1, 0.06, ^1) primitiveCube Seat. ]
                t(0, 0.48, 0) s(^1, 0.45, 0.06) primitiveCube split(y) { 0.12 : NIL | { ~0.12 : Slat. | 0.05 : NIL }* }
    Foot    --> s(^1, 0.42, ^1) primitiveCube color("#3b4245") Foot.
    Bed     --> [ extrude(0.2) color("#6e5440") Soil. ] t(0, 0.2, 0) scatter(surface, 40, uniform) { Flower }
    Flower  --> s(0.3, rand(0.2, 0.4), 0.3) center(xz) primitiveSphere(6, 4) color(petals) Flower.
}

pub fn scene() -> Scene<()> {
    let outline = [[0.0, 62.0], [52.0, 74.0], [92.0, 54.0], [86.0, 6.0], [38.0, -4.0], [4.0, 12.0]];
    Scene {
        name: "park",
        title: "Park",
        sentence: "`subtract` cuts the paths out of the lawn, and trees scatter over each piece that is left.",
        rules: grammar_text(include_str!("park.rs")),
        grammar: (),
        shapes: vec![Start::new("Lot", Shape::footprint(&outline, &[]).expect("a simple outline").seed(6))],
        view: View {
            azimuth: 24.0,
            elevation: 27.0,
            region: Some([[4.0, 0.0, 2.0], [86.0, 6.0, 56.0]]),
            ..View::default()
        },
    }
}
