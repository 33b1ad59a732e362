//! Convex parts from triangles, for faces that cuts do not divide: corners that are nearly the same point, thousands of needles.

use std::collections::HashMap;

use glam::DVec2;

use super::net::Net;
use super::plane::Plane;
use super::rings::{Part, Rings, doubled_area};
use super::turn::is_reflex;
use crate::geometry::exact::orient;
use crate::geometry::tol::TOUCH_EPSILON;
use crate::geometry::triangulate::Triangulator;

/// Divides a face along diagonals between its corners. `None`, with an unchanged face, if the parts are not convex.
pub(super) fn divide(net: &mut Net, heads: &[u32], plane: &Plane) -> Option<Vec<Part>> {
    let loops: Vec<Vec<u32>> = heads.iter().map(|&head| net.ring(head).collect()).collect();
    let corners = loops.concat();
    let ends: Vec<u32> = loops.iter().scan(0, |end, ring| (*end += ring.len() as u32, Some(*end)).1).collect();
    let places: Vec<_> = corners.iter().map(|&corner| plane.flat(net, corner)).collect();
    let mut triangles = Vec::new();
    Triangulator::new().polygon(&places, &ends, &mut triangles);
    let is_turned = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|k| places[k as usize]);
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
    diagonals.sort_by(|&a, &b| length(net, b).total_cmp(&length(net, a)));
    for half in diagonals {
        let ends = [half, net.mate(half)];
        let opens = |net: &Net, half: u32| {
            let after = net.next(net.next(net.mate(half)));
            !is_reflex([net.before(half), half, after].map(|corner| plane.flat(net, corner)))
        };
        if ends.into_iter().all(|half| opens(net, half)) {
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

/// Returns true if holes look the other way than the outline and triangles fill the face: none of them is turned over, and their
/// areas add up to that of the face, except for a share of it. Those of a face that crosses itself do not.
pub(super) fn fill(net: &Net, heads: &[u32], plane: &Plane) -> bool {
    let loops: Vec<Vec<DVec2>> =
        heads.iter().map(|&head| net.ring(head).map(|corner| plane.flat(net, corner)).collect()).collect();
    let ends: Vec<u32> = loops.iter().scan(0, |end, ring| (*end += ring.len() as u32, Some(*end)).1).collect();
    let places = loops.concat();
    let mut triangles = Vec::new();
    Triangulator::new().polygon(&places, &ends, &mut triangles);
    let area = |[a, b, c]: [DVec2; 3]| (b - a).perp_dot(c - a);
    let (mut front, mut back) = (0.0, 0.0);
    for doubled in triangles.iter().map(|triangle| area(triangle.map(|k| places[k as usize]))) {
        *(if 0.0 < doubled { &mut front } else { &mut back }) += doubled;
    }
    let rings: Vec<f64> = loops.iter().map(|ring| doubled_area(ring)).collect();
    let whole: f64 = rings.iter().sum();
    let rounding = TOUCH_EPSILON * rings[0];
    rings[1..].iter().all(|&hole| hole <= 0.0) && -rounding <= back && (front - whole).abs() <= rounding
}

/// Makes a loop of each triangle. Their edges are those of the loops, whose half-edges keep their numbers, and diagonals. Returns
/// all corners.
fn add(net: &mut Net, corners: &[u32], triangles: &[[u32; 3]]) -> Vec<u32> {
    // Numbers of a corner and its next one. Diagonals are joined with their other side.
    let mut next: Vec<Option<u32>> = corners.iter().map(|&corner| Some(net.next(corner))).collect();
    let mut halves: HashMap<[u32; 2], u32> = HashMap::new();
    let mut all = Vec::with_capacity(3 * triangles.len());
    for triangle in triangles {
        let side = |k: usize| [triangle[k], triangle[(k + 1) % 3]];
        let list = [0, 1, 2].map(|k| {
            let [from, to] = side(k).map(|end| end as usize);
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
