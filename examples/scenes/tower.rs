//! A tower of turning storeys.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A residential tower: every storey is the ellipse of the footprint, turned a little further than the one below.
    pub grammar Tower;

    /// The number of storeys.
    @Group("Size", 1) @Order(1) @Range(min = 8, max = 80, stepsize = 1)
    attr storeys = 38
    /// The height of a storey in metres.
    @Order(2) @Distance @Range(min = 2.8, max = 5)
    attr storey = 3.6
    /// The turn between the lowest and the highest storey.
    @Group("Form", 2) @Order(1) @Angle @Range(min = -180, max = 180)
    attr twist = 150
    /// The share of its width that the tower loses on the way up.
    @Order(2) @Percent @Range(min = 0, max = 0.7)
    attr taper = 0.32
    /// The depth of the balconies in metres.
    @Order(3) @Distance @Range(min = 0.4, max = 3)
    attr balcony = 1.5
    @Group("Colours", 3) @Color
    attr concrete = "#efeae1"
    @Color
    attr glass = "#6b93a8"
    @Color
    attr timber = "#b98a5a"

    const lobby = 7.5
    const parapet = 1.05

    // The tower is slim at mid-height and a little wider again near the top.
    width(t) = 1 - taper * sin(t * 130)
    pane = 6% : "#f2d79b" 14% : "#86a9b8" else : glass

    @StartRule
    Lot    --> Plaza
               t(0, 0.5, 0) s(^0.7, 0, ^0.4) center(xz) primitiveDisk(48) deleteUV(0) Mass
    Mass   --> Lobby
               t(0, lobby, 0) extrude(storeys * storey) split(y) { { ~storey : Storey(split.index / split.total) }* | 0.01 : Crown }

    // A storey is a slab with railings around the rooms.
    Storey(t) --> s(^(width(t)), ^1, ^(width(t))) center(xz) r(scopeCenter, 0, twist * t, 0)
                  split(y) { 0.38 : Slab | ~1 : Rooms }
    Slab   --> color(concrete) Slab. comp(f) { top : Railing }
    Railing --> offset(-0.06, border) extrude(parapet) color("#dfeaec") set(material.opacity, 0.35) Railing.
    Rooms  --> s(scope.sx - 2 * balcony, ^1, scope.sz - 2 * balcony) center(xz)
               comp(f) { side : Bay(comp.index) }
    // Every sixth bay is a fin of timber.
    Bay(n) --> case n % 6 == 0 : color(timber) extrude(0.25) Fin.
               else            : split(x) { 0.07 : Mullion | ~1 : Pane | 0.07 : Mullion }
    Pane   --> split(y) { ~1 : color(pane) set(material.roughness, 0.08) Glass. | 0.25 : Mullion }
    Mullion --> color("#4a4f52") extrude(0.08) Mullion.

    Crown  --> s(^(width(1)), ^1, ^(width(1))) center(xz) r(scopeCenter, 0, twist, 0) comp(f) { top : Top }
    Top    --> alignScopeToAxes(y) [ extrude(0.4) color(concrete) Slab. ]
               [ t(0, 0.4, 0) offset(-0.3, border) extrude(1.8) color(timber) Screen. ]
               [ t(0, 0.4, 0) s(^0.5, 3.6, ^0.5) center(xz) primitiveCylinder(32) color("#d5d0c6") Plant. ]
               t(0, 4, 0) s(0.5, 17, 0.5) center(xz) primitiveCone(8) color("#c9ced1") set(material.metallic, 0.6) Mast.

    Lobby  --> [ s(^0.86, ^1, ^0.86) center(xz) extrude(lobby) comp(f) { side : Front(comp.index) } ]
               comp(e) { all : case comp.index % 4 == 2 : Column else : NIL }
    // A door of two leaves in front, another one at the back.
    Front(n) --> split(x) { 0.1 : Mullion | ~1 : split(y) { (case n % 24 == 0 : 3 else : 0) : Door | { ~1 : color("#3f5660") set(material.roughness, 0.08) Glass. | 0.12 : Mullion }* } }
    Door   --> split(y) { ~1 : split(x) { ~1 : Leaf | 0.04 : Mullion | ~1 : Leaf } | 0.12 : Mullion }
    Leaf   --> color(timber) extrude(0.06) Door.
    Column --> alignScopeToAxes(y) s(0.9, lobby, 0.9) t(0, 0, -1.6) primitiveCylinder(16) color(concrete) Column.

    Plaza  --> Paving(0.3, "#e0dace")
               t(0, 0.3, 0) s(^0.8, 0, ^0.6) center(xz) primitiveDisk(48) Paving(0.2, "#cec6b8")
    // The image lies on the top; the sides have it from the side.
    Paving(height, tint) --> extrude(height) color(tint) texture("paving.png") set(material.normalmap, "paving_normal.png") set(material.roughnessmap, "paving_rough.png")
               modify(f) { side : setupProjection(0, scope.xy, 3.6, 3.2) projectUV(0) | all : setupProjection(0, world.xz, 3.6, 3.2) projectUV(0) } Paving.
}

pub fn scene() -> Scene<()> {
    Scene {
        name: "tower",
        title: "Tower",
        sentence: "One rule makes all storeys: it turns and scales each slice of the mass by its number.",
        rules: grammar_text(include_str!("tower.rs")),
        grammar: (),
        shapes: vec![Start::new("Lot", Shape::rectangle(64.0, 64.0).seed(3))],
        view: View {
            azimuth: 24.0,
            elevation: 4.0,
            region: Some([[7.0, -3.0, 7.0], [57.0, 167.0, 57.0]]),
            size: [700, 900],
            ..View::default()
        },
    }
}
