//! Cells: triangles and quads of roadways and sidewalks, with values at their corners.

use cga_geometry::each::Each;
use glam::{DVec2, DVec3};

use super::grid::{Point, twice_area};

/// A corner of a cell: its point, the distances along and across in metres, and its height.
#[derive(Clone, Copy, Debug)]
pub(super) struct TileCorner {
    pub(super) point: Point,
    /// Along, across, height.
    pub(super) value: DVec3,
}

impl TileCorner {
    pub(super) fn new(point: Point, along: f64, across: f64, height: f64) -> Self {
        TileCorner { point, value: DVec3::new(along, across, height) }
    }
}

/// A convex cell with three or four corners, counter-clockwise. A cell beside the street begins with the edge along the
/// street.
#[derive(Clone, Debug)]
pub(super) struct Tile {
    pub(super) corners: Vec<TileCorner>,
}

impl Tile {
    /// A cell; `None` if its area is not positive.
    pub(super) fn new(corners: &[TileCorner]) -> Option<Tile> {
        let mut corners = corners.to_vec();
        corners.dedup_by_key(|corner| corner.point);
        if 1 < corners.len() && corners[0].point == corners[corners.len() - 1].point {
            corners.pop();
        }
        let cell = Tile { corners };
        (0 < twice_area(&cell.ring())).then_some(cell)
    }

    pub(super) fn ring(&self) -> Vec<Point> {
        self.corners.iter().map(|corner| corner.point).collect()
    }

    /// The distances along and across and the height at a point of the cell. Cells with a common edge agree to the bit
    /// at its points.
    pub(super) fn value(&self, point: Point) -> DVec3 {
        if let Some(corner) = self.corners.iter().find(|corner| corner.point == point) {
            return corner.value;
        }
        let place = point.place();
        let count = self.corners.len();
        for at in 0..count {
            let (mut a, mut b) = (self.corners[at], self.corners[(at + 1) % count]);
            if b.point < a.point {
                (a, b) = (b, a);
            }
            let along = b.point.place() - a.point.place();
            let part = (place - a.point.place()).dot(along) / along.length_squared();
            // Points rounded onto an edge are within two grid units of it.
            let off = (place - a.point.place()).perp_dot(along).abs() / along.length();
            if off <= 4.0 * super::grid::UNIT && (0.0..=1.0).contains(&part) {
                return a.value + (b.value - a.value) * part;
            }
        }
        self.inner_value(place)
    }

    fn inner_value(&self, place: DVec2) -> DVec3 {
        let at = |corner: usize| self.corners[corner].point.place();
        let value = |corner: usize| self.corners[corner].value;
        if self.corners.len() == 3 {
            let area = (at(1) - at(0)).perp_dot(at(2) - at(0));
            let second = (place - at(0)).perp_dot(at(2) - at(0)) / area;
            let third = (at(1) - at(0)).perp_dot(place - at(0)) / area;
            return value(0) + (value(1) - value(0)) * second + (value(2) - value(0)) * third;
        }
        // The bilinear map of the quad, inverted by Newton's method from the middle.
        let (u, v, w) = (at(1) - at(0), at(3) - at(0), at(2) - at(1) - (at(3) - at(0)));
        let (mut p, mut q) = (0.5, 0.5);
        for _ in 0..12 {
            let off = at(0) + u * p + v * q + w * (p * q) - place;
            let (by_p, by_q) = (u + w * q, v + w * p);
            let area = by_p.perp_dot(by_q);
            if area.abs() < f64::MIN_POSITIVE {
                break;
            }
            p = (p - off.perp_dot(by_q) / area).clamp(0.0, 1.0);
            q = (q - by_p.perp_dot(off) / area).clamp(0.0, 1.0);
        }
        let near = value(0) + (value(1) - value(0)) * p;
        near + (value(3) + (value(2) - value(3)) * p - near) * q
    }
}

/// A point of a poly-line that runs beside another one.
#[derive(Clone, Copy, Debug)]
pub(super) struct SidePoint {
    pub(super) point: Point,
    pub(super) height: f64,
    /// The position along both poly-lines: points with equal keys are beside each other.
    pub(super) key: (u8, f64),
}

/// A sidewalk between two poly-lines side by side.
pub(super) struct SideStrip {
    pub(super) cells: Vec<Tile>,
    pub(super) length: f64,
    pub(super) width: f64,
}

/// Keys that differ by less are equal.
const SAME_KEY: f64 = 1e-6;

/// The cells between two poly-lines side by side: `inner` and, on its right, `outer`. The distance along is counted
/// backwards, so that the cells are not mirrored: it is 0 at the last point of `inner`. `None` if a cell would be turned
/// over or not be convex.
pub(super) fn strip(inner: &[SidePoint], outer: &[SidePoint], width: f64) -> Option<SideStrip> {
    let mut length = 0.0;
    let mut left = vec![0.0; inner.len()];
    for at in (1..inner.len()).rev() {
        length += inner[at - 1].point.place().distance(inner[at].point.place());
        left[at - 1] = length;
    }
    // The pairs of points beside each other, in steps along one of the lines or both.
    let mut links = vec![(0, 0)];
    let (mut i, mut j) = (0, 0);
    while i + 1 < inner.len() || j + 1 < outer.len() {
        let next = [inner.get(i + 1), outer.get(j + 1)].each(|trace| trace.map_or((u8::MAX, 0.0), |trace| trace.key));
        let (a, b) = (next[0], next[1]);
        let same = a.0 == b.0 && (a.1 - b.1).abs() < SAME_KEY;
        if same || a < b {
            i += 1;
        }
        if same || b < a {
            j += 1;
        }
        links.push((i, j));
    }
    let mut reach = vec![[f64::INFINITY, f64::NEG_INFINITY]; outer.len()];
    for &(i, j) in &links {
        reach[j] = [reach[j][0].min(left[i]), reach[j][1].max(left[i])];
    }
    let near = |at: usize| TileCorner::new(inner[at].point, left[at], 0.0, inner[at].height);
    let far = |at: usize| {
        let along = (reach[at][0] + reach[at][1]) / 2.0;
        TileCorner::new(outer[at].point, along, width, outer[at].height)
    };
    let mut cells = Vec::new();
    for step in links.windows(2) {
        let [(i, j), (to_i, to_j)] = [step[0], step[1]];
        let corners = [near(to_i), near(i), far(j), far(to_j)];
        match Tile::new(&corners) {
            Some(cell) if is_convex(&cell.ring()) => cells.push(cell),
            None if twice_area(&corners.each(|corner| corner.point)) == 0 => {}
            _ => return None,
        }
    }
    Some(SideStrip { cells, length, width })
}

/// Returns true if a counter-clockwise ring turns left at each of its points, except for rounding.
pub(super) fn is_convex(ring: &[Point]) -> bool {
    let count = ring.len();
    (0..count).all(|at| {
        let [a, b, c] = [0, 1, 2].each(|step| ring[(at + step) % count].place());
        let area = (b - a).perp_dot(c - b);
        -4.0 * super::grid::UNIT * ((b - a).length() + (c - b).length()) <= area
    })
}
