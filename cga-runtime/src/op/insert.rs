//! `i(file)`, and how inserted geometry meets a scope.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::asset::AssetError;
use crate::env::Env;
use crate::fault::FaultKind;
use crate::shape::{Geometry, Placed, ShapeRef};
use crate::text::Text;

/// `i(file)`: replaces the geometry by an asset, fitted to the scope (*i operation*). A missing asset leaves a fault and
/// a box in its place.
pub fn insert(env: &mut Env, shape: &mut ShapeRef<'_>, file: Text) {
    // *i operation* up to 2016.0; old rule files are full of it.
    if matches!(file.as_str(), "builtin:cube" | "builtin:cube:notex") {
        return super::cube(env, shape);
    }
    let assets = Arc::clone(&env.settings.assets);
    let found = assets.mesh(&file).and_then(|mesh| match mesh.is_empty() {
        true => Err(AssetError::Broken("it has no faces".to_owned())),
        false => Ok(mesh),
    });
    match found {
        Ok(mesh) => {
            let bounds = mesh.bounds();
            let low = if bounds.low.is_finite() { bounds.low } else { DVec3::ZERO };
            fit(shape, low, bounds.size());
            shape.geometry = Geometry::Mesh(Arc::new(Placed { low, size: bounds.size(), mesh, whole: true }));
            super::trim(env, shape);
        }
        Err(why) => {
            env.fault(FaultKind::Asset, format!("`{file}` cannot be inserted: {why}; a box stands in its place"));
            super::cube(env, shape);
        }
    }
}

/// Sets the scope for geometry with that low corner and size (*i operation*, zero sizes):
/// with three sizes the geometry is fitted; the sizes that are zero follow from the others.
pub(crate) fn fit(shape: &mut ShapeRef<'_>, low: DVec3, size: DVec3) {
    let scope = &mut shape.scope;
    let zero: Vec3Mask = scope.size.cmpeq(DVec3::ZERO).into();
    // A flat asset has no scale along its flat axis.
    let scale = |axis: usize| if size[axis] == 0.0 { 0.0 } else { scope.size[axis] / size[axis] };
    match zero.iter().filter(|zero| **zero).count() {
        3 => {
            scope.size = size;
            scope.origin += scope.axes * low;
        }
        2 => {
            let kept = zero.iter().position(|zero| !zero).unwrap_or(0);
            let scale = scale(kept);
            let open = DVec3::from_array(zero.map(|zero| if zero { 1.0 } else { 0.0 }));
            scope.size += open * size * scale;
            scope.origin += scope.axes * (open * low * scale);
        }
        1 => {
            let flat = zero.iter().position(|zero| *zero).unwrap_or(0);
            let mean = (scale((flat + 1) % 3) + scale((flat + 2) % 3)) * 0.5;
            scope.size[flat] = mean * size[flat];
        }
        _ => {}
    }
}

type Vec3Mask = [bool; 3];

/// Turns the scope so that its y axis is `up`; x stays as near as it can, and the geometry in space stays where it is.
/// Gives the map from old to new scope coordinates, without the offset.
pub(crate) fn raise(axes: &DMat3, up: DVec3) -> DMat3 {
    let x = (axes.x_axis - up * up.dot(axes.x_axis)).try_normalize();
    // Looking along x: the old y takes its place.
    let x =
        x.or_else(|| (-axes.y_axis - up * up.dot(-axes.y_axis)).try_normalize()).unwrap_or(up.any_orthonormal_vector());
    DMat3::from_cols(x, up, x.cross(up))
}
