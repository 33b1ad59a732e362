//! Cuts with known results, and cuts that are awkward on purpose.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use crate::cut_support::section::section;
use crate::cut_support::*;
use cga_geometry::Axis;
use cga_geometry::cut::slabs;
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use cga_geometry::primitive;
use glam::{DAffine3, DMat3, DVec3};

fn equal(low: f64, high: f64, pieces: usize) -> Vec<f64> {
    (1..pieces).map(|i| low + (high - low) * i as f64 / pieces as f64).collect()
}

fn totals(mesh: &Arc<Mesh>, axis: Axis, offsets: &[f64]) -> (f64, f64) {
    let parts = check_closed_cut("workload", mesh, axis, offsets).parts;
    assert!(parts.iter().all(Option::is_some));
    parts.iter().flatten().fold((0.0, 0.0), |sum, part| (sum.0 + part.volume(), sum.1 + part.area()))
}

#[test]
fn a_lying_cylinder_is_sliced_into_prisms() {
    for (sides, pieces) in [(64, 16), (64, 256), (7, 40)] {
        let upright = primitive::cylinder(sides);
        let matrix3 = DMat3::from_cols(DVec3::Y, DVec3::X * 10.0, DVec3::NEG_Z);
        let mesh = Arc::new(upright.map(&DAffine3 { matrix3, translation: DVec3::ZERO }));
        let (volume, area) = totals(&mesh, Axis::X, &equal(0.0, 10.0, pieces));
        let (s, n) = (sides as f64, pieces as f64);
        let section = s / 8.0 * libm::sin(TAU / s);
        assert!((volume - 10.0 * section).abs() < 1e-10);
        assert!((area - (10.0 * s * libm::sin(PI / s) + 2.0 * n * section)).abs() < 1e-9);
        for part in slabs(&mesh, Axis::X, &equal(0.0, 10.0, pieces)).parts.iter().flatten() {
            assert_eq!(part.face_count(), sides + 2);
        }
    }
}

#[test]
fn areas_are_those_of_the_sections_to_the_last_bits() {
    let mesh = Arc::new(torus(64, 32, 1.0, 0.4));
    for (axis, reach) in [(Axis::X, 1.4), (Axis::Y, 1.4), (Axis::Z, 0.4)] {
        for pieces in [2, 3, 16, 64, 257] {
            let offsets = equal(-reach, reach, pieces);
            let expected = mesh.area() + 2.0 * offsets.iter().map(|&at| section(&mesh, axis, at)).sum::<f64>();
            let (volume, area) = totals(&mesh, axis, &offsets);
            assert!((volume - mesh.volume()).abs() < 1e-12 * mesh.volume(), "{axis:?} {pieces}: {volume}");
            assert!((area - expected).abs() < 1e-11 * expected, "{axis:?} {pieces}: {area}, not {expected}");
        }
    }
}

#[test]
fn a_torus_across_its_ring_has_round_caps() {
    let mesh = Arc::new(torus(64, 32, 1.0, 0.4));
    assert!((mesh.area() - 15.7502).abs() < 1e-4);
    for (pieces, expected) in [(4, 24.0744), (16, 51.2740), (64, 158.9476), (256, 588.6422)] {
        let (volume, area) = totals(&mesh, Axis::X, &equal(-1.4, 1.4, pieces));
        assert!((volume - 3.1329805).abs() < 1e-7, "{volume}");
        assert!((area - expected).abs() < 1e-4, "{pieces}: {area}");
    }
}

#[test]
fn a_torus_along_its_axis_has_rings_for_caps() {
    let mesh = Arc::new(torus(64, 32, 1.0, 0.4));
    for (pieces, expected) in [(2, 25.7871), (4, 43.0742), (16, 139.0574), (64, 516.2891), (256, 2020.6795)] {
        let (volume, area) = totals(&mesh, Axis::Z, &equal(-0.4, 0.4, pieces));
        assert!((volume - 3.1329805).abs() < 1e-7, "{volume}");
        assert!((area - expected).abs() < 1e-4, "{pieces}: {area}");
    }
    let parts = slabs(&mesh, Axis::Z, &[0.1]).parts;
    let caps: Vec<_> = parts[0].as_ref().unwrap().faces().filter(|face| face.tag().cap).collect();
    assert_eq!(caps.len(), 1);
    assert_eq!(caps[0].holes().len(), 1);
}

#[test]
fn a_face_in_the_plane_closes_the_part_below_it() {
    // Steps: the plane contains the tread.
    let steps = Arc::new(cells(2, |x, y, _| x == 0 || y == 0));
    let parts = check_closed_cut("steps", &steps, Axis::Y, &[1.0]).parts;
    let [low, high] = [0, 1].map(|slab| parts[slab].as_ref().unwrap());
    assert_eq!((low.volume(), high.volume()), (4.0, 2.0));
    let top = |mesh: &Mesh, cap: bool| {
        let tops = mesh.faces().filter(|f| f.normal().y == 1.0 && f.tag().cap == cap);
        tops.map(|f| f.area()).sum::<f64>()
    };
    assert_eq!((top(low, false), top(low, true)), (2.0, 2.0), "the tread stays, the rest is a cap");
    let under: f64 = high.faces().filter(|f| f.tag().cap).map(|f| f.area()).sum();
    assert_eq!(under, 2.0);
    assert!(high.faces().filter(|f| f.tag().cap).all(|f| f.normal() == DVec3::NEG_Y));
}

#[test]
fn a_cut_that_misses_gives_the_same_mesh() {
    let mesh = Arc::new(primitive::cylinder(16));
    let same = |part: &Option<Arc<Mesh>>| part.as_ref().is_some_and(|part| Arc::ptr_eq(part, &mesh));
    for (offsets, slab) in
        [(vec![], 0), (vec![-1.0], 1), (vec![0.0], 1), (vec![1.0], 0), (vec![-2.0, 0.0, 1.0, 5.0], 2)]
    {
        let parts = slabs(&mesh, Axis::Y, &offsets).parts;
        assert_eq!(parts.len(), offsets.len() + 1);
        assert!(same(&parts[slab]), "{offsets:?}");
        assert_eq!(parts.iter().flatten().count(), 1);
    }
}

#[test]
fn planes_through_corners_and_edges() {
    let octahedron = {
        let mut b = MeshBuilder::new();
        let p = [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z].map(|p| b.point(p));
        for i in 0..4 {
            b.face(&[p[i], p[(i + 1) % 4], p[4]], &[], FaceTag::PLAIN);
            b.face(&[p[(i + 1) % 4], p[i], p[5]], &[], FaceTag::PLAIN);
        }
        Arc::new(b.build().unwrap())
    };
    for axis in AXES {
        let parts = check_closed_cut("octahedron", &octahedron, axis, &[-1.0, 0.0, 1.0]).parts;
        assert!(parts[0].is_none() && parts[3].is_none());
        for part in [&parts[1], &parts[2]] {
            assert_eq!(part.as_ref().unwrap().face_count(), 5);
        }
        check_closed_cut("octahedron", &octahedron, axis, &[-0.5, 0.0, 0.5]);
    }
}

#[test]
fn a_section_that_touches_itself_becomes_simple_loops() {
    // Four cells around an edge, two of them filled. The section pinches at a point.
    let mesh = Arc::new(cells(2, |x, _, z| x == z));
    let parts = check_closed_cut("pinched", &mesh, Axis::Y, &[0.5]).parts;
    let caps: Vec<_> = parts[0].as_ref().unwrap().faces().filter(|f| f.tag().cap).collect();
    assert_eq!(caps.len(), 2);
    assert!(caps.iter().all(|cap| cap.outer().len() == 8 || cap.outer().len() == 4));
    // A ring of cells whose hole touches the outside at an edge.
    let mesh = Arc::new(cells(3, |x, _, z| x != z || x == 2));
    let parts = check_closed_cut("touching hole", &mesh, Axis::Y, &[0.5]).parts;
    let caps: Vec<_> = parts[0].as_ref().unwrap().faces().filter(|f| f.tag().cap).collect();
    assert_eq!((caps.len(), caps[0].holes().len(), caps[0].area()), (1, 1, 7.0));
}

#[test]
fn islands_in_holes_in_islands() {
    let cube = |size: f64| {
        let matrix3 = DMat3::from_diagonal(DVec3::splat(size));
        primitive::cube().map(&DAffine3 { matrix3, translation: DVec3::splat(-size / 2.0) })
    };
    let nested = together(&[cube(8.0), cube(6.0).reversed(), cube(4.0), cube(2.0).reversed()]);
    let two = together(&[nested.clone(), moved(&nested, DVec3::X * 20.0)]);
    let mesh = Arc::new(two);
    let parts = check_closed_cut("nested", &mesh, Axis::Y, &[0.3]).parts;
    for part in parts.iter().flatten() {
        let caps: Vec<_> = part.faces().filter(|f| f.tag().cap).collect();
        assert_eq!(caps.len(), 4);
        assert!(caps.iter().all(|cap| cap.holes().len() == 1));
        assert_eq!(caps.iter().map(|cap| cap.area()).sum::<f64>(), 2.0 * (64.0 - 36.0 + 16.0 - 4.0));
    }
}

#[test]
fn a_star_of_long_points_keeps_its_thousand_holes() {
    // In every direction most edges are long, so the sweep assigns the holes.
    let outline = ring(3000, |i| if i % 2 == 0 { 10.0 } else { 3.0 });
    let at = |i: usize| f64::from(i as u32) / 16.0 - 1.0;
    let holes: Vec<_> = (0..1024).map(|i| square(at(i % 32), at(i / 32), 0.03)).collect();
    let star = Arc::new(prism(&outline, &holes, 1.0));
    let slabs = check_closed_cut("star", &star, Axis::Y, &[0.25]);
    for part in slabs.parts.iter().flatten() {
        let cap = part.faces().find(|face| face.tag().cap).unwrap();
        assert_eq!(cap.loops().count(), 1 + holes.len());
    }
}

#[test]
fn nested_tubes_keep_their_holes_also_inside_out_and_beside_boxes_that_touch() {
    let count = 700;
    let turned = |size: f64| -> Vec<(f64, f64)> {
        let (sin, cos) = libm::sincos(0.3);
        let square = [(-size, -size), (size, -size), (size, size), (-size, size)];
        square.map(|(x, z)| (x * cos - z * sin, x * sin + z * cos)).to_vec()
    };
    let tubes = (1..=count).map(|i| prism(&turned(f64::from(i) * 2.0), &[turned(f64::from(i) * 2.0 - 1.0)], 1.0));
    // The same tube twice, and two boxes with a common part of a side.
    let beside =
        [square(2000.0, 0.0, 1.0), square(2001.0, 0.5, 1.0), square(2100.0, 0.0, 1.0), square(2100.0, 0.0, 1.0)];
    let meshes: Vec<Mesh> = tubes.chain(beside.map(|outline| prism(&outline, &[], 1.0))).collect();
    let whole = together(&meshes);
    for mesh in [Arc::new(whole.reversed()), Arc::new(whole)] {
        let parts = slabs(&mesh, Axis::Y, &[0.5]).parts;
        for part in parts.iter().flatten() {
            let caps = part.faces().filter(|face| face.tag().cap);
            let holes: Vec<usize> = caps.map(|cap| cap.loops().count() - 1).collect();
            assert_eq!((holes.len(), holes.iter().sum::<usize>()), (count as usize + 4, count as usize));
            assert!(holes.iter().all(|&holes| holes <= 1));
        }
    }
}

#[test]
fn an_open_mesh_stays_open() {
    // A box without a lid, and a sheet.
    let cube = primitive::cube();
    let all: Vec<u32> = (0..6).filter(|&face| face != 1).collect();
    let open = Arc::new(cga_geometry::extract::extract(&cube, &all, &cga_geometry::Frame::WORLD));
    let cut = slabs(&open, Axis::X, &[0.5]);
    assert_eq!(cut.open.len(), 1);
    assert_eq!(cut.open[0].points.len(), 4);
    for part in cut.parts.iter().flatten() {
        assert!(part.faces().all(|face| !face.tag().cap));
        assert!(part.check().is_empty());
    }
    assert_eq!(cut.parts.iter().flatten().map(|part| part.area()).sum::<f64>(), 5.0);
    // Across this axis, the section closes.
    let cut = slabs(&open, Axis::Y, &[0.5]);
    assert!(cut.open.is_empty());
    assert_eq!(cut.parts.iter().flatten().map(|part| part.area()).sum::<f64>(), 7.0);
    let cut = slabs(&Arc::new(primitive::quad()), Axis::X, &[0.25, 0.5]);
    assert_eq!(cut.open.len(), 2);
    let areas: Vec<f64> = cut.parts.iter().flatten().map(|part| part.area()).collect();
    assert_eq!(areas, [0.25, 0.25, 0.5]);
}

#[test]
fn offsets_that_make_no_sense_do_no_harm() {
    let mesh = Arc::new(primitive::cube());
    for offsets in [
        vec![f64::NAN],
        vec![0.5, 0.5],
        vec![0.7, 0.2],
        vec![f64::NEG_INFINITY, 0.5, f64::INFINITY],
        vec![f64::NAN, 0.5, f64::NAN],
    ] {
        let parts = slabs(&mesh, Axis::X, &offsets).parts;
        assert_eq!(parts.len(), offsets.len() + 1);
        assert_eq!(parts.iter().flatten().map(|part| part.volume()).sum::<f64>(), 1.0, "{offsets:?}");
    }
    assert!(slabs(&Arc::new(Mesh::default()), Axis::X, &[0.5]).parts.iter().all(Option::is_none));
}

#[test]
fn extents_of_all_sizes() {
    for size in [1e-150, 1e-9, 1e-6, 1e6, 1e12, 1e100] {
        let matrix3 = DMat3::from_diagonal(DVec3::splat(size));
        let mesh = Arc::new(torus(16, 8, 1.0, 0.4).map(&DAffine3 { matrix3, translation: DVec3::ZERO }));
        for axis in AXES {
            for offsets in [even(&mesh, axis, 4), own(&mesh, axis, 5)] {
                let parts = slabs(&mesh, axis, &offsets).parts;
                assert!(parts.iter().flatten().all(|part| closed_by_position(part)), "{size}");
            }
        }
    }
    let far = Arc::new(moved(&torus(16, 8, 1.0, 0.4), DVec3::splat(1e9)));
    for axis in AXES {
        let parts = slabs(&far, axis, &even(&far, axis, 16)).parts;
        assert!(parts.iter().flatten().all(|part| closed_by_position(part)));
    }
}

#[test]
fn random_soups_are_cut_without_harm() {
    let mut rng = Rng(3);
    for round in 0..400 {
        let mut b = MeshBuilder::new();
        let points = 4 + rng.below(12);
        for _ in 0..points {
            let mut c = || if round % 3 == 0 { rng.unit() } else { rng.below(4) as f64 };
            b.point([c(), c(), c()]);
        }
        for _ in 0..1 + rng.below(20) {
            let ring: Vec<u32> = (0..3 + rng.below(5)).map(|_| rng.below(points) as u32).collect();
            let hole: Vec<u32> = (0..3).map(|_| rng.below(points) as u32).collect();
            let holes: &[&[u32]] = if rng.below(3) == 0 { &[&hole] } else { &[] };
            b.face(&ring, holes, FaceTag::PLAIN);
        }
        let mut mesh = b.build().unwrap();
        if rng.below(2) == 0 {
            // All faces twice, the second time reversed: always closed.
            mesh = together(&[mesh.clone(), mesh.reversed()]);
        }
        let mesh = Arc::new(mesh);
        for axis in AXES {
            let offsets = [0.5, 1.0, 1.25, 2.0, 2.5];
            let cut = slabs(&mesh, axis, &offsets);
            for part in cut.parts.iter().flatten() {
                let broken = part.check().into_iter().find(|flaw| {
                    use cga_geometry::mesh::Flaw;
                    !matches!(flaw, Flaw::NotPlanar { .. } | Flaw::Hole { .. })
                });
                assert_eq!(broken, None, "round {round} {axis:?}");
                assert!(!mesh.is_closed() || closed_by_position(part), "round {round} {axis:?}: a part is open");
            }
            assert!(!mesh.is_closed() || cut.open.is_empty());
        }
    }
}
