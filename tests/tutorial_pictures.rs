//! The pictures of the tutorial.

use cga::{Assets, Error, Model, Settings, Shape};

use crate::guide;
use crate::tree::root;

fn settings() -> Settings {
    Settings { assets: Assets::below(root().join("docs/guide")).into(), ..Settings::default() }
}

/// The house of step 11, whose program loads the rules of the step before.
pub(crate) fn loaded(settings: &Settings) -> Result<Model, Error> {
    let house = guide::step_10::House { storeys: Some(3.0), ..Default::default() };
    house.generate_with(&Shape::rectangle(11.0, 8.0).seed(1), settings)
}

/// The bytes of the picture that the program of a step writes.
///
/// # Panics
/// If the run fails.
pub fn written(step: usize) -> Vec<u8> {
    let model = match step {
        11 => loaded(&settings()),
        _ => guide::model(step, &settings()),
    };
    let mut png = Vec::new();
    model.expect("a model").write_png_to(&mut png).expect("a picture");
    png
}

/// The bytes of a step's picture in the tutorial, drawn again.
///
/// # Panics
/// If the run fails.
pub fn picture(step: usize) -> Vec<u8> {
    let model = guide::model(step, &settings()).expect("a model");
    assert_eq!(model.faults(), []);
    let mut png = Vec::new();
    guide::picture(step).render(&model).write_indexed_png_to(&mut png).expect("a picture");
    png
}
