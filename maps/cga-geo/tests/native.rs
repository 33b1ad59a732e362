//! GeoParquet with polygons in lists of coordinates gives the same footprints as with WKB.
#![cfg(all(feature = "geoparquet", feature = "synthetic"))]

use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use cga::cga;
use cga_geo::outline::Corner;
use cga_geo::reader::{self, FileCrs};
use cga_geo::survey::{Columns, Survey, Surveyor};
use cga_geo::synthetic::Town;
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArrayType, DoubleType, Int64Type};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use parquet::schema::types::Type;

cga! {
    @Allow(unused_attribute)
    grammar House;
    attr height = 9
    Lot --> extrude(height) X.
}

/// The polygons of a row; `None` for a row without a geometry.
type Polygons = Option<Vec<Vec<Vec<Corner>>>>;

/// The column of geometries of a schema: lists in lists of x, y and z, where everything is optional or required.
fn schema(lists: usize, word: &str) -> String {
    let mut text = format!("{word} group element {{ {word} double x; {word} double y; optional double z; }}");
    for depth in 0..lists {
        let name = if depth + 1 == lists { "geometry" } else { "element" };
        let word = if depth + 1 == lists { "optional" } else { word };
        text = format!("{word} group {name} (LIST) {{ repeated group list {{ {text} }} }}");
    }
    format!("message town {{ required int64 id; {text} }}")
}

/// Writes rows with ids from 1. Each corner has the height 7, except where `is_flat`.
fn write(path: &Path, rows: &[Polygons], lists: usize, word: &str, encoding: &str) {
    let schema = Arc::new(parse_message_type(&schema(lists, word)).expect("a schema"));
    let geo = format!(r#"{{"primary_column":"geometry","columns":{{"geometry":{{"encoding":"{encoding}"}}}}}}"#);
    let properties =
        WriterProperties::builder().set_key_value_metadata(Some(vec![KeyValue::new("geo".to_owned(), geo)]));
    let file = File::create(path).expect("room");
    let mut writer = SerializedFileWriter::new(file, schema, Arc::new(properties.build())).expect("a writer");
    // The levels of definition: null, and for each list from the outermost one an empty list, then a number.
    let step = if word == "optional" { 2 } else { 1 };
    let empty = |list: usize| (1 + step * list) as i16;
    let number = (step * lists) as i16 + if word == "optional" { 2 } else { 1 };
    let lists = lists as i16;
    for (group, rows) in rows.chunks(40).enumerate() {
        let mut levels: Vec<(i16, i16, Option<Corner>)> = Vec::new();
        for row in rows {
            let Some(polygons) = row else {
                levels.push((0, 0, None));
                continue;
            };
            if polygons.is_empty() {
                levels.push((empty(0), 0, None));
            }
            for (polygon, rings) in polygons.iter().enumerate() {
                let first = if polygon == 0 { 0 } else { lists - 2 };
                if rings.is_empty() {
                    levels.push((empty(lists as usize - 2), first, None));
                }
                for (ring, corners) in rings.iter().enumerate() {
                    let first = if ring == 0 { first } else { lists - 1 };
                    if corners.is_empty() {
                        levels.push((empty(lists as usize - 1), first, None));
                    }
                    let corners = corners.iter().enumerate();
                    levels.extend(
                        corners.map(|(at, corner)| (number, if at == 0 { first } else { lists }, Some(*corner))),
                    );
                }
            }
        }
        let (mut out, from) = (writer.next_row_group().expect("a group"), 40 * group as i64 + 1);
        let mut column = out.next_column().expect("ids").expect("ids");
        let ids: Vec<i64> = (from..from + rows.len() as i64).collect();
        column.typed::<Int64Type>().write_batch(&ids, None, None).expect("room");
        column.close().expect("room");
        let repetitions: Vec<i16> = levels.iter().map(|(_, repetition, _)| *repetition).collect();
        for axis in 0..3 {
            let mut column = out.next_column().expect("a column").expect("a column");
            let corners = levels.iter().filter_map(|(.., corner)| *corner);
            let values: Vec<f64> = corners.map(|corner| if axis == 2 { 7.0 } else { corner[axis] }).collect();
            // Heights are optional.
            let more = i16::from(axis == 2 && word != "optional");
            let definition =
                |(level, _, corner): &(i16, i16, Option<Corner>)| level + if corner.is_some() { more } else { 0 };
            let definitions: Vec<i16> = levels.iter().map(definition).collect();
            column.typed::<DoubleType>().write_batch(&values, Some(&definitions), Some(&repetitions)).expect("room");
            column.close().expect("room");
        }
        out.close().expect("room");
    }
    writer.close().expect("room");
}

fn surveys(path: &Path, names: &[&str]) -> Vec<Survey> {
    let house = House::default();
    let surveyor = Surveyor::new(vec![&house], Columns { id: Some("id".into()), ..Columns::default() });
    let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
    let file = reader::open(path, &names).expect("a map file");
    file.rows.map(|row| surveyor.survey(row)).collect()
}

#[test]
fn lists_give_the_footprints_of_wkb() {
    let folder = tempfile::tempdir().expect("a folder");
    let (wkb, native) = (folder.path().join("wkb.parquet"), folder.path().join("native.parquet"));
    let town = Town { broken: 9, ..Town::new(130) };
    town.write(&wkb).expect("room");
    let expected = surveys(&wkb, &["id"]);
    let rows: Vec<Polygons> = town.iter().map(|row| Some(row.polygons)).collect();
    assert!(
        rows.iter().flatten().any(|row| 1 < row.len()) && rows.iter().flatten().flatten().any(|rings| 1 < rings.len())
    );
    for word in ["optional", "required"] {
        write(&native, &rows, 3, word, "multipolygon");
        for (found, expected) in surveys(&native, &["id"]).into_iter().zip(&expected) {
            let mut footprints = found.footprints;
            assert!(footprints.iter().all(|footprint| footprint.base == 7.0));
            footprints.iter_mut().for_each(|footprint| footprint.base = 0.0);
            assert_eq!(footprints, expected.footprints);
            let lost = |survey: &[cga_geo::survey::Problem]| survey.iter().filter(|problem| problem.is_lost).count();
            assert_eq!(lost(&found.problems), lost(&expected.problems));
        }
        // Rows of one polygon, and no column that is read.
        let single: Vec<Polygons> =
            rows.iter().filter(|row| row.as_ref().is_some_and(|row| row.len() == 1)).cloned().collect();
        write(&native, &single, 2, word, "polygon");
        let expected = expected.iter().zip(&rows).filter(|(_, row)| row.as_ref().is_some_and(|row| row.len() == 1));
        let found = surveys(&native, &[]);
        assert_eq!(found.len(), single.len());
        for (found, (expected, _)) in found.iter().zip(expected) {
            let rings =
                |survey: &Survey| survey.footprints.iter().map(|footprint| footprint.rings.clone()).collect::<Vec<_>>();
            assert_eq!(rings(found), rings(expected));
        }
    }
}

#[test]
fn empty_lists_are_lost_rows_with_a_reason() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("native.parquet");
    let ring = |x: f64| vec![[x, 48.0], [x + 0.0001, 48.0], [x + 0.0001, 48.0001], [x, 48.0]];
    let rows: Vec<Polygons> = vec![
        Some(vec![vec![ring(9.0)]]),
        None,
        Some(vec![]),
        Some(vec![vec![]]),
        Some(vec![vec![vec![]]]),
        Some(vec![vec![vec![], ring(9.0)]]),
        Some(vec![vec![ring(9.1)], vec![], vec![ring(9.2)]]),
        Some(vec![vec![vec![[9.0, 48.0]; 30_000]]]),
        Some(vec![vec![ring(9.3)]]),
    ];
    for word in ["optional", "required"] {
        write(&path, &rows, 3, word, "multipolygon");
        let found: Vec<(usize, String)> = surveys(&path, &["id"])
            .iter()
            .map(|survey| {
                (survey.footprints.len(), survey.problems.iter().map(|problem| problem.reason.clone()).collect())
            })
            .collect();
        let expected = [
            (1, ""),
            (0, "it has no geometry"),
            (0, "it has no polygon"),
            (0, "it has an empty polygon"),
            (0, "its outline has no area"),
            (0, "its outline has no area"),
            (2, "polygon 2 of 3: it has an empty polygon"),
            (0, "it has 30000 corners or more; at most 20000 are used"),
            (1, ""),
        ];
        assert_eq!(found, expected.map(|(count, why)| (count, why.to_owned())), "{word}");
    }
}

#[test]
fn other_native_geometries_are_lost_rows_and_unknown_encodings_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("native.parquet");
    let row = Some(vec![vec![vec![[9.0, 48.0], [9.1, 48.0], [9.0, 48.1]]]]);
    write(&path, &[row.clone(), row.clone()], 2, "required", "multilinestring");
    let found = surveys(&path, &["id"]);
    let reasons: Vec<&str> = found.iter().map(|survey| survey.problems[0].reason.as_str()).collect();
    assert_eq!(reasons, ["a MultiLineString is not a polygon"; 2]);
    assert_eq!(found[1].problems[0].id, "2");
    for (lists, encoding, why) in [
        (3, "polygon", "not made of 2 lists of x and y"),
        (2, "multipolygon", "not made of 3 lists of x and y"),
        (2, "TWKB", "its geometries are encoded as TWKB"),
    ] {
        write(&path, std::slice::from_ref(&row), lists, "optional", encoding);
        let error = reader::open(&path, &[]).err().expect("refused");
        assert!(error.contains(why), "{error}");
    }
}

#[test]
fn a_column_of_the_type_geometry_needs_no_further_description() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("typed.parquet");
    let mut point = vec![1, 1, 0, 0, 0];
    [9.0f64, 48.0].iter().for_each(|number| point.extend(number.to_le_bytes()));
    for (crs, expected) in [
        (None, FileCrs::Epsg(4326)),
        (Some("OGC:CRS84"), FileCrs::Epsg(4326)),
        (Some("EPSG:25832"), FileCrs::Epsg(25832)),
        (Some("srid:3857"), FileCrs::Epsg(3857)),
        (Some(r#"{"name":"UTM","id":{"authority":"EPSG","code":25833}}"#), FileCrs::Epsg(25833)),
        (Some("Gauss"), FileCrs::Unknown("Gauss".to_owned())),
    ] {
        let geometry = Type::primitive_type_builder("shape", Physical::BYTE_ARRAY)
            .with_repetition(Repetition::REQUIRED)
            .with_logical_type(Some(LogicalType::geometry(crs.map(str::to_owned))))
            .build();
        let schema = Type::group_type_builder("town").with_fields(vec![Arc::new(geometry.expect("a type"))]).build();
        let file = File::create(&path).expect("room");
        let mut writer =
            SerializedFileWriter::new(file, Arc::new(schema.expect("a schema")), Arc::default()).expect("a writer");
        let mut out = writer.next_row_group().expect("a group");
        let mut column = out.next_column().expect("a column").expect("a column");
        column.typed::<ByteArrayType>().write_batch(&[point.clone().into()], None, None).expect("room");
        column.close().expect("room");
        out.close().expect("room");
        writer.close().expect("room");
        let mut file = reader::open(&path, &[]).expect("a map file");
        assert_eq!(file.crs, expected);
        let row = file.rows.next().expect("a row");
        assert_eq!(row.outlines, Err("a Point is not a polygon".to_owned()));
    }
}
