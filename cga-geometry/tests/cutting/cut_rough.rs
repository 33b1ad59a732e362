//! Faces that are in a cut plane except for rounding, and meshes of any size.

use std::sync::Arc;

use crate::cut_support::{AXES, Rng, closed_by_position, even, own, prism, ring, square, turned};
use cga_geometry::Axis;
use cga_geometry::cut::{Plane, Slabs, halves, slabs};
use cga_geometry::glam::{DAffine3, DQuat, DVec2, DVec3, EulerRot};
use cga_geometry::mesh::{FaceTag, Flaw, Mesh, MeshBuilder};
use cga_geometry::primitive;

/// The mesh with other points. Each corner has its point as texture coordinates and normal, each face has a group.
fn with_points(mesh: &Mesh, place: impl Fn(DVec3) -> DVec3) -> Arc<Mesh> {
    let mut builder = MeshBuilder::new();
    let points: Vec<u32> = mesh.points().iter().map(|&point| builder.point(place(point))).collect();
    for face in mesh.faces() {
        let loops: Vec<Vec<u32>> = face.loops().map(|r| r.iter().map(|&c| points[c as usize]).collect()).collect();
        let holes: Vec<&[u32]> = loops[1..].iter().map(Vec::as_slice).collect();
        builder.face(&loops[0], &holes, FaceTag { group: face.index() as u32, ..FaceTag::PLAIN });
        let corners = || face.loops().flatten().map(|&point| place(mesh.points()[point as usize]));
        builder.uvs(&corners().map(|point| DVec2::new(point.x, point.z)).collect::<Vec<_>>());
        builder.normals(&vec![face.normal(); face.corner_count()]);
    }
    builder.groups((0..mesh.face_count()).map(|face| face.to_string()).collect::<Vec<_>>());
    Arc::new(builder.build().unwrap())
}

/// Checks that the parts contain each face's surface once, by its group, that they are closed, and that the
/// attributes of their corners are interpolated from the face.
#[track_caller]
fn check(what: &str, mesh: &Mesh, cut: &Slabs) {
    assert!(cut.open.is_empty(), "{what}");
    let mut areas = vec![0.0; mesh.face_count()];
    for part in cut.parts.iter().flatten() {
        let flaws = part.check();
        // A hole that is an ulp from its outline may seem to be outside.
        assert!(flaws.iter().all(|flaw| matches!(flaw, Flaw::Hole { .. })), "{what}: {flaws:?}");
        assert!(part.is_closed() && closed_by_position(part), "{what}");
        for face in part.faces().filter(|face| !face.tag().cap) {
            areas[face.tag().group as usize] += face.area();
            for corner in face.corner_range() {
                let point = part.points()[part.corners()[corner] as usize];
                assert!((part.uvs()[corner] - DVec2::new(point.x, point.z)).length() < 1e-12, "{what}");
                let normal = mesh.normals()[mesh.face(face.tag().group as usize).corner_range().start];
                assert!((part.normals()[corner] - normal).length() < 1e-12, "{what}");
            }
        }
    }
    for (face, area) in mesh.faces().zip(areas) {
        assert!((area - face.area()).abs() < 1e-11 * mesh.area(), "{what}: face {} has {area}", face.index());
    }
}

#[test]
fn a_face_in_a_plane_but_for_an_ulp_is_cut_once() {
    let hole = vec![(2.0, 2.0), (2.0, 4.0), (4.0, 4.0), (4.0, 2.0)];
    let plate = prism(&square(0.0, 0.0, 6.0), &[hole], 1.0);
    let (mut rng, high) = (Rng(1), 1.0 + f64::EPSILON);
    for turn in 0..400 {
        // The eight corners of the top are off by up to two ulps.
        let offs: Vec<f64> = (0..8).map(|_| rng.below(3) as f64 * f64::EPSILON).collect();
        let off = |point: DVec3| {
            offs[usize::from(point.x > 2.0) + 2 * usize::from(point.z < -2.0) + 4 * usize::from(point.x % 6.0 != 0.0)]
        };
        let mesh = with_points(&plate, |point| if point.y == 1.0 { point + DVec3::Y * off(point) } else { point });
        let cut = slabs(&mesh, Axis::Y, &[high]);
        check(&format!("{turn}"), &mesh, &cut);
        for (slab, part) in cut.parts.iter().enumerate() {
            let Some(part) = part else { continue };
            let again = slabs(part, Axis::Y, &[high]);
            assert!(Arc::ptr_eq(again.parts[slab].as_ref().unwrap(), part), "{turn}: cutting again changes it");
        }
        let plane = Plane { point: DVec3::Y * high, normal: DVec3::new(0.0, 1.0, 1e-17) };
        check(&format!("{turn} by a plane"), &mesh, &halves(&mesh, &plane, 0.0));
    }
}

#[test]
fn a_piece_of_a_rough_face_begins_with_its_first_edge() {
    let hole = vec![(2.0, 2.0), (2.0, 4.0), (4.0, 4.0), (4.0, 2.0)];
    let plate = prism(&square(0.0, 0.0, 6.0), &[hole], 1.0);
    let mesh =
        with_points(
            &plate,
            |point| if point == DVec3::new(6.0, 1.0, -6.0) { point + DVec3::Y * f64::EPSILON } else { point },
        );
    let top = mesh.faces().find(|face| face.normal().y > 0.5).unwrap();
    let edge = [0, 1].map(|i| mesh.points()[top.outer()[i] as usize]);
    let mut found = 0;
    for part in slabs(&mesh, Axis::Y, &[1.0]).parts.iter().flatten() {
        let pieces = part.faces().filter(|face| face.tag().group == top.index() as u32);
        for (number, piece) in pieces.enumerate() {
            let ring: Vec<DVec3> = piece.outer().iter().map(|&point| part.points()[point as usize]).collect();
            if edge.iter().all(|end| ring.contains(end)) {
                assert!(ring[..2] == edge && number == 0);
                found += 1;
            }
        }
    }
    assert_eq!(found, 1);
}

/// After turning, moving and turning back, faces are across axes except for rounding. Planes go through corners and
/// faces.
#[test]
fn bodies_that_were_turned_and_turned_back_keep_their_surface() {
    let holes =
        |at: &[f64]| at.iter().map(|&x| vec![(x, 1.0), (x, 2.0), (x + 1.0, 2.0), (x + 1.0, 1.0)]).collect::<Vec<_>>();
    let stairs = [(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0), (1.0, 3.0), (0.0, 3.0)];
    let bodies = [
        prism(&[(0.0, 0.0), (7.0, 0.0), (7.0, 3.0), (0.0, 3.0)], &holes(&[1.0, 3.0, 5.0]), 1.0),
        prism(&stairs, &[], 1.0),
        prism(&ring(11, |i| if i % 2 == 0 { 3.0 } else { 1.5 }), &[], 1.0),
    ];
    let mut rng = Rng(7);
    for turn in 0..600 {
        let mut part = || rng.unit() * 6.0 - 3.0;
        let turned = DQuat::from_euler(EulerRot::XYZ, part(), part(), part());
        let by = DVec3::new(part(), part(), part()) * 4.0;
        let back = turn % 2 == 0;
        let mesh = with_points(&bodies[rng.below(3)], |point| {
            let there = turned * point + by;
            if back { turned.inverse() * there } else { there }
        });
        if !mesh.check().is_empty() {
            continue;
        }
        if back {
            let axis = AXES[rng.below(3)];
            let mut planes: Vec<f64> =
                (0..1 + rng.below(4)).map(|_| mesh.points()[rng.below(mesh.points().len())][axis.index()]).collect();
            planes.sort_by(f64::total_cmp);
            planes.dedup();
            check(&format!("{turn}"), &mesh, &slabs(&mesh, axis, &planes));
        } else {
            let face = mesh.face(rng.below(mesh.face_count()));
            let plane = Plane { point: mesh.points()[face.outer()[0] as usize], normal: face.normal() };
            check(&format!("{turn}"), &mesh, &halves(&mesh, &plane, 0.0));
        }
    }
}

/// Scaling a mesh by a power of two scales its parts, to the bit.
#[test]
fn size_alone_changes_nothing() {
    let solids = [
        primitive::cube(),
        primitive::cube().reversed(),
        prism(&ring(10, |i| if i % 2 == 0 { 3.0 } else { 1.0 }), &[], 2.0),
        turned(&prism(&ring(9, |i| if i % 3 == 0 { 3.0 } else { 1.0 }), &[], 2.0)),
        prism(&square(0.0, 0.0, 8.0), &[square(2.0, 2.0, 3.0)], 2.0),
    ];
    for (number, solid) in solids.iter().enumerate() {
        for axis in AXES {
            for planes in [own(solid, axis, 9), even(solid, axis, 3)] {
                let expected = slabs(&Arc::new(solid.clone()), axis, &planes);
                for exponent in [-900, -560, -540, -500, 400, 520, 1000] {
                    let size = libm::exp2(f64::from(exponent));
                    let scaled = Arc::new(solid.map(&DAffine3::from_scale(DVec3::splat(size))));
                    let planes: Vec<f64> = planes.iter().map(|at| at * size).collect();
                    let found = slabs(&scaled, axis, &planes);
                    let what = format!("solid {number} of size 2^{exponent} across {axis:?} at {planes:?}");
                    assert_eq!(found.open.len(), expected.open.len(), "{what}");
                    for (a, b) in found.parts.iter().zip(&expected.parts) {
                        let points = |part: &Option<Arc<Mesh>>, size: f64| {
                            part.as_ref()
                                .map(|part| part.points().iter().map(|&point| point * size).collect::<Vec<_>>())
                        };
                        assert_eq!(points(a, 1.0), points(b, size), "{what}");
                        let loops = |part: &Option<Arc<Mesh>>| {
                            let loops = |part: &Arc<Mesh>| {
                                part.faces().map(|face| face.loops().map(<[u32]>::to_vec).collect()).collect()
                            };
                            part.as_ref().map(loops) as Option<Vec<Vec<Vec<u32>>>>
                        };
                        assert_eq!(loops(a), loops(b), "{what}");
                    }
                }
            }
        }
    }
}
