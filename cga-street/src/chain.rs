//! Centre lines between junctions: chains of edges with the same widths, with bends as arcs, mitres or breaks.

use cga_geometry::each::Each;
use glam::{DVec2, DVec3};

use super::StreetError;
use super::graph::Graph;
use super::input::{Centerline, NetworkOptions};
use super::progress::{EDGE, spend};

/// Bends sharper than this angle in degrees get no mitre.
const MOST_MITRE: f64 = 100.0;

/// The room that an arc leaves on the inner side of a bend, in metres.
const ARC_ROOM: f64 = 2.0;

/// The most chains that meet at one point. Borders of many streets at one point cross each other: their number grows with the
/// square, and the areas that they cover together with the cube.
const MOST_ARMS: usize = 256;

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
    /// The point in plan, with its height as z.
    pub(super) point: DVec3,
    /// True if it is a bend too tight for a mitre, rather than a vertex of the graph where streets meet.
    pub(super) is_bend: bool,
    /// The chains that meet here, by number, and the end of each.
    pub(super) arms: Vec<(u32, usize)>,
}

/// A poly-line with widths. A closed chain ends at its first point.
#[derive(Clone, Debug)]
pub(super) struct Polyline {
    /// The points in plan, each with its height as z.
    pub(super) points: Vec<DVec3>,
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

    fn walk(&mut self, from: u32, first: u32) -> Polyline {
        let graph = self.graph;
        let end = |vertex: u32| (graph.around[vertex as usize].len() != 1).then_some(vertex);
        let mut chain = Polyline {
            points: vec![graph.points[from as usize]],
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
            chain.points.push(graph.points[at as usize]);
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

/// The chains of a graph with arcs at bends, and the nodes where they meet. An error if too many meet at one node.
pub(super) fn chains(
    graph: &Graph,
    lines: &[Centerline],
    options: &NetworkOptions,
) -> Result<(Vec<Polyline>, Vec<ChainNode>), StreetError> {
    if let Some(vertex) = graph.around.iter().position(|around| MOST_ARMS < around.len()) {
        let place = graph.points[vertex];
        return Err(StreetError::TooManyArms { point: [place.x, 0.0 - place.y], most: MOST_ARMS });
    }
    let mut walker = Walker { graph, lines, seen: vec![false; graph.edges.len()] };
    let mut raw = Vec::new();
    for (vertex, around) in graph.around.iter().enumerate() {
        spend(EDGE * around.len())?;
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
    let node = |&point: &DVec3| ChainNode { point, is_bend: false, arms: Vec::new() };
    let mut nodes: Vec<ChainNode> = graph.points.iter().map(node).collect();
    let mut done: Vec<Polyline> = Vec::new();
    for mut chain in raw {
        spend(4 * EDGE * chain.len())?;
        chain.round_bends(options.arc_above.to_radians());
        done.extend(chain.broken(&mut nodes));
    }
    for (number, chain) in done.iter_mut().enumerate() {
        let mut sum = 0.0;
        chain.along = vec![0.0];
        for segment in 0..chain.len() {
            sum += chain.segment_length(segment);
            chain.along.push(sum);
        }
        for (at, end) in chain.ends.iter().enumerate() {
            if let Some(node) = end.filter(|_| !chain.closed) {
                nodes[node as usize].arms.push((number as u32, at));
            }
        }
    }
    Ok((done, nodes))
}

/// The angle between two directions, positive to the left.
pub(super) fn turn(before: DVec2, after: DVec2) -> f64 {
    libm::atan2(before.perp_dot(after), before.dot(after))
}

impl Polyline {
    /// The number of segments.
    pub(super) fn len(&self) -> usize {
        self.lines.len()
    }

    pub(super) fn length(&self) -> f64 {
        self.along[self.len()]
    }

    /// A point in plan.
    pub(super) fn place(&self, at: usize) -> DVec2 {
        self.points[at].truncate()
    }

    fn segment_length(&self, segment: usize) -> f64 {
        self.place(segment).distance(self.place(segment + 1))
    }

    /// The direction of a segment.
    pub(super) fn direction(&self, segment: usize) -> DVec2 {
        (self.place(segment + 1) - self.place(segment)).normalize_or_zero()
    }

    /// The segments before and after a place; an end of an open chain has one segment.
    pub(super) fn segments_at(&self, at: usize) -> [usize; 2] {
        let last = self.len();
        match at {
            _ if self.closed && (at == 0 || at == last) => [last - 1, 0],
            0 => [0; 2],
            _ if at == last => [last - 1; 2],
            _ => [at - 1, at],
        }
    }

    /// The angle by which the chain bends at a place: 0 at its ends.
    pub(super) fn bend(&self, at: usize) -> f64 {
        let [before, after] = self.segments_at(at).each(|segment| self.direction(segment));
        turn(before, after)
    }

    /// Replaces sharp bends by arcs if there is room.
    fn round_bends(&mut self, above: f64) {
        let Widths { half, left, right } = self.widths;
        let count = self.len();
        let (mut points, mut lines) = (vec![self.points[0]], Vec::new());
        for at in 1..count {
            lines.push(self.lines[at - 1]);
            let bend = self.bend(at);
            let tangent = libm::tan(bend.abs() / 2.0);
            let inner = if 0.0 < bend { left } else { right };
            let room = 0.5 * self.segment_length(at - 1).min(self.segment_length(at));
            let radius = (half + inner + ARC_ROOM).min(room / tangent);
            let place = self.place(at);
            if bend.abs() <= above || radius < half + 0.25 * ARC_ROOM || 3.1 < bend.abs() {
                points.push(self.points[at]);
                continue;
            }
            let before = self.direction(at - 1);
            let (from, reach) = (place - before * (radius * tangent), radius * tangent);
            let centre = from + before.perp() * (radius * bend.signum());
            // An even number of parts, so that a change of lines at the bend is in the middle of the arc.
            let steps = 2 * (bend.abs().to_degrees() / (2.0 * ARC_STEP)).ceil() as usize;
            let height = |other: usize| {
                let part = reach / place.distance(self.place(other));
                self.points[at].z + (self.points[other].z - self.points[at].z) * part
            };
            let ends = [height(at - 1), height(at + 1)];
            for step in 0..=steps {
                let part = step as f64 / steps as f64;
                let (sin, cos) = (libm::sin(bend * part), libm::cos(bend * part));
                let place = centre + DVec2::new(cos, sin).rotate(from - centre);
                points.push(place.extend(ends[0] + (ends[1] - ends[0]) * part));
                if step < steps {
                    lines.push(self.lines[if step < steps / 2 { at - 1 } else { at }]);
                }
            }
        }
        lines.push(self.lines[count - 1]);
        points.push(self.points[count]);
        // Two arcs that touch leave a segment without length.
        (self.points, self.lines) = (vec![points[0]], Vec::new());
        for (at, &point) in points.iter().enumerate().skip(1) {
            let before = self.place(self.len());
            if 1e-3 <= point.truncate().distance(before) || at + 1 == points.len() {
                self.points.push(point);
                self.lines.push(lines[at - 1]);
            }
        }
    }

    /// The parts of the chain between bends that are too tight for a mitre. Each such bend becomes a node.
    fn broken(self, nodes: &mut Vec<ChainNode>) -> Vec<Polyline> {
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
                let length = self.segment_length(at);
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
            nodes.push(ChainNode { point: self.points[at], is_bend: true, arms: Vec::new() });
        }
        let part = |from: usize, to: usize, ends: [Option<u32>; 2]| Polyline {
            points: self.points[from..=to].to_vec(),
            lines: self.lines[from..to].to_vec(),
            widths: self.widths,
            ends,
            closed: false,
            along: Vec::new(),
        };
        let end = |at: usize| Some(numbers[at]);
        let mut parts: Vec<Polyline> =
            cuts.windows(2).map(|cut| part(cut[0], cut[1], [end(cut[0]), end(cut[1])])).collect();
        let last = cuts[cuts.len() - 1];
        if !self.closed {
            parts.insert(0, part(0, first, [self.ends[0], end(first)]));
            parts.push(part(last, count, [end(last), self.ends[1]]));
        } else if first != 0 {
            // The last part continues over the start of the loop.
            let mut over = part(last, count, [end(last), end(first)]);
            over.points.extend_from_slice(&self.points[1..=first]);
            over.lines.extend_from_slice(&self.lines[..first]);
            parts.push(over);
        }
        parts.retain(|part| !part.lines.is_empty());
        parts
    }

    /// The chain in the other direction.
    pub(super) fn reversed(&self) -> Polyline {
        let length = self.length();
        Polyline {
            points: self.points.iter().rev().copied().collect(),
            lines: self.lines.iter().rev().map(|&(line, forward)| (line, !forward)).collect(),
            widths: self.widths.turned(),
            ends: [self.ends[1], self.ends[0]],
            closed: self.closed,
            along: self.along.iter().rev().map(|along| length - along).collect(),
        }
    }
}
