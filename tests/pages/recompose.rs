//! *Shape recomposition*, *modify operation* and the recomposed examples of *Rule inlining*.

use cga::Shape;

use super::example::{Example, example};

/// In the order of the pages.
pub const ALL: &[Example] = &[
    parts::EXAMPLE,
    parts_moved::EXAMPLE,
    edges::EXAMPLE,
    insets::EXAMPLE,
    shared_edge::EXAMPLE,
    new_vertices::EXAMPLE,
    four_faces::EXAMPLE,
    plane::EXAMPLE,
    top::EXAMPLE,
    sides::EXAMPLE,
    random::EXAMPLE,
    ridge::EXAMPLE,
    tapered::EXAMPLE,
    grid::EXAMPLE,
    roof::EXAMPLE,
    twist::EXAMPLE,
];

fn square() -> Shape {
    Shape::rectangle(10.0, 10.0)
}

fn plank() -> Shape {
    Shape::rectangle(9.0, 3.0)
}

example! {
    /// The edges between the parts stay until a cleanup, as in `cleanup::f_shape`.
    parts, "Shape recomposition, Connectivity tracking", Shape::rectangle(20.0, 40.0),
    r#"Init -->
 inline(recompose) split(x) { 10: X.
      | ~1: split(z) { 10: X. | 10: NIL }* }
"#; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// The upper parts follow the lower one.
    parts_moved, "Shape recomposition, Connectivity tracking, translated sideways", Shape::rectangle(20.0, 40.0),
    r#"Init -->
 inline(recompose) split(x) { 10: t(0,0,8) X.
      | ~1: split(z) { 10: X. | 10: NIL }* }
"#; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// Two edges are scaled; their common vertex gets both offsets.
    edges, "Shape recomposition, Vertex merging", square(),
    r#"Init -->
 modify(fe) { 0: s('0.5,0,0) center(x) X.
      | 1: s('0.6,0,0) center(x) X. }
"#; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    insets, "Shape recomposition, InsetExample", square(),
    r#"InsetExample -->
  modify(fe) { all: split(x) { ~1: X.| 1: X. | 3: t(0,0,-2) X. | 1: X. | ~1: X. } }
"#; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// Thirds and sixths: two of the new vertices meet.
    shared_edge, "Shape recomposition, Merging along shared edges", square(),
    r#"Init --> inline(recompose) split(x) { '0.5: Bottom | '0.5: Top }
Bottom --> s('1,'1,'1.5) center(z) split(z) { '1/3: X. }*
Top --> split(z) { '1/6: X. }*
"#; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    new_vertices, "Shape recomposition, Merging along shared edges, split vertically", square(),
    r#"Init --> inline(recompose) split(x) { '0.5: Bottom | '0.5: Top }
Bottom --> s('1,'1,'1.5)
Top --> split(x) { '0.2: X. }*
"#; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// The face is a grid of four.
    four_faces, "Shape recomposition, Accumulating offsets", square(),
    r#"FourFaces -->
  inline(recompose) split(x) { '0.5: split(z) { '0.5: X. }* }*
  modify(f,noAlign) { all: t(0,1,0) X. }
"#
}

example! {
    plane, "Shape recomposition, Shifted plane", plank(),
    r#"Init -->
  inline(recompose) SplitAndTranslate
SplitAndTranslate -->
  split(x) { ~1: X. | ~1: X. | ~1: t(0,2,0) X. }
"#
}

example! {
    top, "Shape recomposition, Shifted plane on a body", plank(),
    r#"Init -->
  extrude(5)
  modify(f,noAlign) { top: SplitAndTranslate }
SplitAndTranslate -->
  split(x) { ~1: X. | ~1: X. | ~1: t(0,2,0) X. }
"#
}

example! {
    sides, "Shape recomposition, Shifted plane, deleted", plank(),
    r#"Init -->
  extrude(5)
  modify(f,noAlign) { top: SplitAndTranslateNIL }
SplitAndTranslateNIL -->
  split(x) { ~1: NIL | ~1: NIL | ~1: t(0,2,0) NIL }
"#
}

example! {
    random, "Shape recomposition, Random split and transform", square(),
    r#"Init -->
  inline(recompose) RandomSplitX
RandomSplitX --> split(x) { rand(0.5,1): RandomSplitZ | ~1: RandomSplitX }
RandomSplitZ --> split(z) { rand(0.5,1): Cell | ~1: RandomSplitZ }
Cell --> t(0, rand(-0.2,0.2), 0)
"#
}

example! {
    ridge, "modify operation, Modified roof ridge", Shape::rectangle(10.0, 6.0),
    r#"Init -->
  extrude(5)
  comp(f) { top: ModifiedRoof | side: Facade. }
ModifiedRoof -->
  roofHip(45)
  modify(e) { ridge: t(0,2,0) X. }
"#; marks &[Mark::From(50.0, 30.0)]
}

example! {
    /// The sizes shrink towards the corner of the face.
    tapered, "modify operation, Tapered mass", square(),
    r#"Init -->
  extrude(5)
  modify(f) { top: s('0.5, '0.5, '0.5) X. }
"#
}

example! {
    grid, "modify operation, Hyperbolic grid", square(),
    r#"attr Max_Height = scope.sx/2
Paraboloid with(
   center := getPivotCoord(scope.sx/2, 0, scope.sz/2)
   cenX := center[0]
   cenZ := center[2]
   a := getDampingFac(scope.sx/2)
   b := getDampingFac(scope.sz/2)
   yPos := scope.ty
)-->
   inline(recompose) Grid
   modify(v, noAlign) { all: Move(cenX, cenZ, a, b) }
   set(scope.ty, yPos)
Grid -->
   split(x,noAdjust) { '0.1: split(z) { '0.1: Cell. }* }*
Move(centerX, centerZ, a, b) with(
   x := scope.tx - centerX
   z := scope.tz - centerZ
)-->
   t(0,hyperbolic(x,z,a,b),0)
hyperbolic(x,z,a,b) = (z*z)/(b*b) - (x*x)/(a*a)
getPivotCoord(x,y,z) = convert(scope,pivot,pos,[x,y,z])
getDampingFac(l) = l / sqrt(Max_Height*0.5)
"#
}

example! {
    roof, "modify operation, Hyperbolic roof", square(),
    r#"attr Max_Height = scope.sx/2
Init -->
  extrude(5)
  modify(f,noAlign) { top: Paraboloid }
Paraboloid with(
   center := getPivotCoord(scope.sx/2, 0, scope.sz/2)
   cenX := center[0]
   cenZ := center[2]
   a := getDampingFac(scope.sx/2)
   b := getDampingFac(scope.sz/2)
   yPos := scope.ty
)-->
   inline(recompose) Grid
   modify(v, noAlign) { all: Move(cenX, cenZ, a, b) }
   set(scope.ty, yPos)
Grid -->
   split(x,noAdjust) { '0.1: split(z) { '0.1: Cell. }* }*
Move(centerX, centerZ, a, b) with(
   x := scope.tx - centerX
   z := scope.tz - centerZ
)-->
   t(0,hyperbolic(x,z,a,b),0)
hyperbolic(x,z,a,b) = (z*z)/(b*b) - (x*x)/(a*a)
getPivotCoord(x,y,z) = convert(scope,pivot,pos,[x,y,z])
getDampingFac(l) = l / sqrt(Max_Height*0.5)
"#
}

example! {
    /// The page deletes the faces between the slices, by a tag.
    twist, "Rule inlining, Twist and taper", Shape::rectangle(40.0, 40.0),
    r#"attr Twist_Angle = 180
attr Taper_Factor = 0.5
attr Resolution = 24
Init -->
  extrude(100)
  inline(recompose) split(y) { '1/Resolution: Slice }*
Slice --> modify(f,noAlign) { top: RotateRescale }
RotateRescale with(
  a := split.index / (Resolution-1)
  f := (1-a) + a*Taper_Factor
)-->
  r(0,(split.index+1)*Twist_Angle/Resolution,0)
  s('f,'1,'f)
  center(xz)
"#
}
