//! Meshes with fewer vertices.
//!
//! Faces are divided into triangles, and edges collapse one after the other, the one with the least quadric error first (Garland and
//! Heckbert). A vertex becomes one of its neighbours, so no point is new, and the values of corners come from the mesh. A
//! collapse removes an edge together with its counterpart, so a closed mesh stays closed. Faces without a change stay polygons.

mod quadric;
mod surface;

#[cfg(test)]
mod tests;

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::derive::{CornerValues, Derivation, FaceOrigin};
use crate::each::Each;
use crate::mesh::Mesh;
use crate::work;
use surface::Surface;

/// The units of work of a search for the best neighbour.
const SEARCH: usize = 256;

/// The units of work of a corner or a triangle in a pass over the whole mesh.
const PASS: usize = 32;

/// A vertex that can become one of its neighbours.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    cost: f64,
    vertex: u32,
    /// The number of the last search for the vertex. Older candidates do not count.
    search: u32,
}

impl Ord for Candidate {
    /// The largest candidate has the least cost.
    fn cmp(&self, other: &Self) -> Ordering {
        other.cost.total_cmp(&self.cost).then_with(|| other.vertex.cmp(&self.vertex))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Candidate {}

/// The mesh without tags and without a share of its vertices, from 0 to 1: fewer vertices go if no further edge can collapse.
///
/// `None` if no vertex goes, if the share is NaN, or if the work is to end ([`crate::work`]).
///
/// ```
/// use cga_geometry::{primitive, reduce};
///
/// // A ball of 12 rings with 24 vertices each, and two poles.
/// let ball = primitive::sphere(24, 13);
/// let coarse = reduce::reduce(&ball, 0.5).unwrap();
/// assert_eq!((ball.points().len(), coarse.points().len()), (290, 145));
/// assert!(coarse.is_closed() && 0.9 * ball.volume() < coarse.volume());
/// ```
pub fn reduce(mesh: &Mesh, share: f64) -> Option<Mesh> {
    if share.is_nan() {
        return None;
    }
    // Counts such as 0.1 * 10 are rounded.
    const ROUNDING: f64 = 1e-9;
    let count = mesh.points.len();
    let wanted = (count as f64 * (1.0 - share) + ROUNDING).floor() as usize;
    let mut surplus = count.saturating_sub(wanted);
    if surplus == 0 {
        return None;
    }
    let mut surface = Surface::of(mesh)?;
    let mut newest = vec![0u32; count];
    let mut heap = BinaryHeap::with_capacity(count);
    let push = |heap: &mut BinaryHeap<Candidate>, newest: &mut [u32], vertex: u32, best: Option<(f64, u32)>| {
        let search = newest[vertex as usize] + 1;
        newest[vertex as usize] = search;
        if let Some((cost, _)) = best {
            heap.push(Candidate { cost, vertex, search });
        }
    };
    for vertex in 0..count as u32 {
        if !work::spend(SEARCH) {
            return None;
        }
        push(&mut heap, &mut newest, vertex, surface.best_target(vertex));
    }
    let mut is_changed = false;
    while let Some(Candidate { cost, vertex, search }) = heap.pop() {
        if !work::spend(SEARCH) {
            return None;
        }
        if search != newest[vertex as usize] {
            continue;
        }
        // Quadrics of neighbours may have grown since the search, and other edges may be in the way.
        let best = surface.best_target(vertex);
        let Some((now, target)) = best else { continue };
        if cost < now {
            push(&mut heap, &mut newest, vertex, best);
            continue;
        }
        let around = surface.neighbours(vertex);
        surface.collapse(vertex, target);
        is_changed = true;
        surplus -= 1;
        if surplus == 0 {
            break;
        }
        for other in around {
            push(&mut heap, &mut newest, other, surface.best_target(other));
        }
    }
    if is_changed { assembled(mesh, &surface) } else { None }
}

/// The faces that are left; `None` if the work is to end.
fn assembled(mesh: &Mesh, surface: &Surface<'_>) -> Option<Mesh> {
    let untagged = Mesh { tag_sets: Default::default(), subcomponent_tags: Default::default(), ..Mesh::clone(mesh) };
    let mut made = Derivation::new(&untagged, CornerValues::All, mesh.corners().len()).with_old_points();
    for face in untagged.faces() {
        if !work::spend(PASS * face.corner_count()) {
            return None;
        }
        let origin = FaceOrigin::piece(&face);
        if !surface.is_changed(face.index()) {
            made.keep(face.loop_ranges(), origin);
            continue;
        }
        for (points, corners) in surface.triangles_of(face.index()) {
            made.keep_at([points.into_iter().zip(corners.each(|corner| corner as usize))], origin);
        }
    }
    let made = made.finish_used();
    work::spend(0).then_some(made)
}
