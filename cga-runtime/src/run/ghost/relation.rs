//! The relation of a mesh to closed meshes, for boxes along the axes of the world.
//!
//! Meshes count as the boxes around them, so the answers are right for boxes and rectangles along the world's axes alone.

use std::sync::Arc;

use crate::geometry::mesh::{Bounds, Mesh};

/// The relation of a mesh to the closed meshes of a set: each answer is for at least one of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Relation {
    pub(crate) inside: bool,
    pub(crate) overlaps: bool,
    pub(crate) touches: bool,
}

impl Relation {
    /// The answers of both.
    pub(crate) fn or(self, other: Relation) -> Relation {
        Relation {
            inside: self.inside | other.inside,
            overlaps: self.overlaps | other.overlaps,
            touches: self.touches | other.touches,
        }
    }
}

/// Closed meshes.
#[derive(Debug)]
pub(crate) struct Occluders {
    boxes: Vec<Bounds>,
}

/// Lengths below this count as contact, in metres.
const TOLERANCE: f64 = 1e-3;

impl Occluders {
    pub(crate) fn new(meshes: Vec<Arc<Mesh>>) -> Self {
        Occluders { boxes: meshes.iter().map(|mesh| mesh.bounds()).collect() }
    }

    /// The relation of a mesh to the closed meshes whose numbers are accepted.
    pub(crate) fn query(&self, query: &Mesh, accept: &mut dyn FnMut(u32) -> bool) -> Relation {
        let bounds = query.bounds();
        let near = self.boxes.iter().zip(0..).map(|(solid, number)| (relation(&bounds, solid), number));
        let near = near.filter(|(relation, number)| *relation != Relation::default() && accept(*number));
        near.fold(Relation::default(), |all, (relation, _)| all.or(relation))
    }
}

fn relation(query: &Bounds, solid: &Bounds) -> Relation {
    let shared = query.high.min(solid.high) - query.low.max(solid.low);
    if shared.min_element() < -TOLERANCE {
        return Relation::default();
    }
    let is_thin = |size: f64| size <= TOLERANCE;
    let size = query.high - query.low;
    // Along thin axes of the query, the overlap is a point in the solid or on its surface.
    let is_within =
        |axis: usize| solid.low[axis] + TOLERANCE < query.low[axis] && query.high[axis] < solid.high[axis] - TOLERANCE;
    let overlaps = (0..3).all(|axis| if is_thin(size[axis]) { is_within(axis) } else { !is_thin(shared[axis]) });
    let thin = (0..3).filter(|axis| is_thin(shared[*axis])).count();
    let inside =
        (query.low - solid.low).min_element() >= -TOLERANCE && (solid.high - query.high).min_element() >= -TOLERANCE;
    // Contact along an area.
    let touches = overlaps
        || inside
        || thin == 1 && (0..3).all(|axis| !is_thin(size[axis]) || is_thin(shared[axis]) && !is_within(axis));
    Relation { inside, overlaps, touches }
}
