//! `set(attribute, value)` (*set operation*).

use glam::DVec3;

use crate::fault::FaultKind;
use crate::geometry::Frame;
use crate::geometry::rotation::turn;
use crate::material::list::{each_material_number, each_material_text};
use crate::material::{Channel, Layer, LayerPart, Material, MaterialNumber, MaterialText};
use crate::query::get;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::Shape;
use crate::shape::scope::Scope;
use crate::shape::seed::Seed;
use crate::value::Value;
use crate::value::shown::shown;
use crate::value::text::Text;

macro_rules! numbers {
    (($set:ident) $($(#[$doc:meta])* $name:ident = $axis:ident;)*) => {$(
        $(#[$doc])*
        pub fn $name(env: &mut Env, shape: &mut Shape, value: f64) {
            $set(env, shape, value, |vector| &mut vector.$axis);
        }
    )*};
}

/// A coordinate of a vector.
type CoordinateOf = fn(&mut DVec3) -> &mut f64;

numbers! { (set_size)
    /// The width.
    scope_sx = x;
    /// The height.
    scope_sy = y;
    /// The depth.
    scope_sz = z;
}

fn set_size(env: &mut Env, shape: &mut Shape, value: f64, at: CoordinateOf) {
    let mut size = shape.scope.size;
    *at(&mut size) = env.finite(value, "the size");
    shape.resize(size);
}

numbers! { (set_offset)
    /// The offset from the pivot, along its x axis.
    scope_tx = x;
    /// The offset from the pivot, along its y axis.
    scope_ty = y;
    /// The offset from the pivot, along its z axis.
    scope_tz = z;
}

fn set_offset(env: &mut Env, shape: &mut Shape, value: f64, at: CoordinateOf) {
    let mut offset = shape.pivot.to_local(shape.scope.origin);
    *at(&mut offset) = env.finite(value, "the offset");
    let before = shape.scope;
    shape.scope.origin = shape.pivot.to_world(offset);
    shape.carry(&before);
}

numbers! { (set_rotation)
    /// The rotation about the pivot's x axis, in degrees.
    scope_rx = x;
    /// The rotation about the pivot's y axis, in degrees.
    scope_ry = y;
    /// The rotation about the pivot's z axis, in degrees.
    scope_rz = z;
}

fn set_rotation(env: &mut Env, shape: &mut Shape, value: f64, at: CoordinateOf) {
    let mut angles = DVec3::new(get::scope_rx(shape), get::scope_ry(shape), get::scope_rz(shape));
    *at(&mut angles) = env.finite(value, "the angle");
    let before = shape.scope;
    shape.scope.axes = shape.pivot.axes * turn(angles.x, angles.y, angles.z);
    shape.carry(&before);
}

macro_rules! material_numbers {
    ($($function:ident $name:literal $which:expr;)*) => {$(
        #[doc = concat!("`material.", $name, "`; moved into its range (*material attribute*).")]
        pub fn $function(env: &mut Env, shape: &mut Shape, value: f64) {
            material_number(env, shape, $which, value);
        }
    )*};
}

macro_rules! material_texts {
    ($($function:ident $name:literal $which:expr;)*) => {$(
        #[doc = concat!("`material.", $name, "` (*material attribute*).")]
        pub fn $function(env: &mut Env, shape: &mut Shape, value: Text) {
            material_text(env, shape, $which, value);
        }
    )*};
}

each_material_number!(material_numbers);
each_material_text!(material_texts);

/// Changes the material that rules set, and counts the new one.
pub(crate) fn change_material(env: &mut Env, shape: &mut Shape, change: impl FnOnce(&mut Material)) {
    shape.change_material(change);
    let _: Flow = env.count_look(shape.material());
}

pub(crate) fn material_number(env: &mut Env, shape: &mut Shape, which: MaterialNumber, value: f64) {
    let value = env.finite(value, "the material's value");
    // Setting one channel keeps the other two at their visible values.
    let seen = matches!(which, MaterialNumber::Color(_)) && shape.material().color.is_none();
    let own = if seen { shape.own_material().and_then(|own| own.color) } else { None };
    change_material(env, shape, |material| {
        material.color = material.color.or(own);
        material.set_number(which, value);
    });
}

pub(crate) fn material_text(env: &mut Env, shape: &mut Shape, which: MaterialText, value: Text) {
    if which.accepts(&value) {
        let value = match which {
            MaterialText::Map(layer) => crate::op::image(env, layer, value).0,
            _ => value,
        };
        change_material(env, shape, |material| material.set_text(which, value));
    } else {
        env.fault(
            FaultKind::Value,
            format!("`{}` is not a mode of an opacity map; the mode stays as it is", shown(&value)),
        );
    }
}

/// `material.color.rgb`, in the form for `color` (*material.color attribute*).
pub fn material_color_rgb(env: &mut Env, shape: &mut Shape, value: Text) {
    crate::op::color_hex(env, shape, value);
}

/// `material.doubleSided` (*material attribute*).
pub fn material_double_sided(env: &mut Env, shape: &mut Shape, value: bool) {
    change_material(env, shape, |material| material.double_sided = Some(value));
}

/// `trim.vertical`, for this shape and its descendants (*trim attribute*).
pub fn trim_vertical(_: &mut Env, shape: &mut Shape, value: bool) {
    shape.state.change().trim.vertical = value;
}

/// `trim.horizontal`, for this shape and its descendants (*trim attribute*).
pub fn trim_horizontal(_: &mut Env, shape: &mut Shape, value: bool) {
    shape.state.change().trim.horizontal = value;
}

/// `seedian`: restarts the random numbers of this shape and of the shapes derived from it afterwards (*seedian
/// attribute*). Equal seeds give equal numbers. A number that is not an integer gives its own seed, which reads as
/// another number.
pub fn seedian(env: &mut Env, shape: &mut Shape, value: f64) {
    let value = env.finite(value, "the seed");
    let whole = value.fract() == 0.0 && value.abs() <= get::SEED_MAX as f64;
    shape.seed = Seed::set(if whole { value as i64 as u64 } else { Seed::new(value.to_bits()).scattered() });
}

// *pivot attribute*: in object coordinates. The scope is relative to the pivot and keeps its translation and
// rotation, so the shape moves with it.
numbers! { (set_pivot_position)
    /// The x coordinate of the pivot.
    pivot_px = x;
    /// The y coordinate of the pivot.
    pivot_py = y;
    /// The z coordinate of the pivot.
    pivot_pz = z;
}

numbers! { (set_pivot_rotation)
    /// The rotation of the pivot about x, in degrees.
    pivot_ox = x;
    /// The rotation of the pivot about y, in degrees.
    pivot_oy = y;
    /// The rotation of the pivot about z, in degrees.
    pivot_oz = z;
}

fn set_pivot_position(env: &mut Env, shape: &mut Shape, value: f64, at: CoordinateOf) {
    let mut position = get::pivot_position(env, shape);
    *at(&mut position) = env.finite(value, "the pivot");
    move_pivot(env, shape, position, get::pivot_rotation(env, shape));
}

fn set_pivot_rotation(env: &mut Env, shape: &mut Shape, value: f64, at: CoordinateOf) {
    let mut rotation = get::pivot_rotation(env, shape);
    *at(&mut rotation) = env.finite(value, "the pivot");
    move_pivot(env, shape, get::pivot_position(env, shape), rotation);
}

fn move_pivot(env: &mut Env, shape: &mut Shape, position: DVec3, rotation: DVec3) {
    let object = &env.initial.object;
    let offset = shape.pivot.to_local(shape.scope.origin);
    let turned = shape.pivot.axes.transpose() * shape.scope.axes;
    let pivot =
        Frame { origin: object.to_world(position), axes: object.axes * turn(rotation.x, rotation.y, rotation.z) };
    let scope = Scope { origin: pivot.to_world(offset), axes: pivot.axes * turned, size: shape.scope.size };
    if !(pivot.origin.is_finite() && scope.is_bounded()) {
        return env.fault(FaultKind::Value, "the pivot overflows; the shape stays as it is");
    }
    let before = shape.scope;
    shape.set_pivot(pivot);
    shape.scope = scope;
    shape.carry(&before);
}

/// Sets an attribute of the grammar, for this shape and its descendants.
pub fn attribute(shape: &mut Shape, number: u32, value: Value) {
    let attributes = &mut shape.state.change().attributes;
    // They usually come in order.
    if attributes.last().is_none_or(|(last, _)| *last < number) {
        return attributes.push((number, value));
    }
    match attributes.binary_search_by_key(&number, |(id, _)| *id) {
        Ok(at) => attributes[at].1 = value,
        Err(at) => attributes.insert(at, (number, value)),
    }
}

/// Removes values of attributes and constants. The numbers are sorted.
pub(crate) fn forget(shape: &mut Shape, numbers: &[u32]) {
    shape.state.change().attributes.retain(|(number, _)| numbers.binary_search(number).is_err());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::op::Length::Absolute;
    use crate::op::{rotate, translate};
    use crate::run::settings::{Limits, Settings};
    use crate::shape::Shape;

    #[test]
    fn materials_that_rules_make_count_for_the_limit_of_bytes() {
        let room = 1_000_000;
        let made = |name: &str, change: fn(&mut Env, &mut Shape, f64)| {
            let limits = Limits { bytes: room + Limits::BYTES_A_SHAPE, ..Limits::default() };
            let settings = Settings { limits, ..Settings::default() };
            let (mut shape, mut count) = (Shape::cuboid(1.0, 1.0, 1.0), 0u32);
            let env = &mut Env::with_names(&settings, &["Lot"], &shape, "Lot");
            shape.change_material(|material| material.name = Some(name.into()));
            env.shapes = 1;
            while !env.ended() {
                change(env, &mut shape, 1.0 / f64::from(count + 1));
                count += 1;
            }
            u64::from(count) - 1
        };
        assert_eq!(made("", material_opacity), room / Limits::BYTES_A_LOOK);
        assert_eq!(made(&"n".repeat(5000), material_opacity), room / (Limits::BYTES_A_LOOK + 5000));
        let color: fn(&mut Env, &mut Shape, f64) =
            |env, shape, red| crate::op::color_rgba(env, shape, red, 0.0, 0.0, red);
        assert_eq!(made("", color), room / Limits::BYTES_A_LOOK);
    }

    #[test]
    fn every_material_attribute_reads_its_default_then_what_was_set() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0));
        macro_rules! numbers {
            ($($function:ident $name:literal $which:expr;)*) => {$(
                if $name != "opacity" {
                    assert_eq!(get::$function(shape), $which.default_value(), $name);
                    for (value, expected) in [(0.25, 0.25), (1e9, $which.clamp(1e9)), (f64::NAN, 0.0)] {
                        $function(env, shape, value);
                        assert_eq!(get::$function(shape), expected, $name);
                    }
                    assert_eq!(env.take_faults().0.len(), 1, $name);
                }
            )*};
        }
        macro_rules! texts {
            ($($function:ident $name:literal $which:expr;)*) => {$(
                assert_eq!(get::$function(shape).as_str(), $which.default_value(), $name);
                $function(env, shape, "opaque".into());
                assert_eq!(get::$function(shape).as_str(), "opaque", $name);
            )*};
        }
        each_material_number!(numbers);
        each_material_text!(texts);
        // No file has the name that the maps were given: colours become checkers, and other maps are left out.
        assert_eq!(env.take_faults().0.len(), 2);
        assert_eq!((get::material_opacity(shape), get::material_double_sided(shape)), (0.0, true));
        assert_eq!(get::material_color_rgb(shape).as_str(), "#000000");
        material_color_rgb(env, shape, "#0a5fff".into());
        assert_eq!(get::material_color_rgb(shape).as_str(), "#0a5fff");
        material_color_rgb(env, shape, "red".into());
        assert_eq!((get::material_color_rgb(shape).as_str(), env.take_faults().0.len()), ("#0a5fff", 1));
    }

    #[test]
    fn a_seed_that_is_set_is_read_and_repeats_its_numbers() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0).seed(7));
        assert_eq!(get::seedian(shape), 7.0);
        let mut drawn = |env: &mut Env, value: f64| {
            seedian(env, shape, value);
            (get::seedian(shape), shape.seed.draw(), shape.seed.child(crate::shape::seed::Tag::Push, 0).value())
        };
        for value in [0.0, -3.0, 9_007_199_254_740_992.0] {
            let first = drawn(env, value);
            assert_eq!((first.0, first), (value, drawn(env, value)));
        }
        assert_ne!(drawn(env, 1.0).1, drawn(env, 2.0).1);
        // A number that is not an integer: its own seed, which reads as itself.
        let odd = drawn(env, 0.5);
        assert_eq!((odd.0.fract(), odd), (0.0, drawn(env, odd.0)));
        assert_ne!(odd.1, drawn(env, 0.25).1);
        assert_eq!(drawn(env, f64::NAN).0, 0.0);
        assert_eq!(env.take_faults().0.len(), 1);
    }

    #[test]
    fn attributes_are_found_in_whatever_order_they_were_set() {
        let shape = &mut Shape::cuboid(1.0, 1.0, 1.0);
        for number in [5, 2, 9, 0, 7, 2, 5] {
            attribute(shape, number, Value::Float(f64::from(number) + 0.5));
            attribute(shape, number, Value::Float(f64::from(number)));
        }
        let read: Vec<f64> = (0..11).map(|number| get::float_attribute(shape, number, -1.0)).collect();
        assert_eq!(read, [0.0, -1.0, 2.0, -1.0, -1.0, 5.0, -1.0, 7.0, -1.0, 9.0, -1.0]);
    }

    #[test]
    fn trim_switches_are_inherited() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0));
        assert!(get::trim_vertical(shape) && !get::trim_horizontal(shape));
        trim_vertical(env, shape, false);
        trim_horizontal(env, shape, true);
        let child = &mut shape.clone();
        assert!(!get::trim_vertical(child) && get::trim_horizontal(child));
        trim_horizontal(env, child, false);
        assert!(get::trim_horizontal(shape));
    }

    /// A lot away from the origin, and a run that starts with it.
    fn moved() -> (Env, Shape) {
        let outline = [[10.0, 5.0], [14.0, 8.0], [12.0, 1.0]];
        let shape = Shape::footprint(&outline, &[]).expect("a triangle").at([0.0, 3.0, 0.0]).named("Lot 7");
        (Env::with_names(&Settings::default(), &[], &shape, "Start"), shape)
    }

    #[test]
    fn a_fresh_shape_has_its_pivot_at_the_origin_of_object_coordinates() {
        let (env, shape) = &mut moved();
        assert_eq!(get::pivot_position(env, shape), DVec3::ZERO);
        assert_eq!(get::pivot_rotation(env, shape), DVec3::ZERO);
        assert_eq!((get::initial_shape_origin_px(env, shape), get::initial_shape_origin_py(env, shape)), (10.0, 3.0));
        let turned = get::initial_shape_origin_oy(env, shape);
        assert!((turned - libm::atan2(-3.0, 4.0).to_degrees()).abs() < 1e-9, "{turned}");
        assert_eq!(get::initial_shape_name(env, shape).as_str(), "Lot 7");
        assert_eq!(get::initial_shape_start_rule(env, shape).as_str(), "Start");
    }

    #[test]
    fn the_shape_goes_with_its_pivot() {
        let (env, shape) = &mut moved();
        translate(env, shape, Absolute(1.0), Absolute(2.0), Absolute(3.0));
        rotate(env, shape, 10.0, 20.0, 30.0);
        let state = |shape: &Shape| {
            let rotation = [get::scope_rx(shape), get::scope_ry(shape), get::scope_rz(shape)];
            [[get::scope_tx(shape), get::scope_ty(shape), get::scope_tz(shape)], rotation].concat()
        };
        let before = state(shape);
        pivot_py(env, shape, 5.0);
        pivot_oy(env, shape, 90.0);
        pivot_px(env, shape, -1.0);
        assert!((get::pivot_position(env, shape) - DVec3::new(-1.0, 5.0, 0.0)).length() < 1e-9);
        assert!((get::pivot_rotation(env, shape) - DVec3::new(0.0, 90.0, 0.0)).length() < 1e-9);
        assert!(state(shape).iter().zip(&before).all(|(a, b)| (a - b).abs() < 1e-9));
        assert!(shape.check().is_ok());
        pivot_pz(env, shape, f64::MAX);
        assert!(shape.check().is_ok() && shape.pivot.origin.is_finite());
        pivot_pz(env, shape, f64::INFINITY);
        assert!(get::pivot_position(env, shape).z.abs() < 1e-6);
    }
}
