//! The directions of components (*comp operation*).

use glam::DVec3;

use super::unit;
use crate::geometry::tol::TIE_EPSILON;

/// A direction that selects components by their normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    /// +z.
    Front,
    /// Every direction except +z.
    NotFront,
    /// −z.
    Back,
    /// −x.
    Left,
    /// +x.
    Right,
    /// +y.
    Top,
    /// −y.
    Bottom,
    /// Not horizontal.
    Side,
    /// Up or down within 11.25 degrees.
    Horizontal,
    /// Upwards, between 11.25 and 78.75 degrees.
    Aslant,
    /// Within 11.25 degrees of the horizon.
    Vertical,
    /// Downwards, between 11.25 and 78.75 degrees.
    Nutant,
}

/// The sine of 11.25 degrees above the horizon: the end of `vertical`.
const LEVEL: f64 = 0.195_090_322_016_128_25;
/// The sine of 78.75 degrees above the horizon: the start of `horizontal`.
const STEEP: f64 = 0.980_785_280_403_230_4;

impl Direction {
    /// Returns true if a unit normal has this direction. Both are in the same axes.
    #[inline]
    pub(crate) fn takes(self, normal: DVec3) -> bool {
        match self {
            Direction::Front => quadrant(normal) == (2, true),
            Direction::NotFront => quadrant(normal) != (2, true),
            Direction::Back => quadrant(normal) == (2, false),
            Direction::Right => quadrant(normal) == (0, true),
            Direction::Left => quadrant(normal) == (0, false),
            Direction::Top => quadrant(normal) == (1, true),
            Direction::Bottom => quadrant(normal) == (1, false),
            Direction::Horizontal => is_horizontal(normal),
            Direction::Side => !is_horizontal(normal),
            Direction::Aslant => LEVEL < normal.y && normal.y <= STEEP,
            Direction::Vertical => -LEVEL < normal.y && normal.y <= LEVEL,
            Direction::Nutant => -STEEP < normal.y && normal.y <= -LEVEL,
        }
    }

    /// Returns true if the normal of a side of a box in those axes has this direction.
    #[inline]
    pub(crate) fn takes_side(self, side: unit::BoxSide) -> bool {
        let sides = match self {
            Direction::Front => 0b00_0001,
            Direction::NotFront => 0b11_1110,
            Direction::Right => 0b00_0010,
            Direction::Back => 0b00_0100,
            Direction::Left => 0b00_1000,
            Direction::Top => 0b01_0000,
            Direction::Bottom => 0b10_0000,
            Direction::Horizontal => 0b11_0000,
            Direction::Side | Direction::Vertical => 0b00_1111,
            Direction::Aslant | Direction::Nutant => 0,
        };
        sides >> side as u32 & 1 == 1
    }
}

/// The axis with the largest component of a normal, and true if that component is positive. Ties are decided in the
/// order z, x, y; in the pictures of the reference, rounding decides them.
#[inline]
fn quadrant(normal: DVec3) -> (usize, bool) {
    let size = normal.abs();
    // Rounding must not decide at 45 degrees, as at the mitres of an offset rectangle.
    let is_most = |a: f64, b: f64| b <= a + TIE_EPSILON;
    let axis = if is_most(size.z, size.x) && is_most(size.z, size.y) {
        2
    } else if is_most(size.x, size.y) {
        0
    } else {
        1
    };
    (axis, 0.0 < normal[axis])
}

/// The normal is in (78.75, 90] or [-90, -78.75] degrees.
#[inline]
fn is_horizontal(normal: DVec3) -> bool {
    STEEP < normal.y || normal.y <= -STEEP
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A normal that points up by some degrees.
    fn at(degrees: f64) -> DVec3 {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        DVec3::new(0.0, sin, cos)
    }

    #[test]
    fn sides_of_boxes_are_taken_as_their_normals_are() {
        use Direction::*;
        let all = [Front, Back, Right, Left, Top, Bottom, Horizontal, Side, Aslant, Vertical, Nutant];
        for side in unit::BoxSide::ALL {
            assert!(
                all.iter().all(|direction| direction.takes_side(side) == direction.takes(side.normal())),
                "{side:?}"
            );
        }
    }

    #[test]
    fn the_ends_of_the_angle_classes() {
        use Direction::{Aslant, Horizontal, Nutant, Side, Vertical};
        let classes = [
            (78.75, Aslant),
            (78.76, Horizontal),
            (11.25, Vertical),
            (11.26, Aslant),
            (-11.25, Nutant),
            (-11.24, Vertical),
            (-78.75, Horizontal),
            (-78.74, Nutant),
            (90.0, Horizontal),
            (-90.0, Horizontal),
            (0.0, Vertical),
        ];
        for (degrees, class) in classes {
            for each in [Horizontal, Aslant, Vertical, Nutant] {
                assert_eq!(each.takes(at(degrees)), each == class, "{degrees} {each:?}");
            }
            assert_eq!(Side.takes(at(degrees)), class != Horizontal);
        }
    }

    #[test]
    fn every_normal_is_in_one_quadrant() {
        use Direction::{Back, Bottom, Front, Left, Right, Top};
        for x in -3..=3 {
            for y in -3..=3 {
                for z in -3..=3 {
                    let normal = DVec3::new(f64::from(x), f64::from(y), f64::from(z)).normalize_or_zero();
                    let quadrants = [Front, Back, Left, Right, Top, Bottom];
                    assert_eq!(quadrants.iter().filter(|quadrant| quadrant.takes(normal)).count(), 1);
                }
            }
        }
    }
}
