//! The command from outside: exit statuses and messages.

use std::path::Path;
use std::process::{Command, Output};

use cga_geo::synthetic::Town;

const RULES: &str = "attr height = 9  @StartRule Lot --> extrude(height) X.  @StartRule Block --> extrude(height) Y.";

fn run(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_cga-city")).current_dir(folder).args(args).output().expect("the command")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A folder with lots and rules.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    Town { broken: 20, ..Town::new(60) }.write(&folder.path().join("lots.geojson")).expect("room");
    std::fs::write(folder.path().join("house.cga"), RULES).expect("room");
    folder
}

#[test]
fn without_arguments_it_makes_a_town_and_says_what_to_type_next() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = run(folder.path(), &[]);
    let text = said(&output);
    assert_eq!(output.status.code(), Some(0), "{text}");
    let next = text.lines().find(|line| line.starts_with("  cga-city town/town.geojson")).expect("a line to type");
    assert!(folder.path().join("town/tiles/tileset.json").is_file());
    // The line works as it is.
    let again = run(folder.path(), &next.split_whitespace().skip(1).collect::<Vec<_>>());
    assert_eq!(again.status.code(), Some(0), "{}", said(&again));
    assert!(said(&again).contains(" 0 kept"));
}

#[test]
fn each_kind_of_failure_has_its_status_and_a_message() {
    let folder = folder();
    std::fs::write(folder.path().join("broken.cga"), "Lot --> extrude(").expect("room");
    std::fs::write(folder.path().join("empty.geojson"), "{\"type\":\"FeatureCollection\",\"features\":[]}")
        .expect("room");
    std::fs::write(folder.path().join("lots.txt"), "lots").expect("room");
    std::fs::create_dir(folder.path().join("full")).expect("room");
    std::fs::write(folder.path().join("full/letter.txt"), "dear").expect("room");
    let usual = |lots: &str, rules: &str, more: &[&str]| {
        let args = [&[lots, "--rules", rules, "--out", "out"], more].concat();
        run(folder.path(), &args)
    };
    for (output, status, why) in [
        (usual("lots.geojson", "house.cga", &[]), 0, ", 3 lost, "),
        (usual("lots.geojson", "house.cga", &["--deny-lost"]), 1, "edges cross"),
        (usual("lots.geojson", "broken.cga", &[]), 1, "error"),
        (usual("empty.geojson", "house.cga", &[]), 1, "the city is empty"),
        (usual("none.geojson", "house.cga", &[]), 2, "cannot read `none.geojson`"),
        (usual("lots.txt", "house.cga", &[]), 2, "its name ends in none of"),
        (usual("lots.geojson", "none.cga", &[]), 2, "cannot read `none.cga`"),
        (usual("lots.geojson", "house.cga", &["--set", "hight=3"]), 2, "height"),
        (usual("lots.geojson", "house.cga", &["--attribute", "h=hight"]), 2, "`hight` is not an attribute"),
        (usual("lots.geojson", "house.cga", &["--lod", "Blok"]), 2, "its start rules are Lot, Block"),
        (usual("lots.geojson", "house.cga", &["--terrain", "none.asc"]), 2, "cannot read `none.asc`"),
        (usual("lots.geojson", "house.cga", &["--crs", "EPSG:1"]), 2, "EPSG:1"),
        (run(folder.path(), &["lots.geojson", "--rules", "house.cga", "--out", "full"]), 2, "not a city"),
        (run(folder.path(), &["view", "full"]), 2, "has no tileset.json"),
        (run(folder.path(), &["outlines", "a.txt"]), 2, "ends in none of"),
    ] {
        let text = said(&output);
        assert!(
            output.status.code() == Some(status) && text.contains(why),
            "{status} {why}: {:?} {text}",
            output.status
        );
    }
}

#[test]
fn lots_get_their_grammars_rules_values_and_ground_from_files() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("garden.cga"), "@StartRule Lawn --> X.  @StartRule Pond --> Y.").expect("room");
    let feature = |id: u32, properties: &str| {
        let x = 500_000 + 40 * id;
        format!(
            "{{\"type\":\"Feature\",\"id\":{id},\"properties\":{{{properties}}},\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":\
             [[[{x},5400000],[{},5400000],[{},5400010],[{x},5400010],[{x},5400000]]]}}}}",
            x + 20,
            x + 20
        )
    };
    let features = [
        feature(0, "\"HOEHE\":\"12.5\",\"base\":1"),
        feature(1, "\"kind\":\"garden\",\"start\":\"Pond\""),
        feature(2, "\"kind\":\"castle\""),
    ];
    let head = "{\"type\":\"FeatureCollection\",\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"urn:ogc:def:crs:EPSG::25832\"}},\"features\":[";
    std::fs::write(at("mixed.geojson"), format!("{head}{}]}}", features.join(","))).expect("room");
    let grid = "ncols 2\nnrows 2\nxllcenter 499000\nyllcenter 5399000\ncellsize 2000\n300 320\n300 320\n";
    std::fs::write(at("ground.asc"), grid).expect("room");
    let args = "mixed.geojson --rules house.cga --rules garden.cga --out out --attribute HOEHE=height --grammar-column kind \
                --start-column start --terrain ground.asc --jobs 1";
    let output = run(folder.path(), &args.split_whitespace().collect::<Vec<_>>());
    let text = said(&output);
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(text.contains("`castle` is not one of the grammars house, garden"), "{text}");
    assert!(text.contains("3 rows, 2 lots, 1 lost"), "{text}");
    // The ground is at 310 m in the middle of the grid, and rises by 1 m in 100 m to the east.
    let descriptions = find(&at("out/tiles"), "json");
    let text = std::fs::read_to_string(&descriptions[0]).expect("a tile");
    let tile: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let (low, high) =
        (tile["bounds"][0][2].as_f64().expect("a height"), tile["bounds"][1][2].as_f64().expect("a height"));
    assert!((low - 310.0).abs() < 0.2 && (high - 322.5).abs() < 0.2, "{low} {high}");
}

/// The files below a folder with an ending.
fn find(folder: &Path, ending: &str) -> Vec<std::path::PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let mut found: Vec<_> =
        files.into_iter().filter(|path| path.extension().is_some_and(|own| own == ending)).collect();
    found.extend(folders.iter().flat_map(|folder| find(folder, ending)));
    found
}
