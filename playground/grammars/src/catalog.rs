//! The grammars of the playground: the scenes of the gallery, and the grammars of the other examples.

use std::sync::OnceLock;

use serde_json::{Value, json};

use crate::entry::CatalogEntry;
use crate::examples;
use crate::scenes::{Scene, scenes};

/// All grammars, in the order of the menu.
pub fn entries() -> &'static [CatalogEntry] {
    static ENTRIES: OnceLock<Vec<CatalogEntry>> = OnceLock::new();
    ENTRIES.get_or_init(|| scenes().into_iter().map(CatalogEntry::new).chain(examples::entries()).collect())
}

/// The grammar with a name.
pub fn entry(name: &str) -> Option<&'static CatalogEntry> {
    entries().iter().find(|entry| entry.name() == name)
}

/// The grammars as a JSON list: names, texts, seeds and views. A run returns the attributes.
pub fn json() -> String {
    let rows = entries().iter().map(|entry| {
        let Scene { name, title, sentence, rules, grammar, view, .. } = &entry.scene;
        json!({
            "name": name,
            "title": title,
            "sentence": sentence,
            "grammar": grammar.name(),
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{entries, entry};
    use crate::run::{Request, Run};

    #[test]
    fn names_differ() {
        let names: BTreeSet<&str> = entries().iter().map(|entry| entry.name()).collect();
        assert_eq!(names.len(), entries().len());
        assert!(entry("tower").is_some() && entry("towre").is_none());
    }

    #[test]
    fn each_leaf_has_a_line() {
        for entry in entries() {
            let name = entry.name();
            let run = Run::new(&Request::of(name)).expect("defaults are allowed");
            assert_eq!(run.model.faults(), [], "{name}");
            assert!(!run.model.is_empty(), "{name}");
            let lines = entry.scene.rules.lines().count();
            for rule in run.model.rules() {
                let shown = entry.lines(rule);
                let exist = shown.iter().all(|line| (1..=lines).contains(line));
                assert!(!shown.is_empty() && exist, "{name}: {rule}");
            }
        }
    }
}
