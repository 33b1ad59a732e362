//! Materials and textures, with the feature `pbr`.

use std::collections::{HashMap, HashSet};
use std::path::PathBuf;
use std::sync::{Arc, Weak};

use bevy_app::{App, PostUpdate};
use bevy_asset::{AssetEventSystems, AssetId, AssetPath, AssetServer, Assets, Handle, StrongHandle};
use bevy_camera::visibility::Visibility;
use bevy_color::{Color, LinearRgba};
use bevy_ecs::resource::Resource;
use bevy_ecs::schedule::IntoScheduleConfigs;
use bevy_ecs::system::{Res, ResMut};
use bevy_ecs::world::World;
use bevy_image::{Image, ImageAddressMode, ImageLoaderSettings, ImageSampler, ImageSamplerDescriptor};
use bevy_material::AlphaMode;
use bevy_mesh::UvChannel;
use bevy_pbr::{MeshMaterial3d, StandardMaterial};
use cga::{Channel, Layer, Material, MaterialNumber, MaterialText};

use crate::channel::image;
use crate::mip_levels;
use crate::parts::{CgaMesh, CgaRoot};
use crate::source::Cga;

/// The materials in use, each once.
#[derive(Resource, Default)]
struct MaterialCache {
    /// A material that no mesh uses any more is dropped. Only for look-ups, never iterated in an order that matters.
    known: HashMap<MaterialKey, Weak<StrongHandle>>,
    /// The number of entries at which those without a material are removed.
    full: usize,
    image_folder: PathBuf,
    /// Images that are being loaded.
    loading: HashSet<AssetId<Image>>,
}

/// The properties that make a material different.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct MaterialKey {
    /// The bits of red, green, blue, opacity, metallic, roughness, emitted red, green, blue.
    numbers: [u32; 9],
    alpha: AlphaKey,
    is_double_sided: bool,
    textures: Vec<TextureKey>,
}

/// The alpha modes that CGA has. The cutoff is stored as bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum AlphaKey {
    Opaque,
    Blend,
    Mask(u32),
}

/// A map of a material: the layer, the name of the image and the channel of coordinates.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct TextureKey {
    map: TextureMap,
    image: String,
    channel: u8,
}

/// The maps that Bevy shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum TextureMap {
    Color,
    Normal,
    /// Roughness in the green and metal in the blue channel.
    MetallicRoughness,
    Emissive,
    Occlusion,
}

pub(crate) fn build(app: &mut App, image_folder: &str) {
    app.insert_resource(MaterialCache { image_folder: image_folder.into(), ..MaterialCache::default() });
    // Children inherit the visibility of their parents.
    app.register_required_components::<Cga, Visibility>();
    app.register_required_components::<CgaRoot, Visibility>();
    app.add_systems(PostUpdate, add_mip_levels.before(AssetEventSystems));
}

/// Adds smaller levels to images that have been loaded, in the frame before the renderer takes them.
fn add_mip_levels(
    mut cache: ResMut<MaterialCache>,
    server: Option<Res<AssetServer>>,
    images: Option<ResMut<Assets<Image>>>,
) {
    let (Some(server), Some(mut images)) = (server, images) else { return };
    cache.loading.retain(|&id| {
        let Some(mut image) = images.get_mut(id) else {
            // Not an image that could not be loaded, or that no mesh uses any more.
            return server.get_load_state(id).is_some_and(|state| state.is_loading());
        };
        mip_levels::add(&mut image);
        false
    });
}

/// The material of a mesh. `None` without Bevy's plugin for materials.
pub(crate) fn material(world: &mut World, part: &CgaMesh) -> Option<MeshMaterial3d<StandardMaterial>> {
    if !world.contains_resource::<Assets<StandardMaterial>>() {
        return None;
    }
    let key = MaterialKey::of(part);
    let cache = world.get_resource::<MaterialCache>()?;
    if let Some(known) = cache.known.get(&key).and_then(Weak::upgrade) {
        return Some(MeshMaterial3d(Handle::Strong(known)));
    }
    let server = world.get_resource::<AssetServer>().filter(|_| world.contains_resource::<Assets<Image>>()).cloned();
    let made = key.material(server.as_ref(), &cache.image_folder);
    let images = [
        &made.base_color_texture,
        &made.normal_map_texture,
        &made.metallic_roughness_texture,
        &made.emissive_texture,
        &made.occlusion_texture,
    ];
    let loading: Vec<AssetId<Image>> = images.into_iter().flatten().map(Handle::id).collect();
    world.resource_mut::<MaterialCache>().loading.extend(loading);
    let handle = world.resource_mut::<Assets<StandardMaterial>>().add(made);
    if let Handle::Strong(strong) = &handle {
        world.resource_mut::<MaterialCache>().keep(key, strong);
    }
    Some(MeshMaterial3d(handle))
}

impl MaterialCache {
    fn keep(&mut self, key: MaterialKey, strong: &Arc<StrongHandle>) {
        const FEW: usize = 64;
        if self.full <= self.known.len() {
            self.known.retain(|_, known| 0 < known.strong_count());
            self.full = (2 * self.known.len()).max(FEW);
        }
        self.known.insert(key, Arc::downgrade(strong));
    }
}

impl MaterialKey {
    fn of(part: &CgaMesh) -> Self {
        let material = &*part.material;
        let color = material.color();
        let share = |value: Option<f64>, unset: f64| value.filter(|value| !value.is_nan()).unwrap_or(unset);
        let light = |channel| share(material.number(MaterialNumber::Emissive(channel)), 0.0);
        let opacity = share(material.opacity, 1.0);
        let numbers = [
            color.r,
            color.g,
            color.b,
            opacity,
            share(material.metallic, 0.0),
            share(material.roughness, 1.0),
            light(Channel::R),
            light(Channel::G),
            light(Channel::B),
        ]
        // Adding 0 removes the sign of −0, which would make another material.
        .map(|value| (value.clamp(0.0, 1.0) as f32 + 0.0).to_bits());
        let alpha = match material.text(MaterialText::OpacityMode).map(|mode| mode.as_str()) {
            Some("opaque") => AlphaKey::Opaque,
            Some("mask") => AlphaKey::Mask((share(material.number(MaterialNumber::Cutoff), 0.5) as f32).to_bits()),
            _ if opacity < 1.0 || has_opacity_map(material) => AlphaKey::Blend,
            _ => AlphaKey::Opaque,
        };
        let is_double_sided = material.double_sided.unwrap_or(true);
        MaterialKey { numbers, alpha, is_double_sided, textures: textures(part) }
    }

    fn material(&self, server: Option<&AssetServer>, folder: &std::path::Path) -> StandardMaterial {
        let [r, g, b, opacity, metallic, roughness, light @ ..] = self.numbers.map(f32::from_bits);
        // CGA's numbers are sRGB, for emitted light too.
        let emitted = LinearRgba::from(Color::srgb(light[0], light[1], light[2]));
        let mut made = StandardMaterial {
            base_color: Color::srgba(r, g, b, opacity),
            metallic,
            perceptual_roughness: roughness,
            emissive: emitted,
            alpha_mode: match self.alpha {
                AlphaKey::Opaque => AlphaMode::Opaque,
                AlphaKey::Blend => AlphaMode::Blend,
                AlphaKey::Mask(bits) => AlphaMode::Mask(f32::from_bits(bits)),
            },
            double_sided: self.is_double_sided,
            ..StandardMaterial::default()
        };
        if self.is_double_sided {
            made.cull_mode = None;
        }
        let Some(server) = server else { return made };
        for texture in &self.textures {
            let channel = if texture.channel == 0 { UvChannel::Uv0 } else { UvChannel::Uv1 };
            let Some(image) = load(server, folder, texture) else { continue };
            let (slot, channel_slot) = match texture.map {
                TextureMap::Color => (&mut made.base_color_texture, &mut made.base_color_channel),
                TextureMap::Normal => (&mut made.normal_map_texture, &mut made.normal_map_channel),
                TextureMap::MetallicRoughness => {
                    (&mut made.metallic_roughness_texture, &mut made.metallic_roughness_channel)
                }
                TextureMap::Emissive => (&mut made.emissive_texture, &mut made.emissive_channel),
                TextureMap::Occlusion => (&mut made.occlusion_texture, &mut made.occlusion_channel),
            };
            (*slot, *channel_slot) = (Some(image), channel);
        }
        made
    }
}

/// Returns true if the opacity comes from the alpha channel of the colour map. Bevy has no opacity map of its own.
fn has_opacity_map(material: &Material) -> bool {
    image(material, Layer::Opacity).is_some_and(|opacity| image(material, Layer::Color) == Some(opacity))
}

/// The maps of a material. Roughness and metal must be one image, or only one of them may have an image: a roughness map
/// on a material without metal, or a metal map whose green channel is the roughness, as in glTF.
fn textures(part: &CgaMesh) -> Vec<TextureKey> {
    let material = &*part.material;
    let shown = |map, layer| {
        let channel = part.channel(layer)?;
        Some(TextureKey { map, image: image(material, layer)?.to_owned(), channel })
    };
    let rough = shown(TextureMap::MetallicRoughness, Layer::Roughness);
    let metal = shown(TextureMap::MetallicRoughness, Layer::Metallic);
    [
        shown(TextureMap::Color, Layer::Color),
        shown(TextureMap::Normal, Layer::Normal),
        rough.or(metal),
        shown(TextureMap::Emissive, Layer::Emissive),
        shown(TextureMap::Occlusion, Layer::Occlusion),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Loads the image of a map, which repeats. Images inside a mesh file and built-in ones are left out.
fn load(server: &AssetServer, folder: &std::path::Path, texture: &TextureKey) -> Option<Handle<Image>> {
    let name = texture.image.replace('\\', "/");
    if name.starts_with("builtin:") || name.contains('#') {
        tracing::warn!("the image `{name}` is left out: it is not a file");
        return None;
    }
    let is_srgb = matches!(texture.map, TextureMap::Color | TextureMap::Emissive);
    let repeats = move |settings: &mut ImageLoaderSettings| {
        settings.is_srgb = is_srgb;
        settings.sampler = ImageSampler::Descriptor(ImageSamplerDescriptor {
            address_mode_u: ImageAddressMode::Repeat,
            address_mode_v: ImageAddressMode::Repeat,
            // Walls along the direction of view stay sharp.
            anisotropy_clamp: 8,
            ..ImageSamplerDescriptor::linear()
        });
    };
    let path = AssetPath::from_path_buf(folder.join(name.trim_start_matches('/')));
    Some(server.load_builder().with_settings(repeats).load(path))
}
