//! The state of a wavefront: moving vertices, connected in loops.

use std::ops::RangeInclusive;

use glam::DVec2;

use super::limits::WorkLimits;
use super::rims::Arcs;
use super::speeds::Speeds;
use super::{FrontCorner, NONE, SkeletonError, Swept};
use crate::each::Each;
use crate::nesting::extent::Extent;
use crate::tol::STRAIGHT_EPSILON;

/// The range of lengths whose squares are safe.
pub(super) const SIZES: RangeInclusive<f64> = 1e-100..=1e100;

/// Edges count as opposite if the sum of their unit normals is shorter than this.
const TURNED_BACK: f64 = 1e-10;

/// The line of an edge. At a time `t` it contains the points whose scalar product with the normal is `at + speed * t`.
#[derive(Clone, Copy, Debug)]
pub(super) struct MovingLine {
    pub(super) along: DVec2,
    pub(super) at: f64,
    /// From 0 to 1.
    pub(super) speed: f64,
}

impl MovingLine {
    /// The direction in which the line moves.
    pub(super) fn normal(&self) -> DVec2 {
        self.along.perp()
    }

    /// The distance of a point in front of the line at a time.
    pub(super) fn height(&self, p: DVec2, time: f64) -> f64 {
        self.normal().dot(p) - (self.at + self.speed * time)
    }
}

/// A vertex of the wavefront, and the edge from it to the next vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct WavefrontVertex {
    /// The node of the skeleton where the vertex started.
    pub(super) node: u32,
    pub(super) from: DVec2,
    pub(super) born: f64,
    pub(super) velocity: DVec2,
    /// True if its lines do not determine a velocity.
    pub(super) stuck: bool,
    /// The lines of the edge before and the edge after.
    pub(super) before: u32,
    pub(super) after: u32,
    pub(super) last: u32,
    pub(super) next: u32,
    pub(super) alive: bool,
    /// True if it is not convex, so that it can reach other edges.
    pub(super) reflex: bool,
    pub(super) collapse: CollapseEvent,
    pub(super) split: SplitEvent,
}

impl WavefrontVertex {
    /// The position at a time.
    #[inline]
    pub(super) fn at(&self, time: f64) -> DVec2 {
        self.from + self.velocity * (time - self.born)
    }
}

/// The time when the edge after a vertex shrinks to a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct CollapseEvent {
    pub(super) time: f64,
    /// A time before which its ends are not in contact.
    pub(super) near: f64,
}

impl CollapseEvent {
    pub(super) const NEVER: CollapseEvent = CollapseEvent { time: f64::INFINITY, near: f64::INFINITY };
}

/// The first edge that a reflex vertex reaches, and the time.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplitEvent {
    pub(super) time: f64,
    /// A time before which they are not in contact.
    pub(super) near: f64,
    /// [`NONE`] if the edge has changed; then no edge is reached before the time.
    pub(super) edge: u32,
}

impl SplitEvent {
    pub(super) const NEVER: SplitEvent = SplitEvent { time: f64::INFINITY, near: f64::INFINITY, edge: NONE };

    /// Returns true if the split must be computed again.
    pub(super) fn is_open(&self) -> bool {
        self.edge == NONE && self.time < f64::INFINITY
    }
}

/// The next event of a vertex that is alive: its edge shrinks to a point, or it reaches an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct NextEvent {
    pub(super) time: f64,
    /// A time before which it is not a contact.
    pub(super) near: f64,
}

impl NextEvent {
    pub(super) fn of(WavefrontVertex { collapse, split, .. }: &WavefrontVertex) -> Self {
        NextEvent {
            time: if split.time < collapse.time { split.time } else { collapse.time },
            near: if split.near < collapse.near { split.near } else { collapse.near },
        }
    }
}

/// Twice the signed area of a loop, negative if it is clockwise.
pub(super) fn twice_area(points: &[DVec2], ring: &[u32]) -> f64 {
    let at = |i: usize| points[ring[i] as usize] - points[ring[0] as usize];
    (1..ring.len().saturating_sub(1)).map(|i| at(i).perp_dot(at(i + 1))).sum()
}

/// Returns true if two lines are opposite, so that a vertex between them cannot move.
pub(super) fn turn_back(a: &MovingLine, b: &MovingLine) -> bool {
    (a.along + b.along).length() < TURNED_BACK
}

/// The velocity of a vertex between two lines; `None` if it is not determined: for opposite lines, and for parallel ones
/// with different speeds.
pub(super) fn velocity(a: &MovingLine, b: &MovingLine) -> Option<DVec2> {
    if turn_back(a, b) {
        return None;
    }
    if a.speed == b.speed {
        // The sum of the normals is on the bisector; the shorter it is, the faster the vertex.
        let sum = a.normal() + b.normal();
        return Some(sum * (2.0 * a.speed / sum.length_squared()));
    }
    let across = a.along.perp_dot(b.along);
    let is_determined = a.along.dot(b.along) < 0.0 || STRAIGHT_EPSILON < across.abs();
    is_determined.then(|| (b.along * a.speed - a.along * b.speed) / across)
}

#[derive(Debug)]
pub(super) struct Wavefront {
    pub(super) lines: Vec<MovingLine>,
    pub(super) vertices: Vec<WavefrontVertex>,
    /// The vertices that are alive, in the order of their creation.
    pub(super) alive: Vec<u32>,
    /// The positions of the vertices that are alive, at the current time.
    pub(super) positions: Vec<DVec2>,
    /// The next events of the vertices that are alive.
    pub(super) events: Vec<NextEvent>,
    /// The reflex vertices that are alive, as of the last prediction.
    pub(super) reflex: Vec<u32>,
    /// The nodes of the skeleton, beginning with the given points.
    pub(super) nodes: Vec<DVec2>,
    /// The times of the nodes.
    pub(super) times: Vec<f64>,
    given: usize,
    pub(super) arcs: Arcs,
    /// True if only the places of points count, so that edges of different speeds may divide corners.
    pub(super) flat: bool,
    /// True if of neighbours in one line the faster edge takes the place of the slower one.
    pub(super) overtakes: bool,
    /// True if the region is outside the loops.
    pub(super) unbounded: bool,
    /// The size of the polygon.
    pub(super) extent: f64,
    /// The distance below which objects count as touching.
    pub(super) epsilon: f64,
    pub(super) limits: WorkLimits,
    pub(super) now: f64,
    pub(super) until: f64,
}

impl Wavefront {
    /// The wavefront at the start.
    pub(super) fn new(
        points: &[DVec2],
        rings: &[Vec<u32>],
        speeds: Speeds<'_>,
        epsilon: f64,
        until: f64,
    ) -> Result<Self, SkeletonError> {
        let Extent { low, high } = Extent::of(points.iter().copied());
        let extent = (high - low).max_element();
        // The region outside is infinite, so the distance of the sweep sets the scale too.
        let area: f64 = rings.iter().map(|ring| twice_area(points, ring)).sum();
        let unbounded = area < 0.0;
        let extent = if unbounded { extent + until } else { extent };
        if !(SIZES.contains(&extent) && area.is_finite()) {
            return Err(SkeletonError::Tangled);
        }
        let corners = rings.iter().map(Vec::len).sum();
        let mut front = Wavefront {
            lines: Vec::with_capacity(corners),
            vertices: Vec::with_capacity(2 * corners),
            alive: Vec::with_capacity(corners),
            positions: Vec::with_capacity(2 * corners),
            events: Vec::with_capacity(2 * corners),
            reflex: Vec::new(),
            nodes: points.to_vec(),
            times: vec![0.0; points.len()],
            given: points.len(),
            arcs: Arcs::default(),
            flat: matches!(speeds, Speeds::Places(_)),
            overtakes: matches!(speeds, Speeds::Slopes(_)),
            unbounded,
            extent,
            epsilon: epsilon * extent,
            limits: WorkLimits::of(corners),
            now: 0.0,
            until,
        };
        for ring in rings {
            let start = front.lines.len() as u32;
            for (i, &a) in ring.iter().enumerate() {
                let b = ring[(i + 1) % ring.len()];
                let (p, q) = (points[a as usize], points[b as usize]);
                // An edge without length ends at once, with any direction.
                let along = (q - p).normalize_or(DVec2::X);
                let speed = speeds.of(front.lines.len());
                front.lines.push(MovingLine { along, at: along.perp().dot(p), speed });
                front.arcs.edge(a, b);
            }
            let count = ring.len() as u32;
            for (i, &node) in (0..count).zip(ring) {
                let [last, next] = [(i + count - 1) % count, (i + 1) % count].each(|k| start + k);
                let vertex = front.vertex(node, last, start + i);
                front.alive.push(start + i);
                front.push(WavefrontVertex { last, next, ..vertex });
            }
        }
        Ok(front)
    }

    /// The position of a vertex at a time.
    #[inline]
    pub(super) fn at(&self, vertex: u32, time: f64) -> DVec2 {
        self.vertices[vertex as usize].at(time)
    }

    /// Computes the current positions.
    pub(super) fn place(&mut self) {
        for &vertex in &self.alive {
            self.positions[vertex as usize] = self.vertices[vertex as usize].at(self.now);
        }
    }

    /// A vertex between the edges on two lines that starts now at a node, not connected to others yet.
    pub(super) fn vertex(&self, node: u32, before: u32, after: u32) -> WavefrontVertex {
        let [a, b] = [before, after].each(|line| self.lines[line as usize]);
        let velocity = velocity(&a, &b);
        WavefrontVertex {
            node,
            from: self.nodes[node as usize],
            born: self.now,
            velocity: velocity.unwrap_or_default(),
            stuck: velocity.is_none(),
            before,
            after,
            last: NONE,
            next: NONE,
            alive: true,
            reflex: a.along.perp_dot(b.along) <= STRAIGHT_EPSILON,
            collapse: CollapseEvent::NEVER,
            split: SplitEvent::NEVER,
        }
    }

    pub(super) fn push(&mut self, vertex: WavefrontVertex) {
        self.positions.push(vertex.from);
        self.events.push(NextEvent::of(&vertex));
        self.vertices.push(vertex);
    }

    /// Ends a vertex at a node.
    pub(super) fn end_at(&mut self, vertex: u32, node: u32) {
        let old = &mut self.vertices[vertex as usize];
        old.alive = false;
        self.arcs.path(old.node, node, old.before, old.after);
    }

    /// Makes a vertex at a node, between the edge after one vertex and the line of another edge, which leads to a third
    /// vertex.
    pub(super) fn join(&mut self, last: u32, node: u32, edge: u32, next: u32) -> u32 {
        let made = self.vertices.len() as u32;
        let [before, after] = [last, edge].each(|edge| self.vertices[edge as usize].after);
        let vertex = self.vertex(node, before, after);
        self.push(WavefrontVertex { last, next, ..vertex });
        self.vertices[last as usize].next = made;
        self.vertices[next as usize].last = made;
        made
    }

    /// Removes vertices that have ended from the list of those alive, and adds new ones.
    pub(super) fn renew(&mut self, made: &[u32]) {
        let Wavefront { alive, vertices, .. } = self;
        alive.retain(|&vertex| vertices[vertex as usize].alive);
        alive.extend(made);
    }

    /// Adds a node of the skeleton at the current time.
    pub(super) fn node(&mut self, at: DVec2) -> u32 {
        self.nodes.push(at);
        self.times.push(self.now);
        self.nodes.len() as u32 - 1
    }

    /// Records the final positions.
    pub(super) fn finish(mut self) -> Result<Swept, SkeletonError> {
        let mut end = vec![NONE; self.vertices.len()];
        for &number in &self.alive {
            let vertex = self.vertices[number as usize];
            let at = self.at(number, self.now);
            end[number as usize] = if vertex.born == self.now {
                vertex.node
            } else {
                self.nodes.push(at);
                self.times.push(self.now);
                self.nodes.len() as u32 - 1
            };
            self.arcs.path(vertex.node, end[number as usize], vertex.before, vertex.after);
        }
        for &number in &self.alive {
            let vertex = &self.vertices[number as usize];
            self.arcs.front(end[number as usize], end[vertex.next as usize], vertex.after);
        }
        self.arcs.sort();
        let times = (!self.flat).then_some(&self.times[..]);
        let same = self.arcs.contracted(&self.nodes, times, self.given, self.epsilon);
        end.iter_mut().filter(|end| **end != NONE).for_each(|end| *end = same[*end as usize]);
        let left = self.loops(&end);
        let (points, times) = (std::mem::take(&mut self.nodes), std::mem::take(&mut self.times));
        let mut swept = Swept { strips: self.arcs.strips(&same), left, points, times, deviation: 0.0 };
        if !self.allows(&swept) {
            return Err(SkeletonError::Tangled);
        }
        swept.deviation = self.deviation(&swept);
        Ok(swept)
    }

    /// The [`Swept::deviation`] of a result.
    fn deviation(&self, swept: &Swept) -> f64 {
        let off = |line: &MovingLine, point: u32| {
            line.height(swept.points[point as usize], swept.times[point as usize]).abs()
        };
        let mut most = 0.0;
        for strip in &swept.strips {
            let line = &self.lines[strip.edge as usize];
            most = strip.ring.iter().fold(most, |most: f64, &point| most.max(off(line, point)));
        }
        let Extent { low, high } = Extent::of(swept.points.iter().copied());
        most / (high - low).max_element()
    }

    fn loops(&self, end: &[u32]) -> Vec<Vec<FrontCorner>> {
        let mut seen = vec![false; self.vertices.len()];
        let mut loops = Vec::new();
        for &start in &self.alive {
            let mut ring = Vec::new();
            let mut at = start;
            while !std::mem::replace(&mut seen[at as usize], true) {
                let vertex = &self.vertices[at as usize];
                if end[at as usize] != end[vertex.next as usize] {
                    ring.push(FrontCorner { point: end[at as usize], edge: vertex.after });
                }
                at = vertex.next;
            }
            if 3 <= ring.len() {
                loops.push(ring);
            }
        }
        loops
    }
}
