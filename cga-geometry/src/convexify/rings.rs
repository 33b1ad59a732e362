//! The loops of a face that was cut, as parts.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;

use super::net::Net;
use super::turn::is_convex;
use crate::nesting::polygons::NestedRings;
use crate::small_sort::sort_owned_by;
use crate::triangulate::doubled_area;

/// A part of a face: the first corners of its loops, the outline first.
pub(super) type Part = Vec<u32>;

/// The loops of a face.
pub(super) struct Rings {
    /// The corners, and their places.
    corners: Vec<u32>,
    flat: Vec<DVec2>,
    /// The loops as indices of the corners.
    rings: Vec<Vec<u32>>,
}

impl Rings {
    /// The loops of some corners. Cuts with the same loop on both sides divide nothing and are removed.
    pub(super) fn of(net: &mut Net, corners: &[u32], flat: impl Fn(&Net, u32) -> DVec2) -> Self {
        let loops = walk(net, corners);
        let mut ring_of = BTreeMap::new();
        for (number, ring) in (0u32..).zip(&loops) {
            ring_of.extend(ring.iter().map(|&corner| (corner, number)));
        }
        let bridges: Vec<u32> = corners
            .iter()
            .copied()
            .filter(|&half| net.is_cut(half) && half < net.mate(half) && ring_of[&half] == ring_of[&net.mate(half)])
            .collect();
        let loops = if bridges.is_empty() {
            loops
        } else {
            bridges.into_iter().for_each(|half| net.remove(half));
            walk(net, &corners.iter().copied().filter(|&corner| net.is_alive(corner)).collect::<Vec<_>>())
        };
        let corners: Vec<u32> = loops.iter().flatten().copied().collect();
        let mut next = 0..;
        let rings = loops.iter().map(|ring| next.by_ref().take(ring.len()).collect()).collect();
        let flat = corners.iter().map(|&corner| flat(net, corner)).collect();
        Rings { corners, flat, rings }
    }

    /// Each loop as a part. `None` if one of them is not convex.
    pub(super) fn convex_parts(&self) -> Option<Vec<Part>> {
        let place = |&k: &u32| self.flat[k as usize];
        let convex = self.rings.iter().all(|ring| is_convex(&ring.iter().map(place).collect::<Vec<_>>()));
        convex.then(|| self.in_order(self.rings.iter().map(|ring| vec![ring.as_slice()])))
    }

    /// Outlines with their holes. `None` if a hole is in no outline, or if a loop has fewer than three points.
    pub(super) fn parts(&self) -> Option<Vec<Part>> {
        let nested = NestedRings::of_anticlockwise(&self.flat, self.rings.iter().map(|ring| ring.iter().copied()));
        let polygons: Vec<Vec<&[u32]>> = nested.polygons().map(Iterator::collect).collect();
        let area = |ring: &[u32]| doubled_area(&ring.iter().map(|&k| self.flat[k as usize]).collect::<Vec<_>>());
        let is_part = |rings: &Vec<&[u32]>| {
            0.0 <= area(rings[0])
                && rings[1..].iter().all(|hole| area(hole) <= 0.0)
                && rings.iter().all(|ring| self.has_three_points(ring))
        };
        polygons.iter().all(is_part).then(|| self.in_order(polygons.into_iter()))
    }

    fn has_three_points(&self, ring: &[u32]) -> bool {
        let at = |k: u32| self.flat[k as usize];
        let Some((&first, others)) = ring.split_first() else { return false };
        let mut others = others.iter().map(|&k| at(k)).filter(|&place| place != at(first));
        others.next().is_some_and(|second| others.any(|place| place != second))
    }

    fn in_order<'r>(&'r self, parts: impl Iterator<Item = Vec<&'r [u32]>>) -> Vec<Part> {
        let corners = |ring: &[u32]| ring.iter().map(|&k| self.corners[k as usize]).collect();
        in_order(parts.map(|rings| rings.into_iter().map(corners).collect()).collect())
    }
}

/// Parts in the order of their lowest corners, which their loops begin with: the first edge of the face comes first.
pub(super) fn in_order(parts: Vec<Vec<Vec<u32>>>) -> Vec<Part> {
    let first = |ring: &Vec<u32>| ring.iter().copied().min().unwrap_or(0);
    let mut parts: Vec<Part> = parts.iter().map(|rings| rings.iter().map(first).collect()).collect();
    sort_owned_by(&mut parts, Ord::cmp);
    parts
}

/// The loops of some corners, in the order of these.
fn walk(net: &Net, corners: &[u32]) -> Vec<Vec<u32>> {
    let mut seen: BTreeSet<u32> = BTreeSet::new();
    let mut loops = Vec::new();
    for &corner in corners {
        if !seen.contains(&corner) {
            let ring: Vec<u32> = net.ring(corner).collect();
            seen.extend(&ring);
            loops.push(ring);
        }
    }
    loops
}
