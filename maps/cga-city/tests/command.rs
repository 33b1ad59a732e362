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
    let mut lines =
        text.lines().filter_map(|line| line.strip_prefix("  ")?.strip_prefix(env!("CARGO_BIN_EXE_cga-city")));
    let next = lines.find(|line| line.starts_with(" town/town.geojson")).expect("a line to type");
    assert!(folder.path().join("town/tiles/tileset.json").is_file());
    // The line works as it is.
    let again = run(folder.path(), &next.split_whitespace().collect::<Vec<_>>());
    assert_eq!(again.status.code(), Some(0), "{}", said(&again));
    assert!(said(&again).contains(" 0 kept"));
}

#[test]
fn each_kind_of_failure_has_its_status_and_a_message() {
    let folder = folder();
    std::fs::write(folder.path().join("broken.cga"), "Lot --> extrude(").expect("room");
    std::fs::write(folder.path().join("empty.geojson"), "{\"type\":\"FeatureCollection\",\"features\":[]}")
        .expect("room");
    std::fs::write(folder.path().join("start.cga"), "attr height = 9").expect("room");
    std::fs::write(folder.path().join("image.cga"), "Lot --> extrude(9) i(\"lost.obj\") X.").expect("room");
    std::fs::write(folder.path().join("lost.cga"), "Lot --> A(1)  A(n) --> case n < 0 : X. else : A(n + 1)")
        .expect("room");
    for ending in ["fgb", "shp", "parquet"] {
        Town::new(9).write(&folder.path().join(format!("lots.{ending}"))).expect("room");
    }
    std::fs::write(folder.path().join("lots.txt"), "lots").expect("room");
    std::fs::copy(folder.path().join("lots.shp"), folder.path().join("alone.shp")).expect("room");
    std::fs::create_dir(folder.path().join("full")).expect("room");
    std::fs::write(folder.path().join("full/letter.txt"), "dear").expect("room");
    std::fs::create_dir_all(folder.path().join("town/tiles")).expect("room");
    std::fs::write(folder.path().join("town/tiles/tileset.json"), "{}").expect("room");
    std::fs::create_dir(folder.path().join("seen")).expect("room");
    std::fs::write(folder.path().join("seen/tileset.json"), "{}").expect("room");
    std::fs::write(folder.path().join("seen/index.html"), "").expect("room");
    let listener = std::net::TcpListener::bind(("127.0.0.1", 0)).expect("a port");
    let taken = listener.local_addr().expect("a port").port().to_string();
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
        (usual("lost.geojson", "house.cga", &[]), 2, "`lost.geojson`: it does not exist; did you mean `lots.geojson`?"),
        (usual("lots.geojson", "hose.cga", &[]), 2, "`hose.cga`: it does not exist; did you mean `house.cga`?"),
        (usual("alone.shp", "house.cga", &[]), 2, "`alone.shx` is missing; a shapefile is `.shp`, `.shx` and `.dbf`"),
        (usual("lots.txt", "house.cga", &[]), 2, "its name ends in none of"),
        (usual("lots.geojson", "none.cga", &[]), 2, "cannot read `none.cga`"),
        (usual("lots.geojson", "house.cga", &["--set", "hight=3"]), 2, "height"),
        (
            usual("lots.geojson", "house.cga", &["--attribute", "h=hight"]),
            2,
            "`hight` is not an attribute of the rules; did you mean `height`?",
        ),
        (usual("lots.geojson", "house.cga", &["--lod", "Blok"]), 2, "its start rules are Lot, Block"),
        (usual("lots.geojson", "house.cga", &["--lod", "Block", "--lod", "Block@99"]), 2, "`Block@99` is given twice"),
        (
            usual("lots.geojson", "house.cga", &["--lod", "Block@9", "--lod", "Lot@8"]),
            2,
            "`Lot@8` is 8 m, which is not above",
        ),
        (
            usual("lots.geojson", "house.cga", &["--id", "NOCOL"]),
            2,
            "--id: the column `NOCOL` is unknown, as no row has a value in it; the columns are `floors`, `",
        ),
        (
            usual("lots.fgb", "house.cga", &["--attribute", "NOCOL=height"]),
            2,
            "--attribute: the column `NOCOL` is unknown, as no file has it; the columns are `",
        ),
        (usual("lots.fgb", "house.cga", &["--attribute", "hight=height"]), 2, "did you mean `height`? The columns are"),
        (usual("lots.shp", "house.cga", &["--start-column", "NOCOL"]), 2, "--start-column: the column `NOCOL`"),
        (usual("lots.parquet", "house.cga", &["--grammar-column", "NOCOL"]), 2, "--grammar-column: the column `NOCOL`"),
        (usual("none.geojson", "start.cga", &[]), 1, "`start` has no start rule"),
        (usual("lots.geojson", "lost.cga", &[]), 1, "all buildings of a level are lost"),
        (usual("lots.fgb", "image.cga", &[]), 0, "no asset folder is set (`--assets FOLDER`)"),
        (usual("lots.geojson", "house.cga", &["--terrain", "none.asc"]), 2, "cannot read `none.asc`"),
        (
            usual("lots.geojson", "house.cga", &["--crs", "EPSG:1"]),
            2,
            "EPSG:1 is not a known coordinate system; look up",
        ),
        (usual("lots.geojson", "house.cga", &["--crs", "EPSG:25823"]), 2, "such as EPSG:25832 for UTM"),
        (run(folder.path(), &["view", "seen", "--page", "seen", "--port", &taken]), 2, "use another one with `--port`"),
        (run(folder.path(), &["lots.geojson", "--rules", "house.cga", "--out", "full"]), 2, "not a city"),
        (run(folder.path(), &["view", "full"]), 2, "has no tileset.json; make a city"),
        (
            run(folder.path(), &["view", "town"]),
            2,
            &format!("did you mean `{}`?", Path::new("town").join("tiles").display()),
        ),
        (run(folder.path(), &["outlines", "lots.shp"]), 2, "`lots.shp` exists already"),
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

#[test]
fn files_of_a_person_are_not_replaced() {
    let folder = folder();
    let town = folder.path().join("town");
    std::fs::create_dir(&town).expect("room");
    std::fs::rename(folder.path().join("lots.geojson"), town.join("town.geojson")).expect("room");
    let before = std::fs::read(town.join("town.geojson")).expect("lots");
    let output = run(folder.path(), &[]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    assert!(said(&output).contains("town.geojson, which exist already"), "{}", said(&output));
    assert!(std::fs::read(town.join("town.geojson")).expect("lots") == before);
    // A file among the tiles would be replaced.
    for name in ["tiles/0/1.geojson", "problems.jsonl"] {
        let lots = town.join("tiles").join(name);
        let args = [lots.to_str().expect("a name"), "--rules", "house.cga", "--out", "town/tiles"];
        std::fs::write(&lots, &before).expect("room");
        let output = run(folder.path(), &args);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(said(&output).contains("is among the tiles in"), "{}", said(&output));
    }
}

#[test]
fn a_city_and_its_assets_are_apart() {
    let folder = folder();
    std::fs::create_dir_all(folder.path().join("out/tiles")).expect("room");
    std::fs::create_dir_all(folder.path().join("images")).expect("room");
    for (assets, out, why) in [
        ("out/tiles", "out", "`out/tiles` is among the tiles in `"),
        (".", "new", "`new` is inside of the assets in `.`"),
        (".", "new/../images/inner", "`new/../images/inner` is inside of the assets in `.`"),
        ("images", "images", "`images` is inside of the assets in `images`"),
        ("images", "images/a/b", "name an `--out` outside of that folder"),
    ] {
        let output = run(folder.path(), &["lots.geojson", "--rules", "house.cga", "--assets", assets, "--out", out]);
        assert_eq!(output.status.code(), Some(2), "{assets} {out}: {}", said(&output));
        assert!(said(&output).contains(why), "{assets} {out}: {}", said(&output));
    }
    assert!(!folder.path().join("new").exists());
}

/// A link in the place of the mark of a city.
#[cfg(unix)]
#[test]
fn the_file_of_a_link_is_not_written_over() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("out")).expect("room");
    std::os::unix::fs::symlink("../house.cga", folder.path().join("out/cga-city.json")).expect("a link");
    let output = run(folder.path(), &["lots.geojson", "--rules", "house.cga", "--out", "out"]);
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    assert!(said(&output).contains("is a link"), "{}", said(&output));
    assert_eq!(std::fs::read_to_string(folder.path().join("house.cga")).expect("the rules"), RULES);
}

#[test]
fn a_broken_line_is_a_lost_row_and_a_cut_file_is_status_1() {
    let folder = folder();
    let lots = folder.path().join("lots.geojsonl");
    let text = std::fs::read_to_string(folder.path().join("lots.geojson")).expect("lots");
    let lines: Vec<&str> = text.lines().filter(|line| line.starts_with('{') && line.contains("\"Feature\"")).collect();
    let lines: Vec<&str> = lines.into_iter().map(|line| line.trim_end_matches(',')).collect();
    assert!(50 < lines.len());
    let half = &lines[4][..lines[4].len() / 2];
    std::fs::write(&lots, format!("{}\n{half}\n{}\n", lines[..4].join("\n"), lines[5..].join("\n"))).expect("room");
    let args = ["lots.geojsonl", "--rules", "house.cga", "--out", "out"];
    let output = run(folder.path(), &args);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    assert!(said(&output).contains("row 5: the line ends inside of this object"), "{}", said(&output));
    let before = find(&folder.path().join("out"), "glb");
    std::fs::write(&lots, format!("{}\n{half}", lines[..4].join("\n"))).expect("room");
    let output = run(folder.path(), &args);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert!(said(&output).contains("`lots.geojsonl` is damaged in row 5: "), "{}", said(&output));
    assert!(!before.is_empty() && find(&folder.path().join("out"), "glb") == before);
}

/// Libraries of formats panic for some damaged files.
#[test]
fn damaged_files_and_hostile_ids_print_no_panic_and_no_control_characters() {
    let folder = folder();
    let mut random = 1u64;
    for ending in ["fgb", "parquet"] {
        let path = folder.path().join(format!("lots.{ending}"));
        Town::new(9).write(&path).expect("room");
        let bytes = std::fs::read(&path).expect("lots");
        for number in 0..40 {
            let mut changed = bytes.clone();
            for _ in 0..3 {
                random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let at = (random >> 33) as usize % changed.len();
                changed[at] = (random >> 20) as u8;
            }
            std::fs::write(&path, changed).expect("room");
            let name = format!("lots.{ending}");
            let output = run(folder.path(), &[&name, "--rules", "house.cga", "--out", "out", "--jobs", "1"]);
            let text = said(&output);
            assert!(
                !text.contains("panicked") && output.status.code().is_some_and(|code| code < 3),
                "{number}: {text}"
            );
            assert!(!text.chars().any(|character| character.is_control() && character != '\n'), "{number}: {text}");
        }
    }
    let lots = "{\"type\":\"Feature\",\"properties\":{\"id\":\"\\u001b]0;x\\u0007\"},\"geometry\":null}";
    std::fs::write(folder.path().join("lots.geojson"), lots).expect("room");
    let output = run(folder.path(), &["lots.geojson", "--rules", "house.cga", "--out", "out"]);
    assert!(said(&output).contains("(id \\u{1b}]0;x\\u{7}): it has no geometry"), "{}", said(&output));
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
