//! Several meshes as one.

use glam::{DVec2, DVec3};

use super::distinct::Distinct;
use super::materials::Materials;
use super::{FaceTag, Mesh, SubcomponentTagsBuilder, UvSets};
use crate::work;

/// The units of work of a mesh besides its corners.
const MESH: usize = 128;

fn renumbered(index: u32, numbers: &[u32]) -> u32 {
    numbers.get(index as usize).copied().unwrap_or(FaceTag::NONE)
}

/// The faces of all meshes, in order; no points are merged. A mesh without a texture set that another one has gets
/// coordinates 0 there, and a mesh without normals gets the normals of its faces. Bent faces have one direction. Empty if the work of a
/// [`Supervisor`](crate::work::Supervisor) ends meanwhile.
pub fn join<'m>(meshes: impl Iterator<Item = &'m Mesh>) -> Mesh {
    join_all(&meshes.collect::<Vec<_>>())
}

fn join_all(meshes: &[&Mesh]) -> Mesh {
    let (mut groups, mut tag_sets) = (Distinct::default(), Distinct::default());
    let (materials, material_numbers) =
        Materials::joined(&meshes.iter().map(|mesh| &mesh.materials).collect::<Vec<_>>());
    let has_set = |set: usize| meshes.iter().any(|mesh| !mesh.uvs.get(set).is_empty());
    let has_sets: Vec<usize> = (0..UvSets::MOST).filter(|set| has_set(*set)).collect();
    let has_normals = meshes.iter().any(|mesh| !mesh.normals.is_empty());
    let (mut sum, mut tagger) = (Mesh::default(), SubcomponentTagsBuilder::default());
    for (mesh, materials) in meshes.iter().zip(&material_numbers) {
        if !work::spend(MESH + mesh.corners.len()) {
            return Mesh::default();
        }
        let [groups, tag_sets] = [groups.numbers(&mesh.groups), tag_sets.numbers(&mesh.tag_sets)];
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
                group: renumbered(tag.group, &groups),
                material: renumbered(tag.material, materials),
                tags: renumbered(tag.tags, &tag_sets),
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
    (sum.groups, sum.materials, sum.tag_sets) = (groups.into_list().into(), materials, tag_sets.into_list().into());
    sum.subcomponent_tags = tagger.finish();
    sum.bent = meshes.iter().map(|mesh| mesh.bent).find(|bent| *bent != DVec3::ZERO).unwrap_or_default();
    let all_closed = meshes.iter().try_fold(true, |all, mesh| Some(all && mesh.whether_closed()?));
    match all_closed {
        Some(is_closed) if !sum.is_empty() => sum.known_closed(is_closed),
        _ => sum,
    }
}
