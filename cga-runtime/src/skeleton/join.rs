//! The end of a stop: what comes to a meeting place is joined with what goes on from there.

use glam::DVec2;

use super::links::{End, Links};
use super::stop::Contacts;
use super::wavefront::{NONE, Wavefront};

impl Links {
    /// At each place, links that arrive with those that leave: the region is on their left, so each goes on with the next
    /// clockwise.
    pub(super) fn pairs(&self, front: &Wavefront) -> Vec<[usize; 2]> {
        let mut pairs = Vec::new();
        for junction in &self.junctions {
            if let ([arriving], [leaving]) = (&junction.arrive[..], &junction.depart[..]) {
                pairs.push([*arriving, *leaving]);
                continue;
            }
            let along = |link: usize| front.lines[self.list[link].edge as usize].along;
            let angle = |d: DVec2| libm::atan2(d.y, d.x);
            let arrive = junction.arrive.iter().map(|&link| (angle(-along(link)), false, link));
            let depart = junction.depart.iter().map(|&link| (angle(along(link)), true, link));
            let mut around: Vec<(f64, bool, usize)> = arrive.chain(depart).collect();
            let first = pairs.len();
            // Of two side by side the one that arrives is first, so that there is nothing between them.
            around.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
            let mut waiting: Vec<usize> = Vec::new();
            // What leaves before anything has arrived waits for the second round.
            let mut early: Vec<usize> = Vec::new();
            for (_, leaves, link) in around {
                if !leaves {
                    waiting.push(link);
                } else if let Some(arriving) = waiting.pop() {
                    pairs.push([arriving, link]);
                } else {
                    early.push(link);
                }
            }
            pairs.extend(early.into_iter().map_while(|link| Some([waiting.pop()?, link])));
            // Turning everything changes nothing but where the circle begins.
            pairs[first..].sort_unstable();
        }
        pairs
    }
}

/// Makes the new corners and joins them. Gives them.
pub(super) fn join(front: &mut Wavefront, contacts: &Contacts, links: &Links) -> Vec<u32> {
    let nodes = nodes(front, contacts, links);
    let node = |end: End| nodes[end.corner() as usize];
    for [a, b] in &links.cancelled {
        front.arcs.path(node(a.to), node(a.from), a.edge, b.edge);
    }
    for index in 0..front.alive.len() {
        let number = front.alive[index] as usize;
        let Some(place) = contacts.place(number as u32) else { continue };
        if nodes[place as usize] != NONE {
            let old = front.corners[number];
            front.arcs.path(old.node, nodes[place as usize], old.before, old.after);
            front.corners[number].alive = false;
        }
    }
    // For each link the corners at its ends.
    let mut ends: Vec<[u32; 2]> = links.list.iter().map(|link| [link.from, link.to].map(End::corner)).collect();
    let mut made = Vec::new();
    for [arriving, leaving] in links.pairs(front) {
        let new = front.corners.len() as u32;
        let [a, b] = [arriving, leaving].map(|link| links.list[link]);
        let corner = front.corner(node(a.to), a.edge, b.edge);
        front.corners.push(corner);
        (ends[arriving][1], ends[leaving][0]) = (new, new);
        made.push(new);
    }
    for [from, to] in ends {
        front.corners[from as usize].next = to;
        front.corners[to as usize].last = from;
    }
    let Wavefront { alive, corners, .. } = front;
    alive.retain(|&corner| corners[corner as usize].alive);
    alive.extend(&made);
    made
}

/// For each place, by its first corner, the point it becomes.
fn nodes(front: &mut Wavefront, contacts: &Contacts, links: &Links) -> Vec<u32> {
    let mut nodes = vec![NONE; front.corners.len()];
    let mut sums = vec![(DVec2::ZERO, 0.0); front.corners.len()];
    for &number in &front.alive {
        let Some(place) = contacts.place(number) else { continue };
        let corner = &front.corners[number as usize];
        if corner.born == front.now && nodes[place as usize] == NONE {
            // A point of this very moment.
            nodes[place as usize] = corner.node;
        }
        // The faster a corner, the less is known of where it is.
        let weight = 1.0 / corner.speed.length_squared().max(1.0);
        let (sum, weights) = &mut sums[place as usize];
        *sum += contacts.spots[number as usize] * weight;
        *weights += weight;
    }
    let mut kept = vec![NONE; front.corners.len()];
    for junction in &links.junctions {
        let place = junction.place as usize;
        kept[place] = if nodes[place] == NONE {
            front.nodes.push(sums[place].0 / sums[place].1);
            front.nodes.len() as u32 - 1
        } else {
            nodes[place]
        };
    }
    kept
}
