//! Segments by place.

use cga_geometry::bounds_tree::BoundsTree;
use cga_geometry::mesh::Bounds;
use glam::DVec2;

use super::grid::Point;

/// The rounding error of the distance between a box and a line, relative to the distances in between.
const ROUNDING: f64 = 1e-12;

/// The boxes of segments.
pub(super) struct SegmentTree(BoundsTree);

impl SegmentTree {
    /// Segments by number. A point is a segment without length.
    pub(super) fn of(segments: impl Iterator<Item = [Point; 2]>) -> Self {
        let boxes: Vec<Bounds> =
            segments.map(|[a, b]| Bounds::of([flat(a).extend(0.0), flat(b).extend(0.0)])).collect();
        SegmentTree(BoundsTree::of(&boxes))
    }

    /// Calls `each` with the numbers of all segments whose boxes come within `margin` units of a segment, and of some others. Returns
    /// their count.
    pub(super) fn near(&self, [a, b]: [Point; 2], margin: i64, mut each: impl FnMut(u32)) -> usize {
        let [a, b] = [flat(a), flat(b)];
        let margin = margin as f64;
        let [low, high] = [a.min(b) - margin, a.max(b) + margin];
        let across = (b - a).perp();
        let is_near = |bounds: &Bounds| {
            let [from, to] = [bounds.low.truncate(), bounds.high.truncate()];
            if to.cmplt(low).any() || high.cmplt(from).any() {
                return false;
            }
            let (middle, half) = ((from + to) * 0.5 - a, (to - from) * 0.5 + margin);
            let reach = across.abs().dot(half) + ROUNDING * across.abs().dot(middle.abs() + half);
            across.dot(middle).abs() <= reach
        };
        let mut count = 0;
        self.0.visit(is_near, |number| {
            count += 1;
            each(number);
            true
        });
        count
    }
}

/// A point in grid units, which are exact.
fn flat(point: Point) -> DVec2 {
    DVec2::new(point.x as f64, point.y as f64)
}

#[cfg(test)]
mod tests {
    use super::super::grid::{are_apart, orient};
    use super::*;

    #[test]
    fn all_segments_that_meet_are_near() {
        let mut state = 3u64;
        for scale in [20.0, 1e6, 1e15] {
            let mut number = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                ((state >> 11) as f64 / (1u64 << 53) as f64 * scale) as i64
            };
            let mut point = || Point { x: number(), y: number() };
            let segments: Vec<[Point; 2]> = (0..200)
                .map(|at| {
                    let from = point();
                    [from, if at % 5 == 0 { from } else { point() }]
                })
                .collect();
            let tree = SegmentTree::of(segments.iter().copied());
            let sides = |[a, b]: [Point; 2], [c, d]: [Point; 2]| orient(a, b, c).signum() * orient(a, b, d).signum();
            for &segment in &segments {
                let mut found = Vec::new();
                let count = tree.near(segment, 2, |number| found.push(number));
                assert_eq!(count, found.len());
                for (number, &other) in (0..).zip(&segments) {
                    let meets = !are_apart(segment, other) && sides(segment, other) <= 0 && sides(other, segment) <= 0;
                    assert!(!meets || found.contains(&number), "{segment:?} {other:?}");
                }
            }
        }
    }
}
