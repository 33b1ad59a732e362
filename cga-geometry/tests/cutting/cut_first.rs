//! The first face and the first edge of parts.

use std::sync::Arc;

use crate::cut_support::{even, own};
use cga_geometry::Axis;
use cga_geometry::cut::{self, Plane};
use cga_geometry::glam::{DAffine3, DVec2, DVec3};
use cga_geometry::mesh::join::join;
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder};

/// An L with a courtyard, seen from above: counter-clockwise, then the hole clockwise.
const OUTLINE: [(f64, f64); 6] = [(0.0, 0.0), (0.0, 9.0), (5.0, 9.0), (5.0, 5.0), (9.0, 5.0), (9.0, 0.0)];
const HOLE: [(f64, f64); 4] = [(1.0, 1.0), (4.0, 1.0), (4.0, 4.0), (1.0, 4.0)];

#[derive(Clone, Copy, Debug, PartialEq)]
enum First {
    Top,
    Bottom,
    Side(usize),
}

/// A building with the given first face, and the edge with the given index as first edge of its faces. Texture
/// coordinates encode the positions of their corners.
fn building(first: First, edge: usize, triangles: bool) -> Arc<Mesh> {
    let ring =
        |points: &[(f64, f64)], y: f64| -> Vec<DVec3> { points.iter().map(|&(x, z)| DVec3::new(x, y, z)).collect() };
    let mut faces: Vec<(First, Vec<Vec<DVec3>>)> = Vec::new();
    let turned = |mut list: Vec<DVec3>, by: usize| {
        let by = by % list.len();
        list.rotate_left(by);
        list
    };
    for (number, points) in [&OUTLINE[..], &HOLE[..]].into_iter().enumerate() {
        for i in 0..points.len() {
            let (a, b) = (points[i], points[(i + 1) % points.len()]);
            let at = |(x, z): (f64, f64), y: f64| DVec3::new(x, y, z);
            let side = vec![at(a, 0.0), at(b, 0.0), at(b, 7.0), at(a, 7.0)];
            faces.push((First::Side(10 * number + i), vec![side]));
        }
    }
    let reversed = |mut list: Vec<DVec3>| {
        list.reverse();
        list
    };
    faces.push((First::Top, vec![turned(ring(&OUTLINE, 7.0), edge), ring(&HOLE, 7.0)]));
    faces.push((First::Bottom, vec![turned(reversed(ring(&OUTLINE, 0.0)), edge), reversed(ring(&HOLE, 0.0))]));
    let at = faces.iter().position(|(name, _)| *name == first).unwrap();
    faces[..=at].rotate_right(1);
    let mut builder = MeshBuilder::new();
    for (_, rings) in &faces {
        let indices: Vec<Vec<u32>> =
            rings.iter().map(|ring| ring.iter().map(|&p| builder.point(p.to_array())).collect()).collect();
        if triangles && rings.len() == 1 {
            for i in 1..indices[0].len() - 1 {
                builder.face(&[indices[0][0], indices[0][i], indices[0][i + 1]], &[], FaceTag::PLAIN);
                builder.uvs(&[rings[0][0], rings[0][i], rings[0][i + 1]].map(uv));
            }
        } else {
            let holes: Vec<&[u32]> = indices[1..].iter().map(Vec::as_slice).collect();
            builder.face(&indices[0], &holes, FaceTag::PLAIN);
            builder.uvs(&rings.iter().flatten().map(|&p| uv(p)).collect::<Vec<_>>());
        }
    }
    Arc::new(builder.build().unwrap())
}

fn uv(p: DVec3) -> DVec2 {
    DVec2::new(p.x + 2.0 * p.y, p.z - 3.0 * p.y)
}

/// The first edge of the first face.
fn first_edge(mesh: &Mesh) -> [DVec3; 2] {
    [0, 1].map(|i| mesh.points()[mesh.corners()[i] as usize])
}

/// Checks the start of a part: its first face looks in the direction of the whole's first face, and so does its first
/// edge.
fn begins_alike(part: &Mesh, whole: &Mesh, what: &str) {
    let looks = |mesh: &Mesh| mesh.face(0).normal();
    assert!((looks(part) - looks(whole)).length() < 1e-9, "{what}: looks along {}", looks(part));
    let along = |[a, b]: [DVec3; 2]| (b - a).normalize();
    let [mine, its] = [part, whole].map(|mesh| along(first_edge(mesh)));
    assert!((mine - its).length() < 1e-9, "{what}: begins along {mine}, not {its}");
}

#[test]
fn every_storey_begins_with_a_face_like_the_first() {
    for first in [First::Top, First::Bottom] {
        for edge in 0..6 {
            for triangles in [false, true] {
                let mesh = building(first, edge, triangles);
                let cut = cut::slabs(&mesh, Axis::Y, &[1.0, 3.0, 4.5]);
                for (slab, part) in cut.parts.iter().flatten().enumerate() {
                    let what = format!("{first:?}, edge {edge}, storey {slab}");
                    begins_alike(part, &mesh, &what);
                    // The edge is on the same wall, and covers it if the wall is one face.
                    let flat = |mesh: &Mesh| first_edge(mesh).map(|p| p.with_y(0.0));
                    let ([a, b], [c, d]) = (flat(part), flat(&mesh));
                    let off = |p: DVec3| (p - c).cross((d - c).normalize()).length();
                    assert!(off(a).max(off(b)) < 1e-9, "{what}: {a} {b}, not along {c} {d}");
                    assert!(triangles || [a, b] == [c, d], "{what}: {a} {b}, not {c} {d}");
                    assert_eq!(part.face(0).loops().count(), 2, "{what}");
                }
            }
        }
    }
}

#[test]
fn slices_away_from_the_first_wall_begin_with_their_cap() {
    // The first face looks along -x, and its first edge is on the ground. Slices along x: the far ones contain none
    // of it.
    let mesh = building(First::Side(0), 0, false);
    assert_eq!(mesh.face(0).normal(), DVec3::NEG_X);
    let cut = cut::slabs(&mesh, Axis::X, &[2.0, 4.5, 7.0]);
    for (slice, part) in cut.parts.iter().flatten().enumerate() {
        begins_alike(part, &mesh, &format!("slice {slice}"));
        let [a, b] = first_edge(part);
        assert!(a.y == 0.0 && b.y == 0.0, "slice {slice}");
    }
    // Cuts by a general plane give the same.
    let plane = Plane { point: DVec3::new(4.5, 0.0, 0.0), normal: DVec3::X };
    let halves = cut::halves(&mesh, &plane, 0.0);
    halves.parts.iter().flatten().for_each(|half| begins_alike(half, &mesh, "half"));
}

#[test]
fn a_cap_begins_alike_whatever_other_planes_there_are() {
    // A tower beside the building, which a second plane cuts: the part before it, and its cap, are the same.
    let house = building(First::Side(1), 0, false);
    let tower = cga_geometry::primitive::cube().map(&DAffine3::from_translation(DVec3::X * 20.0));
    let [both, house] = [Arc::new(join([&*house, &tower].into_iter())), house];
    for plane in [0.5, 2.0, 4.5] {
        let alone = cut::slabs(&house, Axis::X, &[plane]);
        for more in [vec![plane], vec![plane, 12.0], vec![plane, 20.5], vec![-1.0, plane, 15.0, 20.2, 20.4]] {
            let low = usize::from(more[0] < 0.0);
            let parts = cut::slabs(&both, Axis::X, &more).parts;
            assert_eq!(parts[low].as_ref().unwrap().corners(), alone.parts[0].as_ref().unwrap().corners(), "{more:?}");
        }
    }
}

#[test]
fn nothing_else_changes_its_place() {
    for first in [First::Top, First::Bottom, First::Side(0), First::Side(3), First::Side(10)] {
        for (edge, triangles) in [(0, false), (3, true)] {
            let mesh = building(first, edge, triangles);
            for axis in [Axis::X, Axis::Y, Axis::Z] {
                for planes in [even(&mesh, axis, 3), even(&mesh, axis, 20), own(&mesh, axis, 3)] {
                    let cut = cut::slabs(&mesh, axis, &planes);
                    for part in cut.parts.iter().flatten() {
                        let what = format!("{first:?}, {edge}, {triangles}, across {axis:?} at {planes:?}");
                        assert_eq!(part.check(), [], "{what}");
                        assert!(part.is_closed(), "{what}");
                        // Texture coordinates stay with their corners, and caps have their own tag.
                        let mut from_source = Vec::new();
                        for (number, face) in part.faces().enumerate() {
                            let cap = face.tag() == FaceTag::CAP;
                            for corner in face.loop_ranges().flatten() {
                                let p = part.points()[part.corners()[corner] as usize];
                                assert!(cap || (part.uvs()[corner] - uv(p)).length() < 1e-12, "{what}");
                            }
                            if !cap {
                                from_source.push(source_of(&mesh, part, number));
                            }
                        }
                        assert!(from_source.is_sorted(), "{what}: {from_source:?}");
                        // A cap comes first only if the part contains nothing of the first face.
                        let has_first = from_source.first() == Some(&0);
                        assert!(has_first == (part.face(0).tag() != FaceTag::CAP), "{what}");
                    }
                }
            }
        }
    }
}

/// The face of the whole that contains a face of a part.
fn source_of(mesh: &Mesh, part: &Mesh, face: usize) -> usize {
    let face = part.face(face);
    let first = face.loops().next().unwrap();
    let middle = first.iter().map(|&p| part.points()[p as usize]).sum::<DVec3>() / first.len() as f64;
    let plane = |of: usize| {
        let source = mesh.face(of);
        let on = mesh.points()[source.loops().next().unwrap()[0] as usize];
        (source.normal() - face.normal()).length() < 1e-9 && (middle - on).dot(source.normal()).abs() < 1e-9
    };
    let holds = |of: usize| {
        // By area: if the face contains the middle, the triangles from the middle to the edges add up to the face.
        let source = mesh.face(of);
        let ring = source.loops().next().unwrap();
        let at = |i: usize| mesh.points()[ring[i % ring.len()] as usize];
        (0..ring.len()).all(|i| (at(i + 1) - at(i)).cross(middle - at(i)).dot(source.normal()) > -1e-9)
    };
    (0..mesh.face_count()).find(|&of| plane(of) && (mesh.face(of).loops().count() > 1 || holds(of))).unwrap()
}
