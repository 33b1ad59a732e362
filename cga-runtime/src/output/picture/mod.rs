//! Pictures of models, drawn without a graphics card.
//!
//! ```no_run
//! # use cga_runtime::output::model::Model;
//! use cga_runtime::output::picture::Picture;
//! # let model = Model::new();
//! let image = Picture::new(1200, 900).looking_from(40.0, 15.0).render(&model);
//! println!("{} pixels", image.rgba.len() / 4);
//! ```
//!
//! A picture has sun, a soft sky and light from the ground, a ground that catches shadows, and thin lines along
//! edges. The same model gives the same bytes on every machine.
//!
//! Faces with texture coordinates show the colour map of their material. Their opacity map makes them transparent: by
//! degrees, or fully or not at all if the mode is `mask`. Files are found in the assets of the model
//! ([`Model::with_assets`]). Without an asset folder they are a checker pattern. If several transparent
//! surfaces overlap, the nearest is drawn. Of all maps, pictures show these two. A translucent box stands for a missing
//! asset.

pub(crate) mod camera;
mod footprint;
mod gamma;
mod light;
mod lines;
#[cfg(feature = "png")]
mod palette;
mod placeholder;
#[cfg(feature = "png")]
mod png;
mod raster;
mod scene;
mod shade;
mod texel;
mod texture;
mod threads;
mod visible;

pub use crate::asset::image::Image;
pub use camera::{Camera, Projection, Viewpoint};

use glam::{DVec3, Vec3};

use self::camera::{Viewport, direction};
use self::gamma::Gamma;
use self::scene::Scene;
use self::shade::{Shader, display};
use crate::geometry::mesh::Bounds;
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

/// The lines that are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lines {
    /// No lines.
    None,
    /// Silhouettes and creases.
    Edges,
    /// Silhouettes, creases, and the borders between leaves in one plane.
    Leaves,
}

/// Colours of light and surroundings, in linear light.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// Sunlight on a surface that faces it.
    pub sun: [f32; 3],
    /// Skylight on a roof that sees all of the sky.
    pub sky: [f32; 3],
    /// Light from the ground on a surface that faces down.
    pub bounce: [f32; 3],
    /// The backdrop at the top and near the bottom.
    pub backdrop: [[f32; 3]; 2],
    /// The ground near the model.
    pub ground: [f32; 3],
    /// The lines.
    pub line: [f32; 3],
    /// The opacity of the lines, 0 to 1.
    pub line_opacity: f32,
    /// The share of light that white surfaces reflect, 0 to 1.
    pub albedo: f32,
}

impl Default for Style {
    fn default() -> Self {
        Style {
            sun: [1.12, 0.99, 0.80],
            sky: [0.47, 0.55, 0.68],
            bounce: [0.42, 0.38, 0.33],
            backdrop: [[0.36, 0.54, 0.76], [0.84, 0.89, 0.93]],
            ground: [0.78, 0.76, 0.72],
            line: [0.02, 0.025, 0.035],
            line_opacity: 0.5,
            albedo: 0.9,
        }
    }
}

/// A model before a camera.
struct Stage {
    bounds: Bounds,
    camera: Camera,
    scene: Scene,
    view: Viewport,
}

impl Picture {
    /// A picture of that size, with default settings.
    pub fn new(width: usize, height: usize) -> Self {
        Picture {
            width,
            height,
            view: Viewpoint::default(),
            ground: true,
            lines: Lines::Edges,
            samples: 2,
            sun_azimuth: -62.0,
            sun_elevation: 42.0,
            style: Style::default(),
        }
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
        let samples = self.samples.clamp(1, 4);
        let (width, height) = (self.width * samples, self.height * samples);
        let Stage { bounds, camera, scene, view } = self.stage(model, width, height);
        let sun = direction(camera.azimuth + self.sun_azimuth, self.sun_elevation);

        let (mut layer, clear) = visible::layers(&scene, &view, width, height);
        let half = bounds.size() * 0.5;
        if self.ground {
            visible::ground(&mut layer, &view, -half.y);
        }
        let light = light::light(&scene, &layer, &view, half, sun);
        let radius = DVec3::new(half.x, 0.0, half.z).length().max(0.3 * half.y);
        let shader = Shader { scene: &scene, view: &view, style: &self.style, sun, radius, ground: -half.y };
        let dark = match self.lines {
            Lines::None => Vec::new(),
            lines => lines::lines(&scene, &layer, lines == Lines::Leaves),
        };
        let color = |sample: usize| {
            let mut color = shader.opaque(&layer, &light, sample);
            if let Some(&dark) = dark.get(sample) {
                color = shade::mix(color, self.style.line.into(), dark * self.style.line_opacity);
            }
            if let Some(clear) = &clear {
                color = shader.clear(clear, &light, sample, color);
            }
            display(color)
        };
        self.filtered(width, samples, color)
    }

    /// The leaf that each pixel shows in its middle, by its index in [`Model::leaves`]; `None` for sky and ground. Pixels are in rows from the
    /// upper left. This is for picking: [`Model::buildings`] tells the building of a leaf, and
    /// [`LeafView::node`](crate::output::model::LeafView::node) its rules.
    ///
    /// ```
    /// # use cga_runtime as cga;
    /// use cga::output::model::Model;
    /// use cga::output::picture::Picture;
    ///
    /// fn picked(model: &Model, [x, y]: [usize; 2]) -> Option<&'static str> {
    ///     let leaf = Picture::new(800, 600).leaves(model)[y * 800 + x]?;
    ///     model.leaves().nth(leaf).map(|leaf| leaf.rule())
    /// }
    /// assert_eq!(picked(&Model::new(), [400, 300]), None);
    /// ```
    pub fn leaves(&self, model: &Model) -> Vec<Option<usize>> {
        let Stage { scene, view, .. } = self.stage(model, self.width, self.height);
        let (opaque, clear) = visible::layers(&scene, &view, self.width, self.height);
        let leaf = |seen: u32| Some(scene.triangles.get(seen as usize)?.leaf as usize - 1);
        let behind = opaque.seen.iter().map(|seen| leaf(*seen));
        match clear {
            None => behind.collect(),
            Some(clear) => clear.seen.iter().zip(behind).map(|(seen, behind)| leaf(*seen).or(behind)).collect(),
        }
    }

    /// The model before a camera whose picture has a number of samples.
    fn stage(&self, model: &Model, width: usize, height: usize) -> Stage {
        let bounds = placeholder::bounds(model);
        let mut scene = Scene::new(&bounds, model.assets().cloned());
        let _ = model.replay(&mut scene);
        let camera = self.view.camera(bounds);
        // The scene is drawn relative to its centre, and so is the camera.
        let moved = |point: DVec3| point - scene.centre;
        let local = Bounds { low: moved(camera.bounds.low), high: moved(camera.bounds.high) };
        let camera = Camera { bounds: local, ..camera };
        let view = match self.view {
            Viewpoint::Camera(_) => Viewport::new(&camera, width, height),
            _ => Viewport::around(&camera, &mut scene.triangles.iter().flat_map(|t| t.corners()), width, height),
        };
        Stage { bounds, camera, scene, view }
    }

    /// Averages samples to pixels, in linear light.
    fn filtered(&self, width: usize, samples: usize, color: impl Fn(usize) -> Vec3) -> Image {
        let mut image = Image::filled(self.width, self.height, [0, 0, 0, 255]);
        let gamma = Gamma::new();
        let share = 1.0 / (samples * samples) as f32;
        for (at, pixel) in image.rgba.chunks_exact_mut(4).enumerate() {
            let (x, y) = (at % self.width * samples, at / self.width * samples);
            let row = |row: usize| (0..samples).map(move |column| (y + row) * width + x + column);
            let sum: Vec3 = (0..samples).flat_map(row).map(&color).sum();
            (0..3).for_each(|i| pixel[i] = gamma.byte(sum[i] * share));
        }
        image
    }
}
