//! The end of an event: new vertices join the segments that end at a cluster with the segments that begin there.

use crate::each::Each;
use crate::small_sort::SmallSort;
use glam::DVec2;

use super::NONE;
use super::arrangement::{Arrangement, SegmentEnd, Star};
use super::contact::Contacts;
use super::wavefront::Wavefront;

impl Arrangement {
    /// Pairs the incoming with the outgoing segments at each cluster. The region is on their left, so each incoming
    /// segment continues with the next outgoing one clockwise.
    pub(super) fn pair_up(&mut self, front: &Wavefront) {
        let mut pairs = std::mem::take(&mut self.pairs);
        pairs.clear();
        for star in self.stars() {
            match (star.incoming().len(), star.outgoing().len()) {
                (1, 1) => pairs.extend(star.incoming().zip(star.outgoing()).map(|(from, to)| [from, to])),
                _ => self.pair_by_angle(front, star, &mut pairs),
            }
        }
        self.pairs = pairs;
    }

    fn pair_by_angle(&self, front: &Wavefront, star: Star<'_>, pairs: &mut Vec<[usize; 2]>) {
        let along = |segment: usize| front.lines[self.segments[segment].line as usize].along;
        let angle = |d: DVec2| libm::atan2(d.y, d.x);
        let incoming = star.incoming().map(|segment| (angle(-along(segment)), false, segment));
        let outgoing = star.outgoing().map(|segment| (angle(along(segment)), true, segment));
        let mut around: Vec<(f64, bool, usize)> = incoming.chain(outgoing).collect();
        let first = pairs.len();
        // Of two coincident segments the incoming one is first, so that the area between them is empty.
        around.small_sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
        let mut waiting: Vec<usize> = Vec::new();
        // Outgoing segments before any incoming one wait for the second round.
        let mut early: Vec<usize> = Vec::new();
        for (_, leaves, segment) in around {
            if !leaves {
                waiting.push(segment);
            } else if let Some(incoming) = waiting.pop() {
                pairs.push([incoming, segment]);
            } else {
                early.push(segment);
            }
        }
        pairs.extend(early.into_iter().map_while(|segment| Some([waiting.pop()?, segment])));
        // A rotation of the input changes only the start of the circle; sorting removes this difference.
        pairs[first..].small_sort();
    }
}

/// Ends the vertices of clusters where the wavefront changes, and makes the new vertices. Returns the new ones.
pub(super) fn rejoin(front: &mut Wavefront, contacts: &Contacts, arrangement: &mut Arrangement) -> Vec<u32> {
    arrangement.put_nodes(front, contacts);
    for [a, b] in &arrangement.cancelled {
        let [from, to] = [a.to, a.from].each(|end| arrangement.node(end.vertex()));
        front.arcs.path(from, to, a.line, b.line);
    }
    for &vertex in contacts.vertices() {
        let node = arrangement.node(contacts.cluster(vertex));
        if node != NONE {
            front.end_at(vertex, node);
        }
    }
    let mut made = Vec::with_capacity(arrangement.pairs.len());
    for index in 0..arrangement.pairs.len() {
        let [incoming, outgoing] = arrangement.pairs[index];
        let new = front.vertices.len() as u32;
        let [a, b] = [incoming, outgoing].each(|segment| arrangement.segments[segment]);
        let vertex = front.vertex(arrangement.node(a.to.vertex()), a.line, b.line);
        front.push(vertex);
        // From now on the segments end at vertices of the wavefront.
        arrangement.segments[incoming].to = SegmentEnd::Vertex(new);
        arrangement.segments[outgoing].from = SegmentEnd::Vertex(new);
        made.push(new);
    }
    for segment in &arrangement.segments {
        let [from, to] = [segment.from, segment.to].each(SegmentEnd::vertex);
        front.vertices[from as usize].next = to;
        front.vertices[to as usize].last = from;
    }
    front.renew(&made);
    made
}
