//! Texture coordinates for functions (*geometry functions*), implicit ones included.

use glam::{DVec2, DVec3};

use super::readable::mesh;
use crate::geometry::mesh::TextureSpace;
use crate::geometry::mesh::UvAxis;
use crate::geometry::mesh::uv::spread;
use crate::run::env::Env;
use crate::shape::Shape;

/// `geometry.du(uvSet, space)`: the largest u minus the smallest, in texture coordinates or approximately in metres;
/// 0 without coordinates (*geometry.du, dv functions*).
pub fn geometry_du(env: &mut Env, shape: &Shape, set: f64, space: TextureSpace) -> f64 {
    extent(env, shape, set, space, UvAxis::U, "geometry.du")
}

/// `geometry.dv(uvSet, space)`: the largest v minus the smallest, see [`geometry_du`].
pub fn geometry_dv(env: &mut Env, shape: &Shape, set: f64, space: TextureSpace) -> f64 {
    extent(env, shape, set, space, UvAxis::V, "geometry.dv")
}

/// `geometry.uMin(uvSet)`: the smallest u; 0 without coordinates (*geometry.uMin, uMax, vMin, vMax functions*).
pub fn geometry_u_min(env: &mut Env, shape: &Shape, set: f64) -> f64 {
    range(env, shape, set, "geometry.uMin")[0].x
}

/// `geometry.uMax(uvSet)`: the largest u.
pub fn geometry_u_max(env: &mut Env, shape: &Shape, set: f64) -> f64 {
    range(env, shape, set, "geometry.uMax")[1].x
}

/// `geometry.vMin(uvSet)`: the smallest v.
pub fn geometry_v_min(env: &mut Env, shape: &Shape, set: f64) -> f64 {
    range(env, shape, set, "geometry.vMin")[0].y
}

/// `geometry.vMax(uvSet)`: the largest v.
pub fn geometry_v_max(env: &mut Env, shape: &Shape, set: f64) -> f64 {
    range(env, shape, set, "geometry.vMax")[1].y
}

/// `geometry.hasUVs()`: true if there are coordinates in any set (*geometry.hasUVs function*).
pub fn geometry_has_uvs(_: &mut Env, shape: &Shape) -> bool {
    mesh(shape).is_some_and(|mesh| (0..crate::shape::texture::SETS).any(|set| !mesh.uv_set(set).is_empty()))
}

/// `geometry.hasUVs(uvSet)`: true if there are coordinates in a set.
pub fn geometry_has_uv_set(env: &mut Env, shape: &Shape, set: f64) -> bool {
    env.uv_set(set, "geometry.hasUVs")
        .is_some_and(|set| mesh(shape).is_some_and(|mesh| !mesh.uv_set(usize::from(set)).is_empty()))
}

fn range(env: &mut Env, shape: &Shape, set: f64, what: &str) -> [DVec2; 2] {
    let set = env.uv_set(set, what);
    set.and_then(|set| mesh(shape)?.uv_range(usize::from(set))).unwrap_or_default()
}

fn extent(env: &mut Env, shape: &Shape, set: f64, space: TextureSpace, axis: UvAxis, what: &str) -> f64 {
    let Some(set) = env.uv_set(set, what) else { return 0.0 };
    let extent = mesh(shape).and_then(|mesh| mesh.uv_extent(usize::from(set), DVec3::ONE));
    extent.map_or(0.0, |extent| {
        let size = spread([extent.low, extent.high])[axis.index()];
        match space {
            TextureSpace::Unit if size != 0.0 => extent.metres[axis.index()],
            TextureSpace::Unit | TextureSpace::Uv => size,
        }
    })
}
