//! Cleaned meshes.
//!
//! Each step takes a mesh and returns one whose corners have points of the original mesh; unused points are dropped at the end.
//! All steps but the removal of small faces keep the sum of all directed edges: an edge vanishes together with its counterpart.
//! So a closed mesh stays closed, and small faces are removed from open parts alone.

mod components;
mod crossing;
mod doubles;
mod flat_edges;
mod merge;
mod regions;
mod short_edges;
mod slits;
mod slivers;
mod small_faces;
mod straight;
mod values;

#[cfg(test)]
mod shape_tests;
#[cfg(test)]
mod tests;

use doubles::FlatParts;
use glam::DVec3;
pub use short_edges::without_short_edges;

use crate::derive::{CornerValues, Derivation, FaceOrigin};
use crate::mesh::Mesh;
use crate::tol::{AT_LIMIT_EPSILON, FLAT_ANGLE_EPSILON, FLAT_EPSILON, MERGE_EPSILON, ROUNDING_EPSILON};
use crate::work;

/// The most rounds after the first one.
const MOST_ROUNDS: usize = 8;

/// The parts of a mesh to clean up. Near points are merged in any case.
#[derive(Clone, Copy, Debug, Default)]
pub struct Parts {
    /// Remove points between edges that form a straight line.
    pub vertices: bool,
    /// Remove edges between faces in one plane.
    pub edges: bool,
    /// Remove doubled and small faces.
    pub faces: bool,
}

/// The limits for a tolerance, in a mesh that is scaled to a size of about 1.
struct Limits {
    /// The distance of points that are merged.
    merge: f64,
    /// The distance of points from a line or a plane.
    flat: f64,
    /// The difference between two unit vectors with the largest angle that counts as straight or flat.
    turn: f64,
    /// The area of faces that are removed.
    area: f64,
}

impl Limits {
    /// The limits of a tolerance from 0 to 1: metres, 10 degrees, and square metres.
    fn of(tolerance: f64, scale: f64) -> Self {
        const MOST_DEGREES: f64 = 10.0;
        /// Larger than the distance of any two points.
        const ALL: f64 = 4.0;
        // Lengths, angles and areas equal to the tolerance are beyond it, wherever the shape is and however that rounds them.
        let below = |limit: f64| limit - AT_LIMIT_EPSILON * limit - 2.0 * ROUNDING_EPSILON;
        let distance = below(tolerance * scale).min(ALL);
        let angle = below((tolerance * MOST_DEGREES).to_radians()).max(FLAT_ANGLE_EPSILON);
        Limits {
            merge: distance.max(MERGE_EPSILON),
            flat: distance.max(FLAT_EPSILON),
            turn: 2.0 * libm::sin(angle * 0.5),
            area: below(tolerance * scale * scale).max(FLAT_EPSILON * FLAT_EPSILON),
        }
    }

    /// Returns true if two unit vectors have about the same direction.
    fn are_parallel(&self, a: DVec3, b: DVec3) -> bool {
        (a - b).length() <= self.turn
    }
}

/// Cleans up a mesh: merges near points, and removes the parts that `parts` lists. `None` if nothing changes. The result may be
/// empty.
///
/// The tolerance is from 0 to 1. It counts as a length in metres, as an angle in units of 10 degrees, and as an area in square
/// metres. A tolerance that is NaN counts as 0. Also `None` if the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile.
///
/// ```
/// use cga_geometry::cleanup::{Parts, cleanup};
/// use cga_geometry::mesh::MeshBuilder;
///
/// // A square with sides of 2, in two triangles: their common edge goes.
/// let mut builder = MeshBuilder::new();
/// let [a, b, c, d] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|[x, y]| builder.point([x, y, 0.0]));
/// builder.polygon(&[a, b, c]).polygon(&[a, c, d]);
/// let mesh = builder.build()?;
/// let cleaned = cleanup(&mesh, Parts { edges: true, ..Parts::default() }, 0.0).unwrap();
/// assert_eq!((cleaned.face_count(), cleaned.area()), (1, 4.0));
/// # Ok::<(), cga_geometry::mesh::MeshError>(())
/// ```
pub fn cleanup(mesh: &Mesh, parts: Parts, tolerance: f64) -> Option<Mesh> {
    if mesh.is_empty() {
        return None;
    }
    let tolerance = if tolerance.is_nan() { 0.0 } else { tolerance };
    let bounds = mesh.bounds();
    let scale = bounds.scale_to_one();
    let limits = Limits::of(tolerance, scale);
    let from = bounds.low * scale;
    let scaled = mesh.with_points(mesh.points().iter().map(|&p| p * scale - from).collect());
    let mut draft = Draft { kept: slits::tagged_slits(&scaled), mesh: scaled, steps: 0 };
    draft.round(parts, &limits, FlatParts::Open);
    // Joined faces may be opposite to others, and joined edges may go along an edge and back. Only rounding counts from here
    // on, so that tolerances do not add up. A closed part that the tolerance made flat stays closed.
    let exact = Limits::of(0.0, scale);
    let flat = if exact.merge < limits.merge { FlatParts::StayClosed } else { FlatParts::Open };
    for _ in 0..MOST_ROUNDS {
        let steps = draft.steps;
        draft.round(parts, &exact, flat);
        if draft.steps == steps {
            break;
        }
    }
    if draft.steps == 0 {
        return None;
    }
    let made = without_unused_points(draft.mesh, mesh);
    work::spend(0).then_some(made)
}

/// A mesh whose corners have points of the original mesh, with those points alone; empty if the work is to end.
fn without_unused_points(made: Mesh, original: &Mesh) -> Mesh {
    let full = Mesh { points: original.points.clone(), trace: original.trace.clone(), ..made };
    let mut made = Derivation::new(&full, CornerValues::All, full.corners.len()).with_old_points();
    for face in full.faces() {
        if !work::spend(CORNER * face.corner_count()) {
            break;
        }
        made.keep(face.loop_ranges(), FaceOrigin::piece(&face));
    }
    made.finish_used()
}

/// The units of work of a corner in a step.
const CORNER: usize = 8;

/// A mesh between two steps. If work is to end, steps change nothing.
struct Draft {
    mesh: Mesh,
    /// The edges with tags that one face had in both directions from the start. Such edges that merged points make go.
    kept: Vec<[u32; 2]>,
    /// The number of steps that changed the mesh.
    steps: u32,
}

impl Draft {
    /// All steps once. `flat` is the outcome for parts that are flat before points within the tolerance are merged.
    fn round(&mut self, parts: Parts, limits: &Limits, flat: FlatParts) {
        self.merge(MERGE_EPSILON, parts.faces.then_some(flat));
        if MERGE_EPSILON < limits.merge {
            self.merge(limits.merge, parts.faces.then_some(FlatParts::StayClosed));
        }
        if parts.faces {
            self.step(|mesh| slivers::without_slivers(mesh, limits));
        }
        if parts.edges {
            self.step(|mesh| flat_edges::without_flat_edges(mesh, limits));
        }
        if parts.vertices {
            self.step(|mesh| straight::without_straight_points(mesh, limits));
        }
        if parts.faces {
            self.step(|mesh| small_faces::without_small_faces(mesh, limits));
        }
    }

    fn step(&mut self, step: impl FnOnce(&Mesh) -> Option<Mesh>) {
        if !work::spend(CORNER * self.mesh.corners.len()) {
            return;
        }
        if let Some(made) = step(&self.mesh) {
            self.mesh = made;
            self.steps += 1;
        }
    }

    /// Merges points, and removes doubled faces on request.
    fn merge(&mut self, distance: f64, doubles: Option<FlatParts>) {
        self.step(|mesh| merge::merged(mesh, distance));
        let kept = std::mem::take(&mut self.kept);
        self.step(|mesh| slits::without_slits(mesh, &kept));
        self.kept = kept;
        if let Some(flat) = doubles {
            self.step(|mesh| doubles::without_doubles(mesh, flat));
        }
    }
}

/// Counts the work of a pass over a corner or a point. `None` if the work is to end.
fn spend(count: usize) -> Option<()> {
    work::spend(CORNER * count).then_some(())
}

/// A mesh without faces that has the points of a mesh.
fn without_faces(mesh: &Mesh) -> Derivation<'_> {
    Derivation::new(mesh, CornerValues::All, mesh.corners().len()).with_old_points()
}

/// Adds a face of a mesh as it is.
fn add_face(made: &mut Derivation<'_>, mesh: &Mesh, face: usize) {
    let face = mesh.face(face);
    made.keep(face.loop_ranges(), FaceOrigin::piece(&face));
}

/// Adds a face with some corners of a mesh as its loops, at the points that `target` gives for theirs. Loops with fewer than three
/// corners are left out: they go along an edge and back. If that leaves out the outline, the holes are kept only on request.
fn add_loops(
    made: &mut Derivation<'_>,
    mesh: &Mesh,
    face: usize,
    loops: &[Vec<u32>],
    keeps_holes: bool,
    target: impl Fn(u32) -> u32,
) {
    let is_kept = loops.first().is_some_and(|outline| 3 <= outline.len()) || keeps_holes;
    let mut kept = loops.iter().filter(|ring| is_kept && 3 <= ring.len()).peekable();
    if kept.peek().is_some() {
        let at = |corner: u32| (target(mesh.corners()[corner as usize]), corner as usize);
        made.keep_at(kept.map(|ring| ring.iter().map(|&corner| at(corner))), FaceOrigin::piece(&mesh.face(face)));
    }
}
