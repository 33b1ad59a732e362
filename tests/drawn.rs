//! The models that the repository shows: the scenes of the gallery, the examples, the steps of the tutorial.

use cga::{Error, Model, RunError, Settings};

use crate::scenes::scenes;
use crate::{district, guide, lots, massing, readme, textured, tower};

/// A model that the repository shows.
pub struct Drawn {
    pub name: String,
    pub model: Model,
}

/// All models, with their trees of shapes.
///
/// # Panics
/// When a run ends with an error.
pub fn drawn() -> Vec<Drawn> {
    let settings = Settings { tree: true, ..Settings::default() };
    let mut list: Vec<Drawn> = scenes()
        .iter()
        .map(|scene| Drawn { name: scene.name.to_owned(), model: scene.model_with(&settings).expect("a scene") })
        .collect();
    let mut add = |name: &str, model: Result<Model, Error>| {
        list.push(Drawn { name: name.to_owned(), model: model.expect("an example") });
    };
    add("example readme", readme::model(&settings));
    add("example tower", tower::model(&settings));
    for (step, model) in (1..).zip(guide::models(&settings).expect("the tutorial")) {
        add(&format!("tutorial step {step}"), Ok(model));
    }
    let mut masses = Model::new();
    massing::models(&settings).expect("an example").iter().for_each(|(_, model)| masses.append(model));
    add("example massing", Ok(masses));
    add("example textured", Ok(textured::model(&settings).expect("an example")));
    let failed = |error: RunError| error.error;
    add("example lots", lots::model(&settings).map(|models| models.to_model()).map_err(failed));
    let (lots, _) = district::lots(district::SAMPLE).expect("the sample");
    add("example district", district::derive(&lots, &settings, |_, _| {}).map(|made| made.0).map_err(failed));
    list
}
