//! Checks that the loops of a polygon are simple and nested, by one sweep from bottom to top.
//!
//! Two edges that have more in common than a corner are neighbours on the sweep line before it reaches the lowest such place, so
//! only neighbours are compared (Shamos and Hoey). All comparisons are exact. The edge beside the lowest corner of a hole decides
//! where the hole is.

use glam::DVec2;

use super::MeshError;
use crate::each::Each;
use crate::exact::orient;
use crate::small_sort::SmallSort;
use crate::status::{LEFT, RIGHT, Status, is_below};

/// An edge of a loop, in the plane.
#[derive(Clone, Copy)]
struct LoopEdge {
    /// Its ends in the order of the sweep.
    low: DVec2,
    high: DVec2,
    ring: u32,
    number: u32,
    /// True if the loop runs upwards here: the polygon is on the left then, otherwise on the right.
    rises: bool,
}

impl LoopEdge {
    /// The side of the edge on which a point is: 1 on the left, -1 on the right.
    fn side(&self, p: DVec2) -> i32 {
        orient(self.low, self.high, p)
    }

    /// Returns true if two edges have more in common than corners.
    fn meets(&self, other: &LoopEdge) -> bool {
        let [lows, highs] = [[self.low, self.high], [other.low, other.high]].map(|[a, b]| [a.min(b), a.max(b)]);
        let (low, high) = (lows[0].max(highs[0]), lows[1].min(highs[1]));
        if low.cmpgt(high).any() {
            return false;
        }
        let [c, d] = [other.low, other.high].each(|p| self.side(p));
        let [a, b] = [self.low, self.high].each(|p| other.side(p));
        if [a, b, c, d] == [0; 4] {
            // Edges in one line overlap if they have more than one point in common.
            return low != high;
        }
        if a * b < 0 && c * d < 0 {
            return true;
        }
        // True if a corner of one edge is inside the other edge.
        let is_inside =
            |side: i32, p: DVec2, edge: &LoopEdge| side == 0 && is_below(edge.low, p) && is_below(p, edge.high);
        is_inside(a, self.low, other)
            || is_inside(b, self.high, other)
            || is_inside(c, other.low, self)
            || is_inside(d, other.high, self)
    }
}

/// The place of a loop.
#[derive(Clone, Copy)]
enum HolePlace {
    /// In the outline and in no other hole. Also the place of the outline.
    Right,
    /// In another hole, by number, or outside of the outline.
    Wrong { within: Option<usize> },
}

/// A sweep in progress.
struct CrossingSweep {
    edges: Vec<LoopEdge>,
    status: Status,
    /// The edge of each entry of the status, and the entry of each edge.
    edge_of: Vec<u32>,
    entry_of: Vec<u32>,
}

/// Checks loops in a plane: the outline anticlockwise, then the holes clockwise.
///
/// # Errors
/// [`MeshError::SelfCrossing`] if edges cross, overlap, or touch except at corners, else [`MeshError::HolePlace`] for the first
/// hole that is outside of the outline or inside of another one.
pub(super) fn check(rings: &[Vec<DVec2>]) -> Result<(), MeshError> {
    let edges = edges_of(rings);
    let count = edges.len();
    let mut sweep = CrossingSweep {
        edges,
        status: Status::default(),
        edge_of: Vec::with_capacity(count),
        entry_of: vec![0; count],
    };
    sweep.run(rings.len())
}

/// The edges of loops, without those between two corners at one place.
fn edges_of(rings: &[Vec<DVec2>]) -> Vec<LoopEdge> {
    let mut edges = Vec::with_capacity(rings.iter().map(Vec::len).sum());
    for (ring, points) in (0..).zip(rings) {
        let next = points.iter().cycle().skip(1);
        for (number, (&a, &b)) in (0..).zip(points.iter().zip(next)) {
            if a != b {
                let rises = is_below(a, b);
                let [low, high] = if rises { [a, b] } else { [b, a] };
                edges.push(LoopEdge { low, high, ring, number, rises });
            }
        }
    }
    edges
}

impl CrossingSweep {
    fn run(&mut self, rings: usize) -> Result<(), MeshError> {
        let by = |a: DVec2, b: DVec2| a.y.total_cmp(&b.y).then(a.x.total_cmp(&b.x));
        let sorted = |end: fn(&LoopEdge) -> DVec2| {
            let mut order: Vec<(DVec2, u32)> =
                (0..).zip(&self.edges).map(|(number, edge)| (end(edge), number)).collect();
            order.small_sort_unstable_by(|a, b| by(a.0, b.0).then(a.1.cmp(&b.1)));
            order
        };
        let [starts, ends] = [sorted(|edge| edge.low), sorted(|edge| edge.high)];
        let (mut starts, mut ends) = (&starts[..], &ends[..]);
        let mut places: Vec<Option<HolePlace>> = vec![None; rings];
        places[0] = Some(HolePlace::Right);
        let mut here = Vec::new();
        while let Some(&(high, _)) = ends.first() {
            let at = starts.first().map_or(high, |&(low, _)| if is_below(high, low) { high } else { low });
            let ended = ends.iter().take_while(|end| end.0 == at).count();
            for &(_, edge) in &ends[..ended] {
                self.status.remove(self.entry_of[edge as usize]);
            }
            let began = starts.iter().take_while(|start| start.0 == at).count();
            here.clear();
            here.extend(starts[..began].iter().map(|start| start.1));
            let neighbours = self.around(at);
            if let [_, Some(right)] = neighbours
                && self.edges[right as usize].side(at) == 0
            {
                let other = here.first().copied().unwrap_or(ends[0].1);
                return Err(self.crossing(right, other));
            }
            (starts, ends) = (&starts[began..], &ends[ended..]);
            here.small_sort_unstable_by(|&a, &b| self.edges[a as usize].side(self.edges[b as usize].high).cmp(&0));
            for (k, &edge) in here.iter().enumerate() {
                let ring = self.edges[edge as usize].ring as usize;
                if places[ring].is_none() {
                    let before = here[..k].last().copied().or(neighbours[LEFT]);
                    places[ring] = Some(match before.map(|edge| self.edges[edge as usize]) {
                        // Right of an edge that falls is what is around its loop.
                        Some(LoopEdge { ring, rises: false, .. }) => places[ring as usize].unwrap_or(HolePlace::Right),
                        Some(LoopEdge { ring, .. }) => HolePlace::Wrong { within: (ring as usize).checked_sub(1) },
                        None => HolePlace::Wrong { within: None },
                    });
                }
            }
            let all = neighbours[LEFT].into_iter().chain(here.iter().copied()).chain(neighbours[RIGHT]);
            for (a, b) in all.clone().zip(all.skip(1)) {
                if self.edges[a as usize].meets(&self.edges[b as usize]) {
                    return Err(self.crossing(a, b));
                }
            }
            let mut after = neighbours[LEFT].map(|edge| self.entry_of[edge as usize]);
            for &edge in &here {
                let LoopEdge { low, high, .. } = self.edges[edge as usize];
                let entry = self.status.insert_after(after, [low, high]);
                self.entry_of[edge as usize] = entry;
                self.edge_of.push(edge);
                after = Some(entry);
            }
        }
        let holes = places.iter().skip(1).enumerate();
        let mut wrong = holes.filter_map(|(hole, place)| match place {
            Some(HolePlace::Wrong { within }) => Some(MeshError::HolePlace { hole, within: *within }),
            Some(HolePlace::Right) | None => None,
        });
        wrong.next().map_or(Ok(()), Err)
    }

    /// The last edge that is left of a point, and the first one that is not.
    fn around(&self, at: DVec2) -> [Option<u32>; 2] {
        let entries = self.status.around(|[low, high]| orient(low, high, at) < 0);
        entries.map(|entry| entry.map(|entry| self.edge_of[entry as usize]))
    }

    fn crossing(&self, a: u32, b: u32) -> MeshError {
        let mut pair = [a, b].map(|edge| {
            let LoopEdge { ring, number, .. } = self.edges[edge as usize];
            (ring as usize, number as usize)
        });
        pair.small_sort_unstable();
        MeshError::SelfCrossing { first: pair[0], second: pair[1] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::winding;
    use crate::random::Rng;

    /// The result of comparing every edge with every other one.
    fn crosses(rings: &[Vec<DVec2>]) -> bool {
        let edges = edges_of(rings);
        (0..edges.len()).any(|i| edges[..i].iter().any(|other| edges[i].meets(other)))
    }

    /// A loop without repeated corners, anticlockwise if `turn` is 1, else clockwise.
    fn ring(rng: &mut Rng, corners: u64, grid: u64, turn: f64) -> Vec<DVec2> {
        loop {
            let mut place = || DVec2::new((rng.next() % grid) as f64, (rng.next() % grid) as f64);
            let mut points: Vec<DVec2> = (0..corners).map(|_| place()).collect();
            points.dedup();
            let twice: f64 = (0..points.len()).map(|i| points[i].perp_dot(points[(i + 1) % points.len()])).sum();
            if points[0] != points[points.len() - 1] && twice != 0.0 {
                if twice * turn < 0.0 {
                    points.reverse();
                }
                return points;
            }
        }
    }

    #[test]
    fn the_sweep_finds_what_comparing_all_pairs_finds() {
        let mut rng = Rng(7);
        let (mut found, mut placed) = (0, [0; 3]);
        for _ in 0..20_000 {
            let grid = 5 + rng.next() % 40;
            let mut rings = vec![ring(&mut rng, 3 + grid % 4, grid, 1.0)];
            (0..rng.next() % 3).for_each(|_| rings.push(ring(&mut rng, 3, grid, -1.0)));
            let result = check(&rings);
            assert_eq!(matches!(result, Err(MeshError::SelfCrossing { .. })), crosses(&rings), "{rings:?}: {result:?}");
            if let Err(MeshError::SelfCrossing { first, second }) = result {
                let edge = |(ring, number): (usize, usize)| {
                    *edges_of(&rings)
                        .iter()
                        .find(|edge| (edge.ring, edge.number) == (ring as u32, number as u32))
                        .expect("an edge")
                };
                assert!(edge(first).meets(&edge(second)), "{rings:?}: {first:?} {second:?}");
                found += 1;
                continue;
            }
            let is_inside = |hole: usize, around: usize| {
                rings[hole].iter().find_map(|&p| winding(&rings[around], p)).is_some_and(|turns| turns != 0)
            };
            let is_wrong = |hole: &usize| {
                !is_inside(*hole, 0) || (1..rings.len()).any(|other| other != *hole && is_inside(*hole, other))
            };
            let expected = (1..rings.len()).find(is_wrong);
            match result {
                Err(MeshError::HolePlace { hole, within }) => {
                    assert_eq!(Some(hole + 1), expected, "{rings:?}");
                    assert!(within.is_none_or(|around| is_inside(hole + 1, around + 1)), "{rings:?}");
                    placed[usize::from(within.is_some())] += 1;
                }
                _ => {
                    assert_eq!(expected, None, "{rings:?}");
                    placed[2] += usize::from(1 < rings.len());
                }
            }
        }
        assert!(1000 < found && placed.iter().all(|count| 0 < *count), "{found} {placed:?}");
    }

    /// Turned, so that the boxes of all teeth overlap.
    #[test]
    fn a_comb_of_many_teeth_takes_no_square_of_its_corners() {
        let turn = DVec2::new(0.8, 0.6);
        let teeth = 50_000;
        let mut comb = vec![DVec2::ZERO, DVec2::new(f64::from(teeth), 0.0)];
        for tooth in (0..teeth).rev() {
            let x = f64::from(tooth);
            comb.extend([[x + 1.0, 1e6], [x + 0.5, 1e6], [x + 0.5, 1.0], [x, 1.0]].map(DVec2::from_array));
        }
        let mut comb: Vec<DVec2> = comb.into_iter().map(|p| turn.rotate(p)).collect();
        assert_eq!(check(&[comb.clone()]), Ok(()));
        let middle = comb.len() / 2;
        comb[middle] += turn * 1.5;
        assert!(matches!(check(&[comb]), Err(MeshError::SelfCrossing { .. })));
    }
}
