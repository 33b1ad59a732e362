//! The survey of a GLB file: of the bytes that a viewer reads, not of the model that they were written from.

mod file;
mod parts;
mod stretch;

use cga::glam::{DAffine3, DMat4, DQuat, DVec2, DVec3};
use cga::mesh::Bounds;
use serde_json::Value as Json;

use self::file::numbers;
pub use self::file::{GlbFile, number};
use self::parts::parts;
use self::stretch::is_stretched;
use crate::survey::{Part, Survey, Triangle};

/// A primitive of a file, with its places in the world.
struct Primitive {
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// The rule and the building of each vertex.
    owners: Vec<[u32; 2]>,
    /// The texture coordinates of each set that a map of the material uses.
    uvs: Vec<Vec<DVec2>>,
    material: u32,
}

/// The contents of a GLB file.
pub struct GlbSurvey {
    /// The parts are the closed parts of the file, and all other triangles of a rule, of a building and a material. A trail is the name of
    /// the rule alone.
    pub survey: Survey,
    /// The triangles whose normals at corners look to their backs.
    pub turned_normals: Vec<u32>,
    /// The triangles that stretch a map of their material in one direction: streaks, or one colour.
    pub stretched_textures: Vec<u32>,
    /// The number of materials that show an image.
    pub textured_materials: usize,
    /// The number of images in the file.
    pub embedded_images: usize,
}

impl GlbSurvey {
    /// Reads a file.
    ///
    /// # Panics
    /// Panics if the file is not a GLB file as `cga` writes it.
    pub fn of(bytes: &[u8]) -> Self {
        let file = GlbFile::new(bytes);
        let mut survey = Survey { parts: Vec::new(), triangles: Vec::new(), bounds: Bounds::EMPTY };
        let rules = rules(&file);
        let materials = file.json["materials"].as_array().map_or(&[][..], Vec::as_slice);
        let is_clear = |material: &Json| {
            let [.., opacity] = numbers(&material["pbrMetallicRoughness"]["baseColorFactor"], [1.0; 4]);
            material["alphaMode"] == "BLEND" && opacity < 1.0
        };
        let clear: Vec<bool> = materials.iter().map(is_clear).collect();
        let (mut turned_normals, mut stretched_textures) = (Vec::new(), Vec::new());
        for primitive in primitives(&file) {
            for part in parts(&primitive) {
                let rule = rules.get(part.owner[0] as usize).cloned().unwrap_or_default();
                let own = survey.parts.len() as u32;
                let mut bounds = Bounds::EMPTY;
                for [a, b, c] in part.triangles.iter().map(|triangle| triangle.map(|corner| corner as usize)) {
                    let corners = [a, b, c].map(|corner| primitive.positions[corner]);
                    for corner in corners {
                        bounds = bounds.union(Bounds { low: corner, high: corner });
                    }
                    let Some(normal) = (corners[1] - corners[0]).cross(corners[2] - corners[0]).try_normalize() else {
                        continue;
                    };
                    let number = survey.triangles.len() as u32;
                    if [a, b, c].iter().any(|corner| primitive.normals[*corner].dot(normal) < 0.0) {
                        turned_normals.push(number);
                    }
                    let is_streak = |uvs: &Vec<DVec2>| is_stretched(corners, [a, b, c].map(|corner| uvs[corner]));
                    if primitive.uvs.iter().any(is_streak) {
                        stretched_textures.push(number);
                    }
                    survey.triangles.push(Triangle { corners, normal, part: own });
                }
                survey.bounds = survey.bounds.union(bounds);
                survey.parts.push(Part {
                    trail: rule.clone(),
                    rule,
                    building: part.owner[1],
                    closed: part.is_closed,
                    clear: clear.get(primitive.material as usize).copied().unwrap_or(false),
                    material: primitive.material,
                    volume: if part.is_closed { part.volume } else { 0.0 },
                    middle: (bounds.low + bounds.high) * 0.5,
                });
            }
        }
        let textured_materials = materials.iter().filter(|material| !sets(material).is_empty()).count();
        let embedded_images = images(&file);
        GlbSurvey { survey, turned_normals, stretched_textures, textured_materials, embedded_images }
    }
}

/// The number of images in the file. All textures have an image, and each image has the bytes of its type, or an address.
fn images(file: &GlbFile) -> usize {
    let [images, textures] =
        ["images", "textures"].map(|name| file.json[name].as_array().map_or(&[][..], Vec::as_slice));
    assert!(textures.iter().all(|texture| texture["source"].as_u64().is_some_and(|at| (at as usize) < images.len())));
    let is_embedded = |image: &&Json| {
        if image["bufferView"].is_null() {
            assert!(image["uri"].is_string(), "{image}");
            return false;
        }
        let begin = if image["mimeType"] == "image/png" { &b"\x89PNG\r\n\x1a\n"[..] } else { b"\xff\xd8\xff" };
        assert!(file.view(&image["bufferView"]).starts_with(begin), "{image}");
        true
    };
    images.iter().filter(is_embedded).count()
}

/// The names of the rules, by number.
fn rules(file: &GlbFile) -> Vec<String> {
    let tables = file.json["extensions"]["EXT_structural_metadata"]["propertyTables"].as_array();
    let table = tables.and_then(|tables| tables.iter().find(|table| table["class"] == "rule"));
    table.map_or(Vec::new(), |table| file.texts(&table["properties"]["name"], number(&table["count"])))
}

/// The sets of texture coordinates that the maps of a material use.
fn sets(material: &Json) -> Vec<usize> {
    let pbr = &material["pbrMetallicRoughness"];
    let maps = [
        &pbr["baseColorTexture"],
        &pbr["metallicRoughnessTexture"],
        &material["normalTexture"],
        &material["occlusionTexture"],
        &material["emissiveTexture"],
    ];
    let set = |map: &Json| {
        let moved = &map["extensions"]["KHR_texture_transform"]["texCoord"];
        number(if moved.is_null() { &map["texCoord"] } else { moved })
    };
    let mut sets: Vec<usize> = maps.into_iter().filter(|map| !map.is_null()).map(set).collect();
    sets.sort_unstable();
    sets.dedup();
    sets
}

/// All primitives of the scene, in the world, at each of their places.
fn primitives(file: &GlbFile) -> Vec<Primitive> {
    let scene = &file.json["scenes"][number(&file.json["scene"])];
    let mut waiting: Vec<(usize, DAffine3)> =
        scene["nodes"].as_array().into_iter().flatten().map(|node| (number(node), DAffine3::IDENTITY)).collect();
    let mut list = Vec::new();
    while let Some((node, place)) = waiting.pop() {
        let node = &file.json["nodes"][node];
        let place = place * placement(node);
        waiting.extend(node["children"].as_array().into_iter().flatten().map(|child| (number(child), place)));
        if node["mesh"].is_null() {
            continue;
        }
        let mesh = &file.json["meshes"][number(&node["mesh"])];
        let building = number(&node["extras"]["building"]) as u32;
        for instance in instances(file, node) {
            let own = mesh["primitives"].as_array().into_iter().flatten();
            list.extend(own.map(|primitive| read(file, primitive, &(place * instance), building)));
        }
    }
    list
}

/// The place of a node in its parent.
fn placement(node: &Json) -> DAffine3 {
    if !node["matrix"].is_null() {
        return DAffine3::from_mat4(DMat4::from_cols_array(&numbers(&node["matrix"], [0.0; 16])));
    }
    let rotation = DQuat::from_array(numbers(&node["rotation"], [0.0, 0.0, 0.0, 1.0]));
    let (scale, translation) = (numbers(&node["scale"], [1.0; 3]), numbers(&node["translation"], [0.0; 3]));
    DAffine3::from_scale_rotation_translation(DVec3::from(scale), rotation, DVec3::from(translation))
}

/// The places of a node's mesh in the node.
fn instances(file: &GlbFile, node: &Json) -> Vec<DAffine3> {
    let attributes = &node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    if attributes.is_null() {
        return vec![DAffine3::IDENTITY];
    }
    let (places, turns) = (file.rows::<3>(&attributes["TRANSLATION"]), file.rows::<4>(&attributes["ROTATION"]));
    let place = |(place, turn): (&[f64; 3], &[f64; 4])| {
        DAffine3::from_rotation_translation(DQuat::from_array(*turn), DVec3::from(*place))
    };
    places.iter().zip(&turns).map(place).collect()
}

/// A primitive at a place. `building` is the building of the node.
fn read(file: &GlbFile, primitive: &Json, place: &DAffine3, building: u32) -> Primitive {
    assert!(primitive["mode"].is_null() || primitive["mode"] == 4, "all primitives are triangles");
    let attributes = &primitive["attributes"];
    let positions: Vec<DVec3> =
        file.rows::<3>(&attributes["POSITION"]).iter().map(|at| place.transform_point3(DVec3::from(*at))).collect();
    let turn = place.matrix3.inverse().transpose();
    let normals: Vec<DVec3> = file.rows::<3>(&attributes["NORMAL"]).iter().map(|at| turn * DVec3::from(*at)).collect();
    let corners: Vec<u32> = file.rows::<1>(&primitive["indices"]).iter().map(|[index]| *index as u32).collect();
    let tables = &file.json["extensions"]["EXT_structural_metadata"]["propertyTables"];
    let ids = primitive["extensions"]["EXT_mesh_features"]["featureIds"].as_array();
    let mut owners = vec![[0, building]; positions.len()];
    for id in ids.into_iter().flatten() {
        let class = &tables[number(&id["propertyTable"])]["class"];
        let values = file.rows::<1>(&attributes[&format!("_FEATURE_ID_{}", number(&id["attribute"]))]);
        let own = usize::from(class == "building");
        owners.iter_mut().zip(&values).for_each(|(owner, [value])| owner[own] = *value as u32);
    }
    let material = &file.json["materials"][number(&primitive["material"])];
    let set = |set: usize| {
        let name = format!("TEXCOORD_{set}");
        assert!(!attributes[&name].is_null(), "a map uses {name}, which its primitive does not have");
        file.rows::<2>(&attributes[&name]).into_iter().map(DVec2::from).collect()
    };
    let uvs = sets(material).into_iter().map(set).collect();
    let (triangles, rest) = corners.as_chunks::<3>();
    assert!(rest.is_empty() && normals.len() == positions.len(), "whole triangles, and a normal at each vertex");
    let material = number(&primitive["material"]) as u32;
    Primitive { positions, normals, triangles: triangles.to_vec(), owners, uvs, material }
}
