//! Meshes with more points in their edges.

use std::collections::HashMap;

use glam::{DAffine3, DVec3};

use super::edge_points::EdgePoints;
use crate::fixed_hash::FixedState;
use crate::geometry::derive::{CornerValues, Derivation, FaceOrigin};
use crate::geometry::each::Each;
use crate::geometry::mesh::Mesh;
use crate::geometry::origin::PointOrigin;
use crate::geometry::triangulate::Triangulator;

/// The mesh with all points inside of its edges as corners, and faces with such points as triangles. `placement` maps it to the world,
/// where the points are.
pub(super) fn subdivided(mesh: &Mesh, placement: &DAffine3, edges: &EdgePoints) -> Mesh {
    let divided = with_points(mesh, placement, edges);
    let mut made = Derivation::new(&divided, CornerValues::All, 2 * divided.corners().len()).with_old_points();
    let (mut triangulator, mut corners) = (Triangulator::default(), Vec::new());
    for (face, before) in divided.faces().zip(mesh.faces()) {
        if face.corner_count() == before.corner_count() {
            made.face(face.loops(), FaceOrigin::piece(&face));
            continue;
        }
        corners.clear();
        triangulator.face(&divided, face.index(), &mut corners);
        let point = |corner: u32| divided.corners()[corner as usize];
        let mut triangles: Vec<[u32; 3]> = corners.iter().map(|triangle| triangle.each(point)).collect();
        with_area(&mut triangles, &|point| divided.points()[point as usize]);
        face.loops().for_each(|ring| with_corners(&mut triangles, ring));
        for triangle in triangles {
            made.face([triangle], FaceOrigin::piece(&face));
        }
    }
    made.finish()
}

/// A triangle whose height is below this share of its longest side has no area.
const FLAT: f64 = 1e-7;

/// The edge of a triangle without area that contains the third corner, as the number of its first corner.
fn flat_edge(triangle: [u32; 3], place: &impl Fn(u32) -> DVec3) -> Option<usize> {
    let places = triangle.each(place);
    let length = |k: usize| (places[(k + 1) % 3] - places[k]).length();
    let longest = (0..3).fold(0, |most, k| if length(most) < length(k) { k } else { most });
    let area = (places[1] - places[0]).cross(places[2] - places[0]).length();
    (area <= FLAT * length(longest) * length(longest)).then_some(longest)
}

/// Changes triangles of a polygon so that none is without area: one with a corner inside of its longest edge, and its neighbour at this
/// edge, become two others. A card would not draw it, and the neighbour would have a corner of others inside of an edge.
fn with_area(triangles: &mut [[u32; 3]], place: &impl Fn(u32) -> DVec3) {
    // The triangle of each directed edge. Only for look-ups, never iterated.
    let mut owners: HashMap<[u32; 2], usize, FixedState> = HashMap::default();
    let edges = |[a, b, c]: [u32; 3]| [[a, b], [b, c], [c, a]];
    for (number, triangle) in triangles.iter().enumerate() {
        for edge in edges(*triangle) {
            owners.insert(edge, number);
        }
    }
    let mut flat: Vec<usize> = (0..triangles.len()).filter(|at| flat_edge(triangles[*at], place).is_some()).collect();
    // Each change makes one less. In a row of flat triangles, the last has a neighbour with area.
    while !flat.is_empty() {
        let before = flat.len();
        flat.retain(|&at| {
            let Some(long) = flat_edge(triangles[at], place) else { return false };
            let [a, b, middle] = [0, 1, 2].each(|k| triangles[at][(long + k) % 3]);
            let Some(&beside) = owners.get(&[b, a]) else { return true };
            let Some(&far) = triangles[beside].iter().find(|corner| ![a, b].contains(corner)) else { return true };
            if beside == at || flat_edge(triangles[beside], place).is_some() {
                return true;
            }
            triangles[at] = [b, middle, far];
            triangles[beside] = [middle, a, far];
            for number in [at, beside] {
                for edge in edges(triangles[number]) {
                    owners.insert(edge, number);
                }
            }
            false
        });
        if flat.len() == before {
            break;
        }
    }
}

/// Divides triangles of a polygon that leave out corners of a loop: the corners inside of a straight side need not be in a triangle.
fn with_corners(triangles: &mut Vec<[u32; 3]>, ring: &[u32]) {
    let count = ring.len();
    for at in 0..count {
        let from = ring[at];
        let owner = |triangles: &[[u32; 3]], to: u32| {
            triangles.iter().position(|t| (0..3).any(|k| [t[k], t[(k + 1) % 3]] == [from, to]))
        };
        if owner(triangles, ring[(at + 1) % count]).is_some() {
            continue;
        }
        // The triangle has a side from here over some corners.
        let further = (2..count).map(|step| ring[(at + step) % count]);
        let Some((to, found)) = further.filter_map(|to| Some((to, owner(triangles, to)?))).next() else { continue };
        let Some(&far) = triangles[found].iter().find(|corner| ![from, to].contains(corner)) else { continue };
        let next = ring[(at + 1) % count];
        triangles[found] = [from, next, far];
        triangles.push([next, to, far]);
    }
}

/// A point with the coordinates that both ends of its edge have, so that straight sides stay straight to the last digit.
fn on_edge(point: DVec3, [low, high]: [DVec3; 2]) -> DVec3 {
    DVec3::select(low.cmpeq(high), low, point)
}

/// The mesh with all points inside of its edges as corners.
fn with_points(mesh: &Mesh, placement: &DAffine3, edges: &EdgePoints) -> Mesh {
    let back = placement.inverse();
    let place = |point: u32| placement.transform_point3(mesh.points()[point as usize]);
    let is_placed = *placement != DAffine3::IDENTITY;
    let mut made = Derivation::new(mesh, CornerValues::All, mesh.corners().len()).with_old_points();
    // The new points of each edge, from its lower point to its higher one. Only for look-ups, never iterated.
    let mut known: HashMap<[u32; 2], Vec<u32>, FixedState> = HashMap::default();
    for face in mesh.faces() {
        let mut loops: Vec<Vec<u32>> = Vec::new();
        for ring in face.loops() {
            let mut corners = Vec::with_capacity(ring.len());
            for (&from, &to) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                corners.push(from);
                let ends = [from.min(to), from.max(to)];
                let points = known.entry(ends).or_insert_with(|| {
                    let [low, high] = ends.each(place);
                    let length = (high - low).length();
                    let added = edges.inside([low, high]).map(|point| {
                        let share = ((point - low).length() / length).clamp(0.0, 1.0);
                        let local = if is_placed { back.transform_point3(point) } else { point };
                        let local = on_edge(local, ends.each(|end| mesh.points()[end as usize]));
                        made.point(local, PointOrigin::Between { ends, share })
                    });
                    added.collect()
                });
                if from == ends[0] {
                    corners.extend_from_slice(points);
                } else {
                    corners.extend(points.iter().rev());
                }
            }
            loops.push(corners);
        }
        made.face(loops, FaceOrigin::piece(&face));
    }
    made.finish()
}
