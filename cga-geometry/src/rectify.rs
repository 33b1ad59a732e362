//! Edges that follow two axes.

use crate::each::Each;
use glam::DVec3;

use super::cleanup::{Parts, cleanup};
use super::derive::{CornerValues, Derivation, FaceOrigin};
use super::disjoint::DisjointSets;
use super::mesh::{Mesh, unit};
use super::tol::{COPLANAR_EPSILON, EDGE_EPSILON, UP_EPSILON};
use super::work;

/// The order in which axes are compared. Of equal ones the first counts.
const AXES: [usize; 3] = [1, 2, 0];

/// The units of work of a corner in a pass.
const CORNER: usize = 8;

/// A face that would vanish or turn over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Collapsed {
    /// The number of the face.
    pub face: usize,
}

/// The mesh with edges parallel to the axes: those that deviate by less than `limit` degrees, as seen along the axis across most of the
/// faces. Such an edge turns about its middle; edges in one line get the average of their middles, weighted by lengths. Points at the
/// ends of upright edges move alike. Points move along their faces if these are in one plane, else across the axis of the view.
/// Holes that vanish are removed. `None` if no point moves, as with a limit that is NaN or not positive, or if the work of a
/// [`Supervisor`](crate::work::Supervisor) ends meanwhile.
///
/// # Errors
/// The first face that would vanish or turn over.
pub fn rectify(mesh: &Mesh, limit: f64) -> Result<Option<Mesh>, Collapsed> {
    let scale = mesh.bounds().scale_to_one();
    let low = mesh.bounds().low * scale;
    let points: Vec<DVec3> = mesh.points.iter().map(|&point| point * scale - low).collect();
    let Some(normals) = mesh.face_normals_in_time() else { return Ok(None) };
    let areas: DVec3 = mesh.faces().map(|face| normals[face.index()].abs() * (face.area() * scale * scale)).sum();
    if mesh.adjacency_in_time().is_none() {
        return Ok(None);
    }
    let up = AXES.into_iter().rev().max_by(|&a, &b| areas[a].total_cmp(&areas[b])).unwrap_or(1);
    let along = [(up + 1) % 3, (up + 2) % 3];
    let mut moved = points.clone();
    for [axis, across] in [along, [along[1], along[0]]] {
        align(mesh, &points, &mut moved, axis, across, limit);
    }
    if moved == points {
        return Ok(None);
    }
    for point in 0..points.len() {
        if !work::spend(CORNER) {
            return Ok(None);
        }
        let mut faces = mesh.adjacency().faces_around(point).map(|face| normals[face as usize]);
        let Some(plane) = faces.next() else { continue };
        let is_flat = faces.all(|other| (other - plane).length() <= COPLANAR_EPSILON);
        if is_flat && UP_EPSILON < plane[up].abs() {
            moved[point][up] -= (moved[point] - points[point]).dot(plane) / plane[up];
        }
    }
    // The work may have ended before all points moved.
    if !work::spend(CORNER * mesh.corners.len()) {
        return Ok(None);
    }
    let rectified = Mesh { points: moved, ..mesh.with_points(points) };
    let lost = lost_crossing(mesh, &rectified, &normals);
    if !work::spend(0) {
        return Ok(None);
    }
    if let Some(face) = lost {
        return Err(Collapsed { face });
    }
    let rectified = without_lost_holes(mesh, rectified, &normals, up)?;
    let cleaned = cleanup(&rectified, Parts::default(), 0.0).unwrap_or(rectified);
    if !work::spend(0) {
        return Ok(None);
    }
    if cleaned.is_empty() {
        return Err(Collapsed { face: 0 });
    }
    let places = cleaned.points.iter().map(|&point| (point + low) / scale).collect();
    Ok(Some(cleaned.with_points(places)))
}

/// Moves points across an axis so that edges which nearly follow the axis are parallel to it.
fn align(mesh: &Mesh, points: &[DVec3], moved: &mut [DVec3], axis: usize, across: usize, limit: f64) {
    let adjacency = mesh.adjacency();
    let mut lines = DisjointSets::new(points.len());
    let mut aligned = Vec::new();
    for edge in 0..adjacency.edge_count() {
        if !work::spend(CORNER) {
            return;
        }
        let from = adjacency.uses(edge)[0];
        let [a, b] = [from, adjacency.next(from)].each(|corner| mesh.corners[corner as usize]);
        let step = points[b as usize] - points[a as usize];
        let [ahead, aside] = [step[axis].abs(), step[across].abs()];
        let is_upright = ahead.max(aside) <= EDGE_EPSILON;
        if is_upright || libm::atan2(aside, ahead).to_degrees() < limit {
            lines.unite(a, b);
        }
        if !is_upright && libm::atan2(aside, ahead).to_degrees() < limit {
            aligned.push((a, 0.5 * (points[a as usize][across] + points[b as usize][across]), ahead));
        }
    }
    lines.flatten();
    let mut sums = vec![(0.0, 0.0); points.len()];
    for (point, middle, length) in aligned {
        let sum = &mut sums[lines.find(point) as usize];
        *sum = (sum.0 + middle * length, sum.1 + length);
    }
    for (number, point) in (0..).zip(moved) {
        let (sum, length) = sums[lines.find(number) as usize];
        if 0.0 < length {
            point[across] = sum / length;
        }
    }
}

/// The first face that crosses itself, so that its parts cancel and it has no direction, and whose corners are on a line now. Any
/// face if the work is to end.
fn lost_crossing(before: &Mesh, moved: &Mesh, normals: &[DVec3]) -> Option<usize> {
    let is_flat = |points: &[DVec3], corners: &[u32]| {
        let at = |corner: &u32| points[*corner as usize];
        let from = at(&corners[0]);
        let far = |from: DVec3| {
            let farther =
                |best: DVec3, next: DVec3| if from.distance(best) < from.distance(next) { next } else { best };
            corners.iter().map(at).fold(from, farther)
        };
        let start = far(from);
        let along = unit(far(start) - start);
        corners.iter().all(|corner| (at(corner) - start).cross(along).length() <= COPLANAR_EPSILON)
    };
    let scale = before.bounds().scale_to_one();
    let places: Vec<DVec3> = before.points.iter().map(|&point| point * scale).collect();
    let is_lost = |face: &usize| {
        let corners = &before.corners[before.face_corners(*face)];
        if !work::spend(corners.len()) {
            return true;
        }
        normals[*face] == DVec3::ZERO && !is_flat(&places, corners) && is_flat(&moved.points, corners)
    };
    (0..before.face_count()).find(is_lost)
}

/// The mesh without holes that have vanished or turned over; empty if the work is to end.
fn without_lost_holes(before: &Mesh, moved: Mesh, normals: &[DVec3], up: usize) -> Result<Mesh, Collapsed> {
    let area = |mesh: &Mesh, ring: std::ops::Range<usize>| -> f64 {
        let at = |corner: usize| mesh.points[mesh.corners[corner] as usize];
        let from = at(ring.start);
        let (axis, other) = ((up + 1) % 3, (up + 2) % 3);
        ring.clone()
            .skip(1)
            .zip(ring.skip(2))
            .map(|(a, b)| [at(a) - from, at(b) - from])
            .map(|[a, b]| a[axis] * b[other] - a[other] * b[axis])
            .sum()
    };
    let moved = Mesh { trace: before.trace.clone(), ..moved };
    let mut made = Derivation::new(&moved, CornerValues::All, moved.corners.len()).with_old_points();
    for face in before.faces() {
        if !work::spend(CORNER * face.corner_count()) {
            return Ok(Mesh::default());
        }
        // Upright faces have no area as seen from above.
        let is_upright = normals[face.index()][up].abs() <= UP_EPSILON;
        let mut kept = Vec::with_capacity(1);
        for (number, ring) in face.loop_ranges().enumerate() {
            let sign = area(before, ring.clone()).signum();
            // The rounding error of an area in a mesh with an extent of about 1.
            let is_lost = !is_upright && area(&moved, ring.clone()) * sign <= COPLANAR_EPSILON * COPLANAR_EPSILON;
            if is_lost && number == 0 {
                return Err(Collapsed { face: face.index() });
            }
            if !is_lost {
                kept.push(ring);
            }
        }
        made.keep(kept, FaceOrigin::piece(&face));
    }
    Ok(made.finish_used())
}

#[cfg(test)]
mod tests;
