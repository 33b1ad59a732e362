//! The directions and areas of a shape's faces, for functions.

use glam::DVec3;

use super::readable::placed;
use crate::comp::orientation::Orientation;
use crate::comp::select::{Sense, Word};
use crate::run::env::Env;
use crate::shape::Shape;

/// Calls `each` with the area, in square metres, of every face in the direction of a selector word (*geometry.area
/// function*, *geometry.isOriented function*). A word without a direction selects all faces. A face without area has
/// no direction.
pub(super) fn selected(env: &Env, shape: &Shape, word: Word, mut each: impl FnMut(f64)) {
    let looks = Orientation::of(env, shape);
    area_vectors(shape, |vector, area, at| {
        let length = vector.length();
        let takes = || match word.0 {
            Sense::Looks(axes, direction) => looks.takes(axes, direction, looks.outwards(vector / length), || at),
            _ => true,
        };
        if 0.0 < length && takes() {
            each(area);
        }
    });
}

/// Calls `each` with the area vector of every face (its normal times its area as seen along the normal), its area and a point of
/// it, in scope coordinates.
pub(super) fn area_vectors(shape: &Shape, mut each: impl FnMut(DVec3, f64, DVec3)) {
    let Some(placed) = placed(shape) else { return };
    let stretch = placed.stretch(shape.scope.size);
    // The factor of cross products of stretched vectors.
    let across = DVec3::new(stretch.y * stretch.z, stretch.z * stretch.x, stretch.x * stretch.y);
    let to_scope = placed.to_scope(shape.scope.size);
    placed.mesh.faces().for_each(|face| {
        let at = to_scope.transform_point3(face.position(face.corner_range().start));
        let area = face.sum_of_vectors(|vector| (vector * across * 0.5).length());
        each(face.area_vector() * across * 0.5, area, at);
    });
}
