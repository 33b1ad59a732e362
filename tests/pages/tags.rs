//! *Geometry tagging*, *setTagsFromEdgeAttrs operation* and *edgeAttr functions*, on shapes as in the pictures. Rules
//! whose names end in a dot are the same in all pictures: bars for edges and balls for vertices.

use cga::glam::DVec3;
use cga::mesh::TagSet;
use cga::{Mesh, MeshBuilder, Shape};

use super::example::{Example, example};

/// In the order of the pages.
pub const ALL: &[Example] = &[
    setback_shape::EXAMPLE,
    setback_remainder::EXAMPLE,
    wings_l::EXAMPLE,
    wings_u::EXAMPLE,
    wings_o::EXAMPLE,
    split::EXAMPLE,
    over_faces::EXAMPLE,
    corner::EXAMPLE,
    extruded::EXAMPLE,
    inset::EXAMPLE,
    tapered::EXAMPLE,
    corner_roof::EXAMPLE,
    corner_envelope::EXAMPLE,
    attributes::EXAMPLE,
    sampled::EXAMPLE,
    kept_in_shape::EXAMPLE,
    kept_in_remainder::EXAMPLE,
    walls::EXAMPLE,
    poles::EXAMPLE,
];

/// A lot with six edges in front, as in the pictures of setbacks.
pub fn bend() -> Shape {
    let corners = [
        [3.3, 2.3],
        [6.0, 0.9],
        [8.0, 0.4],
        [10.5, 0.1],
        [12.0, 0.0],
        [14.5, 0.2],
        [29.0, 1.0],
        [27.8, 11.5],
        [0.3, 10.5],
        [0.3, 7.4],
        [1.2, 5.0],
    ];
    let corners = corners.map(|[x, z]| DVec3::new(x, 0.0, -z));
    Shape::mesh_axis_aligned(Mesh::from_polygon(&corners, &[]).expect("an outline"))
}

/// A square of 10 m without its front right quarter: edges and vertices of the square have tags below A, edges and vertices of the quarter
/// below B. Two vertices, where both meet, have none.
pub fn quarter_cut_out() -> Shape {
    let mut builder = MeshBuilder::new();
    let corners = [[0.0, 0.0], [5.0, 0.0], [5.0, 5.0], [10.0, 5.0], [10.0, 10.0], [0.0, 10.0]];
    let points = corners.map(|[x, z]| builder.point([x, 0.0, -z]));
    builder.polygon(&points);
    let tags = |name: &str| TagSet::new([name]);
    for (k, of) in ["A", "B", "B", "A", "A", "A"].into_iter().enumerate() {
        builder.edge_tags([points[k], points[(k + 1) % 6]], &tags(&format!("e.{of}")));
    }
    for (k, of) in [(0, "A"), (2, "B"), (4, "A"), (5, "A")] {
        builder.vertex_tags(points[k], &tags(&format!("v.{of}")));
    }
    Shape::mesh(builder.build().expect("a face"))
}

/// A lot whose edges know what they look at.
pub fn quadrilateral() -> Shape {
    let corners = [[0.0, 9.1], [5.5, 0.0], [11.5, 3.3], [13.2, 16.8]].map(|[x, z]| DVec3::new(x, 0.0, -z));
    let outline = Mesh::from_polygon(&corners, &[]).expect("an outline");
    Shape::mesh_axis_aligned(outline).edge_attribute("orientations", ["front", "front", "side", "side"])
}

/// A square lot with a colour for each edge.
pub fn colours() -> Shape {
    Shape::rectangle(20.0, 20.0).edge_attribute("colors", ["#FFFF00", "#FF0000", "#00FF00", "#0000FF"])
}

example! {
    /// "Operations applying auto-tags on edges", the shape.
    setback_shape, "Geometry tagging, setback", bend(),
    r##"Init --> setback(4) { front : Strip | remainder : color("#cccccc") Rest. }
Strip --> [ color("#ffffff") Ground. ]
          comp(e) { isTagged("setback.front") : color("#0399F5") Bar
                  | isTagged("setback.side")  : color("#FADB19") Bar
                  | isTagged("setback.back")  : color("#09DE1F") Bar }

Bar --> s('1, 0.35, 0.35) center(yz) primitiveCube()
"##
}

example! {
    /// The remainder.
    setback_remainder, "Geometry tagging, the remainder", bend(),
    r##"Init --> setback(4) { front : color("#cccccc") Strip. | remainder : Rest }
Rest --> [ color("#ffffff") Ground. ]
         comp(e) { isTagged("setback.side")      : color("#FADB19") Bar
                 | isTagged("setback.back")      : color("#09DE1F") Bar
                 | isTagged("setback.remainder") : color("#8D09DE") Bar }

Bar --> s('1, 0.35, 0.35) center(yz) primitiveCube()
"##
}

example! {
    /// The auto-tags of shapeL.
    wings_l, "shapeL operation, auto-tags", Shape::rectangle(16.0, 12.0),
    r##"Init --> shapeL(5, 4) { shape : color("#ffffff") Edges | remainder : color("#bbbbbb") Edges }
Edges --> [ Ground. ]
          comp(e) { isTagged("setback.front")     : color("#0399F5") Bar
                  | isTagged("setback.side")      : color("#FADB19") Bar
                  | isTagged("setback.back")      : color("#09DE1F") Bar
                  | isTagged("setback.remainder") : color("#8D09DE") Bar }

Bar --> s('1, 0.4, 0.4) center(yz) primitiveCube()
"##; marks &[Mark::FromAbove]
}

example! {
    /// The auto-tags of shapeU.
    wings_u, "shapeU operation, auto-tags", Shape::rectangle(16.0, 12.0),
    r##"Init --> shapeU(5, 4, 4) { shape : color("#ffffff") Edges | remainder : color("#bbbbbb") Edges }

Edges --> [ Ground. ]
          comp(e) { isTagged("setback.front")     : color("#0399F5") Bar
                  | isTagged("setback.side")      : color("#FADB19") Bar
                  | isTagged("setback.back")      : color("#09DE1F") Bar
                  | isTagged("setback.remainder") : color("#8D09DE") Bar }
Bar --> s('1, 0.4, 0.4) center(yz) primitiveCube()
"##; marks &[Mark::FromAbove]
}

example! {
    /// The auto-tags of shapeO.
    wings_o, "shapeO operation, auto-tags", Shape::rectangle(16.0, 12.0),
    r##"Init --> shapeO(4, 4, 4, 4) { shape : color("#ffffff") Edges | remainder : color("#bbbbbb") Edges }

Edges --> [ Ground. ]
          comp(e) { isTagged("setback.front")     : color("#0399F5") Bar
                  | isTagged("setback.side")      : color("#FADB19") Bar
                  | isTagged("setback.back")      : color("#09DE1F") Bar
                  | isTagged("setback.remainder") : color("#8D09DE") Bar }
Bar --> s('1, 0.4, 0.4) center(yz) primitiveCube()
"##; marks &[Mark::FromAbove]
}

example! {
    /// "These tags are kept by subsequent operations, e.g., when using the split operation."
    split, "Geometry tagging, Geometry subdivision", Shape::rectangle(16.0, 8.0),
    r##"Init --> roofGable(byHeight, 4) tag("EdgeTag", edges) tag("VertexTag", vertices)
         split(x) { '0.25 : t(0, split.index, 0) Marked }*
Marked --> comp(f) { isTagged("roof.bottom") : color("#0399F5") Bottom.
                   | isTagged("roof.side")   : color("#FADB19") Side.
                   | isTagged("roof.top")    : color("#09DE1F") Top.
                   | all                     : color("#bbbbbb") Cut. }
           comp(e) { isTagged("EdgeTag")     : color("#FA9100") Bar }
           comp(v) { isTagged("VertexTag")   : color("#8D09DE") Ball }

Bar  --> s('1, 0.3, 0.3) center(yz) primitiveCube()
Ball --> s(0.6, 0.6, 0.6) center(xyz) primitiveSphere(8, 6)
"##
}

example! {
    /// "Each face now has both extrude and roof auto-tags."
    over_faces, "Geometry tagging, Face tag propagation", Shape::rectangle(16.0, 8.0),
    r##"Init --> roofGable(byHeight, 4) extrude(1)
         comp(f) { isTagged("roof.bottom") : color("#0399F5") Bottom.
                 | isTagged("roof.side")   : color("#FADB19") Side.
                 | isTagged("roof.top")    : color("#09DE1F") Top. }
"##; marks &[Mark::Lowered("Bottom")]
}

/// An example of edge and vertex tag propagation. The faces, edges and vertices of all pictures are marked alike.
macro_rules! propagation {
    ($(#[$doc:meta])* $name:ident, $title:literal, $start:expr, [$($ops:tt)*]) => {
        $(#[$doc])*
        pub mod $name {
            use super::*;

            cga::cga! {
                pub grammar Page;
                Init --> $($ops)* Visualize
                Visualize -->
                    comp(f) { geometry.hasTags("e.A", faces) : color("#09DE1F") FaceA.
                            | geometry.hasTags("e.B", faces) : color("#0399F5") FaceB.
                            | all                            : color("#dddddd") Face. }
                    comp(e) { geometry.hasTags("e.A", edges) : color("#09DE1F") EdgeA
                            | geometry.hasTags("e.B", edges) : color("#0399F5") EdgeB
                            | geometry.hasTags("v.A", edges) : color("#FA9100") UprightA
                            | geometry.hasTags("v.B", edges) : color("#8D09DE") UprightB }
                    comp(v) { geometry.hasTags("v.A", vertices) : color("#FA9100") VertexA
                            | geometry.hasTags("v.B", vertices) : color("#8D09DE") VertexB }
                EdgeA    --> s(^1, 0.3, 0.3) center(yz) primitiveCube()
                EdgeB    --> s(^1, 0.3, 0.3) center(yz) primitiveCube()
                UprightA --> s(^1, 0.3, 0.3) center(yz) primitiveCube()
                UprightB --> s(^1, 0.3, 0.3) center(yz) primitiveCube()
                VertexA  --> s(0.9, 0.9, 0.9) center(xyz) primitiveSphere(8, 6)
                VertexB  --> s(0.9, 0.9, 0.9) center(xyz) primitiveSphere(8, 6)
            }

            pub const EXAMPLE: crate::pages::example::Example = crate::pages::example::Example {
                title: $title,
                rules: concat!("Init --> ", stringify!($($ops)*), " Visualize\n"),
                start: || $start,
                run: |shape, settings| Page::default().generate_with(shape, settings),
                // From the side of the concave corner.
                marks: &[crate::pages::example::Mark::From(57.0, 30.0)],
                pieces: None,
            };
        }
    };
}

pub(crate) use propagation;

propagation! {
    /// Two quads, one subtracted from the other.
    corner, "Geometry tagging, the set-up of propagation", quarter_cut_out(), []
}

propagation! {
    /// "Example extrude operation."
    extruded, "Geometry tagging, propagation: extrude", quarter_cut_out(), [extrude(4)]
}

propagation! {
    /// "Example offset operation."
    inset, "Geometry tagging, propagation: offset", quarter_cut_out(), [offset(-2)]
}

propagation! {
    /// "Example taper operation."
    tapered, "Geometry tagging, propagation: taper", quarter_cut_out(), [taper(4)]
}

propagation! {
    /// A hip roof: a face over each edge, and hips from the vertices.
    corner_roof, "Geometry tagging, propagation: roofHip", quarter_cut_out(), [roofHip(35)]
}

propagation! {
    /// An envelope: upright sides and slopes over each edge.
    corner_envelope, "Geometry tagging, propagation: envelope", quarter_cut_out(),
    [envelope(normal, 5, 2, 45, 2, 45, 2, 45, 2, 45)]
}

example! {
    /// "The string edge attributes are set as tags."
    attributes, "setTagsFromEdgeAttrs operation, Setting edge tags", quadrilateral(),
    r##"Lot --> setTagsFromEdgeAttrs() [ color("#eeeeee") Ground. ] Marked

Marked --> comp(e) { isTagged("edgeattr.orientations.front") : color("#09DE1F") Bar
                   | isTagged("edgeattr.orientations.side")  : color("#0000E0") Bar }
Bar --> s('1, 0.3, 0.3) center(yz) primitiveCube()
"##; marks &[Mark::FromAbove]
}

example! {
    /// "If the geometry has been modified, the attribute value is sampled for each face edge."
    sampled, "setTagsFromEdgeAttrs operation, sampling", quadrilateral(),
    r##"Lot --> [ color("#dddddd") Ground. ] s(9.5, 0, 9.5) center(xz) primitiveDisk(12)
        setTagsFromEdgeAttrs() [ t(0, 0.01, 0) color("#ffffff") Disk. ] Marked

Marked --> comp(e) { isTagged("edgeattr.orientations.front") : color("#09DE1F") Bar
                   | isTagged("edgeattr.orientations.side")  : color("#0000E0") Bar }
Bar --> s('1, 0.3, 0.3) center(yz) primitiveCube()
"##; marks &[Mark::FromAbove]
}

example! {
    /// Edges that were set back also have the tags of their new places.
    kept_in_shape, "setTagsFromEdgeAttrs operation, Setback and edge tags: the shape", quadrilateral(),
    r##"Lot --> setTagsFromEdgeAttrs()
        setback(4) { isTagged("edgeattr.orientations.front") : color("#ffffff") Strip
                   | remainder                               : color("#cccccc") Rest. }
Strip --> [ Ground. ] Marked

Marked --> comp(e) { isTagged("edgeattr.orientations.front") : color("#09DE1F") Bar
                   | isTagged("edgeattr.orientations.side")  : color("#0000E0") Bar }
Bar --> s('1, 0.3, 0.3) center(yz) primitiveCube()
"##; marks &[Mark::FromAbove]
}

example! {
    /// They are in the remainder as well.
    kept_in_remainder, "setTagsFromEdgeAttrs operation, Setback and edge tags: the remainder", quadrilateral(),
    r##"Lot --> setTagsFromEdgeAttrs()
        setback(4) { isTagged("edgeattr.orientations.front") : color("#cccccc") Strip.
                   | remainder                               : color("#ffffff") Rest }
Rest --> [ Ground. ] Marked

Marked --> comp(e) { isTagged("edgeattr.orientations.front") : color("#09DE1F") Bar
                   | isTagged("edgeattr.orientations.side")  : color("#0000E0") Bar }
Bar --> s('1, 0.3, 0.3) center(yz) primitiveCube()
"##; marks &[Mark::FromAbove]
}

example! {
    /// "Sampling on faces"
    walls, "edgeAttr functions, Sampling on faces", colours(),
    r##"Lot --> [ color("#dddddd") Ground. ]
        s(10, 10, 10) center(xz) primitiveCube()
        comp(f) { side : color(edgeAttr.getString("colors")) Wall. }
"##
}

example! {
    /// "Sampling on edges"
    poles, "edgeAttr functions, Sampling on edges", colours(),
    r##"Lot --> [ color("#dddddd") Ground. ]
        s(10, 8, 10) center(xz) primitiveCylinder(22)
        comp(e) { vertical : color(edgeAttr.getString("colors")) s('1, 0.3, 1) center(y) primitiveCube() Pole. }
"##
}
