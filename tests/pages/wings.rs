//! *shapeL, shapeU, shapeO operations* and *taper operation*, on a lot as in the pictures.

use cga::Shape;

use super::example::{Example, example};

/// In the order of the pages.
pub const ALL: &[Example] = &[l::EXAMPLE, u::EXAMPLE, o::EXAMPLE, tapered::EXAMPLE];

/// A lot of a block whose edges are not at right angles.
fn lot() -> Shape {
    Shape::footprint(&[[0.0, 0.0], [46.0, 4.0], [50.0, -34.0], [-2.0, -38.0]], &[]).expect("an outline").seed(4)
}

example! {
    /// "A block filled with L-shapes."
    l, "shapeL operation", lot(),
    r#"attr myFrontDepth = 5
attr myLeftWidth = 11
LotInner -->
    Lot
Lot -->
    offset(-3, inside)
    shapeL(myFrontDepth,myLeftWidth) { shape : Footprint | remainder: NIL }
Footprint -->
    extrude(rand(10,20)) color(1,0,0)
"#
}

example! {
    /// "A block filled with U-shapes."
    u, "shapeU operation", lot(),
    r#"attr myFrontDepth = 5
attr myRightWidth = 3
attr myLeftWidth = 11
LotInner -->
    Lot
Lot -->
    offset(-3, inside)
    shapeU(myFrontDepth,myRightWidth,myLeftWidth) { shape : Footprint | remainder: NIL }
Footprint -->
    extrude(rand(10,20)) color(1,0,0)
"#
}

example! {
    /// "A block filled with O-shapes."
    o, "shapeO operation", lot(),
    r#"attr myFrontDepth = 5
attr myRightWidth = 3
attr myBackDepth = 2
attr myLeftWidth = 11
LotInner -->
    Lot
Lot -->
    offset(-3, inside)
    shapeO(myFrontDepth,myRightWidth,myBackDepth,myLeftWidth) { shape : Footprint | remainder: NIL }
Footprint -->
    extrude(rand(10,20)) color(1,0,0)
"#
}

example! {
    /// "The tapered shape."
    tapered, "taper operation", Shape::footprint(&[[0.0, 0.0], [16.0, 2.0], [14.0, -12.0], [2.0, -13.0]], &[]).expect("an outline"),
    r#"Lot -->	taper(10)
"#
}
