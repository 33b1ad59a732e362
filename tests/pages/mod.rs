//! The pages' examples: what the tests check and `examples/gallery.rs` draws.

pub mod assets;
pub mod boolean;
pub mod boolean_table;
pub mod cleanup;
pub mod comp;
pub mod components;
pub mod cutting;
pub mod example;
pub mod inserting;
pub mod mass;
pub mod mesh_operations;
pub mod meshes;
pub mod normals;
pub mod primitives;
pub mod recompose;
pub mod roofs;
pub mod scattering;
pub mod scope;
pub mod setback;
pub mod split_area;
pub mod split_attribute;
pub mod split_operation;
pub mod subdivision_once;
pub mod subdivision_repeat;
pub mod tags;
pub mod texturing;
pub mod wings;

use example::Example;

/// The examples of all pages.
pub fn all() -> Vec<Example> {
    [
        split_operation::ALL,
        split_attribute::ALL,
        split_area::ALL,
        subdivision_once::ALL,
        subdivision_repeat::ALL,
        cutting::ALL,
        boolean::ALL,
        boolean_table::ALL,
        comp::ALL,
        components::ALL,
        texturing::ALL,
        primitives::ALL,
        roofs::ALL,
        inserting::ALL,
        mass::ALL,
        recompose::ALL,
        scattering::ALL,
        scope::ALL,
        setback::ALL,
        mesh_operations::ALL,
        normals::ALL,
        cleanup::ALL,
        tags::ALL,
        wings::ALL,
    ]
    .concat()
}
