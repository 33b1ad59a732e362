//! Tags, materials and the values of corners in results.

use std::slice::from_ref;

use glam::{DVec2, DVec3};

use super::{BooleanOp, block, combine, combined};
use crate::mesh::{FaceTag, Mesh, MeshBuilder, TagSet};
use BooleanOp::{Intersect, Subtract, Unify, Union};

fn set(name: &str) -> TagSet {
    TagSet::new([name])
}

/// A square on the ground whose faces, edges and vertices have tags that begin with a name. Texture coordinates are positions
/// on the ground, and the normals are tilted.
fn square(low: f64, high: f64, name: &str) -> Mesh {
    let mut builder = MeshBuilder::new();
    let corners = [[low, high], [high, high], [high, low], [low, low]];
    let ring = corners.map(|[x, z]| builder.point([x, 0.0, z]));
    builder.face(&ring, &[], FaceTag { tags: 0, ..FaceTag::PLAIN });
    builder.uvs(&corners.map(|[x, z]| DVec2::new(x / 10.0, z)));
    builder.normals(&corners.map(|[x, _]| DVec3::new(x / 100.0, 1.0, 0.0).normalize()));
    builder.tag_sets([set(&format!("f.{name}"))]);
    for side in 0..4 {
        builder.edge_tags([ring[side], ring[(side + 1) % 4]], &set(&format!("e.{name}")));
        builder.vertex_tags(ring[side], &set(&format!("v.{name}")));
    }
    builder.build().unwrap()
}

fn names(set: &TagSet) -> String {
    set.names().iter().map(|name| name.to_string()).collect::<Vec<_>>().join(" ")
}

/// The tags of a face.
fn tags(mesh: &Mesh, face: usize) -> String {
    names(&mesh.tag_sets()[mesh.face(face).tag().tags as usize])
}

/// The names of all tagged edges with their lengths, sorted.
fn edges(mesh: &Mesh) -> Vec<(String, f64)> {
    let length = |ends: [u32; 2]| mesh.points()[ends[0] as usize].distance(mesh.points()[ends[1] as usize]);
    let mut list: Vec<(String, f64)> =
        mesh.subcomponent_tags.edges().map(|(ends, set)| (names(set), length(ends))).collect();
    list.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    list
}

fn count(mesh: &Mesh, name: &str) -> usize {
    mesh.subcomponent_tags.vertices().filter(|(_, set)| set.has(name)).count()
}

/// The picture of *Geometry tagging*, edge and vertex tag propagation: one square without another.
#[test]
fn a_square_without_another_has_the_tags_of_both_outlines() {
    let made = combined(Subtract, &square(0.0, 4.0, "A"), &square(2.0, 6.0, "B")).unwrap();
    let pairs =
        |list: &[(&str, f64)]| list.iter().map(|(name, length)| (name.to_string(), *length)).collect::<Vec<_>>();
    let outer = [("e.A", 2.0), ("e.A", 2.0), ("e.A", 4.0), ("e.A", 4.0)];
    let expected = pairs(&[("bool.cut e.B", 2.0), ("bool.cut e.B", 2.0)]).into_iter().chain(pairs(&outer));
    assert_eq!(edges(&made), expected.collect::<Vec<_>>());
    assert_eq!((count(&made, "v.A"), count(&made, "v.B"), made.points().len()), (3, 1, 6));
}

#[test]
fn where_areas_overlap_faces_have_the_tags_of_both() {
    let made = combined(Union, &square(0.0, 4.0, "A"), &square(2.0, 6.0, "B")).unwrap();
    assert_eq!(
        (0..3).map(|face| tags(&made, face)).collect::<Vec<_>>(),
        ["bool.A f.A", "bool.A bool.B f.A f.B", "bool.B f.B"]
    );
    assert_eq!(edges(&made).iter().filter(|(name, _)| name.starts_with("bool.cut")).count(), 4);
    // The edges that were cut before are so no longer.
    let again = combined(Intersect, &made, &square(-1.0, 1.0, "C")).unwrap();
    let cut: Vec<_> = edges(&again).into_iter().filter(|(name, _)| name.contains("bool")).collect();
    assert_eq!(cut.len(), 4, "{cut:?}");
    assert_eq!(tags(&again, 0), "bool.A bool.B f.A f.C");
    // `inline(unify)` gives no tags of its own and keeps all.
    let united = combine(Unify, [&[made.clone(), square(9.0, 10.0, "C")], &[]], 0.0).unwrap();
    assert_eq!(united.face_count(), 4);
    assert_eq!(edges(&united).len(), edges(&made).len() + 4);
    assert_eq!(tags(&united, 1), "bool.A bool.B f.A f.B");
}

#[test]
fn solids_are_cut_where_their_faces_meet() {
    let (a, b) = (block([0.0; 3], [4.0; 3]), block([2.0; 3], [6.0; 3]));
    for op in [Union, Subtract, Intersect] {
        let made = combined(op, &a, &b).unwrap();
        // A loop of six edges in three faces of each box.
        assert_eq!(edges(&made), vec![("bool.cut".to_owned(), 2.0); 6], "{op:?}");
    }
    assert!(combine(Unify, [&[a, b], &[]], 0.0).unwrap().subcomponent_tags.is_empty());
}

#[test]
fn corners_get_the_values_of_their_face_at_their_place() {
    let (a, b) = (square(0.0, 4.0, "A"), square(1.0, 6.0, "B"));
    for op in [Union, Subtract, Intersect] {
        for made in [combined(op, &a, &b).unwrap(), combined(op, &b, &a).unwrap()] {
            for (corner, point) in made.corners().iter().enumerate() {
                let place = made.points()[*point as usize];
                assert!(made.uvs()[corner].distance(DVec2::new(place.x / 10.0, place.z)) < 1e-12);
                let tilt = made.normals()[corner].x / made.normals()[corner].y;
                assert!((tilt - place.x / 100.0).abs() < 1e-4, "{tilt} at {place}");
            }
        }
    }
    // Turned faces have turned normals.
    let (outer, inner) = (block([0.0; 3], [4.0; 3]), block([1.0; 3], [2.0; 3]));
    let normals = inner.faces().flat_map(|face| vec![face.normal(); 4]).collect();
    let hollow = combined(Subtract, &outer, &Mesh { normals, ..inner }).unwrap();
    for face in hollow.faces() {
        assert!(face.corner_range().all(|corner| hollow.normals()[corner].distance(face.normal()) < 1e-12));
    }
}

#[test]
fn the_first_edge_and_the_order_of_faces_stay() {
    let a = block([0.0; 3], [4.0; 3]);
    let made = combined(Subtract, &a, &block([3.0, 3.0, 3.0], [5.0; 3])).unwrap();
    let ends = |mesh: &Mesh, face: usize| [0, 1].map(|i| mesh.points()[mesh.face(face).outer()[i] as usize]);
    for face in 0..6 {
        let ([a, b], [c, d]) = (ends(&a, face), ends(&made, face));
        assert!((b - a).normalize().distance((d - c).normalize()) < 1e-12, "{face}");
        assert!((c - a).cross(b - a).length() < 1e-12, "{face}");
    }
    assert_eq!(made.face_count(), 9);
    // Vertices keep their order, and new ones follow.
    assert_eq!(made.points()[..7], a.points().iter().copied().filter(|p| *p != DVec3::splat(4.0)).collect::<Vec<_>>());
}

#[test]
fn a_bent_face_that_nothing_divides_stays_one_face() {
    let mut builder = MeshBuilder::new();
    let at = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 1.0, 4.0], [0.0, 0.0, 4.0], [0.0, -2.0, 0.0]];
    let [a, b, c, d, below] = at.map(|point| builder.point(point));
    builder.face(&[a, d, c, b], &[], FaceTag::PLAIN);
    for [from, to] in [[a, b], [b, c], [c, d], [d, a]] {
        builder.face(&[from, to, below], &[], FaceTag::PLAIN);
    }
    let bent = builder.build().unwrap();
    let same = combine(Unify, [from_ref(&bent), &[]], 0.0).unwrap();
    assert!(same.corners() == bent.corners() && same.points() == bent.points());
    // A box that touches an edge of it divides two other faces.
    let other = combined(Union, &bent, &block([-1.0, -5.0, 1.0], [1.0, -0.2, 2.0])).unwrap();
    assert!(other.is_closed() && other.face(0).outer().len() == 4);
    // A box through it divides its triangles.
    let through = combined(Subtract, &bent, &block([1.0, -5.0, 1.0], [2.0, 5.0, 2.0])).unwrap();
    assert!(through.is_closed() && through.volume() < bent.volume());
}
