//! The pictures of the guide, `docs/guide/step-01.png` and so on, and the images of its walls and roofs in `docs/guide/assets`.
//!
//! `cargo run --release --example guide`

#[path = "../materials/mod.rs"]
mod materials;
mod step_01;
mod step_02;
mod step_03;
mod step_04;
mod step_05;
mod step_06;
mod step_07;
mod step_08;
mod step_09;
pub(crate) mod step_10;

use std::error::Error;
use std::path::Path;

use cga::sink::picture::Picture;
use cga::{Assets, Grammar, Model, Settings, Shape};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new("docs/guide");
    let images = materials::images();
    for (name, material) in [("bricks.png", "brick_red.png"), ("tiles.png", "tile_red.png")] {
        images[material].write_indexed_png(folder.join("assets").join(name))?;
    }
    let settings = Settings { assets: Assets::below(folder).into(), ..Settings::default() };
    for step in 1..=STEPS {
        write(step, &model(step, &settings)?)?;
    }
    println!("wrote the pictures of docs/guide");
    Ok(())
}

/// The number of steps.
pub(crate) const STEPS: usize = 10;

/// The model of a step, from 1 on.
pub(crate) fn model(step: usize, settings: &Settings) -> Result<Model, cga::Error> {
    let higher = step_03::House { storeys: 4.0 };
    let houses: [&dyn Grammar; STEPS - 1] = [
        &step_01::House::default(),
        &step_02::House::default(),
        &higher,
        &step_04::House::default(),
        &step_05::House::default(),
        &step_06::House::default(),
        &step_07::House::default(),
        &step_08::House::default(),
        &step_09::House::default(),
    ];
    match houses.get(step - 1) {
        Some(house) => house.generate_with(&Shape::rectangle(11.0, 8.0), settings),
        None => street(settings),
    }
}

/// A row of houses on lots of several widths, each with a seed of its own.
fn street(settings: &Settings) -> Result<Model, cga::Error> {
    let mut street = Model::new().with_assets(settings.assets.clone());
    let mut x = 0.0;
    for (seed, width) in (1..).zip([9.0, 7.0, 11.0, 8.0, 10.0, 7.5]) {
        let house = step_10::House::default();
        let model = house.generate_with(&Shape::rectangle(width, 8.0).at([x, 0.0, 0.0]).seed(seed), settings)?;
        street.append(&model);
        x += width + 2.5;
    }
    Ok(street)
}

fn write(step: usize, model: &Model) -> Result<(), Box<dyn Error>> {
    model.faults().iter().for_each(|fault| eprintln!("step {step}: {fault}"));
    picture(step).render(model).write_indexed_png(format!("docs/guide/step-{step:02}.png"))?;
    Ok(())
}

/// The view of a step.
pub(crate) fn picture(step: usize) -> Picture {
    // The street is long.
    let (width, height) = if step == 10 { (1200, 560) } else { (900, 620) };
    Picture::new(width, height).looking_from(28.0, 16.0)
}
