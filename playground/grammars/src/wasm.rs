//! The functions that the page calls.

use cga::glam::DVec3;
use wasm_bindgen::prelude::*;

use crate::pick::Picker;
use crate::run::{Request, Run};

/// The grammars as a JSON list.
#[wasm_bindgen]
pub fn catalog() -> String {
    crate::catalog::json()
}

/// A run that the page shows.
#[wasm_bindgen]
pub struct PageRun {
    run: Run,
    /// Made when it is needed.
    picker: Option<Picker>,
}

#[wasm_bindgen]
impl PageRun {
    /// Runs a grammar: the JSON of a [`Request`].
    #[wasm_bindgen(constructor)]
    pub fn new(request: &str) -> Result<PageRun, JsError> {
        let request: Request = serde_json::from_str(request)?;
        let run = Run::new(&request).map_err(|why| JsError::new(&why))?;
        Ok(PageRun { run, picker: None })
    }

    /// The bytes of the GLB file. They are handed over: a second call returns none.
    #[wasm_bindgen(js_name = takeGlb)]
    pub fn take_glb(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.run.glb)
    }

    /// See [`Run::facts`].
    pub fn facts(&self) -> String {
        self.run.facts.clone()
    }

    /// The leaf that a ray hits.
    pub fn pick(&mut self, origin: &[f64], direction: &[f64]) -> Option<u32> {
        let point = |list: &[f64]| <[f64; 3]>::try_from(list).ok().map(DVec3::from_array);
        let leaf = self.picker().hit(point(origin)?, point(direction)?)?;
        u32::try_from(leaf).ok()
    }

    /// The rule of a leaf.
    pub fn rule(&mut self, leaf: u32) -> Option<String> {
        self.picker().rule(leaf as usize).map(str::to_owned)
    }

    /// See [`Picker::triangles_of_leaf`].
    #[wasm_bindgen(js_name = trianglesOfLeaf)]
    pub fn triangles_of_leaf(&mut self, leaf: u32) -> Vec<f32> {
        self.picker().triangles_of_leaf(leaf as usize)
    }

    /// See [`Picker::triangles_of_rule`].
    #[wasm_bindgen(js_name = trianglesOfRule)]
    pub fn triangles_of_rule(&mut self, rule: &str) -> Vec<f32> {
        self.picker().triangles_of_rule(rule)
    }
}

impl PageRun {
    fn picker(&mut self) -> &Picker {
        self.picker.get_or_insert_with(|| Picker::new(&self.run.model))
    }
}
