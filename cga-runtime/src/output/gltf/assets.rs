//! Inserted assets, stored once if they are shown more than once.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::{Glb, Instances, SharedMesh};
use crate::geometry::mesh::Mesh;

/// Assets by mesh, rule and material, in the order of their first use.
#[derive(Debug, Default)]
pub(super) struct AssetList {
    list: Vec<PlacedAsset>,
    /// Only for look-ups, never iterated.
    by_mesh: HashMap<(usize, u32, u32), usize>,
}

/// An asset with one rule and one material, at one or more places.
#[derive(Debug)]
struct PlacedAsset {
    mesh: Arc<Mesh>,
    rule: u32,
    material: u32,
    placements: Vec<DAffine3>,
}

impl AssetList {
    /// Records a place of an asset.
    pub(super) fn add(&mut self, mesh: &Arc<Mesh>, rule: u32, material: u32, placement: &DAffine3) {
        let list = &mut self.list;
        // The list keeps the first mesh, so its address belongs to no other mesh.
        let index = *self.by_mesh.entry((Arc::as_ptr(mesh).addr(), rule, material)).or_insert_with(|| {
            list.push(PlacedAsset { mesh: mesh.clone(), rule, material, placements: Vec::new() });
            list.len() - 1
        });
        self.list[index].placements.push(*placement);
    }
}

impl Glb {
    /// Turns assets at several places into separate meshes; the others join the rest.
    pub(super) fn place_assets(&mut self) -> Vec<SharedMesh> {
        let mut shared = Vec::new();
        for PlacedAsset { mesh, rule, material, placements } in std::mem::take(&mut self.assets).list {
            let (own, loose): (Vec<_>, Vec<_>) = placements.into_iter().partition(is_node_transform);
            if 2 <= own.len() {
                // Filled in the mesh's own coordinates, with a separate list of primitives.
                let main = std::mem::take(&mut self.primitives);
                let origin = std::mem::take(&mut self.origin);
                self.add_mesh(rule, material, &mesh, &DAffine3::IDENTITY);
                self.origin = origin;
                let primitives = std::mem::replace(&mut self.primitives, main);
                shared.push(SharedMesh { primitives: primitives.into_list(), places: Instances::Nodes(own) });
            } else {
                own.iter().for_each(|placement| self.add_mesh(rule, material, &mesh, placement));
            }
            loose.iter().for_each(|placement| self.add_mesh(rule, material, &mesh, placement));
        }
        shared
    }
}

/// Returns true if a glTF node can express the placement: no shear, and no mirroring, which would turn the faces
/// over.
fn is_node_transform(placement: &DAffine3) -> bool {
    let [x, y, z] = [placement.matrix3.x_axis, placement.matrix3.y_axis, placement.matrix3.z_axis];
    let right = |a: DVec3, b: DVec3| a.dot(b).abs() <= 1e-9 * a.length() * b.length();
    0.0 < placement.matrix3.determinant() && right(x, y) && right(y, z) && right(z, x)
}
