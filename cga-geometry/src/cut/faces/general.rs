//! Faces of any shape: concave faces, and faces with holes.
//!
//! Every loop is divided where it meets a plane. Its fragments, each in one slab, are joined again along the planes:
//! the ends on a plane are sorted along the line where the face meets the plane, and neighbours are paired, because the
//! interior begins and ends there. Corners of the face on that line between the two ends are included, so that both
//! sides of the plane and the neighbours of the face have the same edges. Even if rounding changes the order, each
//! fragment has exactly one successor, so the pieces are closed. Pairs are disjoint. If a face crosses itself, pairs
//! may be nested; then only the outermost pair includes corners, so that no corner is used twice.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::ops::Range;

use glam::DVec3;

use super::pieces::Rings;
use crate::cut::caps::rim::PlaneSide;
use crate::cut::class::Class;
use crate::cut::points::PieceCorner;
use crate::cut::state::CutState;
use crate::each::Each;
use crate::long_sort::long_stable_sort_by;
use crate::mesh::{FaceRef, FaceTag, Mesh};
use crate::small_sort::SmallSort;
use crate::triangulate::PlaneProjection;
use crate::work;

/// The units of work of a fragment: it is made, sorted, joined and followed.
const FRAGMENT: usize = 16;

/// A run of nodes within one slab: from plane to plane, or a whole loop that meets no plane.
#[derive(Clone, Copy)]
struct Fragment {
    slab: u32,
    start: usize,
    /// The last node, inclusive.
    end: usize,
    /// The next fragment, and the range of the connecting nodes in the list of ways.
    next: usize,
    way_start: usize,
    way_end: usize,
}

/// A corner of the face on a plane, with its position along the line.
#[derive(Clone, Copy)]
struct OnPlane {
    plane: u32,
    along: f64,
    node: usize,
}

/// An edge along a plane, between two nodes.
#[derive(Clone, Copy)]
struct FaceEdge {
    plane: u32,
    nodes: [usize; 2],
    /// 1 for an edge of the face, -1 for an edge that the cut gave to a piece.
    count: i32,
}

/// An end of a fragment on a plane.
#[derive(Clone, Copy)]
struct FragmentEnd {
    along: f64,
    /// True if the interior of the face begins here, in the direction of the line.
    opens: bool,
    fragment: usize,
}

/// Buffers.
#[derive(Default)]
pub(crate) struct General {
    nodes: Vec<PieceCorner>,
    fragments: Vec<Fragment>,
    on_planes: Vec<OnPlane>,
    plane_edges: Vec<FaceEdge>,
    /// The ends in one slab on one plane, from left to right.
    ends: Vec<FragmentEnd>,
    /// Ends where the interior begins, not paired yet.
    open: Vec<FragmentEnd>,
    /// Ends where the interior ends before it has begun, after rounding has swapped the two. Each is paired with the
    /// next beginning.
    early: Vec<FragmentEnd>,
    /// Nodes on the connections between fragments.
    ways: Vec<usize>,
    rings: Rings,
}

/// The line where a face meets the planes.
#[derive(Clone, Copy)]
struct PlaneLine {
    axis: usize,
    sign: f64,
}

impl PlaneLine {
    /// The line along `axis × normal`, measured by the coordinate that changes most.
    fn of(face: &FaceRef<'_>, axis: usize) -> Self {
        let normal = face.normal();
        let mut cut = DVec3::ZERO;
        cut[axis] = 1.0;
        let along = cut.cross(normal);
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let axis = if along[u].abs() >= along[v].abs() { u } else { v };
        PlaneLine { axis, sign: if along[axis] < 0.0 { -1.0 } else { 1.0 } }
    }
}

impl General {
    pub(crate) fn clip(&mut self, state: &mut CutState, mesh: &Mesh, face: usize, tag: FaceTag) {
        let view = mesh.face(face);
        let line = PlaneLine::of(&view, state.points.axis);
        if !self.take_apart(state, mesh, &view, line) {
            return;
        }
        // Whole loops come last in their slab. Each is its own successor.
        let is_whole = |fragment: &Fragment| !self.nodes[fragment.start].class().is_on_plane();
        let key = |fragment: &Fragment| (fragment.slab, is_whole(fragment));
        if !long_stable_sort_by(&mut self.fragments, |a, b| key(a).cmp(&key(b))) {
            return;
        }
        for (number, fragment) in self.fragments.iter_mut().enumerate().filter(|(_, fragment)| is_whole(fragment)) {
            fragment.next = number;
        }
        let outline = view.loop_ranges().next().unwrap_or(0..0);
        // The projection keeps the coordinate across the planes, in which the positions of pieces are exact.
        self.rings.start(PlaneProjection::keeping(state.points.axis, view.normal()), tag, outline);
        let mut next = 0;
        while let Some(&Fragment { slab, .. }) = self.fragments.get(next) {
            let count = self.fragments[next..].iter().take_while(|f| f.slab == slab).count();
            if !work::spend(FRAGMENT * count) {
                return;
            }
            let group = next..next + count;
            next = group.end;
            if slab > 0 {
                self.join(state, mesh, line, group.clone(), slab - 1, PlaneSide::Above);
            }
            self.join(state, mesh, line, group.clone(), slab, PlaneSide::Below);
            self.trace(group);
            self.rings.emit(state, mesh, slab);
        }
        self.close_flat(state, mesh);
    }

    /// Divides loops into fragments. Returns false if the work is to end.
    fn take_apart(&mut self, state: &mut CutState, mesh: &Mesh, face: &FaceRef<'_>, line: PlaneLine) -> bool {
        self.nodes.clear();
        self.fragments.clear();
        self.on_planes.clear();
        self.plane_edges.clear();
        self.ways.clear();
        for ring in face.loop_ranges() {
            let start = self.nodes.len();
            state.points.cross_loop(&mut state.parts, mesh, ring, &mut self.nodes);
            // The crossings were counted as they were made.
            if !work::spend(1) {
                return false;
            }
            let Some(first) = self.nodes[start..].iter().position(|node| node.class().is_on_plane()) else {
                let (slab, end) = (self.nodes[start].class().slab(), self.nodes.len() - 1);
                self.fragments.push(Fragment { slab, start, end, next: usize::MAX, way_start: 0, way_end: 0 });
                continue;
            };
            self.nodes[start..].rotate_left(first);
            self.nodes.push(self.nodes[start]);
            let mut last = start;
            for here in start + 1..self.nodes.len() {
                let [a, b] = [last, here].each(|i| self.nodes[i]);
                if !b.class().is_on_plane() {
                    continue;
                }
                if !work::spend(FRAGMENT) {
                    return false;
                }
                let plane = b.class().plane();
                if here == last + 1 && a.class() == b.class() {
                    self.plane_edges.push(FaceEdge { plane, nodes: [last, here], count: 1 });
                } else {
                    // Without a node in between, the edge leads from one plane to the next: the slab is below the upper
                    // one.
                    let inside = if here == last + 1 { a.class().max(b.class()) } else { self.nodes[last + 1].class() };
                    let (slab, next) = (inside.slab(), usize::MAX);
                    self.fragments.push(Fragment { slab, start: last, end: here, next, way_start: 0, way_end: 0 });
                }
                if b.is_corner() {
                    self.on_planes.push(OnPlane { plane, along: place(state, mesh, line, b), node: here });
                }
                last = here;
            }
        }
        long_stable_sort_by(&mut self.on_planes, |a, b| a.plane.cmp(&b.plane).then(a.along.total_cmp(&b.along)))
    }

    /// Pairs the ends that fragments of one slab have on one of its planes.
    fn join(
        &mut self,
        state: &mut CutState,
        mesh: &Mesh,
        line: PlaneLine,
        group: Range<usize>,
        plane: u32,
        side: PlaneSide,
    ) {
        self.ends.clear();
        let class = Class::on(plane);
        for fragment in group {
            let Fragment { start, end, .. } = self.fragments[fragment];
            for (node, starts) in [(end, false), (start, true)] {
                let node = self.nodes[node];
                if node.class() == class {
                    // With the normal towards the viewer and the line to the right: below the plane a loop comes up at
                    // the right end of the interior, above it a loop comes down at the left end.
                    let opens = starts == (side == PlaneSide::Below);
                    self.ends.push(FragmentEnd { along: place(state, mesh, line, node), opens, fragment });
                }
            }
        }
        self.ends.small_sort_by(|a, b| a.along.total_cmp(&b.along));
        let ends = std::mem::take(&mut self.ends);
        for tied in ends.chunk_by(|a, b| a.along == b.along) {
            // Order of ends at one position: first open interiors close, then new ones begin, then those close.
            let closers = || tied.iter().filter(|end| !end.opens);
            let first = self.open.len();
            closers().take(first).for_each(|end| self.close(state, *end, plane, side));
            for end in tied.iter().filter(|end| end.opens) {
                match self.early.pop() {
                    Some(early) => self.link(state, *end, early, plane, side),
                    None => self.open.push(*end),
                }
            }
            closers().skip(first).for_each(|end| self.close(state, *end, plane, side));
        }
        self.ends = ends;
        self.open.clear();
        self.early.clear();
    }

    /// Pairs an end with the interior that began last.
    fn close(&mut self, state: &mut CutState, end: FragmentEnd, plane: u32, side: PlaneSide) {
        match self.open.pop() {
            Some(open) => self.link(state, open, end, plane, side),
            None => self.early.push(end),
        }
    }

    /// Makes one fragment the successor of another along a plane.
    fn link(&mut self, state: &mut CutState, open: FragmentEnd, close: FragmentEnd, plane: u32, side: PlaneSide) {
        let (from, to) = if side == PlaneSide::Below { (close, open) } else { (open, close) };
        let [a, b] = [self.fragments[from.fragment].end, self.fragments[to.fragment].start];
        let low = from.along.min(to.along);
        let high = from.along.max(to.along);
        let start = self.on_planes.partition_point(|corner| (corner.plane, corner.along) <= (plane, low));
        let end = self.on_planes.partition_point(|corner| (corner.plane, corner.along) < (plane, high));
        let way = self.ways.len();
        if start < end && self.open.is_empty() && self.early.is_empty() {
            self.ways.extend(self.on_planes[start..end].iter().map(|corner| corner.node));
            if to.along < from.along {
                self.ways[way..].reverse();
            }
        }
        let fragment = &mut self.fragments[from.fragment];
        (fragment.next, fragment.way_start, fragment.way_end) = (to.fragment, way, self.ways.len());
        let mut last = a;
        for here in self.ways[way..].iter().copied().chain([b]) {
            let [p, q] = [last, here].each(|node| self.nodes[node].place);
            if p != q {
                state.rim.edge(plane, p.number, q.number, side);
                self.plane_edges.push(FaceEdge { plane, nodes: [last, here], count: -1 });
            }
            last = here;
        }
    }

    /// Follows the fragments of a slab into rings.
    fn trace(&mut self, group: Range<usize>) {
        for first in group {
            let mut at = first;
            // A fragment that was followed already has no successor.
            while self.fragments[at].next != usize::MAX {
                let fragment = self.fragments[at];
                self.fragments[at].next = usize::MAX;
                let run = fragment.start..fragment.end + 1;
                run.chain(self.ways[fragment.way_start..fragment.way_end].iter().copied())
                    .for_each(|node| self.rings.nodes.push(self.nodes[node]));
                at = fragment.next;
            }
            self.rings.end_ring();
        }
    }

    /// Along a plane, the pieces below and above and the face itself use each edge equally often in both directions. A
    /// broken face (not planar, or crossing itself) may violate this. Then the missing edges become faces in the plane,
    /// so that every neighbour has its partner.
    fn close_flat(&mut self, state: &mut CutState, mesh: &Mesh) {
        let nodes = &self.nodes;
        let key = |edge: &FaceEdge| {
            let [a, b] = edge.nodes.each(|node| nodes[node].place.number);
            (edge.plane, a.min(b), a.max(b))
        };
        if !long_stable_sort_by(&mut self.plane_edges, |a, b| key(a).cmp(&key(b))) {
            return;
        }
        // By start point. Equally many edges end at each point.
        let mut left: BTreeMap<(u32, u32), Vec<[usize; 2]>> = BTreeMap::new();
        for same in self.plane_edges.chunk_by(|a, b| key(a) == key(b)) {
            let FaceEdge { plane, nodes: [a, b], .. } = same[0];
            let is_forward = |edge: &FaceEdge| nodes[edge.nodes[0]].place == nodes[a].place;
            let net: i32 = same.iter().map(|edge| if is_forward(edge) { edge.count } else { -edge.count }).sum();
            let missing = if net > 0 { [a, b] } else { [b, a] };
            if net != 0 {
                let from = left.entry((plane, nodes[missing[0]].place.number)).or_default();
                from.extend(std::iter::repeat_n(missing, net.unsigned_abs() as usize));
            }
        }
        while let Some((&(plane, start), _)) = left.first_key_value() {
            let mut at = start;
            while let Entry::Occupied(mut entry) = left.entry((plane, at)) {
                let Some([from, to]) = entry.get_mut().pop() else { break };
                if entry.get().is_empty() {
                    entry.remove();
                }
                self.rings.nodes.push(nodes[from]);
                at = nodes[to].place.number;
                if at == start {
                    break;
                }
            }
            let ring = &self.rings.nodes;
            for i in 0..ring.len() {
                let [a, b] = [i, (i + 1) % ring.len()].each(|at| ring[at].place.number);
                state.rim.edge(plane, a, b, PlaneSide::Below);
            }
            self.rings.end_ring();
            self.rings.emit(state, mesh, plane);
        }
    }
}

/// The position of a node along the line.
fn place(state: &CutState, mesh: &Mesh, line: PlaneLine, node: PieceCorner) -> f64 {
    line.sign * state.points.position(mesh, &node)[line.axis] + 0.0
}
