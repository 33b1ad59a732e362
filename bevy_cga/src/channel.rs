//! Texture coordinates for Bevy, which has two channels and v downwards. CGA has ten sets and v upwards.

use cga::glam::{DAffine2, DVec2};
use cga::sink::meshes::TriangleMesh;
use cga::{Layer, LayerPart, Material, MaterialNumber, MaterialText};

/// The layers that a renderer of physically based materials shows. The first ones get their channel first.
const SHOWN: [Layer; 6] =
    [Layer::Color, Layer::Normal, Layer::Roughness, Layer::Metallic, Layer::Emissive, Layer::Occlusion];

/// The coordinates of a mesh in up to two channels, and the channel of each layer.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Channels {
    pub(crate) coordinates: Vec<Vec<[f32; 2]>>,
    pub(crate) of_layer: [Option<u8>; 10],
}

/// The image of a layer, if it has one.
pub(crate) fn image(material: &Material, layer: Layer) -> Option<&str> {
    material.text(MaterialText::Map(layer)).map(|name| name.as_str()).filter(|name| !name.is_empty())
}

impl Channels {
    /// The channels of a mesh. The placement of an image on its layer is part of the coordinates, so layers share a
    /// channel if they have the same set and the same placement. Without images, the first channel is set 0.
    pub(crate) fn of(mesh: &TriangleMesh) -> Self {
        const CHANNELS: usize = 2;
        let mut sources: Vec<(usize, DAffine2)> = Vec::new();
        let mut of_layer = [None; 10];
        for layer in SHOWN {
            if image(&mesh.material, layer).is_none() {
                continue;
            }
            let Some(set) = mesh.set_of(layer) else { continue };
            let source = (set, placement(&mesh.material, layer));
            let channel = sources.iter().position(|known| *known == source).unwrap_or_else(|| {
                sources.push(source);
                sources.len() - 1
            });
            of_layer[layer.uv_set()] = (channel < CHANNELS).then_some(channel as u8);
        }
        if sources.is_empty() && !mesh.uvs[0].is_empty() {
            sources.push((0, DAffine2::IDENTITY));
        }
        let coordinates = sources.into_iter().take(CHANNELS).map(|(set, map)| downwards(&mesh.uvs[set], &map));
        Channels { coordinates: coordinates.collect(), of_layer }
    }
}

/// The coordinates of a set in the image, v downwards.
fn downwards(set: &[[f32; 2]], map: &DAffine2) -> Vec<[f32; 2]> {
    let placed = |&[u, v]: &[f32; 2]| {
        let at = map.transform_point2(DVec2::new(u.into(), v.into()));
        [at.x as f32, (1.0 - at.y) as f32]
    };
    set.iter().map(placed).collect()
}

/// The placement of an image on its layer: scaled, then turned, then moved.
fn placement(material: &Material, layer: Layer) -> DAffine2 {
    let number = |part| {
        let which = MaterialNumber::Map(layer, part);
        // Beyond this, 32-bit floats would not be finite.
        material.number(which).filter(|number| number.abs() <= 1e30).unwrap_or(which.default_value())
    };
    let scale = DVec2::new(number(LayerPart::Su), number(LayerPart::Sv));
    let offset = DVec2::new(number(LayerPart::Tu), number(LayerPart::Tv));
    DAffine2::from_scale_angle_translation(scale, (number(LayerPart::Rw) % 360.0).to_radians(), offset)
}
