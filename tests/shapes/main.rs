//! Shapes from rules: components, splits, textures, meshes, assets, extreme numbers, and what sinks get of them.

mod asset_sources;
mod assets;
mod buildings;
mod collect;
mod components;
mod edges;
#[cfg(feature = "geo-types")]
mod geo;
#[allow(deprecated, reason = "rules at the edges of what makes sense: findings are warnings of this kind")]
mod initial_meshes;
mod instances;
mod looks;
mod measured;
mod mesh_operations;
mod normals;
mod placements;
#[allow(deprecated, reason = "rules at the edges of what makes sense: findings are warnings of this kind")]
mod split;
mod texture;
