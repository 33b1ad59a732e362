//! Removes edges between faces in one plane.

use glam::DVec3;

use super::regions::{KEPT, Removal, joined};
use super::slivers::neighbour;
use super::values::{continue_over, have_same_attributes};
use super::{Limits, spend};
use crate::each::Each;
use crate::long_sort::long_sort_by;
use crate::mesh::Mesh;

/// The face of a region that is not found yet.
const UNKNOWN: u32 = u32::MAX;

/// The mesh without edges between faces in one plane. Regions grow from their largest face: all their faces are parallel to it and
/// near its plane, so that a bent surface does not become one face. Edges stay that have tags, or whose faces differ in attributes
/// or texture, and so do those that more than two faces have. `None` if no edge is removed.
pub(super) fn without_flat_edges(mesh: &Mesh, limits: &Limits) -> Option<Mesh> {
    let adjacency = mesh.adjacency_in_time()?;
    let normals = mesh.face_normals_in_time()?;
    let mut open = Removal::none(mesh);
    for corner in 0..mesh.corners.len() as u32 {
        spend(1)?;
        let Some(other) = neighbour(mesh, corner).filter(|&other| corner < other) else { continue };
        let [one, two] = [corner, other].each(|corner| adjacency.face(corner));
        let ends = [corner, other].each(|corner| mesh.corners[corner as usize]);
        let [a, b] = [one, two].each(|face| normals[face as usize]);
        let may_vanish = (a == DVec3::ZERO || b == DVec3::ZERO || limits.are_parallel(a, b))
            && have_same_attributes(mesh, one, two)
            && mesh.edge_tags(ends).is_none()
            && continue_over(mesh, corner, other, limits);
        if may_vanish {
            open.remove(corner, other);
        }
    }
    if open.mates.iter().all(|&mate| mate == KEPT) {
        return None;
    }
    let areas: Vec<f64> = mesh.faces().map(|face| face.area()).collect();
    let mut order: Vec<u32> = (0..mesh.face_count() as u32).collect();
    spend(order.len())?;
    let by_area = |&a: &u32, &b: &u32| areas[b as usize].total_cmp(&areas[a as usize]).then(a.cmp(&b));
    if !long_sort_by(&mut order, by_area) {
        return None;
    }
    let mut growth = Growth { mesh, limits, normals: &normals, open: &open.mates, seeds: vec![UNKNOWN; order.len()] };
    let mut removal = Removal::none(mesh);
    let mut refused = vec![UNKNOWN; order.len()];
    for seed in order {
        if growth.seeds[seed as usize] == UNKNOWN {
            let faces = growth.grow(seed, &mut refused)?;
            let first = faces.iter().copied().min().unwrap_or(seed);
            faces.iter().for_each(|&face| removal.regions[face as usize] = first);
        }
    }
    for (corner, &mate) in (0..).zip(&open.mates) {
        if mate != KEPT {
            let [one, two] = [corner, mate].each(|corner| removal.regions[adjacency.face(corner) as usize]);
            if one == two {
                removal.remove(corner, mate);
            }
        }
    }
    joined(mesh, &removal)
}

struct Growth<'m> {
    mesh: &'m Mesh,
    limits: &'m Limits,
    normals: &'m [DVec3],
    /// For each corner whose edge may be removed, the corner with the edge in the other direction.
    open: &'m [u32],
    /// For each face the one from which its region grew.
    seeds: Vec<u32>,
}

impl Growth<'_> {
    /// Finds the faces of the region around a face. `None` if the work is to end.
    fn grow(&mut self, seed: u32, refused: &mut [u32]) -> Option<Vec<u32>> {
        let mut faces = vec![seed];
        self.seeds[seed as usize] = seed;
        let mut next = 0;
        while let Some(&face) = faces.get(next) {
            next += 1;
            spend(2 * self.mesh.face_corners(face as usize).len())?;
            for corner in self.mesh.face_corners(face as usize) {
                let mate = self.open[corner];
                if mate == KEPT {
                    continue;
                }
                let other = self.mesh.adjacency().face(mate);
                if self.seeds[other as usize] != UNKNOWN || refused[other as usize] == seed {
                    continue;
                }
                if self.fits(other, seed) {
                    self.seeds[other as usize] = seed;
                    faces.push(other);
                } else {
                    refused[other as usize] = seed;
                }
            }
        }
        Some(faces)
    }

    /// Returns true if a face is in the plane of the seed, and if all edges between it and the region can be removed.
    fn fits(&self, face: u32, seed: u32) -> bool {
        let (adjacency, plane) = (self.mesh.adjacency(), self.normals[seed as usize]);
        let normal = self.normals[face as usize];
        if normal != DVec3::ZERO && !self.limits.are_parallel(normal, plane) {
            return false;
        }
        let from = self.mesh.points[self.mesh.corners[self.mesh.face_corners(seed as usize).start] as usize];
        self.mesh.face_corners(face as usize).all(|corner| {
            let at = self.mesh.points[self.mesh.corners[corner] as usize];
            let mut others = adjacency.faces_at(adjacency.edge(corner as u32)).filter(|&other| other != face);
            (at - from).dot(plane).abs() <= self.limits.flat
                && (self.open[corner] != KEPT || others.all(|other| self.seeds[other as usize] != seed))
        })
    }
}
