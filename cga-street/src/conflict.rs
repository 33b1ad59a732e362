//! Finds overlaps of roadways and assigns these parts to junctions.

use super::StreetError;
use super::grid::{Point, is_sliver};
use super::pieces::{JunctionDraft, Plot, StreetPieces};
use super::progress::{EDGE, spend};
use super::subdivision::{Subdivision, check_edges};
use cga_geometry::small_sort::SmallSort;

/// The limit on attempts to find a plan without overlaps. Each attempt enlarges junctions; most networks need three.
pub(super) const MOST_ATTEMPTS: usize = 16;

/// The margin in metres around an overlap that is also assigned to a junction.
const MARGIN: f64 = 1e-5;

/// The pieces of a plan after its overlaps between free roadways are resolved. Overlaps that are left after `attempts`
/// belong to the first of their streets. So the parts of a network never overlap, but such a street may have texture
/// coordinates that do not reach 0 or 1.
pub(super) fn resolve(plan: &mut JunctionDraft, attempts: usize) -> Result<StreetPieces, StreetError> {
    // A roadway and two sidewalks, with four edges each.
    check_edges(plan.chains.iter().map(|chain| 12 * chain.len()).sum())?;
    for _ in 0..attempts {
        let pieces = plan.pieces()?;
        let roads: Vec<usize> =
            (0..pieces.list.len()).filter(|&at| !matches!(pieces.list[at], Plot::Walk { .. })).collect();
        let rings: Vec<Vec<Point>> = roads.iter().map(|&at| pieces.list[at].ring()).collect();
        let faces = Subdivision::new(&rings)?;
        let mut changed = false;
        for (face, covers) in faces.covers.iter().enumerate().filter(|(_, covers)| 1 < covers.len()) {
            let ring = faces.ring(face);
            spend(EDGE * (ring.len() + covers.len()))?;
            if is_sliver(&ring) {
                continue;
            }
            spend(EDGE * ring.len() * covers.len())?;
            let cover = || covers.iter().map(|&road| &pieces.list[roads[road as usize]]);
            let laid_out =
                || cover().filter_map(|piece| if let Plot::Junction { node, .. } = piece { *node } else { None });
            if laid_out().next().is_some() {
                changed |= laid_out().fold(false, |any, node| plan.lower(node as usize) | any);
                continue;
            }
            for piece in cover() {
                if let &Plot::Road { chain, segment, free: true, ref cell, .. } = piece {
                    let cut = extent(plan, chain as usize, segment as usize, &ring);
                    let reach = cell.corners.iter().map(|corner| corner.value.x);
                    let low = reach.clone().fold(f64::INFINITY, f64::min);
                    let high = reach.fold(f64::NEG_INFINITY, f64::max);
                    let cut = [cut[0].clamp(low, high) - MARGIN, cut[1].clamp(low, high) + MARGIN];
                    plan.cuts[chain as usize].push(cut);
                    changed = true;
                }
            }
        }
        if !changed {
            return Ok(pieces);
        }
        plan.cuts.iter_mut().for_each(merge);
    }
    plan.pieces()
}

/// The distances along a chain that a ring in one of its segments covers.
fn extent(plan: &JunctionDraft, chain: usize, segment: usize, ring: &[Point]) -> [f64; 2] {
    let chain = &plan.chains[chain];
    let (from, along) = (chain.place(segment), chain.direction(segment));
    let distances = ring.iter().map(|point| chain.along[segment] + (point.place() - from).dot(along));
    distances.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
}

/// Sorts intervals and joins those that overlap.
fn merge(cuts: &mut Vec<[f64; 2]>) {
    cuts.small_sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut merged: Vec<[f64; 2]> = Vec::new();
    for &[low, high] in cuts.iter() {
        match merged.last_mut() {
            Some(last) if low <= last[1] => last[1] = last[1].max(high),
            _ => merged.push([low, high]),
        }
    }
    *cuts = merged;
}
