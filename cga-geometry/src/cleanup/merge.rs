//! Merges points that are near to each other.

use std::collections::BTreeMap;

use glam::DVec3;

use super::crossing::will_break;
use super::{add_loops, spend, without_faces};
use crate::each::Each;
use crate::mesh::Mesh;

/// The limit on attempts to merge without turning faces over and without crossings. After that only points at one place are merged.
const MOST_ROUNDS: usize = 16;

/// The limit on points of a cell that are compared. Only points that stay can be that dense.
const MOST_IN_CELL: usize = 256;

/// The passes that the search for the target of a point counts for.
const MERGED: usize = 16;

/// The size of cells, in distances, and their least size.
const CELL: f64 = 4.0;
const LEAST_CELL: f64 = 1e-6;

/// Merges each point with the nearest earlier one within a distance, except where a face would turn over or cross itself.
/// Edges and loops that shrink to nothing vanish. `None` if nothing is merged.
pub(super) fn merged(mesh: &Mesh, distance: f64) -> Option<Mesh> {
    merged_into(mesh, |stays| targets(&mesh.points, distance, stays))
}

/// Merges each point into its target, except where a face would turn over or cross itself: `targets` is asked again with the points
/// that have to stay.
pub(super) fn merged_into(mesh: &Mesh, targets: impl Fn(&[bool]) -> Vec<u32>) -> Option<Mesh> {
    let mut stays = vec![false; mesh.points.len()];
    for round in 0..=MOST_ROUNDS {
        if round == MOST_ROUNDS {
            stays.fill(true);
        }
        let targets = targets(&stays);
        if targets.iter().enumerate().all(|(point, &target)| point == target as usize) {
            return None;
        }
        let mut is_done = true;
        for face in mesh.faces() {
            spend(face.corner_count())?;
            if will_break(mesh, face.index(), &targets) {
                for &point in &mesh.corners[face.corner_range()] {
                    let is_moved = targets[point as usize] != point;
                    is_done &= !is_moved;
                    stays[point as usize] |= is_moved;
                }
            }
        }
        if is_done || round == MOST_ROUNDS {
            return with_targets(mesh, &targets);
        }
    }
    None
}

/// For each point the point that it becomes; if the work is to end, the point itself.
fn targets(points: &[DVec3], distance: f64, stays: &[bool]) -> Vec<u32> {
    let size = (distance * CELL).max(LEAST_CELL);
    let cell = |place: DVec3| (place / size).floor();
    let mut cells: BTreeMap<[u64; 3], Vec<u32>> = BTreeMap::new();
    let mut targets = Vec::with_capacity(points.len());
    for (number, &point) in (0..).zip(points) {
        if spend(MERGED).is_none() {
            return (0..points.len() as u32).collect();
        }
        let mut nearest = (f64::INFINITY, number);
        let around = [cell(point - distance), cell(point + distance)];
        let near = corners(around).filter_map(|cell| cells.get(&key(cell)));
        for other in near.flat_map(|points| points.iter().take(MOST_IN_CELL)) {
            let apart = points[*other as usize].distance(point);
            if apart <= distance && (apart, *other) < nearest {
                nearest = (apart, *other);
            }
        }
        // A point that stays may still be the target of others.
        let target = if stays[number as usize] && nearest.0 != 0.0 { number } else { nearest.1 };
        if target == number {
            cells.entry(key(cell(point))).or_default().push(number);
        }
        targets.push(target);
    }
    targets
}

/// The cells at the corners of a box, which is smaller than a cell.
fn corners([low, high]: [DVec3; 2]) -> impl Iterator<Item = DVec3> {
    let along =
        move |axis: usize| [low[axis], high[axis]].into_iter().take(if low[axis] == high[axis] { 1 } else { 2 });
    along(0).flat_map(move |x| along(1).flat_map(move |y| along(2).map(move |z| DVec3::new(x, y, z))))
}

fn key(cell: DVec3) -> [u64; 3] {
    (cell + 0.0).to_array().each(f64::to_bits)
}

/// `None` if the work is to end.
fn with_targets(mesh: &Mesh, targets: &[u32]) -> Option<Mesh> {
    let target = |point: u32| targets[point as usize];
    let keeps_holes = mesh.whether_closed()?;
    let mut made = without_faces(mesh);
    for face in mesh.faces() {
        spend(2 * face.corner_count())?;
        let loops: Vec<Vec<u32>> = face
            .loop_ranges()
            .map(|ring| {
                let mut last = target(mesh.corners[ring.end - 1]);
                let mut is_new = |&corner: &u32| {
                    let point = target(mesh.corners[corner as usize]);
                    point != std::mem::replace(&mut last, point)
                };
                (ring.start as u32..ring.end as u32).filter(|corner| is_new(corner)).collect()
            })
            .collect();
        add_loops(&mut made, mesh, face.index(), &loops, keeps_holes, target);
    }
    // Merged edges and vertices have the tags of all.
    mesh.subcomponent_tags.edges().for_each(|(ends, tags)| made.tag_edge(ends.each(target), tags));
    mesh.subcomponent_tags.vertices().for_each(|(point, tags)| made.tag_vertex(target(point), tags));
    Some(made.finish())
}
