//! Sets edges of a face back, each by a distance of its own.
//!
//! The remainder is the interior of the moved outline. The *setback* is the rest of the face: its sides are the sides of the
//! face and the sides of the remainder, turned over, without the parts where both run on one line. So the areas of both add
//! up to the area of the face, and the parts that neighbouring edges sweep are one face. Edges that move in several
//! turns have several setbacks ([`super::region`]).

use super::region::{EdgeCut, FaceRegion, Loops};
use super::sides::{SideOrigins, Sides};
use super::{FaceParts, OffsetError};
use crate::derive::Derivation;
use crate::mesh::{FaceRef, FlatFace};

/// Sets the edges of a face back in turns and adds the parts to a mesh. The pieces of the outline are its edges, which the
/// cuts divide. The cuts are in the order of edges, and of shares along an edge; a cut out of this order, and the cuts after it,
/// are ignored. A turn has one distance in metres for each piece. Numbers that are not positive, and pieces without a
/// number, leave the piece where it is. With `tags_kinds`, sides have tags such as `setback.front`.
///
/// Parts of a setback begin with the first piece that was set back, parts of the remainder with the first piece that has
/// a side. If the face cannot be set back, nothing is added. Returns the number of faces of each turn, then of the
/// remainder.
pub fn set_back(
    face: &FaceRef<'_>,
    cuts: &[EdgeCut],
    turns: &[&[f64]],
    tags_kinds: bool,
    made: &mut Derivation<'_>,
) -> Result<Vec<usize>, OffsetError> {
    if !turns.iter().copied().flatten().any(|distance| 0.0 < *distance) {
        stay(face, tags_kinds, made);
        return Ok(turns.iter().map(|_| 0).chain([1]).collect());
    }
    let plane = FlatFace::of(face).ok_or(OffsetError::NoNormal)?;
    let mut region = FaceRegion::of(&plane, cuts);
    let mut parts = turns.iter().map(|turn| region.set_back(turn)).collect::<Result<Vec<_>, _>>()?;
    parts.push(region.loops());
    let mut part = FaceParts::new(&plane, &region.points, &region.heights, made);
    let sides = Sides::of(face, tags_kinds);
    let count = |(loops, origins): (Loops, SideOrigins)| {
        // Each part has points of its own, because sides that two parts share may have different tags.
        part.begin();
        part.nested(loops, |made, ring, numbers| sides.of_loop(made, &plane.points, &origins, ring, numbers))
    };
    Ok(parts.into_iter().map(count).collect())
}

/// Adds a copy of a face that is a remainder as a whole.
pub fn stay(face: &FaceRef<'_>, tags_kinds: bool, made: &mut Derivation<'_>) {
    Sides::of(face, tags_kinds).copy(made);
}
