use glam::DVec3;

use super::*;
use crate::comp::never;
use crate::op::face::swept_edges::tests::{ARMS, Parts, divided_by, polygon};
use crate::shape::Shape;

fn divided(shape: &Shape, front: f64, left: f64) -> (Parts, usize) {
    divided_by(shape, |env, arms| shape_l(env, arms, front, left))
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

/// A notch in the back: the strip of the front is cut by it, and the slopes of the notch face the sides.
#[test]
fn a_concave_face_has_an_l_too() {
    let shape = polygon(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [4.0, 2.0], [0.0, 8.0]]);
    let (faces, faults) = divided(&shape, 1.0, 0.0);
    assert_eq!((faces, faults), (vec![(0, 4, 8.0), (1, 5, 32.0)], 0));
    // The tip of the notch divides the remainder.
    let (faces, faults) = divided(&shape, 3.0, 0.0);
    let numbers: Vec<_> = faces.iter().map(|face| (face.0, face.1)).collect();
    assert_eq!((numbers, faults), (vec![(0, 7), (1, 3), (1, 3)], 0));
    assert!((faces[1].2 - 25.0 / 3.0).abs() < 1e-9 && (faces[2].2 - 25.0 / 3.0).abs() < 1e-9, "{faces:?}");
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
