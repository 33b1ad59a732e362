//! The component split from rules to shapes and values: selectors as conditions, operators, `comp` in expressions. The
//! tests of `cga-runtime/src/comp` check which components a word selects, and the scopes of their shapes.

mod conditions;
mod facts;
mod groups;
mod order;
mod propagated;
mod tags;
mod values;

use cga::{Grammar, Mesh, MeshBuilder, Model, Shape};

/// Faces without holes, with points that are shared by number.
fn mesh(points: &[[f64; 3]], faces: &[&[usize]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    let points: Vec<u32> = points.iter().map(|point| builder.point(*point)).collect();
    for face in faces {
        let outer: Vec<u32> = face.iter().map(|&corner| points[corner]).collect();
        builder.polygon(&outer);
    }
    builder.build().expect("a mesh")
}

/// A square that lies flat; its edges face front, right, back and left.
fn square() -> Shape {
    Shape::mesh(mesh(&[[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]], &[&[0, 1, 2, 3]]))
}

/// The model of a start rule; nothing went wrong.
fn run(grammar: &dyn Grammar, start: &str, shape: &Shape) -> Model {
    let settings = cga::Settings { start: Some(start.to_owned()), ..cga::Settings::default() };
    let model = grammar.generate_with(shape, &settings).expect("a model");
    assert_eq!(model.faults(), []);
    model
}

/// The texts of all prints.
fn lines(model: &Model) -> Vec<String> {
    model.prints().iter().map(ToString::to_string).collect()
}
