//! Bent faces: faces whose corners are not in one plane.
//!
//! Roofs with `even` bend faces. A mesh with bent faces has a direction along which none of them has a fold. Measures, cuts,
//! boolean operations and sinks take a bent face as its triangles as seen along this direction, so areas and volumes of parts
//! add up. Everything else sees one face. In a mesh without the direction all faces count as planar, at no cost.

use glam::{DVec2, DVec3};

use super::{FaceRef, unit};
use crate::geometry::tol::PLANAR_EPSILON;
use crate::geometry::triangulate::Triangulator;
use crate::value::each::Each;

impl FaceRef<'_> {
    /// Returns true if the mesh has bent faces, and this face is bent by more than rounding errors.
    #[inline]
    pub(crate) fn is_bent(&self) -> bool {
        self.mesh.bent != DVec3::ZERO && self.is_off_its_plane()
    }

    #[cold]
    fn is_off_its_plane(&self) -> bool {
        let (corners, normal) = (self.corner_range(), self.normal());
        let from = self.position(corners.start);
        let (mut far, mut off) = (0.0f64, 0.0f64);
        for corner in corners {
            let way = self.position(corner) - from;
            (far, off) = (far.max(way.abs().max_element()), off.max(way.dot(normal).abs()));
        }
        PLANAR_EPSILON * far < off
    }

    /// The corners of a bent face as seen along the direction of the mesh. The first axis is along the first edge, so a turn of the
    /// mesh does not change the triangles. `None` for other faces.
    #[inline]
    pub(crate) fn unbent(&self) -> Option<Vec<DVec2>> {
        if self.is_bent() { self.unbent_corners() } else { None }
    }

    #[cold]
    fn unbent_corners(&self) -> Option<Vec<DVec2>> {
        let corners = self.corner_range();
        let [from, to] = [corners.start, corners.start + 1].each(|corner| self.position(corner));
        let along = unit(self.mesh.bent);
        let along = if along.dot(self.normal()) < 0.0 { -along } else { along };
        let y = unit(along.cross(to - from));
        let x = y.cross(along);
        let flat = |corner: usize| {
            let way = self.position(corner) - from;
            DVec2::new(way.dot(x), way.dot(y))
        };
        (y != DVec3::ZERO).then(|| corners.map(flat).collect())
    }

    /// The corners of the triangles of a bent face.
    #[cold]
    pub(crate) fn bent_triangles(&self) -> Vec<[DVec3; 3]> {
        let mut triangles = Vec::new();
        Triangulator::new().face(self.mesh, self.index(), &mut triangles);
        triangles.into_iter().map(|triangle| triangle.each(|corner| self.position(corner as usize))).collect()
    }

    /// The sum of a value of area vectors: of the face, or of its triangles if it is bent.
    #[inline]
    pub(crate) fn sum_of_vectors(&self, value: impl Fn(DVec3) -> f64) -> f64 {
        if self.is_bent() {
            return self.bent_triangles().into_iter().map(|[a, b, c]| value((b - a).cross(c - a))).sum();
        }
        value(self.area_vector())
    }
}
