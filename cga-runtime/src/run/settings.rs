//! What a caller decides about a run: limits and where assets come from.

use std::sync::Arc;

use crate::asset::Assets;
use crate::run::watch::Watch;

/// Bounds on what one run may make. Reaching one ends the run with [`Error::Limit`](crate::fault::Error::Limit), unless it
/// says otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Shapes derived, leaves included.
    pub shapes: u64,
    /// Nesting of rules that can reach themselves.
    pub depth: u32,
    /// Vertices in the meshes that operations make, those shared between faces counted for each (boxes and rectangles count
    /// when they become meshes).
    pub vertices: u64,
    /// Calls of rules that wait because recursion is too deep for the stack. Each holds a shape.
    pub waiting: u64,
    /// Calls in a run of functions that can reach themselves, or that lead to very many others.
    pub calls: u64,
    /// Keys that are reported under, and different texts reported. What is beyond is left out, with a fault.
    pub reports: u64,
    /// Lines printed. What is beyond is left out, with a fault.
    pub prints: u64,
    /// Elements of an array (*CGA changelog 2019.1*: 100,000).
    pub array: u64,
    /// Bytes of a text, and of all texts that one function makes for an array.
    pub text: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            shapes: 10_000_000,
            depth: 1024,
            vertices: 20_000_000,
            waiting: 500_000,
            calls: 100_000_000,
            reports: 100_000,
            prints: 100_000,
            array: 100_000,
            text: 10_000_000,
        }
    }
}

/// How to run a grammar.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// The rule to start with; `None` for the grammar's own start rule.
    pub start: Option<String>,
    /// Bounds on the run.
    pub limits: Limits,
    /// What `i(…)` may insert.
    pub assets: Arc<Assets>,
    /// Whether printed lines are also written to standard output when the run ends, with or without an error. They have the
    /// order of [`Report::prints`](crate::run::report::Report::prints).
    pub echo: bool,
    /// Follows the progress of runs and can end them early.
    pub watch: Option<Watch>,
    /// How parts that repeat are derived; tests compare the ways.
    #[doc(hidden)]
    pub repeats: Repeats,
}

/// How parts that repeat are derived.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Repeats {
    /// From templates that are kept.
    #[default]
    Kept,
    /// From templates that are made again for each repetition. The bytes are those of `Kept`.
    Again,
    /// Each at its place in the world. Positions differ from those of `Kept` by rounding.
    Direct,
}
