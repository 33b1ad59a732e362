//! `set` of an attribute whose name is computed (*sel function*).

use super::set;
use crate::fault::FaultKind;
use crate::material::{MaterialNumber, MaterialText};
use crate::run::env::Env;
use crate::shape::Shape;
use crate::value::Value;
use crate::value::shown::shown;
use crate::value::text::Text;

/// Sets a number.
type SetNumber = fn(&mut Env, &mut Shape, f64);

/// The numbers of shapes that can be set, without the material.
const NUMBERS: &[(&str, SetNumber)] = &[
    ("scope.sx", set::scope_sx),
    ("scope.sy", set::scope_sy),
    ("scope.sz", set::scope_sz),
    ("scope.tx", set::scope_tx),
    ("scope.ty", set::scope_ty),
    ("scope.tz", set::scope_tz),
    ("scope.rx", set::scope_rx),
    ("scope.ry", set::scope_ry),
    ("scope.rz", set::scope_rz),
    ("pivot.px", set::pivot_px),
    ("pivot.py", set::pivot_py),
    ("pivot.pz", set::pivot_pz),
    ("pivot.ox", set::pivot_ox),
    ("pivot.oy", set::pivot_oy),
    ("pivot.oz", set::pivot_oz),
    ("seedian", set::seedian),
];

/// An attribute of shapes that can be set.
enum Settable {
    Number(SetNumber),
    MaterialNumber(MaterialNumber),
    MaterialText(MaterialText),
    Color,
    DoubleSided,
    TrimVertical,
    TrimHorizontal,
}

impl Settable {
    fn named(name: &str) -> Option<Self> {
        if let Some((_, number)) = NUMBERS.iter().find(|(known, _)| *known == name) {
            return Some(Settable::Number(*number));
        }
        let material = match name {
            "trim.vertical" => return Some(Settable::TrimVertical),
            "trim.horizontal" => return Some(Settable::TrimHorizontal),
            _ => name.strip_prefix("material.")?,
        };
        match material {
            "color.rgb" => Some(Settable::Color),
            "doubleSided" => Some(Settable::DoubleSided),
            // Old names.
            "map3" => MaterialText::named("specularmap").map(Settable::MaterialText),
            "map4" => MaterialText::named("opacitymap").map(Settable::MaterialText),
            "map5" => MaterialText::named("normalmap").map(Settable::MaterialText),
            _ => {
                let number = MaterialNumber::named(material).map(Settable::MaterialNumber);
                number.or_else(|| MaterialText::named(material).map(Settable::MaterialText))
            }
        }
    }
}

/// `set(sel(selString), value)`: sets the attribute of shapes with a name. A name that is unknown or cannot be set is a fault, and so is a value
/// of another type. Names of attributes of a grammar are not known in a run. Images are named as in `setMaterial`.
pub fn set_by_name(env: &mut Env, shape: &mut Shape, name: Text, value: impl Into<Value>) {
    let Some(settable) = Settable::named(&name) else {
        let message =
            format!("`{}` is not an attribute of shapes that can be set; the shape stays as it is", shown(&name));
        return env.fault(FaultKind::Value, message);
    };
    let needs = match (settable, value.into()) {
        (Settable::Number(set), Value::Float(value)) => return set(env, shape, value),
        (Settable::MaterialNumber(which), Value::Float(value)) => {
            return set::material_number(env, shape, which, value);
        }
        (Settable::MaterialText(which), Value::Text(value)) => return set::material_text(env, shape, which, value),
        (Settable::Color, Value::Text(value)) => return set::material_color_rgb(env, shape, value),
        (Settable::DoubleSided, Value::Bool(value)) => return set::material_double_sided(env, shape, value),
        (Settable::TrimVertical, Value::Bool(value)) => return set::trim_vertical(env, shape, value),
        (Settable::TrimHorizontal, Value::Bool(value)) => return set::trim_horizontal(env, shape, value),
        (Settable::Number(_) | Settable::MaterialNumber(_), _) => "a number",
        (Settable::MaterialText(_) | Settable::Color, _) => "text",
        (Settable::DoubleSided | Settable::TrimVertical | Settable::TrimHorizontal, _) => "true or false",
    };
    let message = format!("`{}` is {needs}, and the value has another type; the shape stays as it is", shown(&name));
    env.fault(FaultKind::Value, message);
}
