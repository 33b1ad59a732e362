//! The results of runs: models, and sinks that write buffers, files and pictures.

pub mod batches;
pub mod buffers;
pub mod error;
pub(crate) mod flatten;
#[cfg(feature = "gltf")]
pub mod gltf;
#[cfg(feature = "gltf")]
mod interner;
pub(crate) mod measure;
pub mod model;
mod normals;
pub(crate) mod number;
pub(crate) mod numbers;
pub mod obj;
pub(crate) mod order;
pub mod picture;
mod room;
pub mod sink_table;
pub mod stats;
pub mod svg;
mod texture;
mod triangles;
