//! The end of an event: new vertices join the segments that end at a cluster with the segments that begin there.

use glam::DVec2;

use super::arrangement::{Arrangement, SegmentEnd, Star};
use super::contact::Contacts;
use super::wavefront::{NONE, Wavefront};

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
        around.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
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
        pairs[first..].sort_unstable();
    }
}

/// Ends the vertices of clusters where the wavefront changes, and makes the new vertices. Returns the new ones.
pub(super) fn rejoin(front: &mut Wavefront, contacts: &Contacts, arrangement: &Arrangement) -> Vec<u32> {
    let nodes = nodes(front, contacts, arrangement);
    let node = |cluster: u32| arrangement.number(cluster).map_or(NONE, |number| nodes[number]);
    for [a, b] in &arrangement.cancelled {
        front.arcs.path(node(a.to.vertex()), node(a.from.vertex()), a.line, b.line);
    }
    for &vertex in contacts.vertices() {
        let node = node(contacts.cluster(vertex));
        if node != NONE {
            front.end(vertex, node);
        }
    }
    // The vertices at the ends of each segment.
    let mut ends: Vec<[u32; 2]> =
        arrangement.segments.iter().map(|segment| [segment.from, segment.to].map(SegmentEnd::vertex)).collect();
    let mut made = Vec::new();
    for &[incoming, outgoing] in &arrangement.pairs {
        let new = front.vertices.len() as u32;
        let [a, b] = [incoming, outgoing].map(|segment| arrangement.segments[segment]);
        let vertex = front.vertex(node(a.to.vertex()), a.line, b.line);
        front.push(vertex);
        (ends[incoming][1], ends[outgoing][0]) = (new, new);
        made.push(new);
    }
    for [from, to] in ends {
        front.link(from, to);
    }
    let Wavefront { alive, vertices, .. } = front;
    alive.retain(|&vertex| vertices[vertex as usize].alive);
    alive.extend(&made);
    made
}

/// For each cluster where the wavefront changes, its node of the skeleton.
fn nodes(front: &mut Wavefront, contacts: &Contacts, arrangement: &Arrangement) -> Vec<u32> {
    let mut meetings = vec![MeetingPoint::NONE; arrangement.clusters().len()];
    for &vertex in contacts.vertices() {
        if let Some(number) = arrangement.number(contacts.cluster(vertex)) {
            meetings[number].add(front, vertex);
        }
    }
    meetings.into_iter().map(|meeting| meeting.node(front)).collect()
}

/// The place where vertices meet: their mean. The faster a vertex, the less accurate its position.
#[derive(Clone, Copy, Debug)]
pub(super) struct MeetingPoint {
    /// A node that was made at the current time.
    known: Option<u32>,
    sum: DVec2,
    weights: f64,
}

impl MeetingPoint {
    /// Nothing has met yet.
    pub(super) const NONE: Self = MeetingPoint { known: None, sum: DVec2::ZERO, weights: 0.0 };

    pub(super) fn add(&mut self, front: &Wavefront, vertex: u32) {
        let position = front.positions[vertex as usize];
        let vertex = &front.vertices[vertex as usize];
        if vertex.born == front.now {
            self.known = self.known.or(Some(vertex.node));
        }
        let weight = 1.0 / vertex.velocity.length_squared().max(1.0);
        self.sum += position * weight;
        self.weights += weight;
    }

    /// The node of the skeleton at this place.
    pub(super) fn node(self, front: &mut Wavefront) -> u32 {
        self.known.unwrap_or_else(|| front.node(self.sum / self.weights))
    }
}

impl Wavefront {
    /// Ends a vertex at a node.
    pub(super) fn end(&mut self, vertex: u32, node: u32) {
        let old = &mut self.vertices[vertex as usize];
        old.alive = false;
        self.arcs.path(old.node, node, old.before, old.after);
    }

    /// Connects two vertices by an edge.
    pub(super) fn link(&mut self, from: u32, to: u32) {
        self.vertices[from as usize].next = to;
        self.vertices[to as usize].last = from;
    }
}
