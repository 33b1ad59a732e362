use super::*;
use crate::geometry::mesh::Mesh;
use crate::shape::Shape;

const ARMS: [Arm; 2] = [
    Arm { select: Select::Word(Word::Shape), mode: Mode::Each, text: "shape" },
    Arm { select: Select::Word(Word::Remainder), mode: Mode::Each, text: "remainder" },
];

/// The corners and the area of each face, with its arm, and the number of faults.
fn divided(shape: &Shape, front: f64, left: f64) -> (Vec<(u32, usize, f64)>, usize) {
    let env = &mut Env::for_tests();
    let ControlFlow::Continue(made) = shape_l(env, &mut Arms::new(shape, &ARMS, &mut never), front, left) else {
        panic!("no limit is reached")
    };
    assert_eq!(made.mesh.check(), []);
    let faces = made.mesh.faces().zip(&made.arms);
    let faces = faces.map(|(face, arm)| (arm.expect("both are selected"), face.corner_count(), face.area()));
    (faces.collect(), env.take_faults().0.len())
}

fn polygon(corners: &[[f64; 2]]) -> Shape {
    let corners: Vec<DVec3> = corners.iter().map(|[x, z]| DVec3::new(*x, 0.0, -*z)).collect();
    Shape::mesh_axis_aligned(Mesh::from_polygon(&corners, &[]).expect("a polygon"))
}

#[test]
fn an_l_of_a_square_has_six_corners() {
    // 20 x 20: the strip has 144, the remainder 16 x 16.
    let (faces, _) = divided(&Shape::rectangle(20.0, 20.0), 4.0, 4.0);
    assert_eq!(faces, [(0, 6, 144.0), (1, 4, 256.0)]);
    let (faces, _) = divided(&Shape::rectangle(20.0, 10.0), 3.0, 5.0);
    assert_eq!(faces, [(0, 6, 200.0 - 15.0 * 7.0), (1, 4, 15.0 * 7.0)]);
}

#[test]
fn the_strip_lies_in_front_and_on_the_left() {
    let shape = Shape::rectangle(20.0, 10.0);
    let env = &mut Env::for_tests();
    let made = shape_l(env, &mut Arms::new(&shape, &ARMS, &mut never), 3.0, 5.0);
    let ControlFlow::Continue(made) = made else { panic!("no limit is reached") };
    let corners: Vec<DVec3> = made.mesh.face(1).outline().collect();
    // The scope's z axis points to the front.
    assert!(corners.iter().all(|at| 5.0 <= at.x && at.z <= 7.0), "{corners:?}");
}

#[test]
fn a_width_of_nothing_sets_nothing_back() {
    for width in [0.0, -2.0] {
        assert_eq!(divided(&Shape::rectangle(20.0, 10.0), width, width).0, [(1, 4, 200.0)]);
        assert_eq!(divided(&Shape::rectangle(20.0, 10.0), width, 5.0).0, [(0, 4, 50.0), (1, 4, 150.0)]);
    }
    let (faces, faults) = divided(&Shape::rectangle(20.0, 10.0), f64::NAN, 5.0);
    assert_eq!((faces.len(), faults), (2, 1));
}

#[test]
fn wide_strips_leave_no_remainder() {
    assert_eq!(divided(&Shape::rectangle(20.0, 10.0), 10.0, 5.0).0, [(0, 4, 200.0)]);
    assert_eq!(divided(&Shape::rectangle(20.0, 10.0), 30.0, 50.0).0, [(0, 4, 200.0)]);
}

#[test]
fn areas_of_convex_faces_add_up() {
    let lots: [&[[f64; 2]]; 3] = [
        &[[0.0, 0.0], [9.0, 1.0], [12.0, 7.0], [4.0, 11.0], [-2.0, 5.0]],
        &[[0.0, 0.0], [6.0, -2.0], [3.0, 8.0]],
        &[[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [8.0, 6.0], [0.0, 6.0], [0.0, 3.0]],
    ];
    for lot in lots {
        let shape = polygon(lot);
        for (front, left) in [(1.0, 1.0), (2.0, 0.5), (0.0, 2.0), (2.5, 2.5), (5.0, 1.0)] {
            let (faces, faults) = divided(&shape, front, left);
            let sum: f64 = faces.iter().map(|face| face.2).sum();
            assert!((sum - shape.to_mesh().area()).abs() < 1e-9, "{lot:?} {front} {left}: {faces:?}");
            assert!(faults == 0 && faces.iter().any(|face| face.0 == 0), "{faces:?}");
        }
    }
}

#[test]
fn concave_faces_stay_whole() {
    let shape = polygon(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [4.0, 2.0], [0.0, 8.0]]);
    let (faces, faults) = divided(&shape, 1.0, 1.0);
    assert_eq!((faces.len(), faces[0].0, faults), (1, 1, 1));
}

#[test]
fn texture_coordinates_continue_those_of_the_face() {
    let env = &mut Env::for_tests();
    let mut shape = Shape::rectangle(20.0, 10.0);
    crate::op::setup_projection(env, &mut shape, 0.0, crate::op::ProjectionAxes::ScopeXz, size(20.0), size(10.0));
    crate::op::project_uv(env, &mut shape, 0.0);
    shape.bake();
    let ControlFlow::Continue(made) = shape_l(env, &mut Arms::new(&shape, &ARMS, &mut never), 3.0, 5.0) else {
        panic!("no limit is reached")
    };
    for (corner, uv) in made.mesh.corners().iter().zip(made.mesh.uv_set(0)) {
        let at = made.mesh.points()[*corner as usize];
        assert!((uv.x - at.x / 20.0).abs() < 1e-9 && (uv.y - at.z / 10.0).abs() < 1e-9, "{at} {uv}");
    }
}

fn size(metres: f64) -> cga_split::Size {
    cga_split::Size::absolute(metres)
}

#[test]
fn an_arm_is_found_for_each_edge() {
    // As `setback` will ask: the first arm that selects the edge, with indices and words.
    let arms = [
        Arm { select: Select::Index(2.0), mode: Mode::Each, text: "2" },
        Arm { select: Select::Word(Word::Remainder), mode: Mode::Each, text: "remainder" },
        Arm { select: Select::Word(Word::All), mode: Mode::Each, text: "all" },
    ];
    let (env, shape) = (&mut Env::for_tests(), Shape::rectangle(2.0, 1.0));
    let mut never = never;
    let mut arms = Arms::new(&shape, &arms, &mut never);
    assert_eq!((arms.of(Word::Remainder), arms.of(Word::Shape)), (Some(1), None));
    assert_eq!(arms.edges(env), ControlFlow::Continue(vec![Some(2), Some(2), Some(0), Some(2)]));
}
