//! Removes small faces.

use super::components::{components, is_closed};
use super::{Limits, add_face, spend, without_faces};
use crate::mesh::{FaceRef, Mesh};

/// The mesh without faces whose area is below the limit. A closed part is removed as a whole, if all of it is that small; else it
/// stays. `None` if no face is removed.
pub(super) fn without_small_faces(mesh: &Mesh, limits: &Limits) -> Option<Mesh> {
    let area = |face: FaceRef<'_>| {
        spend(face.corner_count())?;
        Some(face.area())
    };
    let areas: Vec<f64> = mesh.faces().map(area).collect::<Option<_>>()?;
    if areas.iter().all(|&area| limits.area < area) {
        return None;
    }
    let mut made = without_faces(mesh);
    let mut is_kept: Vec<bool> = areas.iter().map(|&area| limits.area < area).collect();
    for part in components(mesh).sets() {
        let area: f64 = part.iter().map(|&face| areas[face as usize]).sum();
        if limits.area < area && is_closed(mesh, &part, &[]) {
            part.iter().for_each(|&face| is_kept[face as usize] = true);
        }
    }
    if is_kept.iter().all(|&kept| kept) {
        return None;
    }
    for face in (0..mesh.face_count()).filter(|&face| is_kept[face]) {
        spend(mesh.face_corners(face).len())?;
        add_face(&mut made, mesh, face);
    }
    Some(made.finish())
}
