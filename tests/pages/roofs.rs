//! *roofHip, roofGable, roofPyramid, roofShed and roofRidge operations*.
//!
//! The rules are taken from the pages. The rules of tags and edges, which the pages give as pictures, and the tiles that trim planes
//! cut are ours.

use cga::Shape;

use super::example::{Example, example};

/// In the order of the pages.
pub const ALL: &[Example] = &[
    hip::EXAMPLE,
    hip_uneven::EXAMPLE,
    hip_even::EXAMPLE,
    gable::EXAMPLE,
    gable_uneven::EXAMPLE,
    gable_even::EXAMPLE,
    pyramid::EXAMPLE,
    shed::EXAMPLE,
    ridge::EXAMPLE,
    ridge_across::EXAMPLE,
    ridge_diagonal::EXAMPLE,
    trim_hip::EXAMPLE,
    trim_gable::EXAMPLE,
    trim_pyramid::EXAMPLE,
    edges_pyramid::EXAMPLE,
    edges_shed::EXAMPLE,
    edges_hip::EXAMPLE,
    edges_gable::EXAMPLE,
    tags_hip::EXAMPLE,
    tags_gable::EXAMPLE,
    tags_pyramid::EXAMPLE,
    tags_shed::EXAMPLE,
    tags_ridge::EXAMPLE,
];

fn l_lot() -> Shape {
    let outline = [[0.0, 0.0], [12.0, 0.0], [12.0, -26.0], [-18.0, -26.0], [-18.0, -14.0], [0.0, -14.0]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

fn trapezoid() -> Shape {
    Shape::footprint(&[[0.0, 0.0], [24.0, 0.0], [24.0, -10.0], [0.0, -18.0]], &[]).expect("an outline")
}

fn pentagon() -> Shape {
    Shape::footprint(&[[0.0, 0.0], [20.0, 2.0], [24.0, -12.0], [12.0, -22.0], [-3.0, -14.0]], &[]).expect("an outline")
}

fn u_lot() -> Shape {
    let outline =
        [[0.0, 0.0], [6.0, 0.0], [6.0, -10.0], [16.0, -10.0], [16.0, 0.0], [22.0, 0.0], [22.0, -18.0], [0.0, -18.0]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

fn yard() -> Shape {
    let hole = vec![[7.0, -5.0], [13.0, -5.0], [13.0, -13.0], [7.0, -13.0]];
    Shape::footprint(&[[0.0, 0.0], [24.0, 0.0], [24.0, -18.0], [0.0, -18.0]], &[hole]).expect("an outline")
}

example!(
    hip,
    "roofHip operation, simple hip roof",
    l_lot(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofHip(30, 2) Roof
"#;
    marks &[Mark::Boxes("Roof"), Mark::Scopes("Roof")]
);

example!(
    hip_uneven,
    "roofHip operation, even hip roof: false",
    trapezoid(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofHip(45, 1, false) Roof
"#
);

example!(
    hip_even,
    "roofHip operation, even hip roof: true",
    trapezoid(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofHip(45, 1, true) Roof
"#
);

example!(
    gable,
    "roofGable operation, simple gable roof",
    l_lot(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofGable(30, 2, 1) Roof
"#;
    marks &[Mark::Boxes("Roof"), Mark::Scopes("Roof")]
);

example!(
    gable_uneven,
    "roofGable operation, even gable roof: false",
    trapezoid(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofGable(30, 1, 1, false) Roof
"#
);

example!(
    gable_even,
    "roofGable operation, even gable roof: true",
    trapezoid(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofGable(30, 1, 1, true) Roof
"#
);

example!(
    pyramid,
    "roofPyramid operation",
    pentagon(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofPyramid(30) Roof
"#;
    marks &[Mark::Boxes("Roof"), Mark::Scopes("Roof")]
);

example!(
    shed,
    "roofShed operation",
    l_lot(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofShed(10, 3) Roof
"#;
    marks &[Mark::Boxes("Roof"), Mark::Scopes("Roof")]
);

example!(
    ridge,
    "roofRidge operation, along",
    l_lot(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top : Top | side = Sides. }
    Top  --> alignScopeToGeometryBBox(xy)
             roofRidge(byAngle, 30)
"#
);

example!(
    ridge_across,
    "roofRidge operation, across",
    l_lot(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top : Top | side = Sides. }
    Top  --> alignScopeToGeometryBBox(yx)
             roofRidge(byAngle, 30)
"#
);

example!(
    ridge_diagonal,
    "roofRidge operation, diagonal",
    l_lot(),
    r#"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top : Top | side = Sides. }
    Top  --> alignScopeToGeometryBBox(xy)
             rotateScope(0, 0, 45)
             roofRidge(byAngle, 30)
"#
);

example!(
    edges_hip,
    "comp operation, edges of a hip roof",
    u_lot(),
    r##"
    Lot  --> roofHip(45) Roof
    Roof --> [ color("#dddddd") R. ]
             comp(e) { eave : Line("#00aa00") | hip : Line("#ddaa00") | valley : Line("#0000ff") | ridge : Line("#ff0000") }

    Line(c) --> color(c) primitiveCube s('1, 0.3, 0.3) Bar.
"##
);

example!(
    edges_gable,
    "comp operation, edges of a gable roof",
    u_lot(),
    r##"
    Lot  --> roofGable(45) Roof
    Roof --> [ color("#dddddd") R. ]
             comp(e) { eave : Line("#00aa00") | hip : Line("#ddaa00") | valley : Line("#0000ff") | ridge : Line("#ff0000") }

    Line(c) --> color(c) primitiveCube s('1, 0.3, 0.3) Bar.
"##
);

example!(
    tags_hip,
    "roofHip operation, component tags",
    Shape::rectangle(24.0, 12.0),
    r##"
    Lot --> roofHip(45)
            comp(f) { isTagged("roof.bottom") : Blue
                    | isTagged("roof.top") : Green }

    Blue --> color("#0080ff") Blue_.
    Green --> color("#00ff00") Green_.
"##; marks &[Mark::Lowered("Blue_")]
);

example!(
    tags_gable,
    "roofGable operation, component tags",
    Shape::rectangle(24.0, 12.0),
    r##"
    Lot --> roofGable(45)
            comp(f) { isTagged("roof.bottom") : Blue
                    | isTagged("roof.side") : Yellow
                    | isTagged("roof.top") : Green }

    Blue --> color("#0080ff") Blue_.
    Yellow --> color("#ffff00") Yellow_.
    Green --> color("#00ff00") Green_.
"##; marks &[Mark::Lowered("Blue_")]
);

example!(
    tags_pyramid,
    "roofPyramid operation, component tags",
    Shape::rectangle(24.0, 12.0),
    r##"
    Lot --> roofPyramid(45)
            comp(f) { isTagged("roof.bottom") : Blue
                    | isTagged("roof.top") : Green }

    Blue --> color("#0080ff") Blue_.
    Green --> color("#00ff00") Green_.
"##; marks &[Mark::Lowered("Blue_")]
);

example!(
    tags_shed,
    "roofShed operation, component tags",
    yard(),
    r##"
    Lot --> roofShed(30)
            comp(f) { isTagged("roof.bottom") : Blue
                    | isTagged("roof.side.outer") : Yellow
                    | isTagged("roof.side.inner") : Red
                    | isTagged("roof.top") : Green }

    Blue --> color("#0080ff") Blue_.
    Yellow --> color("#ffff00") Yellow_.
    Red --> color("#ff4000") Red_.
    Green --> color("#00ff00") Green_.
"##; marks &[Mark::Lowered("Blue_")]
);

example!(
    tags_ridge,
    "roofRidge operation, component tags",
    yard(),
    r##"
    Lot --> roofRidge(byAngle, 45)
            comp(f) { isTagged("roof.bottom") : Blue
                    | isTagged("roof.side.outer") : Yellow
                    | isTagged("roof.side.inner") : Red
                    | isTagged("roof.top") : Green }

    Blue --> color("#0080ff") Blue_.
    Yellow --> color("#ffff00") Yellow_.
    Red --> color("#ff4000") Red_.
    Green --> color("#00ff00") Green_.
"##; marks &[Mark::Lowered("Blue_")]
);

example!(
    trim_hip,
    "roofHip operation, trim planes",
    l_lot(),
    r##"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofHip(30, 2) Roof
    Roof --> set(trim.horizontal, true)
             comp(f) { isTagged("roof.top") : Tiles }

    Tiles --> s('1, '1, 0.6) primitiveCube color("#b04030") Tiles_.
"##
);

example!(
    trim_gable,
    "roofGable operation, trim planes",
    l_lot(),
    r##"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofGable(30, 2, 1) Roof
    Roof --> set(trim.horizontal, true)
             comp(f) { isTagged("roof.top") : Tiles | isTagged("roof.side") : X }

    Tiles --> s('1, '1, 0.6) primitiveCube color("#b04030") Tiles_.
"##
);

example!(
    trim_pyramid,
    "roofPyramid operation, trim planes",
    pentagon(),
    r##"
    Lot  --> extrude(10) Mass
    Mass --> comp(f) { top: Top | all: X }
    Top  --> roofPyramid(30) Roof
    Roof --> comp(f) { isTagged("roof.top") : Tiles }

    Tiles --> s('1, '1, 0.6) primitiveCube color("#b04030") Tiles_.
"##
);

example!(
    edges_pyramid,
    "comp operation, edges of a pyramid",
    Shape::rectangle(14.0, 14.0),
    r##"
    Lot  --> roofPyramid(45) Roof
    Roof --> [ color("#dddddd") R. ]
             comp(e) { eave : Line("#00aa00") | hip : Line("#ddaa00") | valley : Line("#0000ff") | ridge : Line("#ff0000") }

    Line(c) --> color(c) primitiveCube s('1, 0.3, 0.3) Bar.
"##
);

example!(
    edges_shed,
    "comp operation, edges of a shed",
    Shape::rectangle(14.0, 10.0),
    r##"
    Lot  --> roofShed(20) Roof
    Roof --> [ color("#dddddd") R. ]
             comp(e) { eave : Line("#00aa00") | hip : Line("#ddaa00") | valley : Line("#0000ff") | ridge : Line("#ff0000") }

    Line(c) --> color(c) primitiveCube s('1, 0.3, 0.3) Bar.
"##
);
