//! `shapeU`: all edges but the back ones set back.

use std::ops::ControlFlow;

use crate::comp::select::Word;
use crate::comp::{Arms, Faces};
use crate::op::face::swept_edges::set_back;
use crate::run::env::Env;

/// `shapeU(frontWidth, rightWidth, leftWidth) { shape : … | remainder : … }`: the edges of each face that face the scope's front,
/// right and left are set back by these distances in metres, as by [`shape_l`](fn@crate::op::shape_l) (*shapeL, shapeU, shapeO
/// operations*).
pub fn shape_u(env: &mut Env, arms: &mut Arms<'_>, front: f64, right: f64, left: f64) -> ControlFlow<(), Faces> {
    set_back(env, arms, "`shapeU`", &[(Word::Front, front), (Word::Right, right), (Word::Left, left)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::op::face::swept_edges::tests::{divided_by, polygon};
    use crate::shape::Shape;

    #[test]
    fn a_u_of_a_square_has_eight_corners() {
        // The remainder is 12 x 16 and lies at the back.
        let (faces, _) = divided_by(&Shape::rectangle(20.0, 20.0), |env, arms| shape_u(env, arms, 4.0, 4.0, 4.0));
        assert_eq!(faces, [(0, 8, 208.0), (1, 4, 192.0)]);
    }

    #[test]
    fn widths_are_those_of_front_right_and_left() {
        let widths = |shape: &Shape, [front, right, left]: [f64; 3]| {
            let (faces, faults) = divided_by(shape, |env, arms| shape_u(env, arms, front, right, left));
            assert_eq!(faults, 0);
            faces
        };
        let lot = Shape::rectangle(20.0, 10.0);
        assert_eq!(widths(&lot, [3.0, 0.0, 0.0])[0], (0, 4, 60.0));
        assert_eq!(widths(&lot, [3.0, 5.0, 2.0]), [(0, 8, 200.0 - 13.0 * 7.0), (1, 4, 13.0 * 7.0)]);
        // Without a front two strips are left.
        assert_eq!(widths(&lot, [0.0, 5.0, 2.0]), [(0, 4, 50.0), (0, 4, 20.0), (1, 4, 130.0)]);
        // Too wide for a court.
        assert_eq!(widths(&lot, [1.0, 15.0, 5.0]), [(0, 4, 200.0)]);
        // The right angle of a triangle is at the front and on the left.
        let triangle = polygon(&[[0.0, 0.0], [12.0, 0.0], [0.0, 4.0]]);
        let faces = widths(&triangle, [1.0, 0.0, 1.0]);
        // A triangle that is similar to the face: its legs are 12 - 3 - 1 and 4 - 1 - 1 / 3.
        assert!((faces[1].2 - 0.5 * 8.0 * 8.0 / 3.0).abs() < 1e-9, "{faces:?}");
    }
}
