//! Bent faces as triangles, for algorithms of planar faces.

use std::borrow::Cow;

use glam::DVec3;

use crate::derive::{CornerValues, Derivation, FaceOrigin};
use crate::each::Each;
use crate::mesh::{FaceRef, Flaw, Mesh, unit};
use crate::tol::UP_EPSILON;
use crate::triangulate::Triangulator;

/// The mesh with its bent faces as their triangles, which have the attributes of the face.
pub fn without_bent_faces(mesh: &Mesh) -> Cow<'_, Mesh> {
    if mesh.bent == DVec3::ZERO {
        return Cow::Borrowed(mesh);
    }
    match in_triangles(mesh, |face| face.is_bent()) {
        Cow::Borrowed(_) => Cow::Owned(Mesh { bent: DVec3::ZERO, ..mesh.clone() }),
        made => made,
    }
}

/// The mesh whose faces are planar: triangles in place of each face whose corners are out of its plane by more than rounding. Cuts
/// and booleans need planar faces. Files often have others, which [`Mesh::check`] names.
///
/// ```
/// use cga_geometry::mesh::MeshBuilder;
/// use cga_geometry::unbent::planar_faces;
///
/// let mut builder = MeshBuilder::new();
/// let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 0.5, -2.0], [0.0, 0.0, -2.0]].map(|at| builder.point(at));
/// builder.polygon(&corners);
/// assert_eq!(planar_faces(&builder.build()?).face_count(), 2);
/// # Ok::<(), cga_geometry::mesh::MeshError>(())
/// ```
pub fn planar_faces(mesh: &Mesh) -> Cow<'_, Mesh> {
    let mut is_planar = vec![true; mesh.face_count()];
    for flaw in mesh.check() {
        if let Flaw::NotPlanar { face, .. } = flaw {
            is_planar[face] = false;
        }
    }
    in_triangles(mesh, |face| face.is_bent() || !is_planar[face.index()])
}

/// The mesh with some faces as their triangles, which have the attributes of the face.
fn in_triangles(mesh: &Mesh, is_divided: impl Fn(&FaceRef<'_>) -> bool) -> Cow<'_, Mesh> {
    if !mesh.faces().any(|face| is_divided(&face)) {
        return Cow::Borrowed(mesh);
    }
    let mut made = Derivation::new(mesh, CornerValues::All, mesh.corners().len()).with_old_points();
    let mut triangulator = Triangulator::new();
    for face in mesh.faces() {
        let (origin, mut triangles) = (FaceOrigin::piece(&face), Vec::new());
        if is_divided(&face) {
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
