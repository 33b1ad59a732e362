//! A read-only view of a face.

use std::ops::Range;

use glam::DVec3;

use super::{Bounds, FaceTag, Mesh, TagSet};
use crate::vector::{area_vector, unit, well_scaled};

/// A polygon with holes: a view into its mesh. It should be planar; see [`Mesh::check`] and
/// [`planar_faces`](crate::unbent::planar_faces). Roofs whose ridges were made level have bent faces, which operations know.
#[derive(Clone, Copy, Debug)]
pub struct FaceRef<'a> {
    pub(crate) mesh: &'a Mesh,
    pub(super) index: usize,
}

impl<'a> FaceRef<'a> {
    /// The component tags of the face, if it has some.
    pub fn tags(&self) -> Option<&'a TagSet> {
        self.mesh.tag_sets().get(self.tag().tags as usize)
    }

    /// The number of the face in the mesh.
    pub fn index(&self) -> usize {
        self.index
    }

    /// The outline, counter-clockwise as seen from outside, as indices into the points.
    #[inline]
    pub fn outer(&self) -> &'a [u32] {
        &self.mesh.corners[self.mesh.loop_range(self.mesh.face_loops(self.index).start)]
    }

    /// The holes, clockwise.
    pub fn holes(&self) -> impl ExactSizeIterator<Item = &'a [u32]> + Clone {
        let loops = self.mesh.face_loops(self.index);
        let mesh = self.mesh;
        (loops.start + 1..loops.end).map(move |l| &mesh.corners[mesh.loop_range(l)])
    }

    /// The outline, then the holes.
    pub fn loops(&self) -> impl ExactSizeIterator<Item = &'a [u32]> + Clone {
        let mesh = self.mesh;
        mesh.face_loops(self.index).map(move |l| &mesh.corners[mesh.loop_range(l)])
    }

    /// The outline, then the holes, each as a range of [`Mesh::corners`], [`Mesh::uvs`] and [`Mesh::normals`].
    pub fn loop_ranges(&self) -> impl ExactSizeIterator<Item = Range<usize>> + Clone + use<'a> {
        let mesh = self.mesh;
        mesh.face_loops(self.index).map(move |l| mesh.loop_range(l))
    }

    /// All corners, as a range of [`Mesh::corners`], [`Mesh::uvs`] and [`Mesh::normals`].
    #[inline]
    pub fn corner_range(&self) -> Range<usize> {
        self.mesh.face_corners(self.index)
    }

    /// The number of corners, with the corners of holes.
    pub fn corner_count(&self) -> usize {
        self.corner_range().len()
    }

    /// The edges of all loops, as their first and their last corner.
    pub fn edges(&self) -> impl Iterator<Item = [usize; 2]> + use<'a> {
        self.loop_ranges().flat_map(|ring| {
            let Range { start, end } = ring;
            ring.map(move |corner| [corner, if corner + 1 == end { start } else { corner + 1 }])
        })
    }

    /// The group, the material, the tags, and whether a cut made the face.
    #[inline]
    pub fn tag(&self) -> FaceTag {
        self.mesh.tags[self.index]
    }

    /// The positions of the outline.
    pub fn outline(&self) -> impl Iterator<Item = DVec3> + Clone + 'a {
        let mesh = self.mesh;
        self.outer().iter().map(|&point| mesh.points[point as usize])
    }

    /// The position of a corner of the mesh, by its number in [`Mesh::corners`]. The corner may belong to any face.
    ///
    /// # Panics
    /// Panics if the mesh does not have the corner.
    pub fn position(&self, corner: usize) -> DVec3 {
        self.mesh.points[self.mesh.corners[corner] as usize]
    }

    /// The normal with twice the area as its length, in square metres. It overflows or vanishes for faces of extreme sizes.
    pub fn area_vector(&self) -> DVec3 {
        self.area_vector_of(|p| p)
    }

    /// The same for other positions.
    #[inline(always)]
    fn area_vector_of(&self, place: impl Fn(DVec3) -> DVec3) -> DVec3 {
        let at = |point: u32| place(self.mesh.points[point as usize]);
        let corners = &self.mesh.corners[self.corner_range()];
        area_vector_of_few(corners, at).unwrap_or_else(|| self.area_vector_of_loops(&at))
    }

    #[inline(always)]
    fn area_vector_of_loops(&self, at: &impl Fn(u32) -> DVec3) -> DVec3 {
        area_vector(self.loops().map(|ring| ring.iter().map(|&point| at(point))))
    }

    /// The unit normal, for faces of any size; zero for a face without area.
    pub fn normal(&self) -> DVec3 {
        unit(well_scaled(self.area_vector(), || self.area_vector_at_one()))
    }

    /// The area vector of the face scaled to a size of about 1.
    #[cold]
    pub(super) fn area_vector_at_one(&self) -> DVec3 {
        let scale = Bounds::of(self.corner_range().map(|corner| self.position(corner))).scale_to_one();
        self.area_vector_of(|p| p * scale)
    }

    /// The unit normal after the mesh is stretched along its axes; zero for a face without area.
    pub fn stretched_normal(&self, stretch: DVec3) -> DVec3 {
        unit(self.area_vector() * DVec3::new(stretch.y * stretch.z, stretch.z * stretch.x, stretch.x * stretch.y))
    }

    /// The area in square metres, without the holes.
    pub fn area(&self) -> f64 {
        0.5 * self.sum_of_vectors(DVec3::length)
    }
}

/// The area vector of a triangle or a quadrilateral. The sum over edges reduces to this, and most faces are one of them.
#[inline(always)]
pub(super) fn area_vector_of_few(corners: &[u32], at: impl Fn(u32) -> DVec3) -> Option<DVec3> {
    match *corners {
        [a, b, c] => {
            let from = at(a);
            Some((at(b) - from).cross(at(c) - from))
        }
        [a, b, c, d] => {
            let from = at(a);
            let across = at(c) - from;
            // From zero on, as the sum of more corners.
            Some(DVec3::ZERO + (at(b) - from).cross(across) + across.cross(at(d) - from))
        }
        _ => None,
    }
}
