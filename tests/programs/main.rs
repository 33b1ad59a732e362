//! The programs of the tutorial that read its files draw the pictures of its steps. The test `builds` compiles the same programs in the
//! package of a user; here they use the libraries that other tests have built.

use std::path::Path;
use std::{env, fs, thread};

use cga_tests::tree::root;
use cga_tests::tutorial_pictures::written;

/// A program as a module with a function that runs it.
macro_rules! program {
    ($name:ident) => {
        mod $name {
            // The compiler looks for images beside the manifest.
            #![allow(deprecated)]
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));

            pub(super) fn run() {
                main().expect("a run");
            }
        }
    };
}

program!(ninth);
program!(tenth);
program!(loaded);

// The only test of this program, as it changes the working folder.
#[test]
fn programs_draw_the_pictures_of_their_steps() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drawn");
    fs::create_dir_all(folder.join("assets")).expect("a writable target folder");
    for file in ["house.cga", "assets/bricks.png", "assets/tiles.png"] {
        fs::copy(root().join("docs/guide").join(file), folder.join(file)).expect("a file of the tutorial");
    }
    env::set_current_dir(&folder).expect("a folder");
    for (name, picture, step) in [("ninth", "house.png", 9), ("tenth", "street.png", 10), ("loaded", "house.png", 11)] {
        let _ = fs::remove_file(picture);
        let expected = thread::spawn(move || written(step));
        match name {
            "ninth" => ninth::run(),
            "tenth" => tenth::run(),
            _ => loaded::run(),
        }
        let expected = expected.join().expect("a picture");
        assert!(fs::read(picture).expect("a picture") == expected, "the program `{name}` draws another {picture}");
    }
}
