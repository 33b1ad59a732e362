//! An entry of the catalog.

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use cga::Assets;

use crate::rule_lines::{NameLines, rule_lines};
use crate::scenes::Scene;

/// A grammar of the playground.
pub struct CatalogEntry {
    /// The grammar, the shapes that it runs on, and the camera.
    pub(crate) scene: Scene,
    /// The files that the rules name. They are made when the grammar runs for the first time.
    pub(crate) assets: LazyLock<Arc<Assets>>,
    lines: BTreeMap<String, NameLines>,
}

impl CatalogEntry {
    /// A grammar without files.
    pub(crate) fn new(scene: Scene) -> Self {
        CatalogEntry::with_assets(scene, Arc::default)
    }

    /// A grammar with files.
    pub(crate) fn with_assets(scene: Scene, assets: fn() -> Arc<Assets>) -> Self {
        let lines = rule_lines(&scene.rules).into_iter().map(|(name, lines)| (name.to_owned(), lines)).collect();
        CatalogEntry { scene, assets: LazyLock::new(assets), lines }
    }

    /// The name in addresses and file names.
    pub fn name(&self) -> &'static str {
        self.scene.name
    }

    /// The lines of the rule text for a rule or a leaf, counted from 1.
    pub fn lines(&self, rule: &str) -> &[usize] {
        self.lines.get(rule).map_or(&[], NameLines::shown)
    }

    /// The seed of the first shape. Another seed changes the seeds of all shapes.
    pub(crate) fn seed(&self) -> u64 {
        self.scene.shapes.first().map_or(0, |start| start.shape.seed_value())
    }
}
