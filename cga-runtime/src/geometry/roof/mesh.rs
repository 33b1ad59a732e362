//! Roofs over the faces of a mesh.

use glam::{DVec2, DVec3};

use super::{Outline, Rise, Roof, RoofFace, RoofForm, RoofPart, roof};
use crate::geometry::mesh::{FaceRef, FaceTag, FlatFace, Mesh, TagSet, flip};
use crate::geometry::skeleton::{Failure, any_cross};
use crate::geometry::tol::TOUCH_EPSILON;

/// The reason why a face has no roof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RoofRefusal {
    NoNormal,
    TooMany,
    Tangled,
}

/// Builds a roof over each face: the faces of the roof in the order of edges, then the face itself as the bottom. Faces
/// without a roof are copied unchanged, and are also listed with the reason.
pub(crate) fn roof_over(source: &Mesh, form: RoofForm, rise: Rise) -> (Mesh, Vec<(usize, RoofRefusal)>) {
    let mut made = Mesh {
        groups: source.groups.clone(),
        materials: source.materials.clone(),
        tag_sets: tag_sets(source),
        ..Mesh::default()
    };
    let mut refused = Vec::new();
    for face in source.faces() {
        if let Err(why) = add_roof(&face, source.tag_sets().len(), form, rise, &mut made) {
            refused.push((face.index(), why));
            add_plain(&face, &mut made);
        }
    }
    made.number_by_use();
    (made, refused)
}

/// The sets of the source and the empty one, for each part with its tag in place of other tags of roofs.
fn tag_sets(source: &Mesh) -> std::sync::Arc<[TagSet]> {
    let plain = TagSet::default();
    let sets = || source.tag_sets().iter().chain([&plain]);
    RoofPart::ALL
        .iter()
        .flat_map(|part| sets().map(|set| set.renewed("roof", part.tag())))
        .chain(sets().cloned())
        .collect()
}

/// The tag of a part over a face, with the sets of [`tag_sets`].
fn tag(own: FaceTag, sets: usize, block: usize) -> FaceTag {
    let own_set = own.tags.min(sets as u32);
    FaceTag { cap: false, tags: (block * (sets + 1)) as u32 + own_set, ..own }
}

fn add_roof(face: &FaceRef<'_>, sets: usize, form: RoofForm, rise: Rise, made: &mut Mesh) -> Result<(), RoofRefusal> {
    let flat = FlatFace::of(face).ok_or(RoofRefusal::NoNormal)?;
    let (_, rings) = flat.edges(false);
    // Across the face: along its first edge.
    let x = DVec2::new(flat.axes[0].x, flat.axes[1].x).try_normalize().unwrap_or(DVec2::X);
    let outline = Outline { points: &flat.flat, rings: &rings, x };
    let ends = |[a, b]: [u32; 2]| [outline.at(a), outline.at(b)];
    let extent = flat.flat.iter().fold(0.0, |most: f64, p| most.max(p.abs().max_element()));
    if any_cross(outline.edges().into_iter().map(ends).collect(), TOUCH_EPSILON * extent) {
        return Err(RoofRefusal::Tangled);
    }
    let Roof { points, faces, below } = roof(&outline, form, rise).map_err(|failure| match failure {
        Failure::TooMany => RoofRefusal::TooMany,
        Failure::Tangled => RoofRefusal::Tangled,
    })?;
    if faces.is_empty() || !points.iter().all(|point| point.is_finite()) {
        return Err(RoofRefusal::Tangled);
    }
    let base = made.points.len() as u32;
    let given = flat.points.len();
    made.points.extend(flat.points.iter().map(|&point| face.mesh.points()[point as usize]));
    let place = |p: &DVec3| flat.origin + flat.axes[0] * p.x + flat.axes[1] * p.y + flat.normal * p.z;
    made.points.extend(points[given..].iter().map(place));
    let mut bottom = RoofFace { part: RoofPart::Bottom, rings };
    bottom.rings.iter_mut().for_each(|ring| flip(ring));
    for RoofFace { part, rings } in faces.into_iter().chain([bottom]) {
        for mut ring in rings {
            if below {
                flip(&mut ring);
            }
            made.corners.extend(ring.iter().map(|&point| base + point));
            made.end_loop();
        }
        let block = RoofPart::ALL.iter().position(|other| *other == part).unwrap_or(0);
        made.end_face(tag(face.tag(), sets, block));
    }
    Ok(())
}

/// Adds a face without its texture coordinates and normals.
fn add_plain(face: &FaceRef<'_>, made: &mut Mesh) {
    let sets = face.mesh.tag_sets().len();
    for ring in face.loops() {
        for &point in ring {
            let number = made.add_point(face.mesh.points()[point as usize]);
            made.corners.push(number);
        }
        made.end_loop();
    }
    made.end_face(tag(face.tag(), sets, RoofPart::ALL.len()));
}
