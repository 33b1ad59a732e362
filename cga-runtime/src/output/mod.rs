//! The results of runs: models, and sinks that write buffers, files and pictures.

pub mod batches;
pub mod buffers;
pub mod error;
#[cfg(feature = "gltf")]
mod extremes;
pub(crate) mod flatten;
#[cfg(feature = "gltf")]
pub mod gltf;
#[cfg(feature = "gltf")]
mod interner;
pub(crate) mod leaf_numbers;
pub(crate) mod measure;
pub mod meshes;
pub mod model;
mod near_origin;
mod normals;
pub(crate) mod number_text;
pub mod obj;
pub(crate) mod order;
mod packed;
pub mod picture;
mod placed_assets;
mod room;
pub mod sink_table;
pub mod stats;
pub mod svg;
mod tangents;
mod texture;
mod triangles;
pub mod watertight;
mod whole_file;

pub use whole_file::write_file;
