//! The attributes of the current shape, named as in the table of the language (*scope attribute*, *split attribute*,
//! …).

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
    /// The width.
    scope_sx = |shape| shape.size().x;
    /// The height.
    scope_sy = |shape| shape.size().y;
    /// The depth.
    scope_sz = |shape| shape.size().z;
    /// The index of the part in the last split, from 0; -1 before any split.
    split_index = |shape| f64::from(shape.split_index());
    /// The number of parts of the last split.
    split_total = |shape| f64::from(shape.split_total());
}

numbers! { (Shape)
    /// The offset from the pivot, along the pivot's x axis.
    scope_tx = |shape| offset(shape).x;
    /// The offset from the pivot, along the pivot's y axis.
    scope_ty = |shape| offset(shape).y;
    /// The offset from the pivot, along the pivot's z axis.
    scope_tz = |shape| offset(shape).z;
    /// The rotation about the pivot's x axis, in degrees.
    scope_rx = |shape| rotation(shape).x;
    /// The rotation about the pivot's y axis, in degrees.
    scope_ry = |shape| rotation(shape).y;
    /// The rotation about the pivot's z axis, in degrees.
    scope_rz = |shape| rotation(shape).z;
    /// The index of the component within its selector, from 0; -1 before any comp.
    comp_index = |shape| f64::from(shape.comp.index());
    /// The number of components of its selector.
    comp_total = |shape| f64::from(shape.comp.total());
}

/// The height of the scope's origin above sea level, in metres: its y coordinate, unless the scene has a coordinate system.
#[inline]
pub fn scope_elevation(env: &Env, shape: &impl View) -> f64 {
    let origin = shape.origin();
    env.settings.coordinates.as_ref().map_or(origin.y, |system| system.elevation(origin))
}

/// The old number of a shape: equal for equal keys, and different for different ones but for chance. It is below 2⁵³.
pub fn uid(env: &Env) -> f64 {
    // FNV-1a.
    let bytes = env.tree_key().into_iter().flat_map(u32::to_le_bytes);
    let hash =
        bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    (hash >> 11) as f64
}

/// The selector that made this component.
pub fn comp_sel(shape: &Shape) -> Text {
    shape.selector.clone()
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

/// The value set by rules, otherwise the value of the geometry's own material (*CGA changelog 2010.3*), otherwise the
/// default.
fn material_number(shape: &Shape, which: MaterialNumber) -> f64 {
    let set = shape.material().number(which);
    set.or_else(|| shape.own_material()?.number(which)).unwrap_or(which.default_value())
}

fn material_text(shape: &Shape, which: MaterialText) -> Text {
    let set = shape.material().text(which).or_else(|| shape.own_material()?.text(which));
    set.cloned().unwrap_or(Text::fixed(which.default_value()))
}

/// `material.color.rgb`: text such as `#ff8000`.
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

/// `trim.vertical`: true if vertical trim planes cut (*trim attribute*).
pub fn trim_vertical(shape: &Shape) -> bool {
    shape.state.trim().vertical
}

/// `trim.horizontal`: true if horizontal trim planes cut (*trim attribute*).
pub fn trim_horizontal(shape: &Shape) -> bool {
    shape.state.trim().horizontal
}

/// `seedian`: the seed of the random numbers of this shape (*seedian attribute*). Seeds have 64 bits; a seed that a
/// float cannot hold exactly reads as another integer.
pub fn seedian(shape: &impl View) -> f64 {
    let seed = shape.seed_value();
    let exact = (seed as i64).unsigned_abs() <= SEED_MAX;
    if exact { seed as i64 as f64 } else { (seed >> 11) as f64 }
}

/// The largest integer up to which all integers are exact in a float.
pub(crate) const SEED_MAX: u64 = 1 << 53;

/// `initialShape.name`: see [`Shape::named`](crate::shape::Shape::named) (*initialShape attribute*).
pub fn initial_shape_name(env: &Env, _: &impl View) -> Text {
    env.initial.name.clone()
}

/// `initialShape.startRule` (*initialShape attribute*).
pub fn initial_shape_start_rule(env: &Env, _: &impl View) -> Text {
    env.initial.start_rule.clone()
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
    /// The x coordinate of the origin of object coordinates, in the world.
    initial_shape_origin_px = |env, _| env.initial.object.origin.x;
    /// The y coordinate of the origin of object coordinates, in the world.
    initial_shape_origin_py = |env, _| env.initial.object.origin.y;
    /// The z coordinate of the origin of object coordinates, in the world.
    initial_shape_origin_pz = |env, _| env.initial.object.origin.z;
    /// The rotation of object coordinates in the world about x, in degrees.
    initial_shape_origin_ox = |env, _| angles(&env.initial.object.axes).x;
    /// The rotation of object coordinates in the world about y, in degrees.
    initial_shape_origin_oy = |env, _| angles(&env.initial.object.axes).y;
    /// The rotation of object coordinates in the world about z, in degrees.
    initial_shape_origin_oz = |env, _| angles(&env.initial.object.axes).z;
}

placed! { (Shape)
    /// The x coordinate of the pivot in object coordinates.
    pivot_px = |env, shape| pivot_position(env, shape).x;
    /// The y coordinate of the pivot in object coordinates.
    pivot_py = |env, shape| pivot_position(env, shape).y;
    /// The z coordinate of the pivot in object coordinates.
    pivot_pz = |env, shape| pivot_position(env, shape).z;
    /// The rotation of the pivot in object coordinates about x, in degrees.
    pivot_ox = |env, shape| pivot_rotation(env, shape).x;
    /// The rotation of the pivot in object coordinates about y, in degrees.
    pivot_oy = |env, shape| pivot_rotation(env, shape).y;
    /// The rotation of the pivot in object coordinates about z, in degrees.
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
            if let Some(Value::$variant(value)) = shape.own_attribute(number) { value.clone() } else { initial.clone() }
        }
    )*};
}

array_attributes! {
    /// The value on this shape of a grammar attribute that is an array of floats.
    floats_attribute: f64 = Floats;
    /// The value on this shape of a grammar attribute that is an array of bools.
    bools_attribute: bool = Bools;
    /// The value on this shape of a grammar attribute that is an array of texts.
    texts_attribute: Text = Texts;
}

/// The value on this shape of a float attribute of the grammar.
#[inline]
pub fn float_attribute(shape: &impl View, number: u32, initial: f64) -> f64 {
    if let Some(Value::Float(value)) = shape.own_attribute(number) { *value } else { initial }
}

/// The value on this shape of a bool attribute of the grammar.
#[inline]
pub fn bool_attribute(shape: &impl View, number: u32, initial: bool) -> bool {
    if let Some(Value::Bool(value)) = shape.own_attribute(number) { *value } else { initial }
}

/// The value on this shape of a text attribute of the grammar.
#[inline]
pub fn text_attribute(shape: &impl View, number: u32, initial: &Text) -> Text {
    if let Some(Value::Text(value)) = shape.own_attribute(number) { value.clone() } else { initial.clone() }
}
