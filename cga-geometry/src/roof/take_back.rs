//! Negative overhangs: the parts of roof planes near eaves or pediments go.

use std::collections::BTreeMap;

use glam::DVec2;

use super::Outline;
use super::arcs::arcs;
use super::plan::{Plan, PlanFace};
use crate::skeleton::SkeletonError;
use crate::small_sort::SmallSort;
use crate::tol::TIE_EPSILON;

/// A line across faces: what is on its right goes.
#[derive(Clone, Copy)]
struct Line {
    from: DVec2,
    along: DVec2,
    /// The height of an eave, as a distance from the outline. Eaves are level also where `even` has moved points.
    height: Option<f64>,
    /// Its number among all lines that cut an arc. Eaves have one number, as neighbours meet at a hip at one distance.
    number: usize,
}

impl Line {
    /// The line to the left of an edge, at a distance.
    fn beside(outline: &Outline<'_>, edge: [u32; 2], distance: f64, number: usize) -> Self {
        let along = outline.along(edge);
        Line { from: outline.at(edge[0]) + along.perp() * distance, along, height: None, number }
    }
}

/// The points at which lines cut arcs, so that the faces on both sides of an arc have the same ones.
type Cuts = BTreeMap<([u32; 2], usize), u32>;

impl Plan {
    /// Takes planes back from their eaves by a distance, and from the pediments beside them by another, both as seen from above. The
    /// new eaves are level also where `even` bends planes. `ends` are the edges with pediments, which stay.
    ///
    /// # Errors
    /// No plane is left.
    pub(super) fn take_back(
        &mut self,
        outline: &Outline<'_>,
        ends: &[bool],
        [eave, end]: [f64; 2],
    ) -> Result<(), SkeletonError> {
        if eave == 0.0 && end == 0.0 {
            return Ok(());
        }
        let (edges, face_arcs, faces) = (outline.edges(), self.face_arcs(), std::mem::take(&mut self.faces));
        let size = outline.points.iter().fold(0.0, |most: f64, p| most.max(p.abs().max_element()));
        let (mut cuts, mut is_left) = (Cuts::new(), false);
        for PlanFace { edge, ring } in &faces {
            let (edge, mut rings) = (*edge, vec![ring.clone()]);
            if !ends[edge as usize] {
                let mut beside: Vec<u32> = arcs(ring)
                    .filter_map(|[a, b]| face_arcs.left_of([b, a]))
                    .map(|other| faces[other].edge)
                    .filter(|&other| ends[other as usize])
                    .collect();
                beside.small_sort_unstable();
                beside.dedup();
                let low = Line { height: Some(eave), ..Line::beside(outline, edges[edge as usize], eave, edges.len()) };
                let eave = (0.0 < eave).then_some(low);
                let line = |other: u32| Line::beside(outline, edges[other as usize], end, other as usize);
                let ends = beside.into_iter().filter(|_| 0.0 < end).map(line);
                for line in eave.into_iter().chain(ends) {
                    rings =
                        rings.iter().flat_map(|ring| self.left_of(ring, line, TIE_EPSILON * size, &mut cuts)).collect();
                }
                is_left |= !rings.is_empty();
            }
            let is_whole = matches!(&rings[..], [only] if only == ring);
            for mut ring in rings {
                if !is_whole {
                    self.begin_low(&mut ring, outline.along(edges[edge as usize]), TIE_EPSILON * size);
                }
                self.faces.push(PlanFace { edge, ring });
            }
        }
        if is_left { Ok(()) } else { Err(SkeletonError::Tangled) }
    }

    /// Rotates a ring to begin with its first arc along the lowest points, in the order along an edge.
    fn begin_low(&self, ring: &mut [u32], along: DVec2, near: f64) {
        let height = |point: u32| self.rises[point as usize];
        let low = ring.iter().map(|&point| height(point)).fold(f64::INFINITY, f64::min) + 2.0 * near;
        let found = arcs(ring).enumerate().filter(|(_, [a, b])| height(*a) <= low && height(*b) <= low);
        let place = |arc: [u32; 2]| along.dot(self.points[arc[0] as usize]);
        let first = found.min_by(|a, b| place(a.1).total_cmp(&place(b.1))).map(|found| found.0);
        ring.rotate_left(first.unwrap_or(0));
    }

    /// The parts of a ring on the left of a line, in their order along it.
    fn left_of(&mut self, ring: &[u32], line: Line, near: f64, cuts: &mut Cuts) -> Vec<Vec<u32>> {
        let across = line.along.perp();
        let ahead = |point: u32| {
            let ahead = match line.height {
                Some(height) => self.rises[point as usize] - height,
                None => across.dot(self.points[point as usize] - line.from),
            };
            if ahead.abs() <= near { 0.0 } else { ahead }
        };
        let heights: Vec<f64> = ring.iter().map(|&point| ahead(point)).collect();
        if heights.iter().all(|&height| 0.0 <= height) {
            return vec![ring.to_vec()];
        }
        // Runs of points on the left, each from the line to the line.
        let count = ring.len();
        let mut runs: Vec<Vec<u32>> = Vec::new();
        let starts: Vec<usize> = (0..count).filter(|&i| heights[i] <= 0.0 && 0.0 < heights[(i + 1) % count]).collect();
        for start in starts {
            let mut run = vec![self.cut(ring, &heights, start, line, cuts)];
            let mut i = (start + 1) % count;
            while 0.0 < heights[i] {
                run.push(ring[i]);
                i = (i + 1) % count;
            }
            run.push(self.cut(ring, &heights, (i + count - 1) % count, line, cuts));
            runs.push(run);
        }
        // Along the line, a part goes on from the end of a run to the next start.
        let place = |point: u32| line.along.dot(self.points[point as usize] - line.from);
        let order = |end: fn(&[u32]) -> u32| {
            let mut order: Vec<usize> = (0..runs.len()).collect();
            order.small_sort_by(|&a, &b| place(end(&runs[a])).total_cmp(&place(end(&runs[b]))));
            order
        };
        let (stops, starts) = (order(|run| run[run.len() - 1]), order(|run| run[0]));
        let mut next = vec![0; runs.len()];
        stops.iter().zip(&starts).for_each(|(&stop, &start)| next[stop] = start);
        let mut is_taken = vec![false; runs.len()];
        let mut rings = Vec::new();
        for first in stops {
            if is_taken[first] {
                continue;
            }
            let (mut ring, mut run) = (vec![runs[first][runs[first].len() - 1]], next[first]);
            loop {
                is_taken[run] = true;
                let points = &runs[run];
                ring.extend_from_slice(if run == first { &points[..points.len() - 1] } else { points });
                if run == first {
                    break;
                }
                run = next[run];
            }
            ring.dedup();
            if 3 <= ring.len() {
                rings.push(ring);
            }
        }
        rings
    }

    /// The point of an arc of a ring on a line: of its ends at most one is on the left.
    fn cut(&mut self, ring: &[u32], heights: &[f64], arc: usize, line: Line, cuts: &mut Cuts) -> u32 {
        let next = (arc + 1) % ring.len();
        let ends = [(ring[arc], heights[arc]), (ring[next], heights[next])];
        if let Some((point, _)) = ends.iter().find(|end| end.1 == 0.0) {
            return *point;
        }
        let [(a, ahead_a), (b, ahead_b)] = if ends[0].0 < ends[1].0 { ends } else { [ends[1], ends[0]] };
        if let Some(&known) = cuts.get(&([a, b], line.number)) {
            return known;
        }
        let share = ahead_a / (ahead_a - ahead_b);
        let [p, q] = [a, b].map(|point| self.points[point as usize]);
        let [low, high] = [a, b].map(|point| self.rises[point as usize]);
        let made = self.point(p.lerp(q, share), low + (high - low) * share);
        self.moved[made as usize] = self.moved[a as usize] || self.moved[b as usize];
        cuts.insert(([a, b], line.number), made);
        made
    }
}
