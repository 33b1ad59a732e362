//! How well assets and images fit the scope: `assetsSortSize`, `assetsSortRatio` and `imagesSortRatio`.
//!
//! The reference gives no measure. Ours is the factor by which an asset is scaled to fit, upwards or downwards:
//!
//! - size: along each axis, scope / asset or its inverse, whichever is larger; the largest factor of all axes counts;
//! - ratio: for each pair of axes, the ratio of the scope / the ratio of the asset or its inverse, whichever is larger; the largest factor of
//!   all pairs counts.
//!
//! 1 is the best factor. Files with equal factors keep their order. An extent of 0 fits an extent of 0 alone.

use glam::DVec3;

use super::file::{image_size, list};
use crate::asset::{AssetError, File, Files};
use crate::geometry::small_sort::sort_owned_by;
use crate::run::env::Env;
use crate::shape::view::View;
use crate::value::array::Array;
use crate::value::text::Text;

/// Words for axes of the scope.
pub(super) trait Axes: Copy + 'static {
    /// What is compared.
    type Compared;
    /// All words with their names.
    const ALL: &'static [(&'static str, Self)];

    /// The axes that a word means.
    fn compared(self) -> Self::Compared;

    /// The axes with a name.
    fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|(_, axes)| *axes)
    }
}

/// The axes whose sizes are compared.
#[allow(missing_docs, reason = "the language defines the names")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SizeAxes {
    X,
    Y,
    Z,
    Xy,
    Xz,
    Yz,
    Xyz,
}

impl Axes for SizeAxes {
    type Compared = &'static [usize];
    const ALL: &'static [(&'static str, Self)] = &[
        ("x", SizeAxes::X),
        ("y", SizeAxes::Y),
        ("z", SizeAxes::Z),
        ("xy", SizeAxes::Xy),
        ("xz", SizeAxes::Xz),
        ("yz", SizeAxes::Yz),
        ("xyz", SizeAxes::Xyz),
    ];

    fn compared(self) -> &'static [usize] {
        match self {
            SizeAxes::X => &[0],
            SizeAxes::Y => &[1],
            SizeAxes::Z => &[2],
            SizeAxes::Xy => &[0, 1],
            SizeAxes::Xz => &[0, 2],
            SizeAxes::Yz => &[1, 2],
            SizeAxes::Xyz => &[0, 1, 2],
        }
    }
}

/// The pairs of axes whose ratios are compared.
#[allow(missing_docs, reason = "the language defines the names")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RatioAxes {
    Xy,
    Xz,
    Yz,
    Xyz,
}

impl Axes for RatioAxes {
    type Compared = &'static [[usize; 2]];
    const ALL: &'static [(&'static str, Self)] =
        &[("xy", RatioAxes::Xy), ("xz", RatioAxes::Xz), ("yz", RatioAxes::Yz), ("xyz", RatioAxes::Xyz)];

    fn compared(self) -> &'static [[usize; 2]] {
        match self {
            RatioAxes::Xy => &[[0, 1]],
            RatioAxes::Xz => &[[0, 2]],
            RatioAxes::Yz => &[[1, 2]],
            RatioAxes::Xyz => &[[0, 1], [0, 2], [1, 2]],
        }
    }
}

/// The axes of the scope along the width and the height of an image.
#[allow(missing_docs, reason = "the language defines the names")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageAxes {
    Xy,
    Xz,
    Yx,
    Yz,
    Zx,
    Zy,
}

impl Axes for ImageAxes {
    type Compared = [usize; 2];
    const ALL: &'static [(&'static str, Self)] = &[
        ("xy", ImageAxes::Xy),
        ("xz", ImageAxes::Xz),
        ("yx", ImageAxes::Yx),
        ("yz", ImageAxes::Yz),
        ("zx", ImageAxes::Zx),
        ("zy", ImageAxes::Zy),
    ];

    fn compared(self) -> [usize; 2] {
        match self {
            ImageAxes::Xy => [0, 1],
            ImageAxes::Xz => [0, 2],
            ImageAxes::Yx => [1, 0],
            ImageAxes::Yz => [1, 2],
            ImageAxes::Zx => [2, 0],
            ImageAxes::Zy => [2, 1],
        }
    }
}

/// The size of the scope, without its signs.
fn scope(shape: &impl View) -> DVec3 {
    shape.size().abs()
}

/// The factor between two lengths, at least 1: infinite if only one is 0, or if one is not a number.
fn factor(a: f64, b: f64) -> f64 {
    if a == b {
        return 1.0;
    }
    let factor = (a / b).max(b / a);
    if factor.is_nan() { f64::INFINITY } else { factor }
}

/// The factor between the ratios of two pairs of lengths.
fn ratio_factor(a: [f64; 2], b: [f64; 2]) -> f64 {
    // 0 / 0 has no ratio.
    if [a, b].contains(&[0.0; 2]) { f64::INFINITY } else { factor(a[0] * b[1], a[1] * b[0]) }
}

/// The sizes of assets in metres, without files that cannot be read, each of which is a fault.
fn sizes(env: &mut Env, files: Vec<File>) -> Vec<(File, DVec3)> {
    let mut sizes = Vec::with_capacity(files.len());
    for file in files {
        match env.settings.assets.mesh_of(&file) {
            Ok(mesh) => sizes.push((file, mesh.bounds().size())),
            Err(why) => left_out(env, &file, &why),
        }
    }
    sizes
}

fn left_out(env: &mut Env, file: &File, why: &AssetError) {
    env.asset_fault(format!("`{file}` cannot be measured: {why}; it is left out"));
}

/// The files by factor, the best one first.
fn sorted(mut files: Vec<(File, f64)>) -> Vec<(File, f64)> {
    sort_owned_by(&mut files, |(_, a), (_, b)| a.total_cmp(b));
    files
}

/// The assets by the fit of their sizes, each with its factor. An error of 0 keeps all, another one those whose scaling along each of
/// the axes is at most this far from 1. NaN keeps none.
pub(super) fn by_size(
    env: &mut Env,
    shape: &impl View,
    files: Vec<File>,
    axes: SizeAxes,
    most_error: f64,
) -> Vec<(File, f64)> {
    let scope = scope(shape);
    let measured = sizes(env, files).into_iter();
    let is_near = |size: &DVec3| {
        // A rounding error is no further scaling.
        let error = |&axis: &usize| (scope[axis] / size[axis] - 1.0).abs() * (1.0 - 1e-12);
        most_error == 0.0 || axes.compared().iter().all(|axis| scope[*axis] == size[*axis] || error(axis) <= most_error)
    };
    let fit = |size: DVec3| axes.compared().iter().map(|&axis| factor(scope[axis], size[axis])).fold(1.0, f64::max);
    sorted(measured.filter(|(_, size)| is_near(size)).map(|(file, size)| (file, fit(size))).collect())
}

/// The assets by the fit of their ratios, each with its factor.
pub(super) fn by_ratio(env: &mut Env, shape: &impl View, files: Vec<File>, axes: RatioAxes) -> Vec<(File, f64)> {
    let scope = scope(shape);
    let fit = |size: DVec3| {
        let factors = axes.compared().iter().map(|pair| ratio_factor(pair.map(|k| scope[k]), pair.map(|k| size[k])));
        factors.fold(1.0, f64::max)
    };
    sorted(sizes(env, files).into_iter().map(|(file, size)| (file, fit(size))).collect())
}

/// The images by the fit of width : height, each with its factor. Files that cannot be read are left out, with a fault.
pub(super) fn images_by_ratio(env: &mut Env, shape: &impl View, files: Vec<File>, axes: ImageAxes) -> Vec<(File, f64)> {
    let scope = axes.compared().map(|axis| scope(shape)[axis]);
    let mut found = Vec::with_capacity(files.len());
    for file in files {
        match image_size(env, &file) {
            Ok((width, height)) => found.push((file, ratio_factor(scope, [width.into(), height.into()]))),
            Err(why) => left_out(env, &file, &why),
        }
    }
    sorted(found)
}

/// The files of a list in text.
fn listed(list: &File) -> Vec<File> {
    let names = list.name.split(';').filter(|name| !name.is_empty());
    names.map(|name| File::new(Text::from(name), list.folder.clone())).collect()
}

/// The files of an array.
fn of_array(files: &Files) -> Vec<File> {
    files.names.as_slice().iter().map(|name| File::new(name.clone(), files.folder.clone())).collect()
}

fn as_list(env: &mut Env, files: Vec<(File, f64)>) -> Text {
    let names: Vec<Text> = files.into_iter().map(|(file, _)| file.name).collect();
    list(env, &names)
}

fn as_array(env: &mut Env, files: Vec<(File, f64)>) -> Array<Text> {
    if env.may_hold(files.len()) { files.into_iter().map(|(file, _)| file.name).collect() } else { Array::default() }
}

/// `assetsSortSize(list, axes, maxScaleError)`: the assets of a list by the fit of their sizes, the best one first, as a list
/// (*assetsSortSize function*). With 0 all of them, with 0.1 the assets that are scaled by at most 10 % along each axis. Assets that
/// cannot be read are left out, with a fault.
pub fn assets_sort_size(env: &mut Env, shape: &mut impl View, list: File, axes: SizeAxes, most_error: f64) -> Text {
    let found = by_size(env, shape, listed(&list), axes, most_error);
    as_list(env, found)
}

/// The same for an array.
pub fn assets_sort_size_array(
    env: &mut Env,
    shape: &mut impl View,
    files: Files,
    axes: SizeAxes,
    most_error: f64,
) -> Array<Text> {
    let found = by_size(env, shape, of_array(&files), axes, most_error);
    as_array(env, found)
}

/// `assetsSortRatio(list, axes)`: the assets of a list by the fit of their ratios, the best one first, as a list (*assetsSortRatio
/// function*).
pub fn assets_sort_ratio(env: &mut Env, shape: &mut impl View, list: File, axes: RatioAxes) -> Text {
    let found = by_ratio(env, shape, listed(&list), axes);
    as_list(env, found)
}

/// The same for an array.
pub fn assets_sort_ratio_array(env: &mut Env, shape: &mut impl View, files: Files, axes: RatioAxes) -> Array<Text> {
    let found = by_ratio(env, shape, of_array(&files), axes);
    as_array(env, found)
}

/// `imagesSortRatio(list, axes)`: the images of a list by the fit of width : height to the ratio of two axes, the best one first, as a
/// list (*imagesSortRatio function*).
pub fn images_sort_ratio(env: &mut Env, shape: &mut impl View, list: File, axes: ImageAxes) -> Text {
    let found = images_by_ratio(env, shape, listed(&list), axes);
    as_list(env, found)
}

/// The same for an array.
pub fn images_sort_ratio_array(env: &mut Env, shape: &mut impl View, files: Files, axes: ImageAxes) -> Array<Text> {
    let found = images_by_ratio(env, shape, of_array(&files), axes);
    as_array(env, found)
}
