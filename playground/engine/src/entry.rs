//! An entry of the catalog.

use std::sync::{Arc, LazyLock};

use cga::Assets;

use crate::scenes::Scene;

/// A grammar of the playground: its rules as text, and the shapes that it runs on.
pub struct CatalogEntry {
    /// The rules are the text of a rule file.
    pub(crate) scene: Scene<()>,
    /// The name of the grammar in files.
    pub(crate) grammar: &'static str,
    /// Attributes that differ from their defaults, as a JSON object.
    pub(crate) values: &'static str,
    /// The files that the rules name. They are made when the grammar runs for the first time.
    pub(crate) assets: LazyLock<Arc<Assets>>,
}

impl CatalogEntry {
    /// A grammar without files.
    pub(crate) fn new(scene: Scene<()>, grammar: &'static str) -> Self {
        CatalogEntry { scene, grammar, values: "{}", assets: LazyLock::new(Arc::default) }
    }

    /// Sets attributes: the text of a JSON object.
    pub(crate) fn with_values(self, values: &'static str) -> Self {
        CatalogEntry { values, ..self }
    }

    /// Sets the files that the rules name.
    pub(crate) fn with_assets(self, assets: fn() -> Arc<Assets>) -> Self {
        CatalogEntry { assets: LazyLock::new(assets), ..self }
    }

    /// The name in addresses and file names.
    pub fn name(&self) -> &'static str {
        self.scene.name
    }

    /// The rules as the text of a rule file.
    pub fn rules(&self) -> &str {
        &self.scene.rules
    }

    /// The seed of the first shape. Another seed changes the seeds of all shapes.
    pub fn seed(&self) -> u64 {
        self.scene.shapes.first().map_or(0, |start| start.shape.seed_value())
    }
}
