//! Attributes of the current shape, as the language's table names them (*scope attribute*, *split attribute*, …).

use glam::DVec3;

use crate::op::angles;
use crate::shape::ShapeRef;
use crate::state::Value;
use crate::text::Text;

macro_rules! numbers {
    ($($(#[$doc:meta])* $name:ident = |$shape:ident| $value:expr;)*) => {$(
        $(#[$doc])*
        #[inline]
        pub fn $name($shape: &ShapeRef<'_>) -> f64 {
            $value
        }
    )*};
}

numbers! {
    /// Width.
    scope_sx = |shape| shape.scope.size.x;
    /// Height.
    scope_sy = |shape| shape.scope.size.y;
    /// Depth.
    scope_sz = |shape| shape.scope.size.z;
    /// Offset from the pivot, along its x axis.
    scope_tx = |shape| offset(shape).x;
    /// Offset from the pivot, along its y axis.
    scope_ty = |shape| offset(shape).y;
    /// Offset from the pivot, along its z axis.
    scope_tz = |shape| offset(shape).z;
    /// Rotation about the pivot's x axis, in degrees.
    scope_rx = |shape| rotation(shape).x;
    /// Rotation about the pivot's y axis, in degrees.
    scope_ry = |shape| rotation(shape).y;
    /// Rotation about the pivot's z axis, in degrees.
    scope_rz = |shape| rotation(shape).z;
    /// Height of the scope's origin above the world's ground.
    scope_elevation = |shape| shape.scope.origin.y;
    /// Number of the part in the last split, from 0; -1 before any.
    split_index = |shape| f64::from(shape.split.index);
    /// Parts of the last split.
    split_total = |shape| f64::from(shape.split.total);
    /// Number of the component in its selector, from 0; -1 before any.
    comp_index = |shape| f64::from(shape.comp.index);
    /// Components of its selector.
    comp_total = |shape| f64::from(shape.comp.total);
    /// Red, in 0..=1.
    material_color_r = |shape| shape.material().color().r;
    /// Green, in 0..=1.
    material_color_g = |shape| shape.material().color().g;
    /// Blue, in 0..=1.
    material_color_b = |shape| shape.material().color().b;
    /// 1 is opaque.
    material_opacity = |shape| shape.material().opacity();
    /// 0 unless set.
    material_metallic = |shape| shape.material().metallic.unwrap_or(0.0);
    /// 1 unless set.
    material_roughness = |shape| shape.material().roughness.unwrap_or(1.0);
}

/// The selector that made this component.
pub fn comp_sel(shape: &ShapeRef<'_>) -> Text {
    Text::fixed(shape.selector)
}

/// `material.name`, empty unless set.
pub fn material_name(shape: &ShapeRef<'_>) -> Text {
    shape.material().name.clone().unwrap_or_default()
}

/// `material.colormap`, empty unless set.
pub fn material_colormap(shape: &ShapeRef<'_>) -> Text {
    shape.material().texture.clone().unwrap_or_default()
}

fn offset(shape: &ShapeRef<'_>) -> DVec3 {
    shape.pivot.to_local(shape.scope.origin)
}

fn rotation(shape: &ShapeRef<'_>) -> DVec3 {
    angles(&(shape.pivot.axes.transpose() * shape.scope.axes))
}

/// What `set` made of an attribute of the grammar on this shape, if it did.
#[inline]
fn attribute<'s>(shape: &'s ShapeRef<'_>, number: u32) -> Option<&'s Value> {
    let state = shape.state.get()?;
    state.attributes.iter().find(|(id, _)| *id == number).map(|(_, value)| value)
}

/// A float attribute of the grammar as this shape sees it.
#[inline]
pub fn float_attribute(shape: &ShapeRef<'_>, number: u32, initial: f64) -> f64 {
    if let Some(Value::Float(value)) = attribute(shape, number) { *value } else { initial }
}

/// A bool attribute of the grammar as this shape sees it.
#[inline]
pub fn bool_attribute(shape: &ShapeRef<'_>, number: u32, initial: bool) -> bool {
    if let Some(Value::Bool(value)) = attribute(shape, number) { *value } else { initial }
}

/// A text attribute of the grammar as this shape sees it.
#[inline]
pub fn text_attribute(shape: &ShapeRef<'_>, number: u32, initial: &Text) -> Text {
    if let Some(Value::Text(value)) = attribute(shape, number) { value.clone() } else { initial.clone() }
}
