//! The single list of material attributes: the functions that rules call, the names, and their meanings. Getters,
//! setters and the look-up by name are generated from it.

/// Calls a macro with all numeric attributes: function, name, attribute.
macro_rules! each_material_number {
    ($make:ident) => {
        $make! {
            material_color_r "color.r" MaterialNumber::Color(Channel::R);
            material_color_g "color.g" MaterialNumber::Color(Channel::G);
            material_color_b "color.b" MaterialNumber::Color(Channel::B);
            material_ambient_r "ambient.r" MaterialNumber::Ambient(Channel::R);
            material_ambient_g "ambient.g" MaterialNumber::Ambient(Channel::G);
            material_ambient_b "ambient.b" MaterialNumber::Ambient(Channel::B);
            material_specular_r "specular.r" MaterialNumber::Specular(Channel::R);
            material_specular_g "specular.g" MaterialNumber::Specular(Channel::G);
            material_specular_b "specular.b" MaterialNumber::Specular(Channel::B);
            material_emissive_r "emissive.r" MaterialNumber::Emissive(Channel::R);
            material_emissive_g "emissive.g" MaterialNumber::Emissive(Channel::G);
            material_emissive_b "emissive.b" MaterialNumber::Emissive(Channel::B);
            // A deprecated synonym of the opacity.
            material_color_a "color.a" MaterialNumber::Opacity;
            material_opacity "opacity" MaterialNumber::Opacity;
            material_reflectivity "reflectivity" MaterialNumber::Reflectivity;
            material_shininess "shininess" MaterialNumber::Shininess;
            material_bump_value "bumpValue" MaterialNumber::BumpValue;
            material_metallic "metallic" MaterialNumber::Metallic;
            material_roughness "roughness" MaterialNumber::Roughness;
            material_opacitymap_cutoff "opacitymap.cutoff" MaterialNumber::Cutoff;
            material_colormap_su "colormap.su" MaterialNumber::Map(Layer::Color, LayerPart::Su);
            material_colormap_sv "colormap.sv" MaterialNumber::Map(Layer::Color, LayerPart::Sv);
            material_colormap_tu "colormap.tu" MaterialNumber::Map(Layer::Color, LayerPart::Tu);
            material_colormap_tv "colormap.tv" MaterialNumber::Map(Layer::Color, LayerPart::Tv);
            material_colormap_rw "colormap.rw" MaterialNumber::Map(Layer::Color, LayerPart::Rw);
            material_bumpmap_su "bumpmap.su" MaterialNumber::Map(Layer::Bump, LayerPart::Su);
            material_bumpmap_sv "bumpmap.sv" MaterialNumber::Map(Layer::Bump, LayerPart::Sv);
            material_bumpmap_tu "bumpmap.tu" MaterialNumber::Map(Layer::Bump, LayerPart::Tu);
            material_bumpmap_tv "bumpmap.tv" MaterialNumber::Map(Layer::Bump, LayerPart::Tv);
            material_bumpmap_rw "bumpmap.rw" MaterialNumber::Map(Layer::Bump, LayerPart::Rw);
            material_dirtmap_su "dirtmap.su" MaterialNumber::Map(Layer::Dirt, LayerPart::Su);
            material_dirtmap_sv "dirtmap.sv" MaterialNumber::Map(Layer::Dirt, LayerPart::Sv);
            material_dirtmap_tu "dirtmap.tu" MaterialNumber::Map(Layer::Dirt, LayerPart::Tu);
            material_dirtmap_tv "dirtmap.tv" MaterialNumber::Map(Layer::Dirt, LayerPart::Tv);
            material_dirtmap_rw "dirtmap.rw" MaterialNumber::Map(Layer::Dirt, LayerPart::Rw);
            material_specularmap_su "specularmap.su" MaterialNumber::Map(Layer::Specular, LayerPart::Su);
            material_specularmap_sv "specularmap.sv" MaterialNumber::Map(Layer::Specular, LayerPart::Sv);
            material_specularmap_tu "specularmap.tu" MaterialNumber::Map(Layer::Specular, LayerPart::Tu);
            material_specularmap_tv "specularmap.tv" MaterialNumber::Map(Layer::Specular, LayerPart::Tv);
            material_specularmap_rw "specularmap.rw" MaterialNumber::Map(Layer::Specular, LayerPart::Rw);
            material_opacitymap_su "opacitymap.su" MaterialNumber::Map(Layer::Opacity, LayerPart::Su);
            material_opacitymap_sv "opacitymap.sv" MaterialNumber::Map(Layer::Opacity, LayerPart::Sv);
            material_opacitymap_tu "opacitymap.tu" MaterialNumber::Map(Layer::Opacity, LayerPart::Tu);
            material_opacitymap_tv "opacitymap.tv" MaterialNumber::Map(Layer::Opacity, LayerPart::Tv);
            material_opacitymap_rw "opacitymap.rw" MaterialNumber::Map(Layer::Opacity, LayerPart::Rw);
            material_normalmap_su "normalmap.su" MaterialNumber::Map(Layer::Normal, LayerPart::Su);
            material_normalmap_sv "normalmap.sv" MaterialNumber::Map(Layer::Normal, LayerPart::Sv);
            material_normalmap_tu "normalmap.tu" MaterialNumber::Map(Layer::Normal, LayerPart::Tu);
            material_normalmap_tv "normalmap.tv" MaterialNumber::Map(Layer::Normal, LayerPart::Tv);
            material_normalmap_rw "normalmap.rw" MaterialNumber::Map(Layer::Normal, LayerPart::Rw);
            material_emissivemap_su "emissivemap.su" MaterialNumber::Map(Layer::Emissive, LayerPart::Su);
            material_emissivemap_sv "emissivemap.sv" MaterialNumber::Map(Layer::Emissive, LayerPart::Sv);
            material_emissivemap_tu "emissivemap.tu" MaterialNumber::Map(Layer::Emissive, LayerPart::Tu);
            material_emissivemap_tv "emissivemap.tv" MaterialNumber::Map(Layer::Emissive, LayerPart::Tv);
            material_emissivemap_rw "emissivemap.rw" MaterialNumber::Map(Layer::Emissive, LayerPart::Rw);
            material_occlusionmap_su "occlusionmap.su" MaterialNumber::Map(Layer::Occlusion, LayerPart::Su);
            material_occlusionmap_sv "occlusionmap.sv" MaterialNumber::Map(Layer::Occlusion, LayerPart::Sv);
            material_occlusionmap_tu "occlusionmap.tu" MaterialNumber::Map(Layer::Occlusion, LayerPart::Tu);
            material_occlusionmap_tv "occlusionmap.tv" MaterialNumber::Map(Layer::Occlusion, LayerPart::Tv);
            material_occlusionmap_rw "occlusionmap.rw" MaterialNumber::Map(Layer::Occlusion, LayerPart::Rw);
            material_roughnessmap_su "roughnessmap.su" MaterialNumber::Map(Layer::Roughness, LayerPart::Su);
            material_roughnessmap_sv "roughnessmap.sv" MaterialNumber::Map(Layer::Roughness, LayerPart::Sv);
            material_roughnessmap_tu "roughnessmap.tu" MaterialNumber::Map(Layer::Roughness, LayerPart::Tu);
            material_roughnessmap_tv "roughnessmap.tv" MaterialNumber::Map(Layer::Roughness, LayerPart::Tv);
            material_roughnessmap_rw "roughnessmap.rw" MaterialNumber::Map(Layer::Roughness, LayerPart::Rw);
            material_metallicmap_su "metallicmap.su" MaterialNumber::Map(Layer::Metallic, LayerPart::Su);
            material_metallicmap_sv "metallicmap.sv" MaterialNumber::Map(Layer::Metallic, LayerPart::Sv);
            material_metallicmap_tu "metallicmap.tu" MaterialNumber::Map(Layer::Metallic, LayerPart::Tu);
            material_metallicmap_tv "metallicmap.tv" MaterialNumber::Map(Layer::Metallic, LayerPart::Tv);
            material_metallicmap_rw "metallicmap.rw" MaterialNumber::Map(Layer::Metallic, LayerPart::Rw);
        }
    };
}

/// Calls a macro with all textual attributes: function, name, attribute.
macro_rules! each_material_text {
    ($make:ident) => {
        $make! {
            material_name "name" MaterialText::Name;
            material_shader "shader" MaterialText::Shader;
            material_opacitymap_mode "opacitymap.mode" MaterialText::OpacityMode;
            material_colormap "colormap" MaterialText::Map(Layer::Color);
            material_bumpmap "bumpmap" MaterialText::Map(Layer::Bump);
            material_dirtmap "dirtmap" MaterialText::Map(Layer::Dirt);
            material_specularmap "specularmap" MaterialText::Map(Layer::Specular);
            material_opacitymap "opacitymap" MaterialText::Map(Layer::Opacity);
            material_normalmap "normalmap" MaterialText::Map(Layer::Normal);
            material_emissivemap "emissivemap" MaterialText::Map(Layer::Emissive);
            material_occlusionmap "occlusionmap" MaterialText::Map(Layer::Occlusion);
            material_roughnessmap "roughnessmap" MaterialText::Map(Layer::Roughness);
            material_metallicmap "metallicmap" MaterialText::Map(Layer::Metallic);
        }
    };
}

pub(crate) use {each_material_number, each_material_text};
