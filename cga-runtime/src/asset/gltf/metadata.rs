//! The data that an author keeps in a file: the members of `extras`.

use serde_json::Value as Json;

use super::{GltfError, container};
use crate::value::Value;
use crate::value::array::Array;
use crate::value::text::Text;

/// The lists whose items may have extras, in the order in which they are searched.
const LISTS: [&str; 3] = ["scenes", "nodes", "meshes"];

/// The members of `asset.extras`, then of the extras of scenes, nodes and meshes, in the order of the file. Members that are objects,
/// null, or arrays of several types are left out. An empty array is one of each type.
pub(crate) fn metadata(bytes: &[u8]) -> Result<Vec<(String, Value)>, GltfError> {
    let json = container::parts(bytes)?.json;
    let json: Json = serde_json::from_slice(json).map_err(|error| GltfError::Json(error.to_string()))?;
    let lists = LISTS.iter().filter_map(|list| json.get(list)?.as_array()).flatten();
    let extras = json.get("asset").into_iter().chain(lists).filter_map(|item| item.get("extras")?.as_object());
    let mut found = Vec::new();
    for (name, member) in extras.flatten() {
        found.extend(values(member).into_iter().map(|value| (name.clone(), value)));
    }
    Ok(found)
}

/// The values that a member is.
fn values(member: &Json) -> Vec<Value> {
    let value = match member {
        Json::Bool(value) => Some(Value::Bool(*value)),
        Json::Number(value) => value.as_f64().map(Value::Float),
        Json::String(value) => Some(Value::Text(Text::from(value.as_str()))),
        Json::Array(list) if list.is_empty() => {
            return vec![
                Value::Floats(Array::default()),
                Value::Bools(Array::default()),
                Value::Texts(Array::default()),
            ];
        }
        Json::Array(list) => array(list),
        Json::Null | Json::Object(_) => None,
    };
    value.into_iter().collect()
}

/// An array of one type.
fn array(list: &[Json]) -> Option<Value> {
    match list.first()? {
        Json::Number(_) => {
            list.iter().map(Json::as_f64).collect::<Option<Vec<_>>>().map(|list| Value::Floats(list.into()))
        }
        Json::Bool(_) => {
            list.iter().map(Json::as_bool).collect::<Option<Vec<_>>>().map(|list| Value::Bools(list.into()))
        }
        Json::String(_) => {
            let texts = list.iter().map(|item| item.as_str().map(Text::from)).collect::<Option<Vec<_>>>();
            texts.map(|list| Value::Texts(list.into()))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extras_are_values_in_the_order_of_the_search() {
        let text = br#"{
            "asset": {"version": "2.0", "extras": {"species": "oak", "age": 12, "tags": ["a", "b"], "none": null}},
            "nodes": [{}, {"extras": {"age": 7, "wild": true, "sizes": [1, 2.5], "flags": [false], "mixed": [1, "a"]}}],
            "scenes": [{"extras": {"empty": [], "deep": {"a": 1}}}, {"extras": 5}]
        }"#;
        let found = metadata(text).unwrap();
        let names: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
        let asset = ["age", "species", "tags"];
        assert_eq!(names[..6], [&asset[..], &["empty"; 3]].concat());
        assert_eq!(names[6..], ["age", "flags", "sizes", "wild"]);
        assert_eq!((&found[0].1, &found[6].1), (&Value::Float(12.0), &Value::Float(7.0)));
        assert_eq!(found[8].1, Value::Floats(vec![1.0, 2.5].into()));
        assert!(metadata(b"{").is_err() && metadata(b"glTF").is_err() && metadata(b"[]").unwrap().is_empty());
    }
}
