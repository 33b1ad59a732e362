//! The row of regions on the sweep line: where new ones go, and where old ones are.
//!
//! The row is only looked at where a region begins or goes; what belongs to what is otherwise known by its edges.

use glam::DVec2;

use super::{Link, NONE, Region, Sweep};
use crate::exact::orient;

impl Sweep {
    /// A corner with both edges above it: the start of a region, or of a hole in one.
    pub(super) fn begin(&mut self, points: &[DVec2], corner: u32, out: &mut Vec<[u32; 3]>) {
        let (a, b) = (self.prev[corner as usize], self.next[corner as usize]);
        let turn = orient(points[a as usize], points[corner as usize], points[b as usize]);
        let right_of = |from: u32, to: u32| -> i32 {
            // On the line it is the corner's own edges that tell.
            let [from, to] = [from, to].map(|c| points[c as usize]);
            let sides = [corner, a, b].map(|c| orient(from, to, points[c as usize]));
            -sides.into_iter().find(|&side| side != 0).unwrap_or(0)
        };
        let at = self.status.partition_point(|&region| {
            let left = self.regions[region as usize].left;
            right_of(self.next[left as usize], left) > 0
        });
        let left = at.checked_sub(1).map(|at| self.status[at]);
        let around = left.filter(|&region| {
            let right = self.regions[region as usize].right;
            right_of(right, self.next[right as usize]) < 0
        });
        let new = self.regions.len() as u32;
        let split = match around {
            Some(region) if turn <= 0 => Some((region, at)),
            None if turn < 0 => self.beside(points, corner, at),
            _ => None,
        };
        self.status.insert(split.map_or(at, |split| split.1), new);
        if let Some((region, _)) = split {
            // The chain parts at the point that came last; the corner sees it, and goes on from it both ways.
            let old = self.regions[region as usize];
            let Link { corner: last, next, .. } = self.links[old.latest as usize];
            self.links[old.latest as usize].next = NONE;
            let twin = self.link(last, NONE, next);
            let right_end = if old.right_end == old.latest { twin } else { old.right_end };
            self.regions.push(Region { left: a, right: old.right, left_end: twin, right_end, latest: twin });
            self.region[old.right as usize] = new;
            self.region[a as usize] = new;
            self.regions[region as usize].right_end = old.latest;
            self.set_right(region, corner);
            self.attach_right(points, region, corner, out);
            self.attach_left(points, new, corner, out);
        } else {
            let link = self.link(corner, NONE, NONE);
            self.regions.push(Region { left: a, right: corner, left_end: link, right_end: link, latest: link });
            self.region[a as usize] = new;
            self.region[corner as usize] = new;
        }
    }

    /// The hole of a region that begins outside of it, because loops cross by rounding: the region at hand, and the place in
    /// the row after it.
    fn beside(&self, points: &[DVec2], corner: u32, at: usize) -> Option<(u32, usize)> {
        let distance = |edge: u32| {
            let [a, b, p] = [edge, self.next[edge as usize], corner].map(|c| points[c as usize]);
            (b - a).perp_dot(p - a).abs() / (b - a).length()
        };
        let left = at
            .checked_sub(1)
            .map(|at| self.status[at])
            .map(|region| (distance(self.regions[region as usize].right), region, at));
        let right = self.status.get(at).map(|&region| (distance(self.regions[region as usize].left), region, at + 1));
        let nearest = match (left, right) {
            (Some(left), Some(right)) => {
                if right.0 < left.0 {
                    right
                } else {
                    left
                }
            }
            (left, right) => left.or(right)?,
        };
        (nearest.0 <= self.slack).then_some((nearest.1, nearest.2))
    }

    /// Takes a region whose left edge has come to its end out of the row.
    pub(super) fn remove(&mut self, points: &[DVec2], region: u32, corner: u32) {
        let guess = self.status.partition_point(|&other| {
            let left = self.regions[other as usize].left;
            let [from, to, p] = [self.next[left as usize], left, corner].map(|c| points[c as usize]);
            orient(from, to, p) < 0
        });
        let at = if self.status.get(guess) == Some(&region) {
            Some(guess)
        } else {
            self.status.iter().position(|&other| other == region)
        };
        if let Some(at) = at {
            self.status.remove(at);
        }
    }
}
