//! The winding numbers on both sides of edges that meet in points only, by a sweep.

use std::cmp::Ordering;

use super::grid::{GridPoint, side};
use super::noding::NodedEdge;
use crate::buckets::Buckets;
use crate::each::Each;
use crate::long_sort::long_sort_by;
use crate::small_sort::SmallSort;
use crate::work;

/// The units of work of a point, besides the moves of edges in the list.
const POINT: usize = 32;

/// The edges with a positive winding number on one side only, with that side on their left.
pub(super) fn outline(places: &[GridPoint], edges: &[NodedEdge]) -> Vec<[u32; 2]> {
    let mut starts = Buckets::default();
    starts.fill(places.len(), edges.iter().map(|edge| edge.ends[0]));
    let mut stops = vec![0u32; places.len()];
    edges.iter().for_each(|edge| stops[edge.ends[1] as usize] += 1);
    let used = |&(_, point): &(GridPoint, u32)| used(&starts, &stops, point);
    let mut order: Vec<(GridPoint, u32)> = places.iter().copied().zip(0..).filter(used).collect();
    if !long_sort_by(&mut order, Ord::cmp) {
        return Vec::new();
    }
    let mut sides = Vec::new();
    // The edges that the sweep line crosses, from the lowest one up, each with the winding number above it.
    let mut active: Vec<(u32, i32)> = Vec::new();
    let mut leaving: Vec<u32> = Vec::new();
    for (p, point) in order {
        // Edges enter and leave in the middle of the list.
        if !work::spend(POINT + active.len() / 8) {
            break;
        }
        let above = |edge: u32| {
            let [a, b] = edges[edge as usize].ends;
            b != point && 0 < side(places[a as usize], places[b as usize], p)
        };
        let mut low = active.partition_point(|entry| above(entry.0));
        if stops[point as usize] != 0 {
            // The edges that end here follow each other, unless edges are out of order by a rounding error.
            let ends_here = |entry: &(u32, i32)| edges[entry.0 as usize].ends[1] == point;
            let count = active[low..].iter().take_while(|entry| ends_here(entry)).count();
            if count == stops[point as usize] as usize {
                active.drain(low..low + count);
            } else {
                low = active.iter().position(ends_here).unwrap_or(low);
                active.retain(|entry| !ends_here(entry));
            }
        }
        leaving.clear();
        leaving.extend_from_slice(starts.of(point as usize));
        leaving.small_sort_by(|&a, &b| steeper(places, edges, p, a, b));
        let mut winding = if low == 0 { 0 } else { active[low - 1].1 };
        let mut entries = Vec::with_capacity(leaving.len());
        for &edge in &leaving {
            let NodedEdge { ends: [a, b], count, .. } = edges[edge as usize];
            let below = winding;
            winding += count;
            entries.push((edge, winding));
            match (0 < below, 0 < winding) {
                (false, true) => sides.push([a, b]),
                (true, false) => sides.push([b, a]),
                _ => {}
            }
        }
        active.splice(low..low, entries);
    }
    sides
}

fn used(starts: &Buckets, stops: &[u32], point: u32) -> bool {
    stops[point as usize] != 0 || !starts.of(point as usize).is_empty()
}

/// The order of two edges that leave a point, from the lowest one up.
fn steeper(places: &[GridPoint], edges: &[NodedEdge], from: GridPoint, a: u32, b: u32) -> Ordering {
    let [a, b] = [a, b].each(|edge| places[edges[edge as usize].ends[1] as usize]);
    0.cmp(&side(from, a, b))
}
