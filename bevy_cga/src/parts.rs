//! Components of a model that is shown.

use std::sync::Arc;

use bevy_ecs::component::Component;
use bevy_ecs::entity::Entity;
use bevy_ecs::resource::Resource;
use bevy_transform::components::Transform;
use cga::glam::DVec3;
use cga::sink::meshes::MeshLeaf;
use cga::{Layer, Material, Model};

/// The model that is shown, on the entity with [`Cga`](crate::Cga). A clone of the entity has none until its own run has ended.
#[derive(Component, Clone, Debug)]
#[component(clone_behavior = Ignore)]
pub struct CgaModel {
    /// The model: leaves, reports, faults.
    pub model: Arc<Model>,
    /// The parent of all meshes, a child of this entity.
    pub root: Entity,
}

/// The parent of all meshes of a model. The next model has a new root; this one is despawned with all its children.
#[derive(Component, Clone, Debug)]
#[require(Transform)]
pub struct CgaRoot {
    /// The point, in coordinates of the shape, to which the children are relative.
    pub origin: DVec3,
}

/// A mesh of a model, or one of the places of a mesh that rules insert several times.
#[derive(Component, Clone, Debug)]
pub struct CgaMesh {
    /// The rule or leaf symbol of all leaves; `None` for a mesh with leaves of any rule.
    pub rule: Option<cga::Text>,
    /// The material.
    pub material: Arc<Material>,
    /// The leaves with the ranges of their indices.
    pub leaves: Vec<MeshLeaf>,
    pub(crate) channels: [Option<u8>; 10],
}

/// The point of the shapes' coordinates that is the origin of Bevy's world: subtracted from all shapes, in 64 bits. With
/// coordinates of a map, choose a point in the middle. A change moves all models.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub struct CgaOrigin(pub DVec3);

impl CgaMesh {
    /// The index in [`Model::leaves`] of the leaf with a triangle, for a triangle that a ray hits.
    pub fn leaf_of_triangle(&self, triangle: usize) -> Option<usize> {
        let index = triangle.checked_mul(3)?;
        let after = self.leaves.partition_point(|leaf| leaf.indices.start <= index);
        let leaf = &self.leaves[after.checked_sub(1)?];
        leaf.indices.contains(&index).then_some(leaf.leaf)
    }

    /// The channel of texture coordinates for the image of a layer. `None` if the layer has no image or no coordinates,
    /// or if other layers use both channels.
    pub fn channel(&self, layer: Layer) -> Option<u8> {
        self.channels[layer.uv_set()]
    }
}
