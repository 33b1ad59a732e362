//! Cuts by general planes.

use std::collections::HashSet;
use std::sync::Arc;

use crate::cut_support::{Rng, cells, check_triangles, closed_by_position, moved, prism, ring, square, torus, turned};
use cga_geometry::Axis;
use cga_geometry::cut::{Plane, Slabs, halves, slabs};
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use cga_geometry::primitive;
use glam::DVec3;

fn solids() -> Vec<(&'static str, Arc<Mesh>)> {
    let court = prism(&square(0.0, 0.0, 4.0), &[vec![(1.0, 1.0), (1.0, 3.0), (3.0, 3.0), (3.0, 1.0)]], 2.0);
    let mut rng = Rng(4);
    let spots: Vec<bool> = (0..64).map(|_| rng.below(2) == 0).collect();
    let list = vec![
        ("cube", primitive::cube()),
        ("cylinder", primitive::cylinder(48)),
        ("torus", torus(24, 12, 1.0, 0.4)),
        ("courtyard", court),
        ("star", prism(&ring(14, |i| if i % 2 == 0 { 3.0 } else { 1.0 }), &[], 1.0)),
        ("cells", cells(4, |x, y, z| spots[(x * 16 + y * 4 + z) as usize])),
        ("turned", turned(&torus(12, 8, 1.0, 0.3))),
        ("far", moved(&torus(12, 8, 1.0, 0.3), DVec3::new(1e4, -2e4, 3e4))),
    ];
    list.into_iter().map(|(name, mesh)| (name, Arc::new(mesh))).collect()
}

fn direction(rng: &mut Rng) -> DVec3 {
    let mut part = || rng.unit() * 2.0 - 1.0;
    DVec3::new(part(), part(), part())
}

fn caps(mesh: &Mesh) -> f64 {
    mesh.faces().filter(|face| face.tag().cap).map(|face| face.area()).sum()
}

#[track_caller]
fn check(name: &str, mesh: &Arc<Mesh>, plane: &Plane) -> Slabs {
    let what = format!("{name} by {plane:?}");
    let cut = halves(mesh, plane, 0.0);
    assert!(cut.open.is_empty() && cut.parts.len() == 2, "{what}");
    let scale = mesh.bounds().size().max_element();
    let own: HashSet<[u64; 3]> = mesh.points().iter().map(|point| point.to_array().map(f64::to_bits)).collect();
    let reach = mesh.bounds().low.abs().max(mesh.bounds().high.abs()).max_element();
    let (mut volume, mut old) = (0.0, 0.0);
    for (side, part) in cut.parts.iter().enumerate() {
        let Some(part) = part else { continue };
        assert!(part.check().is_empty(), "{what}: part {side} {:?}", part.check());
        assert!(part.is_closed() && closed_by_position(part), "{what}: part {side} is open");
        volume += part.volume();
        old += part.area() - caps(part);
        let sign = if side == 0 { 1.0 } else { -1.0 };
        for point in part.points() {
            let height = sign * (*point - plane.point).dot(plane.normal.normalize());
            assert!(height < 1e-14 * (reach + scale), "{what}: part {side} reaches beyond the plane by {height}");
            let kept = own.contains(&point.to_array().map(f64::to_bits));
            assert!(kept || height.abs() < 1e-14 * (reach + scale), "{what}: {point} is no point of the mesh");
        }
        check_triangles(&what, part, scale + reach);
    }
    let near = |a: f64, b: f64, of: f64| (a - b).abs() <= 1e-11 * of * (1.0 + reach / scale);
    assert!(near(volume, mesh.volume(), scale * scale * scale), "{what}: {volume}");
    assert!(near(old, mesh.area(), mesh.area()), "{what}: areas add up to {old}");
    if let [Some(below), Some(above)] = &cut.parts[..] {
        assert!(near(caps(below), caps(above), mesh.area()), "{what}: caps");
    }
    cut
}

#[test]
fn halves_are_closed_and_add_up() {
    let mut rng = Rng(1);
    for (name, mesh) in solids() {
        let (middle, size) = (mesh.bounds().low + mesh.bounds().size() * 0.5, mesh.bounds().size());
        let mut cut = 0;
        for _ in 0..60 {
            let plane = Plane { point: middle + direction(&mut rng) * size * 0.5, normal: direction(&mut rng) };
            cut += usize::from(check(name, &mesh, &plane).parts.iter().all(Option::is_some));
        }
        assert!(20 < cut, "{name}: {cut} of 60 planes met it");
    }
}

/// Reversing the plane swaps the halves.
#[test]
fn the_normal_says_what_is_above() {
    let mut rng = Rng(2);
    for (name, mesh) in solids() {
        let middle = mesh.bounds().low + mesh.bounds().size() * 0.5;
        let plane = Plane { point: middle, normal: direction(&mut rng) };
        let [one, other] =
            [plane, Plane { normal: plane.normal * -3.0, ..plane }].map(|plane| check(name, &mesh, &plane));
        for side in [0, 1] {
            let volumes = [&one.parts[side], &other.parts[1 - side]].map(|part| part.as_ref().unwrap().volume());
            assert!((volumes[0] - volumes[1]).abs() < 1e-9 * mesh.volume(), "{name}: {volumes:?}");
        }
    }
}

/// A plane across an axis gives the same result as a slab cut.
#[test]
fn a_plane_across_an_axis_is_a_slab_cut() {
    for (name, mesh) in solids() {
        for (axis, normal) in [(Axis::X, DVec3::X), (Axis::Y, DVec3::Y), (Axis::Z, DVec3::Z)] {
            let at = mesh.bounds().low + mesh.bounds().size() * 0.4321;
            let by_plane = check(name, &mesh, &Plane { point: at, normal });
            let by_axis = slabs(&mesh, axis, &[at[axis.index()]]);
            for (a, b) in by_plane.parts.iter().zip(&by_axis.parts) {
                let (a, b) = (a.as_ref().unwrap(), b.as_ref().unwrap());
                assert_eq!(a.face_count(), b.face_count(), "{name} {axis:?}");
                assert!((a.volume() - b.volume()).abs() < 1e-9 * mesh.volume(), "{name} {axis:?}");
                assert!((a.area() - b.area()).abs() < 1e-9 * mesh.area(), "{name} {axis:?}");
            }
        }
    }
}

/// Planes through edges and faces of a turned mesh miss them by rounding. A tolerance makes them count as hits.
#[test]
fn a_tolerance_makes_points_lie_in_the_plane_and_moves_none() {
    let mesh = Arc::new(turned(&cells(3, |x, y, z| (x + y + z) % 2 == 0 || y == 1)));
    let (mut rough, mut clean) = (0, 0);
    for face in mesh.faces() {
        let corner = mesh.points()[face.outer()[0] as usize];
        let plane = Plane { point: corner, normal: face.normal() };
        for (tolerance, count) in [(0.0, &mut rough), (1e-12, &mut clean)] {
            for part in halves(&mesh, &plane, tolerance).parts.iter().flatten() {
                assert!(part.check().is_empty() && part.is_closed());
                *count += part.points().len();
                let points: HashSet<[u64; 3]> = mesh.points().iter().map(|p| p.to_array().map(f64::to_bits)).collect();
                let all = part.points().iter().all(|p| points.contains(&p.to_array().map(f64::to_bits)));
                assert!(all || tolerance == 0.0, "cells are cut between each other, so no point is new");
            }
        }
    }
    assert!(clean < rough, "{clean} points, {rough} without tolerance");
}

/// A coordinate that both ends of an edge share is also the coordinate of its crossings, to the bit, so that later
/// cuts find it in the same plane.
#[test]
fn crossings_stay_in_the_boxes_of_their_edges() {
    let (mesh, mut rng) = (Arc::new(primitive::cube()), Rng(3));
    for _ in 0..1000 {
        let plane = Plane { point: direction(&mut rng).abs(), normal: direction(&mut rng) };
        for part in halves(&mesh, &plane, 0.0).parts.iter().flatten() {
            for point in part.points() {
                let on_edge = point.to_array().iter().filter(|&&at| at == 0.0 || at == 1.0).count() >= 2;
                assert!(on_edge && point.min_element() >= 0.0 && point.max_element() <= 1.0, "{point:?} {plane:?}");
            }
            let again = slabs(part, Axis::Y, &[1.0]).parts;
            assert!(again[1].is_none(), "{plane:?} leaves something above");
        }
    }
}

#[test]
fn cutting_again_with_a_tolerance_above_rounding_changes_nothing() {
    let mut rng = Rng(6);
    for (name, mesh) in solids() {
        let (middle, size) = (mesh.bounds().low + mesh.bounds().size() * 0.5, mesh.bounds().size());
        let reach = mesh.bounds().low.abs().max(mesh.bounds().high.abs()).max_element();
        for _ in 0..200 {
            let plane = Plane { point: middle + direction(&mut rng) * size * 0.5, normal: direction(&mut rng) };
            let tolerance = 1e-15 * (reach + size.max_element());
            for (side, part) in halves(&mesh, &plane, tolerance).parts.iter().enumerate() {
                let Some(part) = part else { continue };
                let again = halves(part, &plane, tolerance);
                let same = again.parts[side].as_ref().is_some_and(|same| Arc::ptr_eq(same, part));
                assert!(same && again.parts[1 - side].is_none(), "{name}: {plane:?}");
            }
        }
    }
}

#[test]
fn a_plane_that_misses_or_is_none_gives_the_same_mesh() {
    let mesh = Arc::new(primitive::cube());
    let same = |plane: Plane, side: usize| {
        let cut = halves(&mesh, &plane, 0.0);
        let part = cut.parts[side].as_ref().unwrap();
        assert!(Arc::ptr_eq(part, &mesh) && cut.parts[1 - side].is_none(), "{plane:?}");
    };
    same(Plane { point: DVec3::splat(2.0), normal: DVec3::ONE }, 0);
    same(Plane { point: DVec3::splat(-2.0), normal: DVec3::ONE }, 1);
    // The plane touches a corner, an edge, a face.
    same(Plane { point: DVec3::ONE, normal: DVec3::ONE }, 0);
    same(Plane { point: DVec3::ONE, normal: DVec3::new(1.0, 1.0, 0.0) }, 0);
    same(Plane { point: DVec3::ONE, normal: DVec3::Y }, 0);
    for normal in [DVec3::ZERO, DVec3::NAN, DVec3::INFINITY, DVec3::new(f64::NAN, 1.0, 0.0)] {
        same(Plane { point: DVec3::splat(0.5), normal }, 0);
    }
    for point in [DVec3::NAN, DVec3::splat(f64::INFINITY), DVec3::splat(1e308)] {
        same(Plane { point, normal: DVec3::ONE }, 0);
    }
    assert!(
        halves(&Arc::default(), &Plane { point: DVec3::ZERO, normal: DVec3::X }, 0.0).parts.iter().all(Option::is_none)
    );
}

#[test]
fn an_open_mesh_stays_open_and_says_where() {
    let mut builder = MeshBuilder::new();
    let corners =
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 1.0, 0.0]].map(|corner| builder.point(corner));
    builder.face(&corners, &[], FaceTag::PLAIN);
    let mesh = Arc::new(builder.build().unwrap());
    let cut = halves(&mesh, &Plane { point: DVec3::new(1.0, 0.5, 7.0), normal: DVec3::new(1.0, 1.0, 0.0) }, 0.0);
    let areas: Vec<f64> = cut.parts.iter().flatten().map(|part| part.area()).collect();
    assert!(areas.iter().all(|area| (area - 1.0).abs() < 1e-12), "{areas:?}");
    assert_eq!(cut.open.len(), 1);
    let ends = [DVec3::new(1.5, 0.0, 0.0), DVec3::new(0.5, 1.0, 0.0)];
    assert!(cut.open[0].points.iter().all(|point| ends.iter().any(|end| (*point - *end).length() < 1e-12)));
}

/// Attributes of corners are kept, and interpolated at crossings. Caps look along the plane's normal.
#[test]
fn normals_and_texture_coordinates_come_through() {
    let mut builder = MeshBuilder::new();
    let cube = primitive::cube();
    cube.points().iter().for_each(|point| {
        builder.point(*point);
    });
    for face in cube.faces() {
        builder.face(face.outer(), &[], FaceTag::PLAIN);
        builder.normals(&[face.normal(); 4]);
        builder.uvs(&face.outer().iter().map(|&point| cube.points()[point as usize].truncate()).collect::<Vec<_>>());
    }
    let mesh = Arc::new(builder.build().unwrap());
    let normal = DVec3::new(1.0, 2.0, 3.0).normalize();
    let cut = halves(&mesh, &Plane { point: DVec3::splat(0.5), normal }, 0.0);
    for (side, part) in cut.parts.iter().enumerate() {
        let part = part.as_ref().unwrap();
        for face in part.faces() {
            for corner in face.corner_range() {
                let point = part.points()[part.corners()[corner] as usize];
                if face.tag().cap {
                    let out = if side == 0 { normal } else { -normal };
                    assert!((part.normals()[corner] - out).length() < 1e-15 && (face.normal() - out).length() < 1e-12);
                } else {
                    assert!((part.uvs()[corner] - point.truncate()).length() < 1e-15);
                    assert_eq!(part.normals()[corner], face.normal().round());
                }
            }
        }
    }
}
