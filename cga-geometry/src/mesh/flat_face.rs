//! A face laid flat, for algorithms in the plane.

use glam::{DVec2, DVec3};

use super::FaceRef;
use super::pair_table::PairTable;
use crate::each::Each;
use crate::tol::{PLANAR_EPSILON, THIN_EPSILON};
use crate::vector::unit;

/// A face projected to its plane.
pub(crate) struct FlatFace<'a> {
    pub(crate) face: FaceRef<'a>,
    pub(crate) origin: DVec3,
    pub(crate) axes: [DVec3; 2],
    pub(crate) normal: DVec3,
    /// The distinct points of the face, their heights above the plane, and their numbers in the mesh.
    pub(crate) flat: Vec<DVec2>,
    pub(crate) heights: Vec<f64>,
    pub(crate) points: Vec<u32>,
    /// For each corner the number of its point.
    pub(crate) corners: Vec<u32>,
}

impl FaceRef<'_> {
    /// Two axes in the plane of the face with this normal, the first one along its first edge with a length. `None` if no edge has one.
    pub(crate) fn plane_axes(&self, normal: DVec3) -> Option<[DVec3; 2]> {
        let mut edges = self.edges().map(|[a, b]| unit(self.position(b) - self.position(a)));
        let first = edges.find(|edge| *edge != DVec3::ZERO)?;
        let x = unit(first - normal * first.dot(normal));
        Some([x, normal.cross(x)])
    }

    /// Returns true if the face is thinner than the rounding errors of its coordinates: then its normal means nothing.
    pub(crate) fn is_thin(&self) -> bool {
        let range = self.corner_range();
        let origin = self.position(range.start);
        let [mut extent, mut largest] = [0.0f64; 2];
        for corner in range {
            let position = self.position(corner);
            extent = extent.max((position - origin).abs().max_element());
            largest = largest.max(position.abs().max_element());
        }
        let place = |corner: usize| (self.position(corner) - origin) / extent;
        let double_area: DVec3 = self.edges().map(|[a, b]| place(a).cross(place(b))).sum();
        double_area.length() <= THIN_EPSILON * (largest.max(extent) / extent)
    }
}

impl<'a> FlatFace<'a> {
    /// The face; `None` if it has no area, or is thinner than the rounding errors of its coordinates: then its normal means nothing.
    pub(crate) fn of(face: &FaceRef<'a>) -> Option<Self> {
        let (normal, range) = (face.normal(), face.corner_range());
        if normal == DVec3::ZERO || face.is_thin() {
            return None;
        }
        let origin = face.position(range.start);
        let axes = face.plane_axes(normal)?;
        let count = range.len();
        let (flat, heights) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let (points, corners) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let mut plane = FlatFace { face: *face, origin, axes, normal, flat, heights, points, corners };
        let mut extent = 0.0f64;
        let mut numbers = PairTable::with_capacity(count);
        for corner in range {
            let point = face.mesh.corners[corner];
            let to = face.position(corner) - origin;
            extent = extent.max(to.abs().max_element());
            let next = plane.flat.len() as u32;
            let (number, is_new) = numbers.entry(0, point, next);
            let number = *number;
            if is_new {
                plane.flat.push(DVec2::new(to.dot(axes[0]), to.dot(axes[1])));
                plane.heights.push(to.dot(normal));
                plane.points.push(point);
            }
            plane.corners.push(number);
        }
        // Deviations by rounding errors count as in the plane.
        if plane.heights.iter().all(|height| height.abs() <= PLANAR_EPSILON * extent) {
            plane.heights.fill(0.0);
        }
        Some(plane)
    }

    /// The edges of the face in the order in which they are swept, with their corners counted from the first one of the
    /// face, and the points of its loops. To move them `outwards`, the loops are reversed.
    pub(crate) fn edges(&self, outwards: bool) -> (Vec<[usize; 2]>, Vec<Vec<u32>>) {
        let start = self.face.corner_range().start;
        let (mut edges, mut rings) = (Vec::new(), Vec::new());
        let mut all = self.face.edges().map(|edge| edge.each(|corner| corner - start));
        for ring in self.face.loops() {
            let first = edges.len();
            edges.extend(all.by_ref().take(ring.len()));
            if outwards {
                edges[first..].reverse();
            }
            rings.push(edges[first..].iter().map(|edge| self.corners[edge[usize::from(outwards)]]).collect());
        }
        (edges, rings)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{FaceTag, MeshBuilder};

    fn is_flat(corners: &[[f64; 3]]) -> bool {
        let mut builder = MeshBuilder::new();
        let points: Vec<u32> = corners.iter().map(|place| builder.point(*place)).collect();
        builder.face(&points, &[], FaceTag::PLAIN);
        FlatFace::of(&builder.build().unwrap().face(0)).is_some()
    }

    #[test]
    fn a_face_thinner_than_rounding_has_no_plane() {
        // A strip at a distance from the origin, there and back along an angle too.
        let strip =
            |width: f64| [[9.0, 7.5, 16.0], [9.0, 14.0, 16.0], [9.0 + width, 14.0, 16.0], [9.0 + width, 7.5, 16.0]];
        let angle = |width: f64| {
            let there = [[9.0, 7.0, 16.0], [9.0, 7.0, 4.0], [20.0, 7.0, 4.0]];
            [
                there[0],
                there[1],
                there[2],
                [20.0, 7.0, 4.0 + width],
                [9.0 + width, 7.0, 4.0 + width],
                [9.0 + width, 7.0, 16.0],
            ]
        };
        for (width, is_seen) in [(4e-14, false), (-4e-14, false), (1e-11, true), (1e-3, true)] {
            assert_eq!((is_flat(&strip(width)), is_flat(&angle(width))), (is_seen, is_seen), "{width}");
        }
        for size in [1e-150, 1e-9, 1.0, 1e150] {
            assert!(is_flat(&[[0.0, 0.0, 0.0], [size, 0.0, 0.0], [size, size, 0.0]]), "{size}");
        }
    }
}
