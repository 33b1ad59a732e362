//! Geometry: meshes and operations on them.
#![forbid(unsafe_code)]

pub use glam;

pub mod along_uv;
mod average_normal;
pub mod boolean;
pub(crate) mod bounds;
pub mod buckets;
pub mod cleanup;
pub mod conform;
pub mod convexify;
pub mod cut;
pub mod derive;
pub mod disjoint;
pub mod each;
pub mod envelope;
mod exact;
pub mod extract;
pub mod extrude;
pub mod extrude_wire;
pub mod face_frame;
pub mod footprint;
pub(crate) mod frame;
pub mod holes;
pub mod hull;
pub mod inner_rectangle;
pub(crate) mod long_sort;
pub mod mesh;
mod nesting;
pub mod obj;
pub mod offset;
pub mod origin;
pub mod overlay;
pub mod primitive;
pub mod provenance;
#[cfg(test)]
pub(crate) mod random;
pub mod recompose;
pub mod rectify;
pub mod reduce;
pub mod roof;
pub mod rotation;
pub mod scatter;
pub mod segment;
pub mod skeleton;
pub mod small_sort;
pub(crate) mod soften;
pub mod solid;
mod status;
pub mod tol;
pub mod trace;
pub mod triangulate;
pub mod unbent;
pub mod uv_map;
pub(crate) mod vector;
pub mod wire;
pub mod work;

pub use frame::{Axis, Frame};
