//! A reader for glTF 2.0: `.gltf` and `.glb` files (*insert operation*).
//!
//! The meshes of the scene become one mesh, each at the places of its nodes. Names of nodes, or else of meshes, become
//! groups. Triangles stay triangles; points at the same place become one, so that a closed body is closed. Materials
//! have the colours, factors and images of the file, with colours converted from linear light to sRGB. Texture
//! coordinates have v upwards, as in CGA: set 0 belongs to the colour image, and another set to the image of
//! its layer, otherwise it is `TEXCOORD_n` of its number. Faces without coordinates in a mesh that has some get (0, 0), and
//! faces without normals their own. Cameras, lights, skins, animations, lines and points are skipped.
//!
//! Numbers are read here and not by a crate: those for glTF index bytes with numbers of the file, and panic where these
//! are wrong. The JSON text is read by `serde_json`.

mod accessor;
mod container;
mod document;
mod error;
mod images;
mod item;
mod material;
mod metadata;
mod primitive;
mod scene;

use std::collections::HashMap;

use glam::{DAffine3, DMat3, DVec2, DVec3};
use serde_json::Value;

use self::document::Document;
use self::images::MaterialImages;
use self::material::{GltfMaterial, MaterialReader};
use self::primitive::{PrimitiveReader, PrimitiveTriangles};
use self::scene::{INSTANCING, NodeMesh};
use super::EmbeddedImage;
use crate::geometry::each::Each;
use crate::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use crate::geometry::obj::{Names, Warnings, short};
use crate::material::{Layer, Material};

pub use self::error::GltfError;
pub(crate) use self::metadata::metadata;

/// A mesh, the images inside the file, and the warnings from reading it.
#[derive(Clone, Debug, PartialEq)]
pub struct GltfFile {
    /// The mesh.
    pub mesh: Mesh,
    /// The embedded images that materials name.
    pub images: Vec<EmbeddedImage>,
    /// One sentence per problem, at most 100. If there are more, the last sentence gives the number of the others.
    pub warnings: Vec<String>,
}

/// The greatest number of triangles of a scene, with all places of its meshes. They take about 250 bytes each.
const MOST_TRIANGLES: usize = 1 << 22;

/// The extensions that a file may require. Extensions of materials and lights change only the look.
const KNOWN: [&str; 9] = [
    "EXT_mesh_features",
    INSTANCING,
    "EXT_structural_metadata",
    "EXT_texture_webp",
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "KHR_texture_basisu",
    "KHR_texture_transform",
    "MSFT_texture_dds",
];

/// Reads a file. `file` returns the bytes of a buffer or image in a file of its own, by its name relative to this file,
/// or `None` if it does not exist.
///
/// # Errors
/// The file is not glTF 2.0, requires an unknown extension, names an item that does not exist, has data that end early
/// or a number that is not finite, or has more than 4,194,304 triangles, 33,554,432
/// vertices or 1,048,576 places of meshes.
///
/// Small files have lower limits, as many primitives may share an accessor and many nodes a mesh. The elements that are read are at most
/// 2,097,152 and 4 for each byte of the buffers: an accessor of an attribute counts once, the indices of a primitive count for each
/// primitive, and a primitive without indices counts all its positions again. So 2,000 primitives without indices may share
/// 1,000 positions in any file. The places of meshes are at most 65,536 and 1 for each byte of the buffers.
///
/// ```
/// # use cga_runtime::facade as cga;
/// use cga::mesh::read_gltf;
///
/// let text = br#"{
///     "asset": {"version": "2.0"},
///     "nodes": [{"mesh": 0, "name": "Sail"}],
///     "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
///     "accessors": [{"bufferView": 0, "componentType": 5121, "count": 3, "type": "VEC3"}],
///     "bufferViews": [{"buffer": 0, "byteLength": 9}],
///     "buffers": [{"uri": "data:application/octet-stream;base64,AAAAAQAAAAEA", "byteLength": 9}]
/// }"#;
/// let mesh = read_gltf(text, &mut |_| None)?.mesh;
/// assert_eq!((mesh.area(), mesh.groups()), (0.5, &["Sail".to_owned()][..]));
/// # Ok::<(), cga_runtime::asset::gltf::GltfError>(())
/// ```
pub fn read_gltf(bytes: &[u8], file: &mut dyn FnMut(&str) -> Option<Vec<u8>>) -> Result<GltfFile, GltfError> {
    let document = Document::new(bytes, file)?;
    check_version(&document.json)?;
    check_extensions(&document.json)?;
    let placed = scene::placed(&document)?;
    let mut reader = PrimitiveReader::new(&document);
    let mut meshes: HashMap<usize, Vec<PrimitiveTriangles>> = HashMap::new();
    let mut triangles: usize = 0;
    for NodeMesh { mesh, places, .. } in &placed {
        if !meshes.contains_key(mesh) {
            meshes.insert(*mesh, reader.primitives(*mesh)?);
        }
        let own: usize = meshes[mesh].iter().map(|primitive| primitive.triangles.len()).sum();
        triangles = triangles.saturating_add(own.saturating_mul(places.len()));
    }
    if MOST_TRIANGLES < triangles {
        return Err(GltfError::TooLarge);
    }
    let mut warnings = Warnings::default();
    if reader.others != 0 {
        warnings.add(|| format!("{} primitives with points or lines were left out", reader.others));
    }
    if triangles == 0 {
        warnings.add(|| "the scene has no triangles".to_owned());
    }
    let mut images = MaterialImages::default();
    let mut reader = MaterialReader { document: &document, images: &mut images, file };
    let mut materials: Vec<GltfMaterial> = Vec::new();
    let mut numbers: HashMap<usize, u32> = HashMap::new();
    let used = placed.iter().flat_map(|placed| &meshes[&placed.mesh]).filter_map(|primitive| primitive.material);
    for material in used {
        if let std::collections::hash_map::Entry::Vacant(number) = numbers.entry(material) {
            number.insert(materials.len() as u32);
            materials.push(reader.read(material)?);
        }
    }
    for image in &images.unknown {
        warnings.add(|| format!("images[{image}] is not a complete PNG or JPEG file"));
    }
    let all = || placed.iter().flat_map(|placed| &meshes[&placed.mesh]);
    let material_of = |primitive: &PrimitiveTriangles| Some(&materials[*numbers.get(&primitive.material?)? as usize]);
    let sets: Vec<usize> = (0..Layer::ALL.len())
        .filter(|&set| all().any(|primitive| is_needed(primitive, material_of(primitive), set)))
        .collect();
    let has_normals = all().any(|primitive| primitive.normals.is_some());
    let mut builder = MeshBuilder::new();
    let mut groups = Names::default();
    for NodeMesh { mesh, name, places } in &placed {
        let group = name.map_or(FaceTag::NONE, |name| groups.number(name));
        for (place, primitive) in places.iter().flat_map(|place| meshes[mesh].iter().map(move |own| (place, own))) {
            let material = primitive.material.map_or(FaceTag::NONE, |material| numbers[&material]);
            let tag = FaceTag { group, material, ..FaceTag::PLAIN };
            let coordinates: Vec<_> =
                sets.iter().map(|&set| (set, coordinates(primitive, material_of(primitive), set))).collect();
            add(&mut builder, primitive, place, tag, &coordinates, has_normals);
        }
    }
    let materials: Vec<Material> = materials.into_iter().map(|read| read.material).collect();
    builder.groups(groups.into_list()).materials(materials);
    let mesh = builder.build().map_err(GltfError::Mesh)?;
    let lost = triangles - mesh.face_count();
    if lost != 0 {
        warnings.add(|| format!("{lost} triangles without three different corners were left out"));
    }
    Ok(GltfFile { mesh, images: images.embedded, warnings: warnings.finish() })
}

/// Adds the triangles of a primitive at a place.
fn add(
    builder: &mut MeshBuilder,
    primitive: &PrimitiveTriangles,
    place: &DAffine3,
    tag: FaceTag,
    coordinates: &[(usize, Option<&Vec<DVec2>>)],
    has_normals: bool,
) {
    let normals_place = normals_place(place);
    let is_mirrored = place.matrix3.determinant() < 0.0;
    let points: Vec<DVec3> = primitive.points.iter().map(|&point| place.transform_point3(point)).collect();
    let numbers: Vec<u32> = points.iter().map(|&point| builder.point(point)).collect();
    for &[a, b, c] in &primitive.triangles {
        let corners = if is_mirrored { [a, c, b] } else { [a, b, c] }.each(|corner| corner as usize);
        builder.face(&corners.each(|corner| numbers[corner]), &[], tag);
        for &(set, values) in coordinates {
            builder.uv_set(set, &corners.each(|corner| values.map_or(DVec2::ZERO, |values| values[corner])));
        }
        if has_normals {
            let [p, q, r] = corners.each(|corner| points[corner]);
            let flat = (q - p).cross(r - p).normalize_or(DVec3::Y);
            builder.normals(&corners.each(|corner| match &primitive.normals {
                Some(normals) => (normals_place * normals[corner]).normalize_or(flat),
                None => flat,
            }));
        }
    }
}

/// The transformation of normals, up to their length. It transforms cross products of edges, with the faces of a mirrored
/// mesh turned over. It exists for every place.
fn normals_place(place: &DAffine3) -> DMat3 {
    let [x, y, z] = [place.matrix3.x_axis, place.matrix3.y_axis, place.matrix3.z_axis];
    let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
    if place.matrix3.determinant() < 0.0 { -cofactors } else { cofactors }
}

/// The number `n` of the coordinates `TEXCOORD_n` that a set has for a primitive.
fn coordinate_number(primitive: &PrimitiveTriangles, material: Option<&GltfMaterial>, set: usize) -> usize {
    let of_layer = |set: usize| material.and_then(|material| material.coordinates[set]);
    let plain = || matches!(primitive.coordinates.get(set), Some(Some(_))).then_some(set);
    of_layer(set).or_else(plain).or_else(|| of_layer(0)).unwrap_or(0)
}

/// The coordinates of a set for a primitive.
fn coordinates<'a>(
    primitive: &'a PrimitiveTriangles,
    material: Option<&GltfMaterial>,
    set: usize,
) -> Option<&'a Vec<DVec2>> {
    primitive.coordinates.get(coordinate_number(primitive, material, set))?.as_ref()
}

/// Returns true if a mesh needs a set for a primitive: set 0 if the primitive has coordinates, another set if it
/// differs from set 0.
fn is_needed(primitive: &PrimitiveTriangles, material: Option<&GltfMaterial>, set: usize) -> bool {
    let differs = set == 0 || coordinate_number(primitive, material, set) != coordinate_number(primitive, material, 0);
    differs && coordinates(primitive, material, set).is_some()
}

fn check_version(json: &Value) -> Result<(), GltfError> {
    let asset = json.get("asset").and_then(Value::as_object);
    let version = |member| asset.and_then(|asset| asset.get(member)).and_then(Value::as_str);
    match version("minVersion").or(version("version")) {
        Some(version) if version == "2" || version.starts_with("2.") => Ok(()),
        Some(_) => Err(GltfError::Container("only version 2 of glTF can be read")),
        None => Err(GltfError::Container("the file is not glTF: its version is missing")),
    }
}

fn check_extensions(json: &Value) -> Result<(), GltfError> {
    let required = json.get("extensionsRequired").and_then(Value::as_array).into_iter().flatten();
    let unknown =
        required.filter_map(Value::as_str).find(|name| !KNOWN.contains(name) && !name.starts_with("KHR_materials_"));
    unknown.map_or(Ok(()), |name| Err(GltfError::Extension(short(name))))
}

#[cfg(test)]
mod tests;
