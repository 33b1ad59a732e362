//! Centre lines between junctions: chains of edges with the same widths, with bends as arcs, mitres or breaks.

use glam::DVec2;

use super::graph::Graph;
use super::input::{Centerline, NetworkOptions};

/// Bends sharper than this angle in degrees get no mitre.
const MOST_MITRE: f64 = 100.0;

/// The room that an arc leaves on the inner side of a bend, in metres.
const ARC_ROOM: f64 = 2.0;

/// The largest angle between two parts of an arc, in degrees.
const ARC_STEP: f64 = 10.0;

/// A kerb keeps at least this part of the length of the centre line in a bend.
const LEAST_KERB: f64 = 0.02;

/// The widths of a street along a chain, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Widths {
    /// Half of the roadway.
    pub(super) half: f64,
    pub(super) left: f64,
    pub(super) right: f64,
}

impl Widths {
    fn turned(self) -> Self {
        Widths { left: self.right, right: self.left, ..self }
    }

    /// The distances from the centre line of the four borders, from left to right, positive on the left.
    pub(super) fn borders(&self) -> [f64; 4] {
        [self.half + self.left, self.half, -self.half, -(self.half + self.right)]
    }
}

/// A point where chains meet.
#[derive(Clone, Debug)]
pub(super) struct ChainNode {
    pub(super) place: DVec2,
    pub(super) height: f64,
    /// True if it is a bend too tight for a mitre, rather than a vertex of the graph where streets meet.
    pub(super) is_bend: bool,
    /// The chains that meet here, by number, and the end of each.
    pub(super) arms: Vec<(u32, usize)>,
}

/// A poly-line with widths. A closed chain ends at its first point.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) places: Vec<DVec2>,
    pub(super) heights: Vec<f64>,
    /// The line of each segment, and whether the chain has the line's direction.
    pub(super) lines: Vec<(u32, bool)>,
    pub(super) widths: Widths,
    /// The node at each end; none at a dead end.
    pub(super) ends: [Option<u32>; 2],
    pub(super) closed: bool,
    /// The distance of each place from the start.
    pub(super) along: Vec<f64>,
}

/// Finds the chains of a graph.
struct Walker<'a> {
    graph: &'a Graph,
    lines: &'a [Centerline],
    seen: Vec<bool>,
}

impl Walker<'_> {
    /// The widths of an edge in the direction away from a vertex.
    fn widths(&self, edge: u32, from: u32) -> Widths {
        let edge = &self.graph.edges[edge as usize];
        let line = &self.lines[edge.line as usize];
        let along = Widths { half: line.roadway / 2.0, left: line.sidewalks[0], right: line.sidewalks[1] };
        if edge.ends[0] == from { along } else { along.turned() }
    }

    fn other(&self, edge: u32, from: u32) -> u32 {
        let [a, b] = self.graph.edges[edge as usize].ends;
        if a == from { b } else { a }
    }

    /// The edge on which a chain continues after a vertex.
    fn follow(&self, edge: u32, at: u32) -> Option<u32> {
        let &[a, b] = self.graph.around[at as usize].as_slice() else { return None };
        let next = if a == edge { b } else { a };
        (self.widths(edge, self.other(edge, at)) == self.widths(next, at)).then_some(next)
    }

    fn walk(&mut self, from: u32, first: u32) -> Chain {
        let graph = self.graph;
        let end = |vertex: u32| (graph.around[vertex as usize].len() != 1).then_some(vertex);
        let mut chain = Chain {
            places: vec![graph.places[from as usize]],
            heights: vec![graph.heights[from as usize]],
            lines: Vec::new(),
            widths: self.widths(first, from),
            ends: [end(from); 2],
            closed: false,
            along: Vec::new(),
        };
        let (mut at, mut edge) = (from, first);
        loop {
            self.seen[edge as usize] = true;
            chain.lines.push((graph.edges[edge as usize].line, graph.edges[edge as usize].ends[0] == at));
            at = self.other(edge, at);
            chain.places.push(graph.places[at as usize]);
            chain.heights.push(graph.heights[at as usize]);
            chain.ends[1] = end(at);
            match self.follow(edge, at) {
                Some(next) if !self.seen[next as usize] => edge = next,
                next => {
                    chain.closed = next.is_some();
                    return chain;
                }
            }
        }
    }
}

/// The chains of a graph with arcs at bends, and the nodes where they meet.
pub(super) fn chains(graph: &Graph, lines: &[Centerline], options: &NetworkOptions) -> (Vec<Chain>, Vec<ChainNode>) {
    let mut walker = Walker { graph, lines, seen: vec![false; graph.edges.len()] };
    let mut raw = Vec::new();
    for (vertex, around) in graph.around.iter().enumerate() {
        for &edge in around {
            if !walker.seen[edge as usize] && walker.follow(edge, vertex as u32).is_none() {
                raw.push(walker.walk(vertex as u32, edge));
            }
        }
    }
    for (edge, ends) in graph.edges.iter().enumerate() {
        if !walker.seen[edge] {
            raw.push(walker.walk(ends.ends[0], edge as u32));
        }
    }
    let node = |vertex: usize| ChainNode {
        place: graph.places[vertex],
        height: graph.heights[vertex],
        is_bend: false,
        arms: Vec::new(),
    };
    let mut nodes: Vec<ChainNode> = (0..graph.places.len()).map(node).collect();
    let mut done: Vec<Chain> = Vec::new();
    for mut chain in raw {
        chain.round_bends(options.arc_above.to_radians());
        done.extend(chain.broken(&mut nodes));
    }
    for (number, chain) in done.iter_mut().enumerate() {
        let mut sum = 0.0;
        chain.along = vec![0.0];
        for ends in chain.places.windows(2) {
            sum += ends[0].distance(ends[1]);
            chain.along.push(sum);
        }
        for (at, end) in chain.ends.iter().enumerate() {
            if let Some(node) = end.filter(|_| !chain.closed) {
                nodes[node as usize].arms.push((number as u32, at));
            }
        }
    }
    (done, nodes)
}

/// The angle between two directions, positive to the left.
pub(super) fn turn(before: DVec2, after: DVec2) -> f64 {
    libm::atan2(before.perp_dot(after), before.dot(after))
}

impl Chain {
    /// The number of segments.
    pub(super) fn len(&self) -> usize {
        self.lines.len()
    }

    pub(super) fn length(&self) -> f64 {
        self.along[self.len()]
    }

    /// The direction of a segment.
    pub(super) fn direction(&self, segment: usize) -> DVec2 {
        (self.places[segment + 1] - self.places[segment]).normalize_or_zero()
    }

    /// The angle by which the chain bends at a place: 0 at its ends.
    pub(super) fn bend(&self, at: usize) -> f64 {
        let last = self.len();
        match at {
            0 if self.closed => turn(self.direction(last - 1), self.direction(0)),
            _ if at == last && self.closed => self.bend(0),
            _ if at == 0 || at == last => 0.0,
            _ => turn(self.direction(at - 1), self.direction(at)),
        }
    }

    /// Replaces sharp bends by arcs if there is room.
    fn round_bends(&mut self, above: f64) {
        let Widths { half, left, right } = self.widths;
        let count = self.len();
        let length = |segment: usize| self.places[segment].distance(self.places[segment + 1]);
        let (mut places, mut heights, mut lines) = (vec![self.places[0]], vec![self.heights[0]], Vec::new());
        for at in 1..count {
            lines.push(self.lines[at - 1]);
            let bend = self.bend(at);
            let tangent = libm::tan(bend.abs() / 2.0);
            let inner = if 0.0 < bend { left } else { right };
            let room = 0.5 * length(at - 1).min(length(at));
            let radius = (half + inner + ARC_ROOM).min(room / tangent);
            let place = self.places[at];
            if bend.abs() <= above || radius < half + 0.25 * ARC_ROOM || 3.1 < bend.abs() {
                places.push(place);
                heights.push(self.heights[at]);
                continue;
            }
            let before = self.direction(at - 1);
            let (from, reach) = (place - before * (radius * tangent), radius * tangent);
            let centre = from + before.perp() * (radius * bend.signum());
            // An even number of parts, so that a change of lines at the bend is in the middle of the arc.
            let steps = 2 * (bend.abs().to_degrees() / (2.0 * ARC_STEP)).ceil() as usize;
            let height = |other: usize| {
                let part = reach / place.distance(self.places[other]);
                self.heights[at] + (self.heights[other] - self.heights[at]) * part
            };
            let ends = [height(at - 1), height(at + 1)];
            for step in 0..=steps {
                let part = step as f64 / steps as f64;
                let (sin, cos) = (libm::sin(bend * part), libm::cos(bend * part));
                places.push(centre + DVec2::new(cos, sin).rotate(from - centre));
                heights.push(ends[0] + (ends[1] - ends[0]) * part);
                if step < steps {
                    lines.push(self.lines[if step < steps / 2 { at - 1 } else { at }]);
                }
            }
        }
        lines.push(self.lines[count - 1]);
        places.push(self.places[count]);
        heights.push(self.heights[count]);
        // Two arcs that touch leave a segment without length.
        let mut kept = vec![0];
        let mut parts = Vec::new();
        for at in 1..places.len() {
            let before = kept[kept.len() - 1];
            if places[at].distance(places[before]) < 1e-3 && at + 1 < places.len() {
                continue;
            }
            kept.push(at);
            parts.push(lines[at - 1]);
        }
        self.places = kept.iter().map(|&at| places[at]).collect();
        self.heights = kept.iter().map(|&at| heights[at]).collect();
        self.lines = parts;
    }

    /// The parts of the chain between bends that are too tight for a mitre. Each such bend becomes a node.
    fn broken(self, nodes: &mut Vec<ChainNode>) -> Vec<Chain> {
        let count = self.len();
        let mut bends: Vec<f64> = (0..=count).map(|at| self.bend(at)).collect();
        let mut breaks: Vec<bool> = bends.iter().map(|bend| MOST_MITRE.to_radians() < bend.abs()).collect();
        loop {
            for at in 0..=count {
                if breaks[at] {
                    bends[at] = 0.0;
                }
            }
            let before = breaks.iter().filter(|&&is| is).count();
            for at in 0..count {
                let length = self.places[at].distance(self.places[at + 1]);
                let shorter = self.widths.half * (libm::tan(bends[at] / 2.0) + libm::tan(bends[at + 1] / 2.0)).abs();
                if (1.0 - LEAST_KERB) * length < shorter {
                    let worse = if bends[at].abs() < bends[at + 1].abs() { at + 1 } else { at };
                    breaks[worse] = true;
                    if self.closed && (worse == 0 || worse == count) {
                        (breaks[0], breaks[count]) = (true, true);
                    }
                }
            }
            if breaks.iter().filter(|&&is| is).count() == before {
                break;
            }
        }
        if self.closed && (breaks[0] || breaks[count]) {
            (breaks[0], breaks[count]) = (true, true);
        }
        let cuts: Vec<usize> = (0..=count).filter(|&at| breaks[at]).collect();
        let Some(&first) = cuts.first() else { return vec![self] };
        let mut numbers = vec![0; count + 1];
        for &at in &cuts {
            numbers[at] = nodes.len() as u32;
            if at == count && self.closed {
                numbers[at] = numbers[0];
                continue;
            }
            nodes.push(ChainNode { place: self.places[at], height: self.heights[at], is_bend: true, arms: Vec::new() });
        }
        let part = |from: usize, to: usize, ends: [Option<u32>; 2]| Chain {
            places: self.places[from..=to].to_vec(),
            heights: self.heights[from..=to].to_vec(),
            lines: self.lines[from..to].to_vec(),
            widths: self.widths,
            ends,
            closed: false,
            along: Vec::new(),
        };
        let end = |at: usize| Some(numbers[at]);
        let mut parts: Vec<Chain> =
            cuts.windows(2).map(|cut| part(cut[0], cut[1], [end(cut[0]), end(cut[1])])).collect();
        let last = cuts[cuts.len() - 1];
        if !self.closed {
            parts.insert(0, part(0, first, [self.ends[0], end(first)]));
            parts.push(part(last, count, [end(last), self.ends[1]]));
        } else if first != 0 {
            // The last part continues over the start of the loop.
            let mut over = part(last, count, [end(last), end(first)]);
            over.places.extend_from_slice(&self.places[1..=first]);
            over.heights.extend_from_slice(&self.heights[1..=first]);
            over.lines.extend_from_slice(&self.lines[..first]);
            parts.push(over);
        }
        parts.retain(|part| !part.lines.is_empty());
        parts
    }

    /// The chain in the other direction.
    pub(super) fn reversed(&self) -> Chain {
        let length = self.length();
        Chain {
            places: self.places.iter().rev().copied().collect(),
            heights: self.heights.iter().rev().copied().collect(),
            lines: self.lines.iter().rev().map(|&(line, forward)| (line, !forward)).collect(),
            widths: self.widths.turned(),
            ends: [self.ends[1], self.ends[0]],
            closed: self.closed,
            along: self.along.iter().rev().map(|along| length - along).collect(),
        }
    }
}
