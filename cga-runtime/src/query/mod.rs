//! Functions that read the current shape, its geometry, the run or files, named as in the table of the language.
//!
//! Geometry is measured in metres, in the world. Boxes and rectangles are measured by formula, without a mesh. The
//! result equals the result of their mesh.

mod choice;
mod context;
mod convert;
mod count;
mod edge_attr;
mod faces;
mod file;
mod file_table;
mod fit;
mod form;
mod geo_coord;
pub mod get;
mod material;
mod measure;
mod metadata;
mod occlusion;
mod print;
mod readable;
mod tags;
mod texture;
mod tree_key;

pub use crate::comp::select::Word;
pub use crate::geometry::mesh::{TaggedComponents, TextureSpace};
pub use choice::{
    asset_approx_ratio, asset_approx_size, asset_best_ratio, asset_best_size, asset_fit_size, image_approx_ratio,
    image_best_ratio,
};
pub use context::{ContextComparison, QueryTarget, context_compare, context_count, minimum_distance};
pub use convert::{ConvertWhat, System, convert, convert_array};
pub use count::{
    geometry_groups, geometry_materials, geometry_n_edges, geometry_n_faces, geometry_n_holes, geometry_n_vertices,
};
pub use edge_attr::{edge_attr_bool, edge_attr_float, edge_attr_string};
pub use file::{
    AssetDimension, AssetNaming, ImageDimension, asset_info, asset_naming_info, asset_naming_infos, file_exists,
    file_random, file_search, files_search, image_info, read_text_file,
};
pub use file_table::{read_float_table, read_string_table};
pub use fit::{
    ImageAxes, RatioAxes, SizeAxes, assets_sort_ratio, assets_sort_ratio_array, assets_sort_size,
    assets_sort_size_array, images_sort_ratio, images_sort_ratio_array,
};
pub use form::{
    geometry_is_closed_surface, geometry_is_concave, geometry_is_instanced, geometry_is_oriented, geometry_is_planar,
    geometry_is_rectangular,
};
pub use geo_coord::{GeoCoordinate, get_geo_coord};
pub use material::{MaterialMode, MaterialSource, get_material, read_material};
pub use measure::{
    AngleType, geometry_angle, geometry_area, geometry_boundary_length, geometry_height, geometry_volume,
};
pub use metadata::{
    asset_metadata_bool, asset_metadata_bools, asset_metadata_float, asset_metadata_floats, asset_metadata_text,
    asset_metadata_texts,
};
pub use occlusion::{inside, overlaps, touches};
pub use print::print;
pub use tags::{geometry_has_tags, geometry_has_tags_of, geometry_tags, geometry_tags_of};
pub use texture::{
    geometry_du, geometry_dv, geometry_has_uv_set, geometry_has_uvs, geometry_u_max, geometry_u_min, geometry_v_max,
    geometry_v_min,
};

pub use tree_key::get_tree_key;

/// The coordinate that `convert` returns.
pub use crate::geometry::Axis;

#[cfg(test)]
mod tests;
