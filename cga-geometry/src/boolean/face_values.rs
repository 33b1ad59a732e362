//! The values of a face at places inside it: shares of the corners of its triangles.

use glam::{DVec2, DVec3};

use super::facet::Facet;
use crate::bounds_tree::{BoundsTree, overlap};
use crate::each::Each;
use crate::mesh::{Bounds, Mesh};
use crate::small_sort::SmallSort;
use crate::triangulate::{PlaneProjection, Triangulator};

/// The values of a corner, as shares of corners of the mesh.
pub(super) type Shares = [(u32, f64); 3];

/// The values of one corner of the mesh.
pub(super) fn only(corner: u32) -> Shares {
    [(corner, 1.0), (corner, 0.0), (corner, 0.0)]
}

/// The triangles of a face.
pub(super) struct FaceValues {
    pub(super) face: u32,
    projection: PlaneProjection,
    /// Corners of the mesh, and their places in the face's plane.
    triangles: Vec<([u32; 3], [DVec2; 3])>,
    boxes: Vec<Bounds>,
    tree: BoundsTree,
}

impl FaceValues {
    pub(super) fn of(mesh: &Mesh, face: u32, triangulator: &mut Triangulator) -> Self {
        let mut corners = Vec::new();
        triangulator.face(mesh, face as usize, &mut corners);
        let projection = PlaneProjection::along(mesh.face(face as usize).normal());
        let at = |corner: u32| projection.apply(mesh.points()[mesh.corners()[corner as usize] as usize]);
        let triangles: Vec<_> = corners.iter().map(|triangle| (*triangle, triangle.each(at))).collect();
        let boxes: Vec<Bounds> =
            triangles.iter().map(|(_, places)| Bounds::of(places.each(|place| place.extend(0.0)))).collect();
        let tree = BoundsTree::of(&boxes);
        FaceValues { face, projection, triangles, boxes, tree }
    }

    /// The shares at a place: the corners of the triangle that contains it, or nearly does.
    pub(super) fn shares(&self, facet: &Facet<'_>, place: DVec3) -> Shares {
        let place = self.projection.apply(place);
        let here = Bounds::of([place.extend(0.0)]);
        let mut near = Vec::new();
        self.tree.visit(
            |around| overlap(around, &here),
            |number| {
                near.extend(overlap(&self.boxes[number as usize], &here).then_some(number));
                true
            },
        );
        near.small_sort();
        // Rounding may have moved a place out of all triangles.
        let found = self.best(near.into_iter(), place).filter(|(_, shares)| -INSIDE <= least(shares));
        let found = found.or_else(|| self.best(0..self.triangles.len() as u32, place));
        found.map_or_else(
            || only(facet.sources[0]),
            |(triangle, shares)| [0, 1, 2].each(|end| (triangle[end], shares[end])),
        )
    }

    /// The triangle with the largest smallest share at a place.
    fn best(&self, among: impl Iterator<Item = u32>, place: DVec2) -> Option<([u32; 3], [f64; 3])> {
        let shares = |number: u32| {
            let (triangle, [a, b, c]) = self.triangles[number as usize];
            let whole = (b - a).perp_dot(c - a);
            let part = |a: DVec2, b: DVec2| (a - place).perp_dot(b - place) / whole;
            (triangle, [part(b, c), part(c, a), part(a, b)])
        };
        among
            .map(shares)
            .filter(|(_, shares)| shares.iter().all(|share| share.is_finite()))
            .max_by(|a, b| least(&a.1).total_cmp(&least(&b.1)))
    }
}

/// A place with a share this far below 0 is still in a triangle.
const INSIDE: f64 = 1e-6;

fn least(shares: &[f64; 3]) -> f64 {
    shares.iter().copied().fold(f64::INFINITY, f64::min)
}
