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
