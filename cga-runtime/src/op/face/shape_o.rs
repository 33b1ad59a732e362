//! `shapeO`: all edges set back.

use std::ops::ControlFlow;

use crate::comp::select::Word;
use crate::comp::{Arms, Faces};
use crate::op::face::swept_edges::set_back;
use crate::run::env::Env;

/// `shapeO(frontWidth, rightWidth, backWidth, leftWidth) { shape : … | remainder : … }`: the edges of each face that face the
/// scope's front, right, back and left are set back by these distances in metres, as by [`shape_l`](fn@crate::op::shape_l) (*shapeL,
/// shapeU, shapeO operations*). If a court is left, the `shape` is a face with a hole.
pub fn shape_o(
    env: &mut Env,
    arms: &mut Arms<'_>,
    front: f64,
    right: f64,
    back: f64,
    left: f64,
) -> ControlFlow<(), Faces> {
    set_back(
        env,
        arms,
        "`shapeO`",
        &[(Word::Front, front), (Word::Right, right), (Word::Back, back), (Word::Left, left)],
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::op::face::swept_edges::tests::divided_by;
    use crate::shape::Shape;

    #[test]
    fn an_o_of_a_square_is_a_ring() {
        let (faces, _) = divided_by(&Shape::rectangle(20.0, 20.0), |env, arms| shape_o(env, arms, 4.0, 4.0, 4.0, 4.0));
        assert_eq!(faces, [(0, 8, 256.0), (1, 4, 144.0)]);
    }

    #[test]
    fn widths_are_those_of_front_right_back_and_left() {
        let env = &mut Env::for_tests();
        let (shape, mut never) = (Shape::rectangle(20.0, 10.0), crate::comp::never);
        let mut arms = Arms::new(&shape, &crate::op::face::swept_edges::tests::ARMS, &mut never);
        let ControlFlow::Continue(made) = shape_o(env, &mut arms, 1.0, 2.0, 3.0, 4.0) else {
            panic!("no limit is reached")
        };
        let [ring, court] = [0, 1].map(|face| made.mesh.face(face));
        assert_eq!((ring.holes().len(), ring.area(), court.area()), (1, 200.0 - 14.0 * 6.0, 14.0 * 6.0));
        // The scope's z axis points to the front.
        let corners: Vec<[f64; 2]> = court.outline().map(|at| [at.x, at.z]).collect();
        assert_eq!(corners, [[4.0, 9.0], [18.0, 9.0], [18.0, 3.0], [4.0, 3.0]]);
    }

    #[test]
    fn thin_lots_leave_no_court() {
        let (faces, faults) =
            divided_by(&Shape::rectangle(20.0, 5.0), |env, arms| shape_o(env, arms, 5.0, 3.0, 2.0, 11.0));
        assert_eq!((faces, faults), (vec![(0, 4, 100.0)], 0));
    }
}
