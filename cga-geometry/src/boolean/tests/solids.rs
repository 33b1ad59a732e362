//! Laws of boolean operations on solids of many forms.

use glam::{DAffine3, DMat3, DVec3};

use super::{BooleanOp, block, combined};
use crate::mesh::Mesh;
use crate::primitive::{cone, cylinder, sphere};
use crate::random::Rng;
use crate::rotation::turn;
use BooleanOp::{Intersect, Subtract, Union};

/// A solid of a random form in the box from 0 to 1.
fn form(rng: &mut Rng) -> Mesh {
    match (rng.unit() * 6.0) as u32 {
        0 => block([0.0; 3], [1.0; 3]),
        1 => cylinder(3 + (rng.unit() * 20.0) as usize),
        2 => cone(3 + (rng.unit() * 20.0) as usize),
        3 => sphere(4 + (rng.unit() * 12.0) as usize, 3 + (rng.unit() * 6.0) as usize),
        4 => {
            // A frame: a box with a hole through it.
            combined(Subtract, &block([0.0; 3], [1.0; 3]), &block([0.25, 0.25, -1.0], [0.75, 0.75, 2.0])).unwrap()
        }
        _ => combined(Union, &block([0.0; 3], [1.0, 0.5, 1.0]), &block([0.0; 3], [0.5, 1.0, 0.5])).unwrap(),
    }
}

/// A place that is random, or one of few, so that solids touch each other.
fn place(rng: &mut Rng) -> DAffine3 {
    let in_steps = rng.unit() < 0.6;
    let mut number = |steps: f64| if in_steps { (rng.unit() * steps).floor() / steps } else { rng.unit() };
    let [x, y, z] = [number(4.0), number(4.0), number(4.0)];
    let size = DVec3::new(number(2.0), number(2.0), number(2.0)) + 0.5;
    let angles = [number(8.0), number(8.0), number(8.0)].map(|share| share * 360.0);
    DAffine3 {
        matrix3: turn(angles[0], angles[1], angles[2]) * DMat3::from_diagonal(size),
        translation: DVec3::new(x, y, z),
    }
}

/// The results of all operations on two solids.
struct Results {
    union: Mesh,
    common: Mesh,
    left: Mesh,
    right: Mesh,
}

impl Results {
    fn of(a: &Mesh, b: &Mesh, seed: u64) -> Self {
        let made = |op, a, b| {
            let mesh = combined(op, a, b).unwrap_or_else(|error| panic!("{seed}: {op:?}: {error:?}"));
            assert_eq!(mesh.check(), [], "{seed}: {op:?}");
            assert!(mesh.is_empty() || mesh.is_closed(), "{seed}: {op:?}");
            mesh
        };
        Results {
            union: made(Union, a, b),
            common: made(Intersect, a, b),
            left: made(Subtract, a, b),
            right: made(Subtract, b, a),
        }
    }
}

fn count() -> u64 {
    std::env::var("BOOLEAN_SOLIDS").ok().and_then(|count| count.parse().ok()).unwrap_or(80)
}

#[test]
fn volumes_add_up() {
    let first = std::env::var("BOOLEAN_FIRST").ok().and_then(|count| count.parse().ok()).unwrap_or(0);
    for seed in first..first + count() {
        let rng = &mut Rng(seed + 1);
        let [a, b] = [(); 2].map(|()| {
            let form = form(rng);
            form.map(&place(rng))
        });
        let made = Results::of(&a, &b, seed);
        let [union, common, left, right] = [&made.union, &made.common, &made.left, &made.right].map(Mesh::volume);
        let (a_alone, b_alone) = (a.volume(), b.volume());
        let equal = |x: f64, y: f64, law: &str| assert!((x - y).abs() < 1e-6, "{seed}: {law}: {x} and {y}");
        equal(union + common, a_alone + b_alone, "union and common part");
        equal(left + common, a_alone, "A without B");
        equal(right + common, b_alone, "B without A");
        assert!(a_alone.max(b_alone) <= union + 1e-6 && common <= a_alone.min(b_alone) + 1e-6, "{seed}");
        // The order of operands does not matter.
        equal(combined(Union, &b, &a).unwrap().volume(), union, "union in the other order");
        equal(combined(Intersect, &b, &a).unwrap().volume(), common, "common part in the other order");
        equal(combined(Union, &b, &a).unwrap().area(), made.union.area(), "area in the other order");
    }
}

/// Results are operands again, so their new points and the old planes coincide except for rounding.
#[test]
fn results_fit_together_again() {
    let first = std::env::var("BOOLEAN_FIRST").ok().and_then(|count| count.parse().ok()).unwrap_or(0);
    for seed in first..first + count() {
        let rng = &mut Rng(seed + 1_000_000);
        let far = if seed % 3 == 0 { DVec3::new(400_000.0, 100.0, -300_000.0) } else { DVec3::ZERO };
        let far = DAffine3 { matrix3: turn(12.0, 34.0, 5.0), translation: far };
        let [a, b] = [(); 2].map(|()| {
            let form = form(rng);
            form.map(&(far * place(rng)))
        });
        let made = Results::of(&a, &b, seed);
        let equal = |op: BooleanOp, x: &Mesh, y: &Mesh, other: &Mesh, law: &str| {
            let mesh = combined(op, x, y).unwrap_or_else(|error| panic!("{seed}: {law}: {error:?}"));
            let [volume, expected] = [mesh.volume(), other.volume()];
            assert!((volume - expected).abs() < 1e-6, "{seed}: {law}: {volume} and {expected}");
            assert!(mesh.is_empty() || mesh.is_closed(), "{seed}: {law}");
            assert_eq!(mesh.check(), [], "{seed}: {law}");
        };
        equal(Union, &made.left, &made.common, &a, "A without B, with the common part");
        equal(Union, &made.left, &b, &made.union, "A without B, with B");
        equal(Subtract, &made.union, &b, &made.left, "both without B");
        equal(Intersect, &made.union, &a, &a, "the common part of both and A");
        equal(Subtract, &made.left, &b, &made.left, "A without B, without B again");
        equal(Intersect, &made.left, &made.right, &Mesh::default(), "what is in neither common part");
        equal(Union, &made.common, &made.union, &made.union, "the common part with both");
    }
}

#[test]
fn new_points_have_numbers_in_the_order_of_the_faces() {
    // The order in which crossings are found follows their coordinates, and so their rounding errors.
    let turned = DAffine3::from_axis_angle(DVec3::new(0.6, 0.8, 0.0), 0.7);
    let [a, b] = [block([0.0; 3], [4.0; 3]), block([1.0; 3], [5.0, 6.0, 3.0]).map(&turned)];
    for op in [Union, Intersect, Subtract] {
        let made = combined(op, &a, &b).expect("a solid");
        let is_old = |point: &DVec3| a.points().contains(point) || b.points().contains(point);
        let old = made.points().iter().take_while(|point| is_old(point)).count();
        let mut next = old;
        for point in made.corners().iter().map(|&point| point as usize).filter(|point| old <= *point) {
            assert!(point <= next, "{op:?}: {point} before {next}");
            next = next.max(point + 1);
        }
        assert!(next == made.points().len() && old + 5 < next, "{op:?}");
    }
}
