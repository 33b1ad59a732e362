//! Pages about the scope: *t operation*, *r operation*, *s operation*, *center operation*, *push / pop operations*, *translate operation*,
//! *rotate operation*, *rotateScope operation*, *mirrorScope operation*, *alignScopeToAxes operation*, *alignScopeToGeometry operation*,
//! *setPivot operation*. Cubes and cylinders of the language are in place of the pages' files.

use cga::Shape;

use super::example::{Example, example};

/// In the order of the chapter.
pub const ALL: &[Example] = &[
    cube::EXAMPLE,
    moved::EXAMPLE,
    turned::EXAMPLE,
    moved_again::EXAMPLE,
    slices_origin::EXAMPLE,
    slices_center::EXAMPLE,
    extruded::EXAMPLE,
    resized::EXAMPLE,
    resized_relatively::EXAMPLE,
    centers::EXAMPLE,
    stacked::EXAMPLE,
    independent::EXAMPLE,
    cylinders::EXAMPLE,
    along_world::EXAMPLE,
    along_object::EXAMPLE,
    oriented::EXAMPLE,
    turned_scope::EXAMPLE,
    mirrored_scope::EXAMPLE,
    leaning::EXAMPLE,
    aligned::EXAMPLE,
    upright::EXAMPLE,
    slopes::EXAMPLE,
    slopes_aligned::EXAMPLE,
    cylinder::EXAMPLE,
    cylinder_z_up::EXAMPLE,
    cylinder_y_up::EXAMPLE,
    pivots_xyz::EXAMPLE,
    pivots_yzx::EXAMPLE,
    pivots_zxy::EXAMPLE,
];

fn unit() -> Shape {
    Shape::rectangle(1.0, 1.0)
}

/// A lot with five sides.
fn lot() -> Shape {
    let outline = [[0.0, 0.0], [2.0, 11.0], [11.0, 13.0], [15.0, 6.0], [9.0, 1.0]];
    Shape::footprint(&outline, &[]).expect("a simple outline")
}

/// A square lot whose axes differ from the axes of the world.
fn turned_lot() -> Shape {
    Shape::footprint(&[[0.0, 0.0], [10.0, -4.0], [14.0, 6.0], [4.0, 10.0]], &[]).expect("a simple outline").seed(4)
}

fn plot() -> Shape {
    Shape::rectangle(8.0, 6.0)
}

example! {
    /// "This is the initial shape we start with."
    cube, "t operation: the initial shape", unit(),
    r##"A-->
   primitiveCube()
"##; marks &[Mark::From(-140.0, 30.0), Mark::InitialPivot, Mark::Scopes("A")]
}

example! {
    /// "First a translation of two units along the x-axis."
    moved, "t operation: a translation", unit(),
    r##"A-->
   primitiveCube()
   t(2,0,0)
"##; marks &[Mark::From(-140.0, 30.0), Mark::InitialPivot, Mark::Scopes("A")]
}

example! {
    /// "Then a rotation of 30 degrees around the y-axis."
    turned, "t operation: then a rotation", unit(),
    r##"A-->
   primitiveCube()
   t(2,0,0)
   r(0,30,0)
"##; marks &[Mark::From(-140.0, 30.0), Mark::InitialPivot, Mark::Scopes("A")]
}

example! {
    /// "translations are along the scope's x-axis"
    moved_again, "t operation: and another translation", unit(),
    r##"A-->
   primitiveCube()
   t(2,0,0)
   r(0,30,0)
   t('2,0,0)
"##; marks &[Mark::From(-140.0, 30.0), Mark::InitialPivot, Mark::Scopes("A")]
}

example! {
    /// "Each slice's scope is shown, note how the y-axes denote an axis of symmetry."
    slices_origin, "r operation, Rotation Centers: the origin of the scope", lot(),
    r##"height = 18
dy = 2
Lot-->
   extrude(height)
   split(y) {
      dy : r(0, 360*split.index/split.total, 0)
           X
   }*
"##; marks &[Mark::Scopes("X")]
}

example! {
    /// "this time the rotations are around the scope center"
    slices_center, "r operation, Rotation Centers: the middle of the scope", lot(),
    r##"height = 18
dy = 2
Lot-->
   extrude(height)
   split(y) {
      dy : r(scopeCenter,
             0, 360*split.index/split.total, 0)
           X
   }*
"##; marks &[Mark::Scopes("X")]
}

example! {
    /// "The initial shape with its scope highlighted."
    extruded, "s operation: the initial shape", lot(),
    r##"Lot-->
   extrude(10)
"##; marks &[Mark::From(-140.0, 30.0), Mark::Initial, Mark::Boxes("Lot"), Mark::Scopes("Lot")]
}

example! {
    /// "all scope sizes are set to the absolute value 5"
    resized, "s operation: absolute sizes", lot(),
    r##"Lot-->
   extrude(10)
   s(5,5,5)
"##; marks &[Mark::From(-140.0, 30.0), Mark::Initial, Mark::Boxes("Lot"), Mark::Scopes("Lot")]
}

example! {
    /// "This example demonstrates the usage of the relative operator '."
    resized_relatively, "s operation: relative sizes", lot(),
    r##"Lot-->
   extrude(10)
   s('0.5,'1,'1.5)
"##; marks &[Mark::From(-140.0, 30.0), Mark::Initial, Mark::Boxes("Lot"), Mark::Scopes("Lot")]
}

example! {
    /// "The colored small cubes show the positions of the axis selectors"
    centers, "center operation: the axes", unit(),
    r##"Lot-->
   primitiveCube()
   s(4,4,4)
   t(-2,-2,-2)
   SelCube
SelCube-->
   [ color("#ff0000") s(1,1,1) center(x) X ]
   [ color("#00ff00") s(1,1,1) center(y) X ]
   [ color("#0000ff") s(1,1,1) center(z) X ]
   [ color("#ffff00") s(1,1,1) center(xy) X ]
   [ color("#ff00ff") s(1,1,1) center(xz) X ]
   [ color("#00ffff") s(1,1,1) center(yz) X ]
   [ color("#ffffff") s(1,1,1) center(xyz) X ]
"##; marks &[Mark::From(-130.0, 18.0), Mark::Inner("SelCube")]
}

example! {
    /// "The rotations build on each other."
    stacked, "push / pop operations: rotations", plot(),
    r##"Lot -->
    extrude(15)
    r(scopeCenter, 0, 22.5, 0) X.
    r(scopeCenter, 0, 22.5, 0) X.
    r(scopeCenter, 0, 22.5, 0) X.
"##; marks &[Mark::From(-140.0, 30.0), Mark::Initial, Mark::Scopes("X")]
}

example! {
    /// "The rotations are independent of each other."
    independent, "push / pop operations: independent rotations", plot(),
    r##"Lot -->
    extrude(15)
    [ r(scopeCenter, 0, 22.5, 0) X. ]
    [ r(scopeCenter, 0, 22.5, 0) X. ]
    [ r(scopeCenter, 0, 22.5, 0) X. ]
"##; marks &[Mark::From(-140.0, 30.0), Mark::Initial, Mark::Scopes("X")]
}

example! {
    /// "Each scope is translated based on the scope of the initial shape."
    cylinders, "push / pop operations: translations", Shape::rectangle(4.0, 4.0),
    r##"House-->
    Cylinder
    [ t(  0, 0, ' 1) Cylinder ]
    [ t(  0, 0, '-1) Cylinder ]
    [ t(' 1, 0,   0) Cylinder ]
    [ t('-1, 0,   0) Cylinder ]
Cylinder -->
    primitiveCylinder(16, 1, 2)
"##; marks &[Mark::From(-140.0, 30.0), Mark::Initial, Mark::Scopes("Cylinder")]
}

example! {
    /// "copies of the white cubes, translated by two units along the x-axis of the world coordinate system"
    along_world, "translate operation: along the x axis of the world", turned_lot(),
    r##"Init --> split(x) { '0.2 : split(z) { '0.2 : PP }* }*
PP --> 43% : primitiveCube()
             X
             translate(rel, world, 2, 0, 0)
             color("#ff0000")
             X
       else : NIL
"##; marks &[Mark::Initial, Mark::InitialScope]
}

example! {
    /// "translated by two units along the x-axis of the object coordinate system"
    along_object, "translate operation: along the x axis of the object", turned_lot(),
    r##"Init --> split(x) { '0.2 : split(z) { '0.2 : PP }* }*
PP --> 43% : primitiveCube()
             X
             translate(rel, object, 2, 0, 0)
             color("#ff0000")
             X
       else : NIL
"##; marks &[Mark::Initial, Mark::InitialScope]
}

example! {
    /// "the scope orientation can be set to an orientation relative to the world origin"
    oriented, "rotate operation: an orientation in the world", turned_lot(),
    r##"Init -->
   extrude(10)
   t('0.2, 0, '0.3)
   s('0.5, '1, '0.5)
   rotate(abs, world, 0, 90, 0)
"##; marks &[Mark::From(-140.0, 30.0), Mark::Initial, Mark::InitialPivot, Mark::Scopes("Init")]
}

example! {
    /// "The geometry is not rotated, and the size and translation of the scope is adjusted".
    turned_scope, "rotateScope operation", lot(),
    r##"Lot --> extrude(6) rotateScope(0, 40, 0)
"##; marks &[Mark::From(-140.0, 30.0), Mark::Boxes("Lot"), Mark::Scopes("Lot")]
}

example! {
    /// "The current shape's geometry stays the same."
    mirrored_scope, "mirrorScope operation", lot(),
    r##"Lot --> extrude(6) mirrorScope(true, false, false)
"##; marks &[Mark::From(-140.0, 30.0), Mark::Boxes("Lot"), Mark::Scopes("Lot")]
}

example! {
    /// "The pivot (fat) is in the origin; the scope (yellow) contains a translation and a rotation."
    leaning, "alignScopeToAxes operation: the initial scene", unit(),
    r##"A-->
   t(5,0,4) s(8,24,8) r(10,20,30)
   primitiveCube()
"##; marks &[Mark::From(-140.0, 30.0), Mark::InitialPivot, Mark::Boxes("A"), Mark::Scopes("A")]
}

example! {
    /// "all pivot axes are parallel to the world coordinate axes"
    aligned, "alignScopeToAxes operation: all axes", unit(),
    r##"A-->
   t(5,0,4) s(8,24,8) r(10,20,30)
   primitiveCube()
   alignScopeToAxes()
"##; marks &[Mark::From(-140.0, 30.0), Mark::Boxes("A"), Mark::Scopes("A"), Mark::ScopePivots("A")]
}

example! {
    /// "only aligns the pivot to the y-axis"
    upright, "alignScopeToAxes operation: the y axis alone", unit(),
    r##"A-->
   t(5,0,4) s(8,24,8) r(10,20,30)
   primitiveCube()
   alignScopeToAxes(y)
"##; marks &[Mark::From(-140.0, 30.0), Mark::Boxes("A"), Mark::Scopes("A"), Mark::ScopePivots("A")]
}

example! {
    /// "the scope (and pivot, fat) happen to be positioned such that the y-axis points towards the ground"
    slopes, "alignScopeToGeometry operation: a slope of a roof", Shape::rectangle(20.0, 20.0),
    r##"A--> s(20, 10, 20) primitiveCone(4) comp(f) { side : Faces }
Faces--> alignScopeToGeometry(zUp, 0, 1)
"##; marks &[Mark::Scope("Faces", 0)]
}

example! {
    /// "guarantees that the y-axis of the scope points upwards"
    slopes_aligned, "alignScopeToGeometry operation: the lowest edge", Shape::rectangle(20.0, 20.0),
    r##"A--> s(20, 10, 20) primitiveCone(4) comp(f) { side : Faces }
Faces--> alignScopeToGeometry(zUp, any, world.lowest)
"##; marks &[Mark::Scope("Faces", 0)]
}

example! {
    /// "A mesh is inserted and two faces highlighted by applying a component split."
    cylinder, "alignScopeToGeometry operation: a cylinder", Shape::rectangle(2.0, 2.0),
    r##"A -->
    s(2,3,2)
    primitiveCylinder(16)
    B
    comp(f){
        0: color("#ff0000") t(0,0,0.01) X |
        13: color("#0000ff") t(0,0,0.01) X }
"##; marks &[Mark::Boxes("B"), Mark::Scopes("B")]
}

example! {
    /// "the pivot's (and the scope's) x-axis points along edge 1 of face 0 (red)"
    cylinder_z_up, "alignScopeToGeometry operation: z along the normal", Shape::rectangle(2.0, 2.0),
    r##"A -->
    s(2,3,2)
    primitiveCylinder(16)
    B
    comp(f){
        0: color("#ff0000") t(0,0,0.01) X |
        13: color("#0000ff") t(0,0,0.01) X }
B --> alignScopeToGeometry(zUp, 0, 1)
"##; marks &[Mark::Boxes("B"), Mark::Scopes("B"), Mark::ScopePivots("B")]
}

example! {
    /// "the face-normal becomes the new y-axis"
    cylinder_y_up, "alignScopeToGeometry operation: y along the normal", Shape::rectangle(2.0, 2.0),
    r##"A -->
    s(2,3,2)
    primitiveCylinder(16)
    B
    comp(f){
        0: color("#ff0000") t(0,0,0.01) X |
        13: color("#0000ff") t(0,0,0.01) X }
B --> alignScopeToGeometry(yUp, 13, 2)
"##; marks &[Mark::Boxes("B"), Mark::Scopes("B"), Mark::ScopePivots("B")]
}

example! {
    /// "in corner 0, the axes are the same as the original scope axes"
    pivots_xyz, "setPivot operation: the pivots at all corners, xyz", unit(),
    r##"A --> s(4, 3, 4) primitiveCube() set(material.opacity, 0.04) Corners(0)
Corners(n) -->
    case n < 8 : [ setPivot(xyz, n) Corner. ] Corners(n + 1)
    else       : NIL
"##; marks &[Mark::Boxes("Corner"), Mark::ScopePivots("Corner")]
}

example! {
    /// "in corner 0, the scope axes xyz are replaced by the axes yzx"
    pivots_yzx, "setPivot operation: the pivots at all corners, yzx", unit(),
    r##"A --> s(4, 3, 4) primitiveCube() set(material.opacity, 0.04) Corners(0)
Corners(n) -->
    case n < 8 : [ setPivot(yzx, n) Corner. ] Corners(n + 1)
    else       : NIL
"##; marks &[Mark::Boxes("Corner"), Mark::ScopePivots("Corner")]
}

example! {
    /// "in corner 0, the scope axes xyz are replaced by the axes zxy"
    pivots_zxy, "setPivot operation: the pivots at all corners, zxy", unit(),
    r##"A --> s(4, 3, 4) primitiveCube() set(material.opacity, 0.04) Corners(0)
Corners(n) -->
    case n < 8 : [ setPivot(zxy, n) Corner. ] Corners(n + 1)
    else       : NIL
"##; marks &[Mark::Boxes("Corner"), Mark::ScopePivots("Corner")]
}
