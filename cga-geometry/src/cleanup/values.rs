//! Comparison of the attributes of faces and of the values at their corners.

use glam::DVec3;

use super::Limits;
use crate::each::Each;
use crate::mesh::{FaceTag, Mesh, are_uvs_near};
use crate::tol::{FLAT_ANGLE_EPSILON, TEXTURE_EPSILON};

/// The limit on corners of a face that are searched for the one that tells how the texture continues.
const MOST_CORNERS: usize = 8;

/// Returns true if two faces have equal attributes.
pub(super) fn have_same_attributes(mesh: &Mesh, one: u32, other: u32) -> bool {
    let [a, b] = [one, other].each(|face| mesh.tags[face as usize]);
    let group = |tag: FaceTag| mesh.groups.get(tag.group as usize);
    let names = |tag: FaceTag| mesh.tag_sets.get(tag.tags as usize).map_or(&[][..], |set| set.names());
    a.cap == b.cap
        && (a.tags == b.tags || names(a) == names(b))
        && (a.group == b.group || group(a) == group(b))
        && mesh.materials.are_equal(a.material, b.material)
}

fn position(mesh: &Mesh, corner: u32) -> DVec3 {
    mesh.points[mesh.corners[corner as usize] as usize]
}

/// Returns true if texture and normals continue over an edge that two corners have in opposite directions.
pub(super) fn continue_over(mesh: &Mesh, one: u32, other: u32, limits: &Limits) -> bool {
    let adjacency = mesh.adjacency();
    let [ends, met] = [[one, adjacency.next(one)], [adjacency.next(other), other]];
    let normals_continue = mesh.normals.is_empty()
        || ends.iter().zip(met).all(|(&a, b)| limits.are_parallel(mesh.normals[a as usize], mesh.normals[b as usize]));
    normals_continue
        && ends.iter().zip(met).all(|(&a, b)| mesh.has_same_texture(a, b))
        && (mesh.uvs.is_empty() || gradients_continue(mesh, one, other, limits))
}

/// Returns true if the texture grows on both sides of an edge as quickly.
fn gradients_continue(mesh: &Mesh, one: u32, other: u32, limits: &Limits) -> bool {
    let [near, far] = [one, mesh.adjacency().next(one)];
    let (from, to) = (position(mesh, near), position(mesh, far));
    let length = from.distance(to);
    let along = (to - from) / length;
    // The corner of a face that is farthest from the line of the edge, its place along the edge, and its distance.
    let reach = |corner: u32| {
        let face = mesh.face_corners(mesh.adjacency().face(corner) as usize);
        let step = face.len().div_ceil(MOST_CORNERS);
        let place = |corner: usize| {
            let at = mesh.points[mesh.corners[corner] as usize] - from;
            (at.cross(along).length(), at.dot(along) / length, corner)
        };
        face.step_by(step)
            .map(place)
            .fold((0.0, 0.0, near as usize), |best, next| if best.0 < next.0 { next } else { best })
    };
    let [a, b] = [one, other].each(reach);
    if a.0.min(b.0) <= limits.flat {
        return true;
    }
    mesh.uv_numbers().all(|set| {
        let uvs = mesh.uv_set(set);
        let growth = |(distance, share, corner): (f64, f64, usize)| {
            (uvs[corner] - uvs[near as usize].lerp(uvs[far as usize], share)) / distance
        };
        let [ahead, back] = [growth(a), -growth(b)];
        let size = ahead.abs().max(back.abs()).max_element();
        let range = TEXTURE_EPSILON * uvs[a.2].abs().max(uvs[b.2].abs()).max_element().max(1.0);
        (ahead - back).abs().max_element() <= (FLAT_ANGLE_EPSILON + limits.turn) * size + range / a.0.min(b.0)
    })
}

/// Returns true if the values at a corner are those between its neighbours in the loop, so that the corner can be left out.
pub(super) fn are_between(mesh: &Mesh, corner: u32, limits: &Limits) -> bool {
    let adjacency = mesh.adjacency();
    let [before, after] = [adjacency.before(corner), adjacency.next(corner)];
    let [from, at, to] = [before, corner, after].each(|corner| position(mesh, corner));
    let share = from.distance(at) / (from.distance(at) + at.distance(to));
    let bend = FLAT_ANGLE_EPSILON + limits.turn * limits.turn;
    let texture = mesh.uv_numbers().all(|set| {
        let [from, at, to] = [before, corner, after].each(|corner| mesh.uv_set(set)[corner as usize]);
        are_uvs_near(from.lerp(to, share), at, bend * from.distance(to))
    });
    let normal = |corner: u32| mesh.normals[corner as usize];
    texture
        && (mesh.normals.is_empty()
            || limits.are_parallel(crate::mesh::unit(normal(before).lerp(normal(after), share)), normal(corner)))
}
