//! The fit of inserted geometry to a scope.

use std::sync::Arc;

use glam::DVec3;

use crate::geometry::Axis;
use crate::geometry::each::Each;
use crate::geometry::mesh::{Mesh, Variant};
use crate::geometry::tol::PLANAR_EPSILON;
use crate::run::env::Env;
use crate::shape::{Geometry, Inserted, Placed, Shape};

/// The axes along which a shape has no size. A size that is only rounding, relative to the largest, is set to zero, so that rounding
/// does not choose the form of what is inserted.
pub(in crate::op) fn flat_axes(shape: &mut Shape) -> [bool; 3] {
    let size = &mut shape.scope.size;
    let flat = size.abs().cmple(DVec3::splat(PLANAR_EPSILON * size.abs().max_element()));
    *size = DVec3::select(flat, DVec3::ZERO, *size);
    flat.into()
}

/// Sets the scope for geometry with that low corner and size (*i operation*, zero sizes). With three sizes the
/// geometry is fitted to them; sizes that are zero follow from the others.
pub(in crate::op) fn fit(shape: &mut Shape, low: DVec3, size: DVec3) {
    let zero = flat_axes(shape);
    let scope = &mut shape.scope;
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
            let open = DVec3::from_array(zero.each(|zero| if zero { 1.0 } else { 0.0 }));
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

/// Gives the scope a size, in the middle of its old plane across an axis and on its floor.
pub(in crate::op) fn centre(shape: &mut Shape, size: DVec3, across: Axis) {
    let mut room = (shape.scope.size - size) * 0.5;
    room[across.index()] = 0.0;
    shape.scope.origin += shape.scope.axes * room;
    shape.scope.size = size;
}

/// Replaces the geometry by an asset or a primitive, stretched to the scope.
pub(in crate::op) fn put(env: &mut Env, shape: &mut Shape, mesh: Arc<Mesh>) {
    let placed = Placed { inserted: Inserted::Asset, ..Placed::fitted(mesh) };
    shape.geometry = Geometry::Mesh(Arc::new(placed));
    crate::op::inserted(env, shape);
    // A size of zero flattens it.
    shape.resize(shape.scope.size);
    face_outwards(shape);
    crate::op::trim(env, shape);
}

/// Turns the faces of inserted geometry over where its scope mirrors it, so that they look outwards.
pub(in crate::op) fn face_outwards(shape: &mut Shape) {
    if shape.looks_inwards() {
        shape.hold_as_mesh();
        if let Geometry::Mesh(placed) = &shape.geometry {
            let mesh = placed.mesh.variant(Variant::Reversed, |mesh| Some(mesh.reversed()));
            shape.geometry = Geometry::Mesh(Arc::new(Placed { mesh, mirrored: true, ..Placed::clone(placed) }));
        }
    }
}
