//! Leaves that wait for the other leaves of their initial shape.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use crate::geometry::mesh::Mesh;
use crate::geometry::uv_map::SetMap;
use crate::material::Material;
use crate::run::sink::{Cuboid, Flow, Leaf, Quad, Sink};
use crate::shape::scope::Scope;
use crate::shape::unit::UnitMesh;
use crate::value::text::Text;

/// A leaf that waits.
#[derive(Clone, Debug)]
pub(super) struct Held {
    rule: Text,
    material: Arc<Material>,
    scope: Scope,
    uvs: Vec<SetMap>,
    geometry: HeldGeometry,
}

#[derive(Clone, Debug)]
pub(super) enum HeldGeometry {
    Placement,
    Quad(Quad),
    Cuboid(Cuboid),
    Mesh(Arc<Mesh>, DAffine3),
    Instance(Arc<Mesh>, DAffine3),
}

/// The faces of a leaf, and the places of their points.
pub(super) struct Faces<'a> {
    pub(super) mesh: &'a Mesh,
    /// True if the mesh is of a box.
    pub(super) is_box: bool,
    /// True if the mesh is of a rectangle or a box.
    pub(super) is_unit: bool,
}

impl Held {
    pub(super) fn new(leaf: &Leaf<'_>, geometry: HeldGeometry) -> Self {
        let (rule, material) = (leaf.rule.clone(), leaf.material.clone());
        Held { rule, material, scope: leaf.scope(), uvs: leaf.uvs().to_vec(), geometry }
    }

    pub(super) fn leaf(&self) -> Leaf<'_> {
        Leaf::new(&self.rule, &self.material, &self.scope).with_uvs(&self.uvs)
    }

    /// The faces of the leaf, if they may get points. `points` becomes the points of their mesh, in the world.
    pub(super) fn faces(&self, points: &mut Vec<DVec3>) -> Option<Faces<'_>> {
        points.clear();
        match &self.geometry {
            HeldGeometry::Placement | HeldGeometry::Instance(..) => None,
            HeldGeometry::Quad(quad) => {
                points.extend(quad.points());
                Some(Faces { mesh: quad.unit.mesh(), is_box: false, is_unit: true })
            }
            HeldGeometry::Cuboid(cuboid) => {
                points.extend(cuboid.points());
                Some(Faces { mesh: cuboid.unit.mesh(), is_box: true, is_unit: true })
            }
            HeldGeometry::Mesh(mesh, placement) => {
                points.extend(mesh.points().iter().map(|&point| placement.transform_point3(point)));
                Some(Faces { mesh, is_box: false, is_unit: false })
            }
        }
    }

    /// Returns true for a rectangle or a box without texture coordinates: its mesh in the world is the mesh of [`Held::faces`] at their points.
    pub(super) fn is_plain_unit(&self) -> bool {
        self.uvs.is_empty() && matches!(self.geometry, HeldGeometry::Quad(_) | HeldGeometry::Cuboid(_))
    }

    /// The mesh of the leaf in the world. Its points are bit-equal to [`Held::faces`].
    pub(super) fn mesh(&self) -> Option<Arc<Mesh>> {
        match &self.geometry {
            HeldGeometry::Placement | HeldGeometry::Instance(..) => None,
            HeldGeometry::Quad(quad) => Some(self.unit_mesh(quad.unit, &quad.points())),
            HeldGeometry::Cuboid(cuboid) => Some(self.unit_mesh(cuboid.unit, &cuboid.points())),
            HeldGeometry::Mesh(mesh, placement) if *placement == DAffine3::IDENTITY => Some(mesh.clone()),
            HeldGeometry::Mesh(mesh, placement) => Some(Arc::new(mesh.map(placement))),
        }
    }

    fn unit_mesh(&self, unit: UnitMesh, points: &[DVec3]) -> Arc<Mesh> {
        Arc::new(unit.mesh().with_points(points.to_vec()).with_uvs(&self.uvs))
    }

    /// Passes the leaf on as it was.
    pub(super) fn pass_to<S: Sink>(&self, sink: &mut S) -> Flow {
        match &self.geometry {
            HeldGeometry::Placement => sink.placement(&self.leaf()),
            HeldGeometry::Quad(quad) => sink.quad(&self.leaf(), quad),
            HeldGeometry::Cuboid(cuboid) => sink.cuboid(&self.leaf(), cuboid),
            HeldGeometry::Mesh(mesh, placement) => sink.mesh(&self.leaf(), mesh, placement),
            HeldGeometry::Instance(mesh, placement) => sink.instance(&self.leaf(), mesh, placement),
        }
    }
}
