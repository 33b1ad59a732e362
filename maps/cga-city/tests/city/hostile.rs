//! Rows and rules that go wrong.

use cga::RuleFile;
use cga_city::build::{NoProgress, Options};
use cga_city::rules::Rules;
use cga_geo::synthetic::Town;
use serde_json::Value;

use crate::town::{build, city, files, options, rules};

fn problems(out: &std::path::Path) -> Vec<Value> {
    let text = std::fs::read_to_string(out.join("problems.jsonl")).expect("problems");
    text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

#[test]
fn each_lost_row_has_its_number_and_a_reason() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.parquet"), folder.path().join("out"));
    let town = Town { broken: 10, ..Town::new(300) };
    town.write(&lots).expect("room");
    let summary = city(&lots, &out);
    let lost: Vec<Value> = problems(&out).into_iter().filter(|problem| problem["lost"] == true).collect();
    let rows: Vec<u64> = lost.iter().map(|problem| problem["row"].as_u64().expect("a number")).collect();
    assert_eq!(rows, (0..30).map(|number| number * 10 + 10).collect::<Vec<_>>());
    assert!(lost.iter().all(|problem| !problem["reason"].as_str().unwrap_or_default().is_empty()));
    let good: u64 = town.iter().filter(|row| row.id % 10 != 0).map(|row| row.polygons.len() as u64).sum();
    assert_eq!((summary.lost, summary.lots, summary.levels[0].buildings), (30, good, good));
}

#[test]
fn a_building_that_fails_is_named_and_the_others_stay() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.geojson"), folder.path().join("out"));
    Town::new(100).write(&lots).expect("room");
    // Halls end at the limit of nested rules.
    let text = "attr kind = \"home\"  attr height = 3
        Lot --> case kind == \"hall\" : Endless(1) else : extrude(height) X.
        Endless(n) --> case n < 0 : X. else : Endless(n + 1)";
    let rules = Rules::new(vec![RuleFile::from_text(text).expect("good rules")]).expect("one file");
    let options = Options { levels: Vec::new(), ..options() };
    let summary = build(&lots, &out, &rules, options, &NoProgress).expect("a city");
    let halls: Vec<String> = Town::new(100)
        .iter()
        .filter(|row| row.kind == "hall")
        .flat_map(|row| vec![row.id.to_string(); row.polygons.len()])
        .collect();
    let mut lost: Vec<String> = problems(&out)
        .iter()
        .filter(|problem| problem["lost"] == true)
        .map(|problem| problem["id"].as_str().expect("an id").to_owned())
        .collect();
    lost.sort_by_key(|id| id.parse::<u64>().ok());
    assert_eq!(lost, halls);
    assert_eq!(summary.levels[0].buildings + halls.len() as u64, summary.lots);
}

#[test]
fn a_city_without_lots_is_an_empty_tileset() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("none.geojson"), folder.path().join("out"));
    std::fs::write(&lots, "{\"type\":\"FeatureCollection\",\"features\":[]}").expect("room");
    let summary = city(&lots, &out);
    assert_eq!((summary.rows, summary.lots), (0, 0));
    let set: Value = serde_json::from_slice(&files(&out)["tileset.json"]).expect("JSON");
    assert!(set["root"]["boundingVolume"]["box"][0].is_number(), "{set}");
}

#[test]
fn a_file_that_ends_early_leaves_the_older_city() {
    let folder = tempfile::tempdir().expect("a folder");
    for ending in ["geojson", "fgb", "shp"] {
        let (lots, out) = (folder.path().join(format!("town.{ending}")), folder.path().join(ending));
        Town::new(200).write(&lots).expect("room");
        city(&lots, &out);
        let before = files(&out);
        let bytes = std::fs::read(&lots).expect("the file");
        std::fs::write(&lots, &bytes[..bytes.len() / 2]).expect("room");
        let error = build(&lots, &out, &rules(), options(), &NoProgress).expect_err("damaged");
        assert!(error.contains("is damaged in row ") && error.contains("no tile was made or deleted"), "{error}");
        assert!(files(&out) == before, "{ending}");
        assert!(problems(&out).last().is_some_and(|problem| problem["lost"] == true));
    }
}
