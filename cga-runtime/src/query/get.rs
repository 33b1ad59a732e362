//! Attributes of the current shape, as the language's table names them (*scope attribute*, *split attribute*, …).

use glam::DVec3;

use crate::geometry::rotation::angles;
use crate::material::list::{each_material_number, each_material_text};
use crate::material::{Channel, Layer, LayerPart, MaterialNumber, MaterialText};
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::view::View;
use crate::value::Value;
use crate::value::array::Array;
use crate::value::text::Text;

macro_rules! numbers {
    (($ty:ty) $($(#[$doc:meta])* $name:ident = |$shape:ident| $value:expr;)*) => {$(
        $(#[$doc])*
        #[inline]
        pub fn $name($shape: &$ty) -> f64 {
            $value
        }
    )*};
}

numbers! { (impl View)
    /// Width.
    scope_sx = |shape| shape.size().x;
    /// Height.
    scope_sy = |shape| shape.size().y;
    /// Depth.
    scope_sz = |shape| shape.size().z;
    /// Height of the scope's origin above the world's ground.
    scope_elevation = |shape| shape.origin().y;
    /// Number of the part in the last split, from 0; -1 before any.
    split_index = |shape| f64::from(shape.split_index());
    /// Parts of the last split.
    split_total = |shape| f64::from(shape.split_total());
}

numbers! { (Shape)
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
    /// Number of the component in its selector, from 0; -1 before any.
    comp_index = |shape| f64::from(shape.comp.index());
    /// Components of its selector.
    comp_total = |shape| f64::from(shape.comp.total());
}

/// The selector that made this component.
pub fn comp_sel(shape: &Shape) -> Text {
    Text::fixed(shape.selector)
}

macro_rules! material_numbers {
    ($($function:ident $name:literal $which:expr;)*) => {$(
        #[doc = concat!("`material.", $name, "`.")]
        pub fn $function(shape: &Shape) -> f64 {
            material_number(shape, $which)
        }
    )*};
}

macro_rules! material_texts {
    ($($function:ident $name:literal $which:expr;)*) => {$(
        #[doc = concat!("`material.", $name, "`.")]
        pub fn $function(shape: &Shape) -> Text {
            material_text(shape, $which)
        }
    )*};
}

each_material_number!(material_numbers);
each_material_text!(material_texts);

/// What the rules set, else what the geometry's own material has (*CGA changelog 2010.3*), else the default.
fn material_number(shape: &Shape, which: MaterialNumber) -> f64 {
    let set = shape.material().number(which);
    set.or_else(|| shape.own_material()?.number(which)).unwrap_or(which.default_value())
}

fn material_text(shape: &Shape, which: MaterialText) -> Text {
    let set = shape.material().text(which).or_else(|| shape.own_material()?.text(which));
    set.cloned().unwrap_or(Text::fixed(which.default_value()))
}

/// `material.color.rgb`: as in `#ff8000`.
pub fn material_color_rgb(shape: &Shape) -> Text {
    let channel = |channel| {
        let share = material_number(shape, MaterialNumber::Color(channel));
        libm::round(share.clamp(0.0, 1.0) * 255.0) as u8
    };
    let (r, g, b) = (channel(Channel::R), channel(Channel::G), channel(Channel::B));
    Text::from(format!("#{r:02x}{g:02x}{b:02x}"))
}

/// `material.doubleSided`.
pub fn material_double_sided(shape: &Shape) -> bool {
    shape.material().double_sided.or_else(|| shape.own_material()?.double_sided).unwrap_or(true)
}

/// `trim.vertical`: whether vertical trim planes cut (*trim attribute*). There are no trim planes yet.
pub fn trim_vertical(shape: &Shape) -> bool {
    shape.state.trim().vertical
}

/// `trim.horizontal`: whether horizontal trim planes cut (*trim attribute*). There are no trim planes yet.
pub fn trim_horizontal(shape: &Shape) -> bool {
    shape.state.trim().horizontal
}

/// `seedian`: the seed that random numbers of this shape follow from (*seedian attribute*). Seeds have 64 bits; those that
/// are no whole number a float can hold read as one that is.
pub fn seedian(shape: &impl View) -> f64 {
    let seed = shape.seed_value();
    let exact = (seed as i64).unsigned_abs() <= SEED_MAX;
    if exact { seed as i64 as f64 } else { (seed >> 11) as f64 }
}

/// Whole numbers up to this are exact in a float.
pub(crate) const SEED_MAX: u64 = 1 << 53;

/// `initialShape.name`: see [`Shape::named`](crate::shape::Shape::named) (*initialShape attribute*).
pub fn initial_shape_name(env: &Env, _: &impl View) -> Text {
    env.initial.name.clone()
}

/// `initialShape.startRule` (*initialShape attribute*).
pub fn initial_shape_start_rule(env: &Env, _: &impl View) -> Text {
    Text::fixed(env.initial.start_rule)
}

macro_rules! placed {
    (($ty:ty) $($(#[$doc:meta])* $name:ident = |$env:ident, $shape:pat_param| $value:expr;)*) => {$(
        $(#[$doc])*
        pub fn $name($env: &Env, $shape: &$ty) -> f64 {
            $value
        }
    )*};
}

// *initialShape attribute*: object coordinates in the world. *pivot attribute*: the pivot in object coordinates.
placed! { (impl View)
    /// Where object coordinates begin, in the world: x.
    initial_shape_origin_px = |env, _| env.initial.object.origin.x;
    /// Where object coordinates begin, in the world: y.
    initial_shape_origin_py = |env, _| env.initial.object.origin.y;
    /// Where object coordinates begin, in the world: z.
    initial_shape_origin_pz = |env, _| env.initial.object.origin.z;
    /// How object coordinates are turned in the world, in degrees: about x.
    initial_shape_origin_ox = |env, _| angles(&env.initial.object.axes).x;
    /// How object coordinates are turned in the world, in degrees: about y.
    initial_shape_origin_oy = |env, _| angles(&env.initial.object.axes).y;
    /// How object coordinates are turned in the world, in degrees: about z.
    initial_shape_origin_oz = |env, _| angles(&env.initial.object.axes).z;
}

placed! { (Shape)
    /// Where the pivot is in object coordinates: x.
    pivot_px = |env, shape| pivot_position(env, shape).x;
    /// Where the pivot is in object coordinates: y.
    pivot_py = |env, shape| pivot_position(env, shape).y;
    /// Where the pivot is in object coordinates: z.
    pivot_pz = |env, shape| pivot_position(env, shape).z;
    /// How the pivot is turned in object coordinates, in degrees: about x.
    pivot_ox = |env, shape| pivot_rotation(env, shape).x;
    /// How the pivot is turned in object coordinates, in degrees: about y.
    pivot_oy = |env, shape| pivot_rotation(env, shape).y;
    /// How the pivot is turned in object coordinates, in degrees: about z.
    pivot_oz = |env, shape| pivot_rotation(env, shape).z;
}

pub(crate) fn pivot_position(env: &Env, shape: &Shape) -> DVec3 {
    env.initial.object.to_local(shape.pivot.origin)
}

pub(crate) fn pivot_rotation(env: &Env, shape: &Shape) -> DVec3 {
    angles(&(env.initial.object.axes.transpose() * shape.pivot.axes))
}

fn offset(shape: &Shape) -> DVec3 {
    shape.pivot.to_local(shape.scope.origin)
}

fn rotation(shape: &Shape) -> DVec3 {
    angles(&(shape.pivot.axes.transpose() * shape.scope.axes))
}

macro_rules! array_attributes {
    ($($(#[$doc:meta])* $name:ident: $item:ty = $variant:ident;)*) => {$(
        $(#[$doc])*
        pub fn $name(shape: &impl View, number: u32, initial: &Array<$item>) -> Array<$item> {
            if let Some(Value::$variant(value)) = shape.attribute(number) { value.clone() } else { initial.clone() }
        }
    )*};
}

array_attributes! {
    /// An attribute of the grammar that is an array of floats, as this shape sees it.
    floats_attribute: f64 = Floats;
    /// An attribute of the grammar that is an array of bools, as this shape sees it.
    bools_attribute: bool = Bools;
    /// An attribute of the grammar that is an array of texts, as this shape sees it.
    texts_attribute: Text = Texts;
}

/// A float attribute of the grammar as this shape sees it.
#[inline]
pub fn float_attribute(shape: &impl View, number: u32, initial: f64) -> f64 {
    if let Some(Value::Float(value)) = shape.attribute(number) { *value } else { initial }
}

/// A bool attribute of the grammar as this shape sees it.
#[inline]
pub fn bool_attribute(shape: &impl View, number: u32, initial: bool) -> bool {
    if let Some(Value::Bool(value)) = shape.attribute(number) { *value } else { initial }
}

/// A text attribute of the grammar as this shape sees it.
#[inline]
pub fn text_attribute(shape: &impl View, number: u32, initial: &Text) -> Text {
    if let Some(Value::Text(value)) = shape.attribute(number) { value.clone() } else { initial.clone() }
}
