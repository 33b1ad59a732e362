//! Reads of attributes of the material.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::current::whole;
use crate::dispatch::FunctionCall;
use cga_runtime::rt::get;

/// The read of an attribute, by its name.
pub(crate) fn call(name: &str) -> Option<FunctionCall> {
    Some(match name {
        "material.color.r" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_color_r(shape,));
            stack.push_float(value);
        }),
        "material.color.g" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_color_g(shape,));
            stack.push_float(value);
        }),
        "material.color.b" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_color_b(shape,));
            stack.push_float(value);
        }),
        "material.ambient.r" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_ambient_r(shape,));
            stack.push_float(value);
        }),
        "material.ambient.g" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_ambient_g(shape,));
            stack.push_float(value);
        }),
        "material.ambient.b" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_ambient_b(shape,));
            stack.push_float(value);
        }),
        "material.specular.r" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_specular_r(shape,));
            stack.push_float(value);
        }),
        "material.specular.g" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_specular_g(shape,));
            stack.push_float(value);
        }),
        "material.specular.b" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_specular_b(shape,));
            stack.push_float(value);
        }),
        "material.emissive.r" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_emissive_r(shape,));
            stack.push_float(value);
        }),
        "material.emissive.g" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_emissive_g(shape,));
            stack.push_float(value);
        }),
        "material.emissive.b" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_emissive_b(shape,));
            stack.push_float(value);
        }),
        "material.color.rgb" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_color_rgb(shape,));
            stack.push_text(value);
        }),
        "material.color.a" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_color_a(shape,));
            stack.push_float(value);
        }),
        "material.opacity" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_opacity(shape,));
            stack.push_float(value);
        }),
        "material.reflectivity" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_reflectivity(shape,));
            stack.push_float(value);
        }),
        "material.shininess" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_shininess(shape,));
            stack.push_float(value);
        }),
        "material.bumpValue" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_bump_value(shape,));
            stack.push_float(value);
        }),
        "material.metallic" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_metallic(shape,));
            stack.push_float(value);
        }),
        "material.roughness" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_roughness(shape,));
            stack.push_float(value);
        }),
        "material.doubleSided" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_double_sided(shape,));
            stack.push_bool(value);
        }),
        "material.name" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_name(shape,));
            stack.push_text(value);
        }),
        "material.shader" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_shader(shape,));
            stack.push_text(value);
        }),
        "material.colormap" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_colormap(shape,));
            stack.push_text(value);
        }),
        "material.colormap.su" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_colormap_su(shape,));
            stack.push_float(value);
        }),
        "material.colormap.sv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_colormap_sv(shape,));
            stack.push_float(value);
        }),
        "material.colormap.tu" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_colormap_tu(shape,));
            stack.push_float(value);
        }),
        "material.colormap.tv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_colormap_tv(shape,));
            stack.push_float(value);
        }),
        "material.colormap.rw" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_colormap_rw(shape,));
            stack.push_float(value);
        }),
        "material.bumpmap" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_bumpmap(shape,));
            stack.push_text(value);
        }),
        "material.bumpmap.su" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_bumpmap_su(shape,));
            stack.push_float(value);
        }),
        "material.bumpmap.sv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_bumpmap_sv(shape,));
            stack.push_float(value);
        }),
        "material.bumpmap.tu" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_bumpmap_tu(shape,));
            stack.push_float(value);
        }),
        "material.bumpmap.tv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_bumpmap_tv(shape,));
            stack.push_float(value);
        }),
        "material.bumpmap.rw" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_bumpmap_rw(shape,));
            stack.push_float(value);
        }),
        "material.dirtmap" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_dirtmap(shape,));
            stack.push_text(value);
        }),
        "material.dirtmap.su" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_dirtmap_su(shape,));
            stack.push_float(value);
        }),
        "material.dirtmap.sv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_dirtmap_sv(shape,));
            stack.push_float(value);
        }),
        "material.dirtmap.tu" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_dirtmap_tu(shape,));
            stack.push_float(value);
        }),
        "material.dirtmap.tv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_dirtmap_tv(shape,));
            stack.push_float(value);
        }),
        "material.dirtmap.rw" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_dirtmap_rw(shape,));
            stack.push_float(value);
        }),
        "material.specularmap" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_specularmap(shape,));
            stack.push_text(value);
        }),
        "material.specularmap.su" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_specularmap_su(shape,));
            stack.push_float(value);
        }),
        "material.specularmap.sv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_specularmap_sv(shape,));
            stack.push_float(value);
        }),
        "material.specularmap.tu" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_specularmap_tu(shape,));
            stack.push_float(value);
        }),
        "material.specularmap.tv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_specularmap_tv(shape,));
            stack.push_float(value);
        }),
        "material.specularmap.rw" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_specularmap_rw(shape,));
            stack.push_float(value);
        }),
        "material.opacitymap" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_opacitymap(shape,));
            stack.push_text(value);
        }),
        "material.opacitymap.su" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_opacitymap_su(shape,));
            stack.push_float(value);
        }),
        "material.opacitymap.sv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_opacitymap_sv(shape,));
            stack.push_float(value);
        }),
        "material.opacitymap.tu" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_opacitymap_tu(shape,));
            stack.push_float(value);
        }),
        "material.opacitymap.tv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_opacitymap_tv(shape,));
            stack.push_float(value);
        }),
        "material.opacitymap.rw" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_opacitymap_rw(shape,));
            stack.push_float(value);
        }),
        "material.normalmap" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_normalmap(shape,));
            stack.push_text(value);
        }),
        "material.normalmap.su" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_normalmap_su(shape,));
            stack.push_float(value);
        }),
        "material.normalmap.sv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_normalmap_sv(shape,));
            stack.push_float(value);
        }),
        "material.normalmap.tu" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_normalmap_tu(shape,));
            stack.push_float(value);
        }),
        "material.normalmap.tv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_normalmap_tv(shape,));
            stack.push_float(value);
        }),
        "material.normalmap.rw" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_normalmap_rw(shape,));
            stack.push_float(value);
        }),
        "material.emissivemap" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_emissivemap(shape,));
            stack.push_text(value);
        }),
        "material.emissivemap.su" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_emissivemap_su(shape,));
            stack.push_float(value);
        }),
        "material.emissivemap.sv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_emissivemap_sv(shape,));
            stack.push_float(value);
        }),
        "material.emissivemap.tu" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_emissivemap_tu(shape,));
            stack.push_float(value);
        }),
        "material.emissivemap.tv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_emissivemap_tv(shape,));
            stack.push_float(value);
        }),
        "material.emissivemap.rw" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_emissivemap_rw(shape,));
            stack.push_float(value);
        }),
        "material.occlusionmap" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_occlusionmap(shape,));
            stack.push_text(value);
        }),
        "material.occlusionmap.su" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_occlusionmap_su(shape,));
            stack.push_float(value);
        }),
        "material.occlusionmap.sv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_occlusionmap_sv(shape,));
            stack.push_float(value);
        }),
        "material.occlusionmap.tu" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_occlusionmap_tu(shape,));
            stack.push_float(value);
        }),
        "material.occlusionmap.tv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_occlusionmap_tv(shape,));
            stack.push_float(value);
        }),
        "material.occlusionmap.rw" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_occlusionmap_rw(shape,));
            stack.push_float(value);
        }),
        "material.roughnessmap" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_roughnessmap(shape,));
            stack.push_text(value);
        }),
        "material.roughnessmap.su" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_roughnessmap_su(shape,));
            stack.push_float(value);
        }),
        "material.roughnessmap.sv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_roughnessmap_sv(shape,));
            stack.push_float(value);
        }),
        "material.roughnessmap.tu" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_roughnessmap_tu(shape,));
            stack.push_float(value);
        }),
        "material.roughnessmap.tv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_roughnessmap_tv(shape,));
            stack.push_float(value);
        }),
        "material.roughnessmap.rw" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_roughnessmap_rw(shape,));
            stack.push_float(value);
        }),
        "material.metallicmap" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_metallicmap(shape,));
            stack.push_text(value);
        }),
        "material.metallicmap.su" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_metallicmap_su(shape,));
            stack.push_float(value);
        }),
        "material.metallicmap.sv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_metallicmap_sv(shape,));
            stack.push_float(value);
        }),
        "material.metallicmap.tu" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_metallicmap_tu(shape,));
            stack.push_float(value);
        }),
        "material.metallicmap.tv" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_metallicmap_tv(shape,));
            stack.push_float(value);
        }),
        "material.metallicmap.rw" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_metallicmap_rw(shape,));
            stack.push_float(value);
        }),
        "material.map3" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_specularmap(shape,));
            stack.push_text(value);
        }),
        "material.map4" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_opacitymap(shape,));
            stack.push_text(value);
        }),
        "material.map5" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_normalmap(shape,));
            stack.push_text(value);
        }),
        "material.opacitymap.mode" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_opacitymap_mode(shape,));
            stack.push_text(value);
        }),
        "material.opacitymap.cutoff" => FunctionCall::new(|stack, env, current| {
            let value = whole!(env, current, |shape| get::material_opacitymap_cutoff(shape,));
            stack.push_float(value);
        }),
        _ => return None,
    })
}
