//! The runtime of `cga`: meshes and cuts, shapes, operations, runs, and the sinks that leaves go to.
//!
//! Each module uses modules below it only (`tests/house/layers.rs` checks this). From the top down:
//!
//! | module | contents |
//! |---|---|
//! | `rt` | the names that generated code uses |
//! | [`grammar`] | grammars, their attributes, sessions, runs on many shapes |
//! | [`output`] | models and sinks: buffers, files, pictures |
//! | `func`, `split`, `comp`, `op`, `query` | functions and operations of the language |
//! | [`run`] | a run: settings, environment, derivation, templates, reports, the sink that takes its leaves |
//! | [`asset`] | meshes and images from files |
//! | [`shape`] | the current shape: scope, geometry, seed, look, trim planes |
//! | [`geometry`] | meshes, cuts, triangulation, offsets, exact predicates |
//! | [`material`], [`fault`], [`value`], `fixed_hash` | plain data, a hash |
//!
//! Conventions: right-handed, y up, metres and degrees; f64 inside, f32 in output buffers. Faces are planar polygons
//! with holes, counter-clockwise seen from outside. Most users want the facade crate `cga`.
#![forbid(unsafe_code)]

pub use cga_geometry as geometry;
pub use glam;

pub mod asset;
pub(crate) mod comp;
#[doc(hidden)]
pub mod facade;
pub mod fault;
pub(crate) mod fixed_hash;
pub(crate) mod func;
pub mod grammar;
pub mod material;
pub(crate) mod op;
pub mod output;
pub(crate) mod query;
#[doc(hidden)]
pub mod rt;
#[doc(hidden)]
pub mod rt_eval;
pub mod run;
pub mod shape;
pub mod split;
pub mod value;
