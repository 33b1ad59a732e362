//! Selectors of the component split that look at a face's normal, or at its number.

use glam::DVec3;

/// Which components an arm takes. Directions are those of the scope (*comp operation*).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Select {
    /// +z.
    Front,
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
    /// Everything that is not horizontal.
    Side,
    /// Up or down within 11.25 degrees.
    Horizontal,
    /// Looking up between 11.25 and 78.75 degrees.
    Aslant,
    /// Within 11.25 degrees of the horizon.
    Vertical,
    /// Looking down between 11.25 and 78.75 degrees.
    Nutant,
    /// Everything.
    All,
    /// By number, counted from 0. What is no whole number or too large takes nothing.
    Index(f64),
}

/// Angle above the horizon where `vertical` ends, in degrees.
const LEVEL: f64 = 11.25;
/// Angle above the horizon where `horizontal` begins, in degrees.
const STEEP: f64 = 78.75;

impl Select {
    /// Whether it takes the face with this number and unit normal in scope axes.
    #[inline]
    pub fn takes(self, index: usize, normal: DVec3) -> bool {
        match self {
            Select::Front => quadrant(normal) == (2, true),
            Select::Back => quadrant(normal) == (2, false),
            Select::Right => quadrant(normal) == (0, true),
            Select::Left => quadrant(normal) == (0, false),
            Select::Top => quadrant(normal) == (1, true),
            Select::Bottom => quadrant(normal) == (1, false),
            Select::Horizontal => is_horizontal(elevation(normal)),
            Select::Side => !is_horizontal(elevation(normal)),
            Select::Aslant => LEVEL < elevation(normal) && elevation(normal) <= STEEP,
            Select::Vertical => -LEVEL < elevation(normal) && elevation(normal) <= LEVEL,
            Select::Nutant => -STEEP < elevation(normal) && elevation(normal) <= -LEVEL,
            Select::All => true,
            Select::Index(number) => number == index as f64,
        }
    }
}

/// The axis that a normal follows most, and whether forwards. Where two are equal, z comes before x before y: the
/// pictures of the reference leave ties to rounding.
#[inline]
fn quadrant(normal: DVec3) -> (usize, bool) {
    let size = normal.abs();
    let axis = if size.x <= size.z && size.y <= size.z {
        2
    } else if size.y <= size.x {
        0
    } else {
        1
    };
    (axis, 0.0 < normal[axis])
}

/// Degrees above the horizon.
#[inline]
fn elevation(normal: DVec3) -> f64 {
    // The common cases are exact and need no arc sine.
    match normal.y {
        0.0 => 0.0,
        1.0 => 90.0,
        -1.0 => -90.0,
        y => libm::asin(y.clamp(-1.0, 1.0)).to_degrees(),
    }
}

/// (78.75, 90] or [-90, -78.75].
#[inline]
fn is_horizontal(elevation: f64) -> bool {
    STEEP < elevation || elevation <= -STEEP
}
