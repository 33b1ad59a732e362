//! The pages' examples: what the tests check and `examples/gallery.rs` draws.

pub(crate) mod boolean;
pub(crate) mod boolean_table;
pub(crate) mod cleanup;
pub(crate) mod comp;
pub(crate) mod components;
pub(crate) mod cutting;
pub(crate) mod example;
pub(crate) mod mass;
pub(crate) mod mesh_operations;
pub(crate) mod meshes;
pub(crate) mod normals;
pub(crate) mod primitives;
pub(crate) mod recompose;
pub(crate) mod roofs;
pub(crate) mod scattering;
pub(crate) mod setback;
pub(crate) mod split_area;
pub(crate) mod split_attribute;
pub(crate) mod split_operation;
pub(crate) mod subdivision_once;
pub(crate) mod subdivision_repeat;
pub(crate) mod tags;
pub(crate) mod texturing;
pub(crate) mod wings;
