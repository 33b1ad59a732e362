//! The skyline of a city.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A city centre on a grid: more than a hundred lots with seven kinds of buildings, the highest ones in the middle.
    pub grammar Skyline;

    /// The height of the highest towers in metres.
    @Group("Heights", 1) @Order(1) @Distance @Range(min = 40, max = 500)
    attr highest = 260
    /// The height of towers at the edge of the city, in metres.
    @Order(2) @Distance @Range(min = 8, max = 60)
    attr lowest = 22
    /// The distance from the middle at which towers are half as high.
    @Order(3) @Distance @Range(min = 50, max = 500)
    attr reach = 130
    /// The side of a block in metres.
    @Group("Plan", 2) @Order(1) @Distance @Range(min = 40, max = 140)
    attr block = 86
    /// The width of a street in metres.
    @Order(2) @Distance @Range(min = 8, max = 30)
    attr street = 15
    /// The share of lots that stay green.
    @Order(3) @Percent @Range(min = 0, max = 1)
    attr parks = 0.06
    @Group("Colours", 3) @Color
    attr glass = "#5f8ba6"
    @Color
    attr stone = "#d9ccb4"

    const storey = 4
    // The height that a place allows falls with its distance from the middle of the city.
    allowed(x, z) = lowest + (highest - lowest) / (1 + pow((x * x + z * z) / (reach * reach), 1.3))
    pane = 40% : glass 25% : "#86a9b6" 20% : "#93a0ab" else : "#4c6b80"
    masonry = 45% : stone 25% : "#c2a98c" else : "#e6e0d4"

    @StartRule
    City    --> [ extrude(1) color("#7c7f84") Ground. ] t(0, 1, 0) Rows(scope.sx / 2, scope.sz / 2)
    Rows(x, z) --> split(x) { ~block : Blocks(x, z) | { street : NIL | ~block : Blocks(x, z) }* }
    Blocks(x, z) --> split(z) { ~block : Block(x, z) | { street : NIL | ~block : Block(x, z) }* }
    Block(x, z) --> [ extrude(0.4) color("#b9b6af") Pavement. ]
                t(0, 0.4, 0) offset(-3, inside) split(x) { ~1 : Lots(x, z) | 3 : NIL | ~1 : Lots(x, z) }
    Lots(x, z) --> split(z) { ~1 : Lot(x, z) | 3 : NIL | ~1 : Lot(x, z) }
    Lot(x, z) --> case p(parks) : Park
                else : Site(rand(0.45, 1) * allowed(scope.tx + scope.sx / 2 - x, scope.tz + scope.sz / 2 + z))
    // The higher the tower, the slimmer its kind.
    Site(height) -->
        case height > 0.45 * highest : 35% : Needle(height) 35% : Steps(height, 4) else : Twist(height)
        case height > 0.2 * highest  : 30% : Slab(height) 30% : Steps(height, 3) 20% : Round(height) else : Cut(height)
        else                         : 60% : Low(height) 25% : Slab(height) else : Steps(height, 2)

    // A podium of shops with a lower part and a higher part.
    Low(height) --> split(x) { ^0.6 : extrude(height) Stone(masonry) | ~1 : extrude(height * 0.6) Stone(masonry) }
    // A slab of glass between two solid ends.
    Slab(height) --> s(^0.9, 0, ^0.5) center(xz) extrude(height)
                split(x) { 2 : color(masonry) End. | ~1 : Curtain(pane) | 2 : color(masonry) End. }
    // Setbacks of stone, as zoning laws of the 1920s required.
    Steps(height, n) --> Mass(height, n, masonry)
    Mass(height, n, tint) --> case n > 0 : [ extrude(height * 0.46) Stone(tint) ]
                             t(0, height * 0.46, 0) s(^0.74, 0, ^0.74) center(xz) Mass(height * 0.62, n - 1, tint)
                else : color("#6f8f86") roofPyramid(60) Spire.
    // A round tower with a dark crown.
    Round(height) --> s(^0.8, 0, ^0.8) center(xz) primitiveDisk(20) [ extrude(height) Curtain(pane) ]
                t(0, height, 0) s(^0.8, 0, ^0.8) center(xz) extrude(5) color("#4a5257") Crown.
    // A prism of glass whose top slopes like a shed roof.
    Cut(height) --> s(^0.75, 0, ^0.75) center(xz) [ extrude(height) Curtain(pane) ]
                t(0, height, 0) roofShed(35) color(glass) set(material.roughness, 0.1) Top.
    // Storeys that turn and shrink on the way up.
    Twist(height) --> s(^0.8, 0, ^0.8) center(xz) extrude(height) Turns(pane)
    Turns(tint) --> split(y) { { ~storey : Turn(split.index / split.total, tint) }* }
    Turn(h, tint) --> s(^(1 - 0.4 * h), ^1, ^(1 - 0.4 * h)) center(xz) r(scopeCenter, 0, 90 * h, 0) Floor(tint)
    // Glass that leans back to a needle.
    Needle(height) --> s(^0.85, 0, ^0.85) center(xz) envelope(normal, height, 0, 88.2, 0, 88.2, 0, 88.2)
                [ Curtain(pane) ]
                t(^0.5, ^1, ^0.5) s(1.4, height * 0.22, 1.4) t(-0.7, 0, -0.7) primitiveCone(8) color("#d5dade") Needle.

    // Glass with a dark joint at each storey, and stone with rows of windows.
    Curtain(tint) --> split(y) { { ~storey : Floor(tint) }* | 1.2 : color("#3f474c") Plant. }
    Floor(tint) --> split(y) { ~1 : color(tint) set(material.roughness, 0.12) Glass. | 0.7 : s(^0.985, ^1, ^0.985) center(xz) color("#39434a") Joint. }
    Stone(tint) --> split(y) { { ~storey : StoneFloor(tint) }* }
    StoneFloor(tint) --> split(y) { ~1 : s(^0.97, ^1, ^0.97) center(xz) color("#55646d") Windows. | ~0.9 : color(tint) Spandrel. }

    Park    --> color("#8dab66") [ extrude(0.3) texture("grass.png") set(material.normalmap, "grass_normal.png")
                modify(f) { side : setupProjection(0, scope.xy, 4, 4) projectUV(0) | all : setupProjection(0, world.xz, 4, 4) projectUV(0) } Lawn. ]
                t(0, 0.3, 0) offset(-3, inside) scatter(surface, 14, uniform) { Tree }
    Tree    --> [ s(0.6, 2.8, 0.6) center(xz) primitiveCylinder(6) color("#8a6d50") Trunk. ]
                t(0, 2, 0) s(5, rand(5, 8), 5) center(xz) primitiveSphere(8, 6) color("#7da85f") scaleUV(0, 9, 5) texture("leaves.png") set(material.normalmap, "leaves_normal.png") Crown.
}

pub fn scene() -> Scene<()> {
    Scene {
        name: "skyline",
        title: "Skyline",
        sentence: "The position of each of 120 lots limits its height, and chance picks one of seven kinds of buildings.",
        rules: grammar_text(include_str!("skyline.rs")),
        grammar: (),
        shapes: vec![Start::new("City", Shape::rectangle(620.0, 470.0).at([-310.0, 0.0, -235.0]).seed(2))],
        view: View {
            azimuth: 24.0,
            elevation: 9.0,
            region: Some([[-235.0, 0.0, -150.0], [235.0, 290.0, 220.0]]),
            ..View::default()
        },
    }
}
