//! Images of the rules: one file for all tiles, or inside of the tiles.

use std::collections::BTreeMap;
use std::path::Path;

use cga::RuleFile;
use cga_city::build::{NoProgress, Options};
use cga_city::glb_bounds::json;
use cga_city::images::is_image;
use cga_city::rules::Rules;
use cga_geo::synthetic::Town;

use crate::town::{build, files, options};

const BRICKS: &str = "Lot --> extrude(height) comp(f) { side : setupProjection(0, scope.xy, 2, 2) texture(\"bricks.png\") projectUV(0) Wall. | top : Roof. }";

fn assets() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/guide/assets")
}

fn rules(text: &str) -> Rules {
    let text = format!("attr height = 9  attr kind = \"home\" {text}");
    let rules = Rules::new(vec![RuleFile::from_text(&text).expect("good rules")]).expect("one file");
    rules.with_assets(&assets()).expect("a folder")
}

/// Rules with walls of bricks, nearby and far away.
pub(crate) fn bricks() -> Rules {
    rules(&format!("@StartRule {BRICKS} @StartRule {}", BRICKS.replacen("Lot", "Block", 1)))
}

fn near(shares_images: bool) -> Options {
    Options { levels: Vec::new(), shares_images, ..options() }
}

fn images(files: &BTreeMap<String, Vec<u8>>) -> Vec<&String> {
    files.keys().filter(|name| name.starts_with("images/")).collect()
}

#[test]
fn an_image_is_one_file_for_all_tiles() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out, inside) = (folder.path().join("town.fgb"), folder.path().join("out"), folder.path().join("inside"));
    Town::new(100).write(&lots).expect("room");
    let bricks = std::fs::read(assets().join("bricks.png")).expect("an image");
    let shared = build(&lots, &out, &rules(BRICKS), near(true), &NoProgress).expect("a city");
    let own = build(&lots, &inside, &rules(BRICKS), near(false), &NoProgress).expect("a city");
    let found = files(&out);
    let [image] = images(&found)[..] else { panic!("one image: {:?}", images(&found)) };
    assert!(is_image(image) && found[image] == bricks);
    let tiles: Vec<_> = found.iter().filter(|(name, _)| name.ends_with(".glb")).collect();
    assert!(5 < tiles.len());
    for (name, bytes) in tiles {
        let list = json(bytes).expect("GLB")["images"].clone();
        assert_eq!(list, serde_json::json!([{ "uri": format!("../../../../{image}") }]));
        // The address leads from the folder of the tile to the image.
        let address = out.join(name).parent().expect("a folder").join(list[0]["uri"].as_str().expect("an address"));
        assert_eq!(std::fs::read(address).expect("the image"), bricks);
    }
    assert!(images(&files(&inside)).is_empty());
    let saved = own.levels[0].bytes - shared.levels[0].bytes;
    assert!((shared.levels[0].tiles - 1) * bricks.len() as u64 <= saved, "{saved}");
    // In the place of a city with images inside, all tiles are made again, and the other way round.
    let changed = build(&lots, &inside, &rules(BRICKS), near(true), &NoProgress).expect("a city");
    assert_eq!(changed.kept, 0);
    assert!(files(&inside) == found);
}

#[test]
fn a_missing_or_damaged_image_is_written_again_and_an_old_one_is_deleted() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.geojson"), folder.path().join("out"));
    Town::new(60).write(&lots).expect("room");
    let city = |text: &str| build(&lots, &out, &rules(text), near(true), &NoProgress).expect("a city");
    city(BRICKS);
    let before = files(&out);
    let image = images(&before)[0].clone();
    assert_eq!(city(BRICKS).made, 0);
    std::fs::remove_file(out.join(&image)).expect("the image");
    city(BRICKS);
    assert!(files(&out) == before);
    std::fs::write(out.join(&image), b"half").expect("room");
    assert!(0 < city(BRICKS).made);
    assert!(files(&out) == before);
    std::fs::write(out.join("images/letter.txt"), b"dear").expect("room");
    city(&BRICKS.replace("bricks", "tiles"));
    let after = files(&out);
    assert_eq!(images(&after).len(), 2);
    assert!(!after.contains_key(&image) && after.contains_key("images/letter.txt"));
}
