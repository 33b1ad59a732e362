//! Meshes that no rule should make: the result is a mesh that holds its invariants, or an error, and it comes soon.

use std::slice::from_ref;

use glam::{DAffine3, DVec3};

use super::{BooleanError, BooleanOp, block, combine, combined};
use crate::boolean::budget::Budget;
use crate::boolean::combine_within;
use crate::mesh::{FaceTag, Flaw, Mesh, MeshBuilder};
use crate::primitive::sphere;
use crate::random::Rng;

const OPS: [BooleanOp; 4] = [BooleanOp::Unify, BooleanOp::Union, BooleanOp::Subtract, BooleanOp::Intersect];

/// Faces with random corners: crossing, bent and thin ones, loops that meet themselves, holes outside of outlines.
fn soup(rng: &mut Rng, faces: u32, grid: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    for _ in 0..faces {
        let rings = 1 + (rng.unit() * 1.5) as usize;
        let flat = rng.unit() < 0.5;
        let mut ring = || -> Vec<u32> {
            let count = 3 + (rng.unit() * 4.0) as usize;
            let mut coordinate = || (rng.unit() * grid).floor() / grid;
            let points = (0..count).map(|_| [coordinate(), if flat { 0.5 } else { coordinate() }, coordinate()]);
            points.collect::<Vec<_>>().into_iter().map(|point| builder.point(point)).collect()
        };
        let loops: Vec<Vec<u32>> = (0..rings).map(|_| ring()).collect();
        let holes: Vec<&[u32]> = loops[1..].iter().map(Vec::as_slice).collect();
        builder.face(&loops[0], &holes, FaceTag::PLAIN);
    }
    builder.build().unwrap()
}

/// The flaws that an operation itself can make. Faces that are bent or cross themselves stay so.
fn new_flaws(mesh: &Mesh) -> Vec<Flaw> {
    mesh.check().into_iter().filter(|flaw| !matches!(flaw, Flaw::NotPlanar { .. } | Flaw::Hole { .. })).collect()
}

#[test]
fn soups_give_a_mesh_or_an_error() {
    let (mut done, mut refused) = (0, 0);
    for seed in 0..45 {
        let rng = &mut Rng(seed);
        let grid = [1e12, 5.0, 3.0][seed as usize % 3];
        let a = soup(rng, 1 + seed as u32 % 12, grid);
        let b = if seed % 2 == 0 { block([0.2; 3], [0.7; 3]) } else { soup(rng, 5, grid) };
        for op in OPS {
            match combined(op, &a, &b) {
                Ok(mesh) => {
                    assert_eq!(new_flaws(&mesh), [], "{seed} {op:?}");
                    done += 1;
                }
                Err(_) => refused += 1,
            }
        }
    }
    assert!(refused * 20 < done, "{refused} of {done} refused");
}

#[test]
fn sizes_from_the_smallest_to_the_largest_are_the_same_to_an_operation() {
    let (a, b) = (block([0.0; 3], [2.0; 3]), block([1.0; 3], [3.0; 3]));
    let plain = combined(BooleanOp::Union, &a, &b).unwrap();
    for scale in [1e-150, 1e-6, 1e6, 1e150] {
        let place = DAffine3::from_scale(DVec3::splat(scale));
        let made = combined(BooleanOp::Union, &a.map(&place), &b.map(&place)).unwrap();
        assert_eq!(made.corners(), plain.corners(), "{scale}");
        assert!(made.is_closed());
    }
    // Sizes whose squares overflow or vanish.
    for scale in [1e-300, 1e300] {
        let place = DAffine3::from_scale(DVec3::splat(scale));
        for op in OPS {
            if let Ok(mesh) = combined(op, &a.map(&place), &b.map(&place)) {
                assert_eq!(new_flaws(&mesh), []);
            }
        }
    }
}

#[test]
fn coordinates_that_are_not_finite_are_refused() {
    let a = block([0.0; 3], [2.0; 3]);
    for bad in [f64::NAN, f64::INFINITY] {
        let mut points = a.points().to_vec();
        points[3].y = bad;
        let broken = Mesh { points, ..a.clone() };
        for op in OPS {
            for operands in [[from_ref(&a), from_ref(&broken)], [from_ref(&broken), from_ref(&a)]] {
                assert_eq!(combine(op, operands, 0.0).err(), Some(BooleanError::NotFinite), "{op:?} {bad}");
            }
        }
        assert_eq!(combine(BooleanOp::Union, [from_ref(&a), from_ref(&a)], bad).err(), Some(BooleanError::NotFinite));
    }
}

#[test]
fn an_operand_without_faces_is_nothing() {
    let (a, none) = (block([0.0; 3], [1.0; 3]), Mesh::default());
    let faces = |op, a: &[Mesh], b: &[Mesh]| combine(op, [a, b], 0.0).unwrap().face_count();
    let one = from_ref(&a);
    assert_eq!([faces(BooleanOp::Union, one, &[]), faces(BooleanOp::Union, &[], one)], [6, 6]);
    assert_eq!([faces(BooleanOp::Subtract, one, &[]), faces(BooleanOp::Subtract, &[], one)], [6, 0]);
    assert_eq!([faces(BooleanOp::Intersect, one, &[]), faces(BooleanOp::Intersect, &[], one)], [0, 0]);
    assert_eq!([faces(BooleanOp::Unify, one, &[]), faces(BooleanOp::Unify, &[], &[])], [6, 0]);
    assert_eq!(combined(BooleanOp::Union, &a, &none).unwrap().face_count(), 6);
}

#[test]
fn faces_without_area_leave_a_solid_closed() {
    // The front is divided into a triangle without area and two with.
    let mut builder = MeshBuilder::new();
    let at = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.0, 0.0]];
    let [o, x, y, z, m] = at.map(|point| builder.point(point));
    for face in [[o, y, x], [o, z, y], [x, y, z], [o, m, z], [m, x, z], [o, x, m]] {
        builder.face(&face, &[], FaceTag::PLAIN);
    }
    let solid = builder.build().unwrap();
    assert!(solid.is_closed());
    let part = block([0.0, 0.0, 0.0], [0.5, 1.0, 1.0]);
    let [common, left] = [BooleanOp::Intersect, BooleanOp::Subtract].map(|op| combined(op, &solid, &part).unwrap());
    assert!((common.volume() + left.volume() - 1.0 / 6.0).abs() < 1e-12 && common.is_closed() && left.is_closed());
}

/// Walls along x and walls along z, which all cross.
fn lattice(count: u32) -> [Vec<Mesh>; 2] {
    let wall = |number: u32, turned: bool| {
        let from = f64::from(number) / f64::from(count);
        let to = from + 0.2 / f64::from(count);
        if turned { block([from, 0.1, 0.0], [to, 0.9, 1.0]) } else { block([0.0, 0.0, from], [1.0, 1.0, to]) }
    };
    [false, true].map(|turned| (0..count).map(|number| wall(number, turned)).collect())
}

#[test]
fn too_many_crossings_are_refused() {
    let [a, b] = lattice(12);
    let within = |budget: Budget| combine_within(budget, BooleanOp::Union, [&a, &b], 0.0);
    let made = within(Budget::DEFAULT).unwrap();
    // Each crossing is in a wall of 0.8 m.
    let volume = 12.0 / 60.0 + 12.0 / 60.0 * 0.8 - 144.0 / 3600.0 * 0.8;
    assert!((made.volume() - volume).abs() < 1e-9 && made.is_closed(), "{}", made.volume());
    let refused = Some(BooleanError::TooMany);
    for comparisons in [0, 100, 3_000, 30_000] {
        assert_eq!(within(Budget { comparisons, ..Budget::DEFAULT }).err(), refused, "{comparisons}");
    }
    for edges in [0, 300, 1000] {
        assert_eq!(within(Budget { edges, ..Budget::DEFAULT }).err(), refused, "{edges}");
    }
}

#[test]
fn edges_of_all_attempts_count() {
    // Moved by about an epsilon, so that the first attempt fails.
    let ball = sphere(12, 8);
    let moved = ball.map(&DAffine3::from_translation(DVec3::new(0.61e-8, 0.37e-8, -0.7e-8)));
    let within = |edges: usize| {
        let budget = Budget { edges, ..Budget::DEFAULT };
        combine_within(budget, BooleanOp::Union, [from_ref(&ball), from_ref(&moved)], 0.0)
    };
    let made = within(Budget::DEFAULT.edges).unwrap();
    assert!(made.is_closed() && (made.volume() - ball.volume()).abs() < 1e-6);
    // Too few for the first attempt, for the one that succeeds, and enough for both.
    let mut found: Vec<Option<BooleanError>> = (0..1_000).step_by(50).map(|edges| within(edges).err()).collect();
    found.dedup();
    assert_eq!(found, [Some(BooleanError::TooMany), Some(BooleanError::Tangled), None]);
}

#[test]
fn the_same_solid_many_times_is_that_solid() {
    let ball = sphere(12, 8);
    let all = vec![ball.clone(); 8];
    let made = combine(BooleanOp::Unify, [&all, &[]], 0.0).unwrap();
    assert!(made.corners() == ball.corners() && made.points() == ball.points());
    assert!(combine(BooleanOp::Subtract, [&all, &all], 0.0).unwrap().is_empty());
}

#[test]
fn a_solid_thinner_than_epsilon_is_refused_and_no_surface() {
    // 1e-11 of its length.
    let thin = block([0.0; 3], [1.0, 1.0, 1e-11]);
    let other = block([0.25, 0.25, -1.0], [0.75, 0.75, 1.0]);
    for op in OPS {
        assert_eq!(combined(op, &thin, &thin.reversed()).err(), Some(BooleanError::Tangled), "{op:?}");
    }
    // With a larger operand its faces coincide.
    for op in [BooleanOp::Subtract, BooleanOp::Intersect] {
        let made = combined(op, &thin, &other);
        assert!(made.is_err() || made.is_ok_and(|mesh| mesh.is_empty() || mesh.is_closed()), "{op:?}");
    }
    // Without any volume, it is an area.
    let flat = block([0.0; 3], [1.0, 1.0, 0.0]);
    assert!((combined(BooleanOp::Union, &flat, &flat).unwrap().area() - 1.0).abs() < 1e-12);
}
