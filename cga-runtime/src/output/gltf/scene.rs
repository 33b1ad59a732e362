//! The meshes of the scene, and their places.

use crate::value::each::Each;
use glam::{DAffine3, DQuat, DVec3};

use super::primitive::{Primitive, Primitives};

/// A mesh of the file.
pub(super) struct SceneMesh {
    pub(super) primitives: Vec<Primitive>,
    pub(super) places: MeshPlacement,
}

/// The places of a mesh.
#[derive(Clone)]
pub(super) enum MeshPlacement {
    /// In the root node.
    Root,
    /// In a node of its own that does not move it.
    Child,
    /// A node for each place.
    Nodes(Vec<DAffine3>),
    /// One node for all places.
    Instances(Vec<MeshInstance>),
}

impl SceneMesh {
    /// The mesh divided into one for each rule.
    pub(super) fn by_rule(self) -> Vec<SceneMesh> {
        let mut rules: Vec<(u32, Primitives)> = Vec::new();
        for primitive in &self.primitives {
            primitive.each_rule(|rule, vertices, indices| {
                let at = rules.iter().position(|(known, _)| *known == rule).unwrap_or_else(|| {
                    rules.push((rule, Primitives::default()));
                    rules.len() - 1
                });
                rules[at].1.add_part(primitive, rule, vertices, indices);
            });
        }
        let places = match self.places {
            MeshPlacement::Root => MeshPlacement::Child,
            other => other,
        };
        let mesh = |(_, primitives): (u32, Primitives)| SceneMesh {
            primitives: primitives.into_list(),
            places: places.clone(),
        };
        rules.into_iter().map(mesh).collect()
    }

    /// The number of the rule of all triangles, if there is only one.
    pub(super) fn rule(&self) -> Option<u32> {
        let mut rules = self.primitives.iter().flat_map(|primitive| &primitive.rules).map(|(rule, _)| *rule);
        let first = rules.next()?;
        rules.all(|rule| rule == first).then_some(first)
    }
}

/// A place of an instance, relative to the origin of the file.
#[derive(Clone, Copy, Debug)]
pub(super) struct MeshInstance {
    pub(super) translation: [f32; 3],
    /// A unit quaternion.
    pub(super) rotation: [f32; 4],
}

impl MeshInstance {
    pub(super) fn new(placement: &DAffine3, origin: DVec3) -> Self {
        MeshInstance {
            translation: (placement.translation - origin).to_array().each(|c| c as f32),
            rotation: DQuat::from_mat3(&placement.matrix3).normalize().to_array().each(|c| c as f32),
        }
    }
}
