//! Removes doubled faces.

use std::collections::BTreeMap;

use super::components::{components, is_closed};
use super::values::have_same_attributes;
use super::{add_face, spend, without_faces};
use crate::each::Each;
use crate::long_sort::long_sort_by;
use crate::mesh::Mesh;
use crate::small_sort::{SmallSort, sort_owned_by};
use crate::tol::VOLUME_EPSILON;

/// A face that has the same corners as others.
#[derive(Clone, Copy)]
struct Double {
    face: u32,
    /// True if the face looks to the same side as the first one.
    is_along: bool,
}

/// The outcome for closed parts that enclose nothing: sheets with two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FlatParts {
    /// One of the two sides stays.
    Open,
    /// Both sides stay.
    StayClosed,
}

/// The mesh without doubled faces: of faces with the same corners, attributes and texture, in either direction, the first one
/// stays. In a closed part all faces of such a set stay that are needed to keep it closed; of two opposite faces inside a
/// solid none is. `None` if no face is removed.
pub(super) fn without_doubles(mesh: &Mesh, flat: FlatParts) -> Option<Mesh> {
    let sets = doubles(mesh)?;
    if sets.is_empty() {
        return None;
    }
    let mut is_gone = vec![false; mesh.face_count()];
    let mut of_face: Vec<Option<&Vec<Double>>> = vec![None; mesh.face_count()];
    sets.iter().for_each(|set| of_face[set[0].face as usize] = Some(set));
    for faces in components(mesh).sets() {
        let sets: Vec<&Vec<Double>> = faces.iter().filter_map(|&face| of_face[face as usize]).collect();
        for face in gone(mesh, &faces, &sets, flat) {
            is_gone[face as usize] = true;
        }
    }
    if !is_gone.contains(&true) {
        return None;
    }
    let mut made = without_faces(mesh);
    for face in (0..mesh.face_count()).filter(|&face| !is_gone[face]) {
        spend(mesh.face_corners(face).len())?;
        add_face(&mut made, mesh, face);
    }
    Some(made.finish())
}

/// The faces to remove from a part with these faces and sets of doubles.
fn gone(mesh: &Mesh, faces: &[u32], sets: &[&Vec<Double>], flat: FlatParts) -> Vec<u32> {
    let mut gone: Vec<u32> = sets.iter().flat_map(|set| &set[1..]).map(|double| double.face).collect();
    gone.small_sort();
    if gone.is_empty() || !is_closed(mesh, faces, &[]) || is_closed(mesh, faces, &gone) {
        return gone;
    }
    let is_doubled = sets.iter().map(|set| set.len()).sum::<usize>() == faces.len();
    match flat {
        _ if !(is_doubled && encloses_nothing(mesh, faces)) => sets.iter().flat_map(|set| surplus(set)).collect(),
        FlatParts::Open => gone,
        FlatParts::StayClosed => Vec::new(),
    }
}

/// The faces of a set whose edges cancel: as many of each direction as there are pairs.
fn surplus(set: &[Double]) -> Vec<u32> {
    let along = set.iter().filter(|double| double.is_along).count();
    let pairs = along.min(set.len() - along);
    let of = |is_along: bool| set.iter().rev().filter(move |double| double.is_along == is_along).take(pairs);
    of(true).chain(of(false)).map(|double| double.face).collect()
}

fn encloses_nothing(mesh: &Mesh, faces: &[u32]) -> bool {
    let volume = |&face: &u32| {
        let face = mesh.face(face as usize);
        face.area_vector().dot(face.position(face.corner_range().start))
    };
    faces.iter().map(volume).sum::<f64>().abs() <= 6.0 * VOLUME_EPSILON * faces.len() as f64
}

/// The faces that may have the same corners as others, in order. `None` if the work is to end.
fn candidates(mesh: &Mesh) -> Option<Vec<u32>> {
    let mut faces: Vec<(u64, u32)> = Vec::with_capacity(mesh.face_count());
    for face in mesh.faces() {
        spend(face.corner_count())?;
        // A sum that does not depend on the order of the points.
        let mixed = |point: u32| (u64::from(point) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(29);
        let points = mesh.corners[face.corner_range()].iter().map(|&point| mixed(point).wrapping_mul(mixed(point)));
        faces.push((points.fold(0, u64::wrapping_add), face.index() as u32));
    }
    if !long_sort_by(&mut faces, Ord::cmp) {
        return None;
    }
    let several = faces.chunk_by(|a, b| a.0 == b.0).filter(|faces| 1 < faces.len());
    let mut found: Vec<u32> = several.flatten().map(|face| face.1).collect();
    long_sort_by(&mut found, Ord::cmp).then_some(found)
}

/// The sets of faces with the same corners, each with at least two faces, in the order of their first faces. `None` if the work is to
/// end.
fn doubles(mesh: &Mesh) -> Option<Vec<Vec<Double>>> {
    // Faces with their corners, in the order of the key.
    type Set = Vec<(Double, Vec<u32>)>;
    let mut found: BTreeMap<Vec<u32>, Vec<Set>> = BTreeMap::new();
    for face in candidates(mesh)? {
        spend(2 * mesh.face_corners(face as usize).len())?;
        let (key, corners, is_along) = canonical(mesh, face);
        let sets = found.entry(key).or_default();
        let is_same = |set: &Set| {
            let (first, others) = &set[0];
            have_same_attributes(mesh, first.face, face)
                && others.iter().zip(&corners).all(|(&one, &other)| mesh.has_same_texture(one, other))
        };
        let known = sets.iter().position(is_same);
        let double = (Double { face, is_along }, corners);
        match known {
            Some(set) => sets[set].push(double),
            None => sets.push(vec![double]),
        }
    }
    let mut sets: Vec<Vec<Double>> = found
        .into_values()
        .flatten()
        .filter(|set| 1 < set.len())
        .map(|set| {
            let first = set[0].0.is_along;
            set.iter().map(|(double, _)| Double { is_along: double.is_along == first, ..*double }).collect()
        })
        .collect();
    sort_owned_by(&mut sets, |a, b| a[0].face.cmp(&b[0].face));
    Some(sets)
}

/// The points of a face in an order that does not depend on its first corner and its direction, the corners in that order, and the
/// direction.
fn canonical(mesh: &Mesh, face: u32) -> (Vec<u32>, Vec<u32>, bool) {
    let face = mesh.face(face as usize);
    let mut is_along = true;
    let mut loops: Vec<(Vec<u32>, Vec<u32>)> = Vec::new();
    for (number, ring) in face.loop_ranges().enumerate() {
        let ahead: Vec<u32> = (ring.start as u32..ring.end as u32).collect();
        let back: Vec<u32> = ahead.iter().rev().copied().collect();
        let [ahead, back] = [ahead, back].each(|ring| least_turn(mesh, ring));
        if number == 0 {
            is_along = ahead.0 <= back.0;
        }
        loops.push(if is_along { ahead } else { back });
    }
    sort_owned_by(&mut loops[1..], Ord::cmp);
    let mut points = Vec::with_capacity(face.corner_count() + loops.len());
    for ring in &loops {
        points.extend_from_slice(&ring.0);
        points.push(u32::MAX);
    }
    (points, loops.into_iter().flat_map(|ring| ring.1).collect(), is_along)
}

/// A loop from its smallest point on: its points and its corners. If it has this point several times, from the one with the
/// smallest follower on.
fn least_turn(mesh: &Mesh, mut ring: Vec<u32>) -> (Vec<u32>, Vec<u32>) {
    let count = ring.len();
    let point = |place: usize| mesh.corners[ring[place % count] as usize];
    let least = (0..count).min_by_key(|&place| (point(place), point(place + 1), point(place + 2))).unwrap_or(0);
    ring.rotate_left(least);
    (ring.iter().map(|&corner| mesh.corners[corner as usize]).collect(), ring)
}
