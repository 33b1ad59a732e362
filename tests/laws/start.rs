//! Random start shapes and attributes, and the assets.

use crate::random::Random;
use cga::{Assets, Grammar, Mesh, MeshBuilder, Shape, Value};
use std::sync::Arc;

/// Distances from the origin.
const OFFSETS: [f64; 6] = [0.0, 3.717, -21.93, 117.3, -1013.7, 0.313];

/// Values of the attributes that are numbers.
const NUMBERS: [f64; 9] = [3.71, 1.37, 0.613, 0.2717, 2.171, 5.937, 0.913, 7.171, 0.0913];

/// Sets attributes; says which.
pub(crate) fn attributes(grammar: &mut dyn Grammar, random: &mut Random) -> String {
    let mut given = Vec::new();
    for name in ["a", "b", "c", "on"] {
        if random.below(3) == 0 {
            continue;
        }
        let value = if name == "on" { Value::Bool(random.below(2) == 0) } else { Value::Float(*random.pick(&NUMBERS)) };
        given.push(format!("{name} = {value}"));
        grammar.set(name, value).expect("an attribute of every grammar");
    }
    given.join(", ")
}

/// Makes a start shape; says which, as Rust code.
pub(crate) fn shape(random: &mut Random) -> (String, Shape) {
    // Sides in tenths of a millimetre.
    let most = *random.pick(&[2000, 200_000, 200_000, 200_000, 200_000, 3_000_000]);
    let [a, b, c] = [0; 3].map(|_| (300 + random.below(most)) as f64 / 1e4);
    let (mut text, mut shape) = match random.below(10) {
        0..4 => (format!("Shape::rectangle({a}, {b})"), Shape::rectangle(a, b)),
        4..7 => (format!("Shape::cuboid({a}, {b}, {c})"), Shape::cuboid(a, b, c)),
        _ => lot(a, b, random),
    };
    if random.below(2) == 0 {
        let offset = [0; 3].map(|_| *random.pick(&OFFSETS));
        text += &format!(".at({offset:?})");
        shape = shape.at(offset);
    }
    let seed = random.next() >> 32;
    (format!("{text}.seed({seed})"), shape.seed(seed))
}

/// A rectangle that is turned, as a footprint that begins at any corner and runs either way, often at streets.
fn lot(a: f64, b: f64, random: &mut Random) -> (String, Shape) {
    // Cosines and sines of angles.
    let [cos, sin] = *random.pick(&[[0.8, 0.6], [0.6, -0.8], [-0.28, 0.96], [0.0, 1.0], [-1.0, 0.0], [0.352, 0.936]]);
    let mut outline = [[0.0, 0.0], [a, 0.0], [a, b], [0.0, b]].map(|[x, z]| [x * cos - z * sin, x * sin + z * cos]);
    outline.rotate_left(random.below(4));
    if random.below(2) == 0 {
        outline.reverse();
    }
    let mut text = format!("Shape::footprint(&{outline:?}, &[]).unwrap()");
    let mut shape = Shape::footprint(&outline, &[]).expect("an outline");
    if random.below(2) == 0 {
        let widths = [0; 4].map(|_| *random.pick(&[0.0, 0.0, 7.3, 4.1]));
        text += &format!(".streets({widths:?})");
        shape = shape.streets(widths);
    }
    if random.below(3) == 0 {
        let uses = [0; 4].map(|_| *random.pick(&["street", "garden", "mark"]));
        text += &format!(".edge_attribute(\"tag\", {uses:?})");
        shape = shape.edge_attribute("tag", uses);
    }
    (text, shape)
}

/// Assets that grammars insert: a tetrahedron, and a box with an edge that is cut off by 0.7 mm.
pub(crate) fn assets() -> Arc<Assets> {
    let tree = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 2.0, 0.0], [0.5, 1.0, 0.7]];
    let tree = solid(&tree, &[&[0, 1, 2], &[1, 3, 2], &[3, 0, 2], &[1, 0, 3]]);
    // Seen from the front, and the same corners at the back.
    let front = [[0.0, 0.0], [1.3, 0.0], [1.3, 0.9995], [1.2995, 1.0], [0.0, 1.0]];
    let corners: Vec<[f64; 3]> = [1.0, 0.0].iter().flat_map(|z| front.map(|[x, y]| [x, y, *z])).collect();
    let sides = [[0, 5, 6, 1], [1, 6, 7, 2], [2, 7, 8, 3], [3, 8, 9, 4], [4, 9, 5, 0]];
    let mut faces: Vec<&[usize]> = vec![&[0, 1, 2, 3, 4], &[9, 8, 7, 6, 5]];
    faces.extend(sides.iter().map(|side| &side[..]));
    Arc::new(Assets::new().with("tree", tree).with("rough", solid(&corners, &faces)))
}

/// The mesh of some corners and faces.
fn solid(corners: &[[f64; 3]], faces: &[&[usize]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    let points: Vec<_> = corners.iter().map(|point| builder.point(*point)).collect();
    for face in faces {
        builder.polygon(&face.iter().map(|at| points[*at]).collect::<Vec<_>>());
    }
    builder.build().expect("a mesh")
}
