//! Changes of attributes of the current shape.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::Change;
use cga_runtime::rt::set;

/// The change of an attribute, by its name.
pub(crate) fn call(name: &str) -> Option<Change> {
    Some(match name {
        "scope.sx" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::scope_sx(env, shape, value);
        }),
        "scope.sy" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::scope_sy(env, shape, value);
        }),
        "scope.sz" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::scope_sz(env, shape, value);
        }),
        "scope.tx" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::scope_tx(env, shape, value);
        }),
        "scope.ty" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::scope_ty(env, shape, value);
        }),
        "scope.tz" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::scope_tz(env, shape, value);
        }),
        "scope.rx" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::scope_rx(env, shape, value);
        }),
        "scope.ry" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::scope_ry(env, shape, value);
        }),
        "scope.rz" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::scope_rz(env, shape, value);
        }),
        "trim.vertical" => Change::new(|stack, env, shape, _| {
            let value = stack.bool();
            set::trim_vertical(env, shape, value);
        }),
        "trim.horizontal" => Change::new(|stack, env, shape, _| {
            let value = stack.bool();
            set::trim_horizontal(env, shape, value);
        }),
        "seedian" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::seedian(env, shape, value);
        }),
        "pivot.px" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::pivot_px(env, shape, value);
        }),
        "pivot.py" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::pivot_py(env, shape, value);
        }),
        "pivot.pz" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::pivot_pz(env, shape, value);
        }),
        "pivot.ox" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::pivot_ox(env, shape, value);
        }),
        "pivot.oy" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::pivot_oy(env, shape, value);
        }),
        "pivot.oz" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::pivot_oz(env, shape, value);
        }),
        "material.color.r" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_color_r(env, shape, value);
        }),
        "material.color.g" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_color_g(env, shape, value);
        }),
        "material.color.b" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_color_b(env, shape, value);
        }),
        "material.ambient.r" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_ambient_r(env, shape, value);
        }),
        "material.ambient.g" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_ambient_g(env, shape, value);
        }),
        "material.ambient.b" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_ambient_b(env, shape, value);
        }),
        "material.specular.r" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_specular_r(env, shape, value);
        }),
        "material.specular.g" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_specular_g(env, shape, value);
        }),
        "material.specular.b" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_specular_b(env, shape, value);
        }),
        "material.emissive.r" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_emissive_r(env, shape, value);
        }),
        "material.emissive.g" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_emissive_g(env, shape, value);
        }),
        "material.emissive.b" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_emissive_b(env, shape, value);
        }),
        "material.color.rgb" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_color_rgb(env, shape, value);
        }),
        "material.color.a" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_color_a(env, shape, value);
        }),
        "material.opacity" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_opacity(env, shape, value);
        }),
        "material.reflectivity" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_reflectivity(env, shape, value);
        }),
        "material.shininess" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_shininess(env, shape, value);
        }),
        "material.bumpValue" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_bump_value(env, shape, value);
        }),
        "material.metallic" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_metallic(env, shape, value);
        }),
        "material.roughness" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_roughness(env, shape, value);
        }),
        "material.doubleSided" => Change::new(|stack, env, shape, _| {
            let value = stack.bool();
            set::material_double_sided(env, shape, value);
        }),
        "material.name" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_name(env, shape, value);
        }),
        "material.shader" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_shader(env, shape, value);
        }),
        "material.colormap" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_colormap(env, shape, value);
        }),
        "material.colormap.su" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_colormap_su(env, shape, value);
        }),
        "material.colormap.sv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_colormap_sv(env, shape, value);
        }),
        "material.colormap.tu" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_colormap_tu(env, shape, value);
        }),
        "material.colormap.tv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_colormap_tv(env, shape, value);
        }),
        "material.colormap.rw" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_colormap_rw(env, shape, value);
        }),
        "material.bumpmap" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_bumpmap(env, shape, value);
        }),
        "material.bumpmap.su" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_bumpmap_su(env, shape, value);
        }),
        "material.bumpmap.sv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_bumpmap_sv(env, shape, value);
        }),
        "material.bumpmap.tu" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_bumpmap_tu(env, shape, value);
        }),
        "material.bumpmap.tv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_bumpmap_tv(env, shape, value);
        }),
        "material.bumpmap.rw" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_bumpmap_rw(env, shape, value);
        }),
        "material.dirtmap" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_dirtmap(env, shape, value);
        }),
        "material.dirtmap.su" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_dirtmap_su(env, shape, value);
        }),
        "material.dirtmap.sv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_dirtmap_sv(env, shape, value);
        }),
        "material.dirtmap.tu" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_dirtmap_tu(env, shape, value);
        }),
        "material.dirtmap.tv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_dirtmap_tv(env, shape, value);
        }),
        "material.dirtmap.rw" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_dirtmap_rw(env, shape, value);
        }),
        "material.specularmap" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_specularmap(env, shape, value);
        }),
        "material.specularmap.su" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_specularmap_su(env, shape, value);
        }),
        "material.specularmap.sv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_specularmap_sv(env, shape, value);
        }),
        "material.specularmap.tu" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_specularmap_tu(env, shape, value);
        }),
        "material.specularmap.tv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_specularmap_tv(env, shape, value);
        }),
        "material.specularmap.rw" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_specularmap_rw(env, shape, value);
        }),
        "material.opacitymap" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_opacitymap(env, shape, value);
        }),
        "material.opacitymap.su" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_opacitymap_su(env, shape, value);
        }),
        "material.opacitymap.sv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_opacitymap_sv(env, shape, value);
        }),
        "material.opacitymap.tu" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_opacitymap_tu(env, shape, value);
        }),
        "material.opacitymap.tv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_opacitymap_tv(env, shape, value);
        }),
        "material.opacitymap.rw" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_opacitymap_rw(env, shape, value);
        }),
        "material.normalmap" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_normalmap(env, shape, value);
        }),
        "material.normalmap.su" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_normalmap_su(env, shape, value);
        }),
        "material.normalmap.sv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_normalmap_sv(env, shape, value);
        }),
        "material.normalmap.tu" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_normalmap_tu(env, shape, value);
        }),
        "material.normalmap.tv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_normalmap_tv(env, shape, value);
        }),
        "material.normalmap.rw" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_normalmap_rw(env, shape, value);
        }),
        "material.emissivemap" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_emissivemap(env, shape, value);
        }),
        "material.emissivemap.su" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_emissivemap_su(env, shape, value);
        }),
        "material.emissivemap.sv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_emissivemap_sv(env, shape, value);
        }),
        "material.emissivemap.tu" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_emissivemap_tu(env, shape, value);
        }),
        "material.emissivemap.tv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_emissivemap_tv(env, shape, value);
        }),
        "material.emissivemap.rw" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_emissivemap_rw(env, shape, value);
        }),
        "material.occlusionmap" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_occlusionmap(env, shape, value);
        }),
        "material.occlusionmap.su" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_occlusionmap_su(env, shape, value);
        }),
        "material.occlusionmap.sv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_occlusionmap_sv(env, shape, value);
        }),
        "material.occlusionmap.tu" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_occlusionmap_tu(env, shape, value);
        }),
        "material.occlusionmap.tv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_occlusionmap_tv(env, shape, value);
        }),
        "material.occlusionmap.rw" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_occlusionmap_rw(env, shape, value);
        }),
        "material.roughnessmap" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_roughnessmap(env, shape, value);
        }),
        "material.roughnessmap.su" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_roughnessmap_su(env, shape, value);
        }),
        "material.roughnessmap.sv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_roughnessmap_sv(env, shape, value);
        }),
        "material.roughnessmap.tu" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_roughnessmap_tu(env, shape, value);
        }),
        "material.roughnessmap.tv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_roughnessmap_tv(env, shape, value);
        }),
        "material.roughnessmap.rw" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_roughnessmap_rw(env, shape, value);
        }),
        "material.metallicmap" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_metallicmap(env, shape, value);
        }),
        "material.metallicmap.su" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_metallicmap_su(env, shape, value);
        }),
        "material.metallicmap.sv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_metallicmap_sv(env, shape, value);
        }),
        "material.metallicmap.tu" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_metallicmap_tu(env, shape, value);
        }),
        "material.metallicmap.tv" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_metallicmap_tv(env, shape, value);
        }),
        "material.metallicmap.rw" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_metallicmap_rw(env, shape, value);
        }),
        "material.map3" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_specularmap(env, shape, value);
        }),
        "material.map4" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_opacitymap(env, shape, value);
        }),
        "material.map5" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_normalmap(env, shape, value);
        }),
        "material.opacitymap.mode" => Change::new(|stack, env, shape, _| {
            let value = stack.text();
            set::material_opacitymap_mode(env, shape, value);
        }),
        "material.opacitymap.cutoff" => Change::new(|stack, env, shape, _| {
            let value = stack.float();
            set::material_opacitymap_cutoff(env, shape, value);
        }),
        _ => return None,
    })
}
