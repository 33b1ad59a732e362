//! Corners with both edges above them, where regions begin.
//!
//! The status is searched only here. At all other corners the edges determine the region.

use std::cmp::Ordering;

use glam::DVec2;

use super::{ChainPoint, MonotoneSweep, NONE, SweepInterval};
use crate::each::Each;
use crate::exact::orient;
use crate::status::{LEFT, RIGHT};

impl MonotoneSweep {
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
            let right = self.regions[region as usize].edges[RIGHT];
            right_of(points[right as usize], points[self.next[right as usize] as usize]) < 0
        });
        let split = match around {
            Some(region) if turn <= 0 => Some(region),
            None if turn < 0 => self.beside(points, corner, [left, right]),
            _ => None,
        };
        let new = self.status.insert_after(split.or(left), [corner, a].each(|c| points[c as usize]));
        if let Some(region) = split {
            // The chain is divided at its latest point. The corner sees that point and continues from it in both
            // directions.
            let old = self.regions[region as usize];
            let ChainPoint { corner: last, beside: [_, next] } = self.links[old.latest as usize];
            self.links[old.latest as usize].beside[RIGHT] = NONE;
            let twin = self.link(last, [NONE, next]);
            let right_end = if old.ends[RIGHT] == old.latest { twin } else { old.ends[RIGHT] };
            self.add_region([a, old.edges[RIGHT]], [twin, right_end], twin);
            self.regions[region as usize].ends[RIGHT] = old.latest;
            self.set_edge(region, RIGHT, corner);
            self.attach(points, region, RIGHT, corner, out);
            self.attach(points, new, LEFT, corner, out);
        } else {
            let link = self.link(corner, [NONE; 2]);
            self.add_region([a, corner], [link; 2], link);
        }
    }

    fn add_region(&mut self, edges: [u32; 2], ends: [u32; 2], latest: u32) {
        let new = self.regions.len() as u32;
        edges.iter().for_each(|&edge| self.region[edge as usize] = new);
        self.regions.push(SweepInterval { edges, ends, latest });
    }

    /// The region of a hole that begins outside it, because loops cross by rounding errors: the nearer one of the
    /// regions to the left and to the right.
    fn beside(&self, points: &[DVec2], corner: u32, regions: [Option<u32>; 2]) -> Option<u32> {
        let distance = |region: u32, side: usize| {
            let edge = self.regions[region as usize].edges[side];
            let [a, b, p] = [edge, self.next[edge as usize], corner].each(|c| points[c as usize]);
            (b - a).perp_dot(p - a).abs() / (b - a).length()
        };
        let near = regions.into_iter().zip([RIGHT, LEFT]).filter_map(|(region, side)| Some((region?, side)));
        let near = near.map(|(region, side)| (distance(region, side), region));
        let nearest = near.min_by(|a, b| a.0.partial_cmp(&b.0).unwrap_or(Ordering::Equal))?;
        (nearest.0 <= self.slack).then_some(nearest.1)
    }
}
