//! The function that the page calls.

use wasm_bindgen::prelude::*;

/// The findings of a rule text as a JSON list.
#[wasm_bindgen]
pub fn check(text: &str) -> String {
    crate::json(&crate::findings(text))
}
