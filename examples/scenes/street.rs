//! Streets with junctions.

use cga::street::{Centerline, Network, NetworkOptions};
use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// Streets with CityEngine's start rules, and the houses beside them.
    pub grammar Streets;

    /// The height of the kerb in metres.
    @Group("Street", 1) @Order(1) @Distance @Range(min = 0.05, max = 0.3)
    attr kerb = 0.16
    /// The distance between two trees or lamps in metres.
    @Order(2) @Distance @Range(min = 6, max = 40)
    attr spacing = 11
    /// The share of parking places that are taken.
    @Order(3) @Percent @Range(min = 0, max = 1)
    attr parked = 0.55
    /// The storeys of the highest houses.
    @Group("Houses", 2) @Range(min = 2, max = 10, stepsize = 1)
    attr storeys = 5
    @Group("Colours", 3) @Color
    attr asphalt = "#62646a"
    @Color
    attr paving = "#c9c2b4"
    @Color
    attr paint = "#f1efe8"

    // Markings lie a little above the asphalt.
    const above = 0.03
    leaves  = 40% : "#86ad60" 35% : "#6d9a57" else : "#a3c06c"
    enamel  = 25% : "#b3322c" 20% : "#2f5f8a" 20% : "#e9e6df" 15% : "#3c4043" else : "#b9bec2"
    plaster = 25% : "#e2c79a" 20% : "#d5a98a" 20% : "#e8e0d0" 15% : "#b8c0b4" else : "#b76e55"
    slate   = 50% : "#8c5a48" else : "#6f747b"
    toStreet = minimumDistance(inter, "street")

    // Texture coordinates run along the street and across it, so markings follow every bend.
    @StartRule
    Street  --> label("street") [ Asphalt ]
                t(0, above, 0) split(u, unitSpace, 0) { 1.2 : NIL | 3 : Zebra | 1 : NIL | ~1 : Lanes | 1 : NIL | 3 : Zebra | 1.2 : NIL }
    Asphalt --> tileUV(0, 3, 3) color(asphalt) texture("asphalt.png") set(material.normalmap, "asphalt_normal.png") set(material.roughnessmap, "asphalt_rough.png") Roadway.
    Zebra   --> color(paint) split(v, unitSpace, 0) { 0.4 : NIL | { ~0.55 : Marking. | ~0.55 : NIL }* | 0.4 : NIL }
    Lanes   --> case scope.sz > 9 :
                    split(v, unitSpace, 0) { 2.3 : Parking | 0.12 : Line | ~1 : Traffic | 0.14 : Dashes | ~1 : Traffic | 0.12 : Line | 2.3 : Parking }
                else              : split(v, unitSpace, 0) { ~1 : Traffic | 0.14 : Dashes | ~1 : Traffic }
    Line    --> color(paint) Marking.
    Dashes  --> color(paint) split(u, unitSpace, 0) { { 2.5 : Marking. | ~3 : NIL }* }
    Parking --> split(u, unitSpace, 0) { 3 : NIL | { ~5.6 : Place }* | 3 : NIL }
    Traffic --> split(u, unitSpace, 0) { { ~19 : Gap }* }
    Place   --> case p(parked) : Car else : NIL
    Gap     --> case p(0.25) : Car else : NIL

    // A car is a body, a cabin that is smaller above, and four wheels.
    Car     --> color(enamel) set(trim.vertical, false) s(4.3, 0, 1.75) center(xz) primitiveQuad
                [ t(0, 0.3, 0) extrude(0.55) Body. ]
                [ t(^0.22, 0.85, 0.06) s(^0.55, 0.55, scope.sz - 0.12) primitiveCube
                  modify(f) { top : s(^0.7, ^0.9, ^1) center(xy) } color("#2e3a42") set(material.roughness, 0.1) Cabin. ]
                split(x) { 0.5 : NIL | 0.7 : Axle | ~1 : NIL | 0.7 : Axle | 0.5 : NIL }
    Axle    --> s(^1, 0.7, scope.sz + 0.04) center(z) primitiveCube rotateScope(90, 0, 0) primitiveCylinder(14) color("#26282a") Wheels.

    @StartRule
    Joint   --> Asphalt
    @StartRule
    Junction --> Asphalt
    @StartRule
    Crossing --> Asphalt

    // Trees and lamps alternate along the kerb.
    @StartRule
    Sidewalk --> [ tileUV(0, 1.8, 1.6) extrude(world.up, kerb) color(paving) texture("paving.png") set(material.normalmap, "paving_normal.png") set(material.roughnessmap, "paving_rough.png")
                modify(f) { side : setupProjection(0, scope.xy, 1.8, 1.6) projectUV(0) } Pavement. ]
                t(0, kerb, 0) split(v, unitSpace, 0) { 0.4 : NIL | 1.2 : Furniture | ~1 : NIL }
    Furniture --> split(u, unitSpace, 0) { ~spacing / 2 : NIL | { 1.2 : Tree | ~spacing : NIL | 0.2 : Lamp | ~spacing : NIL }* | ~1 : NIL }
    Tree    --> [ color("#7b6a52") t(0, 0.02, 0) Pit. ] Room(rand(2.8, 3.8))
    // A tree stands clear of houses: it has the room of its crown for itself.
    Room(size) --> s(size, 2.4 + 1.2 * size, size) center(xz) primitiveCube Plant(size)
    Plant(size) --> case overlaps(inter, "house") : NIL
                else : [ s(0.3, 3.2, 0.3) center(xz) primitiveCylinder(8) color("#8a6d50") scaleUV(0, 1, 4) texture("bark.png") set(material.normalmap, "bark_normal.png") Trunk. ]
                       t(0, 2.4, 0) color(leaves) s(^1, size * 1.2, ^1) Crown(size)
    // A crown is a ball with tufts of leaves on it.
    Crown(size) --> [ s(^0.7, ^0.75, ^0.7) center(xyz) primitiveSphere(10, 7) Leafy(2 * size) ]
                s(^0.76, ^0.74, ^0.76) center(xyz) primitiveSphere(10, 6) scatter(surface, 14, uniform) { Tuft(rand(0.28, 0.44) * size) }
    Tuft(size) --> s(size, 0.8 * size, size) center(xyz) r(scopeCenter, rand(-30, 30), rand(0, 90), rand(-30, 30)) primitiveSphere(6, 4) Leafy(2 * size)
    Leafy(n) --> scaleUV(0, n, n / 2) texture("leaves.png") set(material.normalmap, "leaves_normal.png") Crown.
    Lamp    --> color("#3b4245") [ s(0.16, 5.5, 0.16) center(xz) primitiveCylinder(8) Pole. ]
                t(0, 5.5, 0) s(0.6, 0.35, 0.6) center(xz) primitiveSphere(10, 6) color("#fbeecb") Light.

    @StartRule
    House   --> t(0, kerb, 0) color(plaster) Storeys(rint(rand(storeys / 2, storeys)), slate)
    Storeys(n, roof) --> [ extrude(4 + 3.1 * n) label("house") comp(f) { bottom : NIL | top : Roof(roof) | all : setupProjection(0, scope.xy, 2.4, 2.4) Side } ]
    Roof(tint) --> roofGable(38, 0.5, 0, true, 0) label("house") comp(f) { isTagged("roof.side") : setupProjection(0, scope.xy, 2.4, 2.4) Wall | all : setupProjection(0, scope.xy, 2, 2) color(tint)
                texture("tile.png") set(material.normalmap, "tile_normal.png") set(material.roughnessmap, "tile_rough.png") projectUV(0) Roof. }
    Wall    --> texture("plaster.png") set(material.normalmap, "plaster_normal.png") projectUV(0) Wall.
    // A side faces a street if three metres ahead are nearer to it.
    Side    --> Ahead(toStreet)
    Ahead(before) --> t(0, 0, 3) Back(before < 12 && toStreet < before - 0.9)
    Back(faces) --> t(0, 0, -3) Faced(faces)
    Faced(faces) --> case faces : Front else : split(y) { 4 : Wall | { ~3.1 : Floor }* | 0.3 : Wall }
    Front   --> split(y) { 3.6 : Shops | 0.4 : Band | { ~3.1 : Floor }* | 0.3 : Band }
    Band    --> color("#efe8d8") extrude(0.2) Band.
    Shops   --> split(x) { 0.4 : Wall | 1.2 : Entrance | 0.4 : Wall | { ~3.6 : Shop | 0.4 : Wall }* }
    Entrance --> split(y) { 2.7 : [ Recess(0.3) ] t(0, 0, -0.3) Portal | ~1 : Wall }
    Portal  --> split(y) { 2.1 : color(enamel) Door. | 0.08 : color("#f6f1e6") extrude(0.08) Frame. | ~1 : color("#54707d") set(material.roughness, 0.1) Glass. }
    Shop    --> split(y) { 0.3 : Wall | ~1 : Display }
    Display --> [ Recess(0.3) ] [ t(0, 0, -0.3) color("#54707d") set(material.roughness, 0.1) Glass. ]
                t(0, scope.sy - 0.9, 0) color(enamel) s(^1, 0.9, 1.3) primitiveCube
                split(z) { 0.15 : Sign. | ~1 : split(y) { 0.1 : Awning. | ~1 : NIL } }
    Recess(depth) --> set(trim.vertical, false) t(0, 0, -depth) s(^1, ^1, depth) primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : Reveal. }
    Floor   --> split(x) { { ~2.7 : Bay }* }
    // A wall that touches the neighbour has no window.
    Bay     --> case touches(inter, "house") : Wall
                else : split(x) { ~1 : Wall | 1.1 : split(y) { 0.8 : Wall | ~1 : Window | 0.5 : Wall } | ~1 : Wall }
    Window  --> [ Recess(0.12) ] offset(-0.09)
                comp(f) { border : t(0, 0, -0.12) color("#f6f1e6") extrude(0.08) Frame. | inside : t(0, 0, -0.12) color("#5d7888") set(material.roughness, 0.1) Glass. }

    // The ground of a block, as high as the sidewalks around it.
    @StartRule
    Yard    --> extrude(kerb - 0.01) color(paving) texture("paving.png") set(material.normalmap, "paving_normal.png") set(material.roughnessmap, "paving_rough.png")
                modify(f) { side : setupProjection(0, scope.xy, 1.8, 1.6) projectUV(0) | all : setupProjection(0, world.xz, 1.8, 1.6) projectUV(0) } Yard.
    @StartRule
    Green   --> [ extrude(kerb - 0.03) color("#8dab66") texture("grass.png") set(material.normalmap, "grass_normal.png")
                modify(f) { side : setupProjection(0, scope.xy, 4, 4) projectUV(0) | all : setupProjection(0, world.xz, 4, 4) projectUV(0) } Lawn. ]
                t(0, kerb, 0) offset(-3, inside) scatter(surface, 16, uniform) { Tree }
}

/// A line on the ground.
type Line = [[f64; 2]; 2];

/// The line to the left of another one, at a distance in metres.
fn left([from, to]: Line, distance: f64) -> Line {
    let [x, z] = [to[0] - from[0], to[1] - from[1]];
    let by = distance / (x * x + z * z).sqrt();
    [from, to].map(|[a, b]| [a + z * by, b - x * by])
}

/// The point of a line at a coordinate: 0 for x, 1 for z.
fn at([from, to]: Line, axis: usize, value: f64) -> [f64; 2] {
    let share = (value - from[axis]) / (to[axis] - from[axis]);
    [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))
}

/// The point in which two lines meet.
fn meet(a: Line, b: Line) -> [f64; 2] {
    let [[ux, uz], [vx, vz]] = [a, b].map(|[from, to]| [to[0] - from[0], to[1] - from[1]]);
    let share = ((b[0][0] - a[0][0]) * vz - (b[0][1] - a[0][1]) * vx) / (ux * vz - uz * vx);
    [a[0][0] + share * ux, a[0][1] + share * uz]
}

/// Lots of about 13 m along a line, to its left.
fn row(from: [f64; 2], to: [f64; 2]) -> Vec<Shape> {
    let count = ((to[0] - from[0]) / 13.0).round();
    let along = |number: f64| [0, 1].map(|axis| from[axis] + number / count * (to[axis] - from[axis]));
    let lot = |number: usize| {
        let front = [along(number as f64), along(number as f64 + 1.0)];
        let back = left(front, 13.0);
        Shape::footprint(&[front[0], front[1], back[1], back[0]], &[]).expect("a rectangle")
    };
    (0..count as usize).map(lot).collect()
}

pub fn scene() -> Scene<()> {
    let (west, east): (Line, Line) = ([[-70.0, 4.0], [0.0, 0.0]], [[0.0, 0.0], [75.0, -4.0]]);
    let (south, north): (Line, Line) = ([[6.0, 60.0], [0.0, 0.0]], [[0.0, 0.0], [-10.0, -60.0]]);
    let lane: Line = [[38.0, -2.0], [44.0, -60.0]];
    let lines = [
        Centerline::new(&[west[0], west[1], east[1]]).roadway(12.0).sidewalks(4.0, 4.0),
        Centerline::new(&[south[0], south[1], north[1]]).roadway(8.0).sidewalks(3.0, 3.0),
        Centerline::new(&lane).roadway(7.0).sidewalks(3.0, 3.0),
    ];
    let network = Network::new(&lines, &NetworkOptions::default()).expect("a network");
    let parts = network.parts().iter().zip(1..);
    let streets = parts.map(|(part, seed)| Start::new(part.start_rule(), part.shape().seed(seed)));

    // The blocks reach to the sidewalks, two centimetres below them.
    let [left_west, left_east] = [west, east].map(|line| left(line, 9.98));
    let [right_west, right_east] = [west, east].map(|line| left(line, -9.98));
    let [[north_left, north_right], [south_left, south_right]] =
        [north, south].map(|line| [left(line, 6.98), left(line, -6.98)]);
    let [lane_left, lane_right] = [left(lane, 6.48), left(lane, -6.48)];
    let outline = |points: [[f64; 2]; 4]| Shape::footprint(&points, &[]).expect("an outline");
    let yards = [
        [at(left_west, 0, -70.0), meet(left_west, north_left), at(north_left, 1, -58.0), [-70.0, -58.0]],
        [meet(left_east, north_right), meet(left_east, lane_left), at(lane_left, 1, -58.0), at(north_right, 1, -58.0)],
        [meet(left_east, lane_right), at(left_east, 0, 75.0), [75.0, -58.0], at(lane_right, 1, -58.0)],
    ];
    let yards = yards.map(|yard| Start::new("Yard", outline(yard)));
    let houses = [
        row(at(left_west, 0, -69.0), at(left_west, 0, -10.5)),
        row(at(left_east, 0, 7.0), at(left_east, 0, 31.4)),
        row(at(left_east, 0, 47.6), at(left_east, 0, 74.0)),
    ];
    let houses = houses.into_iter().flatten().zip(11..).map(|(lot, seed)| Start::new("House", lot.seed(seed)));
    let greens = [
        [meet(right_west, south_left), at(right_west, 0, -66.0), [-66.0, 42.0], at(south_left, 1, 42.0)],
        [at(right_east, 0, 70.0), meet(right_east, south_right), at(south_right, 1, 42.0), [70.0, 42.0]],
    ];
    let greens = greens.into_iter().zip(21..).map(|(green, seed)| Start::new("Green", outline(green).seed(seed)));
    Scene {
        name: "street",
        title: "Street with junctions",
        sentence: "The library lays out roadways, sidewalks and junctions from three centre lines; rules with CityEngine's names furnish them. Shops face a street, and walls between houses have no windows.",
        rules: grammar_text(include_str!("street.rs")),
        grammar: (),
        shapes: streets.chain(houses).chain(yards).chain(greens).collect(),
        view: View {
            size: [960, 640],
            azimuth: 18.0,
            elevation: 27.0,
            region: Some([[-32.0, 0.0, -18.0], [46.0, 14.0, 19.0]]),
            ..View::default()
        },
    }
}
