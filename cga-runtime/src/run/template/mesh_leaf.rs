//! Leaves of templates that do not fill their scopes: meshes, and leaves without faces.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::TurnedBreak;
use crate::geometry::mesh::Mesh;
use crate::material::Material;
use crate::run::sink::{Flow, Leaf, Sink};
use crate::shape::scope::Scope;
use crate::value::text::Text;

/// A leaf of a shape at the origin.
#[derive(Clone, Debug)]
pub(super) struct MeshLeaf {
    rule: Text,
    material: Arc<Material>,
    /// Its scope, relative to the repetition.
    pub(super) scope: Scope,
    geometry: LeafGeometry,
}

/// A mesh with the map from its coordinates, or none.
#[derive(Clone, Debug)]
pub(super) enum LeafGeometry {
    Mesh(Arc<Mesh>, DAffine3),
    Instance(Arc<Mesh>, DAffine3),
    Placement,
}

impl MeshLeaf {
    pub(super) fn of(leaf: &Leaf<'_>, geometry: LeafGeometry) -> Self {
        MeshLeaf { rule: leaf.rule.clone(), material: leaf.material.clone(), scope: leaf.scope(), geometry }
    }

    /// The map from the coordinates of its mesh.
    pub(super) fn placement(&self) -> DAffine3 {
        match self.geometry {
            LeafGeometry::Mesh(_, placement) | LeafGeometry::Instance(_, placement) => placement,
            LeafGeometry::Placement => DAffine3::IDENTITY,
        }
    }

    /// The number of corners of its mesh. An asset is kept anyway.
    pub(super) fn corner_count(&self) -> usize {
        match &self.geometry {
            LeafGeometry::Mesh(mesh, _) => mesh.corners().len(),
            LeafGeometry::Instance(..) | LeafGeometry::Placement => 0,
        }
    }

    /// Passes the leaf to a sink, for a repetition at `part`.
    pub(super) fn pass(&self, sink: &mut dyn Sink, part: DVec3, at: &TurnedBreak) -> Flow {
        let scope = Scope { origin: part + at.origin, axes: at.axes, size: self.scope.size };
        let leaf = Leaf::new(&self.rule, &self.material, &scope);
        let placement = DAffine3 { translation: part + at.placement.translation, ..at.placement };
        match &self.geometry {
            LeafGeometry::Mesh(mesh, _) => sink.mesh(&leaf, mesh, &placement),
            LeafGeometry::Instance(mesh, _) => sink.instance(&leaf, mesh, &placement),
            LeafGeometry::Placement => sink.placement(&leaf),
        }
    }
}
