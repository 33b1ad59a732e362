//! The models that the repository shows: the scenes of the gallery, the examples, the steps of the tutorial, the first rules of the
//! playground.

use std::error::Error;

use cga::street::{Network, NetworkOptions};
#[cfg(feature = "eval")]
use cga::{Grammar, Grammars, RuleFile};
use cga::{Model, Settings, Shape};

use crate::scenes::materials::single_pixels;
use crate::scenes::{Scene, scenes};
#[cfg(feature = "eval")]
use crate::tree::root;
use crate::{district, front, guide, hello, lots, massing, metropolis, streets, textured, tower, tutorial_pictures};

/// The number of buildings of the metropolis.
const METROPOLIS: usize = 6;

/// A model, or the error of its run.
pub type Made = Result<Model, Box<dyn Error>>;

/// A model that the repository shows.
pub struct Drawn {
    pub name: String,
    make: Box<dyn Fn(&Settings) -> Made + Send + Sync>,
}

impl Drawn {
    pub fn new(name: impl Into<String>, make: impl Fn(&Settings) -> Made + Send + Sync + 'static) -> Self {
        Drawn { name: name.into(), make: Box::new(make) }
    }

    /// The model, with its tree of shapes or without.
    ///
    /// # Panics
    /// When the run ends with an error.
    pub fn model(&self, tree: bool) -> Model {
        let settings = Settings { tree, ..Settings::default() };
        (self.make)(&settings).unwrap_or_else(|error| panic!("{}: {error}", self.name))
    }
}

/// The models of rule files, which the rules of this package cannot name: the example `from_file`, and the first rules of the playground.
#[cfg(feature = "eval")]
fn rule_files() -> Vec<Drawn> {
    let file = |name, path: &'static str, lot: Shape| {
        Drawn::new(name, move |settings| Ok(RuleFile::open(root().join(path))?.generate_with(&lot, settings)?))
    };
    let house = Shape::rectangle(14.0, 9.0).seed(3).attribute("floors", 4.0);
    vec![
        file("example from_file", "examples/rules/house.cga", house),
        file("playground house", "playground/engine/house.cga", Shape::rectangle(20.0, 15.0)),
        Drawn::new("city in Bevy", bevy_street),
    ]
}

/// Three houses of the city in `bevy_cga`, at a street with parked cars.
#[cfg(feature = "eval")]
fn bevy_street(settings: &Settings) -> Made {
    let open = |name| RuleFile::open(root().join(format!("bevy_cga/city/rules/{name}.cga")));
    let grammars = Grammars::new().with_named("House", open("house")?).with_named("Ground", open("ground")?);
    let ground = |start, size: [f64; 2], at: [f64; 3]| {
        Shape::rectangle(size[0], size[1]).at(at).grammar("Ground").start(start).seed(at[0].abs() as u64)
    };
    let house = |number: u32| {
        let at = [13.0 * f64::from(number), 0.15, -15.0];
        Shape::rectangle(13.0, 12.0).at(at).grammar("House").seed(number.into())
    };
    let lane = |number: u32| ground("Street", [15.0, 5.0], [15.0 * f64::from(number) - 3.0, 0.0, 0.0]);
    let around = [
        ground("Asphalt", [60.0, 13.0], [-8.0, 0.0, 0.0]),
        ground("Sidewalk", [60.0, 40.0], [-8.0, 0.0, -40.0]),
        ground("Garden", [54.0, 18.0], [-5.0, 0.17, -37.0]),
    ];
    let lots: Vec<Shape> = (0..3).map(house).chain((0..3).map(lane)).chain(around).collect();
    let settings = Settings { assets: single_pixels(), ..settings.clone() };
    Ok(cga::Scene::of_grammars(&grammars, &lots).generate(&settings)?.to_model())
}

#[cfg(not(feature = "eval"))]
fn rule_files() -> Vec<Drawn> {
    Vec::new()
}

/// All models.
pub fn drawn() -> Vec<Drawn> {
    let scene = |scene: Scene| {
        Drawn::new(scene.name, move |settings| {
            Ok(scene.model_with(&Settings { assets: single_pixels(), ..settings.clone() })?)
        })
    };
    let step = |step| Drawn::new(format!("tutorial step {step}"), move |settings| Ok(guide::model(step, settings)?));
    let examples = [
        Drawn::new("example hello", |settings| Ok(hello::model(settings)?)),
        Drawn::new("example front", |settings| Ok(front::model(settings)?)),
        Drawn::new("example tower", |settings| Ok(tower::model(settings)?)),
        Drawn::new("example textured", textured::model),
        Drawn::new("example lots", |settings| Ok(lots::model(settings)?.to_model())),
        Drawn::new("example district", |settings| {
            let (lots, _) = district::lots(district::SAMPLE)?;
            Ok(district::derive(&lots, settings, |_, _| {})?.0)
        }),
        Drawn::new("example massing", |settings| {
            let mut masses = Model::new();
            massing::models(settings)?.iter().for_each(|(_, model)| masses.append(model));
            Ok(masses)
        }),
        Drawn::new("example streets", |settings| {
            let (lines, _) = streets::read(streets::SAMPLE)?;
            Ok(streets::model(&Network::new(&lines, &NetworkOptions::default())?, settings)?)
        }),
        Drawn::new("example metropolis", |settings| {
            let lots: Vec<Shape> = (0..METROPOLIS).map(metropolis::lot).collect();
            Ok(metropolis::City::default().generate_all(&lots, settings)?.to_model())
        }),
        Drawn::new("tutorial step 11", |settings| Ok(tutorial_pictures::loaded(settings)?)),
    ];
    examples
        .into_iter()
        .chain(rule_files())
        .chain(scenes().into_iter().map(scene))
        .chain((1..=guide::STEPS).map(step))
        .collect()
}
