//! Segments divided at their meeting points, with all vertices on the grid: snap rounding after Hobby.
//!
//! Ends and rounded crossings are *hot*. A segment that passes the unit square around a hot point is routed through
//! that point. So no two segments cross afterwards, and all segments that meet at a point share it.

use super::StreetError;
use super::grid::{Point, are_apart, dot, orient};
use super::progress::{EDGE, sort_and_dedup, spend};
use super::segment_tree::SegmentTree;
use cga_geometry::small_sort::SmallSort;

/// Divides segments at each other. Each becomes a chain of points from its first end to its second. An error if there are
/// more than `most` crossings, or if very many segments lie near each other or on one line.
pub(super) fn divide(segments: &[[Point; 2]], most: usize) -> Result<Vec<Vec<Point>>, StreetError> {
    let mut chains = round(segments, &crossings(segments, most)?, most)?;
    // Rounding errors of crossings may leave edges that still meet. This is rare, and one more round usually repairs
    // it.
    for _ in 0..MOST_ROUNDS {
        let mut edges: Vec<[Point; 2]> = chains.iter().flat_map(|chain| chain.windows(2).map(sorted)).collect();
        sort_and_dedup(&mut edges)?;
        let again = crossings(&edges, most)?;
        if again.is_empty() {
            break;
        }
        let parts = round(&edges, &again, most)?;
        for chain in &mut chains {
            spend(EDGE * chain.len())?;
            let mut finer = vec![chain[0]];
            for edge in chain.windows(2) {
                let Ok(at) = edges.binary_search(&sorted(edge)) else { continue };
                if edge[0] < edge[1] {
                    finer.extend(&parts[at][1..]);
                } else {
                    finer.extend(parts[at].iter().rev().skip(1));
                }
            }
            *chain = finer;
        }
    }
    Ok(chains)
}

/// The limit on rounds that repair edges that still meet.
const MOST_ROUNDS: usize = 8;

fn sorted(edge: &[Point]) -> [Point; 2] {
    [edge[0].min(edge[1]), edge[0].max(edge[1])]
}

/// The limit on comparisons of segments for each crossing that is allowed.
const COMPARISONS: usize = 128;

/// The crossings of segments: the number of a segment and the rounded point. An error if there are more than `most`, or if very
/// many segments lie near each other.
fn crossings(segments: &[[Point; 2]], most: usize) -> Result<Vec<(u32, Point)>, StreetError> {
    let tree = SegmentTree::of(segments.iter().copied());
    let (mut found, mut compared) = (Vec::new(), 0);
    for (second, &segment) in (0..).zip(segments) {
        let near = tree.near(segment, 0, |first| {
            if first < second
                && let Some(point) = crossing(segments[first as usize], segment)
            {
                found.extend([(first, point), (second, point)]);
            }
        });
        compared += near;
        if 8 * most < found.len() || COMPARISONS * most < compared {
            return Err(StreetError::TooDense { most });
        }
        spend(EDGE + 2 * near)?;
    }
    sort_and_dedup(&mut found)?;
    if found.len() <= 2 * most { Ok(found) } else { Err(StreetError::TooDense { most }) }
}

/// The limit on points inside of all chains for each crossing that is allowed, which bounds memory: segments on one line divide each other
/// without a crossing.
const INNER_POINTS: usize = 8;

/// Routes segments through all hot points that they pass, and through their own crossings. An error if the chains have very many
/// points.
fn round(segments: &[[Point; 2]], crossings: &[(u32, Point)], most: usize) -> Result<Vec<Vec<Point>>, StreetError> {
    let mut hot: Vec<Point> = segments.iter().flatten().copied().chain(crossings.iter().map(|one| one.1)).collect();
    sort_and_dedup(&mut hot)?;
    let pixels = SegmentTree::of(hot.iter().map(|point| [*point; 2]));
    let mut inner = 0;
    let chain = |(number, &segment): (usize, &[Point; 2])| {
        let [a, b] = segment;
        let from = crossings.partition_point(|one| (one.0 as usize) < number);
        let own = crossings[from..].iter().take_while(|one| one.0 as usize == number);
        let mut chain: Vec<Point> = own.map(|one| one.1).collect();
        let near = pixels.near(segment, 2, |number| {
            if passes(segment, hot[number as usize]) {
                chain.push(hot[number as usize]);
            }
        });
        spend(EDGE + 2 * near)?;
        let along = b.from(a);
        chain.small_sort_by_key(|point| (dot(along, point.from(a)), *point));
        chain.dedup();
        // Points within a unit of an end may sort before it.
        chain.retain(|&point| point != a && point != b);
        chain.insert(0, a);
        chain.push(b);
        inner += chain.len() - 2;
        if inner <= INNER_POINTS * most { Ok(chain) } else { Err(StreetError::TooDense { most }) }
    };
    segments.iter().enumerate().map(chain).collect()
}

/// The grid point nearest to the crossing of two segments, inside both.
fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<Point> {
    if are_apart([a, b], [c, d]) {
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

/// Returns true if a segment passes the unit square around a point.
fn passes([a, b]: [Point; 2], point: Point) -> bool {
    let outside = |a: i64, b: i64, at: i64| at < a.min(b) || a.max(b) < at;
    if outside(a.x, b.x, point.x) || outside(a.y, b.y, point.y) {
        return false;
    }
    // Compares the distance of the centre from the line with the distance of the farthest corner, in half units.
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
