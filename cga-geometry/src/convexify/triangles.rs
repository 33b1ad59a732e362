//! Convex parts from triangles, for faces that cuts do not divide: corners that are nearly the same point, thousands of needles.

use std::collections::HashMap;

use super::net::Net;
use super::plane::Plane;
use super::rings::{Part, Rings};
use super::turn::is_reflex;
use crate::each::Each;
use crate::exact::orient;
use crate::small_sort::SmallSort;
use crate::triangulate::{Triangulator, is_filled};

/// Divides a face along diagonals between its corners. `None`, with an unchanged face, if the parts are not convex.
pub(super) fn divide(net: &mut Net, heads: &[u32], plane: &Plane) -> Option<Vec<Part>> {
    let loops: Vec<Vec<u32>> = heads.iter().map(|&head| net.ring(head).collect()).collect();
    let corners = loops.concat();
    let ends: Vec<u32> = loops.iter().scan(0, |end, ring| (*end += ring.len() as u32, Some(*end)).1).collect();
    let places: Vec<_> = corners.iter().map(|&corner| plane.flat(net, corner)).collect();
    let mut triangles = Vec::new();
    Triangulator::new().polygon(&places, &ends, &mut triangles);
    let is_turned = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.each(|k| places[k as usize]);
        orient(a, b, c) < 0
    };
    if triangles.iter().any(is_turned) {
        return None;
    }
    let before: Vec<[u32; 2]> = corners.iter().map(|&corner| [corner, net.next(corner)]).collect();
    let all = add(net, &corners, &triangles);
    // Long diagonals are removed first if the joined parts are convex.
    let mut diagonals: Vec<u32> =
        all.iter().copied().filter(|&half| net.is_cut(half) && half < net.mate(half)).collect();
    let length = |net: &Net, half: u32| (net.position(half) - net.position(net.next(half))).length();
    diagonals.small_sort_by(|&a, &b| length(net, b).total_cmp(&length(net, a)));
    for half in diagonals {
        let ends = [half, net.mate(half)];
        let opens = |net: &Net, half: u32| {
            let after = net.next(net.next(net.mate(half)));
            !is_reflex([net.before(half), half, after].each(|corner| plane.flat(net, corner)))
        };
        // A half-edge is the last one of its loop from the next one on.
        let rest = |half: u32| net.ring(half).skip(1).collect::<Vec<_>>();
        let joined = || [rest(ends[0]), rest(ends[1])].concat();
        if ends.into_iter().all(|half| opens(net, half)) && plane.is_convex_part(net, &joined()) {
            net.remove(half);
        }
    }
    let alive: Vec<u32> = all.iter().copied().filter(|&corner| net.is_alive(corner)).collect();
    let is_whole = all.iter().all(|&half| !net.is_cut(half) || net.mate(half) != half);
    let rings = is_whole.then(|| Rings::of(net, &alive, |net, corner| plane.flat(net, corner)));
    let parts = rings.and_then(|rings| rings.convex_parts());
    if parts.is_none() {
        before.iter().for_each(|&[corner, next]| net.chain(corner, next));
    }
    parts
}

/// Returns true if triangles fill a face. The triangles of a face that crosses itself do not.
pub(super) fn fill(net: &Net, heads: &[u32], plane: &Plane) -> bool {
    let flat = |&head: &u32| net.ring(head).map(|corner| plane.flat(net, corner)).collect();
    is_filled(&heads.iter().map(flat).collect::<Vec<_>>())
}

/// Makes a loop of each triangle. Their edges are edges of the loops, whose half-edges keep their numbers, and diagonals. Returns
/// all corners.
fn add(net: &mut Net, corners: &[u32], triangles: &[[u32; 3]]) -> Vec<u32> {
    // Numbers of a corner and its next one. Diagonals are joined with their other side.
    let mut next: Vec<Option<u32>> = corners.iter().map(|&corner| Some(net.next(corner))).collect();
    let mut halves: HashMap<[u32; 2], u32> = HashMap::new();
    let mut all = Vec::with_capacity(3 * triangles.len());
    for triangle in triangles {
        let side = |k: usize| [triangle[k], triangle[(k + 1) % 3]];
        let list = [0, 1, 2].each(|k| {
            let [from, to] = side(k).each(|end| end as usize);
            // A loop uses an edge once.
            (corners[from], next[from].take_if(|next| *next == corners[to]).is_some())
        });
        for (k, half) in net.ring_of(&list).into_iter().enumerate() {
            let [from, to] = side(k);
            if !list[k].1 {
                match halves.remove(&[to, from]) {
                    Some(other) => net.join(half, other),
                    None => drop(halves.insert([from, to], half)),
                }
            }
            all.push(half);
        }
    }
    all
}
