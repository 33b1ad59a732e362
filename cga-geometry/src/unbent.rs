//! Bent faces as triangles, for algorithms of planar faces.

use std::borrow::Cow;

use glam::DVec3;

use crate::derive::{CornerValues, Derivation, FaceOrigin};
use crate::each::Each;
use crate::mesh::{Mesh, unit};
use crate::tol::UP_EPSILON;
use crate::triangulate::Triangulator;

/// The mesh with its bent faces as their triangles, which have the attributes of the face.
pub fn without_bent_faces(mesh: &Mesh) -> Cow<'_, Mesh> {
    if mesh.bent == DVec3::ZERO {
        return Cow::Borrowed(mesh);
    }
    let mut made = Derivation::new(mesh, CornerValues::All, mesh.corners().len()).with_old_points();
    let mut triangulator = Triangulator::new();
    for face in mesh.faces() {
        let (origin, mut triangles) = (FaceOrigin::piece(&face), Vec::new());
        if face.is_bent() {
            triangulator.face(mesh, face.index(), &mut triangles);
        }
        for triangle in &triangles {
            made.keep([triangle.each(|corner| corner as usize)], origin);
        }
        if triangles.is_empty() {
            made.keep(face.loop_ranges(), origin);
        }
    }
    Cow::Owned(Mesh { bent: DVec3::ZERO, ..made.finish() })
}

/// The mesh beside others whose bent faces have a direction, which is zero before the first one: a mesh with another direction
/// has triangles.
pub fn bent_along(mesh: Mesh, direction: &mut DVec3) -> Mesh {
    if mesh.bent == DVec3::ZERO {
        return mesh;
    }
    if *direction == DVec3::ZERO {
        *direction = mesh.bent;
    }
    match unit(mesh.bent).distance(unit(*direction)) <= UP_EPSILON {
        true => mesh,
        false => without_bent_faces(&mesh).into_owned(),
    }
}
