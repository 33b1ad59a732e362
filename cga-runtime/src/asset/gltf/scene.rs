//! The nodes of the scene: the places of meshes.

use crate::geometry::each::Each;
use glam::{DAffine3, DMat4, DQuat, DVec3};

use super::GltfError;
use super::accessor;
use super::document::Document;
use super::item::{Item, item, items};

/// The extension that places a mesh several times at one node.
pub(super) const INSTANCING: &str = "EXT_mesh_gpu_instancing";

/// The greatest number of places of all meshes.
const MOST_PLACES: usize = 1 << 20;

/// The number of places that a file of any size may have. Each byte of its buffers allows one more: instances may be in accessors
/// without data.
const FREE_PLACES: usize = 1 << 16;

/// A mesh of the file at its places.
pub(super) struct NodeMesh<'a> {
    pub(super) mesh: usize,
    /// The name of the node, else the name of the mesh.
    pub(super) name: Option<&'a str>,
    pub(super) places: Vec<DAffine3>,
}

/// The meshes of the scene that `scene` names, else of the first one. A file without scenes shows all nodes that no node has
/// as a child.
///
/// # Errors
/// A node or mesh does not exist, a node has two parents or is its own ancestor, a number is invalid, or there are too many
/// places.
pub(super) fn placed<'a>(document: &'a Document<'_>) -> Result<Vec<NodeMesh<'a>>, GltfError> {
    let json = &document.json;
    let mut is_visited = vec![false; items(json, "nodes").count()];
    let mut meshes = Vec::new();
    let mut places_left = (FREE_PLACES + document.byte_count()).min(MOST_PLACES);
    let mut waiting: Vec<(usize, DAffine3)> =
        roots(document)?.into_iter().rev().map(|root| (root, DAffine3::IDENTITY)).collect();
    while let Some((index, above)) = waiting.pop() {
        let node = item(json, "nodes", index)?;
        if std::mem::replace(&mut is_visited[index], true) {
            return Err(node.error("it has two parents"));
        }
        let placement = above * own(&node)?;
        if !placement.is_finite() {
            return Err(node.error("its place is not finite"));
        }
        waiting.extend(node.indices("children")?.into_iter().rev().map(|child| (child, placement)));
        if let Some(mesh) = node.whole("mesh")? {
            let named = |item: &Item<'a>| Ok(item.text("name")?.filter(|name| !name.is_empty()));
            let name = named(&node)?.or(named(&item(json, "meshes", mesh)?)?);
            let places = places(document, &node, placement, places_left)?;
            places_left = places_left.checked_sub(places.len()).ok_or(GltfError::TooLarge)?;
            meshes.push(NodeMesh { mesh, name, places });
        }
    }
    Ok(meshes)
}

fn roots(document: &Document<'_>) -> Result<Vec<usize>, GltfError> {
    let json = &document.json;
    let number = json.get("scene").and_then(serde_json::Value::as_u64).unwrap_or(0);
    if items(json, "scenes").next().is_some() {
        return item(json, "scenes", usize::try_from(number).unwrap_or(usize::MAX))?.indices("nodes");
    }
    let mut is_child = vec![false; items(json, "nodes").count()];
    for node in items(json, "nodes") {
        for child in node.indices("children")? {
            *is_child.get_mut(child).ok_or_else(|| node.error("a child does not exist"))? = true;
        }
    }
    // A cycle without scene has no root, and is left out.
    Ok((0..is_child.len()).filter(|&node| !is_child[node]).collect())
}

/// The transformation of a node relative to its parent.
fn own(node: &Item<'_>) -> Result<DAffine3, GltfError> {
    if let Some(matrix) = node.numbers::<16>("matrix")? {
        let matrix = DMat4::from_cols_array(&matrix);
        if matrix.row(3) != glam::DVec4::W {
            return Err(node.error("the last row of its `matrix` must be 0, 0, 0, 1"));
        }
        return Ok(DAffine3::from_mat4(matrix));
    }
    let translation = node.numbers("translation")?.unwrap_or([0.0; 3]);
    let rotation = node.numbers("rotation")?.unwrap_or([0.0, 0.0, 0.0, 1.0]);
    let scale = node.numbers("scale")?.unwrap_or([1.0; 3]);
    Ok(affine(translation, rotation, scale))
}

fn affine(translation: [f64; 3], rotation: [f64; 4], scale: [f64; 3]) -> DAffine3 {
    let rotation = DQuat::from_array(rotation);
    let length = rotation.length();
    // A quaternion without length does not turn.
    let turns = length.is_finite() && 0.0 < length;
    let rotation = if turns { rotation / length } else { DQuat::IDENTITY };
    DAffine3::from_scale_rotation_translation(DVec3::from(scale), rotation, DVec3::from(translation))
}

/// The places of the mesh of a node: one, or the places of its instances, which are at most `most`.
fn places(
    document: &Document<'_>,
    node: &Item<'_>,
    placement: DAffine3,
    most: usize,
) -> Result<Vec<DAffine3>, GltfError> {
    let Some(instancing) = node.extension(INSTANCING)? else { return Ok(vec![placement]) };
    let Some(attributes) = instancing.object("attributes")? else { return Ok(vec![placement]) };
    for member in ["TRANSLATION", "SCALE", "ROTATION"] {
        let count = attributes.whole(member)?.map_or(Ok(0), |accessor| accessor::count(document, accessor))?;
        if most < count {
            return Err(GltfError::TooLarge);
        }
    }
    let vectors = |member| match attributes.whole(member)? {
        Some(accessor) => accessor::vectors::<3>(document, accessor).map(Some),
        None => Ok(None),
    };
    let (translations, scales) = (vectors("TRANSLATION")?, vectors("SCALE")?);
    let rotations = match attributes.whole("ROTATION")? {
        Some(accessor) => Some(accessor::vectors::<4>(document, accessor)?),
        None => None,
    };
    let counts = [&translations, &scales].each(|list| list.as_ref().map(Vec::len));
    let mut counts = counts.into_iter().chain([rotations.as_ref().map(Vec::len)]).flatten();
    let Some(count) = counts.next() else { return Ok(vec![placement]) };
    if counts.any(|other| other != count) {
        return Err(node.error("the lists of its instances differ in length"));
    }
    let place = |at: usize| {
        let vector = |list: &Option<Vec<[f64; 3]>>, or: f64| list.as_ref().map_or([or; 3], |list| list[at]);
        let rotation = rotations.as_ref().map_or([0.0, 0.0, 0.0, 1.0], |list| list[at]);
        let place = placement * affine(vector(&translations, 0.0), rotation, vector(&scales, 1.0));
        place.is_finite().then_some(place).ok_or_else(|| node.error("the place of an instance is not finite"))
    };
    (0..count).map(place).collect()
}
