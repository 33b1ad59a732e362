//! The functions that the page calls.

use std::time::Duration;

use cga::glam::DVec3;
use wasm_bindgen::prelude::*;

use crate::chain::Trees;
use crate::engine::{Engine, Run};
use crate::pick::Picker;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

/// The clock of the page.
fn clock() -> Duration {
    Duration::from_secs_f64(now() / 1e3)
}

/// The grammars as a JSON list.
#[wasm_bindgen]
pub fn catalog() -> String {
    crate::catalog::json()
}

/// The engine of a page.
#[wasm_bindgen]
pub struct PageEngine {
    engine: Engine,
    /// Made when it is needed.
    picker: Option<Picker>,
    trees: Trees,
}

#[wasm_bindgen]
impl PageEngine {
    /// An engine without files.
    #[wasm_bindgen(constructor)]
    #[expect(clippy::new_without_default, reason = "JavaScript has no defaults")]
    pub fn new() -> PageEngine {
        PageEngine { engine: Engine::new(clock), picker: None, trees: Trees::default() }
    }

    /// Adds a file that rules can name.
    #[wasm_bindgen(js_name = addFile)]
    pub fn add_file(&mut self, name: &str, bytes: Vec<u8>) {
        self.engine.add_file(name, bytes);
    }

    /// Runs the JSON of a [`Request`](crate::request::Request). Returns the JSON of an [`Answer`](crate::engine::Answer).
    pub fn run(&mut self, request: &str) -> Result<String, JsError> {
        let answer = self.engine.answer(&serde_json::from_str(request)?);
        if answer.facts.is_some() {
            (self.picker, self.trees) = (None, Trees::default());
        }
        Ok(serde_json::to_string(&answer)?)
    }

    /// The GLB file of the last run.
    pub fn glb(&self) -> Result<Vec<u8>, JsError> {
        self.last()?.glb().map_err(|why| JsError::new(&why))
    }

    /// The GLB file of the last run for the view. See [`Run::view_glb`].
    #[wasm_bindgen(js_name = viewGlb)]
    pub fn view_glb(&self) -> Result<Vec<u8>, JsError> {
        self.last()?.view_glb().map_err(|why| JsError::new(&why))
    }

    /// The GLB file of the last run with a node for each rule.
    #[wasm_bindgen(js_name = glbByRule)]
    pub fn glb_by_rule(&self) -> Result<Vec<u8>, JsError> {
        self.last()?.glb_by_rule().map_err(|why| JsError::new(&why))
    }

    /// The OBJ file of the last run and its material library.
    pub fn obj(&self, library: &str) -> Result<Vec<String>, JsError> {
        let (obj, mtl) = self.last()?.obj(library);
        Ok(vec![obj, mtl])
    }

    /// The leaf that a ray hits.
    pub fn pick(&mut self, origin: &[f64], direction: &[f64]) -> Option<u32> {
        let point = |list: &[f64]| <[f64; 3]>::try_from(list).ok().map(DVec3::from_array);
        let leaf = self.picker()?.hit(point(origin)?, point(direction)?)?;
        u32::try_from(leaf).ok()
    }

    /// The rule of a leaf.
    pub fn rule(&mut self, leaf: u32) -> Option<String> {
        self.picker()?.rule(leaf as usize).map(str::to_owned)
    }

    /// See [`Trees::chain`].
    pub fn chain(&mut self, leaf: u32) -> Result<String, JsError> {
        let run = self.engine.last().ok_or_else(no_run)?;
        self.trees.chain(run, leaf as usize, clock).map_err(|why| JsError::new(&why))
    }

    /// See [`Picker::triangles_of_leaf`].
    #[wasm_bindgen(js_name = trianglesOfLeaf)]
    pub fn triangles_of_leaf(&mut self, leaf: u32) -> Vec<f32> {
        self.picker().map(|picker| picker.triangles_of_leaf(leaf as usize)).unwrap_or_default()
    }

    /// See [`Picker::triangles_of_rule`].
    #[wasm_bindgen(js_name = trianglesOfRule)]
    pub fn triangles_of_rule(&mut self, rule: &str) -> Vec<f32> {
        self.picker().map(|picker| picker.triangles_of_rule(rule)).unwrap_or_default()
    }
}

impl PageEngine {
    fn last(&self) -> Result<&Run, JsError> {
        self.engine.last().ok_or_else(no_run)
    }

    fn picker(&mut self) -> Option<&Picker> {
        let run = self.engine.last()?;
        Some(self.picker.get_or_insert_with(|| Picker::new(&run.model)))
    }
}

fn no_run() -> JsError {
    JsError::new("there is no model yet")
}
