//! The Khronos validator on a sample of tiles. It is skipped, with a line, where Node or the package `gltf-validator` is missing:
//! `.ci/maps` installs the package.

use std::path::Path;
use std::process::Command;

use cga_city::build::{NoProgress, Options};
use cga_geo::synthetic::Town;

use crate::images::bricks;
use crate::town::{build, city, files, options, rules};

#[test]
fn the_khronos_validator_finds_no_error_in_tiles() {
    let tools = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tools");
    if !tools.join("node_modules/gltf-validator").is_dir() || Command::new("node").arg("--version").output().is_err() {
        eprintln!("skipped: the Khronos validator needs Node, and `npm ci` in maps/tools");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let lots = folder.path().join("town.fgb");
    Town::new(1000).write(&lots).expect("room");
    let [usual, images, plain] = ["usual", "images", "plain"].map(|name| folder.path().join(name));
    city(&lots, &usual);
    build(&lots, &images, &bricks(), options(), &NoProgress).expect("a city");
    build(&lots, &plain, &rules(), Options { plain_far: true, ..options() }, &NoProgress).expect("a city");
    let tiles: Vec<_> = [usual, images, plain]
        .iter()
        .flat_map(|out| files(out).into_keys().filter(|name| name.ends_with(".glb")).map(|name| out.join(name)))
        .collect();
    let run = Command::new("node").arg(tools.join("validate.mjs")).args(&tiles).output().expect("node");
    let text = String::from_utf8_lossy(&run.stdout);
    assert!(run.status.success(), "{text}{}", String::from_utf8_lossy(&run.stderr));
    assert!(text.contains(&format!("{} files, 0 errors", tiles.len())), "{text}");
}
