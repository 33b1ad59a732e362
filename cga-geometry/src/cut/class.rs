//! Positions of heights among the planes of a cut.

use std::ops::{Range, RangeInclusive};

/// The class of a height: in a slab or on a plane, in the order of heights. Slab 0 is below plane 0, slab 1 between
/// planes 0 and 1, and so on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Class(u32);

impl Class {
    /// Strictly inside a slab.
    #[inline]
    pub(super) fn inside(slab: u32) -> Self {
        Class(2 * slab)
    }

    #[inline]
    pub(super) fn on(plane: u32) -> Self {
        Class(2 * plane + 1)
    }

    /// The class of a height among planes at increasing heights.
    #[inline]
    pub(super) fn among(planes: &[f64], height: f64) -> Self {
        if let [plane] = *planes {
            return if plane == height { Class::on(0) } else { Class::inside(u32::from(plane < height)) };
        }
        let below = planes.partition_point(|&plane| plane < height);
        if planes.get(below) == Some(&height) { Class::on(below as u32) } else { Class::inside(below as u32) }
    }

    #[inline]
    pub(super) fn is_on_plane(self) -> bool {
        self.0 & 1 == 1
    }

    /// The number of the plane, for a class on a plane.
    #[inline]
    pub(super) fn plane(self) -> u32 {
        self.0 / 2
    }

    /// The slab; for a class on a plane, the slab below.
    #[inline]
    pub(super) fn slab(self) -> u32 {
        self.0 / 2
    }

    /// The slab; for a class on a plane, the slab above.
    #[inline]
    fn slab_above(self) -> u32 {
        self.0.div_ceil(2)
    }

    /// Returns true if the class is in a slab or on one of its planes.
    pub(super) fn touches(self, slab: u32) -> bool {
        self.slab() == slab || self.slab_above() == slab
    }
}

/// The range from one class up to another.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClassRange {
    pub(super) low: Class,
    pub(super) high: Class,
}

impl ClassRange {
    /// The span of several classes, at least one.
    #[inline]
    pub(super) fn of(classes: impl Iterator<Item = Class>) -> Self {
        let none = ClassRange { low: Class(u32::MAX), high: Class(0) };
        classes.fold(none, |span, class| ClassRange { low: span.low.min(class), high: span.high.max(class) })
    }

    /// The span of two classes.
    #[inline]
    pub(super) fn between(a: Class, b: Class) -> Self {
        ClassRange { low: a.min(b), high: a.max(b) }
    }

    /// The lowest slab that contains a part of the span.
    #[inline]
    pub(super) fn bottom(self) -> u32 {
        self.low.slab_above()
    }

    /// The highest slab that contains a part of the span.
    #[inline]
    pub(super) fn top(self) -> u32 {
        self.high.slab()
    }

    /// Returns true if the whole span is on one plane, so that no slab contains a part of it.
    #[inline]
    pub(super) fn is_flat(self) -> bool {
        self.top() < self.bottom()
    }

    /// Returns true if an end of the span is on a plane.
    #[inline]
    pub(super) fn touches_plane(self) -> bool {
        self.low.is_on_plane() || self.high.is_on_plane()
    }

    /// The slabs that contain a part of the span.
    #[inline]
    pub(super) fn slabs(self) -> RangeInclusive<u32> {
        self.bottom()..=self.top()
    }

    /// The planes strictly between its ends.
    #[inline]
    pub(super) fn planes(self) -> Range<u32> {
        self.bottom()..self.top()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_know_their_slabs_and_planes() {
        let span = |low, high| ClassRange { low, high };
        let (inside, on) = (Class::inside, Class::on);
        assert!(inside(0) < on(0) && on(0) < inside(1) && inside(1) < on(1));
        assert_eq!(span(inside(1), inside(3)).slabs(), 1..=3);
        assert_eq!(span(inside(1), inside(3)).planes(), 1..3);
        assert_eq!(span(on(0), on(2)).slabs(), 1..=2);
        assert_eq!(span(on(0), on(2)).planes(), 1..2);
        assert_eq!(span(inside(1), on(1)).slabs(), 1..=1);
        assert!(span(on(2), on(2)).is_flat() && !span(inside(2), inside(2)).is_flat());
        assert!(on(1).touches(1) && on(1).touches(2) && !on(1).touches(3) && inside(1).touches(1));
    }
}
