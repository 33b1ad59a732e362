//! Materials: the reverse of what the writer of GLB does.

use super::GltfError;
use super::document::{Document, Resource, resource};
use super::images::MaterialImages;
use super::item::{Item, item};
use crate::asset::image::header;
use crate::material::layer::Placement;
use crate::material::{Channel, Color, ColorOf, Layer, LayerPart, Material, MaterialNumber, MaterialText};
use crate::value::text::Text;

/// A material, and the coordinates of its images.
pub(super) struct GltfMaterial {
    pub(super) material: Material,
    /// For each layer, the number `n` of the coordinates `TEXCOORD_n` that its image uses. `None` without an image.
    pub(super) coordinates: [Option<usize>; Layer::ALL.len()],
}

/// The value of `material.shader` for materials of the format (*insert operation*).
const SHADER: &str = "CityEnginePBRShader";

/// Reads materials one by one.
pub(super) struct MaterialReader<'a, 'b> {
    pub(super) document: &'a Document<'b>,
    pub(super) images: &'a mut MaterialImages,
    /// Returns the bytes of a file by its name.
    pub(super) file: &'a mut dyn FnMut(&str) -> Option<Vec<u8>>,
}

impl MaterialReader<'_, '_> {
    /// The material with an index.
    pub(super) fn read(&mut self, index: usize) -> Result<GltfMaterial, GltfError> {
        let source = item(&self.document.json, "materials", index)?;
        let mut found = GltfMaterial { material: Material::UNSET, coordinates: [None; Layer::ALL.len()] };
        let material = &mut found.material;
        if let Some(name) = source.text("name")?.filter(|name| !name.is_empty()) {
            material.name = Some(Text::from(name));
        }
        material.set_text(MaterialText::Shader, SHADER);
        material.double_sided = Some(source.flag("doubleSided")?);
        let pbr = source.object("pbrMetallicRoughness")?;
        let factor = |member| pbr.map_or(Ok(None), |pbr| pbr.number(member));
        let [r, g, b, opacity] = pbr.map_or(Ok(None), |pbr| pbr.numbers("baseColorFactor"))?.unwrap_or([1.0; 4]);
        material.color = Some(Color::new(srgb(r), srgb(g), srgb(b)));
        material.opacity = Some(opacity.clamp(0.0, 1.0));
        material.metallic = Some(factor("metallicFactor")?.unwrap_or(1.0).clamp(0.0, 1.0));
        material.roughness = Some(factor("roughnessFactor")?.unwrap_or(1.0).clamp(0.0, 1.0));
        let strength = source.extension("KHR_materials_emissive_strength")?;
        let strength = strength.map_or(Ok(None), |strength| strength.number("emissiveStrength"))?.unwrap_or(1.0);
        let light = source.numbers::<3>("emissiveFactor")?.unwrap_or([0.0; 3]);
        let emissive: ColorOf = MaterialNumber::Emissive;
        for (channel, light) in [Channel::R, Channel::G, Channel::B].into_iter().zip(light) {
            // Black is the default.
            if light != 0.0 {
                material.set_number(emissive(channel), srgb(light * strength));
            }
        }
        let mode = source.text("alphaMode")?.unwrap_or("OPAQUE");
        let (opacity_mode, shows_alpha) = match mode {
            "MASK" => ("mask", true),
            "BLEND" => ("blend", true),
            _ => ("opaque", false),
        };
        material.set_text(MaterialText::OpacityMode, opacity_mode);
        if mode == "MASK" {
            material.set_number(MaterialNumber::Cutoff, source.number("alphaCutoff")?.unwrap_or(0.5));
        }
        if let Some(pbr) = pbr {
            self.layers(&mut found, &pbr, "baseColorTexture", &[Layer::Color])?;
            if shows_alpha && self.images.has_alpha(found.material.texture.as_ref()) {
                self.layers(&mut found, &pbr, "baseColorTexture", &[Layer::Opacity])?;
            }
            self.layers(&mut found, &pbr, "metallicRoughnessTexture", &[Layer::Roughness, Layer::Metallic])?;
        }
        self.layers(&mut found, &source, "normalTexture", &[Layer::Normal])?;
        self.layers(&mut found, &source, "occlusionTexture", &[Layer::Occlusion])?;
        self.layers(&mut found, &source, "emissiveTexture", &[Layer::Emissive])?;
        Ok(found)
    }

    /// Gives layers the image, the coordinates and the placement of a texture.
    fn layers(
        &mut self,
        found: &mut GltfMaterial,
        source: &Item<'_>,
        member: &str,
        layers: &[Layer],
    ) -> Result<(), GltfError> {
        let Some(texture) = source.object(member)? else { return Ok(()) };
        let Some(image) = self.image(texture.required("index")?)? else { return Ok(()) };
        let transform = texture.extension("KHR_texture_transform")?;
        let own = transform.map_or(Ok(None), |transform| transform.whole("texCoord"))?;
        let coordinates = own.or(texture.whole("texCoord")?).unwrap_or(0);
        let placement = transform.map_or(Ok(Placement::PLAIN), |transform| placement(&transform))?;
        for &layer in layers {
            found.coordinates[layer.uv_set()] = Some(coordinates);
            found.material.set_text(MaterialText::Map(layer), image.clone());
            let parts = [
                (LayerPart::Su, placement.scale.x),
                (LayerPart::Sv, placement.scale.y),
                (LayerPart::Tu, placement.offset.x),
                (LayerPart::Tv, placement.offset.y),
                (LayerPart::Rw, placement.turn),
            ];
            for (part, value) in parts {
                let which = MaterialNumber::Map(layer, part);
                if value != which.default_value() {
                    found.material.set_number(which, value);
                }
            }
        }
        Ok(())
    }

    /// The name of the image of a texture. `None` if it is neither PNG nor JPEG.
    fn image(&mut self, texture: usize) -> Result<Option<Text>, GltfError> {
        let texture = item(&self.document.json, "textures", texture)?;
        // An image of another format may be the source of an extension.
        let Some(index) = texture.whole("source")? else { return Ok(None) };
        if let Some(known) = self.images.known(index) {
            return Ok(known.cloned());
        }
        let image = item(&self.document.json, "images", index)?;
        let found = match (image.text("uri")?, image.whole("bufferView")?) {
            (Some(uri), _) => match resource(&image, uri)? {
                Resource::Data(bytes) => self.images.embed(index, &bytes),
                Resource::File(name) => {
                    let file = &mut *self.file;
                    let has_alpha = || {
                        let header = file(&name).and_then(|bytes| header::header(&bytes).ok());
                        header.is_some_and(|header| header.has_alpha)
                    };
                    self.images.refer(index, &name, has_alpha)
                }
            },
            (None, Some(view)) => self.images.embed_view(index, view, self.document)?,
            (None, None) => None,
        };
        Ok(found)
    }
}

/// A placement from `KHR_texture_transform`, whose v points down.
fn placement(transform: &Item<'_>) -> Result<Placement, GltfError> {
    let [x, y] = transform.numbers("offset")?.unwrap_or([0.0; 2]);
    let [su, sv] = transform.numbers("scale")?.unwrap_or([1.0; 2]);
    let turn = transform.number("rotation")?.unwrap_or(0.0).to_degrees();
    let mut placement = Placement { scale: glam::DVec2::new(su, sv), turn, offset: glam::DVec2::ZERO };
    let (sin, cos) = placement.sin_cos();
    placement.offset = glam::DVec2::new(x + sin * sv, 1.0 - cos * sv - y);
    Ok(placement)
}

/// The sRGB value of a channel of linear light.
fn srgb(linear: f64) -> f64 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else if linear < 1.0 {
        1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_becomes_srgb() {
        assert_eq!([srgb(0.0), srgb(1.0), srgb(7.0)], [0.0, 1.0, 1.0]);
        assert!((srgb(0.214_041_140) - 0.5).abs() < 1e-7);
    }
}
