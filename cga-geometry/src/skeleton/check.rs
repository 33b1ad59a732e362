//! A check of results.
//!
//! The areas add up wherever points are, so strips overlap only if something is reversed. A strip of a straight
//! skeleton is connected and monotone along its edge. If speeds differ, it need not be monotone. Where only places count,
//! it may also go around edges that stay, as its outline and holes, so only the sum of its areas and its heights are
//! checked. The remaining interior has no crossings, and its loops are nested correctly.

use glam::DVec2;

use super::wavefront::{Wavefront, twice_area};
use super::{FrontCorner, Strip, Swept};
use crate::each::Each;
use crate::exact::orient;
use crate::exact::winding;
use crate::small_sort::SmallSort;
use crate::tol::{MEETING_EPSILONS, TOUCH_EPSILON};
use crate::work;

/// The multiple of the contact distance that counts as rounding.
const SLACK: f64 = 16.0;

impl Wavefront {
    /// Returns true if a result is possible for this wavefront.
    pub(super) fn allows(&self, swept: &Swept) -> bool {
        let slack = SLACK * self.epsilon;
        let rounding = MEETING_EPSILONS[0] * self.extent * self.extent;
        let uniform = self.lines.iter().all(|line| line.speed == 1.0);
        let mut places = Vec::new();
        swept.points.iter().all(|p| p.is_finite())
            && swept.strips.iter().all(|strip| self.is_possible(strip, &swept.points, slack, uniform, &mut places))
            && self.has_areas(&swept.strips, &swept.points, rounding, uniform || !self.flat)
            && !crosses(&swept.left, &swept.points, slack)
            && self.nests(swept)
    }

    /// Returns true if a strip is in front of its edge and, if all speeds are equal, goes along the edge once and returns
    /// once. `places` is a buffer.
    fn is_possible(&self, strip: &Strip, points: &[DVec2], slack: f64, uniform: bool, places: &mut Vec<DVec2>) -> bool {
        let line = &self.lines[strip.edge as usize];
        // Along the edge, and in front of it.
        let place = |&point: &u32| {
            let at = points[point as usize];
            DVec2::new(line.along.dot(at), line.normal().dot(at) - line.at)
        };
        places.clear();
        places.extend(strip.ring.iter().map(place));
        let count = places.len();
        // The time can be infinite.
        let farthest = if line.speed == 0.0 { 0.0 } else { self.until * line.speed };
        if !places.iter().all(|place| (-slack..=farthest + slack).contains(&place.y)) {
            return false;
        }
        if !uniform {
            return true;
        }
        let by = |a: &usize, b: &usize| places[*a].x.total_cmp(&places[*b].x);
        let (Some(low), Some(high)) = ((0..count).min_by(by), (0..count).max_by(by)) else { return false };
        let runs = |from: usize, to: usize, sign: f64| {
            let mut i = from;
            while i != to {
                let next = if i + 1 == count { 0 } else { i + 1 };
                let back = sign * (places[i].x - places[next].x);
                // A vertex that moves nearly along the edge touches it long before its exact contact.
                let is_flat = (places[i].y - places[next].y).abs() <= self.epsilon;
                if slack < back && !(is_flat && back <= TOUCH_EPSILON * self.extent) {
                    return false;
                }
                i = next;
            }
            true
        };
        runs(low, high, 1.0) && runs(high, low, -1.0)
    }

    /// Returns true if no strip is reversed and, if strips are `plain`, each edge has at most one strip, except
    /// for rounding errors.
    fn has_areas(&self, strips: &[Strip], points: &[DVec2], rounding: f64, plain: bool) -> bool {
        if !plain {
            let mut sums = vec![0.0; self.lines.len()];
            strips.iter().for_each(|strip| sums[strip.edge as usize] += twice_area(points, &strip.ring));
            return sums.iter().all(|sum| -rounding <= *sum);
        }
        if strips.iter().any(|strip| twice_area(points, &strip.ring) < -rounding) {
            return false;
        }
        let mut found = vec![false; self.lines.len()];
        let real = |strip: &&Strip| rounding < twice_area(points, &strip.ring);
        strips.iter().filter(real).all(|strip| !std::mem::replace(&mut found[strip.edge as usize], true))
    }

    /// Returns true if every loop of the remaining interior has the region on its left and no region on its right. A
    /// loop that has passed through itself is reversed.
    fn nests(&self, swept: &Swept) -> bool {
        let rings: Vec<Vec<DVec2>> = swept.left.iter().map(|ring| positions(ring, &swept.points)).collect();
        rings.iter().enumerate().all(|(number, ring)| {
            let turns = |p: DVec2| {
                let others = rings.iter().enumerate().filter(|(other, _)| *other != number);
                others.map(|(_, other)| winding(other, p)).sum::<Option<i32>>()
            };
            let middles = (0..ring.len()).map(|i| ring[i].midpoint(ring[(i + 1) % ring.len()]));
            // Tests a side that touches no other loop.
            let around = middles.into_iter().find_map(turns);
            let own = i32::from(0.0 < area(ring));
            around.is_none_or(|around| around + own == i32::from(!self.unbounded))
        })
    }
}

fn positions(ring: &[FrontCorner], points: &[DVec2]) -> Vec<DVec2> {
    ring.iter().map(|left| points[left.point as usize]).collect()
}

fn area(ring: &[DVec2]) -> f64 {
    (1..ring.len() - 1).map(|i| (ring[i] - ring[0]).perp_dot(ring[i + 1] - ring[0])).sum()
}

/// Returns true if loops of the remaining interior cross by more than `slack`.
fn crosses(left: &[Vec<FrontCorner>], points: &[DVec2], slack: f64) -> bool {
    let mut edges: Vec<[DVec2; 2]> = Vec::new();
    for ring in left {
        let at = |i: usize| points[ring[i % ring.len()].point as usize];
        edges.extend((0..ring.len()).map(|i| [at(i), at(i + 1)]));
    }
    any_cross(edges, slack)
}

/// Returns true if two of some edges cross by more than `slack`.
pub(crate) fn any_cross(mut edges: Vec<[DVec2; 2]>, slack: f64) -> bool {
    edges.small_sort_by(|e, f| e[0].x.min(e[1].x).total_cmp(&f[0].x.min(f[1].x)));
    edges.iter().enumerate().any(|(i, edge)| {
        let reach = edge[0].x.max(edge[1].x);
        let near = edges[i + 1..].iter().take_while(|other| other[0].x.min(other[1].x) <= reach);
        // If the work is to end, the answer does not matter.
        let mut compared = 1;
        near.inspect(|_| compared += 1).any(|other| cross(edge, other, slack)) || !work::spend(compared)
    })
}

fn cross(e: &[DVec2; 2], f: &[DVec2; 2], slack: f64) -> bool {
    let apart = |i: usize| e[0][i].max(e[1][i]) < f[0][i].min(f[1][i]) || f[0][i].max(f[1][i]) < e[0][i].min(e[1][i]);
    if apart(0) || apart(1) {
        return false;
    }
    let sides = |e: &[DVec2; 2], f: &[DVec2; 2]| f.each(|p| orient(e[0], e[1], p));
    let ([a, b], [c, d]) = (sides(e, f), sides(f, e));
    if a * b >= 0 || c * d >= 0 {
        return false;
    }
    // All four ends are far from the other edge.
    let away = |e: &[DVec2; 2], p: DVec2| (e[1] - e[0]).perp_dot(p - e[0]).abs() > slack * e[0].distance(e[1]);
    f.iter().all(|&p| away(e, p)) && e.iter().all(|&p| away(f, p))
}
