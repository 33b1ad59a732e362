//! A corner house at street level.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A corner house of stone: shops and a mezzanine, storeys with balconies on brackets, a slate roof with dormers.
    pub grammar Corner;

    /// The storeys above the shops.
    @Group("Size", 1) @Order(1) @Range(min = 2, max = 7, stepsize = 1)
    attr storeys = 4
    /// The height of a storey in metres.
    @Order(2) @Distance @Range(min = 2.8, max = 4)
    attr storey = 3.3
    /// The width of a bay in metres.
    @Order(3) @Distance @Range(min = 2.2, max = 4)
    attr bay = 2.7
    /// The width of the sidewalk in metres.
    @Group("Street", 2) @Distance @Range(min = 2, max = 6)
    attr sidewalk = 3.4
    @Group("Colours", 3) @Color
    attr stone = "#ecdfc6"
    @Color
    attr slate = "#5f6974"
    @Color
    attr awning = "#a8362f"

    const ground = 4.2
    const iron = "#23282b"
    pane = 30% : "#d9d0bd" 10% : "#f4d79a" else : "#3d5563"
    awnings = 50% : awning else : "#2f4f4a"

    // The lot is the outline of the house; sidewalk and street lie around it.
    @StartRule
    Lot     --> [ t(0, -0.15, 0) offset(sidewalk + 7, border) reverseNormals Ground("#737478", "asphalt", 3, 3) ]
                [ t(0, -0.15, 0) offset(sidewalk, border) reverseNormals extrude(0.14) color("#b5ada0") Kerb. ]
                [ offset(sidewalk - 0.25, border) reverseNormals Ground("#cbc3b5", "paving", 1.8, 1.6) ]
                [ offset(sidewalk - 0.5, border) comp(v) { all : case comp.index == 1 || comp.index == 2 : Lamp else : NIL } ]
                extrude(ground + storeys * storey + 1.05) comp(f) { side : Facade | top : Attic }
    Ground(tint, material, u, v) --> setupProjection(0, world.xz, u, v) Look(tint, material)
    Look(tint, material) --> color(tint) texture(material + ".png") set(material.normalmap, material + "_normal.png") set(material.roughnessmap, material + "_rough.png") projectUV(0) Surface.
    Lamp    --> alignScopeToAxes(y) color(iron) [ s(0.14, 4.6, 0.14) center(xz) primitiveCylinder(10) Pole. ]
                t(0, 4.6, 0) s(0.45, 0.55, 0.45) center(xz) primitiveSphere(12, 8) color("#fff2cf") Light.

    Facade  --> setupProjection(0, scope.xy, 2.7, 1.8) split(y) { ground : Shops | 0.35 : Ledge(0.3) | ~1 : Storeys | 0.7 : Cornice }
    Storeys --> split(y) { { ~storey : Storey(split.index, split.total) }* }
    Wall    --> Look(stone, "stone")
    Ledge(depth) --> [ Wall ] extrude(depth) color(stone) Ledge.
    Cornice --> [ Wall ] [ split(x) { { 0.18 : extrude(0.4) color(stone) Bracket. | ~0.5 : NIL }* | 0.18 : extrude(0.4) color(stone) Bracket. } ]
                split(y) { ~1 : NIL | 0.28 : extrude(0.6) color(stone) Cornice. }

    // The first and the last storey have a balcony along the whole front, the others one for each window.
    Storey(n, total) --> [ case n == 0 || n == total - 1 : Balcony(0.8) else : NIL ]
                split(x) { 0.7 : Wall | { ~bay : Bay(n > 0 && n < total - 1) }* | 0.7 : Wall }
    Bay(balcony) --> split(x) { ~1 : Wall | 1.3 : Column(balcony) | ~1 : Wall }
    Column(balcony) --> split(y) { ~1 : Window(balcony) | 0.3 : Ledge(0.1) | 0.45 : Wall }
    Balcony(depth) --> [ s(^1, 0.16, 0) extrude(depth) color(stone) Slab. ]
                t(0, 0.16, depth - 0.06) s(^1, 0.85, 0.04) primitiveCube color(iron)
                split(y) { 0.05 : Rail. | ~1 : split(x) { { ~0.12 : NIL | 0.025 : Bar. }* | ~0.12 : NIL } | 0.05 : Rail. }
    Window(balcony) --> [ case balcony : Balcony(0.25) else : NIL ]
                [ Recess(0.25) ] t(0, 0, -0.25) color(pane) split(x) { 0.07 : Frame | { ~0.5 : Sash | 0.07 : Frame }* }
    Recess(depth) --> set(trim.vertical, false) t(0, 0, -depth) s(^1, ^1, depth) primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : color(stone) Reveal. }
    Sash    --> split(y) { 0.35 : Frame | { ~0.75 : Glass | 0.05 : Frame }* }
    Glass   --> set(material.roughness, 0.08) Glass.
    Frame   --> color("#f4efe4") extrude(0.05) Frame.

    // Shops of wood and glass below awnings, with a door in every third.
    Shops   --> split(x) { 0.6 : Pier | { ~3.6 : Shop(split.index) | 0.6 : Pier }* }
    Pier    --> extrude(0.15) comp(f) { top : Wall | bottom : NIL | all : setupProjection(0, scope.xy, 2.7, 1.8) Wall }
    Shop(n) --> color(case n % 4 == 2 : "#39453f" else : "#4a2f2a") [ Recess(0.35) ] t(0, 0, -0.35)
                split(y) { ~1 : Front(n) | 0.7 : Sign }
    Front(n) --> [ case n % 3 == 0 : NIL else : t(0, ^1, 0.35) Awning ] split(x) { 0.12 : Timber | { ~1.1 : split(y) { 0.6 : Timber | ~1 : color("#4a5f68") Glass | 0.1 : Timber } | 0.12 : Timber }* }
    Timber  --> extrude(0.1) Timber.
    Sign    --> extrude(0.3) Sign.
    Awning  --> color(awnings) s(^1, 0.06, 1.5) r(16, 0, 0) primitiveCube split(x) { { ~0.3 : case split.index % 2 == 0 : Cloth. else : color("#f1e9da") Cloth. }* }

    // A roof of slate, as steep as a wall, with dormers and chimneys.
    Attic   --> envelope(normal, 3.2, 0, 72, 0, 72, 0, 72) comp(f) { bottom : NIL | top : Flat | all : Slope }
    Flat    --> [ color("#8b9095") Flat. ] split(x) { ~1 : NIL | { 0.9 : Chimney | ~4 : NIL }* }
    Slope   --> [ setupProjection(0, scope.xy, 2, 2) Look(slate, "slate") ] split(x) { 1.6 : NIL | { ~bay : Dormers }* | 1.6 : NIL }
    Dormers --> case scope.sx < 1.8 : NIL else : split(x) { ~1 : NIL | 1.2 : Dormer | ~1 : NIL }
    Dormer  --> alignScopeToAxes(y) t(0, 0.35, 0.1) s(^1, 1.7, 0.95) primitiveCube
                comp(f) { front : DormerFront | side : color(stone) Reveal. | top : color(slate) roofGable(30, 0.1) DormerRoof. }
    DormerFront --> color(stone) split(x) { 0.12 : Reveal. | ~1 : split(y) { 0.1 : Reveal. | ~1 : Window(false) | 0.12 : Reveal. } | 0.12 : Reveal. }
    Chimney --> alignScopeToAxes(y) s(0.9, 1.7, 2.4) center(xz) primitiveCube color("#a9765c") [ Chimney. ]
                t(0, 1.7, 0) split(z) { ~0.1 : NIL | { 0.3 : t(^0.2, 0, 0) s(^0.6, 0.6, ^1) primitiveCylinder(8) Pot. | ~0.25 : NIL }* }
}

pub fn scene() -> Scene<()> {
    let outline = [[0.0, 0.0], [0.0, 16.0], [14.0, 16.0], [17.0, 13.0], [17.0, 0.0]];
    Scene {
        name: "corner",
        title: "Corner house",
        sentence: "The outline has a cut corner; each of its sides fits its own number of shops, windows and dormers.",
        rules: grammar_text(include_str!("corner.rs")),
        grammar: (),
        shapes: vec![Start::new("Lot", Shape::footprint(&outline, &[]).expect("the outline is simple").seed(3))],
        view: View {
            azimuth: 38.0,
            elevation: 4.0,
            field_of_view: 50.0,
            region: Some([[1.0, 0.0, 1.0], [18.0, 21.0, 17.0]]),
            sun_azimuth: -58.0,
            ..View::default()
        },
    }
}
