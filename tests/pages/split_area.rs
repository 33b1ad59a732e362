//! *splitArea operation*, Examples: outlines on the ground, seen from above with x to the right.
//!
//! The outlines are taken from the page's pictures, in metres. The rules for the colours stand once on the page, which prints
//! areas with them.

use cga::{MeshBuilder, Shape};

use super::example::{Example, example};

/// All of them, in the page's order.
pub const ALL: &[Example] = &[
    relative::EXAMPLE,
    repeating::EXAMPLE,
    repeating_with_a_rest::EXAMPLE,
    floating_and_absolute::EXAMPLE,
    nested::EXAMPLE,
    scope_of_shapes::EXAMPLE,
    adjusted::EXAMPLE,
    not_adjusted::EXAMPLE,
    scope_of_block::EXAMPLE,
    block_by_area::EXAMPLE,
    block_by_length::EXAMPLE,
];

/// An L of 1000 square metres.
pub fn corner() -> Shape {
    let outline = [[0.0, 30.0], [60.0, 30.0], [60.0, 20.0], [20.0, 20.0], [20.0, 0.0], [0.0, 0.0]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

/// A triangle of 900 square metres.
pub fn triangle() -> Shape {
    Shape::footprint(&[[0.0, 30.0], [60.0, 30.0], [30.0, 0.0]], &[]).expect("an outline")
}

/// A rectangle with a rectangular hole: 1400 square metres.
pub fn frame() -> Shape {
    let hole = vec![[10.0, 10.0], [40.0, 10.0], [40.0, 30.0], [10.0, 30.0]];
    Shape::footprint(&[[0.0, 40.0], [50.0, 40.0], [50.0, 0.0], [0.0, 0.0]], &[hole]).expect("an outline")
}

/// Five faces, three of them concave; two share an edge, two a corner, one stands alone. The scope is 150 × 68.
pub fn shapes() -> Shape {
    let mut builder = MeshBuilder::new();
    let points = [
        // The claw, and what leans on its right edge.
        [8.0, 0.0],
        [35.0, 19.0],
        [64.5, 16.5],
        [68.0, 43.0],
        [48.5, 37.0],
        [39.5, 61.0],
        [0.0, 42.5],
        [29.0, 28.5],
        [3.0, 26.0],
        [71.5, 4.0],
        [86.5, 26.0],
        [84.5, 65.5],
        [58.0, 68.0],
        // The bow, and the rectangle at its end.
        [96.0, 17.0],
        [114.0, 7.5],
        [144.0, 17.0],
        [137.5, 31.0],
        [117.0, 19.0],
        [96.0, 47.5],
        [150.0, 31.0],
        [150.0, 54.0],
        [137.5, 54.0],
        // The rectangle alone.
        [100.0, 52.5],
        [128.0, 52.5],
        [128.0, 67.0],
        [100.0, 67.0],
    ];
    for [x, z] in points {
        builder.point([x, 0.0, z]);
    }
    // Listed clockwise as seen from above; faces look up.
    let faces: [&[u32]; 5] = [
        &[0, 1, 2, 3, 4, 5, 6, 7, 8],
        &[2, 9, 10, 11, 12, 3],
        &[13, 14, 15, 16, 17, 18],
        &[16, 19, 20, 21],
        &[22, 23, 24, 25],
    ];
    for face in faces {
        let upwards: Vec<u32> = face.iter().rev().copied().collect();
        builder.polygon(&upwards);
    }
    Shape::mesh_axis_aligned(builder.build().expect("faces"))
}

/// A block of five corners, its front turned by 5.3 degrees. Its corners follow from the eight areas that the page prints.
pub fn block() -> Shape {
    let outline = [[0.0, 0.0], [129.59, 12.1], [137.02, -46.06], [116.04, -66.25], [16.6, -23.11]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

example! {
    /// Shares of the area that make up all of it.
    relative, "splitArea operation, Relative Split", corner(),
    r##"Lot -->
   print("total area = " + geometry.area)
   splitArea(x) { '0.7 : Green
                | '0.3 : Yellow }

Green  --> color(0, 1, 0) print("area(G) = " + geometry.area)
Yellow --> color(1, 1, 0) print("area(Y) = " + geometry.area)
"##; marks &[Mark::AlongX]
}

example! {
    /// Five repetitions of a fifth.
    repeating, "splitArea operation, Repeating Split", triangle(),
    r##"Lot -->
   print("total area = " + geometry.area)
   splitArea(x) { '0.2 : ColorMe }*
ColorMe -->
   case split.index == 0 :
      Red
   case split.index == 1 :
      Yellow
   case split.index == 2 :
      Green
   case split.index == 3 :
      Cyan
   else :
      Blue

Red    --> color(1, 0, 0) print("area(R) = " + geometry.area)
Yellow --> color(1, 1, 0) print("area(Y) = " + geometry.area)
Green  --> color(0, 1, 0) print("area(G) = " + geometry.area)
Cyan   --> color(0, 1, 1) print("area(C) = " + geometry.area)
Blue   --> color(0, 0, 1) print("area(B) = " + geometry.area)
"##; marks &[Mark::AlongX]
}

example! {
    /// The page's remark on the example before: with another share the last part is what is left.
    repeating_with_a_rest, "splitArea operation, Repeating Split with '0.3", triangle(),
    r##"Lot -->
   print("total area = " + geometry.area)
   splitArea(x) { '0.3 : ColorMe }*
ColorMe -->
   case split.index == 0 :
      Red
   case split.index == 1 :
      Yellow
   case split.index == 2 :
      Green
   case split.index == 3 :
      Cyan
   else :
      Blue

Red    --> color(1, 0, 0) print("area(R) = " + geometry.area)
Yellow --> color(1, 1, 0) print("area(Y) = " + geometry.area)
Green  --> color(0, 1, 0) print("area(G) = " + geometry.area)
Cyan   --> color(0, 1, 1) print("area(C) = " + geometry.area)
Blue   --> color(0, 0, 1) print("area(B) = " + geometry.area)
"##; marks &[Mark::AlongX]
}

example! {
    /// The middle part lies on both sides of the hole.
    floating_and_absolute, "splitArea operation, Split with Mixture of Floating and Absolute Areas", frame(),
    r##"Lot -->
   print("total area = " + geometry.area)
   splitArea(x) { ~1  : Green
                | 600 : Yellow
                | ~1  : Blue }

Green  --> color(0, 1, 0) print("area(G) = " + geometry.area)
Yellow --> color(1, 1, 0) print("area(Y) = " + geometry.area)
Blue   --> color(0, 0, 1) print("area(B) = " + geometry.area)
"##; marks &[Mark::AlongX]
}

example! {
    /// Three parts along x, each halved along z.
    nested, "splitArea operation, Nested Split", triangle(),
    r##"Lot -->
   print("total area = " + geometry.area)
   splitArea(x) { ~1 : splitArea(z) { '0.5 : Red
                                    | '0.5 : Yellow }
                | ~1 : splitArea(z) { '0.5 : Green
                                    | '0.5 : Cyan }
                | ~1 : splitArea(z) { '0.5 : Blue
                                    | '0.5 : Magenta }
                }

Red     --> color(1, 0, 0) print("area(R) = " + geometry.area)
Yellow  --> color(1, 1, 0) print("area(Y) = " + geometry.area)
Green   --> color(0, 1, 0) print("area(G) = " + geometry.area)
Cyan    --> color(0, 1, 1) print("area(C) = " + geometry.area)
Blue    --> color(0, 0, 1) print("area(B) = " + geometry.area)
Magenta --> color(1, 0, 1) print("area(M) = " + geometry.area)
"##; marks &[Mark::AlongX]
}

// `SplitLeaf` ends with `comp(e) { all : color(0, 0, 0) Edge. }` on the page, which draws the scopes' borders in black. Edges
// are no components here yet, so that line is left out of the three examples that follow.

example! {
    /// The page shows this shape with its scope and gives no rule for it.
    scope_of_shapes, "splitArea operation, adjust vs. noAdjust: the original shape", shapes(),
    r##"Original -->
   SplitLeaf
SplitLeaf-->
   color(0.5, 0.5, 0.5)
   Geometry.
   primitiveQuad()
   t(0, 0.02, 0)
   Pink

Pink --> color(1, 0.5, 0.5, 0.3)
"##; marks &[Mark::InitialScope]
}

example! {
    /// Each part's scope is the box around it, with the axes of the whole.
    adjusted, "splitArea operation, adjust vs. noAdjust: adjust", shapes(),
    r##"SplitAdjust -->
   splitArea(x) { '0.2 : splitArea(z) { '0.2 : SplitLeaf }* }*
SplitLeaf-->
   color(0.5, 0.5, 0.5)
   Geometry.
   primitiveQuad()
   t(0, 0.02, 0)
   Pink

Pink --> color(1, 0.5, 0.5, 0.3)
"##
}

example! {
    /// The scopes of the parts are to fill the scope of the whole.
    not_adjusted, "splitArea operation, adjust vs. noAdjust: noAdjust", shapes(),
    r##"SplitNoAdjust -->
   splitArea(x, noAdjust) { '0.2 : splitArea(z, noAdjust) { '0.2 : SplitLeaf }* }*
SplitLeaf-->
   color(0.5, 0.5, 0.5)
   Geometry.
   primitiveQuad()
   t(0, 0.02, 0)
   Pink

Pink --> color(1, 0.5, 0.5, 0.3)
"##
}

example! {
    /// The page shows this shape with its scope and gives no rule for it.
    scope_of_block, "splitArea operation, Divide a Block: the original shape", block(),
    r##"Original -->
   color(0.5, 0.5, 0.5)
   Geometry.
   primitiveQuad()
   t(0, 0.02, 0)
   Pink

Pink --> color(1, 0.5, 0.5, 0.3)
"##; marks &[Mark::InitialScope]
}

example! {
    /// Halves of halves of halves across the longer side have one area and one colour.
    block_by_area, "splitArea operation, Divide a Block into Equal Parts", block(),
    r##"Lot -->
   SplitArea(3)
SplitArea(n) -->
   case n == 0 :
      A
   case scope.sz > scope.sx :
      splitArea(z) { ~1 : SplitArea(n-1)
                   | ~1 : SplitArea(n-1) }
   else :
      splitArea(x) { ~1 : SplitArea(n-1)
                   | ~1 : SplitArea(n-1) }

A -->
   color(getColor)
   print("area(A) = " + geometry.area)

const minArea = 243
const maxArea = 1255
alpha = (geometry.area - minArea)/(maxArea - minArea)
getColor = colorRamp("spectrum", alpha)
"##
}

example! {
    /// The same with lengths instead of areas: the colours tell the areas apart.
    block_by_length, "splitArea operation, Divide a Block with split", block(),
    r##"Lot2 -->
   Split(3)
Split(n) -->
   case n == 0 :
      B
   case scope.sz > scope.sx :
      split(z) { ~1 : Split(n-1)
               | ~1 : Split(n-1) }
   else :
      split(x) { ~1 : Split(n-1)
               | ~1 : Split(n-1) }

B -->
   color(getColor)
   print("area(B) = " + geometry.area)

const minArea = 243
const maxArea = 1255
alpha = (geometry.area - minArea)/(maxArea - minArea)
getColor = colorRamp("spectrum", alpha)
"##
}
