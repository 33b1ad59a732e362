//! Holes: upright shafts through the volume over the outline.

use std::ops::Range;

use glam::DVec3;

use super::planes::prism;
use super::{EnvelopePart, EnvelopeRefusal, Ground, marked};
use crate::boolean::{BooleanOp, combine};
use crate::mesh::{FaceRef, FaceTag, FlatFace, Mesh};
use crate::nesting::extent::Extent;
use crate::small_sort::SmallSort;

/// The volume over the outline of a face without the shafts over its holes. Faces are in the order of their parts.
pub(super) fn drilled(volume: Mesh, ground: &Ground<'_>, face: &FaceRef<'_>) -> Result<Mesh, EnvelopeRefusal> {
    let Extent { low, high } = Extent::of(ground.flat.flat.iter().copied());
    // Above the volume, so that the top is cut and no face is doubled.
    let top = ground.top + (high - low).max_element();
    let shafts: Vec<Mesh> = face
        .loop_ranges()
        .skip(1)
        .filter_map(|ring| shaft(face, ring, ground.up, top))
        .map(|shaft| with_marks_as_groups(&shaft))
        .collect();
    let made = combine(BooleanOp::Subtract, [&[with_marks_as_groups(&volume)], &shafts], 0.0)
        .map_err(|_| EnvelopeRefusal::Tangled)?;
    if made.is_empty() {
        return Err(EnvelopeRefusal::Empty);
    }
    if !made.is_closed() {
        return Err(EnvelopeRefusal::Tangled);
    }
    Ok(in_order(&with_groups_as_marks(&made)))
}

/// A mesh of the faces of another in the order of their parts.
fn in_order(mesh: &Mesh) -> Mesh {
    let mut faces: Vec<_> = mesh.faces().collect();
    faces.small_sort_by_key(|face| EnvelopePart::of_mark(face.tag().tags));
    let mut sorted = Mesh { points: mesh.points.clone(), ..Mesh::default() };
    for face in faces {
        for ring in face.loops() {
            sorted.corners.extend_from_slice(ring);
            sorted.end_loop();
        }
        sorted.end_face(face.tag());
    }
    sorted
}

/// The prism over a hole. `None` for a hole without area.
fn shaft(face: &FaceRef<'_>, ring: Range<usize>, up: DVec3, top: f64) -> Option<Mesh> {
    let start = face.corner_range().start;
    let mut corners: Vec<usize> = ring.collect();
    let mut mesh = super::plain(face, &corners);
    // Holes run the other way around than the outline.
    let is_turned = mesh.face(0).normal().dot(up) < 0.0;
    if is_turned {
        corners.reverse();
        mesh = super::plain(face, &corners);
    }
    let prism = prism(&FlatFace::of(&mesh.face(0))?, up, top);
    // The edge of the hole that begins at each of these corners, or ends there.
    let edge = |k: usize| corners[if is_turned { (k + 1) % corners.len() } else { k }] - start;
    Some(marked(&prism, |tag| match EnvelopePart::of_mark(tag.tags) {
        EnvelopePart::Base(k) => FaceTag { tags: EnvelopePart::Inner(edge(k as usize) as u32).to_mark(), ..tag },
        _ => tag,
    }))
}

/// Groups have names that operations keep; marks have none.
fn with_marks_as_groups(mesh: &Mesh) -> Mesh {
    let mut marks: Vec<u32> = mesh.faces().map(|face| face.tag().tags).collect();
    marks.small_sort();
    marks.dedup();
    let group = |mark: u32| marks.binary_search(&mark).map_or(FaceTag::NONE, |number| number as u32);
    let mut made = marked(mesh, |tag| FaceTag { group: group(tag.tags), ..FaceTag::PLAIN });
    made.groups = marks.iter().map(|mark| mark.to_string()).collect::<Vec<_>>().into();
    made
}

fn with_groups_as_marks(mesh: &Mesh) -> Mesh {
    let marks: Vec<u32> = mesh.groups().iter().map(|name| name.parse().unwrap_or_default()).collect();
    marked(mesh, |tag| FaceTag { tags: marks.get(tag.group as usize).copied().unwrap_or_default(), ..FaceTag::PLAIN })
}
