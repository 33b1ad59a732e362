//! Faces of the carrier as convex patches of texture space, with their maps to the surface.

use glam::{DVec2, DVec3};

use super::{AlongUv, HeightDirection};
use crate::each::Each;
use crate::exact::{comes_first, orient};
use crate::extrude::vertex_normals;
use crate::long_sort::long_sort_by;
use crate::mesh::{Mesh, TooManyCorners};
use crate::nesting::extent::Extent;
use crate::segment::nearest_share;
use crate::tol::{AFFINE_EPSILON, ANGLE_EPSILON, NEXT_EPSILON, WHOLE_EPSILON};
use crate::triangulate::Triangulator;
use crate::work;

/// The units of work of an edge whose neighbours are found.
const EDGE: usize = 128;

/// A triangle, or a quad whose coordinates are a parallelogram. Corners are counter-clockwise in texture space.
pub(super) struct UvPatch {
    corners: Vec<PatchCorner>,
    /// True if u, v and height are left-handed on the surface.
    pub(super) is_mirrored: bool,
    /// The scalar products with these vectors, applied to the offset from the first corner, are the shares along the
    /// edges from the first corner to the second and to the last corner.
    along: [DVec2; 2],
}

/// The part of a patch that a position is on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum On {
    Inside,
    Edge(usize),
    Corner(usize),
}

#[derive(Clone, Copy)]
struct PatchCorner {
    uv: DVec2,
    point: DVec3,
    /// The displacement for a height of 1.
    up: DVec3,
    /// The number of the carrier's point.
    number: u32,
}

impl UvPatch {
    /// A patch; `None` for corners without area in texture space, up to rounding: a projection sees faces edge-on.
    fn of(mut corners: Vec<PatchCorner>) -> Option<Self> {
        let turn = orient(corners[0].uv, corners[1].uv, corners[2].uv);
        let between = |from: usize, to: usize| corners[to].point - corners[from].point;
        let normal = match corners.len() {
            3 => between(0, 1).cross(between(0, 2)),
            _ => between(0, 2).cross(between(1, 3)),
        };
        let up: DVec3 = corners.iter().map(|corner| corner.up).sum();
        // Along the surface up to rounding, the height has no side.
        let is_below = normal.dot(up) < -ANGLE_EPSILON * normal.length() * up.length();
        let is_mirrored = (turn < 0) != is_below;
        if turn < 0 {
            corners.reverse();
        }
        let from = corners[0].uv;
        let (a, b) = (corners[1].uv - from, corners[corners.len() - 1].uv - from);
        let area = a.perp_dot(b);
        let along = [DVec2::new(b.y, -b.x) / area, DVec2::new(-a.y, a.x) / area];
        let far = corners.iter().fold(1.0, |far: f64, corner| far.max(corner.uv.abs().max_element()));
        let is_thin = area.abs() / a.length().max(b.length()) <= far * NEXT_EPSILON;
        let is_sound = turn != 0 && !is_thin && along.iter().all(|way| way.is_finite());
        is_sound.then_some(UvPatch { corners, is_mirrored, along })
    }

    /// The ends of an edge in texture space.
    pub(super) fn edge(&self, edge: usize) -> [DVec2; 2] {
        [self.corners[edge].uv, self.corners[self.after(edge)].uv]
    }

    pub(super) fn edge_count(&self) -> usize {
        self.corners.len()
    }

    /// The common corner of two edges, if any.
    pub(super) fn corner_between(&self, a: usize, b: usize) -> Option<usize> {
        [(a, b), (b, a)].into_iter().find(|&(before, after)| self.after(before) == after).map(|(_, after)| after)
    }

    pub(super) fn corner(&self, corner: usize) -> DVec2 {
        self.corners[corner].uv
    }

    /// The corners at the ends of an edge.
    pub(super) fn ends(&self, edge: usize) -> [usize; 2] {
        [edge, self.after(edge)]
    }

    /// The two edges at a corner, as bits.
    pub(super) fn edges_at(&self, corner: usize) -> u8 {
        let before = if corner == 0 { self.corners.len() - 1 } else { corner - 1 };
        1 << corner | 1 << before
    }

    fn after(&self, corner: usize) -> usize {
        if corner + 1 == self.corners.len() { 0 } else { corner + 1 }
    }

    fn extent(&self) -> Extent {
        Extent::of(self.corners.iter().map(|corner| corner.uv))
    }

    /// Returns true if its range of coordinates meets another range.
    pub(super) fn may_meet(&self, low: DVec2, high: DVec2) -> bool {
        let own = self.extent();
        own.low.cmple(high).all() && low.cmple(own.high).all()
    }

    /// The v at which each row of cells begins.
    pub(super) fn rows(&self, most: usize) -> Result<impl Iterator<Item = f64> + use<>, TooManyCorners> {
        let Extent { low, high } = self.extent();
        count_up(low.y.floor(), high.y.ceil(), most)
    }

    /// The smallest and the largest u in a row of cells.
    fn range_in_row(&self, row: f64) -> (f64, f64) {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut add = |u: f64| (low, high) = (low.min(u), high.max(u));
        for edge in 0..self.corners.len() {
            let [a, b] = self.edge(edge);
            for end in [a, b].into_iter().filter(|end| row <= end.y && end.y <= row + 1.0) {
                add(end.x);
            }
            for v in [row, row + 1.0] {
                if (a.y < v) != (b.y < v) && a.y != v && b.y != v {
                    add((a.x + (b.x - a.x) * ((v - a.y) / (b.y - a.y))).clamp(a.x.min(b.x), a.x.max(b.x)));
                }
            }
        }
        (low, high)
    }

    /// The cells that it covers in a row, by their smallest coordinates.
    pub(super) fn cells(&self, row: f64, most: usize) -> Result<impl Iterator<Item = DVec2> + use<>, TooManyCorners> {
        let (low, high) = self.range_in_row(row);
        Ok(count_up(low.floor(), high.ceil(), most)?.map(move |u| DVec2::new(u, row)))
    }

    /// Returns true if it covers a part of a cell.
    fn covers(&self, cell: DVec2) -> bool {
        let own = self.extent();
        let (low, high) = self.range_in_row(cell.y);
        own.low.y.floor() <= cell.y && cell.y < own.high.y.ceil() && low.floor() <= cell.x && cell.x < high.ceil()
    }

    /// The position of a node on or above the surface.
    pub(super) fn place(&self, uv: DVec2, height: f64, on: On) -> DVec3 {
        let (point, up) = match on {
            On::Corner(corner) => (self.corners[corner].point, self.corners[corner].up),
            On::Edge(edge) => {
                // Computed alike from both sides of the edge.
                let (a, b) = (self.corners[edge], self.corners[self.after(edge)]);
                let (a, b) = if comes_first(a.uv, b.uv) { (a, b) } else { (b, a) };
                let share = nearest_share(uv, [a.uv, b.uv]);
                (a.point + (b.point - a.point) * share, a.up + (b.up - a.up) * share)
            }
            On::Inside => {
                let off = uv - self.corners[0].uv;
                let [s, t] = self.along.each(|way| way.dot(off));
                let mix = |of: fn(&PatchCorner) -> DVec3| match &self.corners[..] {
                    [a, b, c] => of(a) + (of(b) - of(a)) * s + (of(c) - of(a)) * t,
                    [a, b, c, d] => {
                        let (low, high) = (of(a) + (of(b) - of(a)) * s, of(d) + (of(c) - of(d)) * s);
                        low + (high - low) * t
                    }
                    _ => DVec3::ZERO,
                };
                (mix(|corner| corner.point), mix(|corner| corner.up))
            }
        };
        point + up * height
    }
}

/// The whole numbers from `low` to before `high`.
fn count_up(low: f64, high: f64, most: usize) -> Result<impl Iterator<Item = f64> + use<>, TooManyCorners> {
    let count = high - low;
    if (most as f64) < count {
        return Err(TooManyCorners { most });
    }
    Ok((0..count as u64).map(move |step| low + step as f64))
}

/// The end of an edge: its point and its coordinates.
type EdgeEnd = (u32, [u64; 2]);

/// All patches of a carrier.
#[derive(Default)]
pub(super) struct Patches {
    pub(super) list: Vec<UvPatch>,
    /// The edges of patches with the numbers of the patches, sorted.
    edges: Vec<([EdgeEnd; 2], u32)>,
}

impl Patches {
    /// The patches of triangles and quads.
    pub(super) fn of(carrier: &Mesh, options: &AlongUv) -> Self {
        let mut patches = Patches::default();
        let uvs = carrier.uv_set(options.set);
        if uvs.is_empty() {
            return patches;
        }
        let normals = match options.direction {
            HeightDirection::ScopeY => Vec::new(),
            HeightDirection::VertexNormal => vertex_normals(carrier),
        };
        let Some(near) = rounding(carrier, uvs, options.rounding) else { return patches };
        let corner = |corner: u32| {
            let number = carrier.corners[corner as usize];
            let up = match options.direction {
                HeightDirection::ScopeY => DVec3::Y,
                HeightDirection::VertexNormal => normals[number as usize],
            };
            let (uv, near) = (uvs[corner as usize], near[number as usize]);
            let uv = DVec2::new(on_whole(uv.x, near.x), on_whole(uv.y, near.y));
            PatchCorner { uv, point: carrier.points[number as usize], up, number }
        };
        let (mut triangulator, mut triangles) = (Triangulator::new(), Vec::new());
        for face in carrier.faces().filter(|face| matches!(face.corner_count(), 3 | 4)) {
            if !work::spend(EDGE * face.corner_count()) {
                return Patches::default();
            }
            let corners: Vec<PatchCorner> = face.corner_range().map(|at| corner(at as u32)).collect();
            if is_parallelogram(&corners) {
                patches.add(UvPatch::of(corners));
                continue;
            }
            triangles.clear();
            triangulator.face(carrier, face.index(), &mut triangles);
            for triangle in &triangles {
                patches.add(UvPatch::of(triangle.each(corner).to_vec()));
            }
        }
        if long_sort_by(&mut patches.edges, Ord::cmp) { patches } else { Patches::default() }
    }

    fn add(&mut self, patch: Option<UvPatch>) {
        let Some(patch) = patch else { return };
        let number = self.list.len() as u32;
        for edge in 0..patch.corners.len() {
            self.edges.push((key(&patch, edge), number));
        }
        self.list.push(patch);
    }

    /// Returns true if polygons above an edge in a cell belong to a patch: they belong to the first patch at the edge
    /// that covers the cell.
    pub(super) fn owns_wall(&self, patch: usize, edge: usize, cell: DVec2) -> bool {
        /// The limit on patches per edge. An edge of a surface has fewer.
        const MOST: usize = 8;
        let key = key(&self.list[patch], edge);
        let from = self.edges.partition_point(|known| known.0 < key);
        let known = self.edges[from..].iter().take_while(|known| known.0 == key).take(MOST);
        let first = known.map(|known| known.1 as usize).find(|&other| self.list[other].covers(cell));
        first.is_none_or(|first| first == patch)
    }
}

fn key(patch: &UvPatch, edge: usize) -> [EdgeEnd; 2] {
    let end = |corner: PatchCorner| (corner.number, corner.uv.to_array().each(f64::to_bits));
    let (a, b) = (end(patch.corners[edge]), end(patch.corners[patch.after(edge)]));
    [a.min(b), a.max(b)]
}

/// For each point the change of its coordinates by the rounding errors of its position: their steepest change along the edges there, in
/// all faces, so that faces agree. `None` if the work is to end.
fn rounding(carrier: &Mesh, uvs: &[DVec2], rounding: f64) -> Option<Vec<DVec2>> {
    let mut most = vec![DVec2::ZERO; carrier.points.len()];
    for face in carrier.faces() {
        if !work::spend(face.corner_count()) {
            return None;
        }
        for ends in face.edges() {
            let [a, b] = ends.each(|corner| carrier.corners[corner] as usize);
            let metres = carrier.points[a].distance(carrier.points[b]);
            let by = (uvs[ends[0]] - uvs[ends[1]]).abs() * (rounding / metres);
            if metres > 0.0 && by.is_finite() {
                [a, b].each(|end| most[end] = most[end].max(by));
            }
        }
    }
    Some(most)
}

/// A coordinate that is a whole number except for rounding as that number: else a copy that ends there would lose its end, or the
/// next one would begin. `near` is the rounding of its position.
fn on_whole(coordinate: f64, near: f64) -> f64 {
    let whole = coordinate.round();
    let is_near = (coordinate - whole).abs() <= near.max(WHOLE_EPSILON * whole.abs().max(1.0));
    (if is_near { whole } else { coordinate }) + 0.0
}

/// Returns true if coordinates are the corners of a parallelogram, except for rounding.
fn is_parallelogram(corners: &[PatchCorner]) -> bool {
    let [a, b, c, d] = corners else { return false };
    let gap = (a.uv - b.uv) + (c.uv - d.uv);
    let size = (c.uv - a.uv).abs().max((d.uv - b.uv).abs()).max_element();
    let [ab, bc] = [orient(a.uv, b.uv, c.uv), orient(b.uv, c.uv, d.uv)];
    let [cd, da] = [orient(c.uv, d.uv, a.uv), orient(d.uv, a.uv, b.uv)];
    ab != 0 && [bc, cd, da] == [ab; 3] && gap.abs().max_element() <= AFFINE_EPSILON * size
}
