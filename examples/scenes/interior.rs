//! A room.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    /// A room, cut open on two sides: floorboards, windows, shelves full of books, and a painting made by rules.
    pub grammar Interior;

    /// The height of the room in metres.
    @Group("Room", 1) @Order(1) @Distance @Range(min = 2.4, max = 4)
    attr height = 3
    /// The number of windows.
    @Order(2) @Range(min = 1, max = 4, stepsize = 1)
    attr windows = 2
    /// The width of a floorboard in metres.
    @Order(3) @Distance @Range(min = 0.06, max = 0.4)
    attr board = 0.15
    /// The chance that a place on the shelves is taken.
    @Group("Furniture", 2) @Order(1) @Percent @Range(min = 0, max = 1)
    attr books = 0.88
    /// The height of the sofa and of the armchair in metres.
    @Order(2) @Range(min = 0.7, max = 1.1)
    attr seat = 0.8
    /// The number of times that the painting is divided.
    @Order(3) @Range(min = 1, max = 6, stepsize = 1)
    attr divisions = 4
    @Group("Colours", 3) @Color
    attr wall = "#e9e4d8"
    @Color
    attr fabric = "#3f6f78"
    @Color
    attr wood = "#8a5c3a"

    const thick = 0.22
    oak    = 40% : "#b98b5a" 35% : "#ad7f50" else : "#c49868"
    cover  = 22% : "#8c3b34" 18% : "#2f4f6b" 16% : "#d8c79c" 14% : "#47614a" 12% : "#c98a3b" else : "#e6e0d2"
    flat   = 14% : "#c23a2e" 12% : "#2d559b" 12% : "#e7bd3c" else : "#f3efe4"
    leaf   = 50% : "#55803f" else : "#6c9750"

    @StartRule
    Room    --> [ t(0, -0.25, 0) extrude(0.23) color("#cfc9bd") Slab. ]
                [ t(0, -0.02, 0) split(z) { { ~board : Boards }* } ]
                [ s(thick, height, ^1) t(-thick, 0, 0) primitiveCube Side ]
                [ s(scope.sx + thick, height, thick) t(-thick, 0, -thick) primitiveCube Back ]
                Furniture
    Boards  --> split(x) { ~rand(0.3, 1.6) : Board | { ~1.9 : Board }* }
    Board   --> color(oak) extrude(0.02) Board.

    // The windows of the side wall, with curtains inside.
    Side    --> color(wall) split(z) { 0.9 : Wall. | { ~((scope.sz - 0.9) / windows - 0.8) : Window | 0.8 : Wall. }* }
    Back    --> color(wall) [ Wall. ] t(thick, 0, thick) s(scope.sx - thick, 0.12, 0.02) primitiveCube color("#f7f4ec") Skirting.
    Window  --> split(y) { 0.55 : Wall. | ~1 : Opening | 0.3 : Wall. }
    Opening --> [ t(^1, -0.25, -0.35) s(0.09, scope.sy + 0.35, scope.sz + 0.7)
                  split(y) { ~1 : split(z) { 0.4 : Curtain | ~1 : NIL | 0.4 : Curtain } | 0.05 : color(wood) Rail. } ]
                color("#faf8f2") [ s(thick + 0.12, 0.04, ^1) primitiveCube Sill. ]
                s(0.06, ^1, ^1) center(x) split(z) { 0.07 : Frame. | ~1 : Sash | 0.07 : Frame. | ~1 : Sash | 0.07 : Frame. }
    Curtain --> split(z) { { ~0.1 : primitiveCylinder(10) color("#d9cdb6") Fold. }* }
    Sash    --> split(y) { 0.1 : Frame. | ~1 : NIL | 0.05 : Frame. | ~2 : NIL | 0.07 : Frame. }

    Furniture --> [ t(0.8, 0, 1.1) s(3.6, 0.015, 3.1) primitiveCube Rug ]
                [ t(1.3, 0, 0.15) s(2.5, seat, 1) primitiveCube Sofa ]
                [ t(0.7, 0, 2.2) s(1, seat, 1) r(scopeCenter, 0, 70, 0) primitiveCube Sofa ]
                [ t(2.05, 0, 1.9) s(1.3, 0.38, 0.75) primitiveCube Table(0.05) ]
                [ t(1.75, 1.35, 0.01) s(1.6, 1.15, 0.05) primitiveCube Painting ]
                [ t(4.4, 0, 0.01) s(2.6, 2.3, 0.34) primitiveCube Shelves ]
                [ t(0.35, 0, 0.35) s(0.5, 1.7, 0.5) Lamp ]
                [ t(0.4, 0, 4.6) s(0.5, 0.5, 0.5) Plant ]
                [ t(4.9, 0, 2.7) s(1.9, 0.75, 0.95) primitiveCube Table(0.04) ]
                [ t(5.1, 0.75, 3) s(0.22, 0.1, 0.22) primitiveCylinder(20) color("#d8b15a") Widened(1.6) ]
                t(5.05, 0, 2.25) s(0.46, 0.88, 0.46) [ Chair ] t(1, 0, 0) [ Chair ]
                t(-1, 0, 1.4) [ r(scopeCenter, 0, 180, 0) Chair ] t(1, 0, 0) r(scopeCenter, 0, 172, 0) Chair

    Rug     --> comp(f) { top : offset(-0.25) comp(f) { inside : color("#d9c7a3") Rug. | border : color("#9c4a3c") Rug. } | all : NIL }
    // A sofa and an armchair are one rule: the width determines the number of cushions.
    Sofa    --> color(fabric) split(x) { 0.18 : Arm | ~1 : split(z) { 0.24 : Rest. | ~1 : Seat } | 0.18 : Arm }
    Arm     --> s(^1, ^0.72, ^1) Arm.
    Seat    --> split(y) { 0.24 : Base. | 0.2 : split(x) { { ~0.75 : Cushion }* } | ~1 : NIL }
    Cushion --> s(^0.97, ^1, ^1.02) center(x) color("#4e8089") Cushion.
    Table(top) --> color(wood) split(y) { ~1 : Legs(0.06) | top : Top. }
    Legs(w) --> s(^0.94, ^1, ^0.9) center(xz) split(x) { w : Pair(w) | ~1 : NIL | w : Pair(w) }
    Pair(w) --> split(z) { w : Leg. | ~1 : NIL | w : Leg. }
    Chair   --> primitiveCube color("#c9a06b") split(y) { 0.43 : Legs(0.04) | 0.04 : Seat. | ~1 : split(z) { 0.04 : Rest | ~1 : NIL } }
    Rest    --> split(y) { ~1 : split(x) { 0.04 : Post. | ~1 : NIL | 0.04 : Post. } | 0.16 : Post. }

    Shelves --> color("#f2eee4") split(x) { 0.03 : Board. | { ~0.8 : Bay | 0.03 : Board. }* }
    Bay     --> split(y) { 0.08 : Board. | { ~0.33 : Shelf | 0.03 : Board. }* }
    Shelf   --> split(z) { 0.02 : Board. | ~1 : split(x) { { ~0.045 : Book }* } }
    Book    --> case p(books) : s(^0.94, ^(rand(0.62, 0.92)), ^(rand(0.6, 0.85))) color(cover) Book. else : NIL

    Painting --> split(z) { ~1 : color("#2b2622") Frame. | 0.02 : s(scope.sx - 0.08, scope.sy - 0.08, ^1) center(xy) Canvas(divisions) }
    Canvas(n) --> case n == 0 : color(flat) Paint.
                else : 50% : split(x) { ^(rand(0.25, 0.75)) : Canvas(n - 1) | 0.02 : Stroke | ~1 : Canvas(n - 1) }
                       else : split(y) { ^(rand(0.25, 0.75)) : Canvas(n - 1) | 0.02 : Stroke | ~1 : Canvas(n - 1) }
    Stroke  --> color("#1f1d1b") Stroke.

    Lamp    --> color("#3a3a3c") [ s(0.32, 0.03, 0.32) center(xz) primitiveCylinder(24) Foot. ]
                [ s(0.03, ^1, 0.03) center(xz) primitiveCylinder(8) Pole. ]
                t(0, scope.sy - 0.3, 0) s(^1, 0.36, ^1) primitiveCylinder(24) color("#f7e3b4") Widened(0.6)
    Widened(factor) --> modify(f) { top : s(^factor, ^factor, ^1) center(xy) } Turned.
    Plant   --> [ s(^0.8, ^1, ^0.8) center(xz) primitiveCylinder(20) color("#b0694c") Widened(1.3) ]
                t(0.1, 0.5, 0.1) s(0.3, 0, 0.3) primitiveQuad scatter(surface, 6, uniform) { Stem(rand(0.55, 1)) }
    Stem(length) --> s(0.02, length, 0.02) color("#6b7d45") [ center(xz) primitiveCylinder(6) Stem. ]
                primitiveCube split(y) { 0.08 : NIL | { ~0.14 : Leaf }* }
    Leaf    --> r(rand(-20, 20), rand(360), rand(10, 50)) s(0.36, 0.03, 0.13) t(0, 0, -0.065) primitiveSphere(8, 4) color(leaf) Leaf.
}

pub fn scene() -> Scene<()> {
    Scene {
        name: "interior",
        title: "Interior",
        sentence: "Furniture is made of splits too: one rule makes sofa and armchair, and a recursive one the painting.",
        rules: grammar_text(include_str!("interior.rs")),
        grammar: (),
        shapes: vec![Start::new("Room", Shape::rectangle(7.4, 5.6).seed(4))],
        view: View {
            azimuth: 36.0,
            elevation: 27.0,
            region: Some([[0.0, 0.0, 0.0], [7.4, 3.0, 5.6]]),
            sun_azimuth: -118.0,
            sun_elevation: 33.0,
            ..View::default()
        },
    }
}
