//! `set(attribute, value)` (*set operation*).

use glam::DVec3;

use crate::env::Env;
use crate::get;
use crate::op::turn;
use crate::shape::ShapeRef;
use crate::state::Value;
use crate::text::Text;

macro_rules! sizes {
    ($($(#[$doc:meta])* $name:ident = $axis:ident;)*) => {$(
        $(#[$doc])*
        pub fn $name(env: &mut Env, shape: &mut ShapeRef<'_>, value: f64) {
            let mut size = shape.scope.size;
            size.$axis = env.finite(value, "the size");
            shape.resize(size);
        }
    )*};
}

macro_rules! offsets {
    ($($(#[$doc:meta])* $name:ident = $axis:ident;)*) => {$(
        $(#[$doc])*
        pub fn $name(env: &mut Env, shape: &mut ShapeRef<'_>, value: f64) {
            let mut offset = shape.pivot.to_local(shape.scope.origin);
            offset.$axis = env.finite(value, "the offset");
            shape.scope.origin = shape.pivot.to_world(offset);
        }
    )*};
}

macro_rules! rotations {
    ($($(#[$doc:meta])* $name:ident = $axis:ident;)*) => {$(
        $(#[$doc])*
        pub fn $name(env: &mut Env, shape: &mut ShapeRef<'_>, value: f64) {
            let mut angles = DVec3::new(get::scope_rx(shape), get::scope_ry(shape), get::scope_rz(shape));
            angles.$axis = env.finite(value, "the angle");
            shape.scope.axes = shape.pivot.axes * turn(angles.x, angles.y, angles.z);
        }
    )*};
}

macro_rules! materials {
    ($($(#[$doc:meta])* $name:ident = |$material:ident, $value:ident| $change:expr;)*) => {$(
        $(#[$doc])*
        pub fn $name(env: &mut Env, shape: &mut ShapeRef<'_>, value: f64) {
            let $value = env.finite(value, "the material's value").clamp(0.0, 1.0);
            shape.change_material(|$material| $change);
        }
    )*};
}

sizes! {
    /// Width.
    scope_sx = x;
    /// Height.
    scope_sy = y;
    /// Depth.
    scope_sz = z;
}

offsets! {
    /// Offset from the pivot, along its x axis.
    scope_tx = x;
    /// Offset from the pivot, along its y axis.
    scope_ty = y;
    /// Offset from the pivot, along its z axis.
    scope_tz = z;
}

rotations! {
    /// Rotation about the pivot's x axis, in degrees.
    scope_rx = x;
    /// Rotation about the pivot's y axis, in degrees.
    scope_ry = y;
    /// Rotation about the pivot's z axis, in degrees.
    scope_rz = z;
}

materials! {
    /// Red.
    material_color_r = |material, value| material.color.get_or_insert(crate::material::Color::WHITE).r = value;
    /// Green.
    material_color_g = |material, value| material.color.get_or_insert(crate::material::Color::WHITE).g = value;
    /// Blue.
    material_color_b = |material, value| material.color.get_or_insert(crate::material::Color::WHITE).b = value;
    /// Opacity.
    material_opacity = |material, value| material.opacity = Some(value);
    /// Metallic.
    material_metallic = |material, value| material.metallic = Some(value);
    /// Roughness.
    material_roughness = |material, value| material.roughness = Some(value);
}

/// `material.name`.
pub fn material_name(_: &mut Env, shape: &mut ShapeRef<'_>, value: Text) {
    shape.change_material(|material| material.name = Some(value));
}

/// `material.colormap`.
pub fn material_colormap(_: &mut Env, shape: &mut ShapeRef<'_>, value: Text) {
    shape.change_material(|material| material.texture = Some(value));
}

/// An attribute of the grammar, for this shape and its descendants.
pub fn attribute(shape: &mut ShapeRef<'_>, number: u32, value: Value) {
    let attributes = &mut shape.state.change().attributes;
    match attributes.iter_mut().find(|(id, _)| *id == number) {
        Some((_, old)) => *old = value,
        None => attributes.push((number, value)),
    }
}
