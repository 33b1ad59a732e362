//! Runs that end early, and runs after a change.

use std::collections::BTreeMap;
use std::io;
use std::sync::atomic::{AtomicU64, Ordering};

use cga_city::build::{Build, NoProgress, Progress};
use cga_city::tree::TileEvent;
use cga_geo::synthetic::Town;

use crate::town::{build, city, files, options, rules};

/// Ends the run after a number of tiles.
struct Stop {
    left: AtomicU64,
}

impl Progress for Stop {
    fn tile(&self, _: &TileEvent<'_>) -> io::Result<()> {
        let before = self.left.fetch_update(Ordering::SeqCst, Ordering::SeqCst, |left| left.checked_sub(1));
        before.map(drop).map_err(|_| io::Error::other("stopped"))
    }
}

#[test]
fn a_run_that_was_stopped_goes_on_and_makes_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let lots = folder.path().join("town.parquet");
    Town::new(600).write(&lots).expect("room");
    let whole = folder.path().join("whole");
    let all = city(&lots, &whole);
    let stopped = folder.path().join("stopped");
    let stop = Stop { left: AtomicU64::new(20) };
    let error = build(&lots, &stopped, &rules(), options(), &stop).expect_err("it was stopped");
    assert!(error.contains("stopped"));
    assert!(!stopped.join("tileset.json").exists());
    let rest = city(&lots, &stopped);
    // Tiles that were finished are not made again. Threads may finish some more after the first refusal.
    assert!(20 <= rest.kept && rest.kept < all.made, "{rest:?}");
    assert_eq!(rest.kept + rest.made, all.made);
    assert!(files(&stopped) == files(&whole));
    let again = city(&lots, &stopped);
    assert_eq!((again.made, again.kept), (0, all.made));
    assert!(files(&stopped) == files(&whole));
}

#[test]
fn a_damaged_tile_is_made_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.geojson"), folder.path().join("out"));
    Town::new(100).write(&lots).expect("room");
    city(&lots, &out);
    let before = files(&out);
    let (name, bytes) = before.iter().find(|(name, _)| name.ends_with(".glb")).expect("a tile");
    std::fs::write(out.join("tiles/.part-of-a-killed-run"), b"half").expect("room");
    let mut flipped = bytes.clone();
    flipped[bytes.len() / 2] ^= 1;
    for damaged in [b"glTF".to_vec(), vec![0; bytes.len()], flipped] {
        std::fs::write(out.join(name), damaged).expect("room");
        assert_eq!(city(&lots, &out).made, 1);
        assert!(files(&out) == before);
    }
}

#[test]
fn a_change_makes_the_tiles_of_its_lots_alone_and_old_tiles_are_deleted() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.geojson"), folder.path().join("out"));
    Town::new(400).write(&lots).expect("room");
    let all = city(&lots, &out).made;
    let text = std::fs::read_to_string(&lots).expect("the file");
    std::fs::write(&lots, text.replacen("\"height\":", "\"height\":1", 1)).expect("room");
    let changed = city(&lots, &out);
    // The lot is in a near tile and in a far one.
    assert_eq!((changed.made, changed.kept), (2, all - 2));
    let fewer = Town::new(50);
    fewer.write(&lots).expect("room");
    city(&lots, &out);
    let fresh = folder.path().join("fresh");
    city(&lots, &fresh);
    assert!(files(&out) == files(&fresh));
}

#[test]
fn other_rules_make_all_tiles_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.geojson"), folder.path().join("out"));
    Town::new(100).write(&lots).expect("room");
    let all = city(&lots, &out).made;
    let mut changed = rules();
    changed.set("slope", "50").expect("an attribute");
    let summary = build(&lots, &out, &changed, options(), &NoProgress).expect("a city");
    assert_eq!((summary.made, summary.kept), (all, 0));
}

#[test]
fn a_folder_with_other_files_is_left_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.geojson"), folder.path().join("out"));
    Town::new(10).write(&lots).expect("room");
    std::fs::create_dir(&out).expect("room");
    std::fs::write(out.join("letter.txt"), b"dear").expect("room");
    let error = build(&lots, &out, &rules(), options(), &NoProgress).expect_err("refused");
    assert!(error.contains("files that are not a city"), "{error}");
    assert_eq!(std::fs::read_dir(&out).expect("a folder").count(), 1);
}

#[cfg(unix)]
#[test]
fn links_are_not_followed_and_files_of_others_stay_among_the_tiles() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out, other) =
        (folder.path().join("town.geojson"), folder.path().join("out"), folder.path().join("other"));
    Town::new(20).write(&lots).expect("room");
    city(&lots, &out);
    std::fs::create_dir(&other).expect("room");
    let names = ["tiles/notes.txt", "tiles/my.json", "tiles/0/house.glb", "sets/old.json"].map(|name| out.join(name));
    let letters = [other.join("house.glb")].into_iter().chain(names).collect::<Vec<_>>();
    letters.iter().for_each(|path| std::fs::write(path, b"dear").expect("room"));
    std::os::unix::fs::symlink(&other, out.join("tiles/backup")).expect("a link");
    city(&lots, &out);
    assert!(letters.iter().all(|path| path.exists()));
}

#[test]
fn a_file_without_lots_leaves_the_older_city() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.geojson"), folder.path().join("out"));
    Town::new(20).write(&lots).expect("room");
    city(&lots, &out);
    let tiles = |files: BTreeMap<String, Vec<u8>>| files.keys().filter(|name| name.ends_with("glb")).count();
    let before = tiles(files(&out));
    std::fs::write(&lots, "{\"type\":\"FeatureCollection\",\"features\":[]}").expect("room");
    city(&lots, &out);
    assert!(0 < before && tiles(files(&out)) == before);
}

#[test]
fn a_folder_has_one_run_at_a_time() {
    let folder = tempfile::tempdir().expect("a folder");
    let (lots, out) = (folder.path().join("town.geojson"), folder.path().join("out"));
    Town::new(20).write(&lots).expect("room");
    let first = Build::begin(&out, options()).expect("a new folder");
    let error = build(&lots, &out, &rules(), options(), &NoProgress).expect_err("locked");
    assert!(error.contains("another run of cga-city writes to"), "{error}");
    // The lock ends with the run.
    drop(first);
    city(&lots, &out);
    let before = files(&out);
    city(&lots, &out);
    assert!(files(&out) == before);
}
