//! Bent faces: faces whose corners are not in one plane.
//!
//! Roofs with `even` bend faces. A mesh with bent faces has a direction along which none of them has a fold. Measures, cuts,
//! boolean operations and sinks take a bent face as its highest triangles along this direction, so areas and volumes of parts
//! add up, and turned, mirrored and reversed faces have the same surface. Everything else sees one face. In a mesh without the
//! direction all faces count as planar, at no cost.

use glam::{DMat3, DVec3};

use super::{FaceRef, unit};
use crate::each::Each;
use crate::tol::PLANAR_EPSILON;
use crate::triangulate::{Triangulator, highest};

impl FaceRef<'_> {
    /// Returns true if the mesh has bent faces, and this face is bent by more than rounding errors.
    #[inline]
    pub fn is_bent(&self) -> bool {
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

    /// The triangles of a bent face, as numbers of its corners in the mesh: the highest ones along the direction of the
    /// mesh. `None` for a face that is not bent, has holes, or has a fold.
    #[inline]
    pub(crate) fn unbent(&self) -> Option<Vec<[u32; 3]>> {
        if self.is_bent() { self.highest_triangles() } else { None }
    }

    #[cold]
    fn highest_triangles(&self) -> Option<Vec<[u32; 3]>> {
        if self.holes().len() != 0 {
            return None;
        }
        let along = unit(self.mesh.bent);
        let (x, y) = along.any_orthonormal_pair();
        let is_turned = self.area_vector().dot(along) < 0.0;
        let mut corners: Vec<u32> = self.corner_range().map(|corner| corner as u32).collect();
        if is_turned {
            corners.reverse();
        }
        let place = |&corner: &u32| DMat3::from_cols(x, y, along).transpose() * self.position(corner as usize);
        let mut triangles: Vec<[u32; 3]> = highest(&corners.iter().map(place).collect::<Vec<_>>())?
            .into_iter()
            .map(|triangle| triangle.each(|number| corners[number]))
            .collect();
        if is_turned {
            triangles.iter_mut().for_each(|[_, b, c]| std::mem::swap(b, c));
        }
        Some(triangles)
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
    pub fn sum_of_vectors(&self, value: impl Fn(DVec3) -> f64) -> f64 {
        if self.is_bent() {
            return self.bent_triangles().into_iter().map(|[a, b, c]| value((b - a).cross(c - a))).sum();
        }
        value(self.area_vector())
    }
}
