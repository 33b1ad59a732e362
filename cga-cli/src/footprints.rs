//! Lots from the polygons of a GeoJSON file, in metres around their middle.

use cga::{Grammar, Shape, Value, ValueType};
use geo_types::{Coord, Geometry, LineString, MultiPolygon, Polygon};
use geojson::{Feature, GeoJson, JsonValue};

/// The lots of a file, and a note for each feature that has none and for each property that is not read. Lots have seeds from `seed` on, in
/// the order of the file: each polygon counts, so that lots keep their seeds if others cannot be used.
///
/// # Errors
/// The text is not GeoJSON, its coordinates are not degrees, or no feature has a lot.
pub(crate) fn lots(text: &str, grammar: &dyn Grammar, seed: u64) -> Result<(Vec<Shape>, Vec<String>), String> {
    // Some programs begin a file with a mark of its encoding.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let file: GeoJson = text.parse().map_err(|why| format!("it is not GeoJSON: {why}"))?;
    let features = match file {
        GeoJson::FeatureCollection(collection) => collection.features,
        GeoJson::Feature(feature) => vec![feature],
        GeoJson::Geometry(geometry) => vec![Feature::from(geometry)],
    };
    let mut notes = Vec::new();
    let mut polygons: Vec<(usize, Polygon)> = Vec::new();
    for (number, feature) in features.iter().enumerate() {
        match of_feature(feature) {
            Ok(list) => polygons.extend(list.0.into_iter().map(|polygon| (number, polygon))),
            Err(why) => notes.push(format!("{} is left out: {why}", label(feature, number))),
        }
    }
    let place = Place::of(polygons.iter().map(|(_, polygon)| polygon))?;
    let mut lots = Vec::new();
    for (at, (number, polygon)) in (0..).zip(polygons) {
        let feature = &features[number];
        match Shape::try_from(&place.metres(&polygon)) {
            Ok(shape) => {
                let shape = shape.seed(seed.wrapping_add(at));
                let shape = named(shape, feature);
                let mut note = |why| notes.push(format!("{}: {why}", label(feature, number)));
                lots.push(with_values(shape, feature, grammar, &mut note));
            }
            Err(why) => notes.push(format!("{} is left out: {why}", label(feature, number))),
        }
    }
    if lots.is_empty() {
        let notes: String = notes.iter().map(|note| format!("\n  {note}")).collect();
        return Err(format!("no feature is a polygon that can be a lot{notes}"));
    }
    Ok((lots, notes))
}

/// The polygons of a feature.
fn of_feature(feature: &Feature) -> Result<MultiPolygon, String> {
    let geometry = feature.geometry.as_ref().ok_or("it has no geometry")?;
    let kind = geometry.value.type_name();
    match Geometry::<f64>::try_from(geometry) {
        Ok(Geometry::Polygon(polygon)) => Ok(polygon.into()),
        Ok(Geometry::MultiPolygon(list)) => Ok(list),
        Ok(_) => Err(format!("a {kind} is not a polygon")),
        Err(why) => Err(why.to_string()),
    }
}

/// A feature in a note.
fn label(feature: &Feature, number: usize) -> String {
    match id(feature) {
        Some(id) => format!("feature `{id}`"),
        None => format!("feature {number}"),
    }
}

fn id(feature: &Feature) -> Option<String> {
    match feature.id.as_ref()? {
        geojson::feature::Id::String(id) => Some(id.clone()),
        geojson::feature::Id::Number(id) => Some(id.to_string()),
    }
}

/// Gives a lot the id of its feature as its name.
fn named(shape: Shape, feature: &Feature) -> Shape {
    match id(feature) {
        Some(id) => shape.named(id),
        None => shape,
    }
}

/// Gives a lot the values of properties that are attributes of the grammar, with a note for each property of another type.
fn with_values(shape: Shape, feature: &Feature, grammar: &dyn Grammar, note: &mut dyn FnMut(String)) -> Shape {
    let Some(properties) = &feature.properties else { return shape };
    let given = grammar.attributes().iter().filter_map(|attribute| {
        let given = properties.get(attribute.name.as_str()).filter(|given| !given.is_null())?;
        let read = value(given, attribute.ty);
        if read.is_none() {
            note(format!("its property `{}` is left out: {given} is not {}", attribute.name, attribute.ty));
        }
        Some((attribute.name.clone(), read?))
    });
    given.fold(shape, |shape, (name, value)| shape.attribute(name, value))
}

/// The value of a property. Maps often have numbers as text.
fn value(given: &JsonValue, ty: ValueType) -> Option<Value> {
    match given {
        JsonValue::Number(number) if ty == ValueType::Float => number.as_f64().map(Value::Float),
        JsonValue::Number(number) => Value::parse(&Value::Float(number.as_f64()?).to_string(), ty),
        JsonValue::String(text) => Value::parse(text, ty),
        JsonValue::Bool(truth) => Value::parse(&truth.to_string(), ty),
        JsonValue::Array(_) if ty != ValueType::Text => Value::parse(&given.to_string(), ty),
        JsonValue::Null | JsonValue::Array(_) | JsonValue::Object(_) => None,
    }
}

/// The middle of all lots. Around it the Earth is taken as flat.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    middle: Coord,
    /// The metres in a degree to the east and to the north.
    degree: Coord,
}

impl Place {
    /// The middle of the box around some polygons.
    fn of<'p>(polygons: impl Iterator<Item = &'p Polygon>) -> Result<Self, String> {
        let (mut low, mut high) =
            (Coord { x: f64::INFINITY, y: f64::INFINITY }, Coord { x: f64::NEG_INFINITY, y: f64::NEG_INFINITY });
        for point in polygons.flat_map(|polygon| polygon.exterior().coords()) {
            (low.x, low.y) = (low.x.min(point.x), low.y.min(point.y));
            (high.x, high.y) = (high.x.max(point.x), high.y.max(point.y));
        }
        if low.x < -180.0 || 180.0 < high.x || low.y < -90.0 || 90.0 < high.y {
            return Err(format!(
                "coordinates from ({}, {}) to ({}, {}) are not longitudes and latitudes in degrees, as GeoJSON has them; \
                 convert the file to EPSG:4326 first",
                low.x, low.y, high.x, high.y
            ));
        }
        let middle = (low + high) / 2.0;
        Ok(Place { middle, degree: metres_a_degree(middle.y) })
    }

    /// A polygon in metres to the east and to the north of the middle.
    fn metres(&self, polygon: &Polygon) -> Polygon {
        let moved = |point: &Coord| Coord {
            x: (point.x - self.middle.x) * self.degree.x,
            y: (point.y - self.middle.y) * self.degree.y,
        };
        let ring = |ring: &LineString| -> LineString { ring.coords().map(moved).collect() };
        Polygon::new(ring(polygon.exterior()), polygon.interiors().iter().map(ring).collect())
    }
}

/// The metres to the east in a degree of longitude and to the north in a degree of latitude, on the ellipsoid WGS 84. Computed with `libm`,
/// so that all platforms have the same lots.
fn metres_a_degree(latitude: f64) -> Coord {
    const EQUATOR: f64 = 6_378_137.0;
    const FLATTENING: f64 = 1.0 / 298.257_223_563;
    const ECCENTRICITY_SQUARED: f64 = FLATTENING * (2.0 - FLATTENING);
    let (sin, cos) = (libm::sin(latitude.to_radians()), libm::cos(latitude.to_radians()));
    let squared = 1.0 - ECCENTRICITY_SQUARED * sin * sin;
    let east = EQUATOR / squared.sqrt() * cos;
    let north = EQUATOR * (1.0 - ECCENTRICITY_SQUARED) / (squared * squared.sqrt());
    Coord { x: east.to_radians(), y: north.to_radians() }
}
