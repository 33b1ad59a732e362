//! One slab's mesh while it is made.

use std::sync::Arc;

use super::crossing::Crossings;
use crate::mesh::{FaceTag, Mesh, keep_used};

/// Not numbered yet.
pub(super) const NONE: u32 = u32::MAX;

/// Where a point is among the planes, and its number in the slab or slabs it belongs to.
#[derive(Clone, Copy)]
pub(super) struct Place {
    /// 2s strictly inside slab s, 2j + 1 on plane j.
    pub(super) class: u32,
    /// Number in slab `class / 2`.
    pub(super) low: u32,
    /// Number in the slab above, for a point on a plane.
    pub(super) high: u32,
}

impl Place {
    pub(super) fn new(class: u32) -> Self {
        Place { class, low: NONE, high: NONE }
    }
}

/// A corner of a piece: a point of the mesh at one of its corners, or a crossing between two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// Point of the mesh, or number of points + crossing.
    pub(super) point: u32,
    pub(super) class: u32,
    /// The corner, or that at the lexicographically first end of the edge.
    pub(super) from: u32,
    /// The same corner, or that at the other end.
    pub(super) to: u32,
}

/// The mesh of a slab, and how many faces it has from the source as they were.
pub(super) struct Part {
    pub(super) mesh: Mesh,
    pub(super) whole: usize,
    /// Whether a piece was left out because it has no extent: points of it may not be used.
    pub(super) dropped: bool,
}

impl Part {
    /// With room for the share of the faces that its share of the points suggests.
    pub(super) fn new(source: &Mesh, points: usize) -> Self {
        let mut mesh = Mesh {
            groups: source.groups.clone(),
            materials: source.materials.clone(),
            ..Mesh::default()
        };
        let share = |all: usize| {
            let part = all as f64 * points as f64 / source.points.len() as f64;
            (part * 1.02) as usize + 16
        };
        mesh.points.reserve(points + points / 32 + 8);
        mesh.corners.reserve(share(source.corners.len()));
        mesh.loop_ends.reserve(share(source.loop_ends.len()));
        mesh.face_ends.reserve(share(source.face_ends.len()));
        mesh.tags.reserve(share(source.tags.len()));
        if !source.uvs.is_empty() {
            mesh.uvs.reserve(share(source.uvs.len()));
        }
        if !source.normals.is_empty() {
            mesh.normals.reserve(share(source.normals.len()));
        }
        Part { mesh, whole: 0, dropped: false }
    }

    /// The number of a point in this slab, given when first asked for.
    #[inline]
    pub(super) fn number(
        &mut self,
        places: &mut [Place],
        source: &Mesh,
        crossings: &Crossings,
        point: u32,
        slab: u32,
    ) -> u32 {
        let place = &mut places[point as usize];
        let number = if slab == place.class / 2 { &mut place.low } else { &mut place.high };
        if *number == NONE {
            *number = self.mesh.points.len() as u32;
            self.mesh.points.push(crossings.position(source, point));
        }
        *number
    }

    /// Adds a corner of a piece with what it carries.
    #[inline]
    pub(super) fn corner(
        &mut self,
        places: &mut [Place],
        source: &Mesh,
        crossings: &Crossings,
        node: Node,
        slab: u32,
    ) {
        let number = self.number(places, source, crossings, node.point, slab);
        self.mesh.corners.push(number);
        let [a, b] = [node.from as usize, node.to as usize];
        if !source.uvs.is_empty() {
            let uv = source.uvs[a];
            self.mesh.uvs.push(if a == b { uv } else { uv.lerp(source.uvs[b], crossings.share(node.point)) });
        }
        if !source.normals.is_empty() {
            let normal = source.normals[a];
            self.mesh.normals.push(if a == b {
                normal
            } else {
                normal.lerp(source.normals[b], crossings.share(node.point)).normalize_or(normal)
            });
        }
    }

    pub(super) fn end_loop(&mut self) {
        self.mesh.loop_ends.push(self.mesh.corners.len() as u32);
    }

    pub(super) fn end_face(&mut self, tag: FaceTag) {
        self.mesh.face_ends.push(self.mesh.loop_ends.len() as u32);
        self.mesh.tags.push(tag);
    }

    /// The finished mesh; the source itself when all of it is here, nothing when nothing is.
    pub(super) fn finish(mut self, source: &Arc<Mesh>, closed: bool) -> Option<Arc<Mesh>> {
        let faces = self.mesh.face_ends.len();
        if faces == 0 {
            return None;
        }
        if self.whole == source.face_ends.len() && faces == self.whole {
            return Some(source.clone());
        }
        if self.dropped {
            self.mesh.points = keep_used(&self.mesh.points, &mut self.mesh.corners);
        }
        if closed {
            let _ = self.mesh.derived.closed.set(true);
        }
        Some(Arc::new(self.mesh))
    }
}
