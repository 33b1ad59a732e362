//! Sets edges of a face back, each by a distance of its own (*setback operation*).
//!
//! The remainder is the interior of the moved outline. The *setback* is the rest of the face: its sides are those of the
//! face and those of the remainder, turned over, without the parts where both run on one line. So the areas of both add
//! up to the area of the face, and the parts that neighbouring edges sweep are one face.

use std::collections::BTreeMap;

use super::{FaceParts, OffsetError, from_first, relief};
use crate::geometry::mesh::build::in_order_of_use;
use crate::geometry::mesh::flat_face::FlatFace;
use crate::geometry::mesh::{FaceRef, Mesh};
use crate::geometry::nesting::contour::Contour;
use crate::geometry::skeleton::{self, Swept};

/// The numbers of faces that were made of a face: first those of the setback, then those of the remainder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SetBack {
    pub(crate) setback: usize,
    pub(crate) remainder: usize,
}

/// Sets the edges of a face back and adds the parts to a mesh. `distances` has one number for each corner of the face, for
/// the edge that begins there; numbers that are not positive leave the edge where it is.
///
/// Parts of the setback begin with the first edge that was set back, parts of the remainder with the first edge that has a
/// side. If the face cannot be set back, nothing is added.
pub(crate) fn set_back(face: &FaceRef<'_>, distances: &[f64], made: &mut Mesh) -> Result<SetBack, OffsetError> {
    if !distances.iter().any(|distance| 0.0 < *distance) {
        made.add_copy(face);
        return Ok(SetBack { setback: 0, remainder: 1 });
    }
    let plane = FlatFace::of(face).ok_or(OffsetError::NoNormal)?;
    let (edges, rings) = plane.edges(false);
    let distances: Vec<f64> = edges.iter().map(|edge| distances[edge[0]].max(0.0)).collect();
    let swept = skeleton::sweep_each(&plane.flat, &rings, &distances)?;
    let heights = relief::heights(&plane.heights, &rings, &swept);
    let setback = setback(&rings, &swept, &distances);
    // Sides without an edge come after all others.
    let remainder = swept.left.iter().map(|ring| ring.iter().map(|left| (left.edge as usize, left.point)).collect());
    let remainder = remainder.map(from_first).collect();
    let mut part = FaceParts::new(&plane, &swept, &heights, false, made);
    let own = |point: u32| plane.corners.iter().position(|&corner| corner == point);
    Ok(SetBack { setback: part.nested(setback, own), remainder: part.nested(remainder, own) })
}

/// Gives points numbers in the order of faces, after all faces were added.
pub(crate) fn renumber(mesh: &mut Mesh) {
    mesh.points = in_order_of_use(&mesh.points, &mut mesh.corners);
}

/// The loops of the setback. Corners have the rank of their next side: edges that were set back are first.
fn setback(rings: &[Vec<u32>], swept: &Swept, distances: &[f64]) -> Vec<Vec<(usize, u32)>> {
    let mut lines: BTreeMap<usize, Vec<[u32; 2]>> = BTreeMap::new();
    let sides = rings.iter().flat_map(|ring| (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]]));
    sides.enumerate().for_each(|(edge, side)| lines.entry(edge).or_default().push(side));
    for ring in &swept.left {
        for (k, left) in ring.iter().enumerate() {
            let side = [ring[(k + 1) % ring.len()].point, left.point];
            lines.entry(left.edge as usize).or_default().push(side);
        }
    }
    let mut ranks = BTreeMap::new();
    for (&edge, sides) in &lines {
        let is_moved = distances.get(edge).is_some_and(|distance| 0.0 < *distance);
        match &sides[..] {
            [side, moved @ ..] if is_moved => {
                ranks.insert(*side, edge);
                ranks.extend(moved.iter().map(|side| (*side, edge + lines.len())));
            }
            _ => {
                let sides = apart(sides, swept);
                ranks.extend(sides.into_iter().map(|side| (side, edge + lines.len())));
            }
        }
    }
    let sides: Vec<[u32; 2]> = ranks.keys().copied().collect();
    let mut contour = Contour::default();
    contour.follow(&sides, &swept.points, |_| ());
    let mut loops = Vec::new();
    let mut from = 0;
    for &end in &contour.ends {
        let ring = &contour.corners[from..end];
        let rank = |k: usize| ranks.get(&[ring[k], ring[(k + 1) % ring.len()]]).copied().unwrap_or(usize::MAX);
        loops.push(from_first((0..ring.len()).map(|k| (rank(k), ring[k])).collect()));
        from = end;
    }
    loops
}

/// The sides of one line, without the parts where two sides of opposite directions cover each other.
fn apart(sides: &[[u32; 2]], swept: &Swept) -> Vec<[u32; 2]> {
    let at = |point: u32| swept.points[point as usize];
    let Some(&[from, to]) = sides.first() else { return Vec::new() };
    let along = at(to) - at(from);
    let mut points: Vec<u32> = sides.iter().flatten().copied().collect();
    points.sort_unstable();
    points.dedup();
    points.sort_by(|&a, &b| along.dot(at(a)).total_cmp(&along.dot(at(b))));
    let place = |point: u32| points.iter().position(|&other| other == point).unwrap_or(0);
    // For each gap between neighbours the sides ahead less the sides back.
    let mut cover = vec![0i32; points.len()];
    for &[from, to] in sides {
        let (from, to) = (place(from), place(to));
        cover[from.min(to)..from.max(to)].iter_mut().for_each(|count| *count += if from < to { 1 } else { -1 });
    }
    let gaps = points.windows(2).zip(cover);
    gaps.filter(|(_, count)| *count != 0)
        .map(|(gap, count)| if 0 < count { [gap[0], gap[1]] } else { [gap[1], gap[0]] })
        .collect()
}
