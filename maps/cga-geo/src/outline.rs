//! Polygons of rows, before they are checked.

use std::ops::RangeInclusive;

/// A corner in the coordinates of the file: x or longitude, then y or latitude.
pub type Corner = [f64; 2];

/// A polygon of a row as the file has it: rings with or without a last corner that repeats the first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// The outer ring, then the holes.
    pub rings: Vec<Vec<Corner>>,
    /// The lowest height of the corners of the outer ring in metres, if the file has heights.
    pub height: Option<f64>,
    /// A height of a corner that is not in [`HEIGHTS`] and was left out.
    pub wrong_height: Option<f64>,
}

/// The heights in metres that corners may have. Files write numbers such as −3.4·10³⁸ for a height that is missing.
pub const HEIGHTS: RangeInclusive<f64> = -12_000.0..=100_000.0;

impl Outline {
    /// An outline without heights.
    pub fn new(rings: Vec<Vec<Corner>>) -> Self {
        Outline { rings, ..Outline::default() }
    }

    /// Takes a height of a corner of the outer ring. NaN is not a height.
    pub fn lower_to(&mut self, height: f64) {
        if height.is_nan() {
            return;
        }
        if !HEIGHTS.contains(&height) {
            self.wrong_height.get_or_insert(height);
        } else {
            self.height = Some(self.height.map_or(height, |lowest| lowest.min(height)));
        }
    }
}

/// Twice the area of a ring, positive if it runs counter-clockwise with y up. It is computed around the first corner, so that coordinates
/// far from the origin lose no digits.
pub fn twice_area(ring: &[Corner]) -> f64 {
    let Some(&[x, y]) = ring.first() else { return 0.0 };
    let moved = |corner: &Corner| [corner[0] - x, corner[1] - y];
    ring.windows(2).map(|pair| (moved(&pair[0]), moved(&pair[1]))).map(|([ax, ay], [bx, by])| ax * by - bx * ay).sum()
}

/// The centroid of the area of a ring with a positive or negative area.
pub fn centroid(ring: &[Corner]) -> Corner {
    let Some(&[x, y]) = ring.first() else { return [0.0; 2] };
    let (mut area, mut sum) = (0.0, [0.0; 2]);
    for pair in ring.windows(2) {
        let [ax, ay, bx, by] = [pair[0][0] - x, pair[0][1] - y, pair[1][0] - x, pair[1][1] - y];
        let cross = ax * by - bx * ay;
        area += cross;
        sum = [sum[0] + (ax + bx) * cross, sum[1] + (ay + by) * cross];
    }
    [x + sum[0] / (3.0 * area), y + sum[1] / (3.0 * area)]
}

/// Returns true if a point is inside of a ring.
pub fn contains(ring: &[Corner], [x, y]: Corner) -> bool {
    let mut inside = false;
    for (at, &[bx, by]) in ring.iter().enumerate() {
        let [ax, ay] = ring[(at + ring.len() - 1) % ring.len()];
        if (ay > y) != (by > y) && x < (bx - ax) * (y - ay) / (by - ay) + ax {
            inside = !inside;
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Corner; 4] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];

    #[test]
    fn areas_and_centroids_do_not_depend_on_the_place() {
        for by in [0.0, 1e7] {
            let ring = SQUARE.map(|[x, y]| [x + by, y + by]);
            assert_eq!(twice_area(&ring), 8.0);
            assert_eq!(centroid(&ring), [by + 1.0, by + 1.0]);
        }
        assert_eq!(twice_area(&[SQUARE[0], SQUARE[2], SQUARE[1]]), -4.0);
    }

    #[test]
    fn points_are_inside_or_outside_of_rings() {
        assert!(contains(&SQUARE, [0.5, 1.5]));
        assert!(!contains(&SQUARE, [2.5, 1.5]));
        assert!(!contains(&SQUARE, [-0.5, 1.5]));
    }
}
