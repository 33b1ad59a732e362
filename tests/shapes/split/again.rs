//! A part that is divided again where it was divided: cuts follow edges.

use cga::{LeafView, Model, Shape, cga};

cga! {
    grammar Again = r#"
    @StartRule Once  --> extrude(6.3) comp(f) { side : Wall | all : NIL }
    @StartRule Twice --> extrude(6.3) comp(f) { side : inline { Wall } Wall | all : NIL }
    @StartRule Solid --> extrude(6.3) inline { Wall } Wall
    Wall --> split(x, noAdjust) { { { 0.31 : Post. | scope.sx * 0.2371 : Tile. }* }* | ~1.37 : Pane. }
    "#;
}

/// The rules of the leaves; and of each leaf its sizes, its area and its number of faces.
fn leaves(model: &Model) -> (Vec<String>, Vec<f64>) {
    let numbers = |leaf: LeafView<'_>| {
        let (mesh, _) = leaf.mesh();
        let area = mesh.faces().map(|face| face.area()).sum();
        [leaf.size().x, leaf.size().y, area, mesh.face_count() as f64]
    };
    (model.leaves().map(|leaf| leaf.rule().to_owned()).collect(), model.leaves().flat_map(numbers).collect())
}

/// A rectangle that is turned by an angle in degrees.
fn turned(width: f64, depth: f64, angle: f64) -> Shape {
    let (sin, cos) = (libm::sin(angle.to_radians()), libm::cos(angle.to_radians()));
    let corners = [[0.0, 0.0], [width, 0.0], [width, depth], [0.0, depth]];
    Shape::footprint(&corners.map(|[x, z]| [x * cos + z * sin, z * cos - x * sin]), &[]).expect("a rectangle")
}

#[test]
fn a_second_division_finds_the_edges_of_the_first() {
    for (width, depth, turn) in
        [(12.025, 10.6228, 0.0), (12.025, 10.6228, 17.31), (9.0385, 7.1, 45.0), (31.7, 0.9, 3.0)]
    {
        for offset in [[0.0; 3], [0.0, 0.0, 3.717], [-1013.7, 3.717, -21.93]] {
            let shapes = [turned(width, depth, turn).at(offset), Shape::rectangle(width, depth).at(offset)];
            for shape in shapes.iter().flat_map(|shape| [shape.clone(), shape.clone().held_as_meshes()]) {
                let run = |rule: &str| Again::default().generate_from(rule, &shape).unwrap();
                let [(rules, numbers), (others, its)] = ["Once", "Twice"].map(|rule| leaves(&run(rule)));
                assert_eq!(rules, others, "{width} {depth} {turn} {offset:?}");
                let is_near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-9;
                assert!(
                    numbers.iter().zip(&its).all(is_near),
                    "{width} {depth} {turn} {offset:?}: {numbers:?} {its:?}"
                );
                let solid = run("Solid");
                assert!(solid.leaves().all(|leaf| 1e-3 < leaf.mesh().0.volume()), "{width} {depth} {turn} {offset:?}");
            }
        }
    }
}

/// A tolerance in metres of the world would be larger than the mesh.
#[test]
fn a_tiny_mesh_far_away_is_divided() {
    for size in [1e-3, 1e-6, 1e-9] {
        let shape = Shape::cuboid(size, size, size).at([1e6, 0.0, -1e6]).held_as_meshes();
        let halves = cga! { Lot --> split(x, noAdjust) { ~1 : A. | ~1 : B. } };
        let model = halves.generate(&shape).unwrap();
        let volumes: Vec<f64> = model.leaves().map(|leaf| leaf.mesh().0.volume()).collect();
        assert_eq!(volumes.len(), 2);
        assert!(volumes.iter().all(|volume| 0.4 < volume / volumes.iter().sum::<f64>()), "{size}: {volumes:?}");
    }
}
