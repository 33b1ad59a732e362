//! *comp operation*, the examples that need more than faces by direction: alignment, conditions, trim planes, connected faces,
//! borders, tags, edges, vertices, holes, groups and materials.

use cga::mesh::FaceTag;
use cga::{MeshBuilder, Shape};

use super::example::{Example, example};
use super::meshes;

/// In the order of the page.
pub(crate) const ALL: &[Example] = &[
    aligned::EXAMPLE,
    kept::EXAMPLE,
    condition::EXAMPLE,
    own_function::EXAMPLE,
    numbers::EXAMPLE,
    trim_upright::EXAMPLE,
    trim_level::EXAMPLE,
    mitre::EXAMPLE,
    connected::EXAMPLE,
    border::EXAMPLE,
    tagged::EXAMPLE,
    roof_edges::EXAMPLE,
    edges::EXAMPLE,
    face_edges::EXAMPLE,
    vertices::EXAMPLE,
    face_vertices::EXAMPLE,
    holes::EXAMPLE,
    groups::EXAMPLE,
    materials::EXAMPLE,
];

fn wings() -> Shape {
    let outline = [[0., 9.], [9., 9.], [9., 5.], [4., 5.], [4., 0.], [0., 0.]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

fn yard() -> Shape {
    let hole = |x: f64| vec![[x, 2.], [x + 2., 2.], [x + 2., 6.], [x, 6.]];
    Shape::footprint(&[[0., 8.], [10., 8.], [10., 0.], [0., 0.]], &[hole(1.5), hole(6.5)]).expect("an outline")
}

/// A plane of four by four faces.
fn grid() -> Shape {
    let mut builder = MeshBuilder::new();
    for at in 0..16 {
        let (x, z) = (f64::from(at % 4), f64::from(at / 4));
        let ring = [(x, z + 1.0), (x + 1.0, z + 1.0), (x + 1.0, z), (x, z)].map(|(x, z)| builder.point([x, 0.0, z]));
        builder.face(&ring, &[], FaceTag::PLAIN);
    }
    Shape::mesh(builder.build().expect("a plane"))
}

/// A hip roof over an L: it has all kinds of edges.
fn roof() -> Shape {
    let mut builder = MeshBuilder::new();
    let points = [
        [0., 0., 9.],
        [4., 0., 9.],
        [4., 0., 4.],
        [9., 0., 4.],
        [9., 0., 0.],
        [0., 0., 0.],
        [2., 2., 7.],
        [2., 2., 2.],
        [7., 2., 2.],
    ];
    let p = points.map(|point| builder.point(point));
    let faces: [&[usize]; 6] = [&[0, 1, 6], &[1, 2, 7, 6], &[2, 3, 8, 7], &[3, 4, 8], &[4, 5, 7, 8], &[5, 0, 6, 7]];
    for face in faces {
        let ring: Vec<u32> = face.iter().map(|&corner| p[corner]).collect();
        builder.face(&ring, &[], FaceTag::PLAIN);
    }
    Shape::mesh_axis_aligned(builder.build().expect("a roof"))
}

/// A trunk, a crown and fruits: groups, and materials of the same names.
fn tree() -> Shape {
    Shape::mesh_axis_aligned(meshes::tree())
}

fn ball() -> Shape {
    Shape::mesh_axis_aligned(meshes::sphere(16, 12, 5.0))
}

example! {
    /// Scope and pivot of each child follow its face.
    aligned, "comp operation, Face split, aligned", wings(),
    r##"Lot --> extrude(5) comp(f) { right : color("#f2d24b") Bar Right. | side : Bar Side. | top : Top. }
Bar --> s('1, '0.1, 0.3) color("#c04030") primitiveCube() Bar.
"##
}

example! {
    /// With `noAlign` they keep those of the lot.
    kept, "comp operation, Face split, noAlign", wings(),
    r##"Lot --> extrude(5) comp(f, noAlign) { right : color("#f2d24b") Bar Right. | side : Bar Side. | top : Top. }
Bar --> s('1, '0.1, '1) color("#c04030") primitiveCube() Bar.
"##
}

example! {
    /// Words in a condition: faces on top or in front become one shape.
    condition, "comp operation, Logical selection, ||", ball(),
    r##"Sphere --> comp(f) { top || front = color("#ffe030") X. | all = Rest. }
"##
}

example! {
    /// A function of one's own: faces on top, and those with three vertices.
    own_function, "comp operation, Logical selection, function", ball(),
    r##"chosen = geometry.isOriented(top) || geometry.nVertices == 3
Sphere --> comp(f) { chosen : color("#ffe030") X. | all : Rest. }
"##
}

example! {
    /// Faces by number.
    numbers, "comp operation, Index-based Selection", Shape::mesh_axis_aligned(meshes::lying_cylinder(8, 3.0, 8.0)),
    r##"Tube --> comp(f) { 0 : X | 2 : X | 4 : X | all : Rest. }
X --> color("#ffe030") X.
"##
}

example! {
    /// What is put at a face is cut at upright trim planes.
    trim_upright, "comp operation, Trim planes, vertical", Shape::cuboid(10.0, 10.0, 10.0),
    r##"Start --> s(10, 10, 10) primitiveCube() comp(f) { 5 : X Front. | all : Rest. }
X --> s(15, '1, 2) center(x) color("#9fd06c") primitiveCube() X.
"##
}

example! {
    /// And at level ones, when they are switched on.
    trim_level, "comp operation, Trim planes, both", Shape::cuboid(10.0, 10.0, 10.0),
    r##"Start --> s(10, 10, 10) primitiveCube() set(trim.horizontal, true)
  comp(f) { 5 : X Front. | all : Rest. }
X --> s(15, 15, 2) center(xy) color("#9fd06c") primitiveCube() X.
"##
}

example! {
    /// Cornices meet in mitres.
    mitre, "comp operation, Trim planes, cornice", wings(),
    r##"Lot --> extrude(5) comp(f) { side : Side | top : Top. }
Side --> [ s('1.5, 1, 1) center(x) t(0, 4, 0) color(0.3 + 0.1 * comp.index, 0.5, 0.4) primitiveCube() Cornice. ] Wall.
"##
}

example! {
    /// Faces in front that touch are one shape.
    connected, "comp operation, Connecting operator =:", crate::pages::comp::comb(),
    r##"Lot --> extrude(10) comp(f) { side && !back =: color(rand, rand, rand) Sides. | all = Mass. }
"##
}

example! {
    /// Faces, edges and vertices at the border and inside.
    border, "comp operation, Border and Inside Selectors", grid(),
    r##"Init -->
   comp(f) { border : color("#ff8070") F. | inside : color("#70ff80") F. }
   comp(e) { border : Edge(0.1, "#a00000") | inside : Edge(0.05, "#006000") }
   comp(v) { border : Vertex("#a00000") | inside : Vertex("#006000") }
Edge(width, tint) --> s('1, width, width) center(yz) color(tint) primitiveCube() E.
Vertex(tint) --> s(0.2, 0.2, 0.2) center(xyz) color(tint) primitiveSphere(12, 8) V.
"##
}

example! {
    /// Faces by the tags that `extrude` gives.
    tagged, "comp operation, isTagged Selector", yard(),
    r##"Init --> extrude(4) comp(f) {
   isTagged("extrude.bottom") : color("#0399F5") Bottom. | isTagged("extrude.side.outer") : color("#FADB19") Outer. |
   isTagged("extrude.side.inner") : color("#FF360A") Inner. | isTagged("extrude.top") : color("#09DE1F") Top. }
"##
}

example! {
    /// Eaves green, hips yellow, valleys blue, ridges red.
    roof_edges, "comp operation, Roof Edges", roof(),
    r##"Roof --> Slopes. comp(e) {
   eave : Bar("#20c020") | hip : Bar("#e0d020") | valley : Bar("#2040e0") | ridge : Bar("#e02020") }
Bar(tint) --> s('1, 0.25, 0.25) center(yz) color(tint) primitiveCube() Bar.
"##
}

example! {
    /// Bars along the edges, looking the mean way of their faces.
    edges, "comp operation, Edge Split", wings(),
    r##"Lot --> extrude(3) Mass. comp(e) { all : s('1, 0.2, 1) center(y) color("#b06040") primitiveCube() X. }
"##
}

example! {
    /// Each face's own edges, looking out of it.
    face_edges, "comp operation, Face Edge Split", wings(),
    r##"Lot --> extrude(3) Mass. comp(fe) { all : s('1, 0.1, 0.6) center(y) color("#4070b0") primitiveCube() X. }
"##
}

example! {
    /// Sticks at the vertices.
    vertices, "comp operation, Vertex Split", wings(),
    r##"Lot --> extrude(6) Mass. comp(v) { all : s(0.3, 0.3, 2) center(xy) color("#40a060") primitiveCube() X. }
"##
}

example! {
    /// At the vertices of a polygon, pointing outside.
    face_vertices, "comp operation, Face Vertex Split", yard(),
    r##"Lot --> Ground. comp(fv) { all : s(0.2, 0.2, 1) center(xy) color("#a040a0") primitiveCube() X. }
"##
}

example! {
    /// Holes filled.
    holes, "comp operation, holes", yard(),
    r##"Lot --> Ground. comp(h) { all : color("#ffe030") extrude(1) Hole. }
"##
}

example! {
    /// One group alone.
    groups, "comp operation, Group Split", tree(),
    r##"Lot --> comp(g) { findFirst(geometry.materials, "Bark") : Trunk. | all = set(material.opacity, 0.4) Foliage. }
"##
}

example! {
    /// Two materials of three.
    materials, "comp operation, Material Split", tree(),
    r##"Lot --> comp(m) { findFirst(geometry.materials, "Fruit") : Oranges. | findFirst(geometry.materials, "Bark") : Trunk. }
"##
}
