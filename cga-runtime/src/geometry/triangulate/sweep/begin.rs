//! Corners with both edges above them, where regions begin.
//!
//! The status is searched only here. At all other corners the edges determine the region.

use glam::DVec2;

use super::{Link, NONE, Region, Sweep};
use crate::geometry::exact::orient;

impl Sweep {
    /// A corner with both edges above it: the start of a region, or of a hole in one.
    pub(super) fn begin(&mut self, points: &[DVec2], corner: u32, out: &mut Vec<[u32; 3]>) {
        let (a, b) = (self.prev[corner as usize], self.next[corner as usize]);
        let turn = orient(points[a as usize], points[corner as usize], points[b as usize]);
        let right_of = |from: DVec2, to: DVec2| -> i32 {
            // If the corner is on the line, its own edges decide.
            let mut sides = [corner, a, b].into_iter().map(|c| orient(from, to, points[c as usize]));
            -sides.find(|&side| side != 0).unwrap_or(0)
        };
        let [left, right] = self.status.around(|[from, to]| right_of(from, to) > 0);
        let around = left.filter(|&region| {
            let right = self.regions[region as usize].right;
            right_of(points[right as usize], points[self.next[right as usize] as usize]) < 0
        });
        let new = self.regions.len() as u32;
        let split = match around {
            Some(region) if turn <= 0 => Some(region),
            None if turn < 0 => self.beside(points, corner, left, right),
            _ => None,
        };
        self.status.insert_after(split.or(left), [corner, a].map(|c| points[c as usize]));
        if let Some(region) = split {
            // The chain is divided at its latest point. The corner sees that point and continues from it in both
            // directions.
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

    /// The region of a hole that begins outside it, because loops cross by rounding errors: the nearer one of the
    /// regions to the left and to the right.
    fn beside(&self, points: &[DVec2], corner: u32, left: Option<u32>, right: Option<u32>) -> Option<u32> {
        let distance = |edge: u32| {
            let [a, b, p] = [edge, self.next[edge as usize], corner].map(|c| points[c as usize]);
            (b - a).perp_dot(p - a).abs() / (b - a).length()
        };
        let left = left.map(|region| (distance(self.regions[region as usize].right), region));
        let right = right.map(|region| (distance(self.regions[region as usize].left), region));
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
        (nearest.0 <= self.slack).then_some(nearest.1)
    }
}
