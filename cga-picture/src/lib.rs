//! Pictures of triangles, drawn without a graphics card: sun, a soft sky, light from the ground, shadows, images on surfaces, and
//! thin lines along edges.
//!
//! ```
//! use cga_picture::glam::DVec3;
//! use cga_picture::{Bounds, Paint, Renderer, Scene};
//!
//! let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
//! let mut scene = Scene::new(Bounds::of(corners));
//! let white = scene.add_paint(Paint::default());
//! scene.add_triangle(corners, white);
//! let renderer = Renderer::new(64, 48);
//! let picture = renderer.render(&scene);
//! assert_eq!((picture.width, picture.height, picture.rgba.len()), (64, 48, 4 * 64 * 48));
//! // The triangle is its leaf 0.
//! assert!(renderer.leaves(&scene).contains(&Some(0)));
//! ```
//!
//! | | |
//! |---|---|
//! | what is drawn | [`Scene`], [`Face`], [`Paint`], [`Bitmap`] |
//! | from where | [`Viewpoint`], [`Camera`], [`Projection`], [`Viewport`], [`direction`] |
//! | how | [`Renderer`], [`Lines`], [`Style`] |
#![cfg_attr(feature = "png", doc = "| PNG files | [`png`] |")]
#![cfg_attr(not(feature = "png"), doc = "| PNG files | with the feature `png` |")]
//!
//! A renderer finds the nearest triangle of each sample ([`Renderer::samples`] along a side of a pixel), then the light that reaches it
//! from sun and sky by depth maps, then lines, then colours.
//!
//! Conventions: right-handed coordinates with y up, metres, f64; angles in degrees. Colours are linear light, and bytes of images are
//! sRGB.
//!
//! # Promises
//!
//! - **The same bytes everywhere.** Pictures do not depend on the platform, on threads or on hashing.
//! - **No gaps.** Triangles with a common edge neither share nor omit a pixel.
//! - **Bad input is safe.** Coordinates that are not finite are left out, and numbers that a scene does not know are ignored.
//! - **No unsafe code.**
#![forbid(unsafe_code)]

pub use cga_geometry::mesh::Bounds;
pub use glam;

mod bitmap;
mod camera;
mod face;
mod footprint;
mod gamma;
mod light;
mod lines;
mod paint;
#[cfg(feature = "png")]
mod palette;
#[cfg(feature = "png")]
pub mod png;
mod raster;
mod renderer;
mod scene;
mod shade;
mod style;
mod texture;
mod threads;
mod viewport;
mod visible;

pub use bitmap::Bitmap;
pub use camera::{Camera, Projection, Viewpoint};
pub use face::Face;
pub use gamma::linear;
pub use lines::Lines;
pub use paint::{Alpha, ImageId, Paint, PaintId};
pub use renderer::Renderer;
pub use scene::Scene;
pub use style::Style;
pub use viewport::{Viewport, direction};

/// The code of the README.
#[cfg(all(doctest, feature = "png"))]
#[doc = include_str!("../README.md")]
struct Readme;
