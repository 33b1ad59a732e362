//! Four formats with the same rows give the same footprints, and damaged files lose nothing silently.
#![cfg(all(
    feature = "geojson",
    feature = "flatgeobuf",
    feature = "shapefile",
    feature = "geoparquet",
    feature = "synthetic"
))]

use std::path::Path;

use cga::cga;
use cga_geo::footprint::Footprint;
use cga_geo::reader::{self, FileCrs};
use cga_geo::survey::{Columns, Problem, Surveyor};
use cga_geo::synthetic::Town;

cga! {
    @Allow(unused_attribute)
    grammar House;
    attr height = 9
    attr floors = 1
    attr kind = "home"
    Lot --> extrude(height) X.
}

const FORMATS: [&str; 4] = ["geojson", "fgb", "shp", "parquet"];

/// The sorted footprints, the ids of lost rows, and all problems of a file.
fn surveyed(path: &Path) -> (Vec<Footprint>, Vec<String>, Vec<Problem>) {
    let house = House::default();
    let columns = Columns { id: Some("id".into()), ..Columns::default() };
    let names = columns.names(&[&house]);
    let surveyor = Surveyor::new(vec![&house], columns);
    let file = reader::open(path, &names).expect("a map file");
    assert_eq!(file.crs, FileCrs::Epsg(4326), "{}", path.display());
    let (mut footprints, mut problems) = (Vec::new(), Vec::new());
    for row in file.rows {
        let survey = surveyor.survey(row);
        footprints.extend(survey.footprints);
        problems.extend(survey.problems);
    }
    footprints.sort_by_cached_key(Footprint::key);
    let mut lost: Vec<String> =
        problems.iter().filter(|problem| problem.is_lost).map(|problem| problem.id.clone()).collect();
    lost.sort_unstable();
    (footprints, lost, problems)
}

#[test]
fn equal_rows_make_equal_footprints_in_all_formats() {
    let folder = tempfile::tempdir().expect("a folder");
    let town = Town { broken: 7, ..Town::new(700) };
    let of_format = |ending: &str| {
        let path = folder.path().join(format!("town.{ending}"));
        town.write(&path).expect("room");
        surveyed(&path)
    };
    let [first, others @ ..] = FORMATS.map(of_format);
    // Each row has a footprint for each polygon, or is lost with its id. A row with NaN is not JSON, so GeoJSON does not know its id.
    assert_eq!(first.1.len(), 100);
    assert_eq!(first.1.iter().filter(|id| id.is_empty()).count(), 20);
    for (footprints, lost, problems) in others {
        assert_eq!(footprints, first.0);
        assert!(
            problems
                .iter()
                .filter(|problem| problem.is_lost)
                .all(|problem| problem.id.parse::<u64>().unwrap() % 7 == 0)
        );
        assert_eq!(lost.len(), 100);
    }
    assert!(600 < first.0.len());
    assert!(first.0.iter().any(|footprint| footprint.rings.len() == 2));
    assert!(first.0.iter().all(|footprint| footprint.values.len() == 3));
}

#[test]
fn reasons_name_the_fault_of_each_row() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("town.parquet");
    Town { broken: 2, ..Town::new(20) }.write(&path).expect("room");
    let (_, _, problems) = surveyed(&path);
    let reasons: Vec<&str> =
        problems.iter().filter(|problem| problem.is_lost).map(|problem| problem.reason.as_str()).collect();
    for (number, why) in
        ["a corner is (NaN", "no area", "edges cross", "km long", "corners or more"].into_iter().enumerate()
    {
        assert!(reasons[number].contains(why), "{reasons:?}");
    }
    assert_eq!(reasons.len(), 10);
}

#[test]
fn a_file_that_ends_early_says_so_or_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    for ending in FORMATS {
        let path = folder.path().join(format!("town.{ending}"));
        Town::new(300).write(&path).expect("room");
        let whole = surveyed(&path).0.len();
        let bytes = std::fs::read(&path).expect("the file");
        for part in [1, 3, 7] {
            std::fs::write(&path, &bytes[..bytes.len() * part / 8]).expect("room");
            let house = House::default();
            let Ok(file) = reader::open(&path, &["id".to_owned()]) else { continue };
            let surveyor = Surveyor::new(vec![&house], Columns::default());
            let rows: Vec<_> = file.rows.collect();
            // Only the last row tells that the file is damaged.
            let ends: Vec<bool> = rows.iter().map(|row| row.is_damaged_end).collect();
            assert_eq!(ends.iter().position(|is_end| *is_end), Some(rows.len() - 1), "{ending} {part}");
            assert!(rows.iter().zip(1..).all(|(row, number)| row.number == number), "{ending} {part}");
            let surveys: Vec<_> = rows.into_iter().map(|row| surveyor.survey(row)).collect();
            let found: usize = surveys.iter().map(|survey| survey.footprints.len()).sum();
            let lost = surveys.iter().flat_map(|survey| &survey.problems).any(|problem| problem.is_lost);
            assert!(found < whole && lost, "{ending} {part}: {found} of {whole}");
        }
    }
}

#[test]
fn bytes_that_are_changed_end_no_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let house = House::default();
    for ending in FORMATS {
        let path = folder.path().join(format!("town.{ending}"));
        Town::new(40).write(&path).expect("room");
        let bytes = std::fs::read(&path).expect("the file");
        let mut random = 1u64;
        for _ in 0..60 {
            let mut changed = bytes.clone();
            for _ in 0..3 {
                random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let at = (random >> 33) as usize % changed.len();
                changed[at] = (random >> 20) as u8;
            }
            std::fs::write(&path, &changed).expect("room");
            let Ok(file) = reader::open(&path, &["id".to_owned()]) else { continue };
            let surveyor = Surveyor::new(vec![&house], Columns::default());
            let rows = file.rows.map(|row| surveyor.survey(row)).take(1000).count();
            assert!(rows <= 400, "{ending}: {rows} rows of 40");
        }
    }
}

#[test]
fn a_feature_with_a_wrong_length_takes_no_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("one.fgb");
    Town::new(1).write(&path).expect("room");
    let mut bytes = std::fs::read(&path).expect("the file");
    // The length of the only feature leads to the end of the file.
    let is_length =
        |at: &usize| u32::from_le_bytes(bytes[*at..at + 4].try_into().expect("four")) as usize == bytes.len() - at - 4;
    let at = (8..bytes.len() - 4).find(is_length).expect("a length");
    bytes[at..at + 4].copy_from_slice(&(u32::MAX - 9).to_le_bytes());
    std::fs::write(&path, &bytes).expect("room");
    let rows: Vec<_> = reader::open(&path, &[]).expect("a map file").rows.collect();
    assert_eq!(rows.len(), 1);
    let why = rows[0].outlines.as_ref().expect_err("damaged");
    assert!(why.contains("after 0 of 1 features: a feature is longer than the rest of the file"), "{why}");
}

#[test]
fn a_table_that_announces_too_many_rows_ends_with_a_reason() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("town.shp");
    Town::new(40).write(&path).expect("room");
    let table = path.with_extension("dbf");
    let bytes = std::fs::read(&table).expect("the table");
    for count in [u32::MAX, 3] {
        let mut changed = bytes.clone();
        changed[4..8].copy_from_slice(&count.to_le_bytes());
        std::fs::write(&table, changed).expect("room");
        let rows: Vec<_> = reader::open(&path, &[]).expect("a shapefile").rows.collect();
        let last = rows.last().expect("a row");
        let whole = if count == 3 { 3 } else { 40 };
        assert_eq!((rows.len(), last.number, last.is_damaged_end), (whole + 1, whole as u64 + 1, true));
        let why = last.outlines.as_ref().expect_err("damaged");
        assert!(why.contains(&format!("announces {count} rows")), "{why}");
    }
    // Each of the three files may be the one that is cut short.
    std::fs::write(&table, &bytes[..bytes.len() / 2]).expect("room");
    let last = reader::open(&path, &[]).expect("a shapefile").rows.last().expect("a row");
    assert!(last.is_damaged_end && last.outlines.is_err_and(|why| why.contains("announces 40 rows and has ")));
    std::fs::write(&table, &bytes[..9]).expect("room");
    let why = reader::open(&path, &[]).err().expect("refused");
    assert!(why.contains("town.dbf` is not a table: ") && !why.contains('{'), "{why}");
    let index = path.with_extension("shx");
    let bytes = std::fs::read(&index).expect("the index");
    std::fs::write(&index, &bytes[..bytes.len() - 20]).expect("room");
    let why = reader::open(&path, &[]).err().expect("refused");
    assert!(why.contains("town.shx` is cut short: it has 400 of 420 bytes"), "{why}");
}

#[test]
fn formats_with_a_head_know_their_columns() {
    let folder = tempfile::tempdir().expect("a folder");
    let columns = |ending: &str| {
        let path = folder.path().join(format!("town.{ending}"));
        Town::new(3).write(&path).expect("room");
        reader::open(&path, &[]).expect("a map file").columns
    };
    let expected = columns("fgb");
    assert!(
        expected
            .as_ref()
            .is_some_and(|names| names.contains(&"height".to_owned()) && !names.contains(&"geometry".to_owned()))
    );
    assert_eq!([columns("shp"), columns("parquet"), columns("geojson")], [expected.clone(), expected, None]);
}

#[test]
fn a_broken_line_is_one_lost_row() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("town.geojsonl");
    let line =
        |x: u32| format!("{{\"type\":\"Polygon\",\"coordinates\":[[[{x},0],[{x}.001,0],[{x},0.001],[{x},0]]]}}\n");
    let text = [&line(1), "{\"type\":\"Polygon\",\"coordinates\":[[[\n", &line(2), "}]\n", &line(3)].concat();
    std::fs::write(&path, text).expect("room");
    let (footprints, _, problems) = surveyed(&path);
    let lost: Vec<u64> = problems.iter().filter(|problem| problem.is_lost).map(|problem| problem.row).collect();
    assert_eq!((footprints.len(), lost), (3, vec![2, 4]), "{problems:?}");
}

#[test]
fn packed_files_are_named() {
    let folder = tempfile::tempdir().expect("a folder");
    for ending in ["geojson", "geojsonl", "fgb", "shp", "parquet", "zip"] {
        let path = folder.path().join(format!("lots.{ending}"));
        for (head, why) in [
            (&b"PK\x03\x04 and more"[..], "it is a ZIP archive; unpack it first"),
            (b"\x1f\x8b\x08 and more", "it is a gzip file; unpack it first"),
        ] {
            std::fs::write(&path, head).expect("room");
            assert_eq!(reader::open(&path, &[]).err().as_deref(), Some(why), "{ending}");
        }
    }
}

#[test]
fn a_feature_with_a_wrong_geometry_has_its_id() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("lots.geojson");
    let text = r#"{"type":"FeatureCollection","features":[
        {"type":"Feature","properties":{"id":"a"},"geometry":{"type":"Polygon","coordinates":[9,48]}},
        {"type":"Feature","id":7,"properties":null,"geometry":{"type":"Polygon","coordinates":[[["9","48"]]]}},
        {"type":"Feature","id":[8],"properties":[1],"geometry":{"type":"Curve"}},
        null]}"#;
    std::fs::write(&path, text).expect("room");
    let rows: Vec<_> = reader::open(&path, &[]).expect("a file").rows.collect();
    assert!(rows.iter().all(|row| row.outlines.is_err()) && rows.len() == 4);
    let (_, _, problems) = surveyed(&path);
    assert_eq!(problems.iter().map(|problem| problem.id.as_str()).collect::<Vec<_>>()[0], "a");
    assert_eq!([&rows[1].id, &rows[2].id, &rows[3].id], [&Some("7".to_owned()), &None, &None]);
}
