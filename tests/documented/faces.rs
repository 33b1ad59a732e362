//! *comp operation*, *comp attribute*: which faces a selector takes, in which order, and where their shapes stand.

use cga::{Mesh, MeshBuilder, Model, Shape, cga};

use cga_tests::pages::meshes;

cga! {
    @Allow(undefined_rule)
    grammar Comp = r#"
    # comp attribute
    @StartRule
    Cube --> primitiveCube() comp(f) { front : Note | side : Note | all = Note }
    Note --> set(material.name, comp.sel + " " + comp.index + " of " + comp.total) Note.

    # comp operation, Index-based Selection
    @StartRule
    Indices --> comp(f) {
          0 : X |
          2 : X |
          4 : X
       }

    # A roof of 60 degrees is top and side: the first one has it.
    @StartRule
    TopFirst --> comp(f){ top:A | side:B }
    @StartRule
    SideFirst --> comp(f){ side:B | top:A }

    @StartRule
    Slope --> comp(f) { horizontal : Horizontal. | aslant : Aslant. | vertical : Vertical. | nutant : Nutant. }

    # Where the pivot of a face is: the scope is moved there.
    @StartRule
    Pivots --> comp(f) { all : set(scope.tx, 0) set(scope.ty, 0) set(scope.tz, 0) P. }
    @StartRule
    Faces --> comp(f) { all : P. }

    # Cut across each axis; the selectors take the faces that are cut.
    @StartRule
    CutX --> split(x) { ~1 : FrontBack | ~1 : FrontBack | ~1 : FrontBack }
    FrontBack --> comp(f) { front : Wall. | back : Wall. }
    @StartRule
    CutY --> split(y) { ~1 : Sides | ~1 : Sides | ~1 : Sides }
    Sides --> comp(f) { side : Wall. }
    @StartRule
    CutZ --> split(z) { ~1 : LeftRight | ~1 : LeftRight | ~1 : LeftRight }
    LeftRight --> comp(f) { left : Wall. | right : Wall. }
    "#;
}

fn run(rule: &str, shape: &Shape) -> Model {
    Comp::default().generate_from(rule, shape).unwrap()
}

#[test]
fn index_and_total_are_per_selector() {
    let model = run("Cube", &Shape::cuboid(1.0, 1.0, 1.0));
    let name = |material: &cga::Material| material.name.as_ref().map(ToString::to_string).unwrap_or_default();
    let names: Vec<_> = model.leaves().map(|leaf| name(leaf.material())).collect();
    assert_eq!(names, ["front 0 of 1", "side 0 of 3", "side 1 of 3", "side 2 of 3", "all 0 of 1"]);
    let last = model.leaves().next_back().unwrap();
    assert_eq!(last.mesh().0.face_count(), 2, "top and bottom");
    assert!((last.area() - 2.0).abs() < 1e-12);
}

#[test]
fn faces_by_number() {
    let mesh = meshes::lying_cylinder(6, 1.0, 3.0);
    let model = run("Indices", &Shape::mesh(mesh.clone()));
    assert_eq!(model.counts(), [("X", 3)]);
    let (low, six) = (mesh.bounds().low, [0, 2, 4]);
    for (leaf, index) in model.leaves().zip(six) {
        let face = mesh.face(index);
        assert!((leaf.scope().axes.z_axis - face.normal()).length() < 1e-9, "face {index}");
        let first = mesh.points()[face.outer()[0] as usize];
        assert!((leaf.scope().origin - first).length() < 1e-9, "face {index} from {low}");
    }
    // A number too large selects nothing.
    assert_eq!(run("Indices", &Shape::rectangle(1.0, 1.0)).len(), 1);
}

/// A square that leans: its normal is that many degrees above the horizon, to the front.
fn leaning(degrees: f64) -> Shape {
    let (sin, cos) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
    let mut builder = MeshBuilder::new();
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    let points = corners.map(|[x, up]| builder.point([x, up * cos, -up * sin]));
    builder.polygon(&points);
    Shape::mesh_axis_aligned(builder.build().unwrap())
}

#[test]
fn a_steep_roof_is_top_and_side() {
    assert_eq!(run("TopFirst", &leaning(60.0)).counts(), [("A", 1)]);
    assert_eq!(run("SideFirst", &leaning(60.0)).counts(), [("B", 1)]);
}

#[test]
fn slopes_have_their_borders_where_the_page_says() {
    let near = 0.005;
    for (degrees, rule) in [
        (78.75 - near, "Aslant"),
        (78.75 + near, "Horizontal"),
        (11.25 - near, "Vertical"),
        (11.25 + near, "Aslant"),
        (-11.25 + near, "Vertical"),
        (-11.25 - near, "Nutant"),
        (-78.75 + near, "Nutant"),
        (-78.75 - near, "Horizontal"),
        (90.0, "Horizontal"),
        (-90.0, "Horizontal"),
        (0.0, "Vertical"),
    ] {
        assert_eq!(run("Slope", &leaning(degrees)).counts(), [(rule, 1)], "{degrees}");
    }
}

/// A house with a gable: rectangles and two faces with five corners.
fn house() -> Mesh {
    let mut b = MeshBuilder::new();
    let gable = [[0.0, 0.0], [6.0, 0.0], [6.0, 3.0], [3.0, 5.0], [0.0, 3.0]];
    let [front, back] = [4.0, 0.0].map(|z| gable.map(|[x, y]| b.point([x, y, z])));
    b.polygon(&front);
    b.polygon(&[back[1], back[0], back[4], back[3], back[2]]);
    for at in 0..5 {
        let next = (at + 1) % 5;
        b.polygon(&[front[next], front[at], back[at], back[next]]);
    }
    b.build().unwrap()
}

#[test]
fn a_face_is_flat_along_z_and_starts_at_its_first_corner() {
    let mesh = house();
    assert!(mesh.is_closed() && 0.0 < mesh.volume());
    let (pivots, faces) = (run("Pivots", &Shape::mesh(mesh.clone())), run("Faces", &Shape::mesh(mesh.clone())));
    assert_eq!((pivots.len(), faces.len()), (7, 7));
    for ((pivot, leaf), face) in pivots.leaves().zip(faces.leaves()).zip(mesh.faces()) {
        let corners: Vec<_> = face.outer().iter().map(|&point| mesh.points()[point as usize]).collect();
        let (axes, size) = (leaf.scope().axes, leaf.size());
        assert_eq!(size.z, 0.0);
        assert!((axes.z_axis - face.normal()).length() < 1e-9);
        assert!((axes.x_axis - (corners[1] - corners[0]).normalize()).length() < 1e-9);
        assert!((axes.y_axis - axes.z_axis.cross(axes.x_axis)).length() < 1e-9);
        assert!((pivot.scope().origin - corners[0]).length() < 1e-9);
        assert!((leaf.area() - face.area()).abs() < 1e-9);
        // The scope is the box of the face.
        let reach = |axis: usize| {
            let along = corners.iter().map(|corner| (*corner - corners[0]).dot(axes.col(axis)));
            along.fold((0.0f64, 0.0f64), |(low, high), at| (low.min(at), high.max(at)))
        };
        for axis in [0, 1] {
            let (low, high) = reach(axis);
            assert!((size[axis] - (high - low)).abs() < 1e-9);
            assert!(((leaf.scope().origin - corners[0]).dot(axes.col(axis)) - low).abs() < 1e-9);
        }
    }
}

/// "Helps to preserve the first edge of the geometry" (changelog of 2025.1): a box that is a mesh is cut into faces that
/// stand like the faces of a box that is not a mesh, with x along what is left of the lower edge.
#[test]
fn cut_faces_keep_their_first_edge() {
    let plain = Shape::cuboid(3.0, 6.0, 9.0);
    let mesh = Shape::mesh_axis_aligned(plain.to_mesh().as_ref().clone());
    for (rule, count) in [("CutX", 6), ("CutY", 12), ("CutZ", 6)] {
        let (expected, found) = (run(rule, &plain), run(rule, &mesh));
        assert_eq!((expected.len(), found.len()), (count, count));
        for (a, b) in expected.leaves().zip(found.leaves()) {
            let (a, b) = (a.scope(), b.scope());
            assert!(a.axes.abs_diff_eq(b.axes, 1e-9), "{rule}: {} and {}", a.axes, b.axes);
            assert!(a.origin.abs_diff_eq(b.origin, 1e-9) && a.size.abs_diff_eq(b.size, 1e-9), "{rule}");
            assert_eq!(b.axes.y_axis.to_array(), [0.0, 1.0, 0.0], "{rule}");
        }
    }
}
