//! The features of a GeoJSON text.

use geojson::{Feature, GeoJson};

/// The features of a text. A broken one is a reason, and the others are read.
///
/// # Errors
/// The text is not GeoJSON, and features cannot be found in it.
pub(crate) fn features(text: &str) -> Result<Vec<Result<Feature, String>>, String> {
    // Some programs begin a file with a mark of its encoding.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    match text.parse::<GeoJson>() {
        Ok(GeoJson::FeatureCollection(collection)) => Ok(collection.features.into_iter().map(Ok).collect()),
        Ok(GeoJson::Feature(feature)) => Ok(vec![Ok(feature)]),
        Ok(GeoJson::Geometry(geometry)) => Ok(vec![Ok(Feature::from(geometry))]),
        Err(why) => match elements(text) {
            Some(list) => Ok(list.into_iter().map(feature).collect()),
            None => Err(format!("it is not GeoJSON: {why}")),
        },
    }
}

/// A feature by itself.
fn feature(text: &str) -> Result<Feature, String> {
    match text.parse::<GeoJson>() {
        Ok(GeoJson::Feature(feature)) => Ok(feature),
        Ok(_) => Err("it is not a feature".to_owned()),
        Err(why) => {
            let hint = if text.contains("NaN") { "; `NaN` is not JSON" } else { "" };
            Err(format!("it is not GeoJSON: {why}{hint}"))
        }
    }
}

/// The texts of the elements of the list `features` of an object, by their brackets: the text need not be JSON. `None` without such a list, or
/// if it does not end.
fn elements(text: &str) -> Option<Vec<&str>> {
    let (mut depth, mut in_text, mut escaped) = (0usize, false, false);
    let (mut text_begins, mut key, mut list, mut begin) = (0, "", None, 0);
    for (at, byte) in text.bytes().enumerate() {
        if in_text {
            match byte {
                _ if escaped => escaped = false,
                b'\\' => escaped = true,
                b'"' => {
                    in_text = false;
                    if depth == 1 {
                        key = &text[text_begins..at];
                    }
                }
                _ => {}
            }
            continue;
        }
        match byte {
            b'"' => (in_text, text_begins) = (true, at + 1),
            b'[' | b'{' => {
                depth += 1;
                if byte == b'[' && depth == 2 && key == "features" && list.is_none() {
                    (list, begin) = (Some(Vec::new()), at + 1);
                }
            }
            b',' if depth == 2 => {
                list.iter_mut().for_each(|list| list.push(text[begin..at].trim()));
                begin = at + 1;
            }
            b']' | b'}' => {
                depth = depth.checked_sub(1)?;
                if depth == 1
                    && let Some(mut elements) = list.take()
                {
                    let last = text[begin..at].trim();
                    elements.extend(Some(last).filter(|last| !last.is_empty()));
                    return Some(elements);
                }
            }
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_cut_out_of_their_list() {
        let text =
            "{\"a\": \"features\", \"b\": [1, 2], \"features\": [{\"c\": \"]}\\\"\"}, [1, NaN], 7 ], \"d\": [1]}";
        assert_eq!(elements(text), Some(vec!["{\"c\": \"]}\\\"\"}", "[1, NaN]", "7"]));
        assert_eq!(elements("{\"features\": []}"), Some(vec![]));
        for text in ["{\"features\": [{}", "{\"a\": [1]}", "]", "", "{\"a\": {\"features\": [1]}}", "Lot --> X."] {
            assert_eq!(elements(text), None, "{text}");
        }
    }

    #[test]
    fn broken_features_are_reasons() {
        let good = "{\"type\": \"Feature\", \"properties\": null, \"geometry\": null}";
        let text =
            format!("\u{feff}{{\"type\": \"FeatureCollection\", \"features\": [{good}, {{\"a\": NaN}}, {good}]}}");
        let list = features(&text).expect("features");
        assert_eq!(list.iter().map(Result::is_ok).collect::<Vec<_>>(), [true, false, true]);
        assert!(list[1].as_ref().is_err_and(|why| why.ends_with("; `NaN` is not JSON")), "{list:?}");
    }
}
