//! Texture coordinates: projections, and operations on whole sets.
//!
//! A set is a number from 0 to 9. All of these leave geometry alone: what they make is a function of the place
//! ([`crate::texture`]), so a rectangle or a box stays one.

use cga_split::{Prefix, Size};
use glam::{DAffine2, DVec2, DVec3, DVec4};

use super::Length;
use super::transform::sin_cos;
use crate::env::Env;
use crate::fault::FaultKind;
use crate::shape::Shape;
use crate::texture::map::UvMap;
use crate::texture::{SETS, Source};

/// The coordinate system of a projection, and its axes for u and v.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names say it")]
pub enum ProjectionAxes {
    ScopeXy,
    ScopeXz,
    ScopeYx,
    ScopeYz,
    ScopeZx,
    ScopeZy,
    WorldXy,
    WorldXz,
    WorldYx,
    WorldYz,
    WorldZx,
    WorldZy,
}

impl ProjectionAxes {
    /// The numbers of the axes for u and v.
    fn axes(self) -> (usize, usize) {
        use ProjectionAxes as A;
        match self {
            A::ScopeXy | A::WorldXy => (0, 1),
            A::ScopeXz | A::WorldXz => (0, 2),
            A::ScopeYx | A::WorldYx => (1, 0),
            A::ScopeYz | A::WorldYz => (1, 2),
            A::ScopeZx | A::WorldZx => (2, 0),
            A::ScopeZy | A::WorldZy => (2, 1),
        }
    }

    fn is_world(self) -> bool {
        use ProjectionAxes as A;
        matches!(self, A::WorldXy | A::WorldXz | A::WorldYx | A::WorldYz | A::WorldZx | A::WorldZy)
    }
}

/// `setupProjection(uvSet, axes, textureWidth, textureHeight)`: stores how a texture is laid on the shape and on what is made
/// of it (*setupProjection operation*). [`project_uv`] writes coordinates with it.
pub fn setup_projection(env: &mut Env, shape: &mut Shape, set: f64, axes: ProjectionAxes, width: Size, height: Size) {
    setup_projection_at(env, shape, set, axes, width, height, Length::Absolute(0.0), Length::Absolute(0.0), 0.0);
}

/// `setupProjection(uvSet, axes, textureWidth, textureHeight, uwFactor)`, an old form (*CGA changelog*).
pub fn setup_projection_uw(
    env: &mut Env,
    shape: &mut Shape,
    set: f64,
    axes: ProjectionAxes,
    width: Size,
    height: Size,
    uw_factor: f64,
) {
    setup_projection_at(env, shape, set, axes, width, height, Length::Absolute(0.0), Length::Absolute(0.0), uw_factor);
}

/// `setupUV(uvSet, textureWidth, textureHeight, uwFactor)`, an old spelling of `setupProjection(uvSet, scope.xy, …)`.
pub fn setup_uv(env: &mut Env, shape: &mut Shape, set: f64, width: f64, height: f64, uw_factor: f64) {
    let [width, height] = [width, height].map(Size::absolute);
    setup_projection_uw(env, shape, set, ProjectionAxes::ScopeXy, width, height, uw_factor);
}

/// `setupProjection(uvSet, axes, textureWidth, textureHeight, widthOffset, heightOffset, uwFactor)`: u is the distance along the
/// first axis from the origin of the scope or the world, plus the offset, plus `uwFactor` times the distance along the axis
/// that is left over, in texture widths; v in the same way without the factor (*setupProjection operation*). The sign of the
/// offsets is not documented: here they are added.
///
/// A relative width is a share of the scope's size along that axis; a floating one is the width nearest to it of which a whole
/// number fill the scope. With `world` it is the scope's axis of the same letter.
#[allow(clippy::too_many_arguments, reason = "the parameters of the operation")]
pub fn setup_projection_at(
    env: &mut Env,
    shape: &mut Shape,
    set: f64,
    axes: ProjectionAxes,
    width: Size,
    height: Size,
    width_offset: Length,
    height_offset: Length,
    uw_factor: f64,
) {
    let Some(set) = uv_set(env, set, "setupProjection") else { return };
    let (a, b) = axes.axes();
    let size = shape.scope.size;
    let sizes = [(width, a, "the texture width"), (height, b, "the texture height")];
    let [width, height] = sizes.map(|(tile, axis, what)| tile_size(env, tile, size[axis], what));
    let offsets = [(width_offset, a, "the width offset"), (height_offset, b, "the height offset")];
    let [width_offset, height_offset] = offsets.map(|(offset, axis, what)| offset.of(size[axis], env, what));
    let uw_factor = env.finite(uw_factor, "the uwFactor");
    let along = |axis: usize| match axes.is_world() {
        true => DVec3::AXES[axis],
        false => shape.scope.axes.col(axis),
    };
    let origin = if axes.is_world() { DVec3::ZERO } else { shape.scope.origin };
    let row = |direction: DVec3, offset: f64, length: f64| -> DVec4 {
        if length == 0.0 {
            return DVec4::ZERO;
        }
        direction.extend(offset - direction.dot(origin)) / length
    };
    let map = UvMap {
        u: row(along(a) + along(3 - a - b) * uw_factor, width_offset, width),
        v: row(along(b), height_offset, height),
    };
    if !(map.u.is_finite() && map.v.is_finite()) {
        return env.fault(FaultKind::Value, "the projection leads beyond the largest number; it is not set up");
    }
    if shape.state.coordinates().is_projected() {
        let projections = shape.state.projections().clone();
        shape.state.change_look().coordinates.fix(set, &projections);
    }
    shape.state.change().projections.set(set, map);
}

/// `projectUV(uvSet)`: gives the geometry the coordinates of the projection that was set up (*projectUV operation*). Without
/// one the set has none.
pub fn project_uv(env: &mut Env, shape: &mut Shape, set: f64) {
    let Some(set) = uv_set(env, set, "projectUV") else { return };
    shape.state.change_look().coordinates.set(set, Source::Stored(set));
}

/// `deleteUV(uvSet)` (*deleteUV operation*).
pub fn delete_uv(env: &mut Env, shape: &mut Shape, set: f64) {
    let Some(set) = uv_set(env, set, "deleteUV") else { return };
    shape.state.change_look().coordinates.set(set, Source::Deleted);
}

/// `copyUV(uvSetSource, uvSetDest)` (*copyUV operation*).
pub fn copy_uv(env: &mut Env, shape: &mut Shape, from: f64, to: f64) {
    let (Some(from), Some(to)) = (uv_set(env, from, "copyUV"), uv_set(env, to, "copyUV")) else { return };
    shape.state.change_look().coordinates.copy(from, to);
}

/// `translateUV(uvSet, u, v)`: adds to the coordinates (*translateUV operation*).
pub fn translate_uv(env: &mut Env, shape: &mut Shape, set: f64, u: f64, v: f64) {
    let by = DVec2::new(env.finite(u, "`translateUV` in u"), env.finite(v, "`translateUV` in v"));
    change(env, shape, set, "translateUV", DAffine2::from_translation(by));
}

/// `scaleUV(uvSet, u, v)`: multiplies the coordinates (*scaleUV operation*).
pub fn scale_uv(env: &mut Env, shape: &mut Shape, set: f64, u: f64, v: f64) {
    let by = DVec2::new(env.finite(u, "`scaleUV` in u"), env.finite(v, "`scaleUV` in v"));
    change(env, shape, set, "scaleUV", DAffine2::from_scale(by));
}

/// `rotateUV(uvSet, angle)`: turns the coordinates anticlockwise about (0, 0), in degrees (*rotateUV operation*).
pub fn rotate_uv(env: &mut Env, shape: &mut Shape, set: f64, angle: f64) {
    let (sin, cos) = sin_cos(env.finite(angle, "`rotateUV`"));
    let turn = glam::DMat2::from_cols(DVec2::new(cos, sin), DVec2::new(-sin, cos));
    change(env, shape, set, "rotateUV", DAffine2::from_mat2(turn));
}

fn change(env: &mut Env, shape: &mut Shape, set: f64, what: &str, change: DAffine2) {
    if let Some(set) = uv_set(env, set, what) {
        shape.state.change_look().coordinates.change(set, &change);
    }
}

/// The number of a set; a fault for any other number.
pub(crate) fn uv_set(env: &mut Env, set: f64, what: &str) -> Option<u8> {
    let known = (0..SETS as u8).find(|&known| f64::from(known) == set);
    if known.is_none() {
        env.fault(FaultKind::Value, format!("`{what}`: there is no uv set {set}, only 0 to 9; it does nothing"));
    }
    known
}

/// The size of a texture in metres, on an extent of the scope or of a surface.
pub(crate) fn tile_size(env: &mut Env, tile: Size, extent: f64, what: &str) -> f64 {
    let value = env.finite(tile.value, what);
    match tile.prefix {
        Prefix::Absolute => value,
        Prefix::Relative => value * extent,
        Prefix::Floating if value == 0.0 || extent == 0.0 => extent,
        Prefix::Floating => {
            // The nearest whole number of tiles, and at least one.
            let count = libm::round((extent / value).abs()).max(1.0);
            (extent.abs() / count).copysign(value)
        }
    }
}
