//! Polygons from Python objects: coordinates, WKB, GeoJSON, and objects with `__geo_interface__`.

use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyBytes, PyDict, PyFloat, PyString};

use crate::outline::{MOST_CORNERS, Outline, too_many_corners};
use crate::value::{elements, plain, type_name};
use crate::wkb;

/// The polygons of a geometry.
///
/// # Errors
/// A sentence about the object.
pub(crate) fn outlines(given: &Bound<'_, PyAny>) -> Result<Vec<Outline>, String> {
    if let Ok(bytes) = given.cast::<PyBytes>() {
        return wkb::outlines(bytes.as_bytes());
    }
    if let Ok(bytes) = given.cast::<PyByteArray>() {
        return wkb::outlines(&bytes.to_vec());
    }
    if let Some(object) = geo_object(given)? {
        return geo_json(&object);
    }
    let rings = Rings { corners: 0 }.polygon(given)?;
    Ok(vec![rings])
}

/// The object of GeoJSON: a dict, its text, or the interface of another object.
pub(crate) fn geo_object<'py>(given: &Bound<'py, PyAny>) -> Result<Option<Bound<'py, PyDict>>, String> {
    if let Ok(object) = given.cast::<PyDict>() {
        return Ok(Some(object.clone()));
    }
    let object = if given.is_instance_of::<PyString>() {
        // Deep nesting is an exception there.
        let json = given.py().import("json").and_then(|json| json.call_method1("loads", (given,)));
        json.map_err(|why| format!("the text is not GeoJSON: {why}"))?
    } else {
        match given.getattr_opt("__geo_interface__").map_err(|why| why.to_string())? {
            Some(object) => object,
            None => return Ok(None),
        }
    };
    let wrong = |object: &Bound<'_, PyAny>| format!("{} is not an object of GeoJSON", type_name(object));
    object.cast::<PyDict>().map(|object| Some(object.clone())).map_err(|_| wrong(&object))
}

/// The type of an object of GeoJSON.
pub(crate) fn geo_type(object: &Bound<'_, PyDict>) -> Result<String, String> {
    member(object, "type")?
        .and_then(|name| name.extract::<String>().ok())
        .ok_or_else(|| "an object of GeoJSON needs the member `type`".to_owned())
}

/// A member of an object, without null.
pub(crate) fn member<'py>(object: &Bound<'py, PyDict>, name: &str) -> Result<Option<Bound<'py, PyAny>>, String> {
    let found = object.get_item(name).map_err(|why| why.to_string())?;
    Ok(found.filter(|found| !found.is_none()))
}

/// The polygons of a geometry or of a feature.
pub(crate) fn geo_json(object: &Bound<'_, PyDict>) -> Result<Vec<Outline>, String> {
    let mut object = object.clone();
    let mut kind = geo_type(&object)?;
    if kind == "Feature" {
        let geometry = member(&object, "geometry")?.ok_or("it has no geometry")?;
        object = geometry.cast_into::<PyDict>().map_err(|_| "the geometry of a feature is an object")?;
        kind = geo_type(&object)?;
    }
    let coordinates = || member(&object, "coordinates")?.ok_or_else(|| "the geometry has no coordinates".to_owned());
    let mut rings = Rings { corners: 0 };
    match kind.as_str() {
        "Polygon" => Ok(vec![rings.polygon(&coordinates()?)?]),
        "MultiPolygon" => list(&coordinates()?)?.iter().map(|polygon| rings.polygon(polygon)).collect(),
        "FeatureCollection" => Err("a FeatureCollection has many lots; give it to `generate_all`".to_owned()),
        "Feature" => Err("a Feature is not a geometry".to_owned()),
        _ => Err(format!("a {kind} is not a polygon")),
    }
}

/// Reads rings and counts their corners.
struct Rings {
    corners: usize,
}

impl Rings {
    /// A polygon: one ring, or a list of rings of which the first is the outer one.
    fn polygon(&mut self, given: &Bound<'_, PyAny>) -> Result<Outline, String> {
        let rings = list(given)?;
        let mut outline = Outline::default();
        let is_ring = match rings.first() {
            Some(first) => list(first)?.first().is_some_and(is_number),
            None => true,
        };
        if is_ring {
            self.ring(&mut outline, &rings)?;
        } else {
            rings.iter().try_for_each(|ring| self.ring(&mut outline, &list(ring)?))?;
        }
        Ok(outline)
    }

    fn ring(&mut self, outline: &mut Outline, corners: &[Bound<'_, PyAny>]) -> Result<(), String> {
        self.corners += corners.len();
        if MOST_CORNERS < self.corners {
            return Err(too_many_corners());
        }
        outline.rings.push(Vec::with_capacity(corners.len()));
        corners.iter().enumerate().try_for_each(|(number, corner)| match *numbers(corner)? {
            [x, y] => {
                outline.add(x, y, None);
                Ok(())
            }
            [x, y, z, ..] => {
                outline.add(x, y, Some(z));
                Ok(())
            }
            _ => Err(format!("corner {number} of a ring needs x and y")),
        })
    }
}

fn is_number(given: &Bound<'_, PyAny>) -> bool {
    given.is_instance_of::<PyFloat>() || given.extract::<f64>().is_ok()
}

/// The numbers of a corner.
fn numbers(corner: &Bound<'_, PyAny>) -> Result<Vec<f64>, String> {
    let numbers = list(corner)?;
    let wrong = |number: &Bound<'_, PyAny>| format!("{} is not a coordinate", type_name(number));
    numbers.iter().take(4).map(|number| number.extract::<f64>().map_err(|_| wrong(number))).collect()
}

/// The elements of a list, a tuple, or an array of NumPy.
fn list<'py>(given: &Bound<'py, PyAny>) -> Result<Vec<Bound<'py, PyAny>>, String> {
    let given = plain(given)?;
    elements(&given).ok_or_else(|| {
        format!(
            "{} is not a polygon; give coordinates, WKB, GeoJSON, or an object with `__geo_interface__`",
            type_name(&given)
        )
    })
}
