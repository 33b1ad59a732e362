//! Streams and description into one file.

use std::fmt::Write as _;

use glam::DVec3;

use super::json::joined;
use super::primitive::Primitive;
use super::{Glb, MAX_BYTES, Shared};
use crate::sink::error::WriteError;
use crate::sink::number::list;

/// Component and target numbers of the format.
const U32: u32 = 5125;
const F32: u32 = 5126;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// The binary part under construction: views of bytes, accessors into them.
#[derive(Default)]
struct Binary {
    bytes: Vec<u8>,
    views: Vec<String>,
    accessors: Vec<String>,
}

/// Accessors of one primitive.
#[derive(Clone, Copy, Default)]
struct Accessors {
    indices: usize,
    position: usize,
    normal: usize,
    rule: usize,
    uv: Option<usize>,
}

pub(super) fn pack(glb: &Glb, shared: &[Shared]) -> Result<Vec<u8>, WriteError> {
    let main = Some(&glb.primitives[..]).filter(|primitives| !primitives.is_empty());
    let meshes: Vec<&[Primitive]> = main.into_iter().chain(shared.iter().map(|s| &s.primitives[..])).collect();
    let flat: Vec<&Primitive> = meshes.iter().copied().flatten().collect();
    let mut binary = Binary::default();
    let accessors = binary.primitives(&flat)?;

    let mut json = String::from("{\"asset\":{\"generator\":\"cga\",\"version\":\"2.0\"},");
    if flat.is_empty() {
        json.push_str("\"scene\":0,\"scenes\":[{}]}");
        return container(&json, &[]);
    }
    let rules = glb.table.rules();
    write_rules(&mut json, &mut binary, rules);
    json.push_str("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],");
    write_nodes(&mut json, glb.origin, main.is_some(), shared);
    let mut next = accessors.into_iter();
    let mesh = |primitives: &&[Primitive]| {
        let list = primitives.iter().zip(&mut next).map(|(p, a)| primitive(p, &a, rules.len()));
        format!("{{\"primitives\":[{}]}}", joined(list))
    };
    let _ = write!(json, "\"meshes\":[{}],", joined(meshes.iter().map(mesh)));
    glb.looks.write(&mut json);
    let _ = write!(json, "\"accessors\":[{}],", binary.accessors.join(","));
    let _ = write!(json, "\"bufferViews\":[{}],", binary.views.join(","));
    // The chunk is padded, and readers complain when the buffer is not as long as the chunk.
    binary.bytes.resize(binary.bytes.len().next_multiple_of(8), 0);
    let _ = write!(json, "\"buffers\":[{{\"byteLength\":{}}}]}}", binary.bytes.len());
    container(&json, &binary.bytes)
}

/// Rule names: one string table, one row a rule.
fn write_rules(json: &mut String, binary: &mut Binary, rules: &[&str]) {
    let mut offsets = vec![0u32];
    let mut text = Vec::new();
    for rule in rules {
        text.extend_from_slice(rule.as_bytes());
        offsets.push(text.len() as u32);
    }
    let values = binary.view(text, "");
    let offsets = binary.view(offsets.iter().flat_map(|o| o.to_le_bytes()), "");
    json.push_str("\"extensionsUsed\":[\"EXT_mesh_features\",\"EXT_structural_metadata\"],");
    json.push_str("\"extensions\":{\"EXT_structural_metadata\":{\"schema\":{\"id\":\"cga\",\"classes\":{");
    json.push_str("\"rule\":{\"properties\":{\"name\":{\"type\":\"STRING\",\"required\":true}}}}},");
    let _ = write!(json, "\"propertyTables\":[{{\"class\":\"rule\",\"count\":{},\"properties\":{{", rules.len());
    let _ = write!(json, "\"name\":{{\"values\":{values},\"stringOffsets\":{offsets}}}}}}}]}}}},");
}

/// The first node holds everything, so that one translation moves all.
fn write_nodes(json: &mut String, origin: DVec3, has_main: bool, shared: &[Shared]) {
    let moved = match origin {
        DVec3::ZERO => String::new(),
        origin => format!(",\"translation\":[{}]", list(&origin.to_array())),
    };
    let main = if has_main { ",\"mesh\":0" } else { "" };
    let mut children = Vec::new();
    for (i, asset) in shared.iter().enumerate() {
        for place in &asset.placements {
            let [x, y, z] = [place.matrix3.x_axis, place.matrix3.y_axis, place.matrix3.z_axis];
            let columns = [x.extend(0.0), y.extend(0.0), z.extend(0.0), (place.translation - origin).extend(1.0)];
            let matrix = list(columns.map(|column| column.to_array()).as_flattened());
            children.push(format!("{{\"mesh\":{},\"matrix\":[{matrix}]}}", i + usize::from(has_main)));
        }
    }
    let ids = match children.len() {
        0 => String::new(),
        count => format!(",\"children\":[{}]", joined((1..=count).map(|i| i.to_string()))),
    };
    let root = format!("{{\"name\":\"model\"{main}{moved}{ids}}}");
    let _ = write!(json, "\"nodes\":[{}],", joined(std::iter::once(root).chain(children)));
}

fn primitive(primitive: &Primitive, at: &Accessors, rules: usize) -> String {
    let uv = at.uv.map_or(String::new(), |uv| format!(",\"TEXCOORD_0\":{uv}"));
    format!(
        "{{\"attributes\":{{\"POSITION\":{},\"NORMAL\":{},\"_FEATURE_ID_0\":{}{uv}}},\"indices\":{},\"material\":{},\
         \"extensions\":{{\"EXT_mesh_features\":{{\"featureIds\":[{{\"featureCount\":{rules},\"attribute\":0,\
         \"propertyTable\":0}}]}}}}}}",
        at.position, at.normal, at.rule, at.indices, primitive.look
    )
}

impl Binary {
    /// Appends bytes as a view of their own, on an 8-byte boundary; gives its number.
    fn view(&mut self, bytes: impl IntoIterator<Item = u8>, more: &str) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(8), 0);
        let start = self.bytes.len();
        self.bytes.extend(bytes);
        let length = self.bytes.len() - start;
        let offset = if start == 0 { String::new() } else { format!(",\"byteOffset\":{start}") };
        self.views.push(format!("{{\"buffer\":0{offset},\"byteLength\":{length}{more}}}"));
        self.views.len() - 1
    }

    fn accessor(&mut self, view: usize, offset: usize, component: u32, count: usize, kind: &str, more: &str) -> usize {
        let offset = if offset == 0 { String::new() } else { format!(",\"byteOffset\":{offset}") };
        self.accessors.push(format!(
            "{{\"bufferView\":{view}{offset},\"componentType\":{component},\"count\":{count},\"type\":\"{kind}\"{more}}}"
        ));
        self.accessors.len() - 1
    }

    /// One view a stream for all primitives together, and accessors for each.
    fn primitives(&mut self, primitives: &[&Primitive]) -> Result<Vec<Accessors>, WriteError> {
        let mut all = vec![Accessors::default(); primitives.len()];
        if primitives.is_empty() {
            return Ok(all);
        }
        let bytes = |f: &f32| f.to_le_bytes();
        let target = |target: u32| format!(",\"target\":{target}");
        let strided = |stride: u32| format!(",\"byteStride\":{stride},\"target\":{VERTICES}");

        let stream = primitives.iter().flat_map(|p| p.indices.iter().flat_map(|i| i.to_le_bytes()));
        let (view, mut at) = (self.view(stream, &target(INDICES)), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            a.indices = self.accessor(view, at, U32, p.indices.len(), "SCALAR", "");
            at += 4 * p.indices.len();
        }
        let stream = primitives.iter().flat_map(|p| p.positions.as_flattened().iter().flat_map(bytes));
        let (view, mut at) = (self.view(stream, &strided(12)), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            let range = extremes(&p.positions)?;
            a.position = self.accessor(view, at, F32, p.positions.len(), "VEC3", &range);
            at += 12 * p.positions.len();
        }
        let stream = primitives.iter().flat_map(|p| p.normals.as_flattened().iter().flat_map(bytes));
        let (view, mut at) = (self.view(stream, &strided(12)), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            a.normal = self.accessor(view, at, F32, p.normals.len(), "VEC3", "");
            at += 12 * p.normals.len();
        }
        let stream = primitives.iter().flat_map(|p| p.rules.iter().flat_map(bytes));
        let (view, mut at) = (self.view(stream, &strided(4)), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            a.rule = self.accessor(view, at, F32, p.rules.len(), "SCALAR", "");
            at += 4 * p.rules.len();
        }
        if primitives.iter().any(|p| !p.uvs.is_empty()) {
            let stream = primitives.iter().flat_map(|p| p.uvs.as_flattened().iter().flat_map(bytes));
            let (view, mut at) = (self.view(stream, &strided(8)), 0);
            for (p, a) in primitives.iter().zip(&mut all).filter(|(p, _)| !p.uvs.is_empty()) {
                a.uv = Some(self.accessor(view, at, F32, p.uvs.len(), "VEC2", ""));
                at += 8 * p.uvs.len();
            }
        }
        if MAX_BYTES < self.bytes.len() as u64 {
            return Err(WriteError::TooLarge { what: "bytes", limit: u64::from(u32::MAX) });
        }
        Ok(all)
    }
}

/// The members `min` and `max`. Every digit of the `f32`s is written: readers compare.
fn extremes(positions: &[[f32; 3]]) -> Result<String, WriteError> {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for position in positions {
        if !position.iter().all(|c| c.is_finite()) {
            return Err(WriteError::NotFinite);
        }
        for axis in 0..3 {
            low[axis] = low[axis].min(position[axis]);
            high[axis] = high[axis].max(position[axis]);
        }
    }
    Ok(format!(",\"min\":[{}],\"max\":[{}]", list(&low.map(f64::from)), list(&high.map(f64::from))))
}

/// Header and chunks. The description is padded so that the binary part starts on an 8-byte boundary of the file.
fn container(json: &str, binary: &[u8]) -> Result<Vec<u8>, WriteError> {
    let json_length = (json.len() + 4).next_multiple_of(8) - 4;
    let binary_chunk = if binary.is_empty() { 0 } else { 8 + binary.len() };
    let total = 20 + json_length + binary_chunk;
    let Ok(total) = u32::try_from(total) else {
        return Err(WriteError::TooLarge { what: "bytes", limit: u64::from(u32::MAX) });
    };
    let mut file = Vec::with_capacity(total as usize);
    file.extend_from_slice(b"glTF");
    for word in [2, total, json_length as u32] {
        file.extend_from_slice(&word.to_le_bytes());
    }
    file.extend_from_slice(b"JSON");
    file.extend_from_slice(json.as_bytes());
    file.resize(20 + json_length, b' ');
    if !binary.is_empty() {
        file.extend_from_slice(&(binary.len() as u32).to_le_bytes());
        file.extend_from_slice(b"BIN\0");
        file.extend_from_slice(binary);
    }
    Ok(file)
}
