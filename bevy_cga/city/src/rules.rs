//! The rules of houses, streets, gardens and trees, and the images that they name.

use std::path::Path;

use bevy::asset::io::memory::{Dir, MemoryAssetReader};
use bevy::asset::io::{AssetSourceBuilder, AssetSourceId};
use bevy::prelude::*;
use cga::{Settings, cga};

use crate::materials;

// The images are made when the program starts.
cga! { @Allow(missing_asset) pub grammar House in "rules/house.cga"; }

cga! { @Allow(missing_asset) pub grammar Ground in "rules/ground.cga"; }

/// The settings of a run.
pub(crate) fn settings() -> Settings {
    Settings { assets: materials::assets(), ..Settings::default() }
}

/// Gives the images to Bevy, as files in memory. It comes before Bevy's own plugins.
pub(crate) fn add_images(app: &mut App) {
    let folder = Dir::default();
    for (name, image) in materials::images() {
        folder.insert_asset(Path::new(&name), image.to_png().unwrap_or_default());
    }
    let reader = move || Box::new(MemoryAssetReader { root: folder.clone() }) as _;
    app.register_asset_source(AssetSourceId::Default, AssetSourceBuilder::new(reader));
}
