//! The pictures of the tutorial.

use std::fs;

use cga_tests::tree::root;
use cga_tests::tutorial::INLINE;
use cga_tests::tutorial_pictures::picture;

#[test]
fn the_pictures_of_the_tutorial_show_the_models_of_today() {
    for step in 1..=INLINE {
        let path = root().join(format!("docs/guide/step-{step:02}.png"));
        let same = fs::read(&path).expect("a picture") == picture(step);
        assert!(same, "{}: `cargo run --release --example guide` writes it again", path.display());
    }
}
