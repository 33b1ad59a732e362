//! The last resort: an ear cutter that keeps the rim whatever the geometry.
//!
//! For loops that cross themselves or each other no triangulation is right. This one always has every edge of every loop
//! exactly once and the signed area of the polygon, so a mesh stays closed. Holes are joined to the outline by a bridge;
//! corners are cut while they are ears, and when none is left, whatever comes next is cut.

use glam::DVec2;

use crate::exact::orient;

/// Above this many corners no ears are searched for: it takes the square of their number.
const SEARCH_LIMIT: usize = 4000;

/// Appends the triangles.
pub(super) fn triangulate(points: &[DVec2], loop_ends: &[u32], out: &mut Vec<[u32; 3]>) {
    let mut ring = join(points, loop_ends);
    if ring.len() > SEARCH_LIMIT {
        out.extend((1..ring.len() - 1).map(|i| [ring[0], ring[i], ring[i + 1]]));
        return;
    }
    let mut at = 0;
    let mut missed = 0;
    while ring.len() > 3 {
        let count = ring.len();
        let [a, b, c] = [(at + count - 1) % count, at, (at + 1) % count].map(|i| ring[i]);
        let forced = missed > count;
        if forced || is_ear(points, &ring, [a, b, c]) {
            out.push([a, b, c]);
            ring.remove(at);
            // Not straight on: cutting every corner in turn would make a fan of slivers.
            at = if at + 1 < ring.len() { at + 1 } else { 0 };
            missed = 0;
        } else {
            at = (at + 1) % count;
            missed += 1;
        }
    }
    if let [a, b, c] = ring[..] {
        out.push([a, b, c]);
    }
}

fn is_ear(points: &[DVec2], ring: &[u32], t: [u32; 3]) -> bool {
    let [a, b, c] = t.map(|i| points[i as usize]);
    if orient(a, b, c) <= 0 {
        return false;
    }
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    !ring.iter().any(|&i| {
        let p = points[i as usize];
        p.cmpge(low).all()
            && p.cmple(high).all()
            && p != a
            && p != b
            && p != c
            && orient(a, b, p) >= 0
            && orient(b, c, p) >= 0
            && orient(c, a, p) >= 0
    })
}

/// One ring through all loops: from the nearest corner of what is joined already to each hole and back.
fn join(points: &[DVec2], loop_ends: &[u32]) -> Vec<u32> {
    let mut ring: Vec<u32> = (0..loop_ends[0]).collect();
    for pair in loop_ends.windows(2) {
        let hole: Vec<u32> = (pair[0]..pair[1]).collect();
        if hole.is_empty() {
            continue;
        }
        // The search is bounded: for very many corners the first will do.
        let few = ring.len().saturating_mul(hole.len()) <= SEARCH_LIMIT * SEARCH_LIMIT / 16;
        let (ring_seen, hole_seen) = if few { (ring.len(), hole.len()) } else { (ring.len().min(SEARCH_LIMIT), 1) };
        let mut best = (f64::INFINITY, 0, 0);
        for (i, &r) in ring[..ring_seen].iter().enumerate() {
            for (j, &h) in hole[..hole_seen].iter().enumerate() {
                let distance = points[r as usize].distance_squared(points[h as usize]);
                if distance < best.0 {
                    best = (distance, i, j);
                }
            }
        }
        let (_, i, j) = best;
        let mut joined = Vec::with_capacity(ring.len() + hole.len() + 2);
        joined.extend_from_slice(&ring[..=i]);
        joined.extend_from_slice(&hole[j..]);
        joined.extend_from_slice(&hole[..=j]);
        joined.extend_from_slice(&ring[i..]);
        ring = joined;
    }
    ring
}
