//! Points in the plane on a grid of 2^-24 m (60 nm), seen from above: x to the right, y up, which is -z in the world.
//!
//! Grid points are exact as f64, and orientation tests of them are exact in 128 bits.

use std::collections::BTreeMap;

use glam::DVec2;

/// Grid units in a metre.
const UNITS: f64 = 16_777_216.0;

/// The length of a grid unit in metres.
pub(super) const UNIT: f64 = 1.0 / UNITS;

/// A point of the grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Point {
    pub(super) x: i64,
    pub(super) y: i64,
}

impl Point {
    /// The grid point nearest to a position in metres.
    pub(super) fn near(place: DVec2) -> Point {
        Point { x: (place.x * UNITS).round() as i64, y: (place.y * UNITS).round() as i64 }
    }

    /// The position of the point in metres.
    pub(super) fn place(self) -> DVec2 {
        DVec2::new(self.x as f64 * UNIT, self.y as f64 * UNIT)
    }

    /// The vector from another point to this one.
    pub(super) fn from(self, other: Point) -> (i128, i128) {
        (i128::from(self.x - other.x), i128::from(self.y - other.y))
    }
}

/// The cross product of two vectors.
pub(super) fn cross(a: (i128, i128), b: (i128, i128)) -> i128 {
    a.0 * b.1 - a.1 * b.0
}

/// The scalar product of two vectors.
pub(super) fn dot(a: (i128, i128), b: (i128, i128)) -> i128 {
    a.0 * b.0 + a.1 * b.1
}

/// Positive when `c` is left of the line from `a` to `b`, negative when it is right, 0 when the points are collinear.
pub(super) fn orient(a: Point, b: Point, c: Point) -> i128 {
    cross(b.from(a), c.from(a))
}

/// Returns true if the bounding boxes of two segments do not touch.
pub(super) fn are_apart([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let apart = |a: i64, b: i64, c: i64, d: i64| a.max(b) < c.min(d) || c.max(d) < a.min(b);
    apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)
}

/// Twice the signed area of a ring in square grid units, positive when it is counter-clockwise.
pub(super) fn twice_area(ring: &[Point]) -> i128 {
    let Some(&from) = ring.first() else { return 0 };
    ring.windows(2).map(|edge| cross(edge[0].from(from), edge[1].from(from))).sum()
}

/// The limit of the average thickness in metres below which a face is due to rounding.
const THIN: f64 = 1e-6;

/// Returns true if a counter-clockwise ring encloses only a rounding error.
pub(super) fn is_sliver(ring: &[Point]) -> bool {
    let length: f64 = sides(ring).map(|[a, b]| a.place().distance(b.place())).sum();
    let area = twice_area(ring) as f64 * UNIT * UNIT / 2.0;
    0.0 <= area && area < THIN * length
}

/// The sides of a ring, each from one point to the next.
pub(super) fn sides(ring: &[Point]) -> impl Iterator<Item = [Point; 2]> {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// The winding number of a ring around a point, counter-clockwise. A point on the ring counts as on one of its sides.
pub(super) fn winding(ring: &[Point], point: Point) -> i32 {
    sides(ring).map(|side| winding_part(side, point)).sum()
}

/// The part of a side in the winding number around a point: not 0 only if the side passes the line to the right of the point.
pub(super) fn winding_part([a, b]: [Point; 2], point: Point) -> i32 {
    let rises = a.y <= point.y && point.y < b.y && 0 < orient(a, b, point);
    let falls = b.y <= point.y && point.y < a.y && orient(a, b, point) < 0;
    i32::from(rises) - i32::from(falls)
}

/// A map by points or cells. Its time is bounded for all points, and its order is the order of the keys.
pub(super) type GridMap<K, V> = BTreeMap<K, V>;
