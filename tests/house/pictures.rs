//! The pictures of the pages.

use std::collections::HashMap;
use std::fs;
use std::path::PathBuf;

use cga_tests::tree::{files_below, root};

/// The largest size of a picture in bytes.
const LARGEST: usize = 400_000;

#[test]
fn no_two_pictures_are_equal() {
    let mut seen: HashMap<Vec<u8>, PathBuf> = HashMap::new();
    let pictures = files_below(&root().join("docs"), ".png");
    assert!(200 < pictures.len(), "the walk found the pictures");
    for path in pictures {
        let bytes = fs::read(&path).expect("a picture");
        assert!(bytes.len() <= LARGEST, "{}: {} bytes", path.display(), bytes.len());
        if let Some(other) = seen.insert(bytes, path.clone()) {
            panic!("{} and {} are the same picture", path.display(), other.display());
        }
    }
}

/// The pictures that users fetch: with the package `cga`, and with the chapters of the gallery.
#[test]
fn the_pictures_of_the_package_and_of_the_chapters_are_small() {
    const MOST: usize = 6_000_000;
    let gallery = root().join("docs/gallery");
    let (mut package, mut chapters) = (0, 0);
    for path in files_below(&root().join("docs"), ".png") {
        let size = fs::read(&path).expect("a picture").len();
        // The package leaves out the gallery, except for its scenes.
        let is_chapter = path.starts_with(&gallery) && !path.starts_with(gallery.join("scenes"));
        *(if is_chapter { &mut chapters } else { &mut package }) += size;
    }
    println!("{package} bytes in the package, {chapters} in the chapters");
    assert!(package <= MOST && chapters <= MOST, "{package} bytes in the package, {chapters} in the chapters");
}
