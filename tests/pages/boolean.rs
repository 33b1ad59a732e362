//! *Boolean operations*, and the united examples of *Rule inlining*.

use cga::Shape;

use super::example::{Example, example};

/// In the order of the pages.
pub const ALL: &[Example] = &[
    tagged_union::EXAMPLE,
    tagged_subtraction::EXAMPLE,
    tagged_intersection::EXAMPLE,
    classes::EXAMPLE,
    cube_without_cylinder::EXAMPLE,
    cylinder_without_cube::EXAMPLE,
    quad_first::EXAMPLE,
    circle_first::EXAMPLE,
    quad_gives_attributes::EXAMPLE,
    circle_gives_attributes::EXAMPLE,
    single::EXAMPLE,
    multiple::EXAMPLE,
    apart::EXAMPLE,
    half_spheres::EXAMPLE,
    half_spheres_unified::EXAMPLE,
    half_spheres_drilled::EXAMPLE,
    half_spheres_tagged::EXAMPLE,
    auto_tags::EXAMPLE,
    layout::EXAMPLE,
    open_cube::EXAMPLE,
    open_cube_crossed::EXAMPLE,
    plane::EXAMPLE,
    plane_crossed::EXAMPLE,
    stairs::EXAMPLE,
    united_solids::EXAMPLE,
    united_areas::EXAMPLE,
];

fn square() -> Shape {
    Shape::rectangle(10.0, 10.0)
}

fn lot() -> Shape {
    Shape::rectangle(100.0, 40.0)
}

/// The outline of the page's picture: two wings of different depth.
fn house() -> Shape {
    let outline = [[0.0, 0.0], [40.0, 0.0], [40.0, 40.0], [27.0, 40.0], [27.0, 45.0], [0.0, 45.0]];
    Shape::footprint(&outline, &[]).expect("a polygon")
}

example! {
    tagged_union, "Boolean operations, component tags", Shape::cuboid(1.0, 1.0, 1.0),
    r##"Left --> union { Cube | Sphere }
         comp(f) { isTagged("bool.A") : Blue
                 | isTagged("bool.B") : Green }
         comp(e) { isTagged("bool.cut") : Orange }
Cube --> primitiveCube
Sphere --> t(0.3,0.3,0.3) primitiveSphere

Blue --> color("#0399F5")
Green --> color("#09DE1F")
Orange --> color("#FA9100")
"##
}

example! {
    tagged_subtraction, "Boolean operations, component tags, subtracted", Shape::cuboid(1.0, 1.0, 1.0),
    r##"Middle --> subtract { Cube | Sphere }
         comp(f) { isTagged("bool.A") : Blue
                 | isTagged("bool.B") : Green }
         comp(e) { isTagged("bool.cut") : Orange }
Cube --> primitiveCube
Sphere --> t(0.3,0.3,0.3) primitiveSphere

Blue --> color("#0399F5")
Green --> color("#09DE1F")
Orange --> color("#FA9100")
"##
}

example! {
    tagged_intersection, "Boolean operations, component tags, intersected", Shape::cuboid(1.0, 1.0, 1.0),
    r##"Right --> intersect { Cube | Sphere }
         comp(f) { isTagged("bool.A") : Blue
                 | isTagged("bool.B") : Green }
         comp(e) { isTagged("bool.cut") : Orange }
Cube --> primitiveCube
Sphere --> t(0.3,0.3,0.3) primitiveSphere

Blue --> color("#0399F5")
Green --> color("#09DE1F")
Orange --> color("#FA9100")
"##
}

example! {
    classes, "Boolean operations, plane subtract volume, by tags", square(),
    r##"Init -->
  subtract { Blue | GreenSphere }
  comp(f) { isTagged("bool.A") : Blue }

GreenSphere --> s(8, 8, 8) center(xyz) primitiveSphere Green
Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    cube_without_cylinder, "Boolean operations, order of operands, subtract", square(),
    r##"Left --> subtract { Cube | Cylinder }
Cube --> primitiveCube
         Blue
Cylinder --> t(3,3,3)
         primitiveCylinder
         Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    cylinder_without_cube, "Boolean operations, order of operands, subtract, swapped", square(),
    r##"Right --> subtract { Cylinder | Cube }
Cube --> primitiveCube
         Blue
Cylinder --> t(3,3,3)
         primitiveCylinder
         Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    quad_first, "Boolean operations, order of operands, material", square(),
    r##"Left --> union { Quad | Circle }
Quad --> primitiveQuad
         Blue
Circle --> t(3,0,3)
         primitiveDisk
         Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    circle_first, "Boolean operations, order of operands, material, swapped", square(),
    r##"Right --> union { Circle | Quad }
Quad --> primitiveQuad
         Blue
Circle --> t(3,0,3)
         primitiveDisk
         Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    quad_gives_attributes, "Boolean operations, order of operands, attributes", square(),
    r##"attr Height = 0
Left --> intersect { Quad | Circle }
         extrude(Height) // Height == 10
Quad --> set(Height, 10)
         primitiveQuad
Circle --> set(Height, 1)
         t(3,0,3)
         primitiveDisk

"##
}

example! {
    circle_gives_attributes, "Boolean operations, order of operands, attributes, swapped", square(),
    r##"attr Height = 0
Right --> intersect { Circle | Quad }
         extrude(Height) // Height == 1
Quad --> set(Height, 10)
         primitiveQuad
Circle --> set(Height, 1)
         t(3,0,3)
         primitiveDisk

"##
}

example! {
    single, "Boolean operations, inlining of operands", square(),
    r##"Left --> primitiveCube
         union { Blue
               | t(1,1,1) Green }

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    multiple, "Boolean operations, inlining of operands, multiple shapes", square(),
    r##"Right --> primitiveCube
         union { Blue
               | t(1,1,1) Green
                 t(1,1,1) Green
                 t(1,1,1) Green }

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    apart, "Boolean operations, shapes that do not touch", square(),
    r##"Init --> primitiveCube
         union { Blue
               | t(1,1,1+10) Green
                 t(1,1,1) Green
                 t(1,1,1) Green }

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    half_spheres, "Boolean operations, mass modeling, step 1", lot(),
    r##"Init -->
    intersect { Envelope | Sphere }
Envelope -->
    extrude(40)
Sphere -->
    s('1, 40, '2)
    center(z)
    t(0, '-0.2, 0)
    primitiveSphere

"##
}

example! {
    half_spheres_unified, "Boolean operations, mass modeling, step 2", lot(),
    r##"Init -->
    intersect { Envelope | Sphere }
    inline(unify) split(y) { ~1: LowerHalf
                           | 20: UpperHalf }
Envelope -->
    extrude(40)
Sphere -->
    s('1, 40, '2)
    center(z)
    t(0, '-0.2, 0)
    primitiveSphere
LowerHalf --> X.
UpperHalf --> t(10, 0, 0)
              r(scopeCenter, 0, 7.2, 0)

"##
}

example! {
    half_spheres_drilled, "Boolean operations, mass modeling, step 3", lot(),
    r##"Init -->
    intersect { Envelope | Sphere }
    inline(unify) split(y) { ~1: LowerHalf
                           | 20: UpperHalf }
    subtract { CurrentMass. | Hole }
Envelope -->
    extrude(40)
Sphere -->
    s('1, 40, '2)
    center(z)
    t(0, '-0.2, 0)
    primitiveSphere
LowerHalf --> X.
UpperHalf --> t(10, 0, 0)
              r(scopeCenter, 0, 7.2, 0)
Hole -->
    s(16, 16, '1.2)
    center(z)
    t(30, 5, 0)
    rotateScope(-90, 0, 0)
    primitiveCylinder

"##
}

example! {
    /// The page writes `tag("envelope")`, which `isTagged("Envelope")` does not find.
    half_spheres_tagged, "Boolean operations, mass modeling, adding tags", lot(),
    r##"Init -->
    intersect { Envelope | Sphere }
    inline(unify) split(y) { ~1: LowerHalf
                           | 20: UpperHalf }
    subtract { CurrentMass. | Hole }
    comp(f) { isTagged("Envelope") && side   : Blue
            | isTagged("Lower")    && top    : Red
            | isTagged("Upper")    && bottom : Orange
            | isTagged("Lower")              : Green
            | isTagged("Upper")              : Yellow
            | isTagged("Hole")               : Purple }
Envelope -->
    extrude(40)
    tag("Envelope")
Sphere -->
    s('1, 40, '2)
    center(z)
    t(0, '-0.2, 0)
    primitiveSphere
LowerHalf --> tag("Lower")
UpperHalf --> t(10, 0, 0)
              r(scopeCenter, 0, 7.2, 0)
              tag("Upper")
Hole -->
    s(16, 16, '1.2)
    center(z)
    t(30, 5, 0)
    rotateScope(-90, 0, 0)
    primitiveCylinder
    tag("Hole")

Blue --> color("#0399F5")
Green --> color("#09DE1F")
Yellow --> color("#FADB19")
Purple --> color("#8D09DE")
Red --> color("#FF360A")
Orange --> color("#FA9100")
"##
}

example! {
    auto_tags, "Boolean operations, auto-tags", house(),
    r##"Init -->
    extrude(40)
    subtract { Mass.
             | t(20, -15, -15)
               rotate(rel, scope, 15, 12, 25) }
    SurfaceSplitter
SurfaceSplitter -->
    comp(f) { isTagged("extrude.top")
                  && isTagged("bool.A"): Purple
            | isTagged("extrude.top")
                  && isTagged("bool.B"): Green
            | isTagged("extrude.side")
                  && isTagged("bool.A"): Blue
            | isTagged("extrude.side")
                  && isTagged("bool.B"): Yellow }

Blue --> color("#0399F5")
Green --> color("#09DE1F")
Yellow --> color("#FADB19")
Purple --> color("#8D09DE")
"##; marks &[Mark::From(15.0, -20.0)]
}

example! {
    layout, "Boolean operations, layout modeling, step 1", Shape::rectangle(20.0, 20.0),
    r##"Init -->
    primitiveDisk(5)
    union { HouseFootprint. | FrontyardFootprint }
    ShowBoolAutotags
FrontyardFootprint -->
    s(10, 0, 10)
    center(x)
    t(0, 0, '-0.33)
ShowBoolAutotags -->
    comp(f) { isTagged("bool.A")
                  && isTagged("bool.B"): Yellow
            | isTagged("bool.A")       : Blue
            | isTagged("bool.B")       : Green }

Blue --> color("#0399F5")
Green --> color("#09DE1F")
Yellow --> color("#FADB19")
"##
}

example! {
    open_cube, "Boolean operations, open operands, cube", square(),
    r##"Left --> primitiveCube
         union { Blue
               | t(2,2,2)
                 comp(f) { front: NIL | all= Green } }

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    open_cube_crossed, "Boolean operations, open operands, cube, border crossed", square(),
    r##"Right --> primitiveCube
         union { Blue
               | t(2,2,2)
                 comp(f) { left: NIL | all= Green } }

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    plane, "Boolean operations, open operands, plane", square(),
    r##"Left --> primitiveCube
         union { Blue
               | primitiveQuad
                 s(12,0,12)
                 center(xyz)
                 Green }

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    plane_crossed, "Boolean operations, open operands, plane, border crossed", square(),
    r##"Right --> primitiveCube
         union { Blue
               | primitiveQuad
                 s(12,0,10)
                 t(-1,5,2)
                 Green }

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    stairs, "Rule inlining, spiral steps", Shape::rectangle(1.0, 1.0),
    r##"Init -->
    inline(unify) StepsRec(18)
    color(0, 1, 0, 0.8)

StepsRec(nSteps) -->
    case nSteps > 0:
        Step
        r(0, 20, 0)
        t(0, 0.18, 0)
        StepsRec(nSteps-1)
    else:
        NIL

Step --> s(0.4, 0.3, 1) primitiveCube

"##
}

example! {
    united_solids, "Rule inlining, inline and tags in 3D", Shape::rectangle(10.0, 3.0),
    r##"Init -->
    inline(unify) split(x) { 3: A | 4: B | 3: C }
    comp(f) { isTagged("A"): Blue
            | isTagged("B"): Yellow
            | isTagged("C"): Red }
A --> primitiveCylinder tag("A")
B --> t(-1, 0.5, 0.75)
      s(6, 2, 1.5)
      primitiveCube
      tag("B")
C --> primitiveSphere tag("C")

Blue --> color("#0399F5")
Yellow --> color("#FADB19")
Red --> color("#FF360A")
"##
}

example! {
    united_areas, "Rule inlining, inline and tags in 2D", Shape::rectangle(10.0, 3.0),
    r##"Init -->
    inline(unify) split(x) { 3: A | 4: B | 3: C }
    comp(f) { isTagged("A") && isTagged("B"): Green
            | isTagged("B") && isTagged("C"): Orange
            | isTagged("A")                 : Blue
            | isTagged("B")                 : Yellow
            | isTagged("C")                 : Red }
A --> primitiveDisk tag("A")
B --> t(-1, 0, 0.75)
      s(6, 0, 1.5)
      tag("B")
C --> tag("C")

Blue --> color("#0399F5")
Yellow --> color("#FADB19")
Red --> color("#FF360A")
Green --> color("#09DE1F")
Orange --> color("#FA9100")
"##; marks &[Mark::FromAbove]
}
