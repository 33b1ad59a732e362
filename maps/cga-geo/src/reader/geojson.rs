//! GeoJSON: a collection, one feature, or features after each other, as in GeoJSON text sequences.

use std::io::BufRead;

use ::geojson::{Feature, GeoJson, Geometry, GeometryValue, JsonValue, Position};

use super::json_objects::{JsonObjects, Part};
use super::{FileCrs, MapFile};
use crate::column::ColumnValue;
use crate::outline::{Corner, Outline, twice_area};
use crate::row::{MOST_CORNERS, Row, too_many_corners};

/// Reads the features of a text. Without the old member `crs`, coordinates are degrees on WGS 84 (RFC 7946).
///
/// # Errors
/// The text does not begin as JSON does.
pub fn read(input: impl BufRead + 'static) -> Result<MapFile, String> {
    let mut parts = JsonObjects::new(input).peekable();
    let crs = match parts.peek() {
        Some(Part::Head(text)) => crs(text),
        Some(Part::Broken(why)) => return Err(why.clone()),
        Some(Part::Object(_)) | None => FileCrs::Epsg(4326),
    };
    let objects = parts.filter(|part| !matches!(part, Part::Head(_)));
    let rows = (0..).zip(objects).map(|(number, part)| match part {
        Part::Object(text) => row(number, &text),
        Part::Broken(why) => Row::new(number, Err(why)),
        Part::Head(_) => unreachable!("they are left out"),
    });
    Ok(MapFile::new(rows, crs))
}

/// The coordinate system of the old member `crs`.
fn crs(head: &[u8]) -> FileCrs {
    let Ok(head) = serde_json::from_slice::<JsonValue>(head) else { return FileCrs::Epsg(4326) };
    let Some(name) = head["crs"]["properties"]["name"].as_str() else { return FileCrs::Epsg(4326) };
    if name.ends_with(":CRS84") {
        return FileCrs::Epsg(4326);
    }
    let code = name.rsplit(':').next().filter(|_| name.to_uppercase().contains("EPSG"));
    code.and_then(|code| code.parse().ok()).map_or_else(|| FileCrs::Unknown(name.to_owned()), FileCrs::Epsg)
}

fn row(number: u64, text: &[u8]) -> Row {
    let feature = match std::str::from_utf8(text).map_err(|why| why.to_string()).and_then(feature) {
        Ok(feature) => feature,
        Err(why) => {
            let has_nan = text.windows(3).any(|word| word == b"NaN");
            let hint = if has_nan { "; `NaN` is not JSON" } else { "" };
            return Row::new(number, Err(format!("it is not GeoJSON: {why}{hint}")));
        }
    };
    let id = feature.id.as_ref().map(|id| match id {
        ::geojson::feature::Id::String(id) => id.clone(),
        ::geojson::feature::Id::Number(id) => id.to_string(),
    });
    let columns = feature.properties.iter().flatten().filter_map(|(name, value)| Some((name.clone(), column(value)?)));
    let columns = columns.collect();
    let outlines = match &feature.geometry {
        Some(geometry) => outlines(geometry),
        None => Err("it has no geometry".to_owned()),
    };
    let mut notes = Vec::new();
    if outlines.iter().flatten().any(|outline| twice_area(outline.rings.first().map_or(&[], Vec::as_slice)) < 0.0) {
        notes.push(
            "its outline runs clockwise, but outlines of GeoJSON run counter-clockwise; it was turned".to_owned(),
        );
    }
    Row { number, id, outlines, columns, notes }
}

fn feature(text: &str) -> Result<Feature, String> {
    match text.parse().map_err(|why: ::geojson::Error| why.to_string())? {
        GeoJson::Feature(feature) => Ok(feature),
        GeoJson::Geometry(geometry) => Ok(Feature::from(geometry)),
        GeoJson::FeatureCollection(_) => Err("a collection inside of a collection".to_owned()),
    }
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

fn outlines(geometry: &Geometry) -> Result<Vec<Outline>, String> {
    let polygons = match &geometry.value {
        GeometryValue::Polygon { coordinates } => std::slice::from_ref(coordinates),
        GeometryValue::MultiPolygon { coordinates } => coordinates.as_slice(),
        other => return Err(format!("a {} is not a polygon", other.type_name())),
    };
    let count: usize = polygons.iter().flatten().map(Vec::len).sum();
    if MOST_CORNERS < count {
        return Err(too_many_corners(count));
    }
    polygons.iter().map(|polygon| outline(polygon)).collect()
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
    use super::*;

    fn rows(text: &'static str) -> Vec<Row> {
        read(text.as_bytes()).expect("JSON").rows.collect()
    }

    #[test]
    fn features_have_ids_columns_and_heights() {
        let text = r#"{ "type": "FeatureCollection", "crs": { "properties": { "name": "urn:ogc:def:crs:EPSG::25832" } }, "features": [
            { "type": "Feature", "id": 7, "properties": { "h": 3.5, "name": "A", "none": null, "list": [1, 2] },
              "geometry": { "type": "Polygon", "coordinates": [[[0, 0, 5], [1, 0, 4], [1, 1, 6], [0, 0, 5]]] } } ] }"#;
        assert_eq!(read(text.as_bytes()).unwrap().crs, FileCrs::Epsg(25832));
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
}
