//! The checker of the playground: the findings of a rule text.

mod finding;
mod json;
#[cfg(target_arch = "wasm32")]
pub mod wasm;

pub use finding::{Finding, findings};
pub use json::json;
