//! *setback*, *setbackPerEdge*, *setbackToArea* and *splitAndSetbackPerimeter operations*, on lots as in the
//! pictures. The pages give most rules without the rules of the colours, which are given here once for all examples.

use cga::glam::DVec3;
use cga::{Mesh, MeshBuilder, Shape};

use super::example::{Example, example};

/// In the order of the pages. Examples that need maps of streets, occlusion or attributes of edges are left out.
pub const ALL: &[Example] = &[
    street_front::EXAMPLE,
    alternating::EXAMPLE,
    by_selectors::EXAMPLE,
    left_handed::EXAMPLE,
    right_handed::EXAMPLE,
    drawn_once::EXAMPLE,
    drawn_per_edge::EXAMPLE,
    by_index::EXAMPLE,
    by_length::EXAMPLE,
    printing::EXAMPLE,
    area_left::EXAMPLE,
    area_right::EXAMPLE,
    area_of_an_l::EXAMPLE,
    area_of_a_larger_lot::EXAMPLE,
    area_between::EXAMPLE,
    perimeter::EXAMPLE,
    perimeter_relative::EXAMPLE,
    perimeter_fronts::EXAMPLE,
    perimeter_random::EXAMPLE,
    perimeter_indices::EXAMPLE,
    perimeter_left::EXAMPLE,
    perimeter_right::EXAMPLE,
];

/// Faces on the ground, with small second coordinates at the front.
pub fn faces(outlines: &[&[[f64; 2]]]) -> Shape {
    let mut builder = MeshBuilder::new();
    let mut known: Vec<[f64; 2]> = Vec::new();
    for outline in outlines {
        let mut point = |corner: [f64; 2]| match known.iter().position(|other| *other == corner) {
            Some(number) => number as u32,
            None => {
                known.push(corner);
                builder.point(DVec3::new(corner[0], 0.0, -corner[1]))
            }
        };
        let points: Vec<u32> = outline.iter().map(|corner| point(*corner)).collect();
        builder.face(&points, &[], cga::mesh::FaceTag::PLAIN);
    }
    Shape::mesh(builder.build().expect("faces"))
}

fn lot(corners: &[[f64; 2]]) -> Shape {
    let corners: Vec<DVec3> = corners.iter().map(|[x, z]| DVec3::new(*x, 0.0, -z)).collect();
    Shape::mesh(Mesh::from_polygon(&corners, &[]).expect("an outline"))
}

/// A lot of four edges beside one of five.
fn two() -> Shape {
    faces(&[
        &[[2.0, 0.0], [15.0, 0.4], [16.2, 12.4], [0.8, 12.4]],
        &[[15.0, 0.4], [27.8, 0.6], [29.1, 6.4], [22.0, 12.2], [16.2, 12.4]],
    ])
}

/// Two lots of four edges.
fn pair() -> Shape {
    faces(&[
        &[[0.9, 0.5], [14.2, 2.3], [13.8, 10.9], [1.8, 10.1]],
        &[[14.2, 2.3], [28.2, 1.2], [28.4, 9.9], [13.8, 10.9]],
    ])
}

fn kite() -> Shape {
    lot(&[[3.2, 0.2], [14.8, 4.4], [6.6, 13.3], [1.2, 8.5]])
}

fn with_notch() -> Shape {
    lot(&[[4.2, 0.4], [25.4, 0.0], [24.8, 15.2], [15.0, 14.2], [11.0, 23.1], [0.8, 21.7]])
}

/// The lot of the first pictures of the perimeter.
fn bay() -> Shape {
    lot(&[[0.6, 13.0], [14.0, 0.0], [34.0, 0.0], [44.0, 14.0], [59.4, 14.0], [59.4, 31.6], [0.6, 31.6]])
}

/// Eight edges; numbers 7, 0 and 1 look to the front.
fn eight() -> Shape {
    lot(&[
        [16.5, 0.0],
        [36.0, -4.0],
        [54.0, 0.0],
        [66.0, 14.0],
        [62.0, 40.0],
        [10.0, 42.0],
        [-14.0, 30.0],
        [-15.0, 8.0],
    ])
}

fn chamfered() -> Shape {
    lot(&[[0.0, 0.0], [5.9, 0.0], [8.7, 2.7], [8.7, 7.8], [0.0, 7.8]])
}

example! {
    /// "Setback on Street Front"
    street_front, "setback operation, street front", lot(&[[0.0, 0.0], [30.0, -3.0], [38.0, 24.0], [4.0, 30.0]]),
    r##"LotInner --> Lot
Lot --> setback(5) { street.front = Garden |
                     remainder    : Building }
Garden --> color("#00ff00")
Building --> offset(-3, inside)
             extrude(world.up, rand(5, 15))
"##
}

example! {
    /// "The distances in the array are applied in face-edge order."
    alternating, "setback operation, alternating distances", two(),
    r##"// (9)[1,6,1,6,1,6,1,6,1]
const dists = comp(fe) { all : case comp.index%2 == 0 : 1
                               else                   : 6 }
Lot --> setback(dists) { all       = Garden |
                         remainder : Building }

Garden --> color("#00ff00")
Building --> color("#d8d8d8")
"##; marks &[Mark::FromAbove]
}

example! {
    /// "In this example the comp function is used with different selectors and operators."
    by_selectors, "setback operation, distances by selectors", two(),
    r##"// (9)[4,0,2,0.5,5,0.5,2,2,0]
const dists = comp(fe) { inside = 0 |
                         front  :
                            case comp.index == 0 : 4
                            else                 : 5 |
                         back   = 2 |
                         side   = 0.5 }
Lot --> setback(dists) { all       = Garden |
                         remainder : Building }

Garden --> color("#00ff00")
Building --> color("#d8d8d8")
"##; marks &[Mark::FromAbove]
}

example! {
    /// "A left-handed L shape using the shapeL operation."
    left_handed, "setback operation, left-handed L", Shape::rectangle(14.0, 12.0),
    r##"Left --> shapeL(5, 5) { shape     = Garden |
                        remainder : Building }

Garden --> color("#00ff00")
Building --> color("#d8d8d8")
"##; marks &[Mark::FromAbove]
}

example! {
    /// "A right-handed L shape shape using setback."
    right_handed, "setback operation, right-handed L", Shape::rectangle(14.0, 12.0),
    r##"// (4)[5,5,0,0]
const dists = comp(fe) { front = 5 | right = 5 }
Right --> setback(dists) { all       = Garden |
                           remainder : Building }

Garden --> color("#00ff00")
Building --> color("#d8d8d8")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "While for setback the distance is evaluated once and assigned the same for all edges…"
    drawn_once, "setbackPerEdge operation, setback", kite(),
    r##"Lot1 --> setback(rand(5))
         { front = Red | back = Blue | left = Green }

Red --> color("#ff0000")
Green --> color("#00ff00")
Blue --> color("#0000ff")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "… setbackPerEdge re-evaluates the distance for each edge."
    drawn_per_edge, "setbackPerEdge operation, setbackPerEdge", kite(),
    r##"Lot2 --> setbackPerEdge(rand(5))
         { front = Red | back = Blue | left = Green }

Red --> color("#ff0000")
Green --> color("#00ff00")
Blue --> color("#0000ff")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "The comp.index attribute is used to extract the distance from an ordered float array."
    by_index, "setbackPerEdge operation, comp shape attributes", pair(),
    r##"const dists = [3,2,1,0,0,1,2,3]
dist = dists[comp.index]
Lot --> setbackPerEdge(dist) { all = Green }

Green --> color("#00ff00")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "Setbacks are applied relative to edge lengths."
    by_length, "setbackPerEdge operation, comp shape geometry", pair(),
    r##"Lot --> setbackPerEdge(scope.sx / 7.5) { all = Green }

Green --> color("#00ff00")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "The debug function is evaluated 4 times, once for each edge."
    printing, "setbackPerEdge operation, setbackPerEdge as setback", Shape::rectangle(14.0, 12.0),
    r##"debug = print(comp.index+5)
Lot --> setbackPerEdge(debug) { front = Green }

Green --> color("#00ff00")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "A square shape with an area of 400 is setback to an area of 100."
    area_left, "setbackToArea operation, remainder of 100", Shape::rectangle(20.0, 20.0),
    r##"Left --> setbackToArea(100) { all       = NIL |
                              remainder = Green }

Green --> color("#00ff00")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "A setback is performed such that all setback faces have an area of 300."
    area_right, "setbackToArea operation, setback of 300", Shape::rectangle(20.0, 20.0),
    r##"Right --> setbackToArea(geometry.area - 300)
          { all = Green }

Green --> color("#00ff00")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "A L-shaped setback to area 100 and 300."
    area_of_an_l, "setbackToArea operation, L", with_notch(),
    r##"attr area = 100
Lot --> setbackToArea(area) { front     = Blue |
                              left      = Red |
                              remainder = Green }

Red --> color("#ff0000")
Green --> color("#00ff00")
Blue --> color("#0000ff")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "A setback to area 100 on the same shape at different scales."
    area_of_a_larger_lot, "setbackToArea operation, scale", with_notch(),
    r##"Lot --> setbackToArea(100) { all       = Blue |
                             remainder = Green }

Green --> color("#00ff00")
Blue --> color("#0000ff")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "The setback to restricted by minimum and maximum distances (highlighted in red)."
    area_between, "setbackToArea operation, lower and upper bounds",
    lot(&[[2.0, 0.0], [22.0, 1.0], [26.0, 12.0], [17.0, 24.0], [0.0, 20.0]]),
    r##"attr area = 300
const minDists = comp(fe) { all : rand(3) }
const maxDists = comp(fe) { all : rand(3, 6) }
ShowDists(dists) -->
    setback(dists) { all = NIL |
                     remainder =
                        comp(e) { all = Red } }
Lot -->
    ShowDists(minDists)
    ShowDists(maxDists)
    setbackToArea(area, minDists, maxDists)
                 { all = NIL |
                   remainder = Green }

Red --> color("#ff0000")
Green --> color("#00ff00")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "First the perimeter of a polygon is split into sections according to the specified lengths."
    perimeter, "splitAndSetbackPerimeter operation, basic", bay(),
    r##"Lot --> splitAndSetbackPerimeter(6)
        { 40 :  5 : Yellow |
          20 : 10 : Blue }
        { remainder : Grey }
Yellow --> color("#F2BB1D")
Blue   --> color("#3957A5")
Grey   --> color("#CAC9C6")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "The start of the split pattern is offset by 10% of the length of the perimeter."
    perimeter_relative, "splitAndSetbackPerimeter operation, relative splitOffset", bay(),
    r##"Lot --> splitAndSetbackPerimeter('0.1)
        { '0.5 : 10 : extrude(15) Yellow |
          ~1   :  0 : NIL |
          '0.4 :  8 : extrude(10) Blue |
          ~1   :  0 : NIL }
        { remainder : Grey }

Yellow --> color("#F2BB1D")
Blue   --> color("#3957A5")
Grey   --> color("#CAC9C6")
"##
}

example! {
    /// "A section centered on the front edges of the perimeter is setback."
    perimeter_fronts, "splitAndSetbackPerimeter operation, selected edges", eight(),
    r##"const INF = 100000
// (8)[0.0,16.5,INF,INF,INF,INF,INF,-15.0]
frontXCoords = comp(fe) { front : pivot.px | all : INF }
// 7
frontLeftMostEdgeIndex = sortIndices(frontXCoords)[0]
// (8)[true,true,false,false,false,false,false,true]
frontEdgesMask = comp(fe) { front : true }
Lot --> splitAndSetbackPerimeter(0,
            frontLeftMostEdgeIndex, frontEdgesMask)
        { ~1   :  0 : NIL |
          '0.7 : 10 : extrude(12) Yellow |
          ~1   :  0 : NIL }
        { remainder : Grey }

Yellow --> color("#F2BB1D")
Grey   --> color("#CAC9C6")
"##
}

example! {
    /// "The perimeter is repeatedly split and setback by a random distance."
    perimeter_random, "splitAndSetbackPerimeter operation, random distances", bay(),
    r##"Lot --> splitAndSetbackPerimeter(0)
        { ~30 : rand(3, 15) : extrude(rand(2, 10)) Yellow }*
        { remainder : Grey }

Yellow --> color("#F2BB1D")
Grey   --> color("#CAC9C6")
"##
}

example! {
    /// "The perimeter is repeatedly split and setback based on the split attribute."
    perimeter_indices, "splitAndSetbackPerimeter operation, distances by index", bay(),
    r##"Lot --> splitAndSetbackPerimeter(0)
        { ~30 : split.index : extrude(split.index) Yellow }*
        { remainder : Grey }

Yellow --> color("#F2BB1D")
Grey   --> color("#CAC9C6")
"##
}

example! {
    /// "The overlap belongs to the shape that has been generated with larger depth…"
    perimeter_left, "splitAndSetbackPerimeter operation, overlap on the left", chamfered(),
    r##"Left --> splitAndSetbackPerimeter(3)
         { 2 : 6 : Yellow | 2 : 0 : NIL | 2 : 4 : Blue }
         { remainder : Grey }

Yellow --> color("#F2BB1D")
Blue   --> color("#3957A5")
Grey   --> color("#CAC9C6")
"##; marks &[Mark::FromAbove]
}

example! {
    /// "… and is cut away from the other."
    perimeter_right, "splitAndSetbackPerimeter operation, overlap on the right", chamfered(),
    r##"Right --> splitAndSetbackPerimeter(3)
          { 2 : 4 : Yellow | 2 : 0 : NIL | 2 : 6 : Blue }
          { remainder : Grey }

Yellow --> color("#F2BB1D")
Blue   --> color("#3957A5")
Grey   --> color("#CAC9C6")
"##; marks &[Mark::FromAbove]
}
