//! The grammars of the catalog, compiled. Tests compare the files of loaded rules with theirs.

use cga::{Grammar, Settings, Shape, cga};
use serde_json::Value;

use crate::catalog::entry;
use crate::engine::generate;
use crate::limits::LIMITS;
use crate::programs::{district, massing, streets, textured, tower};
use crate::request::Request;
use crate::scenes::scenes;

cga! { pub(crate) grammar House in "house.cga"; }

/// The GLB file of a request without rules and lots of its own.
///
/// # Errors
/// A sentence about the request.
pub fn glb(request: &Request) -> Result<Vec<u8>, String> {
    let entry = entry(&request.grammar).ok_or("no such grammar")?;
    let mut grammar = grammar(entry.name()).ok_or("no such grammar")?;
    for values in [entry.values, &Value::Object(request.values.clone()).to_string()] {
        grammar.set_values_json(values).map_err(|error| error.to_string())?;
    }
    let change = request.seed.unwrap_or(entry.seed()).wrapping_sub(entry.seed());
    let lots = entry.scene.shapes.iter().map(|start| {
        let seed = start.shape.seed_value().wrapping_add(change);
        start.shape.clone().seed(seed).start(start.rule)
    });
    let settings = Settings { limits: LIMITS, assets: entry.assets.clone(), ..Settings::default() };
    let (model, _) = generate(&*grammar, &lots.collect::<Vec<Shape>>(), &settings)?;
    model.to_glb().map_err(|error| error.to_string())
}

fn grammar(name: &str) -> Option<Box<dyn Grammar + Send + Sync>> {
    Some(match name {
        "house" => Box::new(House::default()),
        "office_tower" => Box::new(tower::Tower::default()),
        "district" => Box::new(district::House::default()),
        "massing" => Box::new(massing::Massing::default()),
        "street_network" => Box::new(streets::Streets::default()),
        "brick_tower" => Box::new(textured::Tower::default()),
        "marked_streets" => Box::new(textured::Streets::default()),
        _ => scenes().into_iter().find(|scene| scene.name == name)?.grammar,
    })
}
