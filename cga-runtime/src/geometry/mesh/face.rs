//! One face of a mesh, read-only.

use std::ops::Range;

use glam::DVec3;

use super::{Bounds, FaceTag, Mesh};

/// A planar polygon with holes: a view into its mesh.
#[derive(Clone, Copy, Debug)]
pub struct FaceRef<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) index: usize,
}

impl<'a> FaceRef<'a> {
    /// Its number in the mesh.
    pub fn index(&self) -> usize {
        self.index
    }

    /// The outline, counter-clockwise seen from outside, as indices into the points.
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

    /// All its corners, as a range of [`Mesh::corners`], [`Mesh::uvs`] and [`Mesh::normals`].
    pub fn corner_range(&self) -> Range<usize> {
        let loops = self.mesh.face_loops(self.index);
        self.mesh.loop_range(loops.start).start..self.mesh.loop_range(loops.end - 1).end
    }

    /// How many corners it has, those of holes included.
    pub fn corner_count(&self) -> usize {
        self.corner_range().len()
    }

    /// Group, material, and whether a cut made it.
    pub fn tag(&self) -> FaceTag {
        self.mesh.tags[self.index]
    }

    /// The positions of its outline.
    pub(crate) fn outline(&self) -> impl Iterator<Item = DVec3> + 'a {
        let mesh = self.mesh;
        self.outer().iter().map(|&point| mesh.points[point as usize])
    }

    /// The position of a corner of the mesh.
    pub(crate) fn position(&self, corner: usize) -> DVec3 {
        self.mesh.points[self.mesh.corners[corner] as usize]
    }

    /// Twice the area, along the normal.
    pub(crate) fn area_vector(&self) -> DVec3 {
        self.area_vector_of(|p| p)
    }

    /// The same of other positions (Newell's sum, about the first corner so that distance costs no digits).
    #[inline(always)]
    fn area_vector_of(&self, place: impl Fn(DVec3) -> DVec3) -> DVec3 {
        let at = |point: u32| place(self.mesh.points[point as usize]);
        let corners = &self.mesh.corners[self.corner_range()];
        if let [a, b, c] = *corners {
            // What is left of the sum; most faces of large meshes are triangles.
            let from = at(a);
            return (at(b) - from).cross(at(c) - from);
        }
        let from = place(self.position(self.corner_range().start));
        let mut sum = DVec3::ZERO;
        for ring in self.loops() {
            let mut last = at(ring[ring.len() - 1]) - from;
            for &c in ring {
                let here = at(c) - from;
                sum += last.cross(here);
                last = here;
            }
        }
        sum
    }

    /// The unit normal, zero for a face without area; of faces of any size.
    pub fn normal(&self) -> DVec3 {
        /// Far above what is lost where products underflow.
        const SMALL: f64 = 1e-250;
        let sum = self.area_vector();
        let size = sum.abs().max_element();
        let safe = SMALL < size && size < f64::INFINITY;
        unit(if safe { sum } else { self.area_vector_at_one() })
    }

    /// The area vector of the face made about one large.
    #[cold]
    fn area_vector_at_one(&self) -> DVec3 {
        let scale = Bounds::of(self.corner_range().map(|corner| self.position(corner))).scale_to_one();
        self.area_vector_of(|p| p * scale)
    }

    /// The unit normal once the mesh is stretched along its axes; zero for a face without area.
    pub(crate) fn stretched_normal(&self, stretch: DVec3) -> DVec3 {
        unit(self.area_vector() * DVec3::new(stretch.y * stretch.z, stretch.z * stretch.x, stretch.x * stretch.y))
    }

    /// The area, holes taken off.
    pub fn area(&self) -> f64 {
        0.5 * self.area_vector().length()
    }
}

/// A vector made one long, or zero; safe for very small and very large ones.
pub(crate) fn unit(v: DVec3) -> DVec3 {
    let scale = v.abs().max_element();
    if 0.0 < scale && scale < f64::INFINITY { (v / scale).normalize() } else { DVec3::ZERO }
}
