//! Inserted assets at their places: a mesh at several places is stored once.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use crate::geometry::mesh::Mesh;

/// Assets by mesh, rule and material, in the order of their first use. Each place has a value of type `T`.
#[derive(Debug, Default)]
pub(super) struct AssetList<T> {
    list: Vec<PlacedAsset<T>>,
    /// Only for look-ups, never iterated.
    by_mesh: HashMap<(usize, u32, u32), usize>,
}

/// An asset with one rule and one material, at one or more places.
#[derive(Debug)]
pub(super) struct PlacedAsset<T> {
    pub(super) mesh: Arc<Mesh>,
    pub(super) rule: u32,
    pub(super) material: u32,
    places: Vec<(DAffine3, T)>,
}

impl<T> AssetList<T> {
    /// Records a place of an asset.
    pub(super) fn add(&mut self, mesh: &Arc<Mesh>, rule: u32, material: u32, place: (DAffine3, T)) {
        let list = &mut self.list;
        // The list keeps the first mesh, so its address belongs to no other mesh.
        let index = *self.by_mesh.entry((Arc::as_ptr(mesh).addr(), rule, material)).or_insert_with(|| {
            list.push(PlacedAsset { mesh: mesh.clone(), rule, material, places: Vec::new() });
            list.len() - 1
        });
        self.list[index].places.push(place);
    }

    /// The assets.
    pub(super) fn into_list(self) -> Vec<PlacedAsset<T>> {
        self.list
    }
}

/// Places of a mesh, each with its value.
pub(super) type Places<T> = Vec<(DAffine3, T)>;

impl<T> PlacedAsset<T> {
    /// Divides the places of a mesh: two or more places share a mesh that is stored once; at the others the mesh joins the rest.
    pub(super) fn shared_and_single(&mut self) -> (Places<T>, Places<T>) {
        let (mut shared, mut single): (Vec<_>, Vec<_>) =
            std::mem::take(&mut self.places).into_iter().partition(|(place, _)| is_node_transform(place));
        if shared.len() < 2 {
            shared.append(&mut single);
            std::mem::swap(&mut shared, &mut single);
        }
        (shared, single)
    }
}

/// Returns true if a node of a scene can express the placement: no shear, and no mirroring, which would turn the faces
/// over.
fn is_node_transform(placement: &DAffine3) -> bool {
    let [x, y, z] = [placement.matrix3.x_axis, placement.matrix3.y_axis, placement.matrix3.z_axis];
    let right = |a: DVec3, b: DVec3| a.dot(b).abs() <= 1e-9 * a.length() * b.length();
    0.0 < placement.matrix3.determinant() && right(x, y) && right(y, z) && right(z, x)
}
