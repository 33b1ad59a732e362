//! Coordinates that are affine over a face.

use glam::DVec3;

use super::coordinate::Coordinate;
use crate::mesh::{FaceRef, Mesh};
use crate::tol::AFFINE_EPSILON;

/// Returns true if a coordinate is an affine function of the position on a face, up to rounding. A face without area
/// gives false.
pub(super) fn is_affine(mesh: &Mesh, face: usize, coordinate: Coordinate) -> bool {
    let face = &mesh.face(face);
    let uvs = mesh.uv_set(coordinate.set);
    let value = |corner: usize| uvs[corner][coordinate.axis];
    let Some(gradient) = gradient(face, value) else { return false };
    let start = face.corner_range().start;
    let (from, base) = (face.position(start), value(start));
    let extremes = |(low, high): (f64, f64), corner| (value(corner).min(low), value(corner).max(high));
    let (low, high) = face.corner_range().fold((base, base), extremes);
    let tolerance = AFFINE_EPSILON * (high - low);
    let off = |corner: usize| (value(corner) - base - gradient.dot(face.position(corner) - from)).abs();
    // If a value is infinite or NaN, the comparison is false.
    tolerance.is_finite() && face.corner_range().all(|corner| off(corner) <= tolerance)
}

/// The mean gradient of a coordinate over the face: an integral along the rim, by Green's theorem.
fn gradient(face: &FaceRef<'_>, value: impl Fn(usize) -> f64) -> Option<DVec3> {
    let area = face.area_vector();
    let base = value(face.corner_range().start);
    let mut sum = DVec3::ZERO;
    for [corner, next] in face.edges() {
        let twice_mean = (value(corner) - base) + (value(next) - base);
        sum += (face.position(next) - face.position(corner)) * twice_mean;
    }
    // Both are twice the exact value.
    let gradient = sum.cross(area) / area.length_squared();
    gradient.is_finite().then_some(gradient)
}
