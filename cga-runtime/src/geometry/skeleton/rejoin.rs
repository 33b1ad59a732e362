//! The end of an event: new vertices join the segments that end at a cluster with the segments that begin there.

use glam::DVec2;

use super::arrangement::{Arrangement, Incidence, SegmentEnd};
use super::contact::Contacts;
use super::wavefront::{NONE, Wavefront};

impl Arrangement {
    /// The pairs of incoming and outgoing segments at each cluster. The region is on their left, so each incoming
    /// segment continues with the next outgoing one clockwise.
    pub(super) fn pairs(&self, front: &Wavefront) -> Vec<[usize; 2]> {
        let mut pairs = Vec::new();
        for incidence in &self.incidences {
            match (&incidence.incoming[..], &incidence.outgoing[..]) {
                ([incoming], [outgoing]) => pairs.push([*incoming, *outgoing]),
                _ => self.pairs_by_angle(front, incidence, &mut pairs),
            }
        }
        pairs
    }

    fn pairs_by_angle(&self, front: &Wavefront, incidence: &Incidence, pairs: &mut Vec<[usize; 2]>) {
        let along = |segment: usize| front.lines[self.segments[segment].line as usize].along;
        let angle = |d: DVec2| libm::atan2(d.y, d.x);
        let incoming = incidence.incoming.iter().map(|&segment| (angle(-along(segment)), false, segment));
        let outgoing = incidence.outgoing.iter().map(|&segment| (angle(along(segment)), true, segment));
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
    for vertex in contacts.vertices() {
        let node = node(contacts.cluster(vertex));
        if node != NONE {
            let old = front.vertices[vertex as usize];
            front.arcs.path(old.node, node, old.before, old.after);
            front.vertices[vertex as usize].alive = false;
        }
    }
    // The vertices at the ends of each segment.
    let mut ends: Vec<[u32; 2]> =
        arrangement.segments.iter().map(|segment| [segment.from, segment.to].map(SegmentEnd::vertex)).collect();
    let mut made = Vec::new();
    for [incoming, outgoing] in arrangement.pairs(front) {
        let new = front.vertices.len() as u32;
        let [a, b] = [incoming, outgoing].map(|segment| arrangement.segments[segment]);
        let vertex = front.vertex(node(a.to.vertex()), a.line, b.line);
        front.push(vertex);
        (ends[incoming][1], ends[outgoing][0]) = (new, new);
        made.push(new);
    }
    for [from, to] in ends {
        front.vertices[from as usize].next = to;
        front.vertices[to as usize].last = from;
    }
    let Wavefront { alive, vertices, .. } = front;
    alive.retain(|&vertex| vertices[vertex as usize].alive);
    alive.extend(&made);
    made
}

/// For each cluster where the wavefront changes, its node of the skeleton.
fn nodes(front: &mut Wavefront, contacts: &Contacts, arrangement: &Arrangement) -> Vec<u32> {
    let mut known = vec![None; arrangement.incidences.len()];
    let mut sums = vec![(DVec2::ZERO, 0.0); arrangement.incidences.len()];
    for vertex in contacts.vertices() {
        let Some(number) = arrangement.number(contacts.cluster(vertex)) else { continue };
        let position = front.positions[vertex as usize];
        let vertex = &front.vertices[vertex as usize];
        if vertex.born == front.now {
            // A node made at this very time.
            known[number] = known[number].or(Some(vertex.node));
        }
        // The faster a vertex, the less accurate its position.
        let weight = 1.0 / vertex.velocity.length_squared().max(1.0);
        let (sum, weights) = &mut sums[number];
        *sum += position * weight;
        *weights += weight;
    }
    let node =
        |(known, (sum, weights)): (Option<u32>, (DVec2, f64))| known.unwrap_or_else(|| front.node(sum / weights));
    known.into_iter().zip(sums).map(node).collect()
}
