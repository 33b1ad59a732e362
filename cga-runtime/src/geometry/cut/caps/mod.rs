//! Caps: what closes the slabs in the cut planes.
//!
//! The sections of both sides of a plane are the same loops the other way round, so they are found once. Below a plane the
//! cap looks up, above it looks down. A cap's texture coordinates are metres in its plane, upright where it stands.

mod first_face;
pub(crate) mod rim;
pub(crate) mod sheet_search;
pub(crate) mod sheets;

use glam::{DVec2, DVec3};

use super::points::{Place, Points};
use super::state::State;
use crate::geometry::cut::caps::first_face::{Lead, Wish};
use crate::geometry::mesh::{FaceTag, Mesh};
use crate::geometry::nesting::Nest;
use crate::geometry::nesting::contour::Contour;

/// Buffers, and where caps take their texture coordinates from.
pub(crate) struct Caps {
    low: DVec3,
    stretch: DVec3,
    edges: Vec<[u32; 2]>,
    contour: Contour,
    nest: Nest,
    lead: Lead,
}

impl Default for Caps {
    fn default() -> Self {
        let (edges, contour, nest, lead) = Default::default();
        Caps { low: DVec3::ZERO, stretch: DVec3::ONE, edges, contour, nest, lead }
    }
}

impl Caps {
    /// From now on coordinates of caps begin at a point of the mesh, whose lengths are stretched to metres.
    pub(crate) fn in_metres(&mut self, low: DVec3, stretch: DVec3) {
        (self.low, self.stretch) = (low, stretch);
    }

    /// Adds the caps of every plane to the slabs on both sides of it. Edges that do not close are handed to `open`, with their
    /// plane, as numbers of points on it.
    pub(crate) fn close(&mut self, state: &mut State, mesh: &Mesh, mut open: impl FnMut(&Points, usize, Vec<u32>)) {
        let planes = state.points.planes.len();
        state.rim.sort(planes);
        let mut sought = false;
        for plane in 0..planes {
            state.rim.missing(plane, &mut self.edges);
            if self.edges.is_empty() {
                continue;
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
            self.add(state, mesh, plane, plane, first);
            self.add(state, mesh, plane, plane + 1, first);
        }
    }

    /// The cap of a plane that comes first, turned to begin with the edge that it should begin with.
    fn turn_to_lead(&mut self, plane: u32) -> usize {
        let mut start = 0;
        for (group, &end) in self.nest.ends.iter().enumerate() {
            for (number, range) in self.nest.order[start..end].iter().enumerate() {
                let ring = &mut self.contour.corners[range.clone()];
                if let Some(at) = self.lead.edge_in(plane, ring) {
                    // The first edge of a face is one of its outline.
                    if number == 0 {
                        ring.rotate_left(at);
                    }
                    return group;
                }
            }
            start = end;
        }
        0
    }

    /// Adds the caps of a plane to one of its slabs, that with number `first` as the first one.
    fn add(&self, state: &mut State, mesh: &Mesh, plane: u32, slab: u32, first: usize) {
        let State { parts, points, .. } = state;
        let axis = points.axis;
        let up = slab == plane;
        let part = &mut parts[slab as usize];
        let mut normal = DVec3::ZERO;
        normal[axis] = if up { 1.0 } else { -1.0 };
        let (right, upwards) = texture_axes(normal);
        match self.lead.wants(slab, plane) {
            Some(Wish::First) => part.lead = Some(part.mesh.face_ends.len()),
            Some(Wish::Second) => part.lead = part.lead.or(Some(part.mesh.face_ends.len())),
            None => {}
        }
        let groups = self.nest.ends.len();
        for group in std::iter::once(first).chain((0..groups).filter(|&group| group != first)) {
            let start = if group == 0 { 0 } else { self.nest.ends[group - 1] };
            for range in &self.nest.order[start..self.nest.ends[group]] {
                let ring = &self.contour.corners[range.clone()];
                for i in 0..ring.len() {
                    // Turned over with the first edge first: 1 0 n-1 … 2.
                    let corner = ring[if up { i } else { (ring.len() + 1 - i) % ring.len() }];
                    let number = part.number(points, Place::on(plane, corner), slab);
                    part.mesh.corners.push(number);
                    let point = part.mesh.points[number as usize];
                    let metres = (point - self.low) * self.stretch;
                    part.mesh.uvs.push_from(&mesh.uvs, |_| DVec2::new(right.dot(metres), upwards.dot(metres)));
                    if !mesh.normals.is_empty() {
                        part.mesh.normals.push(normal);
                    }
                }
                part.end_loop();
            }
            part.end_face(FaceTag::CAP);
        }
    }
}

/// Along which the texture of a cap runs, in metres and not mirrored when seen from outside: upright, or as a floor's where
/// the cap lies flat.
pub(crate) fn texture_axes(normal: DVec3) -> (DVec3, DVec3) {
    const FLAT: f64 = 1e-9;
    let level = DVec3::Y.cross(normal);
    let right = if level.length() <= FLAT { DVec3::X } else { level.normalize() };
    (right, normal.cross(right))
}
