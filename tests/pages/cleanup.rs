//! *cleanupGeometry operation*, and the examples of other pages that clean up: *Geometry tagging*, *Shape recomposition*, *Boolean
//! operations* and *modify operation*.

use cga::{MeshBuilder, Shape};

use super::example::{Example, example};
use super::tags::{propagation, quarter_cut_out};

/// In the order of the pages.
pub const ALL: &[Example] = &[
    house::EXAMPLE,
    house_0::EXAMPLE,
    house_0_1::EXAMPLE,
    kept::EXAMPLE,
    merged::EXAMPLE,
    f_shape::EXAMPLE,
    layout_2::EXAMPLE,
    layout_3::EXAMPLE,
    outsets::EXAMPLE,
    smooth::EXAMPLE,
];

/// A house of triangles. The planes of its roof are bent by half a degree.
fn triangulated_house() -> Shape {
    const COLUMNS: u32 = 5;
    const BEND: f64 = 0.01;
    let mut builder = MeshBuilder::new();
    let mut grid = |rows: u32, place: &dyn Fn(f64, f64) -> [f64; 3]| {
        let at =
            |column: u32, row: u32| place(f64::from(column) / f64::from(COLUMNS), f64::from(row) / f64::from(rows));
        for (column, row) in (0..COLUMNS).flat_map(|column| (0..rows).map(move |row| (column, row))) {
            let places = [at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)];
            let [a, b, c, d] = places.map(|place| builder.point(place));
            builder.polygon(&[a, b, c]).polygon(&[a, c, d]);
        }
    };
    // The profile across the ridge: half the width, and the height.
    let profile = [[3.0, 0.0], [3.0, 5.0], [1.5, 6.5 + BEND], [0.0, 8.0], [-1.5, 6.5 + BEND], [-3.0, 5.0], [-3.0, 0.0]];
    for pair in profile.windows(2) {
        let [[z, y], [far, high]] = [pair[0], pair[1]];
        grid(2, &|u, v| [10.0 * u, y + (high - y) * v, z + (far - z) * v]);
    }
    grid(1, &|u, v| [10.0 * u, 0.0, -3.0 + 6.0 * v]);
    for x in [0.0, 10.0] {
        let middle = builder.point([x, 4.0, 0.0]);
        let ring: Vec<u32> = (0..7)
            .flat_map(|k| {
                let [from, to] = [profile[k], profile[(k + 1) % 7]];
                let parts = if k == 6 { 1 } else { 2 };
                (0..parts)
                    .map(move |part| f64::from(part) / f64::from(parts))
                    .map(move |share| [from[0] + (to[0] - from[0]) * share, from[1] + (to[1] - from[1]) * share])
            })
            .map(|[z, y]| builder.point([x, y, z]))
            .collect();
        for (place, &corner) in ring.iter().enumerate() {
            let next = ring[(place + 1) % ring.len()];
            let triangle = if x == 10.0 { [next, corner, middle] } else { [corner, next, middle] };
            builder.polygon(&triangle);
        }
    }
    Shape::mesh_axis_aligned(builder.build().expect("a house"))
}

/// The outline with a hole of the picture of *modify operation*, as read from it.
fn jagged() -> Shape {
    let outline = [
        [0.2, 0.2],
        [13.0, 0.2],
        [6.5, 3.2],
        [11.6, 3.4],
        [7.4, 6.1],
        [12.3, 5.9],
        [7.7, 8.7],
        [10.4, 11.9],
        [6.3, 7.6],
        [7.4, 12.6],
        [1.6, 14.4],
        [4.4, 12.0],
        [2.1, 11.5],
        [3.9, 10.4],
        [0.5, 7.6],
        [4.9, 8.2],
        [4.2, 5.4],
        [1.0, 5.3],
    ];
    Shape::footprint(&outline, &[vec![[2.4, 2.3], [5.6, 2.3], [3.9, 4.1], [2.5, 4.2]]]).expect("an outline")
}

example! {
    /// "The original asset."
    house, "cleanupGeometry operation, the original asset", triangulated_house(),
    r##"Init --> House.
"##
}

example! {
    /// "Mild cleanup removes most disturbing edges."
    house_0, "cleanupGeometry operation, mild cleanup", triangulated_house(),
    r##"Init --> cleanupGeometry(all, 0) House.
"##
}

example! {
    /// "Increasing the tolerance gets rid of the remaining nasty edges."
    house_0_1, "cleanupGeometry operation, an increased tolerance", triangulated_house(),
    r##"Init --> cleanupGeometry(all, 0.1) House.
"##
}

propagation! {
    /// "Using the cleanupGeometry operation to merge coplanar faces has no effect because of the existing tags."
    kept, "Geometry tagging, Geometry cleanup, tagged edges", quarter_cut_out(),
    [offset(-2) cleanupGeometry(edges, 0)]
}

propagation! {
    /// "The adjacent faces with the same tags are merged."
    merged, "Geometry tagging, Geometry cleanup, without the tags of edges", quarter_cut_out(),
    [offset(-2) deleteTags("v", edges) cleanupGeometry(edges, 0)]
}

example! {
    /// "Remove the shared edges between coplanar faces and create the F-shaped polygon."
    f_shape, "Shape recomposition, the F-shaped polygon", Shape::rectangle(20.0, 40.0),
    r##"Init -->
    inline(recompose) split(x) { 10: X.
                               | ~1: split(z) { 10: X. | 10: NIL }* }
    cleanupGeometry(all,0)
    F.
"##; marks &[Mark::From(57.0, 30.0)]
}

example! {
    /// "Merge the yellow and green faces and tag the edges in preparation for Step 3."
    layout_2, "Boolean operations, layout modeling, step 2", Shape::rectangle(20.0, 20.0),
    r##"Init -->
    primitiveDisk(5)
    deleteUV(0)
    union { HouseFootprint. | FrontyardFootprint }
    modify(f) { isTagged("bool.B")= B
              | isTagged("bool.A")= A }
    ShowTags
A --> tag("eHouse", edges)
B --> deleteTags("bool.A")
      deleteTags("bool.cut")
      cleanupGeometry(edges, 0) // merge faces
      tag("eFrontyard", edges)
ShowTags -->
    ShowBoolAutotags
    comp(e) { isTagged("eFrontyard")
                  && isTagged("eHouse"): YellowEdge
            | isTagged("eHouse")       : BlueEdge
            | isTagged("eFrontyard")   : GreenEdge }

FrontyardFootprint --> s(10, 0, 10) center(x) t(0, 0, '-0.33)
ShowBoolAutotags -->
    comp(f) { isTagged("bool.A")
                  && isTagged("bool.B"): Yellow
            | isTagged("bool.A")       : Blue
            | isTagged("bool.B")       : Green }
YellowEdge --> s('1, 0.4, 0.4) center(yz) primitiveCube() color("#FADB19")
BlueEdge --> s('1, 0.4, 0.4) center(yz) primitiveCube() color("#0399F5")
GreenEdge --> s('1, 0.4, 0.4) center(yz) primitiveCube() color("#09DE1F")
Blue --> color("#0399F5")
Green --> color("#09DE1F")
Yellow --> color("#FADB19")
"##; marks &[Mark::From(147.0, 30.0)]
}

example! {
    /// "The house footprint is extruded and the frontyard footprint is offset."
    layout_3, "Boolean operations, layout modeling, step 3", Shape::rectangle(20.0, 20.0),
    r##"Init -->
    primitiveDisk(5)
    deleteUV(0)
    union { HouseFootprint. | FrontyardFootprint }
    modify(f) { isTagged("bool.B")= B
              | isTagged("bool.A")= A }
    comp(f) { isTagged("bool.A"): House
            | isTagged("bool.B"): Frontyard }
House -->
    extrude(3)
    comp(f) { isTagged("eFrontyard"): Yellow
            | all                   : Blue }
Frontyard -->
    offset(-2)
    comp(f) { isTagged("eHouse"): Yellow
            | all               : Green }

A --> tag("eHouse", edges)
B --> deleteTags("bool.A")
      deleteTags("bool.cut")
      cleanupGeometry(edges, 0)
      tag("eFrontyard", edges)
FrontyardFootprint --> s(10, 0, 10) center(x) t(0, 0, '-0.33)
Blue --> color("#0399F5")
Green --> color("#09DE1F")
Yellow --> color("#FADB19")
"##; marks &[Mark::From(147.0, 30.0)]
}

example! {
    /// "The cleanupGeometry operation is used to merge adjacent coplanar wall polygons."
    outsets, "modify operation, corrugated facade", Shape::rectangle(13.0, 12.0),
    r##"const OpeningL = 2
const Depth = 0.75
const InnerL = 1
Init -->
    inline(recompose) split(x) { 5:  tag("Front") F.
                               | ~1: tag("House") H. }
    modify(e) { isTagged("Front") && isTagged("House"):
        split(x) { ~4: CreateOutset }* }
    comp(f) { isTagged("House"): BuildHouse }
CreateOutset -->
    split(x) { ~1      : Wall.
             | 0.01    : tag("Side") Side.
             | OpeningL: tag("Outset") Outset
             | 0.01    : tag("Side") Side.
             | ~1      : Wall. }
Outset --> t(0,-Depth,0) s(InnerL,0,0) center(x)
BuildHouse -->
    extrude(3)
    cleanupGeometry(all,0)
    comp(f) { isTagged("Side")  : Blue
            | isTagged("Outset"): Green
            | all               = White. }
Blue -->   color("#0399F5")
Green -->  color("#09DE1F")
"##
}

example! {
    /// "The cleanupGeometry operation merges the vertices of the collapsed edge."
    smooth, "modify operation, Chaikin's corner cutting", jagged(),
    r##"Init -->
    ChaikinSmoothing(3)
ChaikinSmoothing(n) -->
    case n > 0:
        modify(fe) { all: SplitEdge }
        modify(fe) { isTagged("Collapse"): s(0,0,0) X. }
        cleanupGeometry(vertices,0)
        ChaikinSmoothing(n-1)
    else:
        Done.
SplitEdge -->
    split(x) { '0.25: CornerCut.
             | ~1: Fixed.
             | '0.25: tag("Collapse") Collapse. }
"##; marks &[Mark::FromAbove]
}
