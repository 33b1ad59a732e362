//! Points that only rounding keeps apart from the planes of a cut.

use std::sync::Arc;

use crate::Axis;
use crate::mesh::Mesh;

/// Moves points along `axis` onto the nearest of the planes where the coordinate equals an offset, if they are at most `tolerance` away, in
/// the mesh's own unit. A cut by [`slabs`](super::slabs()) along edges of the mesh then makes no faces that are thinner than the tolerance.
/// Offsets must increase. Without such points, or if the tolerance is not finite, it is the same mesh, not a copy. One pass over the points.
///
/// ```
/// use std::sync::Arc;
/// use cga_geometry::{Axis, cut, primitive};
///
/// let cube = Arc::new(primitive::cube());
/// let plane = 1.0 - f64::EPSILON;
/// assert!(cut::slabs(&cube, Axis::X, &[plane]).parts[1].is_some(), "a sliver");
/// let snapped = cut::snap(&cube, Axis::X, &[plane], 1e-15);
/// assert_eq!(snapped.bounds().high.x, plane);
/// assert!(cut::slabs(&snapped, Axis::X, &[plane]).parts[1].is_none());
/// ```
pub fn snap(mesh: &Arc<Mesh>, axis: Axis, offsets: &[f64], tolerance: f64) -> Arc<Mesh> {
    let at = axis.index();
    let plane = |place: f64| {
        let after = offsets.partition_point(|&offset| offset < place);
        let around = offsets[after.saturating_sub(1)..offsets.len().min(after + 1)].iter().copied();
        let distance = |offset: f64| (offset - place).abs();
        around.filter(|&offset| distance(offset) <= tolerance).min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
    };
    let is_near = |place: f64| plane(place).is_some_and(|offset| offset != place);
    if !tolerance.is_finite() || !mesh.points().iter().any(|point| is_near(point[at])) {
        return mesh.clone();
    }
    let mut points = mesh.points().to_vec();
    for point in &mut points {
        // Adds 0.0 because a plane at -0 would give points at -0.
        point[at] = plane(point[at]).map_or(point[at], |offset| offset + 0.0);
    }
    Arc::new(mesh.with_points(points))
}
