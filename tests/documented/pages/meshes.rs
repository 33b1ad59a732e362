//! Meshes that the documents insert from files, made here: a lying cylinder, a tube, a sphere.

use cga::mesh::FaceTag;
use cga::{Mesh, MeshBuilder};

/// Points on a circle about the x axis, counter-clockwise seen from +x, beginning on top.
fn circle(builder: &mut MeshBuilder, sides: u32, radius: f64, x: f64) -> Vec<u32> {
    let point = |at: u32| {
        let angle = std::f64::consts::TAU * f64::from(at) / f64::from(sides);
        [x, radius * libm::cos(angle), radius * libm::sin(angle)]
    };
    (0..sides).map(|at| builder.point(point(at))).collect()
}

/// Four-sided faces from one circle to another. They look outwards when `low` has the smaller x.
fn wall(builder: &mut MeshBuilder, low: &[u32], high: &[u32]) {
    for at in 0..low.len() {
        let next = (at + 1) % low.len();
        builder.face(&[low[at], low[next], high[next], high[at]], &[], FaceTag::PLAIN);
    }
}

fn reversed(ring: &[u32]) -> Vec<u32> {
    ring.iter().rev().copied().collect()
}

/// "cylinder.hor.obj": a closed cylinder from x = 0 to `length`: side faces, then the ends.
///
/// # Panics
/// For fewer than three sides or numbers that are not finite.
pub(crate) fn lying_cylinder(sides: u32, radius: f64, length: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let [low, high] = [0.0, length].map(|x| circle(&mut builder, sides, radius, x));
    wall(&mut builder, &low, &high);
    builder.face(&reversed(&low), &[], FaceTag::PLAIN);
    builder.face(&high, &[], FaceTag::PLAIN);
    builder.build().expect("a cylinder")
}

/// A hollow cylinder from x = 0 to `length`: its ends are rings.
///
/// # Panics
/// For fewer than three sides or numbers that are not finite.
pub(crate) fn lying_tube(sides: u32, radii: [f64; 2], length: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let [[inner_low, inner_high], [low, high]] =
        radii.map(|radius| [0.0, length].map(|x| circle(&mut builder, sides, radius, x)));
    wall(&mut builder, &low, &high);
    wall(&mut builder, &reversed(&inner_low), &reversed(&inner_high));
    builder.face(&reversed(&low), &[&inner_low], FaceTag::PLAIN);
    builder.face(&high, &[&reversed(&inner_high)], FaceTag::PLAIN);
    builder.build().expect("a tube")
}

/// A ball of that many faces around and from pole to pole, about the y axis.
///
/// # Panics
/// For fewer than three sides, fewer than two rows or a radius that is not finite.
pub(crate) fn sphere(sides: u32, rows: u32, radius: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut ring = |row: u32| -> Vec<u32> {
        let down = std::f64::consts::PI * f64::from(row) / f64::from(rows);
        let (y, out) = (radius * libm::cos(down), radius * libm::sin(down));
        let around = |at: u32| std::f64::consts::TAU * f64::from(at) / f64::from(sides);
        let pole = row == 0 || row == rows;
        let count = if pole { 1 } else { sides };
        (0..count).map(|at| builder.point([out * libm::sin(around(at)), y, out * libm::cos(around(at))])).collect()
    };
    let rings: Vec<Vec<u32>> = (0..=rows).map(&mut ring).collect();
    for pair in rings.windows(2) {
        for at in 0..sides as usize {
            let on = |ring: &[u32], at: usize| ring[at % ring.len()];
            let mut face = vec![on(&pair[1], at), on(&pair[1], at + 1), on(&pair[0], at + 1), on(&pair[0], at)];
            face.dedup();
            builder.face(&face, &[], FaceTag::PLAIN);
        }
    }
    builder.build().expect("a sphere")
}
