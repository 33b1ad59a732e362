//! Properties of a shape's faces: concave, rectangular, planar, closed, oriented.

use glam::DVec3;

use super::faces::selected;
use super::readable::placed;
use crate::comp::select::Word;
use crate::geometry::mesh::{FaceRef, unit};
use crate::geometry::tol::{ANGLE_EPSILON, STRAIGHT_EPSILON};
use crate::run::env::Env;
use crate::shape::body::is_closed_surface;
use crate::shape::{Inserted, Placed, Shape};

/// `geometry.isConcave()`: true if a face has a reflex corner (*geometry.isConcave function*). A straight corner is
/// not reflex. Some corners of every hole are.
pub fn geometry_is_concave(shape: &Shape) -> bool {
    let Some(placed) = placed(shape) else { return false };
    let stretch = placed.stretch(shape.scope.size);
    placed.mesh.faces().any(|face| {
        let normal = face.stretched_normal(stretch);
        normal != DVec3::ZERO
            && corners(&face, stretch).any(|[before, after]| before.cross(after).dot(normal) < -STRAIGHT_EPSILON)
    })
}

/// `geometry.isRectangular(tolerance)`: true if there are faces, and all have four vertices and right angles within
/// `tolerance` degrees (*geometry.isRectangular function*). A side without length has no angles.
pub fn geometry_is_rectangular(env: &mut Env, shape: &Shape, tolerance: f64) -> bool {
    let tolerance = env.finite(tolerance, "the tolerance");
    let Some(placed) = placed(shape) else { return false };
    let stretch = placed.stretch(shape.scope.size);
    let near = libm::sin(tolerance.clamp(0.0, 90.0).to_radians()) + ANGLE_EPSILON;
    let right =
        |[before, after]: [DVec3; 2]| before != DVec3::ZERO && after != DVec3::ZERO && before.dot(after).abs() <= near;
    0.0 <= tolerance
        && !placed.mesh.is_empty()
        && placed.mesh.faces().all(|face| face.corner_count() == 4 && corners(&face, stretch).all(right))
}

/// `geometry.isPlanar(tolerance)`: true if there are faces, and at no corner the plane of the two edges differs from
/// the plane of the face by more than `tolerance` degrees (*geometry.isPlanar function*). Straight corners do not
/// count.
pub fn geometry_is_planar(env: &mut Env, shape: &Shape, tolerance: f64) -> bool {
    let tolerance = env.finite(tolerance, "the tolerance");
    let Some(placed) = placed(shape) else { return false };
    let stretch = placed.stretch(shape.scope.size);
    let least = libm::cos(tolerance.min(90.0).to_radians()) - ANGLE_EPSILON;
    let flat = |face: FaceRef<'_>| {
        let normal = face.stretched_normal(stretch);
        normal == DVec3::ZERO
            || corners(&face, stretch).all(|[before, after]| {
                let local = before.cross(after);
                // At a reflex corner, the local normal points the other way.
                local.length() <= STRAIGHT_EPSILON || least <= unit(local).dot(normal).abs()
            })
    };
    0.0 <= tolerance && !placed.mesh.is_empty() && placed.mesh.faces().all(flat)
}

/// `geometry.isOriented(selector)`: true if a face has that direction (*geometry.isOriented function*).
pub fn geometry_is_oriented(env: &Env, shape: &Shape, selector: Word) -> bool {
    let mut any = false;
    selected(env, shape, selector, |_| any = true);
    any
}

/// `geometry.isClosedSurface()`: true if there are faces, and every edge has two of them (*geometry.isClosedSurface
/// function*).
pub fn geometry_is_closed_surface(shape: &Shape) -> bool {
    let Some(Placed { mesh, .. }) = placed(shape) else { return false };
    is_closed_surface(&mesh)
}

/// `geometry.isInstanced()`: true if the geometry is an asset or a primitive that has not changed since its insertion
/// (*geometry.isInstanced function*; *Built-in assets* has the primitives). A new size or place is not a change.
pub fn geometry_is_instanced(shape: &Shape) -> bool {
    shape.geometry.inserted() != Inserted::No
}

/// The unit directions of the edges to and from each corner, in scope coordinates.
fn corners<'a>(face: &FaceRef<'a>, stretch: DVec3) -> impl Iterator<Item = [DVec3; 2]> + 'a {
    let face = *face;
    face.loop_ranges().flat_map(move |ring| {
        let (start, count) = (ring.start, ring.len());
        let at = move |i: usize| face.position(start + i % count) * stretch;
        (0..count).map(move |i| {
            let here = at(i + 1);
            [unit(here - at(i)), unit(at(i + 2) - here)]
        })
    })
}
