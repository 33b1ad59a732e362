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
    const top = ground + storeys * storey + 1.05
    const iron = "#23282b"
    pane = 30% : "#d9d0bd" 10% : "#f4d79a" else : "#3d5563"
    awnings = 50% : awning else : "#2f4f4a"

    // The lot is the outline of the house; sidewalk and street lie around it.
    @StartRule
    Lot     --> [ t(0, -0.15, 0) offset(sidewalk + 7, border) reverseNormals Ground("#737478", "asphalt", 3, 3) ]
                [ t(0, -0.15, 0) offset(sidewalk, border) reverseNormals extrude(0.14) color("#b5ada0") Kerb. ]
                [ offset(sidewalk - 0.25, border) reverseNormals Ground("#cbc3b5", "paving", 1.8, 1.6) ]
                [ offset(sidewalk - 0.5, border) comp(v) { all : case comp.index == 1 || comp.index == 2 : Lamp else : NIL } ]
                [ t(0, ground, 0) Band(0.3, 0.35) ] [ t(0, top - 0.28, 0) Band(0.6, 0.28) ]
                [ t(0, ground + 0.35, 0) Gallery ] [ t(0, top - 0.7 - storey, 0) Gallery ]
                extrude(top) comp(f) { side : Facade | top : Attic }
    Ground(tint, material, u, v) --> setupProjection(0, world.xz, u, v) Look(tint, material)
    Look(tint, material) --> color(tint) texture(material + ".png") set(material.normalmap, material + "_normal.png") set(material.roughnessmap, material + "_rough.png") projectUV(0) Surface.
    Lamp    --> alignScopeToAxes(y) color(iron) [ s(0.14, 4.6, 0.14) center(xz) primitiveCylinder(10) Pole. ]
                t(0, 4.6, 0) s(0.45, 0.55, 0.45) center(xz) primitiveSphere(12, 8) color("#fff2cf") Light.

    Facade  --> setupProjection(0, scope.xy, 2.7, 1.8) split(y) { ground : Shops | 0.35 : Wall | ~1 : Storeys | 0.7 : Cornice }
    Storeys --> split(y) { { ~storey : Storey(split.index, split.total) }* }
    Wall    --> Look(stone, "stone")
    Ledge(depth) --> [ Wall ] extrude(depth) color(stone) Ledge.
    Cornice --> [ Wall ] split(y) { ~1 : split(x) { { 0.18 : Bracket | ~0.5 : NIL }* | 0.18 : Bracket } | 0.28 : NIL }
    Bracket --> extrude(0.4) color(stone) Bracket.

    // Ledge, cornice and the long balconies are rings around the outline, so they have mitres at all corners.
    Band(depth, height) --> offset(depth, border) reverseNormals extrude(height) color(stone) Band.
    Gallery --> [ Band(0.8, 0.16) ] color(iron) t(0, 0.16, 0) [ Rail ] [ t(0, 0.8, 0) Rail ] offset(0.76, inside) comp(fe) { all : Bars }
    Rail    --> offset(0.74, inside) offset(0.04, border) reverseNormals extrude(0.05) Rail.
    Bars    --> alignScopeToAxes(y) t(0, 0.05, 0) s(^1, 0.75, 0.025) primitiveCube split(x) { { ~0.12 : NIL | 0.025 : Bar. }* | ~0.12 : NIL }

    // The first and the last storey have a balcony along the whole front, the others one for each window.
    Storey(n, total) --> split(x) { 0.7 : Wall | { ~bay : Bay(n > 0 && n < total - 1) }* | 0.7 : Wall }
    Bay(balcony) --> split(x) { ~1 : Wall | 1.3 : Column(balcony) | ~1 : Wall }
    Column(balcony) --> split(y) { ~1 : Window(balcony) | 0.3 : Ledge(0.1) | 0.45 : Wall }
    Balcony --> [ s(^1, 0.16, 0) extrude(0.25) color(stone) Slab. ] t(0, 0.16, 0) s(^1, 0.85, 0.23) primitiveCube color(iron)
                split(y) { 0.05 : Handrail | ~1 : split(z) { ~1 : NIL | 0.025 : Ends | ~1 : NIL | 0.04 : split(x) { 0.025 : Bar. | { ~0.12 : NIL | 0.025 : Bar. }* } } | 0.05 : Handrail }
    Handrail --> split(z) { ~1 : Ends | 0.04 : Rail. }
    Ends    --> split(x) { 0.025 : Bar. | ~1 : NIL | 0.025 : Bar. }
    Window(balcony) --> [ case balcony : Balcony else : NIL ]
                [ Recess(0.25) ] t(0, 0, -0.25) color(pane) split(x) { 0.07 : Frame | { ~0.5 : Sash | 0.07 : Frame }* }
    Recess(depth) --> set(trim.vertical, false) t(0, 0, -depth) s(^1, ^1, depth) primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : color(stone) Reveal. }
    Sash    --> split(y) { 0.35 : Frame | { ~0.75 : Glass | 0.05 : Frame }* }
    Glass   --> set(material.roughness, 0.08) Glass.
    Frame   --> color("#f4efe4") extrude(0.05) Frame.

    // Shops of wood and glass below awnings, with a door in every third.
    Shops   --> split(x) { 0.6 : Wall | { ~3.6 : Shop(split.index) | 0.6 : Pier(split.index == split.total - 1) }* }
    Pier(last) --> case last : Wall
                else : extrude(0.15) comp(f) { top : Wall | bottom : NIL | all : setupProjection(0, scope.xy, 2.7, 1.8) Wall }
    Shop(n) --> color(case n % 4 == 3 : "#39453f" else : "#4a2f2a") [ Recess(0.35) ] t(0, 0, -0.35)
                split(y) { ~1 : Front(n) | 0.7 : Sign }
    Front(n) --> [ case n % 3 == 0 : NIL else : t(0, ^1, 0.35) Awning ]
                [ case n % 6 == 1 : split(x) { 0.12 : Timber | ~1 : Panes | 1.1 : Door | ~1 : Panes | 0.12 : Timber } else : split(x) { 0.12 : Timber | ~1 : Panes | 0.12 : Timber } ]
    Panes   --> split(x) { ~1.1 : Panel(0.6) | { 0.12 : Timber | ~1.1 : Panel(0.6) }* }
    Door    --> split(x) { 0.12 : Timber | ~1 : split(x) { 0.09 : Leaf | ~1 : split(y) { 0.2 : Leaf | ~1 : color("#4a5f68") Glass | 0.1 : Leaf } | 0.09 : Leaf } | 0.12 : Timber }
    Leaf    --> extrude(0.05) Door.
    Panel(sill) --> split(y) { sill : Timber | ~1 : color("#4a5f68") Glass | 0.1 : Timber }
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
