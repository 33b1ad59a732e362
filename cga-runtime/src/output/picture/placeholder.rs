//! Boxes in the place of missing assets: as large as their scopes, to show what will be there, and translucent, to hide nothing.

use std::sync::Arc;

use crate::asset::MISSING;
use crate::geometry::mesh::{Bounds, Mesh};
use crate::material::{Color, Material};
use crate::output::model::{Geometry, Model};
use crate::shape::filled_scope::{self, Cuboid};
use crate::shape::scope::Scope;
use crate::shape::unit::UnitMesh;

/// The box of a leaf whose mesh marks the place of a missing asset.
pub(super) fn placeholder(mesh: &Mesh, scope: &Scope) -> Option<Cuboid> {
    mesh.groups().iter().any(|group| group == MISSING).then(|| filled_scope::cuboid(scope, UnitMesh::cuboid()))
}

/// The look of the boxes.
pub(super) fn material() -> Arc<Material> {
    let color = Some(Color { r: 1.0, g: 0.45, b: 0.1 });
    Arc::new(Material { color, opacity: Some(0.3), ..Material::default() })
}

/// The box around a model and its placeholders, in the world.
pub(super) fn bounds(model: &Model) -> Bounds {
    model.leaves().fold(model.bounds(), |sum, leaf| match leaf.geometry() {
        Geometry::Mesh { mesh, .. } | Geometry::Instance { mesh, .. } => match placeholder(mesh, &leaf.scope()) {
            Some(cuboid) => sum.union(Bounds::of(cuboid.corners())),
            None => sum,
        },
        Geometry::Placement | Geometry::Quad(_) | Geometry::Cuboid(_) => sum,
    })
}
