//! Meshes as initial shapes: scope and pivot follow the first edge of the first face (*CGA essentials*, object coordinate
//! system; *alignScopeToGeometryBBox operation*, initial shape).

use cga::glam::{DMat3, DQuat, DVec3};
use cga::{Mesh, MeshBuilder, Model, Shape, cga};

cga! {
    @Allow(undefined_rule)
    grammar Frames = r#"
        start Lot --> Lot.
        start Aligned --> alignScopeToGeometry(yUp, 0, 0) Lot.
        start Sides --> extrude(2) comp(f) { front : Front. | top : Top. | bottom : Bottom. | all = Rest. }
        start Slices --> split(x) { ~1 : Slice. }*
        start Says --> print(initialShape.origin.px) print(initialShape.origin.py) print(initialShape.origin.pz) print(scope.tx) print(scope.tz) Lot.
    "#;
}

/// A mesh of faces given by their corners.
fn faces(faces: &[&[[f64; 3]]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    for corners in faces {
        let ring: Vec<u32> = corners.iter().map(|corner| builder.point(*corner)).collect();
        builder.polygon(&ring);
    }
    builder.build().expect("a mesh")
}

/// The outline of the page's picture, turned by 40 degrees: a quarter of an octagon cut from a rectangle.
fn turned_outline() -> Vec<[f64; 3]> {
    let (sin, cos) = (libm::sin(0.7), libm::cos(0.7));
    let outline = [[0.0, 0.0], [6.0, 0.0], [9.0, -3.0], [9.0, -8.0], [-1.0, -8.0]];
    outline.map(|[x, z]| [20.0 + x * cos + z * sin, 5.0, -7.0 - x * sin + z * cos]).to_vec()
}

fn run(start: &str, shape: &Shape) -> Model {
    let model = Frames::default().generate_from(start, shape).expect("a model");
    assert_eq!(model.faults(), []);
    model
}

#[track_caller]
fn near(found: DVec3, expected: [f64; 3]) {
    assert!(found.abs_diff_eq(DVec3::from(expected), 1e-9), "{found}, not {expected:?}");
}

#[test]
fn a_lot_is_aligned_to_its_first_edge() {
    let outline = turned_outline();
    let shape = Shape::mesh(faces(&[&outline]));
    let (first, second) = (DVec3::from(outline[0]), DVec3::from(outline[1]));
    let (scope, pivot) = (shape.scope(), shape.pivot());
    near(pivot.origin, outline[0]);
    near(scope.axes.x_axis, ((second - first) / 6.0).to_array());
    near(scope.axes.y_axis, [0.0, 1.0, 0.0]);
    assert_eq!(pivot.axes, scope.axes);
    near(scope.size, [10.0, 0.0, 8.0]);
    assert_eq!(scope.size.y, 0.0, "flat, whatever was rounded");
    // The scope begins at the low corner of the box, 1 m left of the edge and 8 m behind it.
    near(pivot.to_local(scope.origin), [-1.0, 0.0, -8.0]);
    let said: Vec<f64> =
        run("Says", &shape).prints().iter().map(|line| line.to_string().parse().expect("a number")).collect();
    for (said, expected) in said.iter().zip([outline[0][0], outline[0][1], outline[0][2], -1.0, -8.0]) {
        assert!((said - expected).abs() < 1e-6, "{said}, not {expected}");
    }
}

#[test]
fn a_mesh_is_the_lot_of_its_outline() {
    // The same polygon by both ways: a footprint is turned to face up and keeps its first edge.
    for outline in [&turned_outline()[..], &[[1.0, 0.0, 4.0], [5.0, 0.0, 4.0], [5.0, 0.0, 1.0], [1.0, 0.0, 1.0]]] {
        let ground: Vec<[f64; 2]> = outline.iter().map(|corner| [corner[0], corner[2]]).collect();
        let lot = Shape::footprint(&ground, &[]).expect("a lot").at([0.0, outline[0][1], 0.0]);
        let mesh = Shape::mesh(faces(&[outline]));
        let (a, b) = (lot.scope(), mesh.scope());
        assert!(a.axes.abs_diff_eq(b.axes, 1e-9), "{} and {}", a.axes, b.axes);
        assert!(a.origin.abs_diff_eq(b.origin, 1e-9) && a.size.abs_diff_eq(b.size, 1e-9), "{a:?} and {b:?}");
        assert!(lot.pivot().origin.abs_diff_eq(mesh.pivot().origin, 1e-9));
        assert_eq!(run("Sides", &lot).counts(), run("Sides", &mesh).counts());
    }
}

/// A ramp: its only face rises to the back.
fn ramp() -> Mesh {
    faces(&[&[[0.0, 0.0, 3.0], [5.0, 0.0, 3.0], [5.0, 4.0, 0.0], [0.0, 4.0, 0.0]]])
}

#[test]
fn alignment_to_the_first_edge_changes_nothing() {
    // A prism whose first face leans, so that no axis is one of the world's.
    let [a, b, c, d] = [[0.1, 0.0, 3.3], [5.0, 0.7, 3.0], [4.7, 4.0, 0.2], [1.0, 0.3, -4.0]];
    let solid = faces(&[&[a, b, c], &[b, a, d], &[c, b, d], &[a, c, d]]);
    for mesh in [faces(&[&turned_outline()]), ramp(), solid] {
        let (shape, other) = (Shape::mesh(mesh.clone()), Shape::mesh_axis_aligned(mesh));
        let (plain, aligned, turned) = (run("Lot", &shape), run("Aligned", &shape), run("Aligned", &other));
        let scope = |model: &Model| model.leaves().next().expect("a leaf").scope();
        for model in [&aligned, &turned] {
            let (a, b) = (scope(&plain), scope(model));
            assert!(a.axes.abs_diff_eq(b.axes, 1e-9), "{} and {}", a.axes, b.axes);
            assert!(a.origin.abs_diff_eq(b.origin, 1e-9) && a.size.abs_diff_eq(b.size, 1e-9), "{a:?} and {b:?}");
        }
        assert!((plain.area() - turned.area()).abs() < 1e-9);
    }
}

#[test]
fn faces_that_stand_or_look_down_turn_the_scope() {
    let ramp = Shape::mesh(ramp());
    near(ramp.scope().axes.y_axis, [0.0, 0.6, 0.8]);
    near(ramp.scope().size, [5.0, 0.0, 5.0]);
    assert_eq!(ramp.scope().size.y, 0.0);
    let model = run("Sides", &ramp);
    // It grows along the normal, and its top is where that looks.
    near(model.leaves_of("Top").next().expect("the top").scope().axes.z_axis, [0.0, 0.6, 0.8]);

    let wall = Shape::mesh(faces(&[&[[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [4.0, 3.0, 2.0], [0.0, 3.0, 2.0]]]));
    near(wall.scope().axes.y_axis, [0.0, 0.0, 1.0]);
    near(wall.scope().axes.z_axis, [0.0, -1.0, 0.0]);
    near(wall.scope().size, [4.0, 0.0, 3.0]);
    near(wall.scope().origin, [0.0, 3.0, 2.0]);

    let ceiling = Shape::mesh(faces(&[&[[0.0, 3.0, 0.0], [4.0, 3.0, 0.0], [4.0, 3.0, 2.0], [0.0, 3.0, 2.0]]]));
    near(ceiling.scope().axes.y_axis, [0.0, -1.0, 0.0]);
    near(ceiling.pivot().origin, [0.0, 3.0, 0.0]);
    near(ceiling.scope().size, [4.0, 0.0, 2.0]);
}

#[test]
fn what_has_no_area_or_no_length_is_skipped() {
    let good = [[0.0, 0.0, 4.0], [0.0, 0.0, 0.0], [-3.0, 0.0, 0.0], [-3.0, 0.0, 4.0]];
    // A face without an area before the good one.
    let flat = [[7.0, 0.0, 0.0], [8.0, 0.0, 0.0], [9.0, 0.0, 0.0]];
    let shape = Shape::mesh(faces(&[&flat, &good]));
    near(shape.pivot().origin, good[0]);
    near(shape.scope().axes.x_axis, [0.0, 0.0, -1.0]);
    assert!(shape.scope().size.x > 3.9 && shape.scope().size.z > 11.9, "all faces are in the box");
    // A first edge without a length.
    let doubled: Vec<[f64; 3]> = [&good[..1], &good].concat();
    let shape = Shape::mesh(faces(&[&doubled]));
    near(shape.pivot().origin, good[0]);
    near(shape.scope().axes.x_axis, [0.0, 0.0, -1.0]);
    near(shape.scope().size, [4.0, 0.0, 3.0]);
    // Nothing to align to: the world's axes.
    for mesh in [Mesh::default(), faces(&[&flat]), faces(&[&[[1.0; 3]; 3]])] {
        let (found, expected) = (Shape::mesh(mesh.clone()), Shape::mesh_axis_aligned(mesh));
        assert_eq!(found.scope(), expected.scope());
        assert_eq!(found.pivot(), expected.pivot());
        let _ = Frames::default().generate_from("Slices", &found).expect("a model");
    }
    let mut points = MeshBuilder::new();
    points.point([3.0, 4.0, 5.0]);
    points.point([4.0, 4.0, 5.0]);
    let shape = Shape::mesh(points.build().expect("points alone"));
    near(shape.scope().axes.x_axis, [1.0, 0.0, 0.0]);
}

#[test]
fn any_size_and_place_gives_a_frame_or_an_error() {
    let outline = turned_outline();
    for size in [1e-300, 1e-160, 1e-30, 1e-7, 1.0, 1e7, 1e30, 1e150, 1e300] {
        for far in [0.0, 5e5, 1e12] {
            let moved: Vec<[f64; 3]> = outline.iter().map(|corner| corner.map(|at| at * size + far)).collect();
            let shape = Shape::mesh(faces(&[&moved]));
            for start in ["Lot", "Sides", "Slices"] {
                if let Ok(model) = Frames::default().generate_from(start, &shape) {
                    assert!(model.leaves().all(|leaf| leaf.scope().size.is_finite()), "{size} {far} {start}");
                }
            }
        }
    }
}

/// A polygon that no axis of the world is along: the outline, leaning by 0.4 and turned by 0.9.
fn leaning(outline: &[[f64; 2]], far: f64) -> Vec<[f64; 3]> {
    let turn = DQuat::from_rotation_y(0.9) * DQuat::from_rotation_x(0.4) * DQuat::from_rotation_z(-0.3);
    outline
        .iter()
        .map(|[x, z]| (turn * DVec3::new(*x, 0.0, *z) + far * DVec3::new(1.0, 0.1, -2.0)).to_array())
        .collect()
}

#[test]
fn a_lot_that_leans_is_flat() {
    let outline: Vec<[f64; 2]> =
        (0..12).map(|at| f64::from(at) * -0.5).map(|at| [7.0 * libm::cos(at), 3.0 * libm::sin(at)]).collect();
    for far in [0.0, 1.0, 5e5] {
        let shape = Shape::mesh(faces(&[&leaning(&outline, far)]));
        assert_eq!(shape.scope().size.y, 0.0, "{far}");
        assert!(
            (run("Lot", &shape).area() - run("Lot", &Shape::footprint(&outline, &[]).expect("a lot")).area()).abs()
                < 1e-6
        );
    }
    // Two faces that are not in one plane are not.
    let folded =
        faces(&[&leaning(&[[0.0, 0.0], [4.0, 0.0], [4.0, -3.0]], 0.0), &[[0.0; 3], [1.0, 5.0, 0.0], [0.0, 5.0, 1.0]]]);
    assert!(1.0 < Shape::mesh(folded).scope().size.y);
}

/// A face whose first edge leaves its plane nearly at a right angle, and comes back.
#[test]
fn a_bent_face_gives_axes_at_right_angles() {
    for slant in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15] {
        let mut corners = leaning(&[[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [1.0, -1.0], [0.0, -1.0]], 0.0);
        let out = DQuat::from_rotation_y(0.9) * DQuat::from_rotation_x(0.4) * DQuat::from_rotation_z(-0.3);
        corners[1] = (out * DVec3::new(slant, 1.0, 0.0)).to_array();
        let shape = Shape::mesh(faces(&[&corners]));
        let axes = shape.scope().axes;
        assert!((axes.transpose() * axes).abs_diff_eq(DMat3::IDENTITY, 1e-12), "{slant}: {axes}");
        assert_eq!(run("Lot", &shape).len(), 1, "{slant}");
    }
}

#[test]
fn corners_are_arrays_pairs_or_vectors() {
    use cga::glam::DVec2;
    let arrays = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [1.0, 5.0]];
    let pairs = arrays.map(|[x, z]| (x, z));
    let vectors = arrays.map(DVec2::from);
    let hole = [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0]];
    let mesh = |shape: Result<Shape, cga::Error>| shape.expect("a footprint").to_mesh();
    let first = mesh(Shape::footprint(&arrays, &[hole.to_vec()]));
    let points = |mesh: &cga::Mesh| format!("{mesh:?}");
    assert_eq!(points(&first), points(&mesh(Shape::footprint(&pairs, &[hole.map(|[x, z]| (x, z)).to_vec()]))));
    assert_eq!(points(&first), points(&mesh(Shape::footprint(&vectors, &[hole.map(DVec2::from).to_vec()]))));
    assert_eq!(first.area(), mesh(Shape::footprint(&vectors, &[])).area() - 0.5);
    assert!(Shape::footprint::<(f64, f64)>(&[], &[]).is_err());
}
