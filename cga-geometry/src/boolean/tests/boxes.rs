//! Sequences of operations on boxes on a grid, so that faces and edges coincide everywhere. The truth is counted in voxels.

use glam::{DAffine3, DMat3, DVec3};

use super::{BooleanOp, block, combined};
use crate::mesh::Mesh;
use crate::random::Rng;
use crate::rotation::turn;

const SIZE: usize = 6;

/// The cells of a grid of unit cubes.
#[derive(Clone, PartialEq)]
struct Voxels(Vec<bool>);

impl Voxels {
    fn of_box(low: [usize; 3], high: [usize; 3]) -> Self {
        let inside = |i: usize, axis: u32| {
            let at = i / SIZE.pow(axis) % SIZE;
            low[axis as usize] <= at && at < high[axis as usize]
        };
        Voxels((0..SIZE.pow(3)).map(|i| (0..3).all(|axis| inside(i, axis))).collect())
    }

    fn combined(&self, op: BooleanOp, other: &Voxels) -> Self {
        let both = self.0.iter().zip(&other.0);
        Voxels(both.map(|(a, b)| op.keeps([*a, *b])).collect())
    }

    fn at(&self, [x, y, z]: [i64; 3]) -> bool {
        let size = SIZE as i64;
        let is_inside = [x, y, z].iter().all(|at| (0..size).contains(at));
        is_inside && self.0[(x + size * (y + size * z)) as usize]
    }

    fn volume(&self) -> f64 {
        self.0.iter().filter(|cell| **cell).count() as f64
    }

    /// The number of squares between cells of the solid and others.
    fn area(&self) -> f64 {
        let size = SIZE as i64;
        let mut count = 0;
        for i in 0..size.pow(3) {
            let cell = [i % size, i / size % size, i / size / size];
            if self.at(cell) {
                for axis in 0..3 {
                    for step in [-1, 1] {
                        let mut beside = cell;
                        beside[axis] += step;
                        count += u32::from(!self.at(beside));
                    }
                }
            }
        }
        f64::from(count)
    }
}

fn random_box(rng: &mut Rng) -> ([usize; 3], [usize; 3]) {
    let mut one = || {
        let [a, b] = [(); 2].map(|()| (rng.unit() * (SIZE as f64 + 1.0)) as usize % (SIZE + 1));
        if a == b { if a == SIZE { (a - 1, a) } else { (a, a + 1) } } else { (a.min(b), a.max(b)) }
    };
    let [x, y, z] = [one(), one(), one()];
    ([x.0, y.0, z.0], [x.1, y.1, z.1])
}

/// Runs sequences and returns the descriptions of the wrong ones.
fn wrong_sequences(place: &DAffine3, count: u64, first: u64) -> Vec<String> {
    use BooleanOp::{Intersect, Subtract, Union};
    let mut wrong = Vec::new();
    for seed in first..first + count {
        let rng = &mut Rng(seed);
        let mut next = || {
            let (low, high) = random_box(rng);
            let mesh = block(low.map(|x| x as f64), high.map(|x| x as f64));
            (mesh.map(place), Voxels::of_box(low, high))
        };
        let (mut mesh, mut voxels) = next();
        let ops = [Union, Union, Subtract, Union, if seed % 3 == 0 { Intersect } else { Subtract }];
        for (step, op) in ops.into_iter().enumerate() {
            let (other, cells) = next();
            let empty = Mesh::default();
            let a = if mesh.is_empty() { &empty } else { &mesh };
            match combined(op, a, &other) {
                Ok(made) => mesh = made,
                Err(error) => {
                    wrong.push(format!("{seed}, step {step}: {error:?}"));
                    break;
                }
            }
            voxels = voxels.combined(op, &cells);
            let [volume, area] = [mesh.volume(), mesh.area()];
            let flaws = mesh.check();
            let is_right = (volume - voxels.volume()).abs() < 1e-4
                && (area - voxels.area()).abs() < 1e-4
                && flaws.is_empty()
                && (mesh.is_closed() || mesh.is_empty());
            if !is_right {
                wrong.push(format!(
                    "{seed}, step {step}: volume {volume} of {}, area {area} of {}, closed {}, {flaws:?}",
                    voxels.volume(),
                    voxels.area(),
                    mesh.is_closed()
                ));
                break;
            }
        }
    }
    wrong
}

fn count() -> u64 {
    std::env::var("BOOLEAN_SEQUENCES").ok().and_then(|count| count.parse().ok()).unwrap_or(40)
}

fn turned() -> DMat3 {
    turn(11.0, 17.0, 0.0)
}

#[test]
fn upright_boxes() {
    let wrong = wrong_sequences(&DAffine3::IDENTITY, count(), 1);
    assert!(wrong.is_empty(), "{} wrong: {wrong:#?}", wrong.len());
}

#[test]
fn turned_boxes() {
    let place = DAffine3 { matrix3: turned(), translation: DVec3::ZERO };
    let wrong = wrong_sequences(&place, count(), 1);
    assert!(wrong.is_empty(), "{} wrong: {wrong:#?}", wrong.len());
}

#[test]
fn turned_boxes_500_km_away() {
    let place = DAffine3 { matrix3: turned(), translation: DVec3::new(500_000.0, 12.3, -400_000.0) };
    let wrong = wrong_sequences(&place, count(), 1);
    assert!(wrong.is_empty(), "{} wrong: {wrong:#?}", wrong.len());
}
