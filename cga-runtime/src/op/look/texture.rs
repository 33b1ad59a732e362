//! Texture coordinates: projections, and operations on whole sets.
//!
//! A set is a number from 0 to 9. These operations do not change the geometry: their result is a function of the
//! position ([`crate::shape::texture`]), so a rectangle or a box stays one.

use cga_split::{Prefix, Size};
use glam::{DAffine2, DVec2, DVec3, DVec4};

use crate::fault::FaultKind;
use crate::geometry::Frame;
use crate::geometry::each::Each;
use crate::geometry::mesh::uv::{range, spread};
use crate::geometry::rotation::sin_cos;
use crate::geometry::tol::PLANAR_EPSILON;
use crate::geometry::uv_map::UvMap;
use crate::geometry::work;
use crate::op::Length;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::texture::UvSource;

/// The units of work of a corner whose coordinates are changed.
const CORNER: usize = 4;

/// The coordinate system of a projection, and its axes for u and v.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProjectionAxes {
    of_world: bool,
    /// The numbers of the axes for u and v.
    u: usize,
    v: usize,
}

#[allow(missing_docs, non_upper_case_globals, reason = "the language defines the names")]
impl ProjectionAxes {
    pub const ScopeXy: ProjectionAxes = ProjectionAxes::new(false, 0, 1);
    pub const ScopeXz: ProjectionAxes = ProjectionAxes::new(false, 0, 2);
    pub const ScopeYx: ProjectionAxes = ProjectionAxes::new(false, 1, 0);
    pub const ScopeYz: ProjectionAxes = ProjectionAxes::new(false, 1, 2);
    pub const ScopeZx: ProjectionAxes = ProjectionAxes::new(false, 2, 0);
    pub const ScopeZy: ProjectionAxes = ProjectionAxes::new(false, 2, 1);
    pub const WorldXy: ProjectionAxes = ProjectionAxes::new(true, 0, 1);
    pub const WorldXz: ProjectionAxes = ProjectionAxes::new(true, 0, 2);
    pub const WorldYx: ProjectionAxes = ProjectionAxes::new(true, 1, 0);
    pub const WorldYz: ProjectionAxes = ProjectionAxes::new(true, 1, 2);
    pub const WorldZx: ProjectionAxes = ProjectionAxes::new(true, 2, 0);
    pub const WorldZy: ProjectionAxes = ProjectionAxes::new(true, 2, 1);

    const fn new(of_world: bool, u: usize, v: usize) -> Self {
        ProjectionAxes { of_world, u, v }
    }
}

/// `setupProjection(uvSet, axes, textureWidth, textureHeight)`: stores the projection of a texture onto the shape and
/// its descendants (*setupProjection operation*). [`project_uv`] writes coordinates with it.
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
    let [width, height] = [width, height].each(Size::absolute);
    setup_projection_uw(env, shape, set, ProjectionAxes::ScopeXy, width, height, uw_factor);
}

/// `setupProjection(uvSet, axes, textureWidth, textureHeight, widthOffset, heightOffset, uwFactor)`: u is the
/// distance along the first axis from the origin of the scope or the world, plus the offset, minus `uwFactor` times
/// the distance along the remaining axis, in texture widths; v is the same without the factor (*setupProjection
/// operation*). In the page's picture of a doorway, bricks continue around the corner into the reveal on the left,
/// where u grows inwards: with `scope.xy` from the front to the back. The signs of the offsets follow from the page's example for
/// large coordinates, which passes `-offsetx` and `offsetz` to keep both coordinates small: the width offset is added to u, the
/// height offset is taken from v.
///
/// A relative width is a share of the scope's size along that axis. A floating width becomes the nearest width of
/// which an integer number fills the scope. With `world` it refers to the scope's axis of the same letter.
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
    let Some(set) = env.uv_set(set, "setupProjection") else { return };
    let ProjectionAxes { of_world, u: a, v: b } = axes;
    // A size that is only rounding counts as zero, so that its shares are zero.
    let (size, least) = (shape.scope.size, PLANAR_EPSILON * shape.scope.size.abs().max_element());
    let size = DVec3::select(size.abs().cmple(DVec3::splat(least)), DVec3::ZERO, size);
    let sizes = [(width, a, "the texture width"), (height, b, "the texture height")];
    let [width, height] = sizes.each(|(tile, axis, what)| tile_size(env, tile, size[axis], what));
    let offsets = [(width_offset, a, "the width offset"), (height_offset, b, "the height offset")];
    let [width_offset, height_offset] = offsets.each(|(offset, axis, what)| offset.of(size[axis], env, what));
    let uw_factor = env.finite(uw_factor, "the uwFactor");
    let frame = if of_world { Frame::WORLD } else { shape.scope.frame() };
    let (along, origin) = (|axis: usize| frame.axes.col(axis), frame.origin);
    let row = |direction: DVec3, offset: f64, length: f64| -> DVec4 {
        if length == 0.0 {
            return DVec4::ZERO;
        }
        direction.extend(offset - direction.dot(origin)) / length
    };
    let map = UvMap {
        u: row(along(a) - along(3 - a - b) * uw_factor, width_offset, width),
        v: row(along(b), -height_offset, height),
    };
    if !map.is_bounded() {
        return env.fault(FaultKind::Value, "the projection has factors beyond 1e75; it is not set up");
    }
    if shape.state.coordinates().is_projected(set) {
        let projections = shape.state.projections().clone();
        shape.state.change_look().coordinates.fix(set, &projections);
    }
    shape.state.change().projections.set(set, map);
}

/// `projectUV(uvSet)`: gives the geometry the coordinates of its stored projection (*projectUV operation*). Without a
/// projection the set is empty.
pub fn project_uv(env: &mut Env, shape: &mut Shape, set: f64) {
    let Some(set) = env.uv_set(set, "projectUV") else { return };
    shape.map_caps();
    shape.state.change_look().coordinates.set(set, UvSource::Stored(set));
}

/// `deleteUV(uvSet)` (*deleteUV operation*).
pub fn delete_uv(env: &mut Env, shape: &mut Shape, set: f64) {
    let Some(set) = env.uv_set(set, "deleteUV") else { return };
    shape.state.change_look().coordinates.set(set, UvSource::Deleted);
}

/// `copyUV(uvSetSource, uvSetDest)` (*copyUV operation*).
pub fn copy_uv(env: &mut Env, shape: &mut Shape, from: f64, to: f64) {
    let (Some(from), Some(to)) = (env.uv_set(from, "copyUV"), env.uv_set(to, "copyUV")) else { return };
    shape.map_caps();
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
    if let Some(set) = env.uv_set(set, what) {
        change_set(env, shape, set, what, &change);
    }
}

/// Changes a set, unless the result is too large.
fn change_set(env: &mut Env, shape: &mut Shape, set: u8, what: &str, change: &DAffine2) {
    shape.map_caps();
    if !shape.state.change_look().coordinates.change(set, change) {
        env.fault(FaultKind::Value, format!("`{what}` has factors beyond 1e75; the set stays as it is"));
    }
}

/// The coordinates that `normalizeUV` changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalizeMode {
    /// Both, each by its own range.
    Uv,
    /// Both by the larger range.
    UvUniform,
    /// The first coordinate.
    U,
    /// The second coordinate.
    V,
}

/// The faces that `normalizeUV` treats together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalizeType {
    /// Each face by its own range.
    SeparatePerFace,
    /// All faces by the range of all.
    CollectiveAllFaces,
}

/// `normalizeUV(uvSet, normalizeMode, normalizeType)`: moves and scales coordinates to 0 to 1. A coordinate without a
/// range becomes 0 (*normalizeUV operation*).
pub fn normalize_uv(env: &mut Env, shape: &mut Shape, set: f64, mode: NormalizeMode, faces: NormalizeType) {
    let Some(set) = env.uv_set(set, "normalizeUV") else { return };
    let mesh = shape.to_mesh();
    if faces == NormalizeType::SeparatePerFace && 1 < mesh.face_count() {
        shape.map_caps();
        shape.bake();
        return shape.change_mesh(|mesh| {
            let mut uvs = mesh.uv_set(usize::from(set)).to_vec();
            for face in mesh.faces() {
                let own = face.corner_range();
                if !work::spend(CORNER * own.len()) {
                    break;
                }
                if let Some(change) = uvs.get(own.clone()).and_then(range).map(|range| normalized(mode, range)) {
                    uvs[own].iter_mut().for_each(|uv| *uv = change.transform_point2(*uv));
                }
            }
            mesh.with_uv_set(usize::from(set), uvs)
        });
    }
    if let Some(range) = mesh.uv_range(usize::from(set)) {
        change_set(env, shape, set, "normalizeUV", &normalized(mode, range));
    }
}

/// The change that maps a range of coordinates to 0 to 1.
fn normalized(mode: NormalizeMode, [low, high]: [DVec2; 2]) -> DAffine2 {
    let share = |size: f64| if size * UvMap::MOST < 1.0 { 0.0 } else { 1.0 / size };
    let size = spread([low, high]);
    let (each, larger) = (DVec2::new(share(size.x), share(size.y)), DVec2::splat(share(size.max_element())));
    let (factor, by) = match mode {
        NormalizeMode::Uv => (each, low),
        NormalizeMode::UvUniform => (larger, low),
        NormalizeMode::U => (DVec2::new(each.x, 1.0), DVec2::new(low.x, 0.0)),
        NormalizeMode::V => (DVec2::new(1.0, each.y), DVec2::new(0.0, low.y)),
    };
    DAffine2::from_scale_angle_translation(factor, 0.0, -by * factor)
}

/// `tileUV(uvSet, textureWidth, textureHeight)`: scales coordinates about (0, 0) so that a texture has that size in
/// metres on the surface (*tileUV operation*). A relative width is a share of the surface's extent in u; with a
/// floating width, an integer number of tiles fills it. 0 keeps the coordinate, and a negative size mirrors.
pub fn tile_uv(env: &mut Env, shape: &mut Shape, set: f64, width: Size, height: Size) {
    let Some(set) = env.uv_set(set, "tileUV") else { return };
    let Some(extent) = shape.to_mesh().uv_extent(usize::from(set), DVec3::ONE) else { return };
    let (range, metres) = (spread([extent.low, extent.high]), extent.metres);
    let mut factor = |tile: Size, range: f64, metres: f64, what: &str| {
        let tile = Size { value: env.finite(tile.value, what), ..tile };
        if tile.value == 0.0 {
            return 1.0;
        }
        let factor = metres / range / tile_size(env, tile, metres, what);
        if factor.is_finite() { factor } else { 1.0 }
    };
    let factors = DVec2::new(
        factor(width, range.x, metres.x, "the texture width"),
        factor(height, range.y, metres.y, "the texture height"),
    );
    change_set(env, shape, set, "tileUV", &DAffine2::from_scale(factors));
}

/// The size of a texture in metres, on an extent of the scope or of a surface.
pub(crate) fn tile_size(env: &mut Env, tile: Size, extent: f64, what: &str) -> f64 {
    let value = env.finite(tile.value, what);
    match tile.prefix {
        Prefix::Absolute => value,
        Prefix::Relative => value * extent,
        Prefix::Floating if value == 0.0 || extent == 0.0 => extent,
        Prefix::Floating => {
            // Of the two neighbouring integers, the one with the nearer tile size; at least one.
            let exact = (extent / value).abs();
            let (fewer, more) = (libm::floor(exact).max(1.0), libm::ceil(exact).max(1.0));
            let stretch = |count: f64| (exact / count - 1.0).abs();
            let count = if stretch(fewer) < stretch(more) { fewer } else { more };
            (extent.abs() / count).copysign(value)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_fill_an_extent_in_the_number_whose_size_is_nearest() {
        let size = |tile: Size, extent: f64| tile_size(&mut Env::for_tests(), tile, extent, "the width");
        for (wanted, extent, count) in [(3.0, 10.0, 3.0), (4.0, 10.0, 3.0), (20.0, 81.0, 4.0), (1e3, 10.0, 1.0)] {
            assert_eq!(size(Size::floating(wanted), extent), extent / count);
            assert_eq!(size(Size::floating(-wanted), extent), -extent / count);
        }
        assert_eq!([size(Size::floating(0.0), 7.0), size(Size::floating(2.0), 0.0)], [7.0, 0.0]);
        assert_eq!([size(Size::relative(0.5), 8.0), size(Size::absolute(-1.5), 8.0)], [4.0, -1.5]);
    }
}
