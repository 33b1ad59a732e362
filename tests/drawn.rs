//! The models that the repository shows: the scenes of the gallery, the examples, the steps of the tutorial.

use std::error::Error;

use cga::{Model, Settings};

use crate::scenes::{Scene, scenes};
use crate::{district, front, guide, hello, lots, massing, textured, tower};

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

/// All models.
pub fn drawn() -> Vec<Drawn> {
    let scene = |scene: Scene| Drawn::new(scene.name, move |settings| Ok(scene.model_with(settings)?));
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
    ];
    examples.into_iter().chain(scenes().into_iter().map(scene)).chain((1..=guide::STEPS).map(step)).collect()
}
