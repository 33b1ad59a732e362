//! The grammars of the playground: the scenes of the gallery, and the grammars of the other examples.

use std::sync::LazyLock;

use serde_json::{Value, json};

use crate::entry::CatalogEntry;
use crate::examples;
use crate::inline::rules_of;
use crate::scenes::{Scene, layouts, materials};

static ENTRIES: LazyLock<Vec<CatalogEntry>> =
    LazyLock::new(|| layouts().into_iter().map(scene_entry).chain(examples::entries()).collect());

/// All grammars, in the order of the menu.
pub fn entries() -> &'static [CatalogEntry] {
    &ENTRIES
}

/// The grammar with a name.
pub fn entry(name: &str) -> Option<&'static CatalogEntry> {
    entries().iter().find(|entry| entry.name() == name)
}

/// A scene of the gallery, with its rules as the text of a rule file.
fn scene_entry(scene: Scene<()>) -> CatalogEntry {
    let source = format!("cga! {{\n{}\n}}\n", scene.rules);
    let rules = scene.rules.split_once("pub grammar ").and_then(|(_, rest)| rest.split_once(';'));
    let name = rules.map(|(name, _)| name.to_owned()).unwrap_or_default();
    let rules = rules_of(&source, &name).unwrap_or_default();
    CatalogEntry::new(Scene { rules, ..scene }, name.leak()).with_assets(materials::assets)
}

/// The grammars as a JSON list: names, texts, seeds and views. A run returns the attributes.
pub fn json() -> String {
    let rows = entries().iter().map(|entry| {
        let Scene { name, title, sentence, rules, view, .. } = &entry.scene;
        json!({
            "name": name,
            "title": title,
            "sentence": sentence,
            "grammar": entry.grammar,
            "rules": rules,
            "seed": entry.seed(),
            "view": {
                "azimuth": view.azimuth,
                "elevation": view.elevation,
                "fieldOfView": view.field_of_view,
                "sunAzimuth": view.sun_azimuth,
                "sunElevation": view.sun_elevation,
                "region": view.region,
            },
        })
    });
    Value::Array(rows.collect()).to_string()
}
