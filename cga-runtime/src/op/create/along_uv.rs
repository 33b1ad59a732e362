//! `insertAlongUV`.

use std::sync::Arc;

use crate::asset::{CUBES, File};
use crate::fault::FaultKind;
use crate::geometry::along_uv::{AlongUv, HeightAlignment, HeightDirection, insert_along_uv as bend};
use crate::geometry::primitive;
use crate::geometry::tol::ROUNDING_EPSILON;
use crate::op::create::insert::asset;
use crate::run::env::Env;
use crate::shape::Shape;

/// `insertAlongUV(uvSet, filePath, height)`: copies of an asset, bent along texture coordinates, replace the
/// triangles and quads of the geometry (*insertAlongUV operation*). A missing asset, or geometry without coordinates
/// in the set, is a fault.
pub fn insert_along_uv(env: &mut Env, shape: &mut Shape, set: f64, file: File, height: f64) {
    insert_along_uv_with(env, shape, set, file, height, HeightDirection::ScopeY, HeightAlignment::AlignPosition);
}

/// `insertAlongUV(uvSet, filePath, height, heightDirection, heightAlignment)` (*insertAlongUV operation*).
pub fn insert_along_uv_with(
    env: &mut Env,
    shape: &mut Shape,
    set: f64,
    file: File,
    height: f64,
    direction: HeightDirection,
    alignment: HeightAlignment,
) {
    let Some(set) = env.uv_set(set, "insertAlongUV") else { return };
    let height = env.finite(height, "the height of `insertAlongUV`");
    let is_cube = CUBES.contains(&file.name.as_str());
    let asset = match if is_cube { Ok(Arc::new(primitive::cube())) } else { asset(env, &file) } {
        Ok(asset) => asset,
        Err(why) => return env.asset_fault(format!("`{file}` cannot be inserted: {why}; the shape stays as it is")),
    };
    let carrier = shape.to_mesh();
    if carrier.uv_set(usize::from(set)).is_empty() {
        let message = format!("the shape has no texture coordinates in set {set}: `insertAlongUV` does nothing");
        return env.fault(FaultKind::Geometry, message);
    }
    let most = env.corners_left(1);
    // Functions from points of the world make coordinates, so these have the rounding errors of the world.
    let reach = shape.scope.origin.abs().max_element() + shape.scope.size.length();
    let options = AlongUv { set: usize::from(set), height, direction, alignment, rounding: ROUNDING_EPSILON * reach };
    let Ok(bent) = bend(&carrier, &asset, &options, most) else {
        let _ = env.too_many_corners::<()>(1);
        return;
    };
    if bent.is_empty() {
        let message = "no triangle or quad of the shape carries the asset: `insertAlongUV` does nothing";
        return env.fault(FaultKind::Geometry, message);
    }
    if env.count_vertices(&bent).is_continue() {
        shape.set_mesh(bent);
        crate::op::inserted(env, shape);
    }
}
