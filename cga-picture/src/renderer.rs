//! Pictures of scenes.

use cga_geometry::mesh::Bounds;
use glam::{DVec3, Vec3};

use crate::bitmap::Bitmap;
use crate::camera::{Camera, Viewpoint};
use crate::gamma::Gamma;
use crate::light;
use crate::lines::{self, Lines};
use crate::scene::Scene;
use crate::shade::{self, Shader, display};
use crate::style::Style;
use crate::viewport::{Viewport, direction};
use crate::visible::{self, VisibilityBuffer};

/// The settings of a picture, which draw scenes.
#[derive(Clone, Debug, PartialEq)]
pub struct Renderer {
    /// The width in pixels.
    pub width: usize,
    /// The height in pixels.
    pub height: usize,
    /// The viewpoint.
    pub view: Viewpoint,
    /// True for a ground that catches shadows, at the lowest point of the scene's bounds.
    pub ground: bool,
    /// The lines that are drawn.
    pub lines: Lines,
    /// The samples along a side of each pixel, 1 to 4.
    pub samples: usize,
    /// The azimuth of the sun in degrees around the scene, relative to the camera: −60 is to the left of the viewer.
    pub sun_azimuth: f64,
    /// The elevation of the sun, in degrees.
    pub sun_elevation: f64,
    /// The colours of light and surroundings.
    pub style: Style,
}

impl Renderer {
    /// A picture of that size in pixels, with default settings.
    pub fn new(width: usize, height: usize) -> Self {
        Renderer {
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

    /// Draws a scene. All pixels are opaque.
    pub fn render(&self, scene: &Scene) -> Bitmap {
        let samples = self.samples.clamp(1, 4);
        let (width, height) = (self.width * samples, self.height * samples);
        let (camera, view) = self.viewport(scene, width, height);
        let sun = direction(camera.azimuth + self.sun_azimuth, self.sun_elevation);

        let (mut layer, clear) = visible::layers(scene, &view, width, height);
        let half = scene.bounds.size() * 0.5;
        if self.ground {
            visible::ground(&mut layer, &view, -half.y);
        }
        let light = light::light(scene, &layer, &view, half, sun);
        let radius = DVec3::new(half.x, 0.0, half.z).length().max(0.3 * half.y);
        let shader = Shader { scene, view: &view, style: &self.style, sun, radius, ground: -half.y };
        let lines = |layer: &VisibilityBuffer| lines::lines(scene, &view, layer, self.lines);
        let dark = if self.lines == Lines::None { Vec::new() } else { lines(&layer) };
        let clear_dark = clear.as_ref().filter(|_| self.lines == Lines::Faces).map_or_else(Vec::new, lines);
        let lined = |color: Vec3, dark: &[f32], sample: usize| match dark.get(sample) {
            Some(dark) => shade::mix(color, self.style.line.into(), dark * self.style.line_opacity),
            None => color,
        };
        let color = |sample: usize| {
            let mut color = lined(shader.opaque(&layer, &light, sample), &dark, sample);
            if let Some(clear) = &clear {
                color = lined(shader.clear(clear, &light, sample, color), &clear_dark, sample);
            }
            display(color)
        };
        self.filtered(width, samples, color)
    }

    /// The leaf that each pixel shows in its middle, by [`Face::leaf`](crate::Face::leaf); `None` for sky and ground. Pixels are
    /// in rows from the upper left.
    pub fn leaves(&self, scene: &Scene) -> Vec<Option<u32>> {
        let (_, view) = self.viewport(scene, self.width, self.height);
        let (opaque, clear) = visible::layers(scene, &view, self.width, self.height);
        let leaf = |seen: u32| Some(scene.triangles.get(seen as usize)?.leaf);
        let behind = opaque.seen.iter().map(|seen| leaf(*seen));
        match clear {
            None => behind.collect(),
            Some(clear) => clear.seen.iter().zip(behind).map(|(seen, behind)| leaf(*seen).or(behind)).collect(),
        }
    }

    /// The camera before a scene, relative to the scene's centre, and its view for a number of samples.
    pub(crate) fn viewport(&self, scene: &Scene, width: usize, height: usize) -> (Camera, Viewport) {
        let camera = self.view.camera(scene.bounds);
        // The scene is drawn relative to its centre, and so is the camera.
        let moved = |point: DVec3| point - scene.centre;
        let local = Bounds { low: moved(camera.bounds.low), high: moved(camera.bounds.high) };
        let camera = Camera { bounds: local, ..camera };
        let view = match self.view {
            Viewpoint::Camera(_) => Viewport::new(&camera, width, height),
            _ => Viewport::around(&camera, &mut scene.triangles.iter().flat_map(|t| t.corners()), width, height),
        };
        (camera, view)
    }

    /// Averages samples to pixels, in linear light.
    fn filtered(&self, width: usize, samples: usize, color: impl Fn(usize) -> Vec3) -> Bitmap {
        let mut image = Bitmap::filled(self.width, self.height, [0, 0, 0, 255]);
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
