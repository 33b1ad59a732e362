//! *resetGeometry*, *deleteHoles* and the operations that change the mesh of a shape.

use cga::{Model, Settings, Shape, cga};

use cga_tests::pages::mesh_operations as pages;

cga! {
    grammar Operations = r##"
    # Parts that are cut are joined to their neighbours again.
    @StartRule
    Recomposed --> extrude(3) inline(recompose) comp(f) { all : convexify X. } Whole.
    "##;
}

fn run(rule: &str, shape: &Shape) -> Model {
    let model = Operations::default().generate_from(rule, shape).expect("a model");
    assert!(model.faults().is_empty(), "{rule}: {:?}", model.faults());
    model
}

fn l() -> Shape {
    let outline = [[0.0, 10.0], [10.0, 10.0], [10.0, 5.0], [5.0, 5.0], [5.0, 0.0], [0.0, 0.0]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

/// The parts of the picture, with its colours: "one of the resulting polygons might still be concave".
#[test]
fn lots_are_cut_as_in_the_picture() {
    let example = pages::convexify::EXAMPLE;
    let model = example.model(&Settings::default());
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    let colours =
        |red: f64| model.leaves().filter(move |leaf| leaf.material().color.is_some_and(|color| color.r == red));
    assert_eq!((model.len(), colours(1.0).count(), colours(0.0).count()), (10, 6, 4));
    let area: f64 = model.leaves().map(|leaf| leaf.area()).sum();
    assert!((area - (example.start)().to_mesh().area()).abs() < 1e-9);
    // The comb keeps its wide notch, the others are convex.
    let corners = model.leaves().map(|leaf| leaf.mesh().0.face(0).outer().len()).max();
    assert_eq!(corners, Some(14));
}

#[test]
fn faces_that_are_cut_one_by_one_are_connected_again() {
    let model = run("Recomposed", &l());
    let (mesh, _) = model.leaves_of("Whole").next().expect("a leaf").mesh();
    assert_eq!((mesh.face_count(), mesh.is_closed()), (10, true));
    assert_eq!(mesh.check(), []);
}

/// "Each setback shall be applied wrt. the initial shape." "Note how shape attributes (here the color) are not changed."
#[test]
fn floors_are_set_back_from_the_initial_shape() {
    let example = pages::reset_setbacks::EXAMPLE;
    let lot = (example.start)();
    let model = example.model(&Settings::default());
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    let inset = |distance: f64| {
        let inset = cga::cga! { Lot --> offset(-#distance, inside) X. };
        inset.generate(&lot).expect("a model").leaves().map(|leaf| leaf.area()).sum::<f64>()
    };
    let mut sum = 0.0;
    let floors: Vec<_> = model.leaves().collect();
    assert!(3 < floors.len());
    for (floor, leaf) in floors.iter().enumerate() {
        let number = floor as f64;
        assert_eq!((leaf.scope().origin.y, leaf.size().y), (10.0 * number, 10.0));
        let area = leaf.mesh().0.volume() / 10.0;
        let expected = if floor == 0 { lot.to_mesh().area() } else { inset(3.0 * number) };
        assert!((area - expected).abs() < 1e-9 * expected, "floor {floor}: {area} instead of {expected}");
        sum += area;
        let material = leaf.material();
        assert_eq!(material.opacity, Some(if 5000.0 < sum { 0.1 } else { 1.0 }));
        assert_eq!(material.color, floors[0].material().color);
    }
    // Two floors fit, as in the picture.
    assert_eq!(floors.iter().filter(|floor| floor.material().opacity == Some(1.0)).count(), 2, "{sum}");
    assert_eq!(floors.len(), 7);
}

/// "Aligns edges to the scope such that they are parallel or perpendicular to each other."
#[test]
fn a_lot_gets_right_angles() {
    let model = pages::rectify::EXAMPLE.model(&Settings::default());
    assert!(model.faults().is_empty());
    let (mesh, _) = model.leaves_of("ShowRect").next().expect("a lot").mesh();
    assert_eq!((mesh.points().len(), mesh.check()), (10, Vec::new()));
    for face in mesh.faces() {
        let ring = face.outer();
        for (k, &point) in ring.iter().enumerate() {
            let step = mesh.points()[ring[(k + 1) % ring.len()] as usize] - mesh.points()[point as usize];
            assert!(step.abs().min_element() < 1e-9 && [step.x, step.z].iter().any(|along| along.abs() < 1e-9));
        }
    }
    // "As big as" the middles of its outer edges.
    let size = model.leaves_of("ShowRect").next().expect("a lot").scope().size;
    assert!((size.x - (23.75 - 2.65)).abs() < 1e-9 && (size.z - (20.55 - 3.75)).abs() < 1e-9, "{size}");
}

/// "A value of 0.2 will reduce the vertex count of the geometry by 20%."
#[test]
fn a_terrain_has_a_fifth_of_its_vertices() {
    let [before, after] = [pages::terrain::EXAMPLE, pages::terrain_reduced::EXAMPLE].map(|example| {
        let model = example.model(&Settings::default());
        assert!(model.faults().is_empty());
        model
    });
    let count = |model: &Model| model.leaves().next().expect("a leaf").mesh().0.points().len();
    assert_eq!([count(&before), count(&after)], [4096, 819]);
}
