//! The meshes of the scene, and their places.

use std::collections::HashMap;

use glam::{DAffine3, DQuat, DVec3};

use super::primitive::{Primitive, Primitives};
use crate::geometry::each::Each;

/// A mesh of the file.
pub(super) struct SceneMesh {
    pub(super) primitives: Vec<Primitive>,
    pub(super) places: MeshPlacement,
    /// The building of all its triangles, if the mesh was divided by buildings.
    pub(super) building: Option<u32>,
}

/// What has meshes of its own.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Division {
    pub(super) by_building: bool,
    pub(super) by_rule: bool,
}

/// The places of a mesh.
#[derive(Clone)]
pub(super) enum MeshPlacement {
    /// In the root node.
    Root,
    /// In a node of its own that does not move it.
    Child,
    /// A node for each place, with the number of its building.
    Nodes(Vec<(DAffine3, u32)>),
    /// One node for all places.
    Instances(Vec<MeshInstance>),
}

impl SceneMesh {
    /// The mesh divided into one for each building, each rule, or each rule of a building, in the order of their first leaves.
    pub(super) fn divided(self, by: Division) -> Vec<SceneMesh> {
        // A mesh at several places belongs to no building.
        let by_building = by.by_building && matches!(self.places, MeshPlacement::Root);
        if !by_building && !by.by_rule {
            return vec![self];
        }
        type Key = (Option<u32>, Option<u32>);
        let mut divided: Vec<(Option<u32>, Primitives)> = Vec::new();
        // Only for look-ups, never iterated.
        let mut known: HashMap<Key, usize> = HashMap::new();
        for primitive in self.primitives {
            // Parts of it are taken.
            let primitive = Primitive { faces: primitive.faces.into_loose(), ..primitive };
            primitive.each_owner(|owner, vertices, indices| {
                let (building, rule) = (by_building.then_some(owner.building), by.by_rule.then_some(owner.rule));
                let at = *known.entry((building, rule)).or_insert_with(|| {
                    divided.push((building, Primitives::default()));
                    divided.len() - 1
                });
                divided[at].1.add_part(&primitive, owner, vertices, indices);
            });
        }
        let places = match self.places {
            MeshPlacement::Root => MeshPlacement::Child,
            other => other,
        };
        let mesh = |(building, primitives): (Option<u32>, Primitives)| SceneMesh {
            primitives: primitives.into_list(),
            places: places.clone(),
            building,
        };
        divided.into_iter().map(mesh).collect()
    }

    /// Returns true if its vertices are in the place where they are shown.
    pub(super) fn is_in_place(&self) -> bool {
        matches!(self.places, MeshPlacement::Root | MeshPlacement::Child)
    }

    /// Passes the numbers of the buildings of its vertices or of its places to `each`, which may change them.
    pub(super) fn each_building(&mut self, mut each: impl FnMut(&mut u32)) {
        match &mut self.places {
            MeshPlacement::Root | MeshPlacement::Child => {
                let owners = self.primitives.iter_mut().flat_map(|primitive| &mut primitive.owners);
                owners.for_each(|(owner, _)| each(&mut owner.building));
            }
            MeshPlacement::Nodes(nodes) => nodes.iter_mut().for_each(|(_, building)| each(building)),
            MeshPlacement::Instances(places) => places.iter_mut().for_each(|place| each(&mut place.building)),
        }
    }

    /// The number of the rule of all triangles, if there is only one.
    pub(super) fn rule(&self) -> Option<u32> {
        let mut rules = self.primitives.iter().flat_map(|primitive| &primitive.owners).map(|(owner, _)| owner.rule);
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
    pub(super) building: u32,
}

impl MeshInstance {
    pub(super) fn new(placement: &DAffine3, building: u32, origin: DVec3) -> Self {
        MeshInstance {
            translation: (placement.translation - origin).to_array().each(|c| c as f32),
            rotation: DQuat::from_mat3(&placement.matrix3).normalize().to_array().each(|c| c as f32),
            building,
        }
    }
}

/// A node that shows a mesh at several places: the accessors of their translations, their rotations and their buildings.
pub(super) struct NodePlaces {
    /// The number of the mesh.
    pub(super) mesh: usize,
    /// The building of all places, if buildings have nodes.
    pub(super) building: Option<u32>,
    pub(super) translations: usize,
    pub(super) rotations: usize,
    pub(super) buildings: Option<usize>,
}

/// The extension for lists of places.
pub(super) const INSTANCING: &str = "EXT_mesh_gpu_instancing";
