//! Scopes: an origin, three axes and a size.
//!
//! Right-handed, y up. All lengths in metres, all coordinates in the world. A scope spans
//! `origin + x·axes.x + y·axes.y + z·axes.z` with `0 ≤ x ≤ size.x` and so on; a negative size mirrors.

use glam::{DAffine3, DMat3, DVec3};

use crate::geometry::{Axis, Frame};

/// An oriented box: the place and the size of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scope {
    /// The corner at (0, 0, 0), in the world.
    pub origin: DVec3,
    /// Orthonormal axes, as columns.
    pub axes: DMat3,
    /// The extent along each axis; a negative extent mirrors.
    pub size: DVec3,
}

impl Scope {
    /// A scope at the origin of the world, along the world's axes.
    pub const fn new(size: DVec3) -> Self {
        Scope { origin: DVec3::ZERO, axes: DMat3::IDENTITY, size }
    }

    /// The frame, without the size.
    pub fn frame(&self) -> Frame {
        Frame { origin: self.origin, axes: self.axes }
    }

    /// The centre, in the world.
    pub fn centre(&self) -> DVec3 {
        self.origin + self.axes * (self.size * 0.5)
    }

    /// The eight corners, in the world; the corner (x, y, z) has the index x + 2y + 4z.
    pub(crate) fn corners(&self) -> [DVec3; 8] {
        let far = |at: usize, axis: usize| if at & (1 << axis) == 0 { 0.0 } else { self.size[axis] };
        std::array::from_fn(|at| self.origin + self.axes * DVec3::new(far(at, 0), far(at, 1), far(at, 2)))
    }

    /// The largest size of a scope: squares of lengths must be finite. The macro relies on it (`lower/extent.rs`).
    pub(crate) const MOST_SIZE: f64 = 1e149;

    /// The largest distance of a scope from the origin of the world, summed over the axes.
    pub(crate) const MOST_DISTANCE: f64 = 1e150;

    /// Returns true if the scope's contents stay far from overflow under any rotation.
    pub(crate) fn is_bounded(&self) -> bool {
        // Maxima ignore NaN; sums and comparisons do not.
        self.origin.abs().element_sum() <= Scope::MOST_DISTANCE
            && self.size.abs().cmple(DVec3::splat(Scope::MOST_SIZE)).all()
    }

    /// The extent along an axis.
    pub fn extent(&self, axis: Axis) -> f64 {
        self.size[axis.index()]
    }

    /// The map from scope coordinates (metres from the origin corner, along the axes) to the world.
    pub fn placement(&self) -> DAffine3 {
        DAffine3 { matrix3: self.axes, translation: self.origin }
    }
}
