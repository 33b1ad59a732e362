//! Lots from the polygons of a GeoJSON file, in metres around their middle.

use cga::{Error, Grammar, Settings, Shape, Text, Value, ValueType};
use geo_types::{Coord, LineString, Polygon};
use geojson::{Feature, GeometryValue, JsonValue, Position};

use crate::features::features;

/// Notes about a file for its user.
#[derive(Debug, Default)]
pub(crate) struct Notes {
    pub(crate) list: Vec<String>,
    /// True if a note is about a mistake: a polygon that is not a lot, or a value that is refused.
    pub(crate) has_mistakes: bool,
}

impl Notes {
    fn add(&mut self, note: String) {
        self.list.push(note);
    }

    fn mistake(&mut self, note: String) {
        self.list.push(note);
        self.has_mistakes = true;
    }
}

/// The lots of a file, with a note for each feature or part of one that has none and for each property that is not read. Lots have seeds from `seed` on, in
/// the order of the file: each polygon counts, so that lots keep their seeds if others cannot be used. The list may be empty.
///
/// # Errors
/// The text is not GeoJSON, or its coordinates are not degrees.
pub(crate) fn lots(text: &str, grammar: &dyn Grammar, seed: u64, notes: &mut Notes) -> Result<Vec<Shape>, String> {
    let features = features(text)?;
    // The number of a polygon in the file and the number of its feature. A feature that cannot be read counts as one polygon.
    let mut polygons: Vec<(u64, usize, Polygon)> = Vec::new();
    let mut count = 0;
    for (number, feature) in features.iter().enumerate() {
        match feature.as_ref().map_err(Clone::clone).map(of_feature) {
            Ok(Polygons::Of(parts)) => {
                for kind in parts.others {
                    notes.add(format!("{}: a {kind} of its collection is left out", label(feature, number)));
                }
                for polygon in parts.polygons {
                    polygons.push((count, number, polygon));
                    count += 1;
                }
            }
            Ok(Polygons::None(why)) => notes.add(format!("{} is left out: {why}", label(feature, number))),
            Ok(Polygons::Wrong(why)) | Err(why) => {
                count += 1;
                notes.mistake(format!("{} is left out: {why}", label(feature, number)));
            }
        }
    }
    let all = polygons.iter().map(|(_, _, polygon)| polygon);
    let in_degrees: Vec<&Polygon> = all.clone().filter(|polygon| is_in_degrees(polygon)).collect();
    // Some wrong corners are mistakes of their polygons; more are another coordinate system.
    let place = if 2 * in_degrees.len() < polygons.len() { Place::of(all) } else { Place::of(in_degrees.into_iter()) }?;
    place.note().into_iter().for_each(|note| notes.add(note));
    let mut lots = Vec::new();
    for (at, number, polygon) in polygons {
        let Ok(feature) = &features[number] else { continue };
        let name = || label(&features[number], number);
        if !is_in_degrees(&polygon) {
            notes.mistake(format!(
                "{} is left out: its coordinates are not longitudes and latitudes in degrees",
                name()
            ));
            continue;
        }
        match Shape::try_from(&place.metres(&polygon)) {
            Ok(shape) => {
                let shape = shape.seed(seed.wrapping_add(at));
                let shape = named(shape, feature);
                let mut note = |why| notes.mistake(format!("{}: {why}", name()));
                lots.push(with_values(shape, feature, grammar, &mut note));
            }
            Err(why) => notes.mistake(format!("{} is left out: {why}", name())),
        }
    }
    Ok(lots)
}

/// Returns true if all corners are a longitude and a latitude.
fn is_in_degrees(polygon: &Polygon) -> bool {
    let mut corners = polygon.exterior().coords().chain(polygon.interiors().iter().flat_map(LineString::coords));
    corners.all(|corner| corner.x.abs() <= 180.0 && corner.y.abs() <= 90.0)
}

/// The polygons of a feature, or the reason why it has none.
enum Polygons {
    Of(Parts),
    /// The feature has no polygon, as points and lines of a map.
    None(String),
    /// The feature is broken.
    Wrong(String),
}

/// The polygons of a feature.
fn of_feature(feature: &Feature) -> Polygons {
    let Some(geometry) = &feature.geometry else { return Polygons::None("it has no geometry".to_owned()) };
    let mut parts = Parts::default();
    if let Err(why) = parts.add(geometry) {
        return Polygons::Wrong(why);
    }
    match &geometry.value {
        _ if !parts.polygons.is_empty() => Polygons::Of(parts),
        GeometryValue::MultiPolygon { .. } | GeometryValue::GeometryCollection { .. } => {
            Polygons::None("it has no polygon".to_owned())
        }
        other => Polygons::None(format!("a {} is not a polygon", other.type_name())),
    }
}

/// The parts of a geometry.
#[derive(Default)]
struct Parts {
    polygons: Vec<Polygon>,
    /// The kinds of its other parts, each once.
    others: Vec<&'static str>,
}

impl Parts {
    /// Adds a geometry, and each geometry of a collection. JSON is at most 128 lists deep.
    ///
    /// # Errors
    /// A reason: a polygon is broken.
    fn add(&mut self, geometry: &geojson::Geometry) -> Result<(), String> {
        match &geometry.value {
            GeometryValue::Polygon { coordinates } => self.polygons.push(polygon(coordinates)?),
            GeometryValue::MultiPolygon { coordinates } => {
                for rings in coordinates {
                    self.polygons.push(polygon(rings)?);
                }
            }
            GeometryValue::GeometryCollection { geometries } => {
                geometries.iter().try_for_each(|inner| self.add(inner))?;
            }
            other if !self.others.contains(&other.type_name()) => self.others.push(other.type_name()),
            _ => {}
        }
        Ok(())
    }
}

/// The polygon of some rings: its outline, then its holes.
///
/// # Errors
/// A reason: a corner is not a place.
fn polygon(rings: &[Vec<Position>]) -> Result<Polygon, String> {
    let corner = |position: &Position| match position.as_slice() {
        [x, y, ..] => Ok(Coord { x: *x, y: *y }),
        [_] => Err("a corner has one number; write a longitude and a latitude".to_owned()),
        [] => Err("a corner has no numbers; write a longitude and a latitude".to_owned()),
    };
    let ring = |ring: &Vec<Position>| ring.iter().map(corner).collect::<Result<LineString, String>>();
    let mut rings = rings.iter().map(ring).collect::<Result<Vec<_>, _>>()?.into_iter();
    Ok(Polygon::new(rings.next().unwrap_or_else(LineString::empty), rings.collect()))
}

/// A feature in a note. Features without an id count from 1.
fn label(feature: &Result<Feature, String>, number: usize) -> String {
    match feature.as_ref().ok().and_then(id) {
        Some(id) => format!("feature `{id}`"),
        None => format!("feature {}", number + 1),
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

/// Gives a lot the values of properties that are attributes of the grammar, with a note for each property that has another type or that
/// the grammar refuses.
fn with_values(shape: Shape, feature: &Feature, grammar: &dyn Grammar, note: &mut dyn FnMut(String)) -> Shape {
    let Some(properties) = &feature.properties else { return shape };
    let mut values: Vec<(Text, Value)> = Vec::new();
    for attribute in grammar.attributes() {
        let Some(given) = properties.get(attribute.name.as_str()).filter(|given| !given.is_null()) else { continue };
        match value(given, attribute.ty) {
            Some(value) => values.push((attribute.name.clone(), value)),
            None => note(format!("its property `{}` is left out: {given} is not {}", attribute.name, attribute.ty)),
        }
    }
    let with = |shape: &Shape, (name, value): &(Text, Value)| shape.clone().attribute(name.clone(), value.clone());
    let all = values.iter().fold(shape.clone(), |shape, value| with(&shape, value));
    if values.is_empty() || refusal(&all, grammar).is_none() {
        return all;
    }
    // Values may be the choices of others, so they are tried again while one is taken.
    let mut lot = shape;
    loop {
        let before = values.len();
        values.retain(|value| {
            let tried = with(&lot, value);
            let is_refused = refusal(&tried, grammar).is_some();
            if !is_refused {
                lot = tried;
            }
            is_refused
        });
        if values.is_empty() || values.len() == before {
            break;
        }
    }
    for value in &values {
        let why = refusal(&with(&lot, value), grammar).unwrap_or_default();
        note(format!("its property `{}` is left out: {why}", value.0));
    }
    lot
}

/// The reason why the grammar refuses a value of a lot.
fn refusal(lot: &Shape, grammar: &dyn Grammar) -> Option<String> {
    match grammar.used_values(lot, &Settings::default()) {
        Err(Error::Lot { problems, .. }) => Some(problems.join("; ")),
        _ => None,
    }
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
    /// The degrees from the middle to the sides of the box around all lots.
    reach: Coord,
    /// True if the box crosses the meridian of 180 degrees: longitudes in the west count on from 180.
    is_across: bool,
}

/// The largest error of distances that needs no note.
const SMALL_ERROR: f64 = 0.01;

/// The largest reach in metres that needs no note.
const NEAR: f64 = 500_000.0;

impl Place {
    /// The middle of the box around some polygons.
    fn of<'p>(polygons: impl Iterator<Item = &'p Polygon>) -> Result<Self, String> {
        let points: Vec<Coord> = polygons.flat_map(|polygon| polygon.exterior().coords()).copied().collect();
        let (low, high) = bounds(points.iter().copied());
        if low.x < -180.0 || 180.0 < high.x || low.y < -90.0 || 90.0 < high.y {
            return Err(format!(
                "coordinates from ({}, {}) to ({}, {}) are not longitudes and latitudes in degrees, as GeoJSON has them; \
                 convert the file to EPSG:4326 first",
                low.x, low.y, high.x, high.y
            ));
        }
        let across = bounds(points.into_iter().map(counted_on));
        let is_across = 180.0 < high.x - low.x && across.1.x - across.0.x < high.x - low.x;
        let (low, high) = if is_across { across } else { (low, high) };
        let middle = (low + high) / 2.0;
        Ok(Place { middle, degree: metres_a_degree(middle.y), reach: (high - low) / 2.0, is_across })
    }

    /// A note about lots that are too far from each other for a flat map.
    fn note(&self) -> Option<String> {
        let metres = Coord { x: self.reach.x * self.degree.x, y: self.reach.y * self.degree.y };
        let sides = [self.middle.y - self.reach.y, self.middle.y + self.reach.y].map(|side| metres_a_degree(side).x);
        let error = sides.into_iter().map(|side| (self.degree.x / side - 1.0).abs()).fold(0.0, f64::max);
        let far = metres.x.max(metres.y);
        (SMALL_ERROR < error || NEAR < far).then(|| {
            let percent = (100.0 * error).min(999.0);
            // Along the equator, only the heights are wrong.
            let wrong = match percent < 1.0 {
                true => String::new(),
                false => format!(", where lengths to the east are wrong by up to {percent:.0} %"),
            };
            let far = far / 1000.0;
            format!("the lots are up to {far:.0} km from their middle{wrong}: the Earth is taken as flat; run each town by itself")
        })
    }

    /// A polygon in metres to the east and to the north of the middle.
    fn metres(&self, polygon: &Polygon) -> Polygon {
        let moved = |point: &Coord| {
            let point = if self.is_across { counted_on(*point) } else { *point };
            Coord { x: (point.x - self.middle.x) * self.degree.x, y: (point.y - self.middle.y) * self.degree.y }
        };
        let ring = |ring: &LineString| -> LineString { ring.coords().map(moved).collect() };
        Polygon::new(ring(polygon.exterior()), polygon.interiors().iter().map(ring).collect())
    }
}

/// A point whose longitude counts from 0 to 360 degrees.
fn counted_on(point: Coord) -> Coord {
    if point.x < 0.0 { Coord { x: point.x + 360.0, ..point } } else { point }
}

/// The corners of the box around points.
fn bounds(points: impl Iterator<Item = Coord>) -> (Coord, Coord) {
    let (mut low, mut high) =
        (Coord { x: f64::INFINITY, y: f64::INFINITY }, Coord { x: f64::NEG_INFINITY, y: f64::NEG_INFINITY });
    for point in points {
        (low.x, low.y) = (low.x.min(point.x), low.y.min(point.y));
        (high.x, high.y) = (high.x.max(point.x), high.y.max(point.y));
    }
    (low, high)
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
