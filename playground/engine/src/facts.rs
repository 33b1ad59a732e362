//! The facts about a run, as JSON.

use std::collections::BTreeMap;
use std::mem::discriminant;

use cga::{Grammar, Model, RuleFile};
use serde_json::{Value, json};

use crate::rule_lines::{NameLines, rule_lines};

/// The attributes, the values that the run used, start rules, counts, reports and faults. `first` has the values, as JSON, with which
/// the page shows the grammar: a reset goes back to them.
pub(crate) fn facts(text: &str, grammar: &RuleFile, first: &str, model: &Model, notes: &[String]) -> Value {
    let lines = rule_lines(text);
    let rules = model.counts().into_iter().map(|(rule, leaves)| {
        // An imported rule is not in the text.
        let lines = lines.get(rule).map_or(&[][..], NameLines::shown);
        json!({ "name": rule, "leaves": leaves, "lines": lines })
    });
    let bounds = model.bounds();
    let mut attributes: Vec<Value> = serde_json::from_str(&grammar.attributes_json()).unwrap_or_default();
    let first: Value = serde_json::from_str(first).unwrap_or_default();
    for attribute in &mut attributes {
        let value = attribute["name"].as_str().and_then(|name| first.get(name)).cloned();
        // Rules that a user changed may have another type.
        if let Some(value) = value.filter(|value| discriminant(value) == discriminant(&attribute["default"])) {
            attribute["default"] = value;
        }
    }
    let faults = model.faults().iter().map(ToString::to_string).chain(notes.iter().cloned());
    json!({
        "attributes": attributes,
        "used": used(model),
        "starts": grammar.start_rules().iter().filter(|rule| !rule.hidden).collect::<Vec<_>>(),
        "rules": rules.collect::<Vec<_>>(),
        "buildings": model.buildings().len(),
        "triangles": model.triangle_count(),
        "low": bounds.low.to_array(),
        "high": bounds.high.to_array(),
        "report": serde_json::to_value(model.report()).unwrap_or_default(),
        "faults": faults.collect::<Vec<_>>(),
    })
}

/// The different values of each attribute that the initial shapes used.
fn used(model: &Model) -> BTreeMap<&str, Vec<Value>> {
    let mut used: BTreeMap<&str, Vec<Value>> = BTreeMap::new();
    for (name, value) in model.buildings().flat_map(|(building, _)| &building.attributes) {
        let list = used.entry(name.as_str()).or_default();
        let value = serde_json::to_value(value).unwrap_or_default();
        if !list.contains(&value) {
            list.push(value);
        }
    }
    used
}
