//! The surface of a mesh, as convex pieces in a tree.

use glam::{DAffine3, DVec3};

use super::convex_polygon::ConvexPolygon;
use super::plane_cut::edge_planes;
use crate::bounds::Bounds;
use crate::bounds_tree::{BoundsTree, overlap};
use crate::mesh::{FaceRef, Mesh, unit};
use crate::tol::PLANAR_EPSILON;
use crate::triangulate::Triangulator;
use crate::upward_ray::winding_part;
use crate::vector::area_vector;

/// The least cosine between the normals of surfaces that count as parallel.
const PARALLEL: f64 = 0.9;

/// Convex planar pieces of the faces of a mesh, in the world.
#[derive(Debug)]
pub(super) struct Surface {
    corners: Vec<DVec3>,
    pieces: Vec<Piece>,
    boxes: Vec<Bounds>,
    tree: BoundsTree,
    pub(super) bounds: Bounds,
    pub(super) is_closed: bool,
}

#[derive(Debug)]
struct Piece {
    /// The range of its corners.
    start: u32,
    end: u32,
    /// The unit normal; zero for a piece without area.
    normal: DVec3,
}

/// The place of a point beside a closed surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    Inside,
    Outside,
    On,
}

impl Surface {
    /// The surface of a mesh after it is placed.
    pub(super) fn of_mesh(mesh: &Mesh, placement: &DAffine3) -> Self {
        let points: Vec<DVec3> = mesh.points().iter().map(|point| placement.transform_point3(*point)).collect();
        let at = |corner: usize| points[mesh.corners()[corner] as usize];
        let mut surface = Surface::empty(mesh.is_closed());
        let (mut triangulator, mut triangles) = (Triangulator::new(), Vec::new());
        for face in mesh.faces() {
            if is_convex(&face) {
                surface.add(face.corner_range().map(at));
                continue;
            }
            triangles.clear();
            triangulator.face(mesh, face.index(), &mut triangles);
            for triangle in &triangles {
                surface.add(triangle.iter().map(|corner| at(*corner as usize)));
            }
        }
        surface.finish()
    }

    /// The surface of convex faces.
    pub(super) fn of_faces(faces: &[[DVec3; 4]]) -> Self {
        let mut surface = Surface::empty(1 < faces.len());
        faces.iter().for_each(|face| surface.add(face.iter().copied()));
        surface.finish()
    }

    fn empty(is_closed: bool) -> Self {
        let (corners, pieces, boxes) = (Vec::new(), Vec::new(), Vec::new());
        Surface { corners, pieces, boxes, tree: BoundsTree::default(), bounds: Bounds::EMPTY, is_closed }
    }

    fn add(&mut self, corners: impl Iterator<Item = DVec3>) {
        let start = self.corners.len();
        self.corners.extend(corners);
        let own = &self.corners[start..];
        let normal = unit(area_vector([own.iter().copied()].into_iter()));
        self.boxes.push(Bounds::of(own.iter().copied()));
        self.pieces.push(Piece { start: start as u32, end: self.corners.len() as u32, normal });
    }

    fn finish(mut self) -> Self {
        self.bounds = self.boxes.iter().fold(Bounds::EMPTY, |sum, bounds| sum.union(*bounds));
        self.tree = BoundsTree::of(&self.boxes);
        self
    }

    /// The corners of a piece.
    pub(super) fn corners(&self, piece: u32) -> &[DVec3] {
        let Piece { start, end, .. } = self.pieces[piece as usize];
        &self.corners[start as usize..end as usize]
    }

    /// The unit normal of a piece; zero if it has no area.
    pub(super) fn normal(&self, piece: u32) -> DVec3 {
        self.pieces[piece as usize].normal
    }

    /// A piece as a polygon with its normal.
    pub(super) fn polygon(&self, piece: u32) -> ConvexPolygon<'_> {
        ConvexPolygon { corners: self.corners(piece), normal: self.normal(piece) }
    }

    pub(super) fn bounds_of(&self, piece: u32) -> &Bounds {
        &self.boxes[piece as usize]
    }

    /// The two corners that are farthest apart along the longest extent, if no piece has an area.
    pub(super) fn flat_ends(&self) -> Option<[DVec3; 2]> {
        if self.pieces.iter().any(|piece| piece.normal != DVec3::ZERO) {
            return None;
        }
        let size = self.bounds.size().to_array();
        let axis = (1..3).fold(0, |longest, axis| if size[longest] < size[axis] { axis } else { longest });
        let by = |a: &DVec3, b: &DVec3| a[axis].total_cmp(&b[axis]);
        let corners = || self.corners.iter().copied();
        Some([corners().min_by(by)?, corners().max_by(by)?])
    }

    /// Calls `found` with the pieces with an area whose boxes come within a distance of a box, until it returns false.
    pub(super) fn near(&self, bounds: &Bounds, distance: f64, mut found: impl FnMut(u32) -> bool) {
        let wide = Bounds { low: bounds.low - distance, high: bounds.high + distance };
        self.tree.visit(
            |node| overlap(node, &wide),
            |piece| {
                let is_near = overlap(&self.boxes[piece as usize], &wide) && self.normal(piece) != DVec3::ZERO;
                !is_near || found(piece)
            },
        );
    }

    /// Returns true if the surface winds around a point.
    pub(super) fn winds_around(&self, point: DVec3) -> bool {
        let is_below = |bounds: &Bounds| {
            let (DVec3 { x, y, z }, Bounds { low, high }) = (point, bounds);
            low.x <= x && x <= high.x && low.z <= z && z <= high.z && y <= high.y
        };
        let mut winding = 0;
        self.tree.visit(is_below, |piece| {
            if is_below(&self.boxes[piece as usize]) {
                let corners = self.corners(piece);
                let fan = corners.windows(2).skip(1);
                winding += fan.map(|pair| winding_part(point, [corners[0], pair[0], pair[1]])).sum::<i32>();
            }
            true
        });
        winding != 0
    }

    /// The place of a point. Up to the tolerance from the surface it is on it; but on walls inside a solid, which have the solid on both
    /// sides and are parallel to a plane with the given normal, it is inside.
    pub(super) fn place(&self, point: DVec3, normal: DVec3, tolerance: f64) -> Place {
        let (mut is_near, mut is_parallel) = (false, true);
        self.near(&Bounds { low: point, high: point }, tolerance, |piece| {
            if self.distance(piece, point) <= tolerance {
                is_near = true;
                is_parallel &= PARALLEL <= self.normal(piece).dot(normal).abs();
            }
            !is_near || is_parallel
        });
        if !is_near {
            return if self.winds_around(point) { Place::Inside } else { Place::Outside };
        }
        let step = normal * (2.0 * tolerance);
        if is_parallel && self.winds_around(point + step) && self.winds_around(point - step) {
            return Place::Inside;
        }
        Place::On
    }

    /// The distance of a point from a piece.
    pub(super) fn distance(&self, piece: u32, point: DVec3) -> f64 {
        let (corners, normal) = (self.corners(piece), self.normal(piece));
        if edge_planes(corners, normal).all(|[a, inwards]| 0.0 <= (point - a).dot(inwards)) {
            return (point - corners[0]).dot(normal).abs();
        }
        let next = corners.iter().cycle().skip(1);
        let distance = |(a, b): (&DVec3, &DVec3)| {
            let way = *b - *a;
            let share = ((point - *a).dot(way) / way.length_squared()).clamp(0.0, 1.0);
            // An edge without length has the share NaN.
            point.distance(*a + way * if share.is_nan() { 0.0 } else { share })
        };
        corners.iter().zip(next).map(distance).fold(f64::INFINITY, f64::min)
    }
}

/// Returns true for a planar convex face without holes.
fn is_convex(face: &FaceRef<'_>) -> bool {
    if face.corner_count() == 3 {
        return true;
    }
    if face.holes().len() != 0 || face.is_bent() {
        return false;
    }
    let (normal, mut outline) = (face.normal(), face.outline());
    let Some(from) = outline.next() else { return false };
    let (mut far, mut off) = (0.0f64, 0.0f64);
    for point in outline {
        far = far.max((point - from).abs().max_element());
        off = off.max((point - from).dot(normal).abs());
    }
    off <= PLANAR_EPSILON * far && face.is_convex()
}
