//! Pictures of models, drawn without a graphics card.
//!
//! ```no_run
//! # use cga_runtime::facade as cga;
//! # use cga::Model;
//! use cga::sink::picture::Picture;
//! # let model = Model::new();
//! let image = Picture::new(1200, 900).looking_from(40.0, 15.0).render(&model);
//! println!("{} pixels", image.rgba.len() / 4);
//! ```
//!
//! A picture has sun, a soft sky and light from the ground, a ground that catches shadows, and thin lines along
//! edges. The same model gives the same bytes on every machine.
//!
//! Faces with texture coordinates show the colour map of their material. Their opacity map makes them transparent: by
//! degrees, or fully or not at all if the mode is `mask`. Normal maps change the direction of the light. Files are found in the
//! assets of the model ([`Model::with_assets`]). Without an asset folder a colour map is a checker pattern, and a normal map is
//! left out. If several transparent surfaces overlap, the nearest is drawn. Pictures show these three maps. A translucent box
//! marks a missing asset.

mod images;
mod model_scene;
mod placeholder;
#[cfg(feature = "png")]
mod png;

pub use crate::asset::image::Image;
pub use cga_picture::{Camera, Lines, Projection, Style, Viewpoint};

use cga_picture::{Bitmap, Renderer};

use crate::output::model::Model;

/// The settings of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// The width in pixels.
    pub width: usize,
    /// The height in pixels.
    pub height: usize,
    /// The viewpoint.
    pub view: Viewpoint,
    /// True for a ground that catches shadows, at the model's lowest point.
    pub ground: bool,
    /// The lines that are drawn.
    pub lines: Lines,
    /// The samples along a side of each pixel, 1 to 4.
    pub samples: usize,
    /// The azimuth of the sun in degrees around the model, relative to the camera: −60 is to the left of the viewer.
    pub sun_azimuth: f64,
    /// The elevation of the sun, in degrees.
    pub sun_elevation: f64,
    /// The colours of light and surroundings.
    pub style: Style,
}

impl Model {
    /// Writes a picture of 1200 by 900 pixels as a PNG file; see [`Picture`] for others.
    ///
    /// # Errors
    /// Errors of the file system.
    #[cfg(feature = "png")]
    pub fn write_png(&self, path: impl AsRef<std::path::Path>) -> Result<(), crate::output::error::WriteError> {
        Picture::new(1200, 900).render(self).write_png(path)
    }

    /// Writes the bytes of the file of [`Model::write_png`] to `out`.
    ///
    /// # Errors
    /// As [`Image::write_png_to`].
    #[cfg(feature = "png")]
    pub fn write_png_to(&self, out: impl std::io::Write) -> Result<(), crate::output::error::WriteError> {
        Picture::new(1200, 900).render(self).write_png_to(out)
    }
}

impl Picture {
    /// A picture of that size, with default settings.
    pub fn new(width: usize, height: usize) -> Self {
        let Renderer { width, height, view, ground, lines, samples, sun_azimuth, sun_elevation, style } =
            Renderer::new(width, height);
        Picture { width, height, view, ground, lines, samples, sun_azimuth, sun_elevation, style }
    }

    /// Takes the picture from a camera that does not depend on the model.
    pub fn camera(self, camera: Camera) -> Self {
        Picture { view: Viewpoint::Camera(camera), ..self }
    }

    /// Takes the picture from a direction, in degrees (see [`Camera`]), with the whole model in it.
    pub fn looking_from(self, azimuth: f64, elevation: f64) -> Self {
        Picture { view: Viewpoint::Around { azimuth, elevation }, ..self }
    }

    /// Draws a model.
    pub fn render(&self, model: &Model) -> Image {
        let Bitmap { width, height, rgba } = self.renderer().render(&model_scene::scene(model));
        Image { width, height, rgba }
    }

    /// The leaf that each pixel shows in its middle, by its index in [`Model::leaves`]; `None` for sky and ground. Pixels are in rows from the
    /// upper left. This is for picking: [`Model::buildings`] tells the building of a leaf, and
    /// [`LeafView::node`](crate::output::model::LeafView::node) its rules.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::picture::Picture;
    /// use cga::Model;
    ///
    /// fn picked(model: &Model, [x, y]: [usize; 2]) -> Option<&str> {
    ///     let leaf = Picture::new(800, 600).leaves(model)[y * 800 + x]?;
    ///     model.leaves().nth(leaf).map(|leaf| leaf.rule())
    /// }
    /// assert_eq!(picked(&Model::new(), [400, 300]), None);
    /// ```
    pub fn leaves(&self, model: &Model) -> Vec<Option<usize>> {
        let leaves = self.renderer().leaves(&model_scene::scene(model));
        leaves.into_iter().map(|leaf| Some(leaf? as usize)).collect()
    }

    /// The renderer with the same settings.
    fn renderer(&self) -> Renderer {
        let Picture { width, height, view, ground, lines, samples, sun_azimuth, sun_elevation, ref style } = *self;
        let style = style.clone();
        Renderer { width, height, view, ground, lines, samples, sun_azimuth, sun_elevation, style }
    }
}
