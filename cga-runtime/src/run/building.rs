//! Buildings: initial shapes with what their runs found out about them.

use std::sync::Arc;

use crate::run::report::Reports;
use crate::run::shape_tree::ShapeTree;
use crate::shape::Shape;
use crate::value::Value;
use crate::value::text::Text;

/// An initial shape as files and programs know it beside its leaves: a building of a city, a feature of a map.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Building {
    /// The name of the initial shape; empty if it has none.
    pub name: Text,
    /// The seed of the initial shape.
    pub seed: u64,
    /// The name of its grammar; empty for a grammar without a header.
    pub grammar: Text,
    /// The names and values of the attributes that the run used, in the order of the grammar's attributes: values of the lot and of
    /// the program, and defaults, which may be computed for this shape.
    pub attributes: Vec<(Text, Value)>,
    /// The values that its rules reported.
    pub reports: Reports,
    /// The tree of its shapes, if [`Settings::tree`](crate::run::settings::Settings::tree) asks for it. `None` after a run that ended early, or if the
    /// leaves of the model are not the leaves of the run, because a sink in between has left out some.
    pub tree: Option<Arc<ShapeTree>>,
}

impl Building {
    /// A building without attributes and reports, for sinks that are filled by hand.
    pub fn new(name: impl Into<Text>, seed: u64) -> Self {
        Building { name: name.into(), seed, ..Building::default() }
    }

    /// The building of a shape.
    pub(crate) fn of(shape: &Shape, grammar: Text) -> Self {
        Building { grammar, ..Building::new(shape.name(), shape.seed_value()) }
    }

    /// Each reported key with one value, sorted by key: of numbers and truth values the sum, of texts the different ones. Under a key
    /// with several types the first counts, as in [`Reports::get`].
    #[cfg(feature = "gltf")]
    pub(crate) fn report_values(&self) -> Vec<(&str, Value)> {
        let mut values: Vec<(&str, Value)> = self
            .reports
            .iter()
            .map(|collection| {
                let texts: Vec<&str> = collection.texts().map(|(text, _)| text).collect();
                let sum = || Value::Float(collection.summary().sum);
                (collection.key(), if texts.is_empty() { sum() } else { Value::from(texts.join(", ")) })
            })
            .collect();
        values.dedup_by_key(|(key, _)| *key);
        values
    }

    /// The value of an attribute.
    pub fn attribute(&self, name: &str) -> Option<&Value> {
        self.attributes.iter().find(|(known, _)| known.is(name)).map(|(_, value)| value)
    }
}
