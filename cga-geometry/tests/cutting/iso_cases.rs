//! Cuts along lines of constant texture coordinate with known results.

use std::sync::Arc;

use crate::cut_support::*;
use crate::iso_support::*;
use cga_geometry::Axis;
use cga_geometry::cut::{iso_bands, slabs};
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder, TooManyCorners, UvAxis};
use glam::{DVec2, DVec3};

const MOST: usize = 1 << 24;

fn bands(mesh: &Mesh, axis: UvAxis, lines: &[f64]) -> Vec<Option<Arc<Mesh>>> {
    iso_bands(&Arc::new(mesh.clone()), 0, axis, lines, MOST).unwrap()
}

fn areas(bands: &[Option<Arc<Mesh>>]) -> Vec<f64> {
    bands.iter().map(|band| band.as_ref().map_or(0.0, |band| band.area())).collect()
}

/// A rectangle on the ground with coordinates from 0 to 1.
fn facade(width: f64, height: f64) -> Mesh {
    let mesh = Mesh::from_polygon(&polygon(&[(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]), &[]).unwrap();
    charted(&mesh, &[0], |_, _, p, _| DVec2::new(p.x / width, -p.z / height))
}

#[test]
fn a_facade_of_any_size_is_halved() {
    // u = 0.5, independent of the size.
    for width in [3.0, 10.0, 77.5] {
        assert_eq!(areas(&bands(&facade(width, 4.0), UvAxis::U, &[0.5])), [width * 2.0; 2]);
    }
}

#[test]
fn pieces_in_unit_space_have_their_metres() {
    // Pieces of 5, and the rest.
    let mesh = facade(23.0, 4.0);
    let extent = mesh.uv_extent(0, DVec3::ONE).unwrap();
    let lines = [5.0, 10.0, 15.0, 20.0].map(|metres| extent.at_metres(UvAxis::U, metres));
    for (area, expected) in areas(&bands(&mesh, UvAxis::U, &lines)).into_iter().zip([20.0, 20.0, 20.0, 20.0, 12.0]) {
        assert!((area - expected).abs() < 1e-12, "{area}");
    }
}

#[test]
fn a_street_has_a_band_across_in_every_period() {
    // About 3 m in every 23 m.
    let street = street(&[(0.0, 0.0), (30.0, 4.0), (50.0, 20.0), (92.0, 18.0)], 6.0);
    let extent = street.uv_extent(0, DVec3::ONE).unwrap();
    let length: f64 = [(30.0, 4.0), (20.0, 16.0), (42.0, -2.0)].iter().map(|(x, y): &(f64, f64)| x.hypot(*y)).sum();
    assert!((extent.metres.x - length).abs() < 1e-9, "{} {length}", extent.metres.x);
    let periods = extent.metres.x / 23.0;
    let period = extent.metres.x / periods.round();
    let starts = (0..periods.round() as usize).map(|i| i as f64 * period);
    let lines: Vec<f64> = starts
        .flat_map(|at| [at + period * 10.0 / 23.0, at + period * 13.0 / 23.0])
        .map(|at| extent.at_metres(UvAxis::U, at))
        .collect();
    let areas = areas(&bands(&street, UvAxis::U, &lines));
    for band in areas.iter().skip(1).step_by(2) {
        assert!((band / 6.0 / 3.0 - period / 23.0).abs() < 0.35, "{band}");
    }
    assert!((areas.iter().sum::<f64>() - street.area()).abs() < 1e-9);
}

#[test]
fn a_mesh_that_no_line_meets_is_the_same_mesh() {
    let mesh = Arc::new(facade(4.0, 4.0));
    let number = |lines: &[f64]| {
        let bands = iso_bands(&mesh, 0, UvAxis::U, lines, MOST).unwrap();
        assert_eq!(bands.len(), lines.len() + 1);
        let found: Vec<usize> = (0..bands.len()).filter(|&band| bands[band].is_some()).collect();
        assert!(found.len() == 1 && Arc::ptr_eq(bands[found[0]].as_ref().unwrap(), &mesh), "{lines:?}");
        found[0]
    };
    assert_eq!([number(&[]), number(&[-1.0, -0.5]), number(&[2.0, 3.0]), number(&[-1.0, 2.0])], [0, 2, 0, 1]);
    assert_eq!([number(&[0.0]), number(&[1.0]), number(&[0.0, 1.0]), number(&[-0.0])], [1, 0, 1, 1]);
    assert_eq!([number(&[f64::NEG_INFINITY]), number(&[f64::INFINITY]), number(&[f64::NAN])], [1, 0, 1]);
    // Without that set.
    let without = iso_bands(&mesh, 5, UvAxis::U, &[0.25, 0.5], MOST).unwrap();
    assert!(Arc::ptr_eq(without[0].as_ref().unwrap(), &mesh) && without[1..].iter().all(Option::is_none));
    assert!(iso_bands(&Arc::default(), 0, UvAxis::U, &[0.5], MOST).unwrap().iter().all(Option::is_none));
}

#[test]
fn lines_that_do_not_rise_cut_nothing() {
    let found = areas(&bands(&facade(4.0, 1.0), UvAxis::U, &[0.25, 0.25, f64::NAN, 0.125, 0.75]));
    assert_eq!(found, [1.0, 0.0, 0.0, 0.0, 2.0, 1.0]);
}

#[test]
fn a_face_of_one_coordinate_is_in_the_band_above_its_line() {
    let mesh = grid(4, 1, false, |i, j| DVec3::new(i as f64, 0.0, -(j as f64)));
    let mesh = charted(&mesh, &[0], |face, _, _, _| DVec2::splat([0.0, 1.0, 2.0, 2.0][face]));
    assert_eq!(areas(&bands(&mesh, UvAxis::U, &[1.0, 2.0, 3.0])), [1.0, 1.0, 2.0, 0.0]);
    assert_eq!(areas(&bands(&mesh, UvAxis::V, &[0.0, 1.5, 2.0])), [0.0, 2.0, 0.0, 2.0]);
}

#[test]
fn the_last_piece_does_not_vanish() {
    // 0.1 + 0.1 + … is not quite 1: the last line is just inside the surface, and makes a piece.
    let lines: Vec<f64> = (0..9)
        .scan(0.0, |at, _| {
            *at += 0.1;
            Some(*at)
        })
        .chain([1.0 - f64::EPSILON])
        .collect();
    let found = bands(&facade(10.0, 1.0), UvAxis::U, &lines);
    assert!(found.iter().all(Option::is_some));
    assert!((areas(&found).iter().sum::<f64>() - 10.0).abs() < 1e-12);
}

#[test]
fn a_cut_by_coordinates_is_a_cut_across_the_axis() {
    let mut rng = Rng(3);
    let comb = [
        (0.0, 0.0),
        (5.0, 0.0),
        (5.0, 4.0),
        (4.0, 4.0),
        (4.0, 1.0),
        (3.0, 1.0),
        (3.0, 4.0),
        (2.0, 1.0),
        (1.0, 4.0),
        (0.0, 4.0),
    ];
    let windows: Vec<Vec<DVec3>> = (0..4).map(|i| polygon(&square(f64::from(i) + 0.25, 0.25, 0.5))).collect();
    let flat = grid(5, 4, false, |i, j| DVec3::new(i as f64, 0.0, -(j as f64)));
    for mesh in [Mesh::from_polygon(&polygon(&comb), &windows).unwrap(), flat] {
        let mesh = Arc::new(charted(&mesh, &[0, 2], |_, _, p, set| {
            DVec2::new(p.x + set as f64, p.x * 0.1 - p.z * set as f64)
        }));
        for _ in 0..200 {
            let mut lines: Vec<f64> = (0..1 + rng.below(6)).map(|_| number(&mut rng, 5)).collect();
            lines.sort_by(f64::total_cmp);
            lines.dedup();
            let by_axis = slabs(&mesh, Axis::X, &lines).parts;
            let by_u = iso_bands(&mesh, 0, UvAxis::U, &lines, MOST).unwrap();
            for (a, b) in by_axis.iter().zip(&by_u) {
                let describe = |part: &Option<Arc<Mesh>>| {
                    let part = part.clone().unwrap_or_default();
                    let faces = part.faces().map(|face| {
                        let corner = |c: usize| {
                            (part.points()[part.corners()[c] as usize], part.uv_set(2)[c], part.normals()[c])
                        };
                        (
                            face.tag(),
                            face.loop_ranges().map(|ring| ring.map(corner).collect::<Vec<_>>()).collect::<Vec<_>>(),
                        )
                    });
                    format!("{:?}", faces.collect::<Vec<_>>())
                };
                assert_eq!(describe(a), describe(b), "{lines:?}");
            }
        }
    }
}

#[test]
fn corners_on_lines_make_no_pieces_without_area() {
    let mut rng = Rng(8);
    for _ in 0..300 {
        let outline: Vec<(f64, f64)> = ring(5 + rng.below(8), |_| 1.0);
        let rounded: Vec<(f64, f64)> = outline
            .iter()
            .enumerate()
            .map(|(i, &(x, y))| {
                let far = [2.0, 4.0, 8.0][i % 3];
                ((x * far).round(), (y * far).round())
            })
            .collect();
        let Ok(mesh) = Mesh::from_polygon(&polygon(&rounded), &[]) else { continue };
        let mesh = charted(&mesh, &[0], |_, _, p, _| DVec2::new(p.x, -p.z));
        let lines: Vec<f64> = (-8..=8).map(f64::from).collect();
        for axis in [UvAxis::U, UvAxis::V] {
            for band in bands(&mesh, axis, &lines).iter().flatten() {
                assert!(band.faces().all(|face| 1e-9 < face.area()), "{rounded:?}");
            }
        }
    }
}

#[test]
fn faces_keep_what_they_carry_and_their_first_edges() {
    let mut builder = MeshBuilder::new();
    let p = [[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [0.0, -2.0], [4.0, -2.0], [8.0, -2.0]]
        .map(|[x, z]| builder.point([x, 0.0, z]));
    builder.groups(["left".into(), "right".into()].to_vec());
    for (group, corners, u) in [(0, [p[1], p[4], p[3], p[0]], 0.0), (1, [p[2], p[5], p[4], p[1]], 0.5)] {
        builder.face(&corners, &[], FaceTag { group, ..FaceTag::PLAIN });
        builder.uvs(&[[u + 0.5, 0.0], [u + 0.5, 1.0], [u, 1.0], [u, 0.0]].map(DVec2::from));
    }
    let found = bands(&builder.build().unwrap(), UvAxis::U, &[0.25, 0.75]);
    let middle = found[1].as_ref().unwrap();
    assert_eq!(middle.faces().map(|face| face.tag().group).collect::<Vec<_>>(), [0, 1]);
    // The first edge of the left face is whole; on the right the cut replaces it.
    let first = |mesh: &Mesh, face: usize| [0, 1].map(|at| mesh.points()[mesh.face(face).outer()[at] as usize].x);
    assert_eq!([first(middle, 0), first(middle, 1)], [[4.0; 2], [6.0; 2]]);
    let shared: Vec<_> = middle.face(0).outer().iter().filter(|point| middle.face(1).outer().contains(point)).collect();
    assert_eq!(shared.len(), 2);
}

#[test]
fn seams_have_crossings_of_their_own() {
    // Two squares with a common edge, on which v agrees and u does not.
    let mesh = grid(2, 1, false, |i, j| DVec3::new(i as f64, 0.0, -(j as f64)));
    let mesh = charted(&mesh, &[0], |face, n, _, _| {
        [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y][n] + DVec2::X * (5 * face) as f64
    });
    let across = bands(&mesh, UvAxis::V, &[0.5]);
    // v is equal on both sides, so the pieces stay connected.
    assert!(across.iter().flatten().all(|band| band.points().len() == 6));
    let mirrored = charted(&mesh, &[0], |face, n, _, _| {
        [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y][if face == 0 { n } else { n ^ 1 }]
    });
    let found = bands(&mirrored, UvAxis::U, &[0.25]);
    assert_eq!(areas(&found), [0.5, 1.5]);
}

#[test]
fn many_lines_through_many_faces() {
    let place = |i: usize, j: usize| DVec3::new(i as f64, (i * 7 % 5) as f64 * 0.3, -(j as f64));
    let mesh = grid(50, 50, true, place);
    let mesh = Arc::new(charted(&mesh, &[0, 1], |_, _, p, _| DVec2::new(p.x * 0.02, -p.z * 0.02)));
    let lines: Vec<f64> = (1..3000).map(|i| f64::from(i) / 3000.0).collect();
    let found = iso_bands(&mesh, 0, UvAxis::U, &lines, MOST).unwrap();
    assert!(found.iter().all(Option::is_some));
    let area: f64 = areas(&found).iter().sum();
    assert!((area / mesh.area() - 1.0).abs() < 1e-12);
    let corners: usize = found.iter().flatten().map(|band| band.corners().len()).sum();
    assert!(iso_bands(&mesh, 0, UvAxis::U, &lines, corners).is_ok());
    for most in [0, 1000, corners - 1] {
        assert_eq!(iso_bands(&mesh, 0, UvAxis::U, &lines, most).unwrap_err(), TooManyCorners { most });
    }
}

#[test]
fn faces_that_would_need_too_much_are_refused_before_they_are_cut() {
    let count = 2000;
    let comb: Vec<(f64, f64)> = (0..count).map(|i| (f64::from(i), if i % 2 == 0 { 1.0 } else { 9.0 })).collect();
    let outline: Vec<(f64, f64)> = [(f64::from(count), -1.0), (0.0, -1.0)].into_iter().chain(comb).rev().collect();
    let mesh = Mesh::from_polygon(&polygon(&outline), &[]).unwrap();
    let mesh = Arc::new(charted(&mesh, &[0], |_, _, p, _| DVec2::new(-p.z, p.x)));
    let lines: Vec<f64> = (0..1_000_000).map(|i| f64::from(i) * 1e-5).collect();
    assert!(iso_bands(&mesh, 0, UvAxis::U, &lines, 1 << 20).is_err());
    assert!(iso_bands(&mesh, 0, UvAxis::U, &lines[..20], 1 << 20).is_ok());
}

#[test]
fn extreme_coordinates_stay_finite() {
    for (size, scale) in [(f64::MAX, 1.0), (1e308, 1e300), (1e-308, 1e-300), (f64::MIN_POSITIVE, 1.0), (5e-324, 1.0)] {
        let mesh = grid(2, 2, true, |i, j| DVec3::new(i as f64 * scale, 0.0, -(j as f64) * scale));
        let values =
            [DVec2::new(-size, size), DVec2::new(size, 0.0), DVec2::ZERO, DVec2::new(0.0, -size), DVec2::splat(size)];
        let mesh = charted(&mesh, &[0, 1], |f, n, _, set| values[(2 * f + n + set) % 5]);
        let lines = [-size * 0.5, -1e-310, 0.0, size * 0.25, size * 0.999];
        for axis in [UvAxis::U, UvAxis::V] {
            for band in bands(&mesh, axis, &lines).iter().flatten() {
                assert!(band.check().is_empty(), "{size} {:?}", band.check());
                assert!(band.points().iter().all(|p| p.is_finite()));
                assert!([0, 1].iter().all(|&set| band.uv_set(set).iter().all(|uv| uv.is_finite())));
            }
        }
        assert!(mesh.uv_extent(0, DVec3::ONE).unwrap().metres.is_finite());
    }
}
