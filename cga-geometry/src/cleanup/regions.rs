//! Faces that are joined by removing edges.

use glam::DVec3;

use super::crossing::is_simple;
use super::{add_face, spend, without_faces};
use crate::derive::FaceOrigin;
use crate::mesh::{Mesh, unit};

/// The half-edge of a corner without a counterpart that is removed with it.
pub(super) const KEPT: u32 = u32::MAX;

/// The edges to remove.
pub(super) struct Removal {
    /// For each corner whose edge is removed, the corner that has the edge in the other direction. The two are removed together.
    pub(super) mates: Vec<u32>,
    /// For each face the first face of its region. Edges are removed inside regions.
    pub(super) regions: Vec<u32>,
}

impl Removal {
    /// No edge is removed, and every face is a region.
    pub(super) fn none(mesh: &Mesh) -> Self {
        Removal { mates: vec![KEPT; mesh.corners.len()], regions: (0..mesh.face_count() as u32).collect() }
    }

    /// Removes the edge that starts at two corners.
    pub(super) fn remove(&mut self, one: u32, other: u32) {
        self.mates[one as usize] = other;
        self.mates[other as usize] = one;
    }
}

/// The mesh without these edges. Each region is one face at the place of its first face, with that face's attributes. Loops
/// start with the first edge that is left. A region that does not become one outline with holes stays divided, except that a face
/// may fall apart into several. `None` if nothing changes, or if the work is to end.
pub(super) fn joined(mesh: &Mesh, removal: &Removal) -> Option<Mesh> {
    let mut faces: Vec<Vec<u32>> = vec![Vec::new(); mesh.face_count()];
    spend(mesh.face_count())?;
    for (face, &region) in (0..).zip(&removal.regions) {
        faces[region as usize].push(face);
    }
    let mut found: Vec<Option<Vec<Vec<u32>>>> = vec![None; mesh.face_count()];
    let mut is_seen = vec![false; mesh.corners.len()];
    for (region, faces) in faces.iter().enumerate() {
        spend(faces.iter().map(|&face| mesh.face_corners(face as usize).len()).sum())?;
        let is_cut = |face: &u32| mesh.face_corners(*face as usize).any(|corner| removal.mates[corner] != KEPT);
        if faces.iter().any(is_cut) {
            found[region] = loops(mesh, removal, faces, &mut is_seen).filter(|loops| {
                faces.len() == 1
                    || loops.is_empty()
                    || is_simple(mesh, &points(mesh, loops), unit(loops_area(mesh, loops)))
            });
        }
    }
    if found.iter().all(Option::is_none) {
        return None;
    }
    let mut made = without_faces(mesh);
    for face in 0..mesh.face_count() {
        spend(mesh.face_corners(face).len())?;
        let region = removal.regions[face] as usize;
        match &found[region] {
            None => add_face(&mut made, mesh, face),
            Some(_) if region != face => {}
            Some(loops) => {
                let is_apart = 1 < loops.len()
                    && loops.iter().all(|ring| 0.0 < area_vector(mesh, ring).dot(loops_area(mesh, loops)));
                let origin = FaceOrigin::piece(&mesh.face(face));
                for loops in loops.chunks(if is_apart { 1 } else { loops.len().max(1) }) {
                    made.keep(loops.iter().map(|ring| ring.iter().map(|&corner| corner as usize)), origin);
                }
            }
        }
    }
    Some(made.finish())
}

/// The loops of a region, its outline first. `None` if it does not have one outline.
fn loops(mesh: &Mesh, removal: &Removal, faces: &[u32], is_seen: &mut [bool]) -> Option<Vec<Vec<u32>>> {
    let adjacency = mesh.adjacency();
    let (mut loops, mut areas) = (Vec::new(), Vec::new());
    let mut whole = DVec3::ZERO;
    for &face in faces {
        whole += mesh.face(face as usize).area_vector();
        for start in mesh.face_corners(face as usize).map(|corner| corner as u32) {
            if removal.mates[start as usize] != KEPT || is_seen[start as usize] {
                continue;
            }
            let mut ring = Vec::new();
            let mut corner = start;
            loop {
                is_seen[corner as usize] = true;
                ring.push(corner);
                corner = adjacency.next(corner);
                // Around the end of the edge, past those that are removed. The way leads back to the start, because every
                // corner has one predecessor.
                while removal.mates[corner as usize] != KEPT {
                    corner = adjacency.next(removal.mates[corner as usize]);
                }
                if corner == start {
                    break;
                }
            }
            // A loop of two corners goes along an edge and back.
            if 3 <= ring.len() {
                areas.push(area_vector(mesh, &ring));
                loops.push(ring);
            }
        }
    }
    let outlines: Vec<usize> = (0..loops.len()).filter(|&ring| 0.0 < areas[ring].dot(whole)).collect();
    match outlines[..] {
        [outline] => {
            loops[..=outline].rotate_right(1);
            Some(loops)
        }
        // A region without an area may vanish, or it is one loop.
        [] if loops.len() < 2 => Some(loops),
        // A face whose parts only a slit connected.
        _ if faces.len() == 1 && outlines.len() == loops.len() => Some(loops),
        _ => None,
    }
}

fn points(mesh: &Mesh, loops: &[Vec<u32>]) -> Vec<Vec<u32>> {
    loops.iter().map(|ring| ring.iter().map(|&corner| mesh.corners[corner as usize]).collect()).collect()
}

fn loops_area(mesh: &Mesh, loops: &[Vec<u32>]) -> DVec3 {
    loops.iter().map(|ring| area_vector(mesh, ring)).sum()
}

fn area_vector(mesh: &Mesh, ring: &[u32]) -> DVec3 {
    let at = |corner: u32| mesh.points[mesh.corners[corner as usize] as usize];
    let from = at(ring[0]);
    ring.windows(2).map(|pair| (at(pair[0]) - from).cross(at(pair[1]) - from)).sum()
}
