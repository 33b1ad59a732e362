//! `assetMetadata`.

use crate::asset::File;
use crate::run::env::Env;
use crate::value::Value;
use crate::value::array::Array;
use crate::value::text::Text;

/// The first value with a key that `take` accepts.
fn value<T>(env: &mut Env, file: &File, key: &Text, take: fn(&Value) -> Option<T>) -> Option<T> {
    match env.settings.assets.metadata(file) {
        Ok(list) => list.iter().filter(|(name, _)| name == key.as_str()).find_map(|(_, value)| take(value)),
        Err(why) => {
            env.asset_fault(format!("`{file}` cannot be read: {why}; the default is used instead"));
            None
        }
    }
}

/// Defines the function for each type of default.
macro_rules! functions {
    ($($(#[$about:meta])* $name:ident $ty:ty, $variant:ident)*) => {
        $($(#[$about])* pub fn $name(env: &mut Env, file: File, key: Text, default: $ty) -> $ty {
            let found = value(env, &file, &key, |value| match value {
                Value::$variant(value) => Some(value.clone()),
                _ => None,
            });
            found.unwrap_or(default)
        })*
    };
}

functions! {
    /// `assetMetadata(file, key, default)`: a number kept in an asset's file (*assetMetadata function*). The default, if the file has no
    /// number with this key. In glTF files the keys are the members of `asset.extras`, then of the extras of scenes, nodes and meshes,
    /// of which the first one of the type counts. Other assets have none. A file that cannot be read is a fault.
    asset_metadata_float f64, Float
    /// The same for a truth value.
    asset_metadata_bool bool, Bool
    /// The same for text.
    asset_metadata_text Text, Text
    /// The same for an array of numbers.
    asset_metadata_floats Array<f64>, Floats
    /// The same for an array of truth values.
    asset_metadata_bools Array<bool>, Bools
    /// The same for an array of texts.
    asset_metadata_texts Array<Text>, Texts
}

#[cfg(all(test, feature = "gltf"))]
mod tests {
    use super::*;
    use crate::asset::Assets;
    use crate::run::settings::Settings;
    use crate::shape::Shape;

    #[test]
    fn the_first_value_of_the_type_counts() {
        let text: &'static [u8] = br#"{
            "asset": {"version": "2.0", "extras": {"species": "oak", "height": "tall"}},
            "nodes": [{"extras": {"species": "ash", "height": 12.5, "wild": true, "rings": [1, 2], "empty": []}}]
        }"#;
        let files: [(&'static str, &'static [u8]); 3] =
            [("tree.gltf", text), ("tree.obj", b"v 0 0 0"), ("a.gltf", b"{")];
        let assets = Assets::from_source(std::collections::BTreeMap::from(files))
            .with("b.glb", crate::geometry::primitive::cube());
        let settings = Settings { assets: std::sync::Arc::new(assets), ..Settings::default() };
        let env = &mut Env::with_names(&settings, &[], &Shape::rectangle(1.0, 1.0), "");
        let tree = || File::from("tree.gltf");
        assert_eq!(asset_metadata_text(env, tree(), "species".into(), "".into()).as_str(), "oak");
        assert_eq!(asset_metadata_float(env, tree(), "height".into(), 1.0), 12.5, "the first number");
        assert_eq!(asset_metadata_text(env, tree(), "height".into(), "".into()).as_str(), "tall");
        assert!(asset_metadata_bool(env, tree(), "wild".into(), false));
        assert_eq!(asset_metadata_float(env, tree(), "wild".into(), 7.0), 7.0, "another type");
        assert_eq!(asset_metadata_floats(env, tree(), "rings".into(), Array::default()).as_slice(), [1.0, 2.0]);
        assert!(asset_metadata_texts(env, tree(), "empty".into(), Array::from(vec![Text::from("a")])).is_empty());
        assert!(asset_metadata_bools(env, tree(), "rings".into(), Array::from(vec![true])).as_slice()[0]);
        assert_eq!(asset_metadata_float(env, "b.glb".into(), "height".into(), 3.0), 3.0);
        #[cfg(feature = "obj")]
        assert_eq!(asset_metadata_float(env, "tree.obj".into(), "height".into(), 3.0), 3.0);
        assert_eq!(env.take_faults().0.len(), 0);
        for name in ["a.gltf", "none.gltf", "tree.txt"] {
            assert_eq!(asset_metadata_float(env, name.into(), "height".into(), 3.0), 3.0);
            assert_eq!(env.take_faults().0.len(), 1, "{name}");
        }
    }
}
