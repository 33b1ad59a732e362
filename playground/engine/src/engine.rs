//! The engine: it loads rules, runs them, and keeps the last model.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

use cga::sink::gltf::Glb;
use cga::{Assets, Flow, Grammar, Model, RuleFile, RuleLoader, Scene, Settings, Shape, Watch, WrongLots};
use serde::Serialize;
use serde_json::{Map, Value, json};

use crate::catalog::{entries, entry};
use crate::entry::CatalogEntry;
use crate::facts::facts;
use crate::finding::{Finding, findings};
use crate::limits::{LIMITS, SECONDS};
use crate::request::Request;

/// The time since any start.
pub type Clock = fn() -> Duration;

/// Loads rules and runs them. It keeps the rules that were loaded last, and the last complete run.
pub struct Engine {
    clock: Clock,
    loaded: Option<Loaded>,
    files: BTreeMap<String, Vec<u8>>,
    run: Option<Run>,
}

/// Rules that were loaded.
struct Loaded {
    text: String,
    name: String,
    grammar: Option<RuleFile>,
    findings: Vec<Finding>,
}

/// A complete run.
pub struct Run {
    /// The rules with the values of the run.
    pub(crate) grammar: RuleFile,
    /// The rules as text.
    pub(crate) text: String,
    /// The initial shapes with their start rules.
    pub(crate) lots: Vec<Shape>,
    /// The number of leaves before the leaves of each initial shape.
    pub(crate) starts: Vec<usize>,
    pub(crate) settings: Settings,
    /// All leaves.
    pub model: Model,
}

/// The answer to a request.
#[derive(Debug, Default, Serialize)]
pub struct Answer {
    /// Errors and warnings about the rules.
    pub findings: Vec<Finding>,
    /// The values that the rules do not take, by attribute, with the reasons. The run has defaults in their place.
    pub refused: BTreeMap<String, String>,
    /// The reason why the run failed. Errors in the rules are findings.
    pub error: Option<String>,
    /// The facts about the run; `None` if there was none.
    pub facts: Option<Value>,
}

impl Engine {
    /// An engine without files.
    pub fn new(clock: Clock) -> Self {
        Engine { clock, loaded: None, files: BTreeMap::new(), run: None }
    }

    /// Adds a file that rules can name: an image or a mesh.
    pub fn add_file(&mut self, name: &str, bytes: Vec<u8>) {
        self.files.insert(name.to_owned(), bytes);
    }

    /// The last complete run.
    pub fn last(&self) -> Option<&Run> {
        self.run.as_ref()
    }

    /// Loads the rules of a request and runs them.
    pub fn answer(&mut self, request: &Request) -> Answer {
        let Some(entry) = entry(&request.grammar) else {
            return Answer { error: Some(unknown(&request.grammar)), ..Answer::default() };
        };
        let text = request.rules.as_deref().unwrap_or(entry.rules());
        let name = request.name.as_deref().unwrap_or(entry.grammar);
        let files = self.files.clone();
        let loaded = self.loaded(text, name);
        let findings = loaded.findings.clone();
        let Some(grammar) = &loaded.grammar else {
            return Answer { findings, ..Answer::default() };
        };
        let mut grammar = grammar.clone();
        let refused = set_values(&mut grammar, entry, request);
        let assets = if files.is_empty() { entry.assets.clone() } else { Arc::new(Assets::from_source(files)) };
        match run(grammar, entry, request, text, assets, self.clock) {
            Ok((run, notes)) => {
                let facts = Some(facts(&run.text, &run.grammar, entry.values, &run.model, &notes));
                self.run = Some(run);
                Answer { findings, refused, error: None, facts }
            }
            Err(error) => Answer { findings, refused, error: Some(error), facts: None },
        }
    }

    /// The rules of a text, which are loaded if they are not the last ones.
    fn loaded(&mut self, text: &str, name: &str) -> &Loaded {
        let is_same = |loaded: &Loaded| loaded.text == text && loaded.name == name;
        match self.loaded.take_if(|loaded| !is_same(loaded)) {
            _ if self.loaded.is_some() => {}
            _ => self.loaded = Some(load(text, name)),
        }
        self.loaded.get_or_insert_with(|| load(text, name))
    }
}

fn load(text: &str, name: &str) -> Loaded {
    let grammar = RuleLoader::new().named(name).text(text).ok();
    // Findings have places in the text, which messages do not have. Most texts have none while they run.
    let has_none = grammar.as_ref().is_some_and(|grammar| grammar.warnings().is_empty());
    let findings = if has_none { Vec::new() } else { findings(text) };
    Loaded { text: text.to_owned(), name: name.to_owned(), grammar, findings }
}

fn unknown(name: &str) -> String {
    let known: Vec<&str> = entries().iter().map(|entry| entry.name()).collect();
    format!("there is no grammar `{name}`; the page has {}", known.join(", "))
}

/// Sets the values of a request. Returns the reasons of the values that the rules do not take.
fn set_values(grammar: &mut RuleFile, entry: &CatalogEntry, request: &Request) -> BTreeMap<String, String> {
    let mut refused = BTreeMap::new();
    // Another text may not have the attributes.
    let _ = grammar.set_values_json(entry.values);
    // A choice and its list may come together.
    if grammar.set_values_json(&Value::Object(request.values.clone()).to_string()).is_err() {
        for (name, value) in &request.values {
            let one: Map<String, Value> = [(name.clone(), value.clone())].into_iter().collect();
            if let Err(error) = grammar.set_values_json(&Value::Object(one).to_string()) {
                refused.insert(name.clone(), error.to_string());
            }
        }
    }
    refused
}

/// The initial shapes of a request, and notes about parts of a file that are left out.
fn lots(grammar: &RuleFile, entry: &CatalogEntry, request: &Request) -> Result<(Vec<Shape>, Vec<String>), String> {
    let (shapes, notes) = match &request.lot {
        Some(lot) => lot.shapes(grammar)?,
        None => {
            let start = |start: &crate::scenes::scene::Start| start.shape.clone().start(start.rule);
            (entry.scene.shapes.iter().map(start).collect(), Vec::new())
        }
    };
    let first = shapes.first().map_or(0, Shape::seed_value);
    let change = request.seed.map_or(0, |seed| seed.wrapping_sub(first));
    let place = |shape: Shape| {
        let seed = shape.seed_value().wrapping_add(change);
        let shape = shape.seed(seed);
        match &request.start {
            Some(start) => shape.start(start.clone()),
            None => shape,
        }
    };
    Ok((shapes.into_iter().map(place).collect(), notes))
}

/// Runs rules on their initial shapes, which may ask about each other.
fn run(
    grammar: RuleFile,
    entry: &CatalogEntry,
    request: &Request,
    text: &str,
    assets: Arc<Assets>,
    clock: Clock,
) -> Result<(Run, Vec<String>), String> {
    let (lots, notes) = lots(&grammar, entry, request)?;
    // A start rule may be gone from a text that a person changes.
    let settings = Settings { limits: LIMITS, assets, wrong_lots: WrongLots::Fault, ..Settings::default() };
    let watch = Watch::deadline_by(Duration::from_secs(SECONDS), clock);
    let (model, starts) = generate(&grammar, &lots, &Settings { watch: Some(watch), ..settings.clone() })?;
    Ok((Run { grammar, text: text.to_owned(), lots, starts, settings, model }, notes))
}

/// The most leaves of a model that is shown without cracks.
const NEAR_LEAVES: usize = 4000;

/// The model of all initial shapes, and the number of leaves before each.
pub(crate) fn generate(
    grammar: &(dyn Grammar + Sync),
    lots: &[Shape],
    settings: &Settings,
) -> Result<(Model, Vec<usize>), String> {
    let mut model: Option<Model> = None;
    let mut starts = Vec::with_capacity(lots.len());
    let take = |_: usize, one: Model| {
        starts.push(model.as_ref().map_or(0, Model::len));
        match &mut model {
            None => model = Some(one),
            Some(model) => model.append(&one),
        }
        Flow::Continue(())
    };
    let report = Scene::new(grammar, lots).generate_each(settings, take).map_err(|error| error.error.to_string())?;
    if report.stopped {
        return Err(format!("the run was ended after {SECONDS} seconds; use smaller values"));
    }
    Ok((model.unwrap_or_default(), starts))
}

impl Run {
    /// The GLB file.
    ///
    /// # Errors
    /// A sentence about the model.
    pub fn glb(&self) -> Result<Vec<u8>, String> {
        self.model.to_glb().map_err(|error| error.to_string())
    }

    /// The GLB file for the view. A small model, which is seen from nearby, has no cracks through which single pixels would show. A large one
    /// is as the file for downloads, as its run would take several times as long.
    ///
    /// # Errors
    /// A sentence about the model.
    pub fn view_glb(&self) -> Result<Vec<u8>, String> {
        if NEAR_LEAVES < self.model.len() {
            return self.glb();
        }
        self.model.watertight().to_glb().map_err(|error| error.to_string())
    }

    /// A GLB file with a node for each rule.
    ///
    /// # Errors
    /// A sentence about the model.
    pub fn glb_by_rule(&self) -> Result<Vec<u8>, String> {
        let mut glb = Glb::new().named(self.grammar.name()).by_rule();
        if let Some(assets) = self.model.assets() {
            glb = glb.with_assets(assets.clone());
        }
        // A file takes all leaves.
        let _ = self.model.replay(&mut glb);
        glb.into_bytes().map_err(|error| error.to_string())
    }

    /// An OBJ file that refers to a material library with a name, and the library.
    pub fn obj(&self, library: &str) -> (String, String) {
        self.model.to_obj(library)
    }

    /// Reports, prints and faults as JSON.
    pub fn report(&self) -> String {
        json!(self.model.report()).to_string()
    }
}
