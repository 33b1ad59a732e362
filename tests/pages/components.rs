//! *comp operation*, the other examples: façades, conditions, trim planes, borders, tags, edges, vertices, groups and materials.
//!
//! The rules are taken from the page, except where an example says otherwise. The page writes `X.` where it calls its rule `X`.

use cga::{MeshBuilder, Shape};

use super::example::{Example, example};
use super::meshes;

/// In the order of the page.
pub const ALL: &[Example] = &[
    mass::EXAMPLE,
    aligned::EXAMPLE,
    kept::EXAMPLE,
    condition::EXAMPLE,
    large_or_border::EXAMPLE,
    own_function::EXAMPLE,
    numbers::EXAMPLE,
    trim_vertical::EXAMPLE,
    trim_both::EXAMPLE,
    border_faces::EXAMPLE,
    border_edges::EXAMPLE,
    border_vertices::EXAMPLE,
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

/// A lot whose right side leans outwards to the front.
fn lot() -> Shape {
    Shape::footprint(&[[0.0, 6.0], [8.0, 6.0], [6.5, 0.0], [0.5, 0.0]], &[]).expect("an outline")
}

/// A polygon with one concave corner.
fn arrow() -> Shape {
    Shape::footprint(&[[0.0, 4.0], [2.0, 7.0], [5.0, 4.5], [9.0, 5.0], [6.0, 0.0]], &[]).expect("an outline")
}

fn yard() -> Shape {
    let hole = |x: f64| vec![[x, 2.], [x + 2., 2.], [x + 2., 6.], [x, 6.]];
    Shape::footprint(&[[0., 8.], [10., 8.], [10., 0.], [0., 0.]], &[hole(1.5), hole(6.5)]).expect("an outline")
}

/// A plane of 10 × 10 faces, 1 m wide.
fn grid() -> Shape {
    let mut builder = MeshBuilder::new();
    for at in 0..100 {
        let (x, z) = (f64::from(at % 10), f64::from(at / 10));
        let corners = [(x, z + 1.0), (x + 1.0, z + 1.0), (x + 1.0, z), (x, z)];
        let ring = corners.map(|(x, z)| builder.point([x / 10.0, 0.0, z / 10.0]));
        builder.polygon(&ring);
    }
    Shape::mesh(builder.build().expect("a plane"))
}

/// A triangle of strips 1 m wide, the two in the middle with a face across both.
fn triangle() -> Shape {
    let (low, high) = (1.5, 3.0);
    let faces: [&[[f64; 2]]; 11] = [
        &[[0., 0.], [1., 0.], [1., 2.]],
        &[[1., 0.], [2., 0.], [2., 4.], [1., 2.]],
        &[[2., 0.], [3., 0.], [3., low], [3., high], [3., 6.], [2., 4.]],
        &[[3., 0.], [4., 0.], [4., low], [3., low]],
        &[[4., 0.], [5., 0.], [5., low], [4., low]],
        &[[3., low], [4., low], [5., low], [5., high], [4., high], [3., high]],
        &[[3., high], [4., high], [4., 8.], [3., 6.]],
        &[[4., high], [5., high], [5., 6.], [4., 8.]],
        &[[5., 0.], [6., 0.], [6., 4.], [5., 6.], [5., high], [5., low]],
        &[[6., 0.], [7., 0.], [7., 2.], [6., 4.]],
        &[[7., 0.], [8., 0.], [7., 2.]],
    ];
    let mut builder = MeshBuilder::new();
    for face in faces {
        let ring: Vec<u32> = face.iter().map(|[x, up]| builder.point([*x, 0.0, -up])).collect();
        builder.polygon(&ring);
    }
    Shape::mesh(builder.build().expect("a triangle"))
}

/// A cylinder whose faces begin with the right end.
fn tube() -> Shape {
    let cylinder = meshes::lying_cylinder(16, 3.0, 8.0);
    let mut builder = MeshBuilder::new();
    cylinder.points().iter().for_each(|point| {
        builder.point(*point);
    });
    let end = cylinder.face_count() - 1;
    for face in [end].into_iter().chain(0..end) {
        builder.polygon(cylinder.face(face).outer());
    }
    Shape::mesh_axis_aligned(builder.build().expect("a cylinder"))
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
        builder.polygon(&ring);
    }
    Shape::mesh_axis_aligned(builder.build().expect("a roof"))
}

/// A trunk, a crown and fruits: groups, and materials of the same names.
fn tree() -> Shape {
    Shape::mesh_axis_aligned(meshes::tree())
}

fn ball() -> Shape {
    Shape::mesh_axis_aligned(meshes::sphere(16, 8, 5.0))
}

example! {
    /// "Note the position and orientation of the pivot and scope (the annotated axes)."
    mass, "comp operation, Face split, the mass", lot(),
    r##"Lot -->
   extrude(5)
   color(1,1,1,0.75)
"##; marks &[Mark::Scopes("Lot"), Mark::InitialPivot]
}

example! {
    /// "The x-axis points along the first edge and the z-axis points along the face normal."
    aligned, "comp operation, Face split", lot(),
    r##"Lot -->
   extrude(5)
   comp(f) { right : color(1,1,0,0.75) Right. |
             side  : color(1,1,1,0.75) Side.  }
"##; marks &[Mark::Scopes("Right"), Mark::Pivots("Right")]
}

example! {
    /// "The pivot is kept when using the noAlign mode. The scope orientation does not change."
    kept, "comp operation, Face split, noAlign", lot(),
    r##"Lot -->
   extrude(5)
   comp(f,noAlign) { right : color(1,1,0,0.75) Right. |
                     side  : color(1,1,1,0.75) Side.  }
"##; marks &[Mark::Scopes("Right"), Mark::InitialPivot]
}

example! {
    /// "Here both the top and front faces are combined into a single shape."
    condition, "comp operation, Logical selection: top || front", ball(),
    r##"Sphere --> comp(f) { top || front = X. }
"##
}

example! {
    /// "Only faces with a surface area greater than 1 and that are not inside are selected."
    large_or_border, "comp operation, Logical selection: area and border", triangle(),
    r##"Triangle -->
   comp(f) { geometry.area() > 1 && !inside : X. }
"##; marks &[Mark::FromAbove]
}

example! {
    /// "A custom function is used to select the top faces and all faces with exactly 3 vertices."
    own_function, "comp operation, Logical selection: a function", ball(),
    r##"mySelectorFunc =
    geometry.isOriented(top) || geometry.nVertices==3
Sphere -->
   comp(f) { mySelectorFunc : X. }
"##
}

example! {
    /// "Here, only faces 0, 2 and 4 of the cylinder are selected."
    numbers, "comp operation, Index-based Selection", tube(),
    r##"Tube -->
   comp(f) {
      0 : X. |
      2 : X. |
      4 : X.
   }
"##
}

example! {
    /// "Inserted geometry is cut with the trim planes."
    trim_vertical, "comp operation, Trim planes: vertical", Shape::cuboid(10.0, 10.0, 10.0),
    r##"Start -->
   s(10,10,10)
   primitiveCube()
   comp(f) { 5 : X }
X -->
   s(15,'1, 2)
   center(xyz)
   primitiveCube()
"##; marks &[Mark::InitialBox]
}

example! {
    /// "By default, horizontal trim planes are off. Enabling them before inserting the geometry gives a different result."
    trim_both, "comp operation, Trim planes: vertical and horizontal", Shape::cuboid(10.0, 10.0, 10.0),
    r##"Start -->
   s(10,10,10)
   primitiveCube()
   set(trim.horizontal, true)
   comp(f) { 5 : X }
X -->
   s(15,'1, 2)
   center(xyz)
   primitiveCube()
"##; marks &[Mark::InitialBox]
}

example! {
    /// "The example selects the border and inside faces and colors them."
    border_faces, "comp operation, Border and Inside Selectors: faces", grid(),
    r##"Init -->
   comp(f) { border : FBorder | inside : FInside }
FBorder -->
   color("#ff0000")
FInside -->
   color("#00ff00")
"##; marks &[Mark::FromAbove]
}

example! {
    /// "There border and inside edges are selected and colored cubes are inserted."
    border_edges, "comp operation, Border and Inside Selectors: edges", grid(),
    r##"Init-->
   comp(e) { border : EBorder | inside : EInside }
EBorder --> s('1, 0.05, 0.05) t(0, '-0.5, 0)
            color("#ff0000") primitiveCube()
EInside --> s('1, 0.01, 0.01) t(0, '-0.5, 0)
            color("#00ff00") primitiveCube()
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "The border and inside vertices are used to insert colored cubes."
    border_vertices, "comp operation, Border and Inside Selectors: vertices", grid(),
    r##"Init -->
   comp(v) { border : VBorder | inside : VInside }
VBorder --> s(0.05, 0.05, 0.05) t(-0.025, -0.025, -0.025)
            color("#ff0000") primitiveCube()
VInside --> s(0.05, 0.05, 0.05) t(-0.025, -0.025, -0.025)
            color("#00ff00") primitiveCube()
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// Faces by the tags that `extrude` gives. The page tags with `envelope`.
    tagged, "comp operation, isTagged Selector", yard(),
    r##"Init --> extrude(4) comp(f) {
   isTagged("extrude.bottom") : color("#0399F5") Bottom. | isTagged("extrude.side.outer") : color("#FADB19") Outer. |
   isTagged("extrude.side.inner") : color("#FF360A") Inner. | isTagged("extrude.top") : color("#09DE1F") Top. }
"##; marks &[Mark::Lowered("Bottom")]
}

example! {
    /// Eaves green, hips yellow, valleys blue, ridges red. The page has a picture and no rules.
    roof_edges, "comp operation, Roof Edges", roof(),
    r##"Roof --> Slopes. comp(e) {
   eave : Bar("#20c020") | hip : Bar("#e0d020") | valley : Bar("#2040e0") | ridge : Bar("#e02020") }
Bar(tint) --> s('1, 0.25, 0.25) center(yz) color(tint) primitiveCube() Bar.
"##
}

example! {
    /// "The x-axis is parallel to the edge, the z-axis is the average of the neighboring face normals."
    edges, "comp operation, Edge Split", lot(),
    r##"Lot --> extrude(3)
        comp(e) { all : primitiveCube() s('1, 0.25, 1) X. }
"##; marks &[Mark::Initial, Mark::Scope("X", 6)]
}

example! {
    /// "The x-axis points in face orientation, the z-axis is pointing out of the face orthogonally to the edge and the face normal."
    face_edges, "comp operation, Face Edge Split", lot(),
    r##"Lot --> extrude(3)
        comp(fe) { all : primitiveCube() s('1, 0.25, 1) X. }
"##; marks &[Mark::Initial, Mark::Scope("X", 4)]
}

example! {
    /// "The z-axes points along the average of the neighboring face normals." Bars along the axes show the pivots.
    vertices, "comp operation, Vertex Split", lot(),
    r##"Lot -->
   extrude(10)
   MassModel
   comp(v) { all : VShapes }

VShapes --> [ s(1, 0.2, 0.2) color(1, 0, 0) primitiveCube() X. ]
            [ s(0.2, 1, 0.2) color(0, 1, 0) primitiveCube() Y. ]
            [ s(0.2, 0.2, 1) color(0, 0, 1) primitiveCube() Z. ]
"##
}

example! {
    /// "The x-axis is the tangent to the polygon, the z-axis points outside of the polygon and the y-axis is the face normal." Bars
    /// along the axes show the pivots.
    face_vertices, "comp operation, Face Vertex Split", arrow(),
    r##"Lot -->
   comp(fv) { all : VShapes }

VShapes --> [ s(1, 0.2, 0.2) color(1, 0, 0) primitiveCube() X. ]
            [ s(0.2, 1, 0.2) color(0, 1, 0) primitiveCube() Y. ]
            [ s(0.2, 0.2, 1) color(0, 0, 1) primitiveCube() Z. ]
"##; marks &[Mark::Initial]
}

example! {
    /// Holes filled. The page has no example of holes.
    holes, "comp operation, holes", yard(),
    r##"Lot --> Ground. comp(h) { all : color("#ffe030") extrude(1) Hole. }
"##
}

example! {
    /// "A tree model is split into its groups." The page inserts the tree with `i`.
    groups, "comp operation, Group Split", tree(),
    r##"Lot -->
   comp(g) { findFirst(geometry.materials,"Bark") : Trunk.
           | all = set(material.opacity, 0.2) Foliage. }
"##
}

example! {
    /// "A tree model is split into its materials." The page inserts the tree with `i`.
    materials, "comp operation, Material Split", tree(),
    r##"Lot -->
   comp(m) { findFirst(geometry.materials,"Foliage") : Oranges.
           | findFirst(geometry.materials,"Bark")    : Trunk. }
"##
}
