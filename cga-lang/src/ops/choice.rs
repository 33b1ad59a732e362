//! The functions that choose assets and images for the scope, and read data in files of assets and materials.

use super::base::function;
use super::{
    Allowed, B, BS, F, FILE, FS, FileUse, Function, Needs, Param, ParamBounds, Params, Str, T, TS, Uses, boolean,
    bounds, file, files, float, of, text, within, word,
};
use crate::types::Type;

const ASSET_RATIO: Param = word("axesRatio", "RatioAxes", &["xy", "xz", "yz", "xyz"]);
const ASSET_SIZE: Param = word("axisSize", "SizeAxes", &["x", "y", "z", "xy", "xz", "yz", "xyz"]);
const IMAGE_RATIO: Param = word("axesRatio", "ImageAxes", &["xy", "xz", "yx", "yz", "zx", "zy"]);

const LIST: Param = files("filePathList", T);
const ARRAY: Param = files("filePaths", TS);

/// A function of the size of the scope and of files.
const fn sized(name: Str, call: Str, params: Params, ty: Type, about: Str) -> Function {
    let uses = Uses::SIZE.and(Uses::SAYS);
    Function { needs: Needs::Both, uses, ..function(name, call, params, ty, about) }
}

/// A function that also draws a random number.
const fn drawn(name: Str, call: Str, params: Params, about: Str) -> Function {
    let row = sized(name, call, params, T, about);
    Function { uses: row.uses.and(Uses::DRAWS), ..row }
}

const BY_RATIO: &str = "assets by how well their proportions suit";
const BY_SIZE: &str = "assets by how well their size suits";
const IMAGES: &str = "images by how well their proportions suit";

/// Lists of files, sorted.
pub(super) static SORTED: &[Function] = &[
    sized("assetsSortRatio", "assets_sort_ratio", &[LIST, ASSET_RATIO], T, BY_RATIO),
    sized("assetsSortRatio", "assets_sort_ratio_array", &[ARRAY, ASSET_RATIO], TS, BY_RATIO),
    sized("assetsSortSize", "assets_sort_size", &[LIST, ASSET_SIZE, float("maxScaleError")], T, BY_SIZE),
    sized("assetsSortSize", "assets_sort_size_array", &[ARRAY, ASSET_SIZE, float("maxScaleError")], TS, BY_SIZE),
    sized("imagesSortRatio", "images_sort_ratio", &[LIST, IMAGE_RATIO], T, IMAGES),
    sized("imagesSortRatio", "images_sort_ratio_array", &[ARRAY, IMAGE_RATIO], TS, IMAGES),
];

const QUERY: Param = file("searchQuery", FileUse::Searched);
const RATIO: Param = text("axesRatio");
const SIZE: Param = text("axisSize");

/// *assetApproxRatio*, *assetApproxSize*, *imageApproxRatio*.
static COUNTS: ParamBounds = bounds(Allowed::AtLeast(1.0), "at least one file is considered");
const COUNT: Param = within(float("n"), &COUNTS);

/// One of the files that a query finds. These functions are written in CGA in the reference's utility library, where axes are text.
pub(super) static CHOSEN: &[Function] = &[
    sized("assetBestRatio", "asset_best_ratio", &[QUERY, RATIO], T, "the asset whose proportions suit best"),
    drawn(
        "assetApproxRatio",
        "asset_approx_ratio",
        &[QUERY, RATIO, COUNT],
        "one of the assets whose proportions suit best",
    ),
    sized("assetBestSize", "asset_best_size", &[QUERY, SIZE], T, "the asset whose size suits best"),
    drawn("assetApproxSize", "asset_approx_size", &[QUERY, SIZE, COUNT], "one of the assets whose size suits best"),
    drawn(
        "assetFitSize",
        "asset_fit_size",
        &[QUERY, SIZE, float("maxScaleError")],
        "one of the assets whose size suits",
    ),
    drawn("imageBestRatio", "image_best_ratio", &[QUERY, RATIO], "the image whose proportions suit best"),
    drawn(
        "imageApproxRatio",
        "image_approx_ratio",
        &[QUERY, RATIO, COUNT],
        "one of the images whose proportions suit best",
    ),
];

const KEY: Param = text("key");

/// A value in the file of an asset.
const fn metadata(call: Str, params: Params, ty: Type) -> Function {
    let about = "a value kept in an asset's file";
    Function { needs: Needs::Env, uses: Uses::SAYS, ..function("assetMetadata", call, params, ty, about) }
}

/// Data in files of assets and materials.
pub(super) static CONTENTS: &[Function] = &[
    metadata("asset_metadata_float", &[FILE, KEY, float("defaultValue")], F),
    metadata("asset_metadata_bool", &[FILE, KEY, boolean("defaultValue")], B),
    metadata("asset_metadata_text", &[FILE, KEY, text("defaultValue")], T),
    metadata("asset_metadata_floats", &[FILE, KEY, of("defaultValue", FS)], FS),
    metadata("asset_metadata_bools", &[FILE, KEY, of("defaultValue", BS)], BS),
    metadata("asset_metadata_texts", &[FILE, KEY, of("defaultValue", TS)], TS),
    Function {
        needs: Needs::Env,
        uses: Uses::SAYS,
        ..function(
            "readMaterial",
            "read_material",
            &[FILE],
            TS,
            "the attributes of a material file, as names and values",
        )
    },
];
