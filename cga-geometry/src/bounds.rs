//! Axis-aligned boxes.

use glam::DVec3;

/// An axis-aligned box. For the empty box `low` is +∞ and `high` is −∞.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The smallest coordinates.
    pub low: DVec3,
    /// The largest coordinates.
    pub high: DVec3,
}

impl Bounds {
    /// The empty box.
    pub const EMPTY: Bounds = Bounds { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// The extent along each axis; zero for the empty box.
    pub fn size(&self) -> DVec3 {
        (self.high - self.low).max(DVec3::ZERO)
    }

    /// A power of two that scales the longest extent to about 1, so that areas and volumes neither overflow nor vanish.
    pub fn scale_to_one(&self) -> f64 {
        const EXPONENT: u64 = 0x7ff << 52;
        // The difference of the largest numbers overflows; the difference of their halves does not.
        let half = (self.high * 0.5 - self.low * 0.5).max_element();
        1.0 / f64::from_bits(half.max(f64::MIN_POSITIVE).to_bits() & EXPONENT)
    }

    /// The bounding box of some points.
    pub fn of(points: impl IntoIterator<Item = DVec3>) -> Bounds {
        points.into_iter().fold(Bounds::EMPTY, |sum, point| sum.union(Bounds { low: point, high: point }))
    }

    /// The distance to another box; infinite if one is empty.
    pub fn distance(&self, other: &Bounds) -> f64 {
        (other.low - self.high).max(self.low - other.high).max(DVec3::ZERO).length()
    }

    /// The bounding box of two boxes.
    #[must_use]
    pub fn union(self, other: Bounds) -> Bounds {
        Bounds { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
}
