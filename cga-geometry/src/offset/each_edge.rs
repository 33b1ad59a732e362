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

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::*;
    use crate::derive::CornerValues;
    use crate::mesh::Mesh;

    /// The areas of the parts of a lot with a step of `step` in a side, whose edges on both sides of the step are set back.
    fn parts(step: f64, distance: f64, turn: f64, at: DVec3) -> (Vec<usize>, Vec<f64>) {
        let turned = DMat3::from_rotation_y(turn);
        let corners = [(0.0, 0.0), (1.0 - step, 0.0), (1.0 - step, -1.0), (1.0, -1.0), (1.0, -2.5), (0.0, -2.5)];
        let corners = corners.map(|(x, z)| turned * DVec3::new(x, 0.0, z) + at);
        let lot = Mesh::from_polygon(&corners, &[]).expect("an outline");
        let mut made = Derivation::new(&lot, CornerValues::All, 0);
        let counts = set_back(&lot.face(0), &[], &[&[0.0, distance, 0.0, distance]], false, &mut made).expect("parts");
        let made = made.finish();
        assert_eq!(made.check(), []);
        (counts, made.faces().map(|face| face.area()).collect())
    }

    #[test]
    fn parts_that_meet_in_a_corner_are_apart_whatever_rounding_says() {
        // An edge moves to the line of the next one, up to its corner. No rounding joins what both sweep.
        for number in 0..2_000 {
            let number = f64::from(number);
            let step = 0.0713 + 0.000_1 * number;
            let at = DVec3::new(11.7 * number, 0.0, -1.3 * number);
            let distance = [step, step.next_up(), step.next_down(), 1.0 - (1.0 - step)][number as usize % 4];
            let (counts, areas) = parts(step, distance, 0.37 * number, at);
            assert_eq!(counts, [2, 1], "{step} by {distance}");
            let expected = [distance, 1.5 * distance, 2.5 - 1.0 * step - 2.5 * distance];
            let is_near = areas.iter().zip(expected).all(|(area, expected)| (area - expected).abs() < 1e-9);
            assert!(is_near, "{step} by {distance}: {areas:?}, not {expected:?}");
        }
        // Farther, both are one part; less far, there is a gap.
        assert_eq!(parts(0.1, 0.101, 0.3, DVec3::ZERO).0, [1, 1]);
        assert_eq!(parts(0.1, 0.099, 0.3, DVec3::ZERO).0, [2, 1]);
    }
}
