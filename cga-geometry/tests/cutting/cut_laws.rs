//! Laws that hold for every closed mesh and every cut.

use std::sync::Arc;

use crate::cut_support::*;
use cga_geometry::Axis;
use cga_geometry::cut::slabs;
use cga_geometry::extrude::{Extrude, extrude};
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use cga_geometry::primitive;
use glam::{DAffine3, DMat3, DVec2, DVec3};

/// One mesh of each kind.
fn zoo() -> Vec<(&'static str, Mesh)> {
    let teeth: Vec<(f64, f64)> = (0..40)
        .flat_map(|i| {
            let x = f64::from(i);
            [(x, 10.0), (x + 0.25, 1.0), (x + 0.5, 10.0)]
        })
        .rev()
        .collect();
    let comb: Vec<(f64, f64)> = [(0.0, 0.0), (39.5, 0.0)].into_iter().chain(teeth).collect();
    let windows: Vec<Vec<(f64, f64)>> =
        (0..16).map(|i| square(0.5 + 2.0 * f64::from(i % 4), 0.5 + 2.0 * f64::from(i / 4), 1.0)).collect();
    let cube = |size: f64| {
        primitive::cube().map(&DAffine3 {
            matrix3: DMat3::from_diagonal(DVec3::splat(size)),
            translation: DVec3::splat(-size / 2.0),
        })
    };
    let l = [(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)];
    vec![
        ("cube", primitive::cube()),
        ("cylinder", primitive::cylinder(17)),
        ("L", prism(&l, &[], 3.0)),
        ("torus", torus(24, 12, 1.0, 0.4)),
        ("star", prism(&ring(14, |i| if i % 2 == 0 { 1.0 } else { 0.3 }), &[], 0.7)),
        ("comb", prism(&comb, &[], 2.0)),
        ("plate with holes", prism(&square(0.0, 0.0, 8.5), &windows, 1.0)),
        ("shells", together(&[cube(8.0), cube(6.0).reversed(), cube(4.0), cube(2.0).reversed()])),
        ("touching at an edge", together(&[primitive::cube(), moved(&primitive::cube(), DVec3::new(1.0, 1.0, 0.0))])),
        ("touching at a corner", together(&[primitive::cube(), moved(&primitive::cube(), DVec3::ONE)])),
        ("touching at a face", together(&[primitive::cube(), moved(&primitive::cube(), DVec3::X)])),
        ("frame of cells", cells(3, |x, y, z| (x == 1) as u8 + (y == 1) as u8 + (z == 1) as u8 <= 1)),
        ("diagonal cells", cells(3, |x, y, z| (x + y + z) % 2 == 0)),
    ]
}

#[test]
fn parts_are_closed_and_add_up() {
    for (name, mesh) in zoo() {
        for (kind, mesh) in [("", mesh.clone()), ("turned ", turned(&mesh)), ("inside out ", mesh.reversed())] {
            let mesh = Arc::new(mesh);
            for axis in AXES {
                for offsets in [even(&mesh, axis, 1), even(&mesh, axis, 7), own(&mesh, axis, 9)] {
                    check_closed_cut(&format!("{kind}{name}"), &mesh, axis, &offsets);
                }
            }
        }
    }
}

#[test]
fn random_cells_cut_at_and_between_their_faces() {
    let mut rng = Rng(1);
    for round in 0..60 {
        let size = 2 + rng.below(3);
        let bits = (rng.next(), rng.next());
        let filled = |x: i32, y: i32, z: i32| {
            let bit = (x + 4 * (y + 4 * z)) as u32;
            (bits.0 >> bit & 1) == 1 && (round % 2 == 0 || (bits.1 >> bit & 1) == 1)
        };
        let mesh = cells(size, filled);
        if mesh.is_empty() {
            continue;
        }
        let mesh = Arc::new(mesh);
        for axis in AXES {
            let offsets: Vec<f64> = (0..=2 * size).filter(|_| rng.below(3) != 0).map(|i| i as f64 / 2.0).collect();
            let cut = check_closed_cut("cells", &mesh, axis, &offsets);
            // The number of cells must match too.
            let bounds: Vec<f64> = [f64::NEG_INFINITY].into_iter().chain(offsets).chain([f64::INFINITY]).collect();
            for (slab, part) in cut.parts.iter().enumerate() {
                let mut expected = 0.0;
                for x in 0..size as i32 {
                    for y in 0..size as i32 {
                        for z in 0..size as i32 {
                            let low = f64::from([x, y, z][axis.index()]);
                            if filled(x, y, z) {
                                expected += ((low + 1.0).min(bounds[slab + 1]) - low.max(bounds[slab])).max(0.0);
                            }
                        }
                    }
                }
                assert_eq!(part.as_ref().map_or(0.0, |part| part.volume()), expected);
            }
        }
    }
}

#[test]
fn random_footprints_with_courtyards() {
    let mut rng = Rng(2);
    for _ in 0..60 {
        let count = 3 + rng.below(20);
        let radii: Vec<f64> = (0..count).map(|_| 4.0 + rng.below(5) as f64).collect();
        let hole = square(-0.5 - rng.unit(), -0.5 - rng.unit(), 1.0);
        let holes = if rng.below(2) == 0 || count < 6 { vec![] } else { vec![hole] };
        let mesh = prism(&ring(count, |i| radii[i]), &holes, 1.0 + rng.unit());
        let mesh = Arc::new(if rng.below(2) == 0 { mesh } else { turned(&mesh) });
        for axis in AXES {
            check_closed_cut("footprint", &mesh, axis, &even(&mesh, axis, 1 + rng.below(20)));
            check_closed_cut("footprint", &mesh, axis, &own(&mesh, axis, 40));
        }
    }
}

#[test]
fn one_pass_gives_what_one_plane_after_the_other_gives() {
    for (name, mesh) in zoo() {
        let mesh = Arc::new(mesh);
        for axis in AXES {
            let offsets = even(&mesh, axis, 5);
            let all = slabs(&mesh, axis, &offsets);
            let mut rest = Some(mesh.clone());
            for (slab, &offset) in offsets.iter().enumerate() {
                let Some(upper) = rest else { break };
                let cut = check_closed_cut(name, &upper, axis, &[offset]);
                let volume = |part: &Option<Arc<Mesh>>| part.as_ref().map_or(0.0, |part| part.volume());
                assert!((volume(&cut.parts[0]) - volume(&all.parts[slab])).abs() < 1e-11, "{name}");
                rest = cut.parts[1].clone();
            }
        }
    }
}

#[test]
fn two_cuts_commute_in_volume_and_nested_cuts_add_up() {
    for (name, mesh) in zoo() {
        let mesh = Arc::new(turned(&mesh));
        let [a, b] = [Axis::X, Axis::Z].map(|axis| even(&mesh, axis, 3));
        let mut sum = 0.0;
        let mut volumes = [vec![vec![0.0; 4]; 4], vec![vec![0.0; 4]; 4]];
        for (i, part) in check_closed_cut(name, &mesh, Axis::X, &a).parts.iter().enumerate() {
            let Some(part) = part else { continue };
            for (j, cell) in check_closed_cut(name, part, Axis::Z, &b).parts.iter().enumerate() {
                let Some(cell) = cell else { continue };
                volumes[0][i][j] = cell.volume();
                for brick in check_closed_cut(name, cell, Axis::Y, &even(&mesh, Axis::Y, 3)).parts.iter().flatten() {
                    sum += brick.volume();
                }
            }
        }
        for (j, part) in slabs(&mesh, Axis::Z, &b).parts.iter().enumerate() {
            let Some(part) = part else { continue };
            for (i, cell) in slabs(part, Axis::X, &a).parts.iter().enumerate() {
                volumes[1][i][j] = cell.as_ref().map_or(0.0, |cell| cell.volume());
            }
        }
        for (x, y) in volumes[0].iter().flatten().zip(volumes[1].iter().flatten()) {
            assert!((x - y).abs() < 1e-10, "{name}: {x} {y}");
        }
        assert!((sum - mesh.volume()).abs() < 1e-10, "{name}: {sum}");
    }
}

#[test]
fn turning_and_mirroring_the_input_turns_and_mirrors_the_parts() {
    let cycle = DAffine3::from_mat3(DMat3::from_cols(DVec3::Y, DVec3::Z, DVec3::X));
    let mirror = DAffine3::from_mat3(DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0)));
    for (name, mesh) in zoo() {
        let mesh = Arc::new(mesh);
        let offsets = even(&mesh, Axis::X, 6);
        let measure = |part: &Option<Arc<Mesh>>| part.as_ref().map_or((0.0, 0.0), |p| (p.volume(), p.area()));
        let plain: Vec<_> = slabs(&mesh, Axis::X, &offsets).parts.iter().map(measure).collect();
        let turned: Vec<_> = slabs(&Arc::new(mesh.map(&cycle)), Axis::Y, &offsets).parts.iter().map(measure).collect();
        let back: Vec<f64> = offsets.iter().rev().map(|o| -o).collect();
        let mirrored: Vec<_> =
            slabs(&Arc::new(mesh.map(&mirror).reversed()), Axis::X, &back).parts.iter().rev().map(measure).collect();
        for ((a, b), c) in plain.iter().zip(&turned).zip(&mirrored) {
            for other in [b, c] {
                assert!((a.0 - other.0).abs() < 1e-12 && (a.1 - other.1).abs() < 1e-11, "{name}: {a:?} {other:?}");
            }
        }
    }
}

#[test]
fn texture_coordinates_and_normals_are_interpolated_and_tags_kept() {
    let base =
        prism(&[(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)], &[square(0.5, 0.5, 1.0)], 3.0);
    let uv = |p: DVec3| DVec2::new(p.x + 2.0 * p.y, p.z - p.y);
    let mut b = MeshBuilder::new();
    let points: Vec<u32> = base.points().iter().map(|&p| b.point(p)).collect();
    for face in base.faces() {
        let loops: Vec<Vec<u32>> =
            face.loops().map(|ring| ring.iter().map(|&c| points[c as usize]).collect()).collect();
        let holes: Vec<&[u32]> = loops[1..].iter().map(Vec::as_slice).collect();
        let at: Vec<DVec3> = loops.iter().flatten().map(|&c| base.points()[c as usize]).collect();
        let tag = FaceTag { group: face.index() as u32 % 3, ..FaceTag::PLAIN };
        b.face(&loops[0], &holes, tag)
            .uvs(&at.iter().map(|&p| uv(p)).collect::<Vec<_>>())
            .uv_set(7, &at.iter().map(|&p| uv(p).perp()).collect::<Vec<_>>())
            .normals(&vec![face.normal(); at.len()]);
    }
    b.groups(["a", "b", "c"].map(String::from).to_vec());
    let mesh = Arc::new(turned(&b.build().unwrap()));
    let back = |p: DVec3| uv(turned_back(p));
    for axis in AXES {
        for part in check_closed_cut("tagged", &mesh, axis, &even(&mesh, axis, 7)).parts.iter().flatten() {
            assert_eq!(part.groups().len(), 3);
            assert!((0..12).all(|set| part.uv_set(set).is_empty() != [0, 7].contains(&set)));
            for face in part.faces() {
                assert_eq!(face.tag().cap, face.tag().group == FaceTag::NONE);
                for corner in face.corner_range() {
                    let p = part.points()[part.corners()[corner] as usize];
                    assert!((part.normals()[corner] - face.normal()).length() < 1e-9);
                    assert!(face.tag().cap || (part.uvs()[corner] - back(p)).length() < 1e-12);
                    assert!(face.tag().cap || (part.uv_set(7)[corner] - back(p).perp()).length() < 1e-12);
                }
            }
        }
    }
}

fn turned_back(p: DVec3) -> DVec3 {
    let (x, y) = (DVec3::new(0.36, 0.48, 0.8), DVec3::new(-0.8, 0.6, 0.0));
    DVec3::new(x.dot(p), y.dot(p), x.cross(y).dot(p))
}

#[test]
fn cutting_is_deterministic() {
    for (_, mesh) in zoo() {
        let mesh = Arc::new(turned(&mesh));
        let offsets = even(&mesh, Axis::Y, 9);
        let dump = || {
            format!(
                "{:?}",
                slabs(&mesh, Axis::Y, &offsets)
                    .parts
                    .iter()
                    .flatten()
                    .map(|p| (p.points(), p.corners()))
                    .collect::<Vec<_>>()
            )
        };
        let first = dump();
        slabs(&Arc::new(primitive::cylinder(99)), Axis::X, &[0.1, 0.2]);
        assert_eq!(first, dump());
    }
}

#[test]
fn extruded_random_polygons_keep_their_volume() {
    let mut rng = Rng(7);
    for _ in 0..100 {
        let outline = ring(3 + rng.below(30), |_| 1.0);
        let base = Mesh::from_polygon(&polygon(&outline), &[]).unwrap();
        let height = 0.1 + rng.unit();
        let body = extrude(&base, Extrude::FaceNormal, height);
        assert!(body.is_closed());
        assert!((body.volume() - base.area() * height).abs() < 1e-12);
    }
}
