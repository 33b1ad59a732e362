//! Meshes that the documents insert from files, made here: a lying cylinder, a tube, a sphere.

use cga::mesh::FaceTag;
use cga::{Color, Material, Mesh, MeshBuilder};

/// Points on a circle about the x axis, counter-clockwise seen from +x, beginning on top.
fn circle(builder: &mut MeshBuilder, sides: u32, radius: f64, x: f64) -> Vec<u32> {
    let point = |at: u32| {
        let angle = std::f64::consts::TAU * f64::from(at) / f64::from(sides);
        [x, radius * libm::cos(angle), radius * libm::sin(angle)]
    };
    (0..sides).map(|at| builder.point(point(at))).collect()
}

/// Four-sided faces from one ring to another. They look outwards if both rings are counter-clockwise, as seen from `high`.
pub(super) fn wall(builder: &mut MeshBuilder, low: &[u32], high: &[u32], tag: FaceTag) {
    for at in 0..low.len() {
        let next = (at + 1) % low.len();
        builder.face(&[low[at], low[next], high[next], high[at]], &[], tag);
    }
}

pub(super) fn reversed(ring: &[u32]) -> Vec<u32> {
    ring.iter().rev().copied().collect()
}

/// "cylinder.hor.obj": a closed cylinder from x = 0 to `length`: side faces, then the ends.
///
/// # Panics
/// For fewer than three sides or numbers that are not finite.
pub fn lying_cylinder(sides: u32, radius: f64, length: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let [low, high] = [0.0, length].map(|x| circle(&mut builder, sides, radius, x));
    wall(&mut builder, &low, &high, FaceTag::PLAIN);
    builder.polygon(&reversed(&low));
    builder.polygon(&high);
    builder.build().expect("a cylinder")
}

/// A hollow cylinder from x = 0 to `length`: its ends are rings.
///
/// # Panics
/// For fewer than three sides or numbers that are not finite.
pub fn lying_tube(sides: u32, radii: [f64; 2], length: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let [[inner_low, inner_high], [low, high]] =
        radii.map(|radius| [0.0, length].map(|x| circle(&mut builder, sides, radius, x)));
    wall(&mut builder, &low, &high, FaceTag::PLAIN);
    wall(&mut builder, &reversed(&inner_low), &reversed(&inner_high), FaceTag::PLAIN);
    builder.face(&reversed(&low), &[&inner_low], FaceTag::PLAIN);
    builder.face(&high, &[&reversed(&inner_high)], FaceTag::PLAIN);
    builder.build().expect("a tube")
}

/// A ball of that many faces around and from pole to pole, about the y axis.
///
/// # Panics
/// For fewer than three sides, fewer than two rows or a radius that is not finite.
pub fn sphere(sides: u32, rows: u32, radius: f64) -> Mesh {
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
            builder.polygon(&face);
        }
    }
    builder.build().expect("a sphere")
}

/// Adds a box by its lowest corner and its size.
pub fn block(builder: &mut MeshBuilder, low: [f64; 3], size: [f64; 3], tag: FaceTag) {
    let corner = |i: usize| [0, 1, 2].map(|axis| low[axis] + if i >> axis & 1 == 1 { size[axis] } else { 0.0 });
    let points: Vec<u32> = (0..8).map(|i| builder.point(corner(i))).collect();
    for face in [[4, 5, 7, 6], [5, 1, 3, 7], [1, 0, 2, 3], [0, 4, 6, 2], [6, 7, 3, 2], [0, 1, 5, 4]] {
        builder.face(&face.map(|i| points[i]), &[], tag);
    }
}

/// A trunk, a crown and three fruits: boxes, in groups and materials of the same names. As in the file of the page, the material
/// of the fruits is called `Foliage`.
///
/// # Panics
/// Never: its numbers are fine.
pub fn tree() -> Mesh {
    const PARTS: [(u32, [f64; 3], [f64; 3]); 5] = [
        (0, [-0.4, 0.0, -0.4], [0.8, 4.0, 0.8]),
        (1, [-2.5, 4.0, -2.5], [5.0, 4.0, 5.0]),
        (2, [2.5, 5.0, 1.0], [0.6, 0.6, 0.6]),
        (2, [-1.0, 6.5, 2.5], [0.6, 0.6, 0.6]),
        (2, [1.0, 5.5, 2.5], [0.6, 0.6, 0.6]),
    ];
    let names = [("Bark", [0.42, 0.29, 0.17]), ("Leaves", [0.3, 0.6, 0.23]), ("Foliage", [0.94, 0.54, 0.11])];
    let mut builder = MeshBuilder::new();
    builder.groups(names.map(|(name, _)| name.to_owned()));
    builder.materials(names.map(|(name, [r, g, b])| {
        let mut material = Material::default();
        (material.name, material.color) = (Some(name.into()), Some(Color::new(r, g, b)));
        material
    }));
    for (part, low, size) in PARTS {
        block(&mut builder, low, size, FaceTag { group: part, material: part, ..FaceTag::PLAIN });
    }
    builder.build().expect("a tree")
}

/// "building.obj": an open house with a wing, a porch and gable roofs whose eaves stick out. Walls, roofs and floors are separate
/// faces, as in a model made by hand.
///
/// # Panics
/// Never.
pub fn house() -> Mesh {
    let mut builder = MeshBuilder::new();
    // Walls around rectangles from x, z to x, z, up to a height.
    for ([x, z], [to_x, to_z], high) in
        [([0., 0.], [12., 8.], 4.), ([8., 8.], [12., 12.], 4.), ([3., 8.], [6., 10.], 0.5)]
    {
        let ring = [[x, to_z], [to_x, to_z], [to_x, z], [x, z]];
        for k in 0..4 {
            let ([ax, az], [bx, bz]) = (ring[k], ring[(k + 1) % 4]);
            let wall = [[ax, 0., az], [bx, 0., bz], [bx, high, bz], [ax, high, az]].map(|at| builder.point(at));
            builder.polygon(&wall);
        }
        let floor = ring.map(|[x, z]| builder.point([x, high.min(0.5), z]));
        builder.polygon(&floor);
    }
    // Gable roofs: the ridge along x over the house, along z over the wing.
    let mut roof = |corners: [[f64; 3]; 4]| {
        let face = corners.map(|at| builder.point(at));
        builder.polygon(&face);
    };
    roof([[-1., 3.5, 9.], [13., 3.5, 9.], [13., 6., 4.], [-1., 6., 4.]]);
    roof([[13., 3.5, -1.], [-1., 3.5, -1.], [-1., 6., 4.], [13., 6., 4.]]);
    roof([[7., 3.5, 13.], [10., 5., 13.], [10., 5., 6.], [7., 3.5, 6.]]);
    roof([[13., 3.5, 6.], [10., 5., 6.], [10., 5., 13.], [13., 3.5, 13.]]);
    builder.build().expect("a house")
}
