//! Faces of any shape: they are cut triangle by triangle, and the pieces of triangles in one band are joined again.
//!
//! All decisions use indices. The pieces of two triangles at a diagonal have the same edges along it, so each of these
//! edges has a twin. Edges without a twin form the rim of a piece of the face: edges of its loops, and edges along
//! lines. The next edge of the rim is found by rotating around the end of an edge, from twin to twin, so pieces that
//! touch at a point stay separate. Where the coordinate is affine, the crossings of diagonals with a line are
//! collinear, and their nodes are removed again.

use std::ops::Range;

use glam::DVec2;

use super::IsoCutter;
use crate::cut::class::ClassRange;
use crate::cut::faces::chain::Chain;
use crate::cut::faces::first_edge::first_node;
use crate::cut::faces::pieces::close_ring;
use crate::cut::points::{NONE, PieceCorner};
use crate::each::Each;
use crate::mesh::pair_table::PairTable;
use crate::mesh::{FaceTag, TooManyCorners};
use crate::nesting::Nest;
use crate::small_sort::sort_owned_by;
use crate::tol::AFFINE_EPSILON;
use crate::triangulate::{PlaneProjection, Triangulator};

/// An edge of a piece of a triangle, with the node where it begins.
#[derive(Clone, Copy)]
struct Half {
    node: PieceCorner,
    band: u32,
    /// The next edge in its piece.
    next: u32,
    /// The same edge in the neighbour in the same band.
    twin: u32,
    /// True if the node is the crossing of a diagonal with a line.
    is_inner: bool,
    is_traced: bool,
}

/// A side of a triangle: `None` for an edge of a loop or a line, or else twice the number of a diagonal, plus 1 in
/// backward direction.
type TriangleSide = Option<u32>;

/// A ring of a piece of the face.
struct Ring {
    band: u32,
    /// The first edge of the face of which the ring has a part.
    edge: u32,
    nodes: Range<usize>,
}

/// Buffers.
#[derive(Default)]
pub(super) struct PatchBuffers {
    triangulator: Triangulator,
    flat: Vec<DVec2>,
    loop_ends: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    /// For each corner of the face, the next one of its loop.
    next: Vec<u32>,
    diagonals: PairTable,
    sides: Vec<[TriangleSide; 3]>,
    chain: Chain,
    halves: Vec<Half>,
    /// For each diagonal and band the edge without a twin so far.
    open: PairTable,
    /// Triangles that are on a line as a whole, and whether they have a band.
    flats: Vec<(u32, bool)>,
    /// For each of their diagonals the number in this list.
    flat_sides: PairTable,
    /// The nodes of all rings, and whether each is the crossing of a diagonal with a line.
    nodes: Vec<(PieceCorner, bool)>,
    rings: Vec<Ring>,
    nest: Nest,
}

impl PatchBuffers {
    /// Cuts a face into its bands.
    pub(super) fn cut(
        &mut self,
        cutter: &mut IsoCutter<'_>,
        face: usize,
        is_affine: bool,
    ) -> Result<(), TooManyCorners> {
        let view = cutter.mesh.face(face);
        let outline = view.loop_ranges().next().unwrap_or(0..0);
        let projection = PlaneProjection::along(view.normal());
        self.triangulate(cutter, face, projection);
        let start = view.corner_range().start;
        // The check comes first: a face needs at most as many corners as its triangles.
        let lines = |cutter: &IsoCutter<'_>, t: &[u32; 3]| {
            ClassRange::of(t.iter().map(|&corner| cutter.sites.class(start + corner as usize))).planes().len()
        };
        let pieces: usize = self.triangles.iter().map(|t| 3 + 4 * lines(cutter, t)).sum();
        cutter.foresee(pieces)?;
        self.halves.clear();
        self.open.clear();
        self.flats.clear();
        self.flat_sides.clear();
        for triangle in 0..self.triangles.len() {
            cutter.spend(1 + lines(cutter, &self.triangles[triangle]))?;
            self.cut_triangle(cutter, triangle, start);
        }
        self.place_flats(cutter, start, is_affine);
        self.trace(is_affine);
        cutter.count(self.nodes.len())?;
        self.emit(cutter, projection, &outline, view.tag());
        Ok(())
    }

    /// Makes the triangles of the face, as corners counted from its first one, and the kinds of their sides.
    fn triangulate(&mut self, cutter: &IsoCutter<'_>, face: usize, projection: PlaneProjection) {
        let view = cutter.mesh.face(face);
        let start = view.corner_range().start;
        self.flat.clear();
        self.flat.extend(view.corner_range().map(|corner| projection.apply(view.position(corner))));
        self.loop_ends.clear();
        self.loop_ends.extend(view.loop_ranges().map(|ring| (ring.end - start) as u32));
        self.next.clear();
        self.next.extend(view.edges().map(|[_, next]| (next - start) as u32));
        self.triangles.clear();
        self.triangulator.polygon(&self.flat, &self.loop_ends, &mut self.triangles);
        // If loops overlap, a triangle may have the same corner twice. Then its two other sides are the same.
        self.triangles.retain(|[a, b, c]| a != b && b != c && c != a);
        self.diagonals.clear();
        self.sides.clear();
        let mut count = 0;
        for triangle in &self.triangles {
            self.sides.push([(0, 1), (1, 2), (2, 0)].each(|(from, to)| {
                let (from, to) = (triangle[from], triangle[to]);
                if self.next[from as usize] == to {
                    return None;
                }
                let (number, new) = self.diagonals.entry(from.min(to), from.max(to), count);
                count += u32::from(new);
                Some(2 * *number + u32::from(to < from))
            }));
        }
    }

    fn cut_triangle(&mut self, cutter: &mut IsoCutter<'_>, triangle: usize, start: usize) {
        let corners = self.triangles[triangle].each(|corner| start + corner as usize);
        let nodes = corners.each(|corner| cutter.sites.node(cutter.mesh, corner));
        let span = ClassRange::of(nodes.iter().map(PieceCorner::class));
        if span.is_flat() {
            for side in self.sides[triangle].into_iter().flatten() {
                self.flat_sides.entry(side, 0, self.flats.len() as u32);
            }
            self.flats.push((triangle as u32, false));
            return;
        }
        let mut chain = std::mem::take(&mut self.chain);
        let (mesh, sites, crossings) = (cutter.mesh, &cutter.sites, &mut cutter.crossings);
        chain.walk(3, span, |i| nodes[i], |from, to, nodes| crossings.cross(mesh, sites, from, to, nodes));
        chain.pieces(span, |band, ahead, back, borders| {
            let from = self.halves.len() as u32;
            let count = (ahead.len() + back.len()) as u32;
            for (at, node) in ahead.iter().chain(back).enumerate() {
                let is_on_border = match at + 1 {
                    at if at == ahead.len() => borders.upper,
                    at if at == count as usize => borders.lower,
                    _ => false,
                };
                let (side, is_inner) = self.side_after(triangle, &corners, node);
                let side = side.filter(|_| !is_on_border);
                let next = from + if at as u32 + 1 == count { 0 } else { at as u32 + 1 };
                self.half(Half { node: *node, band, next, twin: NONE, is_inner, is_traced: false }, side);
            }
        });
        self.chain = chain;
    }

    /// The side of a triangle that contains the edge after a node, and whether the node is on a diagonal.
    fn side_after(&self, triangle: usize, corners: &[usize; 3], node: &PieceCorner) -> (TriangleSide, bool) {
        let sides = &self.sides[triangle];
        let at = |corner: u32| corners.iter().position(|&own| own == corner as usize).unwrap_or(0);
        let (a, b) = (at(node.from), at(node.to));
        // A crossing between two corners is on the side from one of them to its successor.
        let side = sides[if (a + 1) % 3 == b || a == b { a } else { b }];
        (side, a != b && side.is_some())
    }

    /// Adds an edge and finds its twin.
    fn half(&mut self, mut half: Half, side: TriangleSide) {
        let number = self.halves.len() as u32;
        if let Some(side) = side {
            let other = self.open.get(side ^ 1, half.band).filter(|&other| self.halves[other as usize].twin == NONE);
            if let Some(other) = other {
                half.twin = other;
                self.halves[other as usize].twin = number;
            } else {
                self.open.entry(side, half.band, number);
            }
        }
        self.halves.push(half);
    }

    /// Assigns a band to each triangle on a line: the band above, as for a face. A triangle without area gets the band
    /// of a neighbour, so that it makes no piece of its own.
    fn place_flats(&mut self, cutter: &IsoCutter<'_>, start: usize, is_affine: bool) {
        let mut stack = Vec::new();
        for flat in 0..self.flats.len() {
            if !is_affine && self.has_area(self.flats[flat].0) {
                self.add_flat_above(cutter, flat as u32, start);
            }
        }
        for seed in 0..self.flats.len() {
            stack.push(seed as u32);
            while let Some(flat) = stack.pop() {
                let (triangle, is_placed) = self.flats[flat as usize];
                if is_placed {
                    continue;
                }
                let sides = self.sides[triangle as usize];
                let line = cutter.sites.class(start + self.triangles[triangle as usize][0] as usize).plane();
                let is_open = |half: u32| self.halves[half as usize].twin == NONE;
                let meets = |band: u32, side: u32| self.open.get(side ^ 1, band).is_some_and(is_open);
                let band = [line, line + 1]
                    .into_iter()
                    .find(|&band| sides.into_iter().flatten().any(|side| meets(band, side)));
                if let Some(band) = band {
                    self.add_flat(cutter, flat, band, start);
                    stack.extend(sides.into_iter().flatten().filter_map(|side| self.flat_sides.get(side ^ 1, 0)));
                }
            }
        }
        for flat in 0..self.flats.len() {
            if !self.flats[flat].1 {
                self.add_flat_above(cutter, flat as u32, start);
            }
        }
    }

    /// Returns true if a triangle has an area, up to rounding.
    fn has_area(&self, triangle: u32) -> bool {
        let [a, b, c] = self.triangles[triangle as usize].each(|corner| self.flat[corner as usize]);
        let (ab, ac) = (b - a, c - a);
        AFFINE_EPSILON * ab.length_squared().max(ac.length_squared()) < ab.perp_dot(ac).abs()
    }

    fn add_flat_above(&mut self, cutter: &IsoCutter<'_>, flat: u32, start: usize) {
        let corner = self.triangles[self.flats[flat as usize].0 as usize][0];
        let line = cutter.sites.class(start + corner as usize).plane();
        self.add_flat(cutter, flat, line + 1, start);
    }

    fn add_flat(&mut self, cutter: &IsoCutter<'_>, flat: u32, band: u32, start: usize) {
        let (triangle, is_placed) = &mut self.flats[flat as usize];
        *is_placed = true;
        let triangle = *triangle as usize;
        let corners = self.triangles[triangle].each(|corner| start + corner as usize);
        let from = self.halves.len() as u32;
        for (at, corner) in (0u32..).zip(corners) {
            let node = cutter.sites.node(cutter.mesh, corner);
            let half = Half { node, band, next: from + (at + 1) % 3, twin: NONE, is_inner: false, is_traced: false };
            self.half(half, self.sides[triangle][at as usize]);
        }
    }

    /// Follows the edges without twins into rings.
    fn trace(&mut self, is_affine: bool) {
        self.nodes.clear();
        self.rings.clear();
        for first in 0..self.halves.len() {
            let Half { twin, is_traced, band, .. } = self.halves[first];
            if twin != NONE || is_traced {
                continue;
            }
            let from = self.nodes.len();
            let mut at = first;
            loop {
                let half = &mut self.halves[at];
                half.is_traced = true;
                if !(is_affine && half.is_inner) {
                    self.nodes.push((half.node, half.is_inner));
                }
                at = half.next as usize;
                while self.halves[at].twin != NONE {
                    at = self.halves[self.halves[at].twin as usize].next as usize;
                }
                if at == first {
                    break;
                }
            }
            self.end_ring(from, band);
        }
        sort_owned_by(&mut self.rings, |a, b| (a.band, a.edge).cmp(&(b.band, b.edge)));
    }

    /// Ends a ring. Repeated corners are removed, and rings with fewer than three corners are dropped.
    fn end_ring(&mut self, from: usize, band: u32) {
        if close_ring(&mut self.nodes, from, |(node, _)| node.place.number) {
            let nodes = self.nodes[from..].iter().filter(|(_, is_inner)| !is_inner);
            let edge = nodes.map(|(node, _)| edge_of(node)).min().unwrap_or(NONE);
            self.rings.push(Ring { band, edge, nodes: from..self.nodes.len() });
        }
    }

    /// Adds the rings to their bands as faces.
    fn emit(&mut self, cutter: &mut IsoCutter<'_>, projection: PlaneProjection, outline: &Range<usize>, tag: FaceTag) {
        let mut ends = Vec::new();
        let (mut nodes, mut marks): (Vec<PieceCorner>, Vec<PieceCorner>) = (Vec::new(), Vec::new());
        for rings in self.rings.chunk_by(|a, b| a.band == b.band) {
            nodes.clear();
            marks.clear();
            ends.clear();
            for ring in rings {
                for &(node, is_inner) in &self.nodes[ring.nodes.clone()] {
                    nodes.push(node);
                    // A node on a diagonal is on no edge of the outline.
                    marks.push(if is_inner { PieceCorner { from: NONE, to: NONE, ..node } } else { node });
                }
                ends.push(nodes.len());
            }
            let IsoCutter { mesh, crossings, bands, .. } = &mut *cutter;
            let at = |node: usize| projection.apply(crossings.position(mesh, nodes[node].place.number));
            self.nest.sort_rings(&ends, at);
            let band = &mut bands[rings[0].band as usize];
            for group in self.nest.groups() {
                for ring in group {
                    let first = ring.start + first_of_ring(&marks[ring.clone()], outline);
                    band.corners(mesh, crossings, &nodes[first..ring.end]);
                    band.corners(mesh, crossings, &nodes[ring.start..first]);
                    band.mesh.end_loop();
                }
                band.mesh.end_face(tag);
            }
        }
    }
}

/// The edge that contains a node, by the corner where the edge begins.
fn edge_of(node: &PieceCorner) -> u32 {
    let (low, high) = (node.from.min(node.to), node.from.max(node.to));
    // The last edge of a loop ends at its first corner.
    if high - low <= 1 { low } else { high }
}

/// The first node of a ring: by the rule for first edges, or the first corner for a hole.
fn first_of_ring(marks: &[PieceCorner], outline: &Range<usize>) -> usize {
    if marks.iter().any(|node| outline.contains(&(node.from as usize))) {
        return first_node(marks.iter(), outline);
    }
    let corners = marks.iter().enumerate().filter(|(_, node)| node.is_corner() && node.from != NONE);
    corners.min_by_key(|(_, node)| node.from).map_or(0, |(at, _)| at)
}
