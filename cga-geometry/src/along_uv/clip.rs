//! A convex polygon of the asset, cut at the edges of a patch.

use glam::{DVec2, DVec3};

use super::patch::{On, UvPatch};
use super::unit::{AssetPolygon, UnitAsset};
use crate::each::Each;
use crate::exact::{comes_first, orient};
use crate::mesh::{Mesh, UvSets};
use crate::segment::nearest_share;
use crate::tol::NEXT_EPSILON;
use crate::vector::area_vector;

/// A corner of a piece, above a point of texture space.
#[derive(Clone, Copy)]
pub(super) struct ClipVertex {
    pub(super) uv: DVec2,
    pub(super) height: f64,
    /// The edges of the patch below it, as bits.
    above: u8,
    /// The source of the edge after it.
    edge: PieceEdge,
    /// The start of its texture coordinates in the list.
    carried: u32,
}

impl ClipVertex {
    /// Its position on the surface.
    pub(super) fn place(&self, patch: &UvPatch) -> DVec3 {
        patch.place(self.uv, self.height, self.on(patch))
    }

    fn on(&self, patch: &UvPatch) -> On {
        let mut edges = (0..patch.edge_count()).filter(|edge| self.above >> edge & 1 == 1);
        match (edges.next(), edges.next()) {
            (None, _) => On::Inside,
            (Some(edge), None) => On::Edge(edge),
            (Some(a), Some(b)) => patch.corner_between(a, b).map_or(On::Edge(a), On::Corner),
        }
    }

    /// The edges of the patch that contain its position, as bits.
    fn above_of(&self, patch: &UvPatch) -> u8 {
        (0..patch.edge_count()).map(|edge| u8::from(self.side(edge, patch) == 0) << edge).sum()
    }

    /// 1 left of an edge of the patch, which is inside, -1 right of it, 0 above it.
    fn side(&self, edge: usize, patch: &UvPatch) -> i32 {
        let [a, b] = patch.edge(edge);
        if self.above >> edge & 1 == 1 { 0 } else { orient(a, b, self.uv) }
    }
}

#[derive(Clone, Copy)]
enum PieceEdge {
    /// The edge after a corner of the polygon.
    Own(u32),
    /// A cut at an edge of the patch.
    Cut(usize),
}

/// Buffers, and the last piece.
pub(super) struct Clip<'a> {
    asset: &'a Mesh,
    /// The texture sets of the asset.
    pub(super) sets: Vec<usize>,
    pub(super) nodes: Vec<ClipVertex>,
    spare: Vec<ClipVertex>,
    /// The uncut polygon.
    own: Vec<ClipVertex>,
    carried: Vec<DVec2>,
}

impl<'a> Clip<'a> {
    pub(super) fn new(asset: &'a Mesh) -> Self {
        let sets = (0..UvSets::MOST).filter(|&set| !asset.uv_set(set).is_empty()).collect();
        let [nodes, spare, own] = Default::default();
        Clip { asset, sets, nodes, spare, own, carried: Vec::new() }
    }

    /// The texture coordinates of a node, set by set.
    pub(super) fn carried(&self, node: &ClipVertex) -> &[DVec2] {
        &self.carried[node.carried as usize..][..self.sets.len()]
    }

    /// Cuts a polygon in a cell at the edges of a patch. `None` if it is outside. Otherwise the edge that the whole
    /// polygon is above, if there is one.
    pub(super) fn cut(
        &mut self,
        asset: &UnitAsset,
        polygon: &AssetPolygon,
        cell: DVec2,
        patch: &UvPatch,
    ) -> Option<Option<usize>> {
        self.start(asset, polygon, cell, patch);
        let mut wall = None;
        for edge in 0..patch.edge_count() {
            let sides = self.nodes.iter().map(|node| node.side(edge, patch));
            let (low, high) = sides.fold((1, -1), |(low, high), side| (side.min(low), side.max(high)));
            match (low, high) {
                (0, 0) => wall = wall.or(Some(edge)),
                // It is outside, or touches the edge from outside.
                (_, ..=0) => return None,
                (-1, _) => self.cut_at(edge, patch),
                _ => {}
            }
            if self.nodes.len() < 3 {
                return None;
            }
        }
        Some(wall)
    }

    fn start(&mut self, asset: &UnitAsset, polygon: &AssetPolygon, cell: DVec2, patch: &UvPatch) {
        self.carried.clear();
        self.own.clear();
        for (number, (corner, at)) in (0u32..).zip(asset.corners(polygon, cell)) {
            let carried = self.carried.len() as u32;
            self.carried.extend(self.sets.iter().map(|&set| self.asset.uv_set(set)[corner as usize]));
            let edge = PieceEdge::Own(number);
            let mut node = ClipVertex { uv: at.truncate(), height: at.z, above: 0, edge, carried };
            node.above = node.above_of(patch);
            self.own.push(node);
        }
        self.nodes.clone_from(&self.own);
    }

    /// Removes the part right of an edge.
    fn cut_at(&mut self, edge: usize, patch: &UvPatch) {
        let mut kept = std::mem::take(&mut self.spare);
        kept.clear();
        for at in 0..self.nodes.len() {
            let (here, next) = (self.nodes[at], self.nodes[if at + 1 == self.nodes.len() { 0 } else { at + 1 }]);
            match [here, next].each(|node| node.side(edge, patch)) {
                [1, -1] => {
                    let crossing = self.crossing(&here, &next, edge, patch);
                    kept.extend([here, ClipVertex { edge: PieceEdge::Cut(edge), ..crossing }]);
                }
                [-1, 1] => kept.push(self.crossing(&here, &next, edge, patch)),
                [0, -1] => kept.push(ClipVertex { edge: PieceEdge::Cut(edge), ..here }),
                [-1, _] => {}
                _ => kept.push(here),
            }
        }
        self.spare = std::mem::replace(&mut self.nodes, kept);
    }

    /// The crossing of the edge between two nodes with an edge of the patch.
    fn crossing(&mut self, here: &ClipVertex, next: &ClipVertex, edge: usize, patch: &UvPatch) -> ClipVertex {
        if let PieceEdge::Cut(other) = here.edge
            && let Some(corner) = patch.corner_between(other, edge)
        {
            let uv = patch.corner(corner);
            let share = nearest_share(uv, [here.uv, next.uv]);
            let height = self.height_at_corner(uv).unwrap_or(here.height + (next.height - here.height) * share);
            let carried = self.mix(here.carried, next.carried, share);
            return ClipVertex { uv, height, above: patch.edges_at(corner), edge: here.edge, carried };
        }
        // Computed from the ends of the polygon's edge, with the same result for both polygons at the edge and for all
        // patches around.
        let (from, to) = match here.edge {
            PieceEdge::Own(number) => {
                let next = if number as usize + 1 == self.own.len() { 0 } else { number as usize + 1 };
                (self.own[number as usize], self.own[next])
            }
            PieceEdge::Cut(_) => (*here, *next),
        };
        let (from, to) = if is_before(&from, &to) { (from, to) } else { (to, from) };
        let [a, b] = patch.edge(edge);
        let (a, b) = if comes_first(a, b) { (a, b) } else { (b, a) };
        let [off_from, off_to] = [from, to].each(|node| (b - a).perp_dot(node.uv - a));
        let share = off_from / (off_from - off_to);
        // Rounding errors of ends close to the edge may lead outside.
        let share = if share.is_nan() { 0.5 } else { share.clamp(0.0, 1.0) };
        let uv = from.uv + (to.uv - from.uv) * share;
        let height = from.height + (to.height - from.height) * share;
        let carried = self.mix(from.carried, to.carried, share);
        let mut node = ClipVertex { uv, height, above: 1 << edge, edge: here.edge, carried };
        // Rounding may lead to an end of the edge.
        node.above |= node.above_of(patch);
        let is_through = |end: &usize| orient(from.uv, to.uv, patch.corner(*end)) == 0;
        if let Some(corner) = patch.ends(edge).into_iter().find(is_through) {
            node.above |= patch.edges_at(corner);
        }
        if let On::Corner(corner) = node.on(patch) {
            node.uv = patch.corner(corner);
            node.height = height_on_edge(&from, &to, node.uv);
        }
        node
    }

    /// The height of the polygon above a corner of the patch, equal for all patches at the corner. `None` for a
    /// vertical polygon.
    ///
    /// Close to an edge or a corner of the polygon it is the height of that edge or corner, so that neighbouring
    /// polygons agree.
    fn height_at_corner(&self, uv: DVec2) -> Option<f64> {
        if let Some(node) = self.own.iter().find(|node| is_next_to(node.uv, uv)) {
            return Some(node.height);
        }
        let ends = self.own.iter().zip(self.own.iter().cycle().skip(1));
        for (from, to) in ends {
            let (from, to) = if is_before(from, to) { (from, to) } else { (to, from) };
            if is_next_to(from.uv + (to.uv - from.uv) * nearest_share(uv, [from.uv, to.uv]), uv) {
                return Some(height_on_edge(from, to, uv));
            }
        }
        let from = self.own[0];
        let normal = area_vector([self.own.iter().map(|node| node.uv.extend(node.height))].into_iter());
        let height = from.height - normal.truncate().dot(uv - from.uv) / normal.z;
        let heights = || self.own.iter().map(|node| node.height);
        let (low, high) = (heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max));
        height.is_finite().then(|| height.clamp(low, high))
    }

    /// Interpolates the texture coordinates between two nodes.
    fn mix(&mut self, from: u32, to: u32, share: f64) -> u32 {
        let start = self.carried.len() as u32;
        for set in 0..self.sets.len() {
            let (a, b) = (self.carried[from as usize + set], self.carried[to as usize + set]);
            self.carried.push(a.lerp(b, share));
        }
        start
    }
}

/// The height of an edge of the polygon above a point on it.
fn height_on_edge(from: &ClipVertex, to: &ClipVertex, uv: DVec2) -> f64 {
    match [from, to].into_iter().find(|end| is_next_to(end.uv, uv)) {
        Some(end) => end.height,
        None => from.height + (to.height - from.height) * nearest_share(uv, [from.uv, to.uv]),
    }
}

fn is_next_to(a: DVec2, b: DVec2) -> bool {
    (a - b).abs().max_element() <= b.abs().max_element().max(1.0) * NEXT_EPSILON
}

fn is_before(a: &ClipVertex, b: &ClipVertex) -> bool {
    comes_first(a.uv, b.uv) || (a.uv == b.uv && a.height < b.height)
}
