//! Geometry: meshes and operations on them. This module does not know shapes, rules or sinks.

pub(crate) mod boolean;
pub(crate) mod buckets;
pub(crate) mod cleanup;
pub(crate) mod conform;
pub(crate) mod convexify;
pub mod cut;
pub(crate) mod derive;
pub(crate) mod disjoint;
pub(crate) mod envelope;
mod exact;
pub mod extract;
pub mod extrude;
pub(crate) mod extrude_wire;
pub(crate) mod face_frame;
pub(crate) mod frame;
pub(crate) mod holes;
pub(crate) mod hull;
pub(crate) mod inner_rectangle;
pub(crate) mod long_sort;
pub mod mesh;
mod nesting;
pub mod offset;
pub(crate) mod origin;
pub(crate) mod overlay;
pub(crate) mod provenance;
#[cfg(test)]
pub(crate) mod random;
pub(crate) mod recompose;
pub(crate) mod rectify;
pub(crate) mod reduce;
pub(crate) mod roof;
pub(crate) mod rotation;
pub(crate) mod sampled_outline;
pub(crate) mod scatter;
pub(crate) mod segment;
pub(crate) mod skeleton;
mod status;
pub mod tol;
pub(crate) mod trace;
pub mod triangulate;
pub(crate) mod unbent;
pub mod uv_map;
pub(crate) mod wire;
pub(crate) mod work;

pub use frame::{Axis, Frame};
