//! Coincident segments with opposite directions: they touch up to the end of the shorter one.

use crate::each::Each;
use glam::DVec2;

use super::SkeletonError;
use super::arrangement::{Arrangement, Segment, SegmentEnd};
use super::contact::{Contacts, to_segment};
use super::wavefront::{Wavefront, turn_back};

impl Arrangement {
    /// Finds coincident segments of a cluster, so that the far end of the shorter one touches the other one. Returns
    /// whether a contact is new; if there is none, all pairs are known. Pairs of segments that were there before are
    /// skipped.
    pub(super) fn find_overlaps(
        &mut self,
        front: &Wavefront,
        contacts: &mut Contacts,
        before: &[Segment],
    ) -> Result<bool, SkeletonError> {
        let was_there = |segment: &Segment| {
            let first = before.partition_point(|old| old.edge < segment.edge);
            before[first..].iter().take_while(|old| old.edge == segment.edge).any(|old| old == segment)
        };
        // Empty in the first round, when all segments are new.
        let old: Vec<bool> = if before.is_empty() { Vec::new() } else { self.segments.iter().map(was_there).collect() };
        let is_new = |segment: usize| old.get(segment) != Some(&true);
        let mut found = false;
        for star in self.stars() {
            for incoming in star.incoming() {
                for outgoing in star.outgoing() {
                    if is_new(incoming) || is_new(outgoing) {
                        found |= self.overlap(front, contacts, [incoming, outgoing], front.epsilon);
                    }
                }
            }
        }
        if found {
            return Ok(true);
        }
        // Without another segment in between they meet, at any computed distance.
        self.pair_up(front);
        for &pair in &self.pairs {
            let [a, b] = pair.each(|segment| front.lines[self.segments[segment].line as usize]);
            if turn_back(&a, &b) {
                if !self.overlap(front, contacts, pair, f64::INFINITY) {
                    return Err(SkeletonError::Tangled);
                }
                found = true;
            }
        }
        Ok(found)
    }

    /// Records that a segment to a cluster and a segment from it touch, if they do. Returns whether this is new.
    fn overlap(&self, front: &Wavefront, contacts: &mut Contacts, pair: [usize; 2], near: f64) -> bool {
        let [incoming, outgoing] = pair.each(|segment| &self.segments[segment]);
        let position = |end: SegmentEnd| front.positions[end.vertex() as usize];
        let Some(ShortEnd { leaves, squared }) =
            short_end(position(incoming.from), position(incoming.to), position(outgoing.to))
        else {
            return false;
        };
        if squared > near * near {
            return false;
        }
        let (vertex, edge) =
            if leaves { (outgoing.to.vertex(), incoming.edge) } else { (incoming.from.vertex(), outgoing.edge) };
        if vertex == edge || vertex == front.vertices[edge as usize].next {
            contacts.tip(vertex)
        } else {
            contacts.touch(edge, vertex)
        }
    }
}

/// The far end of the shorter of two segments that meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortEnd {
    /// True if it is the end of the segment that leaves.
    pub(super) leaves: bool,
    /// The square of its distance from the other segment.
    pub(super) squared: f64,
}

/// The far end of the shorter segment of one `from` a place to `here` and one from here `to` a place; `None` if they lead to opposite
/// sides.
pub(super) fn short_end(from: DVec2, here: DVec2, to: DVec2) -> Option<ShortEnd> {
    let (a, b) = (from - here, to - here);
    if a.dot(b) <= 0.0 {
        return None;
    }
    let leaves = b.length_squared() <= a.length_squared();
    Some(ShortEnd { leaves, squared: if leaves { to_segment(to, here, from) } else { to_segment(from, here, to) } })
}
