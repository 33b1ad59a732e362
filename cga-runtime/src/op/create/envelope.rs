//! `envelope`: the volume that may be built on a lot.

use std::ops::ControlFlow;

use glam::{DMat3, DVec3};

use crate::comp::face_edges;
use crate::comp::select::Word;
use crate::fault::FaultKind;
use crate::geometry::envelope::{EnvelopeRefusal, EnvelopeSide, envelopes};
use crate::geometry::trace::Trace;
use crate::op::create::extrude::{stand, stand_along};
use crate::op::face::refused::report_refused;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::value::array::Array;

/// The direction in which an envelope is erected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EnvelopeAlong {
    /// Along the normal of each face.
    Normal,
    /// Along the world's y axis.
    WorldUp,
}

/// `envelope(direction, maxHeight, frontBaseHeight, frontAngle)`: see [`envelope_all`]. Sides that do not face the street are
/// upright.
pub fn envelope_front(env: &mut Env, shape: &mut Shape, along: EnvelopeAlong, height: f64, base: f64, angle: f64) {
    by_words(env, shape, along, height, &[(Word::StreetFront, base, angle)]);
}

/// `envelope(direction, maxHeight, frontBaseHeight, frontAngle, backBaseHeight, backAngle)`: see [`envelope_all`]. Left and
/// right sides are upright.
#[allow(clippy::too_many_arguments, reason = "the operation defines the parameters")]
pub fn envelope_front_back(
    env: &mut Env,
    shape: &mut Shape,
    along: EnvelopeAlong,
    height: f64,
    front_base: f64,
    front_angle: f64,
    back_base: f64,
    back_angle: f64,
) {
    let sides = [(Word::StreetFront, front_base, front_angle), (Word::StreetBack, back_base, back_angle)];
    by_words(env, shape, along, height, &sides);
}

/// `envelope(direction, maxHeight, frontBaseHeight, frontAngle, backBaseHeight, backAngle, sideBaseHeight, sideAngle)`: see
/// [`envelope_all`]. Left and right sides are alike.
#[allow(clippy::too_many_arguments, reason = "the operation defines the parameters")]
pub fn envelope_sides(
    env: &mut Env,
    shape: &mut Shape,
    along: EnvelopeAlong,
    height: f64,
    front_base: f64,
    front_angle: f64,
    back_base: f64,
    back_angle: f64,
    side_base: f64,
    side_angle: f64,
) {
    envelope_all(
        env,
        shape,
        along,
        height,
        front_base,
        front_angle,
        back_base,
        back_angle,
        side_base,
        side_angle,
        side_base,
        side_angle,
    );
}

/// `envelope(direction, maxHeight, frontBaseHeight, frontAngle, backBaseHeight, backAngle, rightBaseHeight, rightAngle,
/// leftBaseHeight, leftAngle)`: a closed volume over each face (*envelope operation*). At each edge of the outline an upright
/// side rises to its base height, and then a slope leans inwards. Heights are in metres; angles are in degrees, from the
/// level: 90 goes on upright. The volume ends level at the maximum height over the face. Along the world's y axis this is the
/// height over the lowest corner of the face.
///
/// The edges belong to sides as `street.front` and its like select them. Edges of holes have upright sides. If the whole
/// outline is in front of every edge with a slope, each slope goes on over the whole face; otherwise slopes end at each
/// other as the planes of a roof do. Where edges of different slopes come into one line, the flatter slope goes on over both.
///
/// Along the normal, the new scope's y axis is the normal of the first face, and its x axis stays as near to the old one as
/// it can. Along the world's y axis the axes of the scope stay, as in published results. The pivot stays. The faces are the
/// bottom, the top, the upright sides in the order of edges and the slopes, with the tags of the reference. Texture
/// coordinates are lost.
///
/// The shape stays, with a fault, for a maximum height that is not positive, a base height below 0 and an angle that is not
/// from 0 to 90 degrees. A face stays, with a fault, if it has no normal, does not look in the direction, touches itself, has
/// more than 5000 corners, is not below the maximum height, or if nothing is left below its slopes.
#[allow(clippy::too_many_arguments, reason = "the operation defines the parameters")]
pub fn envelope_all(
    env: &mut Env,
    shape: &mut Shape,
    along: EnvelopeAlong,
    height: f64,
    front_base: f64,
    front_angle: f64,
    back_base: f64,
    back_angle: f64,
    right_base: f64,
    right_angle: f64,
    left_base: f64,
    left_angle: f64,
) {
    let sides = [
        (Word::StreetFront, front_base, front_angle),
        (Word::StreetBack, back_base, back_angle),
        (Word::StreetRight, right_base, right_angle),
        (Word::StreetLeft, left_base, left_angle),
    ];
    by_words(env, shape, along, height, &sides);
}

/// `envelope(direction, maxHeight, baseHeights, angles)`: see [`envelope_all`]. The arrays have an element for each edge of
/// each face, in the order of `comp(fe)`. Missing elements are 0 and 90; elements of holes are ignored.
pub fn envelope_edges(
    env: &mut Env,
    shape: &mut Shape,
    along: EnvelopeAlong,
    height: f64,
    bases: Array<f64>,
    angles: Array<f64>,
) {
    if !shape.geometry.has_surface() {
        return;
    }
    let count = shape.to_mesh().corners().len();
    let mut sides = vec![EnvelopeSide::UPRIGHT; count];
    for (side, &base) in sides.iter_mut().zip(bases.as_slice()) {
        side.base = env.finite(base, "a base height of `envelope`");
    }
    for (side, &angle) in sides.iter_mut().zip(angles.as_slice()) {
        side.angle = env.finite(angle, "an angle of `envelope`");
    }
    build(env, shape, along, height, &sides);
}

/// The form of [`envelope_front`] before 2013.1, along the normals.
pub fn envelope_old_front(env: &mut Env, shape: &mut Shape, height: f64, base: f64, angle: f64) {
    envelope_front(env, shape, EnvelopeAlong::Normal, height, base, angle);
}

/// The form of [`envelope_front_back`] before 2013.1, along the normals.
pub fn envelope_old_front_back(
    env: &mut Env,
    shape: &mut Shape,
    height: f64,
    front_base: f64,
    front_angle: f64,
    back_base: f64,
    back_angle: f64,
) {
    envelope_front_back(env, shape, EnvelopeAlong::Normal, height, front_base, front_angle, back_base, back_angle);
}

/// The form of [`envelope_sides`] before 2013.1, along the normals.
#[allow(clippy::too_many_arguments, reason = "the operation defines the parameters")]
pub fn envelope_old_sides(
    env: &mut Env,
    shape: &mut Shape,
    height: f64,
    front_base: f64,
    front_angle: f64,
    back_base: f64,
    back_angle: f64,
    side_base: f64,
    side_angle: f64,
) {
    let along = EnvelopeAlong::Normal;
    envelope_sides(env, shape, along, height, front_base, front_angle, back_base, back_angle, side_base, side_angle);
}

/// The form of [`envelope_all`] before 2013.1, along the normals.
#[allow(clippy::too_many_arguments, reason = "the operation defines the parameters")]
pub fn envelope_old_all(
    env: &mut Env,
    shape: &mut Shape,
    height: f64,
    front_base: f64,
    front_angle: f64,
    back_base: f64,
    back_angle: f64,
    right_base: f64,
    right_angle: f64,
    left_base: f64,
    left_angle: f64,
) {
    envelope_all(
        env,
        shape,
        EnvelopeAlong::Normal,
        height,
        front_base,
        front_angle,
        back_base,
        back_angle,
        right_base,
        right_angle,
        left_base,
        left_angle,
    );
}

/// Builds envelopes with the base height and the angle of each word. An edge belongs to the first word that selects it.
fn by_words(env: &mut Env, shape: &mut Shape, along: EnvelopeAlong, height: f64, words: &[(Word, f64, f64)]) {
    if !shape.geometry.has_surface() {
        return;
    }
    let ControlFlow::Continue(edges) = face_edges(env, shape, words.iter().map(|word| word.0)) else { return };
    let mut side = |word: &(Word, f64, f64)| EnvelopeSide {
        base: env.finite(word.1, "a base height of `envelope`"),
        angle: env.finite(word.2, "an angle of `envelope`"),
    };
    let of: Vec<EnvelopeSide> = words.iter().map(&mut side).collect();
    let sides: Vec<EnvelopeSide> =
        edges.iter().map(|word| word.map_or(EnvelopeSide::UPRIGHT, |word| of[word as usize])).collect();
    build(env, shape, along, height, &sides);
}

fn build(env: &mut Env, shape: &mut Shape, along: EnvelopeAlong, height: f64, sides: &[EnvelopeSide]) {
    let height = env.finite(height, "the maximum height of `envelope`");
    let why = if height <= 0.0 {
        Some("the maximum height is not positive")
    } else if sides.iter().any(|side| side.base < 0.0) {
        Some("a base height is below 0")
    } else if sides.iter().any(|side| !(0.0..=90.0).contains(&side.angle)) {
        Some("an angle is not from 0 to 90 degrees")
    } else {
        None
    };
    if let Some(why) = why {
        env.fault(FaultKind::Value, format!("`envelope`: {why}; the shape stays as it is"));
        return;
    }
    // Each edge has an upright side, a slope and two corners of the top and the bottom.
    if env.count_corners(10 * shape.corner_count() as u64).is_break() {
        return;
    }
    let mesh = shape.to_mesh();
    let up = match along {
        EnvelopeAlong::Normal => None,
        EnvelopeAlong::WorldUp => Some(shape.scope.axes.transpose() * DVec3::Y),
    };
    let (made, refused) = envelopes(&mesh, sides, height, up);
    report_refused(env, "envelope", &refused, &REFUSALS);
    let normal = || mesh.faces().map(|face| face.normal()).find(|normal| *normal != DVec3::ZERO);
    if refused.len() < mesh.face_count()
        && let Some(up) = up.or_else(normal)
    {
        // *Shape recomposition*: the volume is not connected again, but the movements of the face count.
        env.divide_trace(shape);
        shape.change_trace(|trace| *trace = Trace::default());
        match along {
            EnvelopeAlong::Normal => stand(env, shape, made, up, 1.0, "`envelope`"),
            EnvelopeAlong::WorldUp => stand_along(env, shape, made, DMat3::IDENTITY, 1.0, "`envelope`"),
        }
    }
}

/// The reasons for which a face stays.
const REFUSALS: [(EnvelopeRefusal, &str); 5] = [
    (EnvelopeRefusal::NoNormal, "has no normal"),
    (EnvelopeRefusal::TooMany, "has too many corners"),
    (EnvelopeRefusal::Tangled, "touches itself, or its slopes are too entangled"),
    (EnvelopeRefusal::Empty, "has no room below its slopes and its maximum height"),
    (EnvelopeRefusal::Aside, "does not look in the direction of the envelope"),
];

#[cfg(test)]
mod tests;
