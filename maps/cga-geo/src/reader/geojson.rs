//! GeoJSON: a collection, one feature, or features after each other, as in GeoJSON text sequences.

use std::io::{self, BufRead, Read as _, Seek, SeekFrom};

use ::geojson::{Feature, GeoJson, Geometry, GeometryValue, JsonObject, JsonValue, Position};

use super::json_objects::Part;
use super::json_records::JsonRecords;
use super::{FileCrs, MapFile, left_out};
use crate::column::ColumnValue;
use crate::outline::{Corner, Outline, twice_area};
use crate::row::{MOST_CORNERS, Row, too_many_corners};

/// The bytes at the end of a file where a member `crs` after the features is found.
const TAIL: u64 = 1 << 20;

/// Reads the features of a text. Without the old member `crs` of the collection or of the first feature, coordinates are degrees on WGS 84
/// (RFC 7946). After the features, the member is found in the last megabyte.
///
/// # Errors
/// The text does not begin as JSON does.
pub fn read(input: impl BufRead + Seek + 'static) -> Result<MapFile, String> {
    read_as(input, false)
}

/// Reads a text with a feature a line. A broken line is one lost row.
///
/// # Errors
/// Errors of the file system.
pub fn read_lines(input: impl BufRead + Seek + 'static) -> Result<MapFile, String> {
    read_as(input, true)
}

fn read_as(mut input: impl BufRead + Seek + 'static, is_lines: bool) -> Result<MapFile, String> {
    let tail = tail(&mut input).map_err(|why| why.to_string())?;
    let mut parts = JsonRecords::new(input, is_lines).peekable();
    let crs = match parts.peek() {
        Some(Part::Head(text)) => {
            serde_json::from_slice(text).ok().and_then(|head| crs(&head)).or_else(|| tail_crs(&tail))
        }
        Some(Part::Object(text)) => serde_json::from_slice(text).ok().and_then(|object| crs(&object)),
        Some(Part::End(why)) => return Err(why.clone()),
        Some(Part::Broken(_)) | None => None,
    };
    let crs = crs.unwrap_or(FileCrs::Epsg(4326));
    let is_degrees = crs == FileCrs::Epsg(4326);
    let objects = parts.filter(|part| !matches!(part, Part::Head(_)));
    let rows = (1..).zip(objects).map(move |(number, part)| match part {
        Part::Object(text) => row(number, &text, is_degrees),
        Part::Broken(why) => Row::new(number, Err(why)),
        Part::End(why) => Row::damaged_end(number, why),
        Part::Head(_) => unreachable!("they are left out"),
    });
    Ok(MapFile::new(rows, crs, None))
}

/// The last bytes of a text.
fn tail(input: &mut (impl BufRead + Seek)) -> io::Result<Vec<u8>> {
    let length = input.seek(SeekFrom::End(0))?;
    input.seek(SeekFrom::Start(length.saturating_sub(TAIL)))?;
    let mut tail = Vec::new();
    input.by_ref().take(TAIL).read_to_end(&mut tail)?;
    input.rewind()?;
    Ok(tail)
}

/// The coordinate system of a member `crs` after the list of features. The text from the member to the end is JSON after an opening brace;
/// a member of a feature is followed by more closing brackets.
fn tail_crs(tail: &[u8]) -> Option<FileCrs> {
    const MEMBER: &[u8] = b"\"crs\"";
    let places = tail.windows(MEMBER.len()).enumerate().rev().filter(|(_, word)| *word == MEMBER);
    // A text of a feature may have the word, too.
    places.take(100).find_map(|(at, _)| {
        let object = [b"{", &tail[at..]].concat();
        crs(&serde_json::from_slice(&object).ok()?)
    })
}

/// The coordinate system of the old member `crs` of an object.
fn crs(object: &JsonValue) -> Option<FileCrs> {
    let crs = object.get("crs").filter(|crs| !crs.is_null())?;
    let properties = &crs["properties"];
    if let Some(code) = properties["code"].as_u64().and_then(|code| u32::try_from(code).ok()) {
        return Some(FileCrs::Epsg(code));
    }
    let Some(name) = properties["name"].as_str() else {
        return Some(FileCrs::Unknown("without a name".to_owned()));
    };
    if name.ends_with(":CRS84") {
        return Some(FileCrs::Epsg(4326));
    }
    let code = name.rsplit(':').next().filter(|_| name.to_uppercase().contains("EPSG"));
    let code = code.and_then(|code| code.parse().ok());
    Some(code.map_or_else(|| FileCrs::Unknown(name.to_owned()), FileCrs::Epsg))
}

fn row(number: u64, text: &[u8], is_degrees: bool) -> Row {
    let feature = match std::str::from_utf8(text).map_err(|why| why.to_string()).and_then(feature) {
        Ok(feature) => feature,
        Err(why) => {
            let has_nan = text.windows(3).any(|word| word == b"NaN");
            let hint = if has_nan { "; `NaN` is not JSON" } else { "" };
            // A feature with a wrong geometry may have an id, by which its file is mended.
            let object: JsonValue = serde_json::from_slice(text).unwrap_or_default();
            let id = Some(&object["id"]).filter(|id| id.is_string() || id.is_number()).and_then(column);
            let columns = columns(object["properties"].as_object());
            let id = id.map(|id| id.to_string());
            return Row { id, columns, ..Row::new(number, Err(format!("it is not GeoJSON: {why}{hint}"))) };
        }
    };
    let id = feature.id.as_ref().map(|id| match id {
        ::geojson::feature::Id::String(id) => id.clone(),
        ::geojson::feature::Id::Number(id) => id.to_string(),
    });
    let columns = columns(feature.properties.as_ref());
    let mut notes = Vec::new();
    let outlines = match &feature.geometry {
        Some(geometry) => outlines(geometry, &mut notes),
        None => Err("it has no geometry".to_owned()),
    };
    if outlines.iter().flatten().any(|outline| is_clockwise(outline, is_degrees)) {
        notes.push(
            "its outline runs clockwise, but outlines of GeoJSON run counter-clockwise; it was turned".to_owned(),
        );
    }
    Row { id, columns, notes, ..Row::new(number, outlines) }
}

/// Returns true if the outer ring runs clockwise. A ring of more than half of the Earth crosses the meridian of 180 degrees instead.
fn is_clockwise(outline: &Outline, is_degrees: bool) -> bool {
    let Some(ring) = outline.rings.first() else { return false };
    let longitudes = ring.iter().map(|corner| corner[0]);
    let (west, east) = longitudes.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    if !(is_degrees && 180.0 < east - west && -180.0 <= west && east <= 180.0) {
        return twice_area(ring) < 0.0;
    }
    let beyond: Vec<Corner> = ring.iter().map(|&[x, y]| [if x < 0.0 { x + 360.0 } else { x }, y]).collect();
    twice_area(&beyond) < 0.0
}

fn feature(text: &str) -> Result<Feature, String> {
    match text.parse().map_err(|why: ::geojson::Error| why.to_string())? {
        GeoJson::Feature(feature) => Ok(feature),
        GeoJson::Geometry(geometry) => Ok(Feature::from(geometry)),
        GeoJson::FeatureCollection(_) => Err("a collection inside of a collection".to_owned()),
    }
}

fn columns(properties: Option<&JsonObject>) -> Vec<(String, ColumnValue)> {
    let columns = properties.into_iter().flatten();
    columns.filter_map(|(name, value)| Some((name.clone(), column(value)?))).collect()
}

fn column(value: &JsonValue) -> Option<ColumnValue> {
    match value {
        JsonValue::Null => None,
        JsonValue::Bool(truth) => Some(ColumnValue::Truth(*truth)),
        JsonValue::Number(number) => number.as_f64().map(ColumnValue::Number),
        JsonValue::String(text) => Some(ColumnValue::Text(text.clone())),
        JsonValue::Array(_) | JsonValue::Object(_) => Some(ColumnValue::Text(value.to_string())),
    }
}

fn outlines(geometry: &Geometry, notes: &mut Vec<String>) -> Result<Vec<Outline>, String> {
    let mut polygons = Vec::new();
    collect(&geometry.value, false, &mut polygons, notes)?;
    let count: usize = polygons.iter().copied().flatten().map(Vec::len).sum();
    if MOST_CORNERS < count {
        return Err(too_many_corners(count));
    }
    polygons.into_iter().map(|polygon| outline(polygon)).collect()
}

/// The polygons of a geometry, and a note for each other kind that a collection has beside them. JSON is at most 128 lists deep.
fn collect<'g>(
    geometry: &'g GeometryValue,
    is_inner: bool,
    polygons: &mut Vec<&'g Vec<Vec<Position>>>,
    notes: &mut Vec<String>,
) -> Result<(), String> {
    match geometry {
        GeometryValue::Polygon { coordinates } => polygons.push(coordinates),
        GeometryValue::MultiPolygon { coordinates } => polygons.extend(coordinates),
        GeometryValue::GeometryCollection { geometries } => {
            geometries.iter().try_for_each(|inner| collect(&inner.value, true, polygons, notes))?;
        }
        other if is_inner => {
            let note = left_out(other.type_name());
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
        other => return Err(format!("a {} is not a polygon", other.type_name())),
    }
    Ok(())
}

fn outline(polygon: &[Vec<Position>]) -> Result<Outline, String> {
    let corner = |position: &Position| -> Result<Corner, String> {
        match position.as_slice() {
            [x, y, ..] => Ok([*x, *y]),
            short => Err(format!("a corner has {} coordinates", short.len())),
        }
    };
    let rings = polygon.iter().map(|ring| ring.iter().map(corner).collect()).collect::<Result<_, _>>()?;
    let mut outline = Outline::new(rings);
    let heights = polygon.iter().take(1).flatten().filter_map(|position| position.as_slice().get(2));
    heights.for_each(|height| outline.lower_to(*height));
    Ok(outline)
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    fn rows(text: &'static str) -> Vec<Row> {
        read(Cursor::new(text)).expect("JSON").rows.collect()
    }

    #[test]
    fn features_have_ids_columns_and_heights() {
        let text = r#"{ "type": "FeatureCollection", "crs": { "properties": { "name": "urn:ogc:def:crs:EPSG::25832" } }, "features": [
            { "type": "Feature", "id": 7, "properties": { "h": 3.5, "name": "A", "none": null, "list": [1, 2] },
              "geometry": { "type": "Polygon", "coordinates": [[[0, 0, 5], [1, 0, 4], [1, 1, 6], [0, 0, 5]]] } } ] }"#;
        assert_eq!(read(Cursor::new(text)).unwrap().crs, FileCrs::Epsg(25832));
        let rows = rows(text);
        assert_eq!(rows[0].id.as_deref(), Some("7"));
        assert_eq!(rows[0].column("h"), Some(&ColumnValue::Number(3.5)));
        assert_eq!(rows[0].column("list"), Some(&ColumnValue::Text("[1,2]".to_owned())));
        assert_eq!(rows[0].column("none"), None);
        assert_eq!(rows[0].outlines.as_ref().unwrap()[0].height, Some(4.0));
        assert!(rows[0].notes.is_empty());
    }

    #[test]
    fn each_broken_feature_has_its_number_and_a_reason() {
        let rows = rows(
            r#"{ "type": "FeatureCollection", "features": [
            { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [[[NaN, 0], [1, 0], [1, 1]]] } },
            { "type": "Feature", "properties": {}, "geometry": { "type": "Point", "coordinates": [1, 2] } },
            { "type": "Feature", "properties": {}, "geometry": null },
            { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [[[1]]] } },
            { "type": "Feature", "properties": {}, "geometry": { "type": "Polygon", "coordinates": [[[0, 0], [0, 1], [1, 1]]] } } ] }"#,
        );
        let reasons: Vec<&str> =
            rows.iter().filter_map(|row| row.outlines.as_ref().err().map(String::as_str)).collect();
        assert!(reasons[0].starts_with("it is not GeoJSON: "), "{reasons:?}");
        assert_eq!(reasons[1..3], ["a Point is not a polygon", "it has no geometry"]);
        assert_eq!(rows.len(), 5);
        assert!(rows[3].outlines.is_err());
        assert_eq!(rows[4].notes.len(), 1);
    }

    #[test]
    fn a_coordinate_system_after_the_features_counts() {
        let utm = r#""crs": { "type": "name", "properties": { "name": "EPSG:25832" } }"#;
        let inner = r#"{ "type": "Feature", "properties": { "crs": { "properties": { "name": "EPSG:1" } } }, "geometry": null }"#;
        let of = |text: String| read(Cursor::new(text)).unwrap().crs;
        assert_eq!(of(format!("{{ \"features\": [{inner}], {utm} }}\n")), FileCrs::Epsg(25832));
        assert_eq!(of(format!("{{ \"features\": [{inner}], {utm}, \"more\": \"crs\" }}")), FileCrs::Epsg(25832));
        assert_eq!(of(format!("{{ \"features\": [{inner}] }}")), FileCrs::Epsg(4326));
        assert_eq!(of(format!("{{ {utm}, \"type\": \"Feature\" }}")), FileCrs::Epsg(25832));
        let link = r#"{ "crs": { "type": "link", "properties": { "href": "a" } }, "features": [] }"#;
        assert_eq!(of(link.to_owned()), FileCrs::Unknown("without a name".to_owned()));
    }

    #[test]
    fn an_outline_across_the_meridian_of_180_degrees_is_not_clockwise() {
        let outline = |text: &str| Outline::new(vec![serde_json::from_str(text).expect("corners")]);
        let across = outline("[[179.9, 0], [-179.9, 0], [-179.9, 1], [179.9, 1], [179.9, 0]]");
        assert!(!is_clockwise(&across, true) && is_clockwise(&across, false));
        assert!(is_clockwise(&outline("[[179.9, 0], [179.9, 1], [-179.9, 1], [-179.9, 0], [179.9, 0]]"), true));
    }

    #[test]
    fn the_polygons_of_a_collection_are_used() {
        let square = r#"{ "type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]] }"#;
        let point = r#"{ "type": "Point", "coordinates": [0, 0] }"#;
        let text = format!(
            r#"{{ "type": "GeometryCollection", "geometries": [{square}, {point},
            {{ "type": "GeometryCollection", "geometries": [{square}, {point}] }}] }}"#
        );
        let row = read(Cursor::new(text)).expect("JSON").rows.next().expect("a row");
        assert_eq!((row.number, row.outlines.map(|outlines| outlines.len())), (1, Ok(2)));
        assert_eq!(row.notes, ["a Point of its collection was left out"]);
    }
}
