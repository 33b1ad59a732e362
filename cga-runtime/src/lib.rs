//! The runtime of `cga`: scopes, meshes, the split solver, cutting and capping, components, derivation and sinks.
//!
//! Conventions: right-handed, y up, metres and degrees; f64 inside, f32 in output buffers. Faces are planar polygons
//! with holes, counter-clockwise seen from outside. Most users want the facade crate `cga`.
#![forbid(unsafe_code)]

pub use array::Array;
pub use glam;

pub mod array;
pub mod asset;
pub mod attribute;
pub mod comp;
pub mod cut;
pub mod derive;
pub mod env;
mod exact;
pub mod fault;
pub mod func;
pub mod get;
pub mod grammar;
pub mod host;
mod hull;
pub mod later;
pub mod lazy;
pub mod material;
pub mod mesh;
pub mod model;
mod nearest;
pub mod op;
pub mod parallel;
mod place;
mod provenance;
pub mod query;
pub mod report;
pub mod rt;
pub mod scope;
mod seed;
pub mod session;
pub mod set;
pub mod settings;
pub mod shape;
pub mod sink;
mod skeleton;
pub mod split;
mod state;
pub mod street;
mod template;
pub mod text;
pub mod texture;
pub mod tol;
pub mod triangulate;
mod trim;
mod unit;
pub mod value;
pub mod watch;
mod wire;
