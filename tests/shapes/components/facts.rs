//! *comp operation* and *comp function*: the numbers of components, in pictures and examples. `tests/documented/faces.rs` has the
//! angles of directions and the frames.

use cga::{Shape, cga};

use super::{lines, mesh, run, square};

cga! {
    @Allow(rule_not_reached)
    grammar Facts = r#"
    @StartRule
    Cube --> primitiveCube() comp(f) { front : Note("Front") | side : Note("Side") | all = Note("All") }
    Note(name) --> print(name + " " + comp.sel + " " + comp.index + " of " + comp.total + ", " + geometry.nFaces) X.

    Each --> extrude(10) comp(f) { front : Front. | all = Mass. }
    Together --> extrude(10) comp(f) { front = Front. | all = Mass. }
    Connected --> extrude(10) comp(f) { front =: print(comp.index + " of " + comp.total) Front. | all = Mass. }

    TopFirst --> comp(f) { top : A. | side : B. }
    SideFirst --> comp(f) { side : B. | top : A. }

    Indices --> comp(f) { 0 : X. | 2 : X. | 4 : X. }

    const numbers = comp(v) { all : comp.index }
    Vertices --> print(numbers) X.

    edgeLength = scope.sx
    const lengths = comp(e) { border : edgeLength }
    Edges --> print(comp(e) { border : rint(edgeLength) }) print(size(lengths)) print(rint(lengths[6])) X.

    const names = comp(fe) { front : comp.sel + comp.index | back = str(comp.index) }
    FaceEdges --> print(names) X.

    SetbackDistances --> print(comp(fe) { all : case comp.index%2 == 0 : 1
                                                 else                   : 6 })
                         print(comp(fe) { inside = 0   |
                                          front  :
                                            case comp.index == 0 : 4
                                            else                 : 5 |
                                          back   = 2   |
                                          side   = 0.5 }) X.

    Quad --> print(comp(fe) { front=5 | right=5 }) X.
    "#;
}

#[test]
fn attributes_of_components_are_per_selector() {
    let model = run(&Facts::default(), "Cube", &Shape::cuboid(1.0, 1.0, 1.0));
    assert_eq!(
        lines(&model),
        [
            "Front front 0 of 1, 1",
            "Side side 0 of 3, 1",
            "Side side 1 of 3, 1",
            "Side side 2 of 3, 1",
            "All all 0 of 1, 2",
        ]
    );
}

/// A lot with two wings, each with a bent front of three walls; the middle one of the first wing is the lot's front.
fn wings() -> Shape {
    let wing = |x: f64| [[x + 1.0, 10.4], [x + 3.0, 10.4], [x + 4.0, 10.0]];
    let outline = [&wing(0.0)[..], &[[5.0, 2.0], [6.0, 10.0]], &wing(6.0), &[[10.0, 0.0], [0.0, 0.0], [0.0, 10.0]]];
    let outline = outline.concat();
    Shape::footprint(&outline, &[]).expect("an outline")
}

#[test]
fn six_front_faces_are_six_shapes_or_one_or_two() {
    let counts = |rule: &str| {
        let model = run(&Facts::default(), rule, &wings());
        let fronts = model.counts().into_iter().find(|(name, _)| *name == "Front");
        (fronts.map(|(_, count)| count), model.len())
    };
    assert_eq!(counts("Each"), (Some(6), 7));
    assert_eq!(counts("Together"), (Some(1), 2));
    assert_eq!(counts("Connected"), (Some(2), 3));
    assert_eq!(lines(&run(&Facts::default(), "Connected", &wings())), ["0 of 2", "1 of 2"]);
}

#[test]
fn a_steep_roof_goes_to_the_first_arm() {
    let (sin, cos) = (libm::sin(60f64.to_radians()), libm::cos(60f64.to_radians()));
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|[x, up]| [x, up * cos, -up * sin]);
    let roof = Shape::mesh_axis_aligned(mesh(&corners, &[&[0, 1, 2, 3]]));
    assert_eq!(run(&Facts::default(), "TopFirst", &roof).counts(), [("A", 1)]);
    assert_eq!(run(&Facts::default(), "SideFirst", &roof).counts(), [("B", 1)]);
}

#[test]
fn indices_select_exactly_these_faces() {
    let cube = Shape::cuboid(1.0, 2.0, 3.0);
    let model = run(&Facts::default(), "Indices", &cube);
    let faces = cube.to_mesh();
    let normals: Vec<[f64; 3]> = model.leaves().map(|leaf| leaf.scope().axes.z_axis.to_array()).collect();
    let expected = [0, 2, 4].map(|face| faces.face(face).normal().to_array());
    assert_eq!(normals, expected);
}

#[test]
fn vertices_by_number() {
    let corners = [[0.0, 0.0], [2.0, 0.0], [3.0, 1.0], [2.0, 2.0], [0.0, 2.0], [-1.0, 1.0]].map(|[x, z]| [x, 0.0, -z]);
    let six = Shape::mesh(mesh(&corners, &[&[0, 1, 2, 3, 4, 5]]));
    assert_eq!(lines(&run(&Facts::default(), "Vertices", &six)), ["(6)[0,1,2,3,4,5]"]);
}

/// The sides of two quadrangles that share edge 2, in the order of edges: 7, 15, (15), 17, and 15, 10, 16.
fn quadrangles() -> Shape {
    let (e, d) = ([7.0, 30.0], [-8.0, 15.0]);
    let far: f64 = 450.0; // From `d` to `e`, squared.
    let along = (far + 16.0 * 16.0 - 10.0 * 10.0) / (2.0 * far);
    let off = libm::sqrt(16.0 * 16.0 / far - along * along);
    let f = [d[0] + along * (e[0] - d[0]) - off * (e[1] - d[1]), d[1] + along * (e[1] - d[1]) + off * (e[0] - d[0])];
    let points = [[0.0, 0.0], [7.0, 0.0], [7.0, 15.0], d, e, f].map(|[x, y]| [x, y, 0.0]);
    Shape::mesh(mesh(&points, &[&[0, 1, 2, 3], &[3, 2, 4, 5]]))
}

#[test]
fn an_edge_that_is_not_selected_is_zero() {
    let model = run(&Facts::default(), "Edges", &quadrangles());
    assert_eq!(lines(&model), ["(7)[7,15,0,17,15,10,16]", "7", "16"]);
}

#[test]
fn face_edges_put_together_are_computed_once() {
    let points = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0], [2.0, 1.0], [2.0, 0.0]].map(|[x, z]| [x, 0.0, z]);
    let two = Shape::mesh(mesh(&points, &[&[0, 1, 2, 3], &[4, 5, 2, 1]]));
    assert_eq!(lines(&run(&Facts::default(), "FaceEdges", &two)), ["(8)[front0,,0,,,0,,front1]"]);
}

#[test]
fn edges_of_two_faces_are_counted_through() {
    let points = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0], [2.0, 1.0], [2.0, 0.0], [1.5, -0.3]];
    let points = points.map(|[x, z]| [x, 0.0, z]);
    let two = Shape::mesh(mesh(&points, &[&[0, 1, 2, 3], &[1, 4, 5, 6, 2]]));
    let found = lines(&run(&Facts::default(), "SetbackDistances", &two));
    assert_eq!(found, ["(9)[1,6,1,6,1,6,1,6,1]", "(9)[4,0,2,0.5,5,0.5,2,2,0]"]);
}

#[test]
fn what_no_selector_takes_is_zero() {
    assert_eq!(lines(&run(&Facts::default(), "Quad", &square())), ["(4)[5,5,0,0]"]);
    assert_eq!(lines(&run(&Facts::default(), "Quad", &Shape::rectangle(1.0, 1.0))), ["(4)[5,5,0,0]"]);
}
