//! Cells: triangles and quads of roadways and sidewalks with what is known at their corners.

use glam::{DVec2, DVec3};

use super::grid::{Point, twice_area};

/// A corner of a cell: its point, the distances along and across in metres, and its height.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) point: Point,
    /// Along, across, height.
    pub(super) value: DVec3,
}

impl Corner {
    pub(super) fn new(point: Point, along: f64, across: f64, height: f64) -> Self {
        Corner { point, value: DVec3::new(along, across, height) }
    }
}

/// A convex cell with three or four corners, counter-clockwise. A first edge along the street is its first.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    pub(super) corners: Vec<Corner>,
}

impl Cell {
    /// A cell; nothing where its corners leave no area.
    pub(super) fn new(corners: &[Corner]) -> Option<Cell> {
        let mut corners = corners.to_vec();
        corners.dedup_by_key(|corner| corner.point);
        if 1 < corners.len() && corners[0].point == corners[corners.len() - 1].point {
            corners.pop();
        }
        let cell = Cell { corners };
        (0 < twice_area(&cell.ring())).then_some(cell)
    }

    pub(super) fn ring(&self) -> Vec<Point> {
        self.corners.iter().map(|corner| corner.point).collect()
    }

    /// Along, across and height at a point of the cell. At a common point, cells with a common edge agree to the bit.
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
            // Points that were rounded onto an edge are within two grid units.
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

/// The cells between two poly-lines that run side by side: `inner` and, on its right, `outer`. Each point has a height. Along
/// is counted backwards, so that the cells are not mirrored: it is 0 at the last point of `inner`. Nothing is returned where a
/// cell would be turned over.
pub(super) fn strip(inner: &[(Point, f64)], outer: &[(Point, f64)], width: f64) -> Option<(Vec<Cell>, f64)> {
    let (inner_sums, outer_sums) = (sums(inner), sums(outer));
    let length = inner_sums[inner.len() - 1];
    let corner = |line: &[(Point, f64)], sums: &[f64], at: usize, across: f64| {
        let all = sums[line.len() - 1];
        let part = if 0.0 < all { sums[at] / all } else { at as f64 / (line.len().max(2) - 1) as f64 };
        Corner::new(line[at].0, length * (1.0 - part), across, line[at].1)
    };
    let (mut i, mut j) = (0, 0);
    let mut cells = Vec::new();
    while i + 1 < inner.len() || j + 1 < outer.len() {
        let part = |sums: &[f64], at: usize| {
            sums.get(at).map_or(f64::INFINITY, |sum| if sums[sums.len() - 1] == 0.0 { 1.0 } else { sum / sums[sums.len() - 1] })
        };
        let (next_i, next_j) = (part(&inner_sums, i + 1), part(&outer_sums, j + 1));
        let both = inner.len() == outer.len() || (next_i - next_j).abs() < 1e-6;
        let (to_i, to_j) = match () {
            () if both => (i + 1, j + 1),
            () if next_i < next_j => (i + 1, j),
            () => (i, j + 1),
        };
        let corners = [
            corner(inner, &inner_sums, to_i, 0.0),
            corner(inner, &inner_sums, i, 0.0),
            corner(outer, &outer_sums, j, width),
            corner(outer, &outer_sums, to_j, width),
        ];
        match Cell::new(&corners) {
            Some(cell) if is_convex(&cell.ring()) => cells.push(cell),
            None if twice_area(&corners.map(|corner| corner.point)) == 0 => {}
            _ => return None,
        }
        (i, j) = (to_i, to_j);
    }
    Some((cells, length))
}

fn sums(line: &[(Point, f64)]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut sums = vec![0.0];
    for ends in line.windows(2) {
        sum += ends[0].0.place().distance(ends[1].0.place());
        sums.push(sum);
    }
    sums
}

/// Whether a counter-clockwise ring turns left at each of its points, except for rounding.
pub(super) fn is_convex(ring: &[Point]) -> bool {
    let count = ring.len();
    (0..count).all(|at| {
        let [a, b, c] = [0, 1, 2].map(|step| ring[(at + step) % count].place());
        let area = (b - a).perp_dot(c - b);
        -4.0 * super::grid::UNIT * ((b - a).length() + (c - b).length()) <= area
    })
}
