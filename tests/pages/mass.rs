//! *footprint*, *envelope* and *innerRectangle operations*.

use cga::glam::DVec3;
use cga::{Mesh, MeshBuilder, Shape};

use super::example::{Example, example};

/// In the order of the pages.
pub const ALL: &[Example] = &[
    envelope_parameters::EXAMPLE,
    envelope_slope::EXAMPLE,
    envelope_tags::EXAMPLE,
    envelope_notch::EXAMPLE,
    envelope_concave::EXAMPLE,
    footprint::EXAMPLE,
    inner_rectangle_scope::EXAMPLE,
    inner_rectangle_edge::EXAMPLE,
    inner_rectangle_lots::EXAMPLE,
    inner_rectangle_faces::EXAMPLE,
    inner_rectangle_aligned::EXAMPLE,
    inner_rect::EXAMPLE,
];

/// A lot with a front of 20 metres.
fn lot() -> Shape {
    Shape::footprint(&[[0.0, 30.0], [20.0, 30.0], [20.0, 0.0], [0.0, 0.0]], &[]).expect("an outline")
}

/// The same lot with a front yard 10 metres deep.
fn deep_lot() -> Shape {
    Shape::footprint(&[[0.0, 40.0], [20.0, 40.0], [20.0, 0.0], [0.0, 0.0]], &[]).expect("an outline")
}

fn yard() -> Shape {
    let hole = vec![[6.0, 6.0], [14.0, 6.0], [14.0, 14.0], [6.0, 14.0]];
    Shape::footprint(&[[0.0, 20.0], [20.0, 20.0], [20.0, 0.0], [0.0, 0.0]], &[hole]).expect("an outline")
}

fn bent_lot() -> Shape {
    let outline = [[0.0, 22.0], [12.0, 22.0], [12.0, 10.0], [26.0, 10.0], [26.0, 0.0], [0.0, 0.0]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

/// The lot of the pictures of *innerRectangle operation*, with corners as read from them, in the axes of its scope.
///
/// # Panics
/// Never.
fn concave_lot() -> Shape {
    let outline =
        [[1.0, 42.0], [57.0, 3.0], [111.0, 46.0], [208.0, 18.0], [239.0, 89.0], [156.0, 128.0], [52.0, 130.0]];
    let corners = outline.map(|[x, z]| DVec3::new(x, 0.0, z) / 10.0);
    let corners: Vec<DVec3> = corners.into_iter().rev().collect();
    let mesh = Mesh::from_polygon(&corners, &[]).expect("an outline");
    Shape::mesh_axis_aligned(mesh).seed(3)
}

/// Slanted faces side by side, as on the page.
fn slanting_lots() -> Shape {
    let mut builder = MeshBuilder::new();
    let points: Vec<u32> = [
        [0.0, 0.0, 0.0],
        [30.0, 9.0, -8.0],
        [34.0, 10.0, 8.0],
        [14.0, 3.0, 20.0],
        [-4.0, 0.0, 12.0],
        [62.0, 4.0, 0.0],
        [66.0, 0.0, 16.0],
        [40.0, 3.0, 24.0],
    ]
    .map(|at| builder.point(at))
    .to_vec();
    for face in [[0, 4, 2, 1], [4, 3, 2, 2], [1, 2, 6, 5], [2, 7, 6, 6]] {
        let mut ring: Vec<u32> = face.iter().map(|&k: &usize| points[k]).collect();
        ring.dedup();
        builder.polygon(&ring);
    }
    Shape::mesh(builder.build().expect("faces"))
}

/// Level lots between two streets that are not parallel.
fn row_of_lots() -> Shape {
    let mut builder = MeshBuilder::new();
    for k in 0..4 {
        let x = f64::from(k) * 20.0;
        let depth = |x: f64| 12.0 + 0.2 * x;
        let (front, back) = ([x, 0.0, 0.0], [x + 19.5, 0.0, 0.0]);
        let ring = [front, back, [x + 23.0, 0.0, -depth(x + 23.0)], [x + 4.0, 0.0, -depth(x + 4.0)]];
        let ring = ring.map(|at| builder.point(at));
        builder.polygon(&ring);
    }
    Shape::mesh(builder.build().expect("lots")).seed(1)
}

example! {
    /// The page has a picture and no numbers.
    envelope_parameters, "envelope operation, basic parameters", lot(),
    r#"Lot --> envelope(normal, 16, 8, 50, 7, 55, 7.5, 60) Envelope.
"#
}

example! {
    /// "The example code above creates a building envelope with a slope of 30 degrees facing the street-side."
    envelope_slope, "envelope operation, Street-facing Slope", deep_lot(),
    r#"Lot -->
   setback(10) { street.front : color(0,1,0) FrontYard
               | remainder    : Building }
Building -->
   envelope(normal, 50, 15, 30)
"#
}

example! {
    /// The colours of the page; its picture shows a base that is lower at one side.
    envelope_tags, "envelope operation, Component tags", yard(),
    r##"Lot --> envelope(normal, 8, 4.5, 60, 4.5, 60, 5.5, 60, 4.5, 60) Colored
Colored --> comp(f) {
   isTagged("envelope.bottom") : color("#0399F5") Bottom. | isTagged("envelope.side.base") : color("#FADB19") Base. |
   isTagged("envelope.side.slope") : color("#FF9900") Slope. | isTagged("envelope.side.inner") : color("#FF360A") Inner. |
   isTagged("envelope.top") : color("#09DE1F") Top. }
"##; marks &[Mark::Lowered("Bottom")]
}

example! {
    /// Without a base height the slope begins at the ground; here it reaches the hole.
    envelope_notch, "component tags, a slope with a notch", yard(),
    r##"Lot --> envelope(normal, 6, 0, 38, 4, 60, 4, 60, 4, 60) Colored
Colored --> comp(f) {
   isTagged("envelope.bottom") : color("#0399F5") Bottom. | isTagged("envelope.side.base") : color("#FADB19") Base. |
   isTagged("envelope.side.slope") : color("#FF9900") Slope. | isTagged("envelope.side.inner") : color("#FF360A") Inner. |
   isTagged("envelope.top") : color("#09DE1F") Top. }
"##; marks &[Mark::Lowered("Bottom")]
}

example! {
    /// Not on the page: slopes of a concave lot end at each other.
    envelope_concave, "envelope operation, a concave lot", bent_lot(),
    r##"Lot --> envelope(normal, 9, 5, 45, 5, 45, 5, 45) comp(f) {
   isTagged("envelope.side.base") : color("#FADB19") Base. | isTagged("envelope.side.slope") : color("#FF9900") Slope. |
   isTagged("envelope.top") : color("#09DE1F") Top. | all : Bottom. }
"##
}

example! {
    /// "A schematic low-poly version of a building is created by an extrusion of the footprint."
    footprint, "footprint operation", Shape::point([0.0, 0.0, 0.0]),
    r#"Example -->
    i("building.obj")
    ShowAsset.
    Footprint(scope.sy)
Footprint(height) -->
    footprint()
    extrude(height)
    set(material.opacity, 0.25)
"#
}

example! {
    /// "This example shows the largest inner rectangle aligned to the scope axes."
    inner_rectangle_scope, "innerRectangle operation, scope", concave_lot(),
    r#"Lot-->
   innerRectangle(scope) {shape : Color | remainder : Color}
Color-->
   color(rand(1),rand(1),rand(1))
"#; marks &[Mark::InitialBox, Mark::FromAbove]
}

example! {
    /// "This example shows the largest inner rectangle aligned to one edge."
    inner_rectangle_edge, "innerRectangle operation, edge", concave_lot(),
    r#"Lot-->
   innerRectangle(edge) {shape : Color | remainder = Color}

Color-->
   color(rand(1),rand(1),rand(1))
"#; marks &[Mark::InitialBox, Mark::FromAbove]
}

example! {
    /// "Each rectangle has sides parallel to the scope axes."
    inner_rectangle_lots, "innerRectangle operation, mass volumes in planar lots", row_of_lots(),
    r#"Lot-->
   innerRectangle(scope) { shape : Extrude | remainder : Color }
Extrude-->
   extrude(5)
Color-->
   color(0,1,0)
"#
}

example! {
    /// "Each generated inner shape is a rectangle seen from the face normal."
    inner_rectangle_faces, "innerRectangle operation, slanting faces", slanting_lots(),
    r#"Lot-->
   comp(f) { all : Rectangle }
Rectangle-->
   innerRectangle(scope) { shape : Extrude | remainder : Color }

Extrude-->
   extrude(5)
Color-->
   color(0,1,0)
"#
}

example! {
    /// "When the scope is aligned to the world coordinate system each inner shape is a rectangle seen from the world's y axis."
    inner_rectangle_aligned, "innerRectangle operation, aligned to the world", slanting_lots(),
    r#"Lot-->
   alignScopeToAxes()
   innerRectangle(scope) { shape : Extrude | remainder : Color }
Extrude-->
   extrude(world.up.flatTop, 10)

Color-->
   color(0,1,0)
"#
}

example! {
    /// "This example shows how to use innerRect() to place mass volumes in lots."
    inner_rect, "innerRect operation", row_of_lots(),
    r##"Lot-->
   innerRect
   color("#ff0000")
   set(material.color.a, 0.3)
   extrude(20)
"##
}
