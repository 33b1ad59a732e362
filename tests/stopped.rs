//! Rules and shapes for the test and the bench of stopped runs.

use cga::glam::DVec2;
use cga::{Grammar as _, MeshBuilder, Shape, Text};

cga::cga! {
    pub grammar Every in "rules/one_operation.cga";
}

/// The names of the rules that have an operation each.
pub fn rules() -> Vec<Text> {
    let every = Every::default();
    every.start_rules().iter().map(|rule| rule.name.clone()).filter(|name| name.starts_with('R')).collect()
}

/// The bound of the units of work between two questions to the watch, of each rule of [`rules`] on each shape of [`shapes`].
/// `CGA_BLESS=1 cargo bench -p cga-tests --bench stopping` writes the file.
pub fn bounds() -> Vec<(&'static str, u64)> {
    let lines = include_str!("rules/one_operation_units.txt").lines();
    lines
        .map(|line| line.split_once(' ').expect("two words"))
        .map(|(rule, units)| (rule, units.parse().expect("a number")))
        .collect()
}

/// The largest bound of a rule: some milliseconds of work.
pub const MOST_UNITS: u64 = 1 << 21;

/// The number of corners of a shape.
const CORNERS: usize = 5_000;

/// A comb, a star, and a soup of triangles.
pub fn shapes() -> [Shape; 3] {
    let teeth = CORNERS / 4;
    let mut comb: Vec<[f64; 2]> = vec![[0.0, 0.0], [teeth as f64 * 0.02, 0.0]];
    for tooth in (0..teeth).rev() {
        let x = tooth as f64 * 0.02;
        comb.extend([[x + 0.02, 10.0], [x + 0.01, 10.0 + (tooth % 7) as f64], [x + 0.01, 1.0], [x, 1.0]]);
    }
    comb.truncate(CORNERS);
    let star: Vec<[f64; 2]> = (0..CORNERS)
        .map(|corner| {
            let (sin, cos) = libm::sincos(corner as f64 / CORNERS as f64 * std::f64::consts::TAU);
            let radius = if corner % 2 == 0 { 30.0 } else { 20.0 + (corner % 11) as f64 * 0.1 };
            [radius * cos, -radius * sin]
        })
        .collect();
    let mut state = 1u64;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 40) as f64 / (1 << 24) as f64
    };
    let points: Vec<[f64; 3]> = (0..CORNERS).map(|_| [random() * 20.0, random() * 20.0, random() * 20.0]).collect();
    let flat = |points: Vec<[f64; 2]>| Shape::footprint(&points, &[]).expect("an outline");
    let mut soup = MeshBuilder::new();
    for triangle in points.chunks_exact(3) {
        let corners: Vec<u32> = triangle.iter().map(|&corner| soup.point(corner)).collect();
        soup.polygon(&corners);
    }
    let soup = Shape::mesh(soup.build().expect("a mesh"));
    [flat(comb), flat(star), soup]
}

/// A closed sphere of `2 * rows * rows` faces with texture coordinates.
pub fn sphere(rows: usize) -> Shape {
    let sides = 2 * rows;
    let mut mesh = MeshBuilder::new();
    let mut point = |row: usize, side: usize| {
        let (up, out) = libm::sincos((row as f64 / rows as f64 - 0.5) * std::f64::consts::PI);
        let (sin, cos) = libm::sincos(side as f64 / sides as f64 * std::f64::consts::TAU);
        mesh.point([10.0 * out * cos, 10.0 * up, -10.0 * out * sin])
    };
    let poles = [[0.0, -10.0, 0.0], [0.0, 10.0, 0.0]];
    let rings: Vec<Vec<u32>> = (1..rows).map(|row| (0..sides).map(|side| point(row, side)).collect()).collect();
    let [bottom, top] = poles.map(|pole| mesh.point(pole));
    for row in 0..rows {
        for side in 0..sides {
            let corner = |row: usize, side: usize| match row {
                0 => bottom,
                row if row == rows => top,
                row => rings[row - 1][side % sides],
            };
            let uv = |row: usize, side: usize| DVec2::new(side as f64 / sides as f64, row as f64 / rows as f64);
            let mut all = vec![(row, side), (row, side + 1), (row + 1, side + 1), (row + 1, side)];
            if row == 0 {
                all.remove(0);
            } else if row + 1 == rows {
                all.remove(2);
            }
            let corners: Vec<u32> = all.iter().map(|&(row, side)| corner(row, side)).collect();
            let uvs: Vec<DVec2> = all.iter().map(|&(row, side)| uv(row, side)).collect();
            mesh.polygon(&corners).uvs(&uvs);
        }
    }
    Shape::mesh(mesh.build().expect("a mesh"))
}
