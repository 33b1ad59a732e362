//! The caps that close the slabs in the cut planes.
//!
//! The sections on both sides of a plane are the same loops in opposite directions, so they are computed once. The cap
//! below a plane faces up, the cap above it faces down. All texture coordinates of a cap
//! are (0, 0), as in files that CityEngine writes.

mod first_face;
pub(crate) mod rim;
pub(crate) mod sheet_search;
pub(crate) mod sheets;

use glam::{DVec2, DVec3};

use super::points::{CutPoints, Location};
use super::state::CutState;
use crate::cut::caps::first_face::Lead;
use crate::mesh::{FaceTag, Mesh};
use crate::nesting::Nest;
use crate::nesting::contour::Contour;
use crate::work;

/// The units of work of an edge: it is found, followed and added to both slabs.
const EDGE: usize = 16;

/// Buffers.
#[derive(Default)]
pub(crate) struct Caps {
    edges: Vec<[u32; 2]>,
    contour: Contour,
    nest: Nest,
    lead: Lead,
}

impl Caps {
    /// Adds the caps of every plane to the slabs on both sides of it. Chains that do not close are passed to `open`,
    /// with their plane, as numbers of points on it.
    pub(crate) fn close(
        &mut self,
        state: &mut CutState,
        mesh: &Mesh,
        mut open: impl FnMut(&CutPoints, usize, Vec<u32>),
    ) {
        let planes = state.points.planes.len();
        if !state.rim.sort(planes) {
            return;
        }
        let mut sought = false;
        for plane in 0..planes {
            state.rim.missing(plane, &mut self.edges);
            if self.edges.is_empty() {
                continue;
            }
            if !work::spend(EDGE * self.edges.len()) {
                return;
            }
            let points = &state.points;
            let flat = &points.levels[plane].flat;
            self.contour.follow(&self.edges, flat, |chain| open(points, plane, chain));
            if self.contour.ends.is_empty() {
                continue;
            }
            self.nest.sort(&self.contour.section(flat));
            if !std::mem::replace(&mut sought, true) {
                self.lead.find(state, mesh);
            }
            let plane = plane as u32;
            let first = self.turn_to_lead(plane);
            for slab in [plane, plane + 1] {
                self.add(state, mesh, plane, slab, first);
            }
        }
    }

    /// Finds the cap of a plane that comes first and rotates it to begin with its required edge. Returns the number of
    /// the cap.
    fn turn_to_lead(&mut self, plane: u32) -> usize {
        for (group, rings) in self.nest.groups().enumerate() {
            for (number, range) in rings.iter().enumerate() {
                let ring = &mut self.contour.corners[range.clone()];
                if let Some(at) = self.lead.edge_in(plane, ring) {
                    // The first edge of a face is an edge of its outline.
                    if number == 0 {
                        ring.rotate_left(at);
                    }
                    return group;
                }
            }
        }
        0
    }

    /// Adds the caps of a plane to one of its slabs, beginning with the cap number `first`.
    fn add(&self, state: &mut CutState, mesh: &Mesh, plane: u32, slab: u32, first: usize) {
        let CutState { parts, points, .. } = state;
        let axis = points.axis;
        let up = slab == plane;
        let part = &mut parts[slab as usize];
        let mut normal = DVec3::ZERO;
        normal[axis] = if up { 1.0 } else { -1.0 };
        if let Some(is_nearer) = self.lead.is_nearer(slab, plane)
            && (is_nearer || part.lead.is_none())
        {
            part.lead = Some(part.mesh.face_count());
        }
        let groups = self.nest.groups();
        for rings in groups.clone().skip(first).take(1).chain(groups.clone().take(first)).chain(groups.skip(first + 1))
        {
            for range in rings {
                let ring = &self.contour.corners[range.clone()];
                for i in 0..ring.len() {
                    // Reversed, with the first edge first: 1 0 n-1 … 2.
                    let corner = ring[if up { i } else { (ring.len() + 1 - i) % ring.len() }];
                    let number = part.number(points, Location::on(plane, corner), slab);
                    part.mesh.corners.push(number);
                    part.mesh.uvs.push(&mesh.uvs, |_| DVec2::ZERO);
                    if !mesh.normals.is_empty() {
                        part.mesh.normals.push(normal);
                    }
                }
                part.mesh.end_loop();
            }
            part.mesh.end_face(FaceTag::CAP);
        }
    }
}
