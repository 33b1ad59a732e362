//! Runs: a grammar with values and a seed becomes a model and a GLB file.

use std::collections::BTreeMap;

use cga::{Flow, Limits, Model, Scene, Settings, Shape};
use serde::Deserialize;
use serde_json::{Map, Value, json};

use crate::catalog::{entries, entry};
use crate::entry::CatalogEntry;
use crate::scenes::scene::Start;

/// A request for a run. A page sends it as JSON.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// The name of the grammar.
    pub grammar: String,
    /// Attributes by name; the others have their defaults.
    #[serde(default)]
    pub values: Map<String, Value>,
    /// The seed of the first shape: the seeds of the others change by the same amount. `None` for the seeds of the scene.
    #[serde(default)]
    pub seed: Option<u64>,
}

impl Request {
    /// A run with defaults.
    pub fn of(grammar: &str) -> Self {
        Request { grammar: grammar.to_owned(), ..Request::default() }
    }
}

/// The result of a run.
pub struct Run {
    /// All leaves.
    pub model: Model,
    /// Attributes, the values that the run used, counts, reports and faults as a JSON object.
    pub facts: String,
    /// The GLB file.
    pub glb: Vec<u8>,
}

/// A page must stay responsive, and a 32-bit memory has 4 GB.
fn limits() -> Limits {
    Limits {
        shapes: 400_000,
        vertices: 4_000_000,
        waiting: 50_000,
        calls: 10_000_000,
        reports: 1000,
        prints: 200,
        text: 1_000_000,
        ..Limits::default()
    }
}

impl Run {
    /// Runs a grammar.
    ///
    /// # Errors
    /// A sentence for the person at the page: an unknown grammar, a refused value, a limit.
    pub fn new(request: &Request) -> Result<Self, String> {
        let entry = entry(&request.grammar).ok_or_else(|| unknown(&request.grammar))?;
        let mut grammar = entry.scene.grammar.clone();
        let values = Value::Object(request.values.clone()).to_string();
        grammar.set_values_json(&values).map_err(|error| error.to_string())?;
        let change = request.seed.unwrap_or(entry.seed()).wrapping_sub(entry.seed());
        let settings = Settings { limits: limits(), assets: entry.assets.clone(), ..Settings::default() };
        let place = |start: &Start| {
            let shape = start.shape.clone().seed(start.shape.seed_value().wrapping_add(change));
            shape.start(start.rule)
        };
        let lots: Vec<Shape> = entry.scene.shapes.iter().map(place).collect();
        let mut used = BTreeMap::new();
        for shape in &lots {
            for (name, value) in grammar.used_values(shape, &settings).map_err(|error| error.to_string())? {
                let list: &mut Vec<Value> = used.entry(name).or_default();
                let value = serde_json::to_value(&value).unwrap_or_default();
                if !list.contains(&value) {
                    list.push(value);
                }
            }
        }
        // Rules may ask about the other shapes of the scene.
        let mut model: Option<Model> = None;
        let take = |_: usize, one: Model| {
            match &mut model {
                None => model = Some(one),
                Some(model) => model.append(&one),
            }
            Flow::Continue(())
        };
        Scene::new(&*grammar, &lots).generate_each(&settings, take).map_err(|error| error.error.to_string())?;
        let model = model.unwrap_or_default();
        let glb = model.to_glb().map_err(|error| error.to_string())?;
        let attributes: Value = serde_json::from_str(&grammar.attributes_json()).unwrap_or_default();
        let facts = facts(entry, &model, attributes, used);
        Ok(Run { model, facts, glb })
    }
}

fn unknown(name: &str) -> String {
    let known: Vec<&str> = entries().iter().map(|entry| entry.name()).collect();
    format!("there is no grammar `{name}`; the page has {}", known.join(", "))
}

fn facts(entry: &CatalogEntry, model: &Model, attributes: Value, used: BTreeMap<cga::Text, Vec<Value>>) -> String {
    let rules = model
        .counts()
        .into_iter()
        .map(|(rule, leaves)| json!({ "name": rule, "leaves": leaves, "lines": entry.lines(rule) }));
    let bounds = model.bounds();
    json!({
        "attributes": attributes,
        "used": used,
        "rules": rules.collect::<Vec<_>>(),
        "low": bounds.low.to_array(),
        "high": bounds.high.to_array(),
        "report": serde_json::to_value(model.report()).unwrap_or_default(),
        "faults": model.faults().iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
    .to_string()
}
