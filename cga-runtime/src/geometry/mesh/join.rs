//! Several meshes as one.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::{FaceTag, Mesh, SubcomponentTagsBuilder, UvSets};
use crate::material::Material;

/// The number of last elements of a list that are searched for an equal one.
const FAR: usize = 64;

/// A list in which most equal elements are one.
struct Distinct<T>(Vec<T>);

impl<T: PartialEq + Clone> Distinct<T> {
    /// The number of an element in the list.
    fn number(&mut self, element: &T) -> u32 {
        let recent = self.0.len().saturating_sub(FAR);
        let at = self.0[recent..].iter().position(|known| known == element);
        if at.is_none() {
            self.0.push(element.clone());
        }
        at.map_or(self.0.len() - 1, |at| recent + at) as u32
    }

    /// The numbers of the elements of another list, and the number of "none" in the end.
    fn numbers(&mut self, list: &[T]) -> Vec<u32> {
        list.iter().map(|element| self.number(element)).collect()
    }
}

fn renumbered(index: u32, numbers: &[u32]) -> u32 {
    numbers.get(index as usize).copied().unwrap_or(FaceTag::NONE)
}

/// The faces of all meshes, in order; no points are merged. A mesh without a texture set that another one has gets
/// coordinates 0 there, and a mesh without normals gets the normals of its faces. Bent faces have one direction.
pub(crate) fn join<'m>(meshes: impl Iterator<Item = &'m Mesh>) -> Mesh {
    join_all(&meshes.collect::<Vec<_>>())
}

fn join_all(meshes: &[&Mesh]) -> Mesh {
    let (mut groups, mut materials, mut tag_sets) = (Distinct(Vec::new()), Distinct(Vec::new()), Distinct(Vec::new()));
    let has_set = |set: usize| meshes.iter().any(|mesh| !mesh.uvs.get(set).is_empty());
    let has_sets: Vec<usize> = (0..UvSets::MOST).filter(|set| has_set(*set)).collect();
    let has_normals = meshes.iter().any(|mesh| !mesh.normals.is_empty());
    let (mut sum, mut tagger) = (Mesh::default(), SubcomponentTagsBuilder::default());
    for mesh in meshes {
        let numbers =
            [groups.numbers(&mesh.groups), materials.numbers(&mesh.materials), tag_sets.numbers(&mesh.tag_sets)];
        let (points, corners) = (sum.points.len() as u32, sum.corners.len() as u32);
        tagger.append(&mesh.subcomponent_tags, &|point| points + point);
        sum.trace.append(sum.points.len(), &mesh.trace);
        sum.points.extend_from_slice(&mesh.points);
        sum.corners.extend(mesh.corners.iter().map(|point| points + point));
        sum.loop_ends.extend(mesh.loop_ends.iter().map(|end| corners + end));
        let loops = sum.loop_ends.len() - mesh.loop_ends.len();
        for face in mesh.faces() {
            sum.face_ends.push(loops + mesh.face_loops(face.index()).end);
            let tag = face.tag();
            sum.tags.push(FaceTag {
                group: renumbered(tag.group, &numbers[0]),
                material: renumbered(tag.material, &numbers[1]),
                tags: renumbered(tag.tags, &numbers[2]),
                ..tag
            });
        }
        for &set in &has_sets {
            let list = sum.uvs.list_mut(set);
            list.extend_from_slice(mesh.uvs.get(set));
            list.resize(sum.corners.len(), DVec2::ZERO);
        }
        if has_normals && mesh.normals.is_empty() {
            let normals = mesh.faces().flat_map(|face| std::iter::repeat_n(face.normal(), face.corner_range().len()));
            sum.normals.extend(normals);
        } else {
            sum.normals.extend_from_slice(&mesh.normals);
        }
    }
    (sum.groups, sum.materials, sum.tag_sets) = (groups.0.into(), materials.0.into(), tag_sets.0.into());
    sum.subcomponent_tags = tagger.finish();
    sum.bent = meshes.iter().map(|mesh| mesh.bent).find(|bent| *bent != DVec3::ZERO).unwrap_or_default();
    let is_closed = meshes.iter().all(|mesh| mesh.is_closed());
    if sum.is_empty() { sum } else { sum.known_closed(is_closed) }
}

impl Mesh {
    /// The mesh whose faces have a material over their own.
    pub(crate) fn with_material(&self, material: &Material) -> Mesh {
        let mut materials: Vec<Material> = self.materials.iter().map(|own| material.over(own)).collect();
        let plain = materials.len() as u32;
        materials.push(material.clone());
        let tags = self.tags.mapped(|tag| FaceTag { material: tag.material.min(plain), ..tag });
        Mesh { tags, materials: Arc::from(materials), ..self.clone() }
    }
}
