use glam::{DMat3, DVec3};

use super::{offset as offset_or_refuse, *};
use crate::mesh::{FaceTag, MeshBuilder, TagSet};
use crate::primitive::cube;

/// Roughly the outline of the reference's pictures: wide, with a notch from above.
const NOTCHED: [(f64, f64); 9] =
    [(0.0, 0.0), (6.0, -2.5), (12.0, 0.0), (13.0, 5.0), (9.0, 9.0), (6.5, 8.0), (8.0, 4.0), (5.5, 3.0), (-2.0, 7.0)];

/// Offsets faces that can all be moved.
fn offset(mesh: &Mesh, distance: f64, keep: OffsetFaces) -> Mesh {
    let (made, refused) = offset_or_refuse(mesh, distance, keep);
    assert_eq!(refused, []);
    made
}

fn ring(points: &[(f64, f64)]) -> Vec<DVec3> {
    points.iter().map(|&(x, y)| DVec3::new(x, 0.0, -y)).collect()
}

fn lot(points: &[(f64, f64)], holes: &[&[(f64, f64)]]) -> Mesh {
    Mesh::from_polygon(&ring(points), &holes.iter().map(|hole| ring(hole)).collect::<Vec<_>>()).unwrap()
}

fn courtyard() -> Mesh {
    lot(
        &[(0.0, 0.0), (10.0, 0.0), (10.0, 7.0), (0.0, 7.0)],
        &[&[(2.0, 2.0), (5.0, 2.0), (5.0, 5.0), (3.5, 3.0), (2.0, 5.0)]],
    )
}

/// For each edge of a face the number of faces that use it.
fn uses(mesh: &Mesh, face: &crate::mesh::FaceRef<'_>) -> Vec<usize> {
    let edges = |face: &crate::mesh::FaceRef<'_>| -> Vec<[u32; 2]> {
        let ring = |ring: &[u32]| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]).collect::<Vec<_>>();
        face.loops().flat_map(ring).collect()
    };
    let all: Vec<[u32; 2]> = mesh.faces().flat_map(|face| edges(&face)).collect();
    let same = |a: &[u32; 2], b: &[u32; 2]| a == b || [a[1], a[0]] == *b;
    edges(face).iter().map(|edge| all.iter().filter(|other| same(edge, other)).count()).collect()
}

fn signed_area(mesh: &Mesh) -> f64 {
    mesh.faces().map(|face| face.area() * face.normal().y).sum()
}

#[test]
fn first_edges_are_those_of_the_pictures() {
    let mesh = lot(&NOTCHED, &[]);
    let at = |mesh: &Mesh, face: usize, corner: usize| mesh.points()[mesh.face(face).outer()[corner] as usize];
    let along = |mesh: &Mesh, face: usize| (at(mesh, face, 1) - at(mesh, face, 0)).normalize();
    let edges: Vec<[DVec3; 2]> = (0..9).map(|i| [i, (i + 1) % 9].map(|i| ring(&NOTCHED)[i])).collect();
    let inwards = offset(&mesh, -1.0, OffsetFaces::All);
    let outwards = offset(&mesh, 1.0, OffsetFaces::All);
    assert_eq!((inwards.face_count(), outwards.face_count()), (10, 10));
    for made in [&inwards, &outwards] {
        assert_eq!(made.check(), []);
        assert!(along(made, 0).dot((edges[0][1] - edges[0][0]).normalize()) > 1.0 - 1e-12);
        assert_eq!(made.face(0).normal(), DVec3::Y);
    }
    for (i, &[a, b]) in edges.iter().enumerate() {
        // Inwards, border faces look up and begin with the moved edge, in the opposite direction of the old one.
        assert!(inwards.face(i + 1).normal().y > 0.999);
        assert!(along(&inwards, i + 1).dot((b - a).normalize()) < -1.0 + 1e-12);
        assert!((at(&inwards, i + 1, 0) - b).length() > 0.9);
        // Outwards they look down and begin with the old edge.
        assert!(outwards.face(i + 1).normal().y < -0.999);
        assert_eq!([at(&outwards, i + 1, 0), at(&outwards, i + 1, 1)], [a, b]);
    }
}

#[test]
fn inside_and_border_add_up_to_the_face() {
    for mesh in [lot(&NOTCHED, &[]), courtyard()] {
        for distance in [-9.0, -3.0, -1.5, -1.0, -0.5, -1e-3, 1e-3, 0.5, 1.0, 1.5, 3.0, 40.0] {
            let all = offset(&mesh, distance, OffsetFaces::All);
            assert_eq!(all.check(), []);
            assert!((signed_area(&all) - mesh.area()).abs() < 1e-9 * all.area(), "{distance}");
            let inside = offset(&mesh, distance, OffsetFaces::Inside);
            let border = offset(&mesh, distance, OffsetFaces::Border);
            assert_eq!(inside.face_count() + border.face_count(), all.face_count());
            assert!(inside.faces().all(|face| face.normal() == DVec3::Y));
            assert!(border.faces().all(|face| face.normal().y * distance < 0.0));
            assert_eq!(inside.check().len() + border.check().len(), 0);
        }
    }
}

/// `inside` is the moved polygon and `border` its rim, by the edges that faces share.
#[test]
fn faces_at_the_border_are_told_by_their_edges() {
    for mesh in [lot(&NOTCHED, &[]), courtyard()] {
        for distance in [-1.5, -1.0, -0.5, 0.5, 1.0, 2.0] {
            let inside = offset(&mesh, distance, OffsetFaces::Inside).face_count();
            let made = offset(&mesh, distance, OffsetFaces::All);
            for face in made.faces() {
                let at_border = uses(&made, &face).contains(&1);
                assert_eq!(at_border, inside <= face.index(), "{distance}, face {}", face.index());
            }
        }
    }
}

#[test]
fn faces_share_points_with_their_own_parts_only() {
    let made = offset(&cube(), -0.25, OffsetFaces::All);
    assert_eq!((made.face_count(), made.points().len()), (6 * 5, 6 * 8));
    assert_eq!(made.check(), []);
    assert!((made.area() - 6.0).abs() < 1e-12);
    let inside = made.faces().filter(|face| !uses(&made, face).contains(&1));
    assert_eq!(inside.map(|face| face.area()).collect::<Vec<_>>(), [0.25; 6]);
}

#[test]
fn a_gap_that_closes_makes_a_hole() {
    let gap =
        [(0.0, 0.0), (10.0, 0.0), (10.0, 8.0), (5.5, 8.0), (5.5, 6.5), (8.0, 6.5), (8.0, 2.0), (2.0, 2.0), (2.0, 6.5)];
    let gap = [&gap[..], &[(4.5, 6.5), (4.5, 8.0), (0.0, 8.0)]].concat();
    let holes = |distance: f64| {
        let made = offset(&lot(&gap, &[]), distance, OffsetFaces::Inside);
        made.faces().map(|face| face.holes().len()).collect::<Vec<_>>()
    };
    assert_eq!([0.4, 1.0, 2.0, 2.5].map(holes), [vec![0], vec![1], vec![1], vec![0]]);
    let ring = offset(&lot(&gap, &[]), 1.0, OffsetFaces::Inside);
    assert!((ring.area() - (12.0 * 10.0 - 4.0 * 2.5)).abs() < 1e-9);
}

#[test]
fn what_faces_and_corners_carry_goes_with_them() {
    let corners = [(0.0, 0.0), (6.0, 0.0), (6.0, 5.0), (3.0, 2.5), (0.0, 5.0)];
    let tag = FaceTag { group: 1, tags: 0, cap: true, ..FaceTag::PLAIN };
    let map = |p: DVec3, set: usize| DVec2::new(2.0 * p.x + p.z + 1.0, 0.25 * p.z - 3.0) * (set + 1) as f64;
    let mut builder = MeshBuilder::new();
    builder.groups(["a".to_owned(), "b".to_owned()]);
    builder.tag_sets([TagSet::new(["roof"])]);
    let points: Vec<u32> = ring(&corners).into_iter().map(|p| builder.point(p)).collect();
    builder.face(&points, &[], tag);
    for set in [0, 3] {
        builder.uv_set(set, &ring(&corners).iter().map(|&p| map(p, set)).collect::<Vec<_>>());
    }
    builder.normals(&[DVec3::Y; 5]);
    let mesh = builder.build().unwrap();
    for distance in [-0.5, -2.0, 0.5, 2.0] {
        let made = offset(&mesh, distance, OffsetFaces::All);
        assert_eq!((made.groups(), made.tag_sets(), made.check()), (mesh.groups(), mesh.tag_sets(), vec![]));
        for face in made.faces() {
            assert_eq!(face.tag(), tag);
            for corner in face.corner_range() {
                assert!((made.normals()[corner] - face.normal()).length() < 1e-12);
                for set in [0, 3] {
                    let p = made.points()[made.corners()[corner] as usize];
                    assert!((made.uv_set(set)[corner] - map(p, set)).length() < 1e-12);
                }
            }
        }
    }
}

/// Each face is moved in its own plane, at any position.
#[test]
fn turned_faces_give_turned_faces() {
    let mesh = courtyard();
    let turn = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), 0.9);
    let there = glam::DAffine3 { matrix3: turn, translation: DVec3::new(300.0, -20.0, 7000.0) };
    for distance in [-1.5, -0.5, 0.5, 2.0] {
        let a = offset(&mesh, distance, OffsetFaces::All).map(&there);
        let b = offset(&mesh.map(&there), distance, OffsetFaces::All);
        assert_eq!((a.corners(), b.check()), (b.corners(), vec![]));
        assert!(a.points().iter().zip(b.points()).all(|(p, q)| p.distance(*q) < 1e-9));
    }
}

fn faces(all: &[&[[f64; 3]]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    for face in all {
        let points: Vec<u32> = face.iter().map(|&p| builder.point(p)).collect();
        builder.face(&points, &[], FaceTag::PLAIN);
    }
    builder.build().unwrap()
}

const BOW: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [4.0, 0.0, -4.0], [4.0, 0.0, 0.0], [0.0, 0.0, -3.0]];
const LINE: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [8.0, 0.0, 0.0]];

fn bent(by: f64) -> [[f64; 3]; 4] {
    [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, by, -4.0], [0.0, 0.0, -4.0]]
}

#[test]
fn faces_that_cannot_be_moved_stay_among_others_that_can() {
    let mesh = faces(&[&BOW, &bent(0.0), &LINE, &bent(0.1)]);
    let at = |mesh: &Mesh, face: usize| mesh.face(face).outline().collect::<Vec<_>>();
    for (keep, counts) in [(OffsetFaces::All, [5, 5]), (OffsetFaces::Inside, [1, 1]), (OffsetFaces::Border, [4, 4])] {
        for distance in [-0.5, 0.5] {
            let (made, refused) = offset_or_refuse(&mesh, distance, keep);
            assert_eq!(refused, [(0, OffsetError::Tangled), (2, OffsetError::NoNormal)]);
            let line = 1 + counts[0];
            assert_eq!(made.face_count(), line + 1 + counts[1]);
            assert_eq!((at(&made, 0), at(&made, line)), (at(&mesh, 0), at(&mesh, 2)));
        }
    }
}

/// For any deviation of a corner, old corners stay bit for bit, parts share their points, and all heights are within
/// the range of the face.
#[test]
fn a_bent_face_stays_as_bent() {
    for by in [1e-12, 1e-8, 1e-3, 0.1, 1.0] {
        let mesh = faces(&[&bent(by)]);
        let (face, flat) = (mesh.face(0), faces(&[&bent(0.0)]));
        let from = face.outline().next().unwrap();
        let heights: Vec<f64> = face.outline().map(|p| (p - from).dot(face.normal())).collect();
        let (low, high) = heights.iter().fold((0.0f64, 0.0f64), |(low, high), &h| (low.min(h), high.max(h)));
        for distance in [-3.0, -1.0, -1e-3, 1e-3, 1.0, 50.0] {
            let made = offset(&mesh, distance, OffsetFaces::All);
            let plain = offset(&flat, distance, OffsetFaces::All);
            assert_eq!((made.corners(), made.face_count()), (plain.corners(), plain.face_count()));
            let is_new = |p: &&DVec3| !face.outline().any(|q| q == **p);
            assert_eq!(made.points().iter().filter(|p| !is_new(p)).count(), 4);
            let slack = 1e-9 * (1.0 + distance.abs());
            for (p, q) in made.points().iter().zip(plain.points()) {
                let height = (*p - from).dot(face.normal());
                assert!((low - slack..=high + slack).contains(&height), "{by}, {distance}: {height}");
                assert!(p.distance(*q) <= 2.0 * by * (1.0 + distance.abs()) + slack, "{by}, {distance}: {p} {q}");
            }
            // The signed areas along the normal add up as for planar faces.
            let sum: DVec3 = made.faces().map(|face| face.area_vector()).sum();
            let along = |v: DVec3| v.dot(face.normal());
            assert!((along(sum) - along(face.area_vector())).abs() < 1e-9 * (1.0 + distance * distance));
        }
        // A moved corner is close to its own height.
        let made = offset(&mesh, -1e-6, OffsetFaces::Inside);
        assert!(made.face(0).outline().zip(face.outline()).all(|(p, q)| p.distance(q) < 1e-5));
    }
}

/// A strip ends on its neighbour at a corner of 45 degrees, and on the bisector at a blunter one. Turned outlines are rounded.
#[test]
fn rounding_does_not_decide_at_corners_of_45_degrees() {
    let outline = [(0.0, 0.0), (6.0, 0.0), (8.0, 2.0), (8.0, 6.0), (0.0, 6.0)];
    for degrees in 0..90 {
        let (sin, cos) = libm::sincos(f64::from(degrees).to_radians());
        let turned = outline.map(|(x, y): (f64, f64)| (cos * x - sin * y + 17.3, sin * x + cos * y));
        let mesh = lot(&turned, &[]);
        let rest = to_area::Rest::of(&mesh.face(0), &[&[1.0, 0.0, 0.0, 0.0, 0.0]], |_| true);
        assert!((rest.area - (46.0 - 6.5)).abs() < 1e-9, "{degrees}: {}", rest.area);
    }
}
