//! The requests of the page.

use serde::Deserialize;
use serde_json::{Map, Value};

use crate::lot::Lot;

/// A request for a run. A page sends it as JSON.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// The name of the grammar in the catalog: its rules, lots and files, unless the request has others.
    pub grammar: String,
    /// The rules as text; `None` for the rules of the catalog.
    #[serde(default)]
    pub rules: Option<String>,
    /// The name of the grammar in files; `None` for the name in the catalog.
    #[serde(default)]
    pub name: Option<String>,
    /// Attributes by name; the others have their defaults.
    #[serde(default)]
    pub values: Map<String, Value>,
    /// The seed of the first shape: the seeds of the others change by the same amount. `None` for the seeds of the catalog.
    #[serde(default)]
    pub seed: Option<u64>,
    /// The initial shapes; `None` for the shapes of the catalog.
    #[serde(default)]
    pub lot: Option<Lot>,
    /// The start rule of all initial shapes; `None` for their own.
    #[serde(default)]
    pub start: Option<String>,
}

impl Request {
    /// A run of a grammar of the catalog with defaults.
    pub fn of(grammar: &str) -> Self {
        Request { grammar: grammar.to_owned(), ..Request::default() }
    }
}
