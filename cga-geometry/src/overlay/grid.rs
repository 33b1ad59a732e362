//! Places in a plane as whole numbers, so that the side of a line is exact.

use glam::DVec2;

use crate::each::Each;
use crate::nesting::extent::Extent;

/// A place, in steps of the grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct GridPoint {
    pub(crate) x: i64,
    pub(crate) y: i64,
}

impl GridPoint {
    /// The place as floating-point numbers, which are exact.
    pub(crate) fn flat(self) -> DVec2 {
        DVec2::new(self.x as f64, self.y as f64)
    }
}

/// The grid over some points. The largest extent of the points is between a half and one times [`Grid::EXTENT`] steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    middle: DVec2,
    step: f64,
}

impl Grid {
    /// The number of bits of a coordinate. A product of three differences of coordinates has fewer than 127 bits.
    const BITS: i32 = 36;
    /// The largest extent in steps.
    pub(crate) const EXTENT: f64 = (1u64 << Self::BITS) as f64;

    /// A grid for some points; `None` if they are at one place, or so far apart that numbers overflow.
    pub(crate) fn of(points: &[DVec2]) -> Option<Grid> {
        let Extent { low, high } = Extent::of(points.iter().copied());
        let extent = (high - low).max_element();
        let is_usable = (1e-200..1e200).contains(&extent) && low.abs().max(high.abs()).max_element() < 1e200;
        let step = || libm::scalbn(1.0, libm::ilogb(extent) + 1 - Self::BITS);
        is_usable.then(|| Grid { middle: low * 0.5 + high * 0.5, step: step() })
    }

    /// The nearest place to a point.
    pub(crate) fn place(&self, point: DVec2) -> GridPoint {
        let steps = ((point - self.middle) / self.step).round();
        GridPoint { x: steps.x as i64, y: steps.y as i64 }
    }

    /// The point at a place.
    pub(crate) fn point(&self, place: GridPoint) -> DVec2 {
        self.middle + place.flat() * self.step
    }
}

/// Twice the area of the triangle: positive if `c` is left of the line from `a` to `b`. Exact.
pub(crate) fn side(a: GridPoint, b: GridPoint, c: GridPoint) -> i128 {
    let [bx, by, cx, cy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y].each(i128::from);
    bx * cy - by * cx
}

/// Twice the area of a ring.
pub(crate) fn double_area(ring: &[u32], places: &[GridPoint]) -> i128 {
    let at = |i: usize| places[ring[i] as usize];
    (1..ring.len().saturating_sub(1)).map(|i| side(at(0), at(i), at(i + 1))).sum()
}

/// Returns true if `p` is between `a` and `b`, and at most `most` steps from the edge.
pub(crate) fn is_near(a: GridPoint, b: GridPoint, p: GridPoint, most: f64) -> bool {
    let along = [b.x - a.x, b.y - a.y].each(i128::from);
    let to = [p.x - a.x, p.y - a.y].each(i128::from);
    let length = along[0] * along[0] + along[1] * along[1];
    let share = along[0] * to[0] + along[1] * to[1];
    let across = side(a, b, p) as f64;
    0 < share && share < length && across * across <= most * most * (length as f64)
}

/// Drops corners at which a ring runs straight on, except for points with a number below `kept`.
pub(crate) fn drop_straight(ring: &mut Vec<u32>, places: &[GridPoint], kept: usize) {
    /// The largest distance of a corner from the line of its neighbours, in steps: the distances of rounding, of a place and of an
    /// edge that was led through it.
    const STRAIGHT: f64 = 3.0;
    let at = |point: u32| places[point as usize];
    let runs_on = |a: u32, p: u32, b: u32| kept <= p as usize && is_near(at(a), at(b), at(p), STRAIGHT);
    let mut made: Vec<u32> = Vec::with_capacity(ring.len());
    for &point in &*ring {
        while let [.., a, p] = made[..]
            && runs_on(a, p, point)
        {
            made.pop();
        }
        made.push(point);
    }
    // The start of the ring.
    let mut from = 0;
    while 3 <= made.len() - from {
        let [first, second] = [made[from], made[from + 1]];
        let [last, before] = [made[made.len() - 1], made[made.len() - 2]];
        if runs_on(before, last, first) {
            made.pop();
        } else if runs_on(last, first, second) {
            from += 1;
        } else {
            break;
        }
    }
    *ring = made.split_off(from);
}
