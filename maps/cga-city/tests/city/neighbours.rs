//! Rules that ask about other lots find lots of adjoining tiles.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use cga::RuleFile;
use cga_city::build::{Build, NoProgress, Options, Summary};
use cga_city::rules::Rules;
use cga_city::surroundings::Distances;
use cga_geo::survey::{Columns, Surveyor};

use crate::glb::{Glb, is_tile};
use crate::town::{build, files, options};

/// Houses without walls where they touch a neighbour. A house of 66 m has no end.
const ROW: &str = "attr height = 9  attr kind = \"home\"
    @StartRule Lot --> case height == 66 : Endless(1) else : extrude(height) label(\"house\") comp(f) { side : Wall | top : Roof. }
    Wall --> case touches(inter) : NIL else : Wall.
    Endless(n) --> case n < 0 : X. else : Endless(n + 1)
    @StartRule Block --> extrude(height) comp(f) { side : Wall. | top : Roof. }
    @StartRule Counted --> extrude(contextCount(inter, \"house\") + 1) comp(f) { top : Roof. } ";

const COUNT: usize = 40;

fn rules() -> Rules {
    Rules::new(vec![RuleFile::from_text(ROW).expect("good rules")]).expect("one file")
}

/// A row of houses without gaps, 8 m wide, from west to east across the meridian of a longitude.
fn row(path: &Path, longitude: f64, height: impl Fn(usize) -> f64) {
    let mut text = String::new();
    for at in 0..COUNT {
        let corner = |at: usize| longitude + (at as f64 - COUNT as f64 / 2.0) * 0.0001;
        let turned = |x: f64| if 180.0 < x { x - 360.0 } else { x };
        let [west, east] = [at, at + 1].map(|at| turned(corner(at)));
        let (south, north) = (48.0, 48.0001);
        let height = height(at);
        let _ = writeln!(
            text,
            "{{\"type\":\"Feature\",\"properties\":{{\"id\":\"{at}\",\"height\":{height}}},\"geometry\":{{\"type\":\"Polygon\",\
             \"coordinates\":[[[{west},{south}],[{east},{south}],[{east},{north}],[{west},{north}],[{west},{south}]]]}}}}"
        );
    }
    std::fs::write(path, text).expect("room");
}

fn small(lots_per_tile: u64) -> Options {
    Options { levels: Vec::new(), lots_per_tile, ..options() }
}

fn city(lots: &Path, out: &Path, options: Options) -> Summary {
    build(lots, out, &rules(), options, &NoProgress).expect("a city")
}

/// The number of vertices of each building of the near level, by name.
fn vertices(out: &Path) -> BTreeMap<usize, usize> {
    let near = files(out).into_iter().filter(|(name, _)| is_tile(name, 0));
    let buildings = near.flat_map(|(_, bytes)| Glb::new(&bytes).buildings());
    buildings.map(|building| (building.name.parse().expect("a number"), building.vertices)).collect()
}

#[test]
fn houses_of_adjoining_tiles_touch() {
    let folder = tempfile::tempdir().expect("a folder");
    let lots = folder.path().join("row.geojsonl");
    for (number, longitude) in [9.0, 180.0].into_iter().enumerate() {
        row(&lots, longitude, |_| 9.0);
        let out = |name: &str| folder.path().join(format!("{name}{number}"));
        let summary = city(&lots, &out("small"), small(3));
        assert!(12 < summary.levels[0].tiles, "{summary:?}");
        // A roof and two walls; a house at an end has three.
        let expected: BTreeMap<usize, usize> =
            (0..COUNT).map(|at| (at, if at == 0 || at == COUNT - 1 { 16 } else { 12 })).collect();
        assert_eq!(vertices(&out("small")), expected);
        city(&lots, &out("one"), small(1));
        assert_eq!(vertices(&out("one")), expected);
        // Without neighbours all houses have four walls.
        city(&lots, &out("alone"), Options { neighbours: None, ..small(3) });
        assert!(vertices(&out("alone")).values().all(|count| *count == 20));
        let one = Options { jobs: Some(1), ..small(3) };
        city(&lots, &out("thread"), one);
        assert!(files(&out("thread")) == files(&out("small")));
    }
}

#[test]
fn a_change_makes_the_tiles_within_the_distance_again_and_no_others() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out, fresh) =
        (folder.path().join("row.geojsonl"), folder.path().join("out"), folder.path().join("fresh"));
    row(&lots, 9.0, |_| 9.0);
    let near = Options { neighbours: Some(Distances { occlusion: 1.0, context: 1.0 }), ..small(1) };
    let all = city(&lots, &out, near.clone()).made;
    row(&lots, 9.0, |at| if at == 20 { 12.0 } else { 9.0 });
    let changed = city(&lots, &out, near.clone());
    // The lot and its two neighbours. Tiles of several lots that are divided are made again, too.
    assert_eq!((all, changed.made, changed.kept), (COUNT as u64, 3, COUNT as u64 - 3));
    city(&lots, &fresh, near);
    assert!(files(&fresh) == files(&out));
}

#[test]
fn a_house_that_fails_leaves_its_neighbours() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("row.geojsonl"), folder.path().join("out"));
    row(&lots, 9.0, |at| if at == 20 { 66.0 } else { 9.0 });
    let summary = city(&lots, &out, small(3));
    assert_eq!((summary.lost, summary.levels[0].buildings), (1, COUNT as u64 - 1));
    let found = vertices(&out);
    assert_eq!([found[&18], found[&19], found[&21], found[&22]], [12, 16, 16, 12]);
}

#[test]
fn labelled_shapes_of_other_tiles_are_counted_within_the_distance() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("row.geojsonl"), folder.path().join("out"));
    row(&lots, 9.0, |_| 9.0);
    let text = std::fs::read_to_string(&lots).expect("the file");
    let text = text.replacen("{\"id\":\"20\"", "{\"rule\":\"Counted\",\"id\":\"20\"", 1);
    std::fs::write(&lots, text).expect("room");
    // Lots of 7.5 m: four on each side.
    let neighbours = Some(Distances { occlusion: 1.0, context: 25.0 });
    let (rules, options) = (rules(), Options { neighbours, ..small(3) });
    let columns = Columns { id: Some("id".into()), start: Some("rule".into()), ..Columns::default() };
    let file = cga_geo::reader::open(&lots, &[]).expect("a file");
    let mut made = Build::begin(&out, options).expect("a folder");
    made.add("lots", file.rows, &Surveyor::new(rules.grammars(), columns), &NoProgress).expect("room");
    made.finish(&rules, &NoProgress).expect("a city");
    let near = files(&out).into_iter().filter(|(name, _)| is_tile(name, 0));
    let mut buildings = near.flat_map(|(_, bytes)| Glb::new(&bytes).buildings());
    let counted = buildings.find(|building| building.name == "20").expect("the house");
    assert!((counted.y[1] - 9.0).abs() < 0.05, "{counted:?}");
}
