//! Combines streams and description into one file.

use std::fmt::Write as _;
use std::io;

use glam::{DQuat, DVec3, Vec3, Vec4};

use super::binary::BinaryChunk;
use super::container::Container;
use super::images::Images;
use super::json::{joined, quoted};
use super::primitive::Primitive;
use super::scene::{MeshInstance, MeshPlacement, SceneMesh};
use super::textures::LookTexture;
use super::words::Words;
use super::{Glb, check_size};
use crate::output::buffers::Vertex;
use crate::output::error::WriteError;
use crate::output::number::list;
use crate::shape::scope::Scope;
use crate::value::each::Each;

/// The component types of the format.
const U32: u32 = 5125;
const F32: u32 = 5126;

/// The items of a stream: their type, the type of their components, and their bytes.
struct VertexLayout {
    kind: &'static str,
    component: u32,
    bytes: usize,
}

const INDEX: VertexLayout = VertexLayout { kind: "SCALAR", component: U32, bytes: 4 };
const RULE: VertexLayout = VertexLayout { kind: "SCALAR", component: F32, bytes: 4 };
const UV: VertexLayout = VertexLayout { kind: "VEC2", component: F32, bytes: 8 };
const POINT: VertexLayout = VertexLayout { kind: "VEC3", component: F32, bytes: 12 };
const TANGENT: VertexLayout = VertexLayout { kind: "VEC4", component: F32, bytes: 16 };

/// The accessors of one primitive.
struct Accessors {
    indices: usize,
    position: usize,
    normal: usize,
    /// The numbers of rules, unless the rules have nodes of their own.
    rule: Option<usize>,
    /// The first of its accessors of texture coordinates, one for each set.
    uv: usize,
    tangent: Option<usize>,
}

pub(super) fn pack<'a>(glb: &'a Glb, meshes: &'a [SceneMesh]) -> Result<Container<'a>, WriteError> {
    let flat: Vec<&Primitive> = meshes.iter().flat_map(|mesh| &mesh.primitives).collect();
    let mut binary = BinaryChunk::default();
    let images = Images::of(glb.looks.textures(), glb.files.as_deref(), glb.references_images);
    let mut accessors = binary.primitives(&flat, !glb.is_by_rule)?;
    for (primitive, accessors) in flat.iter().copied().zip(&mut accessors) {
        accessors.tangent = glb.looks.normal_space(primitive.look, &images).map(|space| {
            binary.stream(
                &TANGENT,
                &[primitive],
                |p: &Primitive| p.vertices().len(),
                &[],
                move |p, to| p.write_tangents(&space, to),
            )
        });
    }
    let places = binary.places(meshes);

    let mut json = String::from("{\"asset\":{\"generator\":\"cga\",\"version\":\"2.0\"},");
    if flat.is_empty() {
        let has_nodes = glb.placements.as_ref().is_some_and(|placements| !placements.is_empty());
        let scene = if has_nodes { "{\"nodes\":[0]}" } else { "{}" };
        let _ = write!(json, "\"scene\":0,\"scenes\":[{scene}]");
        if has_nodes {
            let _ = write!(json, ",{}", nodes(glb, &[], &[]));
        }
        json.push('}');
        check_size(json.len() as u64)?;
        return Container::new(json, BinaryChunk::default());
    }
    let rules = glb.numbers.table.rules();
    let table = Some(rules).filter(|_| !glb.is_by_rule);
    let has_transforms = glb.looks.textures().any(LookTexture::is_transformed);
    write_extensions(&mut json, table.is_some(), has_transforms, !places.is_empty());
    if let Some(rules) = table {
        write_rules(&mut json, &mut binary, rules);
    }
    json.push_str("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],");
    let _ = write!(json, "{},", nodes(glb, meshes, &places));
    let mut next = accessors.into_iter();
    let mesh = |mesh: &SceneMesh| {
        let list = mesh.primitives.iter().zip(&mut next).map(|(p, a)| primitive(p, &a, rules.len()));
        format!("{{\"name\":{},\"primitives\":[{}]}}", quoted(name(glb, mesh)), joined(list))
    };
    let _ = write!(json, "\"meshes\":[{}],", joined(meshes.iter().map(mesh)));
    glb.looks.write(&mut json, &images);
    images.write(&mut json, &mut binary);
    check_size(binary.length as u64)?;
    let _ = write!(json, "\"accessors\":[{}],", binary.accessors.join(","));
    let _ = write!(json, "\"bufferViews\":[{}],", binary.views.join(","));
    // The chunk is padded, and readers complain if the buffer is shorter than the chunk.
    binary.align();
    let _ = write!(json, "\"buffers\":[{{\"byteLength\":{}}}]}}", binary.length);
    Container::new(json, binary)
}

/// The name of a mesh and of its node: the name of its rule, or of the file if it has several rules.
fn name<'a>(glb: &'a Glb, mesh: &SceneMesh) -> &'a str {
    let of_file = glb.name.as_deref().unwrap_or("model");
    match (&mesh.places, mesh.rule()) {
        (MeshPlacement::Root, _) | (_, None) => of_file,
        (_, Some(rule)) => glb.numbers.table.rules()[rule as usize],
    }
}

/// Writes the names of the used extensions.
fn write_extensions(json: &mut String, has_rules: bool, has_transforms: bool, has_instances: bool) {
    let used = [
        (has_rules, "EXT_mesh_features"),
        (has_rules, "EXT_structural_metadata"),
        (has_transforms, "KHR_texture_transform"),
        (has_instances, INSTANCING),
    ];
    let used = joined(used.into_iter().filter(|(is_used, _)| *is_used).map(|(_, name)| quoted(name)));
    if !used.is_empty() {
        let _ = write!(json, "\"extensionsUsed\":[{used}],");
    }
    if has_instances {
        // A reader without the extension would show each part once, at a wrong place.
        let _ = write!(json, "\"extensionsRequired\":[{}],", quoted(INSTANCING));
    }
}

/// The extension for lists of places.
const INSTANCING: &str = "EXT_mesh_gpu_instancing";

/// Writes the rule names: a string table with one row for each rule.
fn write_rules(json: &mut String, binary: &mut BinaryChunk<'_>, rules: &[&str]) {
    let mut offsets = vec![0u32];
    let mut names = Vec::new();
    for rule in rules {
        names.extend_from_slice(rule.as_bytes());
        offsets.push(names.len() as u32);
    }
    let values = binary.view(names.len(), "", move |to| to.bytes(&names, 0));
    let offsets = binary.view(4 * offsets.len(), "", move |to| to.each(&offsets, |offset| [offset.to_le_bytes()]));
    json.push_str("\"extensions\":{\"EXT_structural_metadata\":{\"schema\":{\"id\":\"cga\",\"classes\":{");
    json.push_str("\"rule\":{\"properties\":{\"name\":{\"type\":\"STRING\",\"required\":true}}}}},");
    let _ = write!(json, "\"propertyTables\":[{{\"class\":\"rule\",\"count\":{},\"properties\":{{", rules.len());
    let _ = write!(json, "\"name\":{{\"values\":{values},\"stringOffsets\":{offsets}}}}}}}]}}}},");
}

/// The nodes. The first node contains all others, so that one translation moves everything.
fn nodes(glb: &Glb, meshes: &[SceneMesh], places: &[[usize; 2]]) -> String {
    let moved = match glb.origin {
        DVec3::ZERO => String::new(),
        origin => format!(",\"translation\":[{}]", list(&origin.to_array())),
    };
    let mut main = "";
    let mut children = Vec::new();
    let mut places = places.iter();
    for (number, mesh) in meshes.iter().enumerate() {
        let name = quoted(name(glb, mesh));
        match &mesh.places {
            // It is the first mesh.
            MeshPlacement::Root => main = ",\"mesh\":0",
            MeshPlacement::Child => children.push(format!("{{\"name\":{name},\"mesh\":{number}}}")),
            MeshPlacement::Nodes(nodes) => children.extend(nodes.iter().map(|place| {
                let [x, y, z] = [place.matrix3.x_axis, place.matrix3.y_axis, place.matrix3.z_axis];
                let translation = (place.translation - glb.origin).extend(1.0);
                let columns = [x.extend(0.0), y.extend(0.0), z.extend(0.0), translation];
                let matrix = list(columns.each(|column| column.to_array()).as_flattened());
                format!("{{\"name\":{name},\"mesh\":{number},\"matrix\":[{matrix}]}}")
            })),
            MeshPlacement::Instances(_) => children.extend(places.next().map(|[translation, rotation]| {
                format!(
                    "{{\"name\":{name},\"mesh\":{number},\"extensions\":{{\"{INSTANCING}\":{{\"attributes\":\
                     {{\"TRANSLATION\":{translation},\"ROTATION\":{rotation}}}}}}}}}"
                )
            })),
        }
    }
    let placements = glb.placements.iter().flatten();
    children.extend(placements.map(|(rule, scope)| placement(glb, *rule, scope)));
    let ids = match children.len() {
        0 => String::new(),
        count => format!(",\"children\":[{}]", joined((1..=count).map(|i| i.to_string()))),
    };
    let extras = joined(glb.extras.iter().map(|(name, value)| format!("{}:{value}", quoted(name))));
    let extras = if extras.is_empty() { extras } else { format!(",\"extras\":{{{extras}}}") };
    let name = quoted(glb.name.as_deref().unwrap_or("model"));
    let root = format!("{{\"name\":{name}{main}{moved}{ids}{extras}}}");
    format!("\"nodes\":[{}]", joined(std::iter::once(root).chain(children)))
}

/// The node of a leaf without faces.
fn placement(glb: &Glb, rule: u32, scope: &Scope) -> String {
    let name = quoted(glb.numbers.table.rules()[rule as usize]);
    let translation = list(&(scope.origin - glb.origin).to_array());
    let rotation = list(&DQuat::from_mat3(&scope.axes).normalize().to_array());
    let size = list(&scope.size.to_array());
    format!(
        "{{\"name\":{name},\"translation\":[{translation}],\"rotation\":[{rotation}],\"extras\":{{\"size\":[{size}]}}}}"
    )
}

fn primitive(primitive: &Primitive, at: &Accessors, rules: usize) -> String {
    let tangent = at.tangent.map_or(String::new(), |tangent| format!(",\"TANGENT\":{tangent}"));
    let uvs: String = (0..primitive.uvs.len()).map(|set| format!(",\"TEXCOORD_{set}\":{}", at.uv + set)).collect();
    let rule = at.rule.map_or(String::new(), |rule| format!(",\"_FEATURE_ID_0\":{rule}"));
    let features = at.rule.map_or(String::new(), |_| {
        format!(
            ",\"extensions\":{{\"EXT_mesh_features\":{{\"featureIds\":[{{\"featureCount\":{rules},\"attribute\":0,\
             \"propertyTable\":0}}]}}}}"
        )
    });
    format!(
        "{{\"attributes\":{{\"POSITION\":{},\"NORMAL\":{}{rule}{uvs}{tangent}}},\"indices\":{},\"material\":{}{features}}}",
        at.position, at.normal, at.indices, primitive.look
    )
}

impl<'a> BinaryChunk<'a> {
    /// Adds one view for each stream of all primitives together, and accessors for each primitive.
    fn primitives(&mut self, primitives: &[&'a Primitive], has_rules: bool) -> Result<Vec<Accessors>, WriteError> {
        if primitives.is_empty() {
            return Ok(Vec::new());
        }
        let ranges = primitives.iter().map(|p| extremes(p.vertices())).collect::<Result<Vec<_>, _>>()?;
        let lists: Vec<&Vec<[f32; 2]>> = primitives.iter().flat_map(|p| &p.uvs).collect();
        if !lists.iter().all(|list| list.as_flattened().iter().all(|number| number.is_finite())) {
            return Err(WriteError::NotFinite);
        }
        let indices = self.stream(&INDEX, primitives, |p| p.indices().len(), &[], Primitive::write_indices);
        let vertices = |p: &Primitive| p.vertices().len();
        let position = self.stream(&POINT, primitives, vertices, &ranges, Primitive::write_positions);
        let normal = self.stream(&POINT, primitives, vertices, &[], Primitive::write_normals);
        let rule = has_rules.then(|| self.stream(&RULE, primitives, vertices, &[], Primitive::write_rules));
        let mut uv = self.accessors.len();
        if !lists.is_empty() {
            uv = self.stream(&UV, &lists, |list| list.len(), &[], |list, to| to.floats(list.as_flattened()));
        }
        let accessors = primitives.iter().enumerate().map(|(i, primitive)| {
            let (indices, position, normal) = (indices + i, position + i, normal + i);
            let rule = rule.map(|rule| rule + i);
            let own = Accessors { indices, position, normal, rule, uv, tangent: None };
            uv += primitive.uvs.len();
            own
        });
        Ok(accessors.collect())
    }

    /// Adds a view with the output of `write` for each part, and an accessor for each. `more` are further members of
    /// the accessors. Returns the number of the first accessor.
    fn stream<T: 'a>(
        &mut self,
        layout: &VertexLayout,
        parts: &[&'a T],
        count: impl Fn(&T) -> usize,
        more: &[String],
        write: impl Fn(&T, &mut Words<'_>) -> io::Result<()> + 'a,
    ) -> usize {
        let VertexLayout { kind, component, bytes } = *layout;
        let usage = match component {
            U32 => ",\"target\":34963".to_owned(),
            _ => format!(",\"byteStride\":{bytes},\"target\":34962"),
        };
        let (total, all) = (parts.iter().map(|part| count(part)).sum::<usize>(), parts.to_vec());
        let view = self.view(bytes * total, &usage, move |to| all.iter().try_for_each(|part| write(part, to)));
        let (first, mut offset) = (self.accessors.len(), 0);
        for (i, part) in parts.iter().enumerate() {
            let more = more.get(i).map_or("", String::as_str);
            self.accessor(view, offset, component, count(part), kind, more);
            offset += bytes * count(part);
        }
        first
    }

    /// The accessors of the translations and the rotations of instances, for each mesh with instances.
    fn places(&mut self, meshes: &'a [SceneMesh]) -> Vec<[usize; 2]> {
        let lists = meshes.iter().filter_map(|mesh| match &mesh.places {
            MeshPlacement::Instances(places) => Some(&places[..]),
            MeshPlacement::Root | MeshPlacement::Child | MeshPlacement::Nodes(_) => None,
        });
        let lists: Vec<&[MeshInstance]> = lists.collect();
        let count = lists.iter().map(|list| list.len()).sum::<usize>();
        if count == 0 {
            return Vec::new();
        }
        let all = lists.clone();
        let translations = self.view(12 * count, "", move |to| {
            all.iter().try_for_each(|list| to.each(list, |place| place.translation.each(f32::to_le_bytes)))
        });
        let all = lists.clone();
        let rotations = self.view(16 * count, "", move |to| {
            all.iter().try_for_each(|list| to.each(list, |place| place.rotation.each(f32::to_le_bytes)))
        });
        let mut at = 0;
        let accessors = lists.iter().map(|list| {
            let translation = self.accessor(translations, 12 * at, F32, list.len(), "VEC3", "");
            let rotation = self.accessor(rotations, 16 * at, F32, list.len(), "VEC4", "");
            at += list.len();
            [translation, rotation]
        });
        accessors.collect()
    }
}

/// The members `min` and `max`. All digits of the `f32`s are written, as readers compare.
fn extremes(vertices: &[Vertex]) -> Result<String, WriteError> {
    let (low, high) = bounds(vertices).ok_or(WriteError::NotFinite)?;
    Ok(format!(",\"min\":[{}],\"max\":[{}]", list(&low.as_dvec3().to_array()), list(&high.as_dvec3().to_array())))
}

/// The least and the largest coordinates, if all are finite.
fn bounds(vertices: &[Vertex]) -> Option<(Vec3, Vec3)> {
    let (mut low, mut high) = (Vec4::INFINITY, Vec4::NEG_INFINITY);
    // Coordinates that are not finite make the sum NaN.
    let mut zero = Vec4::ZERO;
    for vertex in vertices {
        // The fourth number belongs to the normal.
        let point = Vec4::from_slice(vertex);
        low = low.min(point);
        high = high.max(point);
        zero += point * 0.0;
    }
    (zero.truncate() == Vec3::ZERO).then(|| (low.truncate(), high.truncate()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_those_of_all_positions_and_finite() {
        let mut vertices: Vec<Vertex> = (0..11).map(|i| [i as f32, -(i as f32), 0.5, 0.0, 0.0, 1.0]).collect();
        assert_eq!(bounds(&vertices), Some((Vec3::new(0.0, -10.0, 0.5), Vec3::new(10.0, 0.0, 0.5))));
        for (at, odd) in [(0, f32::NAN), (10, f32::NAN), (3, f32::INFINITY), (9, f32::NEG_INFINITY)] {
            let kept = std::mem::replace(&mut vertices[at][1], odd);
            assert_eq!(bounds(&vertices), None);
            vertices[at][1] = kept;
        }
        assert_eq!(bounds(&vertices[..2]), Some((Vec3::new(0.0, -1.0, 0.5), Vec3::new(1.0, 0.0, 0.5))));
    }
}
