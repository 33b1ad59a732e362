//! The words that select components.

/// The words that select components.
pub const SELECTORS: &[&str] =
    &["front", "back", "left", "right", "top", "bottom", "side", "vertical", "horizontal", "aslant", "nutant", "all"];
