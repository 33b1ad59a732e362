//! Materials that programs draw, for rules with textures: brick, stone, plaster, paving, roof tiles, slate, grass, asphalt, bark, leaves and
//! water. Their images continue at their borders.
//!
//! A material `slate` has the images `slate.png`, `slate_normal.png` and `slate_rough.png`. Bricks and tiles have several colours and one
//! relief: `brick_red.png`, `brick_brown.png` and `brick_normal.png`. Images without a colour in their name are light, for `color` in rules.
#![allow(dead_code, unreachable_pub, reason = "each example uses some")]

mod ground;
mod masonry;
mod noise;
pub mod opening;
mod roof;
mod surface;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock, OnceLock};

use cga::sink::picture::Image;
use cga::{AssetSource, Assets};

use surface::Surface;

/// Materials with one relief.
struct Family {
    name: &'static str,
    /// The names of its colours; an empty one is light.
    colors: &'static [&'static str],
    surface: fn() -> Surface,
}

const FAMILIES: [Family; 11] = [
    Family { name: "brick", colors: &["red", "brown", "yellow"], surface: masonry::brick },
    Family { name: "stone", colors: &[""], surface: masonry::ashlar },
    Family { name: "plaster", colors: &[""], surface: masonry::plaster },
    Family { name: "paving", colors: &[""], surface: masonry::paving },
    Family { name: "tile", colors: &["", "red"], surface: roof::tile },
    Family { name: "slate", colors: &[""], surface: roof::slate },
    Family { name: "grass", colors: &[""], surface: ground::grass },
    Family { name: "asphalt", colors: &[""], surface: ground::asphalt },
    Family { name: "bark", colors: &[""], surface: ground::bark },
    Family { name: "leaves", colors: &[""], surface: ground::leaves },
    Family { name: "water", colors: &[""], surface: ground::water },
];

impl Family {
    /// The names of its colour maps, with the colours.
    fn color_maps(&self) -> impl Iterator<Item = (String, &'static str)> {
        let name = |color: &&'static str| match *color {
            "" => (format!("{}.png", self.name), ""),
            color => (format!("{}_{color}.png", self.name), color),
        };
        self.colors.iter().map(name)
    }

    /// The names of its normal map and its roughness map.
    fn relief(&self) -> [String; 2] {
        [format!("{}_normal.png", self.name), format!("{}_rough.png", self.name)]
    }

    fn names(&self) -> impl Iterator<Item = String> {
        self.color_maps().map(|(name, _)| name).chain(self.relief())
    }

    fn images(&self) -> BTreeMap<String, Image> {
        let surface = (self.surface)();
        let colors = self.color_maps().map(|(name, color)| (name, surface.color(color)));
        colors.chain(self.relief().into_iter().zip(surface.relief())).collect()
    }
}

/// All images by name.
pub fn images() -> BTreeMap<String, Image> {
    FAMILIES.iter().flat_map(Family::images).collect()
}

/// The surfaces by name.
pub fn surfaces() -> impl Iterator<Item = (&'static str, Surface)> {
    FAMILIES.iter().map(|family| (family.name, (family.surface)()))
}

/// The images as files in memory. A family is drawn when a run asks for one of its images.
pub fn assets() -> Arc<Assets> {
    static ASSETS: LazyLock<Arc<Assets>> = LazyLock::new(|| Arc::new(Assets::from_source(Library::default())));
    ASSETS.clone()
}

/// Files of the same names with a pixel each: white, flat and matte.
pub fn single_pixels() -> Arc<Assets> {
    static ASSETS: LazyLock<Arc<Assets>> = LazyLock::new(|| {
        let pixel = |name: String| {
            let color = if name.ends_with("_normal.png") { [128, 128, 255, 255] } else { [255; 4] };
            (name, file(&Image::filled(1, 1, color)))
        };
        let files = FAMILIES.iter().flat_map(Family::names).map(pixel);
        Arc::new(Assets::from_source(files.collect::<BTreeMap<_, _>>()))
    });
    ASSETS.clone()
}

fn file(image: &Image) -> Vec<u8> {
    image.to_png().unwrap_or_default()
}

/// The files of the families whose images a run has read.
#[derive(Default)]
struct Library([OnceLock<BTreeMap<String, Vec<u8>>>; FAMILIES.len()]);

impl AssetSource for Library {
    fn bytes(&self, name: &str) -> Option<Cow<'_, [u8]>> {
        let (family, files) = FAMILIES.iter().zip(&self.0).find(|(family, _)| family.names().any(|own| own == name))?;
        let files =
            files.get_or_init(|| family.images().into_iter().map(|(name, image)| (name, file(&image))).collect());
        files.get(name).map(|bytes| Cow::Borrowed(bytes.as_slice()))
    }

    fn names(&self) -> Vec<String> {
        FAMILIES.iter().flat_map(Family::names).collect()
    }

    fn has(&self, name: &str) -> bool {
        FAMILIES.iter().any(|family| family.names().any(|own| own == name))
    }
}
