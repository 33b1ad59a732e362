//! The highest triangulation of a loop: of all surfaces of triangles between its corners, the one with the largest volume below.
//!
//! It depends on the loop alone: not on its first corner, its sense and its place, and a mirrored loop has the mirrored triangles.
//! Where two triangulations are equally high except for rounding, as at corners in one plane, the one with the shorter diagonals is
//! taken. If these are equal, too, the surfaces are the same or mirror images.

use glam::DVec3;

use crate::tol::TIE_EPSILON;

/// The largest number of corners: the time grows with the third power.
const MOST: usize = 128;

/// A triangle is wide enough if its area is more than this part of the square of the loop's extent.
const THIN: f64 = 1e-10;

/// The best triangles of a row of corners.
#[derive(Clone, Copy)]
struct Best {
    /// Six times the volume below them.
    volume: f64,
    /// The sum of the squares of their diagonals.
    diagonals: f64,
    /// The corner between the first and the last one.
    middle: usize,
}

impl Best {
    /// Returns true if other triangles are higher, or equally high with shorter diagonals.
    fn is_below(&self, other: &Best, tie: f64) -> bool {
        if (self.volume - other.volume).abs() <= tie {
            return other.diagonals < self.diagonals * (1.0 - TIE_EPSILON);
        }
        self.volume < other.volume
    }
}

/// The triangles of a loop that is counter-clockwise as seen from above, along z, as numbers of its corners,
/// counter-clockwise. `None` if the loop crosses itself as seen from above, or has more than 128 corners.
pub(crate) fn highest(points: &[DVec3]) -> Option<Vec<[usize; 3]>> {
    let count = points.len();
    if !(3..=MOST).contains(&count) {
        return None;
    }
    let from = points[0];
    let size = points.iter().fold(0.0, |most: f64, point| most.max((*point - from).truncate().abs().max_element()));
    let height = points.iter().fold(0.0, |most: f64, point| most.max((point.z - from.z).abs()));
    let tie = TIE_EPSILON * size * size * height;
    let diagonal = |a: usize, b: usize| if a + 1 < b { (points[b] - points[a]).length_squared() } else { 0.0 };
    // By first and last corner of a row of corners.
    let mut best = vec![Best { volume: 0.0, diagonals: 0.0, middle: 0 }; count * count];
    for length in 2..count {
        for first in 0..count - length {
            let last = first + length;
            let mut found = Best { volume: f64::NEG_INFINITY, diagonals: f64::INFINITY, middle: 0 };
            for middle in first + 1..last {
                let [a, b, c] = [first, middle, last].map(|corner| points[corner] - from);
                let area = (b - a).truncate().perp_dot((c - a).truncate());
                if THIN * size * size < area {
                    let [left, right] = [best[first * count + middle], best[middle * count + last]];
                    let volume = left.volume + right.volume + area * (a.z + b.z + c.z);
                    let own = diagonal(first, middle) + diagonal(middle, last);
                    let tried = Best { volume, diagonals: left.diagonals + right.diagonals + own, middle };
                    if found.is_below(&tried, tie) {
                        found = tried;
                    }
                }
            }
            best[first * count + last] = found;
        }
    }
    let mut triangles = Vec::with_capacity(count - 2);
    let mut open = vec![[0, count - 1]];
    while let Some([first, last]) = open.pop() {
        if first + 1 < last {
            let Best { volume, middle, .. } = best[first * count + last];
            if volume == f64::NEG_INFINITY {
                return None;
            }
            triangles.push([first, middle, last]);
            open.extend([[middle, last], [first, middle]]);
        }
    }
    Some(triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_higher_diagonal_of_a_square_is_taken_from_every_corner() {
        let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0], [0.0, 1.0, 1.0]].map(DVec3::from);
        for start in 0..4 {
            let mut turned = square;
            turned.rotate_left(start);
            let triangles = highest(&turned).expect("a square");
            // Both triangles have the two corners that are up.
            assert!(
                triangles
                    .iter()
                    .all(|triangle| triangle.iter().filter(|&&corner| turned[corner].z == 1.0).count() == 2)
            );
        }
    }

    #[test]
    fn rounding_does_not_decide_between_the_diagonals_of_a_flat_part() {
        let points = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [9.0, 3.0, 3.0], [2.0, 3.0, 3.0], [-0.5, 1.0, 0.9]];
        let rng = &mut crate::random::Rng(7);
        let mut noisy = || points.map(|point| DVec3::from(point.map(|x| x + 4e-15 * (rng.unit() - 0.5))));
        // The flat part has the corners 0 to 3, and the diagonal from 0 to 2 is longer.
        let expected = [[0, 1, 3], [0, 3, 4], [1, 2, 3]];
        for _ in 0..100 {
            let mut triangles = highest(&noisy()).expect("a loop");
            triangles.sort_unstable();
            assert_eq!(triangles, expected);
        }
    }

    #[test]
    fn loops_that_cross_or_are_clockwise_have_none() {
        let bow = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(DVec3::from);
        assert_eq!(highest(&bow), None);
        let clockwise = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]].map(DVec3::from);
        assert_eq!(highest(&clockwise), None);
        assert_eq!((highest(&[]), highest(&[DVec3::NAN; 4])), (None, None));
    }

    #[test]
    fn a_concave_loop_is_filled() {
        let points: Vec<DVec3> = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 1.0], [0.0, 4.0]]
            .iter()
            .map(|&[x, y]| DVec3::new(x, y, x * y))
            .collect();
        let triangles = highest(&points).expect("a loop");
        let area = |&[a, b, c]: &[usize; 3]| {
            0.5 * (points[b] - points[a]).truncate().perp_dot((points[c] - points[a]).truncate())
        };
        assert!((triangles.iter().map(area).sum::<f64>() - 10.0).abs() < 1e-12);
    }
}
