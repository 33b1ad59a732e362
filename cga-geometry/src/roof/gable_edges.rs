//! The edges of an outline that get gables.
//!
//! The page says that ends are gables and that they are computed. Here an *end* is a side whose face of the hip roof is a
//! triangle, between two convex corners, and whose neighbours run against each other. A side consists of neighbouring
//! edges that are nearly collinear.

use std::ops::Range;

use glam::DVec2;

use super::Outline;
use super::plan::Plan;
use crate::each::Each;
use crate::small_sort::SmallSort;
use crate::tol::TIE_EPSILON;

/// Edges belong to one side up to this angle, in radians (3 degrees).
const ONE_SIDE: f64 = 0.052;

/// The neighbours of an end turn by at least this angle, in radians (150 degrees).
const OPPOSITE: f64 = 2.618;

/// The corners of an end turn by at least this angle and by at most its supplement, in radians (20 degrees).
const SHARPEST: f64 = 0.349;

/// The sides of an outline.
struct Sides {
    /// The rings of the corners between sides.
    rings: Vec<Vec<u32>>,
    /// For each side the ring, the number of its first edge in the ring, and the number of its edges.
    edges: Vec<(usize, usize, usize)>,
}

/// For each edge, whether it is part of an end. Of two neighbouring ends the shorter one counts; of equal ones, as in a
/// square, those beside the first edge.
pub(super) fn ends(outline: &Outline<'_>) -> Vec<bool> {
    let sides = Sides::of(outline);
    let simple = Outline { points: outline.points, rings: &sides.rings, ..*outline };
    let corners = simple.edges();
    let mut found = vec![false; corners.len()];
    let Ok(plan) = Plan::of(&simple, &vec![1.0; corners.len()]) else { return vec![false; outline.edges().len()] };
    let mut candidates: Vec<(f64, usize)> = Vec::new();
    for face in plan.faces.iter().filter(|face| face.ring.len() == 3) {
        let side = face.edge as usize;
        let [last, next] = sides.neighbours(side);
        let turns = [[last, side], [side, next]].each(|[a, b]| turn(&simple, [corners[a], corners[b]]));
        let blunt = SHARPEST..=std::f64::consts::PI - SHARPEST;
        if turns.iter().all(|turn| blunt.contains(turn)) && OPPOSITE <= turns[0] + turns[1] {
            let length = simple.at(corners[side][0]).distance(simple.at(corners[side][1]));
            candidates.push((length, side));
        }
    }
    let longest = candidates.iter().fold(0.0, |most: f64, candidate| most.max(candidate.0));
    // Equal lengths: from the second side on, so that the first one keeps its eave.
    let place = |side: usize| if side == 0 { usize::MAX } else { side };
    let steps = |length: f64| (length / (TIE_EPSILON * longest)).round();
    candidates.small_sort_by(|a, b| steps(a.0).total_cmp(&steps(b.0)).then(place(a.1).cmp(&place(b.1))));
    for (_, side) in candidates {
        found[side] = !sides.neighbours(side).into_iter().any(|other| found[other]);
    }
    sides.of_edges(outline, &found)
}

/// For each edge of a convex polygon, whether it has a gable if the ridge is parallel to an edge: the sides that are
/// across the edge.
pub(super) fn ends_along(outline: &Outline<'_>, edge: usize) -> Vec<bool> {
    let edges = outline.edges();
    let along = outline.along(edges[edge]);
    let sides = Sides::of(outline);
    let simple = Outline { points: outline.points, rings: &sides.rings, ..*outline };
    let is_across = |side: [u32; 2]| along.dot(simple.along(side)).abs() < std::f64::consts::FRAC_1_SQRT_2;
    let found: Vec<bool> = simple.edges().into_iter().map(is_across).collect();
    sides.of_edges(outline, &found)
}

/// The angle from an edge to the next one, positive at a convex corner.
fn turn(outline: &Outline<'_>, edges: [[u32; 2]; 2]) -> f64 {
    let [a, b] = edges.each(|edge| outline.along(edge));
    libm::atan2(a.perp_dot(b), a.dot(b))
}

impl Sides {
    fn of(outline: &Outline<'_>) -> Self {
        let mut sides = Sides { rings: Vec::new(), edges: Vec::new() };
        for (number, ring) in outline.rings.iter().enumerate() {
            let kept = corners(outline, ring);
            let count = ring.len();
            sides.rings.push(kept.iter().map(|&i| ring[i]).collect());
            for (k, &i) in kept.iter().enumerate() {
                let next = kept[(k + 1) % kept.len()];
                sides.edges.push((number, i, (next + count - i - 1) % count + 1));
            }
        }
        sides
    }

    /// The sides of the ring of a side.
    fn ring(&self, side: usize) -> Range<usize> {
        let ring = self.edges[side].0;
        self.edges.partition_point(|side| side.0 < ring)..self.edges.partition_point(|side| side.0 <= ring)
    }

    /// The sides before and after a side.
    fn neighbours(&self, side: usize) -> [usize; 2] {
        let Range { start, end } = self.ring(side);
        [if side == start { end - 1 } else { side - 1 }, if side + 1 == end { start } else { side + 1 }]
    }

    /// A property of sides for all edges.
    fn of_edges(&self, outline: &Outline<'_>, found: &[bool]) -> Vec<bool> {
        let mut starts = vec![0];
        outline.rings.iter().for_each(|ring| starts.push(starts[starts.len() - 1] + ring.len()));
        let mut of = vec![false; starts[outline.rings.len()]];
        for (&(ring, first, count), &found) in self.edges.iter().zip(found) {
            let edges = outline.rings[ring].len();
            (first..first + count).for_each(|i| of[starts[ring] + i % edges] = found);
        }
        of
    }
}

/// The numbers of the corners of a ring where it turns. A chain of small turns keeps a corner as soon as it has turned by
/// more than the limit.
fn corners(outline: &Outline<'_>, ring: &[u32]) -> Vec<usize> {
    let count = ring.len();
    let along = |i: usize| (outline.at(ring[(i + 1) % count]) - outline.at(ring[i % count])).normalize_or(DVec2::X);
    let angle = |a: DVec2, b: DVec2| libm::atan2(a.perp_dot(b), a.dot(b)).abs();
    let sharp = |i: usize| angle(along(i + count - 1), along(i));
    let start = (0..count).find(|&i| ONE_SIDE < sharp(i));
    let Some(start) = start else { return (0..count).collect() };
    let (mut kept, mut direction) = (vec![start], along(start));
    for i in start + 1..start + count {
        if ONE_SIDE < angle(direction, along(i)) {
            kept.push(i % count);
            direction = along(i);
        }
    }
    kept.small_sort();
    if kept.len() < 3 { (0..count).collect() } else { kept }
}
