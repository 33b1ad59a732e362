//! Meshes that rules insert: each is in its tile once, at the places of its buildings.

use std::collections::BTreeSet;

use cga::RuleFile;
use cga_city::build::{NoProgress, Options};
use cga_city::glb_bounds::{glb_bounds, json};
use cga_city::rules::Rules;
use cga_geo::synthetic::Town;

use crate::glb::is_tile;
use crate::town::{build, files, options};

/// A box from 0 to 1.
const HOUSE: &str = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1
f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

#[test]
fn buildings_of_inserted_meshes_alone_have_tiles() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out, assets) = (folder.path().join("town.fgb"), folder.path().join("out"), folder.path().join("assets"));
    Town::new(60).write(&lots).expect("room");
    std::fs::create_dir(&assets).expect("room");
    std::fs::write(assets.join("house.obj"), HOUSE).expect("room");
    let text = "attr height = 9  attr kind = \"home\"  Lot --> extrude(height) i(\"house.obj\")";
    let rules = Rules::new(vec![RuleFile::from_text(text).expect("good rules")]).expect("one file");
    let rules = rules.with_assets(&assets).expect("a folder");
    let options = Options { levels: Vec::new(), ..options() };
    let summary = build(&lots, &out, &rules, options, &NoProgress).expect("a city");
    assert!(0 < summary.levels[0].tiles, "{summary:?}");
    let mut buildings = 0;
    for (_, bytes) in files(&out).iter().filter(|(name, _)| is_tile(name, 0)) {
        let (file, bounds) = (json(bytes).expect("GLB"), glb_bounds(bytes).expect("GLB"));
        assert!((2.9..23.0).contains(&bounds.high[1]) && bounds.low[1].abs() < 0.5, "{bounds:?}");
        let nodes = file["nodes"].as_array().expect("nodes");
        let numbers: BTreeSet<u64> = nodes.iter().filter_map(|node| node["extras"]["building"].as_u64()).collect();
        // A mesh at one place is part of the tile's own mesh.
        let table = &file["extensions"]["EXT_structural_metadata"]["propertyTables"][0];
        let count = table["count"].as_u64().expect("a count");
        assert!(numbers.is_empty() && count == 1 || numbers == (0..count).collect(), "{numbers:?} of {count}");
        buildings += count;
    }
    assert_eq!(buildings, summary.lots);
}
