//! Segments divided where they meet, with all vertices on the grid: snap rounding after Hobby.
//!
//! Ends and rounded crossings are *hot*. A segment that passes the unit square around a hot point is led through that point.
//! So no two segments cross afterwards, and all that meet in a point share it.

use super::grid::{Buckets, Point, dot, orient};

/// Divides segments at each other. Each becomes a chain of points from its first end to its second. Nothing is returned when
/// there are more than `most` crossings.
pub(super) fn divide(segments: &[[Point; 2]], most: usize) -> Option<Vec<Vec<Point>>> {
    let mut buckets = Buckets::for_segments(segments);
    for (number, &segment) in segments.iter().enumerate() {
        buckets.add_segment(segment, number as u32);
    }
    let mut hot: Vec<Point> = segments.iter().flatten().copied().collect();
    let room = most.saturating_add(hot.len());
    for list in buckets.lists() {
        for (at, &first) in list.iter().enumerate() {
            for &second in &list[at + 1..] {
                hot.extend(crossing(segments[first as usize], segments[second as usize]));
            }
            if room < hot.len() {
                return None;
            }
        }
    }
    hot.sort_unstable();
    hot.dedup();
    let mut pixels = Buckets::for_segments(segments);
    for (number, &point) in hot.iter().enumerate() {
        pixels.add_point(point, number as u32);
    }
    let chain = |&segment: &[Point; 2]| {
        let [a, b] = segment;
        let mut chain: Vec<Point> = Vec::new();
        pixels.near_segment(segment, 2, |number| {
            if passes(segment, hot[number as usize]) {
                chain.push(hot[number as usize]);
            }
        });
        let along = b.from(a);
        chain.sort_unstable_by_key(|point| (dot(along, point.from(a)), *point));
        chain.dedup();
        // The ends are hot; neighbours of an end within a unit may sort before it.
        chain.retain(|&point| point != a && point != b);
        chain.insert(0, a);
        chain.push(b);
        chain
    };
    Some(segments.iter().map(chain).collect())
}

/// The grid point next to the place where two segments cross, inside of both.
fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<Point> {
    let apart = |a: i64, b: i64, c: i64, d: i64| a.max(b) < c.min(d) || c.max(d) < a.min(b);
    if apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y) {
        return None;
    }
    let (from_a, from_b) = (orient(c, d, a), orient(c, d, b));
    if from_a.signum() * from_b.signum() != -1 || orient(a, b, c).signum() * orient(a, b, d).signum() != -1 {
        return None;
    }
    let part = from_a as f64 / (from_a - from_b) as f64;
    let along = |a: i64, b: i64| a + ((b - a) as f64 * part).round() as i64;
    Some(Point { x: along(a.x, b.x), y: along(a.y, b.y) })
}

/// Whether a segment passes the unit square around a point.
fn passes([a, b]: [Point; 2], point: Point) -> bool {
    let outside = |a: i64, b: i64, at: i64| at < a.min(b) || a.max(b) < at;
    if outside(a.x, b.x, point.x) || outside(a.y, b.y, point.y) {
        return false;
    }
    // The corners of the square in half units: is the centre nearer to the line than the corner farthest across it?
    let (x, y) = b.from(a);
    2 * orient(a, b, point).abs() < x.abs() + y.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_of_random_segments_meet_in_their_points_only() {
        let mut state = 7u64;
        let mut next = |most: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % most) as i64
        };
        for round in 0..60 {
            let range = [8, 40, 1 << 20][round % 3];
            let mut point = || Point { x: next(range), y: next(range) };
            let segments: Vec<[Point; 2]> = (0..30).map(|_| [point(), point()]).filter(|[a, b]| a != b).collect();
            let chains = divide(&segments, 10_000).unwrap();
            let edges: Vec<[Point; 2]> =
                chains.iter().flat_map(|chain| chain.windows(2).map(|edge| [edge[0], edge[1]])).collect();
            for (at, &edge) in edges.iter().enumerate() {
                for &other in &edges[at + 1..] {
                    assert_eq!(crossing(edge, other), None, "{edge:?} {other:?}");
                    for end in other {
                        let inside = orient(edge[0], edge[1], end) == 0
                            && 0 < dot(edge[1].from(edge[0]), end.from(edge[0]))
                            && 0 < dot(edge[0].from(edge[1]), end.from(edge[1]));
                        assert!(!inside, "{edge:?} {end:?}");
                    }
                }
            }
        }
    }
}
