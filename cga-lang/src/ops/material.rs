//! The attributes of the material.

use super::base::{both, using};
use super::{B, Changes, F, ParamKind, ShapeAttr, T, Uses};
use crate::types::Type;

const OPACITY: &str = "write `material.opacity`";

/// `material.map3` to `map5`, deprecated by *CGA changelog 2011.1*.
const fn old_map(name: &'static str, call: &'static str, layer: u32, instead: &'static str) -> ShapeAttr {
    ShapeAttr { old: Some(instead), ..map(name, call, layer) }
}

/// The image of a texture layer.
const fn map(name: &'static str, call: &'static str, layer: u32) -> ShapeAttr {
    ShapeAttr { kind: ParamKind::Image(layer), ..look(name, call, T) }
}

/// A row of the material. Reading it uses the whole shape: if rules have set nothing, the geometry's own material
/// counts. Setting it uses the material only.
const fn look(name: &'static str, call: &'static str, ty: Type) -> ShapeAttr {
    let row = using(Uses::BODY, Uses::NONE, both(name, call, ty));
    ShapeAttr { set_changes: Changes::Material, ..row }
}

/// A channel of the colour. Setting one reads the other two.
const fn channel(name: &'static str, call: &'static str) -> ShapeAttr {
    using(Uses::BODY, Uses::BODY, both(name, call, F))
}

pub(super) static MATERIAL: &[ShapeAttr] = &[
    channel("material.color.r", "material_color_r"),
    channel("material.color.g", "material_color_g"),
    channel("material.color.b", "material_color_b"),
    look("material.ambient.r", "material_ambient_r", F),
    look("material.ambient.g", "material_ambient_g", F),
    look("material.ambient.b", "material_ambient_b", F),
    look("material.specular.r", "material_specular_r", F),
    look("material.specular.g", "material_specular_g", F),
    look("material.specular.b", "material_specular_b", F),
    look("material.emissive.r", "material_emissive_r", F),
    look("material.emissive.g", "material_emissive_g", F),
    look("material.emissive.b", "material_emissive_b", F),
    ShapeAttr { kind: ParamKind::Color, ..look("material.color.rgb", "material_color_rgb", T) },
    ShapeAttr { old: Some(OPACITY), ..look("material.color.a", "material_color_a", F) },
    look("material.opacity", "material_opacity", F),
    look("material.reflectivity", "material_reflectivity", F),
    look("material.shininess", "material_shininess", F),
    look("material.bumpValue", "material_bump_value", F),
    look("material.metallic", "material_metallic", F),
    look("material.roughness", "material_roughness", F),
    look("material.doubleSided", "material_double_sided", B),
    look("material.name", "material_name", T),
    look("material.shader", "material_shader", T),
    map("material.colormap", "material_colormap", 0),
    look("material.colormap.su", "material_colormap_su", F),
    look("material.colormap.sv", "material_colormap_sv", F),
    look("material.colormap.tu", "material_colormap_tu", F),
    look("material.colormap.tv", "material_colormap_tv", F),
    look("material.colormap.rw", "material_colormap_rw", F),
    map("material.bumpmap", "material_bumpmap", 1),
    look("material.bumpmap.su", "material_bumpmap_su", F),
    look("material.bumpmap.sv", "material_bumpmap_sv", F),
    look("material.bumpmap.tu", "material_bumpmap_tu", F),
    look("material.bumpmap.tv", "material_bumpmap_tv", F),
    look("material.bumpmap.rw", "material_bumpmap_rw", F),
    map("material.dirtmap", "material_dirtmap", 2),
    look("material.dirtmap.su", "material_dirtmap_su", F),
    look("material.dirtmap.sv", "material_dirtmap_sv", F),
    look("material.dirtmap.tu", "material_dirtmap_tu", F),
    look("material.dirtmap.tv", "material_dirtmap_tv", F),
    look("material.dirtmap.rw", "material_dirtmap_rw", F),
    map("material.specularmap", "material_specularmap", 3),
    look("material.specularmap.su", "material_specularmap_su", F),
    look("material.specularmap.sv", "material_specularmap_sv", F),
    look("material.specularmap.tu", "material_specularmap_tu", F),
    look("material.specularmap.tv", "material_specularmap_tv", F),
    look("material.specularmap.rw", "material_specularmap_rw", F),
    map("material.opacitymap", "material_opacitymap", 4),
    look("material.opacitymap.su", "material_opacitymap_su", F),
    look("material.opacitymap.sv", "material_opacitymap_sv", F),
    look("material.opacitymap.tu", "material_opacitymap_tu", F),
    look("material.opacitymap.tv", "material_opacitymap_tv", F),
    look("material.opacitymap.rw", "material_opacitymap_rw", F),
    map("material.normalmap", "material_normalmap", 5),
    look("material.normalmap.su", "material_normalmap_su", F),
    look("material.normalmap.sv", "material_normalmap_sv", F),
    look("material.normalmap.tu", "material_normalmap_tu", F),
    look("material.normalmap.tv", "material_normalmap_tv", F),
    look("material.normalmap.rw", "material_normalmap_rw", F),
    map("material.emissivemap", "material_emissivemap", 6),
    look("material.emissivemap.su", "material_emissivemap_su", F),
    look("material.emissivemap.sv", "material_emissivemap_sv", F),
    look("material.emissivemap.tu", "material_emissivemap_tu", F),
    look("material.emissivemap.tv", "material_emissivemap_tv", F),
    look("material.emissivemap.rw", "material_emissivemap_rw", F),
    map("material.occlusionmap", "material_occlusionmap", 7),
    look("material.occlusionmap.su", "material_occlusionmap_su", F),
    look("material.occlusionmap.sv", "material_occlusionmap_sv", F),
    look("material.occlusionmap.tu", "material_occlusionmap_tu", F),
    look("material.occlusionmap.tv", "material_occlusionmap_tv", F),
    look("material.occlusionmap.rw", "material_occlusionmap_rw", F),
    map("material.roughnessmap", "material_roughnessmap", 8),
    look("material.roughnessmap.su", "material_roughnessmap_su", F),
    look("material.roughnessmap.sv", "material_roughnessmap_sv", F),
    look("material.roughnessmap.tu", "material_roughnessmap_tu", F),
    look("material.roughnessmap.tv", "material_roughnessmap_tv", F),
    look("material.roughnessmap.rw", "material_roughnessmap_rw", F),
    map("material.metallicmap", "material_metallicmap", 9),
    look("material.metallicmap.su", "material_metallicmap_su", F),
    look("material.metallicmap.sv", "material_metallicmap_sv", F),
    look("material.metallicmap.tu", "material_metallicmap_tu", F),
    look("material.metallicmap.tv", "material_metallicmap_tv", F),
    look("material.metallicmap.rw", "material_metallicmap_rw", F),
    old_map("material.map3", "material_specularmap", 3, "write `material.specularmap`"),
    old_map("material.map4", "material_opacitymap", 4, "write `material.opacitymap`"),
    old_map("material.map5", "material_normalmap", 5, "write `material.normalmap`"),
    look("material.opacitymap.mode", "material_opacitymap_mode", T),
    look("material.opacitymap.cutoff", "material_opacitymap_cutoff", F),
];
