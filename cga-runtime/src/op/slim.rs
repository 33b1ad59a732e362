//! Operations on slim shapes: the common operations of façades need no whole shape.
//!
//! Each function changes a slim rectangle or box as the operation of its name changes the whole shape. If that is not
//! enough, it makes the shape whole and adds a base for the result. The changed shape is in `own`. The functions are
//! compiled once: rules have many of these steps.

use glam::DVec3;

use super::{Length, lengths, settle_origin};
use crate::geometry::Axis;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::base::Form;
use crate::shape::look_changes::ChangePlace;
use crate::shape::look_id::LookId;
use crate::shape::scope::Scope;
use crate::shape::step_bases::Bases;
use crate::shape::{Shape, ShapeRef};
use crate::value::read::Read;

/// `t(x, y, z)`, see [`super::translate`].
#[inline(never)]
pub fn translate<'s, 'b>(
    env: &mut Env,
    shape: &'s ShapeRef<'b>,
    bases: &'b Bases,
    own: &'s mut Option<ShapeRef<'b>>,
    x: Length,
    y: Length,
    z: Length,
) -> &'s ShapeRef<'b> {
    let shape = own.insert(shape.clone());
    let size = shape.size.get();
    let moves_coordinates = || !shape.keeps_coordinates(DVec3::new(x.plain(size.x), y.plain(size.y), z.plain(size.z)));
    if shape.has_coordinates() && moves_coordinates() {
        *shape = whole(env, shape, bases, |env, shape| super::translate(env, shape, x, y, z));
        return shape;
    }
    let by = lengths(env, "`t`", [x, y, z], size);
    let origin = shape.origin() + shape.axes.matrix * by;
    if settle_origin(env, origin, "`t`") {
        shape.origin.set(origin.extend(0.0));
    }
    shape
}

/// `s(x, y, z)`, see [`super::size`].
#[inline(never)]
pub fn size<'s, 'b>(
    env: &mut Env,
    shape: &'s ShapeRef<'b>,
    bases: &'b Bases,
    own: &'s mut Option<ShapeRef<'b>>,
    x: Length,
    y: Length,
    z: Length,
) -> &'s ShapeRef<'b> {
    let shape = own.insert(shape.clone());
    let size = shape.size.get();
    let size = DVec3::new(x.plain(size.x), y.plain(size.y), z.plain(size.z));
    let (zero, most) = (DVec3::ZERO, DVec3::splat(Scope::MOST_SIZE));
    let mut fits = size.cmpgt(zero) & size.cmple(most);
    match shape.form {
        // The size across a rectangle does not belong to the rectangle.
        Form::Rect(Axis::X) => fits.set(0, 0.0 <= size.x && size.x <= most.x),
        Form::Rect(Axis::Y) => fits.set(1, 0.0 <= size.y && size.y <= most.y),
        Form::Rect(Axis::Z) => fits.set(2, 0.0 <= size.z && size.z <= most.z),
        Form::Box => {}
        Form::Empty => fits = size.cmpge(zero) & size.cmple(most),
        Form::Other => fits.set(0, false),
    }
    if !fits.all() || shape.has_coordinates() {
        *shape = whole(env, shape, bases, |env, shape| super::size(env, shape, x, y, z));
        return shape;
    }
    shape.size.set(size);
    shape
}

/// `extrude(distance)`, see [`super::extrude()`].
#[inline(never)]
pub fn extrude<'s, 'b>(
    env: &mut Env,
    shape: &'s ShapeRef<'b>,
    bases: &'b Bases,
    own: &'s mut Option<ShapeRef<'b>>,
    distance: Length,
) -> &'s ShapeRef<'b> {
    let shape = own.insert(shape.clone());
    let s = shape.size.get();
    let height = distance.plain(s.y);
    let along = if shape.form == Form::Rect(Axis::Z) { DVec3::Z } else { DVec3::Y };
    // The sides of a cap that grows have its coordinates.
    let keeps = !shape.has_coordinates() || (shape.keeps_coordinates(along) && !shape.has_unmapped_caps());
    let is_length = 0.0 < height && height <= Scope::MOST_SIZE && keeps;
    match shape.form {
        Form::Rect(Axis::Z)
            if is_length && 0.0 < s.x && 0.0 < s.y && s.z == 0.0 && std::ptr::eq(shape.axes, shape.base.axes()) =>
        {
            shape.unit.set(shape.unit.get().grown(Axis::Z));
            shape.origin.set(shape.origin.get() + shape.axes.along(Axis::Y) * s.y);
            shape.size.set(DVec3::new(s.x, height, s.y));
            shape.axes = shape.base.raised();
        }
        Form::Rect(Axis::Y) if is_length && 0.0 < s.x && s.y == 0.0 && 0.0 < s.z => {
            shape.unit.set(shape.unit.get().grown(Axis::Y));
            shape.size.set_along(Axis::Y, height);
        }
        _ => {
            *shape = whole(env, shape, bases, |env, shape| super::extrude(env, shape, distance));
            return shape;
        }
    }
    shape.form = Form::Box;
    shape
}

/// An operation that changes only the material of the look, at a place in the rules. Its result is found once for each previous look, and
/// for the values that it reads.
#[inline(never)]
#[allow(clippy::too_many_arguments, reason = "generated code calls it")]
pub fn change_material<'s, 'b>(
    env: &mut Env,
    shape: &'s ShapeRef<'b>,
    bases: &'b Bases,
    own: &'s mut Option<ShapeRef<'b>>,
    place: ChangePlace,
    reads: &[Read<'_>],
    change: &dyn Fn(&mut Env, &mut Shape),
) -> &'s ShapeRef<'b> {
    let looks = &mut env.leaf_tables.looks;
    if shape.look.get() == LookId::OF_BASE && looks.keeps_more(place, reads) {
        shape.look.set(looks.number(shape.base.shape.state.look()));
    }
    let before = shape.look.get();
    if let Some(after) = looks.changed(place, before, reads) {
        shape.look.set(after);
        return shape;
    }
    let faults = env.fault_count();
    // A look with a number is made once and does not count.
    let counts = std::mem::replace(&mut env.counts_looks, false);
    let changed = whole(env, shape, bases, change);
    env.counts_looks = counts;
    if before != LookId::OF_BASE && faults == env.fault_count() {
        let after = env.leaf_tables.looks.change(place, before, reads, changed.base.shape.state.look());
        if after != LookId::OF_BASE {
            shape.look.set(after);
            return shape;
        }
    }
    let _: Flow = env.count_look(&changed.base.shape.state.look().material);
    own.insert(changed)
}

/// As [`change_material`] for an operation on texture coordinates. Caps become faces like others.
#[inline(never)]
#[allow(clippy::too_many_arguments, reason = "generated code calls it")]
pub fn change_coordinates<'s, 'b>(
    env: &mut Env,
    shape: &'s ShapeRef<'b>,
    bases: &'b Bases,
    own: &'s mut Option<ShapeRef<'b>>,
    place: ChangePlace,
    reads: &[Read<'_>],
    change: &dyn Fn(&mut Env, &mut Shape),
) -> &'s ShapeRef<'b> {
    if shape.has_unmapped_caps() {
        return own.insert(whole(env, shape, bases, change));
    }
    change_material(env, shape, bases, own, place, reads, change)
}

/// Applies an operation to the whole shape.
#[cold]
#[inline(never)]
fn whole<'b>(
    env: &mut Env,
    shape: &ShapeRef<'_>,
    bases: &'b Bases,
    change: impl FnOnce(&mut Env, &mut Shape),
) -> ShapeRef<'b> {
    let mut whole = env.whole(shape);
    change(env, &mut whole);
    bases.keep(env.base(whole)).shape()
}
