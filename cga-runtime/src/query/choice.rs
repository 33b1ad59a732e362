//! One file of those that a query finds, by its fit to the scope: `assetBestSize`, `imageApproxRatio` and others.
//!
//! The query is the one of `fileSearch`. Axes are text here. Functions that choose at random always draw one random number.

use super::fit::{Axes, ImageAxes, RatioAxes, SizeAxes, by_ratio, by_size, images_by_ratio};
use crate::asset::File;
use crate::fault::FaultKind;
use crate::run::env::Env;
use crate::shape::view::View;
use crate::value::shown::shown;
use crate::value::text::Text;

/// The files that a query finds.
fn found(env: &mut Env, query: &File) -> Vec<File> {
    env.files(query).iter().map(|name| File::new(name.clone(), query.folder.clone())).collect()
}

/// The name of the best file; empty if there are none.
fn first(files: Vec<(File, f64)>) -> Text {
    files.into_iter().next().map(|(file, _)| file.name).unwrap_or_default()
}

/// A random file of the best ones; empty if there are none. `draw` is below 1. A number below 1 counts as 1.
fn one_of_best(files: Vec<(File, f64)>, count: f64, draw: f64) -> Text {
    let count = (count as usize).clamp(1, files.len().max(1));
    files.into_iter().nth((draw * count as f64) as usize).map(|(file, _)| file.name).unwrap_or_default()
}

/// A fault for axes that do not exist.
fn unknown<A: Axes>(env: &mut Env, axes: &Text) -> Text {
    let known = A::ALL.iter().map(|(name, _)| *name).collect::<Vec<_>>().join("`, `");
    env.fault(FaultKind::Value, format!("`{}` does not name axes; write `{known}`; no file is chosen", shown(axes)));
    Text::default()
}

/// `assetBestSize(query, axes)`: the asset whose size fits best (*assetBestSize*).
pub fn asset_best_size(env: &mut Env, shape: &mut impl View, query: File, axes: Text) -> Text {
    let Some(which) = SizeAxes::named(&axes) else { return unknown::<SizeAxes>(env, &axes) };
    let files = found(env, &query);
    first(by_size(env, shape, files, which, 0.0))
}

/// `assetApproxSize(query, axes, n)`: a random one of the `n` assets whose sizes fit best (*assetApproxSize*).
pub fn asset_approx_size(env: &mut Env, shape: &mut impl View, query: File, axes: Text, count: f64) -> Text {
    let draw = shape.draw();
    let Some(which) = SizeAxes::named(&axes) else { return unknown::<SizeAxes>(env, &axes) };
    let files = found(env, &query);
    one_of_best(by_size(env, shape, files, which, 0.0), count, draw)
}

/// `assetFitSize(query, axes, maxScaleError)`: a random one of the assets whose scaling is within the error; of all for 0
/// (*assetFitSize*).
pub fn asset_fit_size(env: &mut Env, shape: &mut impl View, query: File, axes: Text, most_error: f64) -> Text {
    let draw = shape.draw();
    let Some(which) = SizeAxes::named(&axes) else { return unknown::<SizeAxes>(env, &axes) };
    let files = found(env, &query);
    one_of_best(by_size(env, shape, files, which, most_error), f64::INFINITY, draw)
}

/// `assetBestRatio(query, axes)`: the asset whose ratio fits best (*assetBestRatio*).
pub fn asset_best_ratio(env: &mut Env, shape: &mut impl View, query: File, axes: Text) -> Text {
    let Some(which) = RatioAxes::named(&axes) else { return unknown::<RatioAxes>(env, &axes) };
    let files = found(env, &query);
    first(by_ratio(env, shape, files, which))
}

/// `assetApproxRatio(query, axes, n)`: a random one of the `n` assets whose ratios fit best (*assetApproxRatio*).
pub fn asset_approx_ratio(env: &mut Env, shape: &mut impl View, query: File, axes: Text, count: f64) -> Text {
    let draw = shape.draw();
    let Some(which) = RatioAxes::named(&axes) else { return unknown::<RatioAxes>(env, &axes) };
    let files = found(env, &query);
    one_of_best(by_ratio(env, shape, files, which), count, draw)
}

/// `imageBestRatio(query, axes)`: a random one of the images whose ratio fits best (*imageBestRatio*).
pub fn image_best_ratio(env: &mut Env, shape: &mut impl View, query: File, axes: Text) -> Text {
    let draw = shape.draw();
    let Some(which) = ImageAxes::named(&axes) else { return unknown::<ImageAxes>(env, &axes) };
    let files = found(env, &query);
    let files = images_by_ratio(env, shape, files, which);
    let best = files.first().map_or(0.0, |(_, best)| *best);
    // Images of other sizes with equal ratios differ by rounding.
    let count = files.iter().take_while(|(_, factor)| *factor <= best * (1.0 + 1e-12)).count();
    one_of_best(files, count as f64, draw)
}

/// `imageApproxRatio(query, axes, n)`: a random one of the `n` images whose ratios fit best (*imageApproxRatio*).
pub fn image_approx_ratio(env: &mut Env, shape: &mut impl View, query: File, axes: Text, count: f64) -> Text {
    let draw = shape.draw();
    let Some(which) = ImageAxes::named(&axes) else { return unknown::<ImageAxes>(env, &axes) };
    let files = found(env, &query);
    one_of_best(images_by_ratio(env, shape, files, which), count, draw)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::sync::Arc;

    use glam::{DAffine3, DVec3};

    use super::*;
    use crate::asset::{Assets, Files};
    use crate::geometry::primitive;
    use crate::query::fit::{
        assets_sort_ratio, assets_sort_ratio_array, assets_sort_size, assets_sort_size_array, images_sort_ratio,
        images_sort_ratio_array,
    };
    use crate::run::settings::Settings;
    use crate::shape::Shape;
    use crate::value::array::Array;

    fn env(assets: Assets) -> Env {
        let settings = Settings { assets: Arc::new(assets), ..Settings::default() };
        Env::with_names(&settings, &[], &Shape::rectangle(1.0, 1.0), "")
    }

    /// Boxes by name, of these sizes.
    fn boxes(list: &[(&str, [f64; 3])]) -> Assets {
        list.iter().fold(Assets::new(), |assets, (name, size)| {
            assets.with(*name, primitive::cube().map(&DAffine3::from_scale(DVec3::from(*size))))
        })
    }

    /// The beginning of a PNG file.
    fn png(width: u8, height: u8) -> Vec<u8> {
        [b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".as_slice(), &[0, 0, 0, width, 0, 0, 0, height]].concat()
    }

    fn pool() -> Env {
        env(boxes(&[
            ("a.obj", [1.0, 1.0, 1.0]),
            ("b.obj", [2.0, 1.0, 1.0]),
            ("c.obj", [4.0, 2.0, 2.0]),
            ("d.obj", [4.4, 2.0, 2.0]),
            ("flat.obj", [4.0, 0.0, 2.0]),
        ]))
    }

    const ALL: &str = "a.obj;b.obj;c.obj;d.obj;flat.obj;";

    #[test]
    fn assets_are_sorted_by_the_factor_of_their_scaling() {
        let (env, shape) = (&mut pool(), &mut Shape::cuboid(4.2, 2.0, 2.0));
        let mut by = |list: &str, axes, error| assets_sort_size(env, shape, list.into(), axes, error).to_string();
        // Factors 4.2, 2.1, 1.05, 1.0476.
        assert_eq!(by("a.obj;b.obj;c.obj;d.obj;", SizeAxes::X, 0.0), "d.obj;c.obj;b.obj;a.obj;");
        assert_eq!(by(ALL, SizeAxes::X, 0.1), "d.obj;c.obj;flat.obj;", "equal factors keep their order");
        assert_eq!(by(ALL, SizeAxes::X, 0.049), "d.obj;", "4.2 / 4.4 is nearer to 1 than 4.2 / 4");
        assert_eq!(by(ALL, SizeAxes::Xyz, 0.1), "d.obj;c.obj;", "nothing scales to or from a flat asset");
        assert_eq!(by(ALL, SizeAxes::Yz, 0.0), "c.obj;d.obj;a.obj;b.obj;flat.obj;");
        assert_eq!(by("", SizeAxes::X, 0.0), "");
        assert_eq!(by(ALL, SizeAxes::X, f64::NAN), "");
        assert_eq!(env.take_faults().0.len(), 0);
    }

    #[test]
    fn scaling_within_the_error_is_kept_at_its_bounds() {
        let env = &mut env(boxes(&[("a.obj", [10.0, 1.0, 1.0])]));
        for (size, kept) in [(9.0, true), (11.0, true), (8.99, false), (11.01, false)] {
            let shape = &mut Shape::cuboid(size, 1.0, 1.0);
            let found = assets_sort_size(env, shape, "a.obj;".into(), SizeAxes::X, 0.1);
            assert_eq!(!found.is_empty(), kept, "{size}");
        }
        // A mirrored scope has the same size.
        let shape = &mut Shape::cuboid(9.5, 1.0, 1.0);
        shape.scope.size.x = -9.5;
        assert_eq!(assets_sort_size(env, shape, "a.obj;".into(), SizeAxes::X, 0.1).as_str(), "a.obj;");
    }

    #[test]
    fn assets_are_sorted_by_the_factor_of_their_ratios() {
        let (env, shape) = (&mut pool(), &mut Shape::cuboid(20.0, 0.0, 10.0));
        let mut by = |axes| assets_sort_ratio(env, shape, ALL.into(), axes).to_string();
        // As in the reference: the height of the scope is 0, and does not count.
        assert_eq!(by(RatioAxes::Xz), "b.obj;c.obj;flat.obj;d.obj;a.obj;");
        assert_eq!(by(RatioAxes::Xyz), "flat.obj;a.obj;b.obj;c.obj;d.obj;");
        let names = |list: &[&str]| -> Array<Text> { list.iter().map(|name| Text::from(*name)).collect() };
        let files = Files::new(names(&["a.obj", "none.obj", "b.obj"]), Text::fixed(""));
        let shape = &mut Shape::cuboid(2.0, 1.0, 1.0);
        assert_eq!(assets_sort_ratio_array(env, shape, files.clone(), RatioAxes::Xyz), names(&["b.obj", "a.obj"]));
        assert_eq!(assets_sort_size_array(env, shape, files, SizeAxes::Xyz, 0.5), names(&["b.obj"]));
        let (faults, _) = env.take_faults();
        assert_eq!((faults.len(), faults[0].count), (1, 2), "a missing file is left out");
    }

    #[test]
    fn names_are_relative_to_the_rule_file() {
        let env = &mut env(boxes(&[("c.obj", [1.0; 3]), ("rules/assets/a.obj", [3.0; 3]), ("rules/b.obj", [2.0; 3])]));
        let shape = &mut Shape::cuboid(3.0, 3.0, 3.0);
        let list = File::new("c.obj;b.obj;a.obj;".into(), Text::fixed("rules"));
        assert_eq!(assets_sort_size(env, shape, list, SizeAxes::X, 0.0).as_str(), "a.obj;b.obj;c.obj;");
        let array = Files::new(["b.obj", "a.obj"].map(Text::from).into_iter().collect(), Text::fixed("rules"));
        let sorted = assets_sort_size_array(env, shape, array, SizeAxes::X, 0.0);
        assert_eq!(sorted.as_slice(), ["a.obj", "b.obj"].map(Text::from));
        let found = asset_best_size(env, shape, File::new("*a.obj".into(), Text::fixed("rules")), "x".into());
        assert_eq!(found.as_str(), "rules/assets/a.obj", "as `fileSearch` writes it");
        assert_eq!(env.take_faults().0.len(), 0);
    }

    #[test]
    fn images_are_sorted_by_their_pixels() {
        let files = [("wide.png", png(200, 100)), ("square.png", png(100, 100)), ("broken.png", vec![1, 2, 3])];
        let source: Vec<(&'static str, &'static [u8])> =
            files.into_iter().map(|(name, bytes)| (name, &*bytes.leak())).collect();
        let env = &mut env(Assets::from_source(BTreeMap::from_iter(source)));
        let shape = &mut Shape::cuboid(4.0, 2.0, 1.0);
        let list = "square.png;wide.png;broken.png;";
        assert_eq!(images_sort_ratio(env, shape, list.into(), ImageAxes::Xy).as_str(), "wide.png;square.png;");
        assert_eq!(images_sort_ratio(env, shape, list.into(), ImageAxes::Yx).as_str(), "square.png;wide.png;");
        let array = Files::new(["wide.png", "square.png"].map(Text::from).into_iter().collect(), Text::fixed(""));
        let sorted = images_sort_ratio_array(env, shape, array, ImageAxes::Zy);
        assert_eq!(sorted.as_slice(), ["square.png", "wide.png"].map(Text::from));
        assert_eq!(image_best_ratio(env, shape, "*.png".into(), "yz".into()).as_str(), "wide.png");
        assert_eq!(env.take_faults().0.len(), 1, "a file that is not an image is left out");
    }

    #[test]
    fn one_of_the_best_is_chosen() {
        let (env, shape) = (&mut pool(), &mut Shape::cuboid(4.2, 2.0, 2.0));
        let query = || File::from("*.obj");
        assert_eq!(asset_best_size(env, shape, query(), "x".into()).as_str(), "d.obj");
        assert_eq!(asset_best_ratio(env, shape, query(), "xyz".into()).as_str(), "d.obj");
        let mut drawn = |choose: &mut dyn FnMut(&mut Env, &mut Shape) -> Text| {
            let mut counts = BTreeMap::new();
            for _ in 0..200 {
                *counts.entry(choose(env, shape).to_string()).or_insert(0) += 1;
            }
            counts.into_keys().collect::<Vec<_>>()
        };
        for (count, expected) in [(1.0, &["d.obj"][..]), (0.0, &["d.obj"]), (2.9, &["c.obj", "d.obj"])] {
            let mut choose =
                |env: &mut Env, shape: &mut Shape| asset_approx_size(env, shape, query(), "xyz".into(), count);
            assert_eq!(drawn(&mut choose), expected, "{count}");
        }
        for (error, expected) in [(0.06, 2), (0.0, 5), (0.001, 1)] {
            let mut choose =
                |env: &mut Env, shape: &mut Shape| asset_fit_size(env, shape, query(), "xyz".into(), error);
            assert_eq!(drawn(&mut choose).len(), expected, "{error}");
        }
        let mut choose = |env: &mut Env, shape: &mut Shape| asset_approx_ratio(env, shape, query(), "xz".into(), 3.0);
        assert_eq!(drawn(&mut choose).len(), 3);
        assert_eq!(asset_fit_size(env, shape, query(), "xyz".into(), 0.001).as_str(), "", "none fits");
        assert_eq!(asset_best_size(env, shape, "*.gltf".into(), "x".into()).as_str(), "", "none is found");
        assert_eq!(env.take_faults().0.len(), 0);
        assert_eq!(asset_best_size(env, shape, query(), "xw".into()).as_str(), Text::fixed(""));
        let (faults, _) = env.take_faults();
        let message = "`xw` does not name axes; write `x`, `y`, `z`, `xy`, `xz`, `yz`, `xyz`; no file is chosen";
        assert_eq!(faults[0].message, message);
    }

    #[test]
    fn equal_images_take_turns() {
        let files = [("a.png", png(100, 50)), ("b.png", png(50, 25)), ("c.png", png(100, 100))];
        let source: Vec<(&'static str, &'static [u8])> =
            files.into_iter().map(|(name, bytes)| (name, &*bytes.leak())).collect();
        let env = &mut env(Assets::from_source(BTreeMap::from_iter(source)));
        let shape = &mut Shape::cuboid(3.3, 1.1, 1.0);
        let mut seen = std::collections::BTreeSet::new();
        for _ in 0..100 {
            seen.insert(image_best_ratio(env, shape, "*.png".into(), "xy".into()).to_string());
        }
        assert_eq!(Vec::from_iter(seen), ["a.png", "b.png"]);
        assert_eq!(image_approx_ratio(env, shape, "c*".into(), "xy".into(), 9.0).as_str(), "c.png");
    }
}
