//! Streams and description into one file.

use std::fmt::Write as _;

use glam::DVec3;

use super::binary::{Binary, container, put};
use super::json::joined;
use super::parts::Place;
use super::primitive::Primitive;
use super::{Glb, MAX_BYTES, Places, Shared};
use crate::sink::error::WriteError;
use crate::sink::number::list;

/// Component and target numbers of the format.
const U32: u32 = 5125;
const F32: u32 = 5126;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// Accessors of one primitive.
#[derive(Clone, Copy, Default)]
struct Accessors {
    indices: usize,
    position: usize,
    normal: usize,
    rule: usize,
    uv: Option<usize>,
}

pub(super) fn pack(glb: &Glb, main: &[Primitive], shared: &[Shared]) -> Result<Vec<u8>, WriteError> {
    let main = Some(main).filter(|primitives| !primitives.is_empty());
    let meshes: Vec<&[Primitive]> = main.into_iter().chain(shared.iter().map(|s| &s.primitives[..])).collect();
    let flat: Vec<&Primitive> = meshes.iter().copied().flatten().collect();
    let mut binary = Binary::default();
    let accessors = binary.primitives(&flat)?;
    let places = binary.places(shared);

    let mut json = String::from("{\"asset\":{\"generator\":\"cga\",\"version\":\"2.0\"},");
    if flat.is_empty() {
        json.push_str("\"scene\":0,\"scenes\":[{}]}");
        return container(&json, &Binary::default());
    }
    let rules = glb.numbers.table.rules();
    write_rules(&mut json, &mut binary, rules, !places.is_empty());
    json.push_str("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],");
    write_nodes(&mut json, glb.origin, main.is_some(), shared, &places);
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
    binary.align();
    let _ = write!(json, "\"buffers\":[{{\"byteLength\":{}}}]}}", binary.length);
    container(&json, &binary)
}

/// Rule names: one string table, one row a rule.
fn write_rules(json: &mut String, binary: &mut Binary<'_>, rules: &[&str], has_instances: bool) {
    let mut offsets = vec![0u32];
    let mut text = Vec::new();
    for rule in rules {
        text.extend_from_slice(rule.as_bytes());
        offsets.push(text.len() as u32);
    }
    let values = binary.view(text.len(), "", move |to| to.copy_from_slice(&text));
    let offsets = binary.view(4 * offsets.len(), "", move |to| {
        put(to, offsets.iter().map(|o| o.to_le_bytes()));
    });
    json.push_str("\"extensionsUsed\":[\"EXT_mesh_features\",\"EXT_structural_metadata\"");
    // A reader without the extension would show each part once, at a wrong place.
    json.push_str(match has_instances {
        true => ",\"EXT_mesh_gpu_instancing\"],\"extensionsRequired\":[\"EXT_mesh_gpu_instancing\"],",
        false => "],",
    });
    json.push_str("\"extensions\":{\"EXT_structural_metadata\":{\"schema\":{\"id\":\"cga\",\"classes\":{");
    json.push_str("\"rule\":{\"properties\":{\"name\":{\"type\":\"STRING\",\"required\":true}}}}},");
    let _ = write!(json, "\"propertyTables\":[{{\"class\":\"rule\",\"count\":{},\"properties\":{{", rules.len());
    let _ = write!(json, "\"name\":{{\"values\":{values},\"stringOffsets\":{offsets}}}}}}}]}}}},");
}

/// The first node holds everything, so that one translation moves all.
fn write_nodes(json: &mut String, origin: DVec3, has_main: bool, shared: &[Shared], places: &[[usize; 2]]) {
    let moved = match origin {
        DVec3::ZERO => String::new(),
        origin => format!(",\"translation\":[{}]", list(&origin.to_array())),
    };
    let main = if has_main { ",\"mesh\":0" } else { "" };
    let mut children = Vec::new();
    let mut places = places.iter();
    for (i, asset) in shared.iter().enumerate() {
        let mesh = i + usize::from(has_main);
        match &asset.places {
            Places::Nodes(nodes) => children.extend(nodes.iter().map(|place| {
                let [x, y, z] = [place.matrix3.x_axis, place.matrix3.y_axis, place.matrix3.z_axis];
                let columns = [x.extend(0.0), y.extend(0.0), z.extend(0.0), (place.translation - origin).extend(1.0)];
                let matrix = list(columns.map(|column| column.to_array()).as_flattened());
                format!("{{\"mesh\":{mesh},\"matrix\":[{matrix}]}}")
            })),
            Places::Instances(_) => children.extend(places.next().map(|[translation, rotation]| {
                format!(
                    "{{\"mesh\":{mesh},\"extensions\":{{\"EXT_mesh_gpu_instancing\":{{\"attributes\":\
                     {{\"TRANSLATION\":{translation},\"ROTATION\":{rotation}}}}}}}}}"
                )
            })),
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

impl<'a> Binary<'a> {
    /// One view a stream for all primitives together, and accessors for each.
    fn primitives(&mut self, primitives: &[&'a Primitive]) -> Result<Vec<Accessors>, WriteError> {
        let mut all = vec![Accessors::default(); primitives.len()];
        if primitives.is_empty() {
            return Ok(all);
        }
        let target = |target: u32| format!(",\"target\":{target}");
        let strided = |stride: u32| format!(",\"byteStride\":{stride},\"target\":{VERTICES}");
        let vertices = primitives.iter().map(|p| p.positions.len()).sum::<usize>();

        let count = primitives.iter().map(|p| p.indices.len()).sum::<usize>();
        let (view, mut at) = (self.stream(4 * count, &target(INDICES), primitives, write_indices), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            a.indices = self.accessor(view, at, U32, p.indices.len(), "SCALAR", "");
            at += 4 * p.indices.len();
        }
        let (view, mut at) = (self.stream(12 * vertices, &strided(12), primitives, write_positions), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            let range = extremes(p.positions.items())?;
            a.position = self.accessor(view, at, F32, p.positions.len(), "VEC3", &range);
            at += 12 * p.positions.len();
        }
        let (view, mut at) = (self.stream(12 * vertices, &strided(12), primitives, write_normals), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            a.normal = self.accessor(view, at, F32, p.normals.len(), "VEC3", "");
            at += 12 * p.normals.len();
        }
        let (view, mut at) = (self.stream(4 * vertices, &strided(4), primitives, write_rule_numbers), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            a.rule = self.accessor(view, at, F32, p.positions.len(), "SCALAR", "");
            at += 4 * p.positions.len();
        }
        let count = primitives.iter().map(|p| p.uvs.len()).sum::<usize>();
        if 0 < count {
            let (view, mut at) = (self.stream(8 * count, &strided(8), primitives, write_uvs), 0);
            for (p, a) in primitives.iter().zip(&mut all).filter(|(p, _)| !p.uvs.is_empty()) {
                a.uv = Some(self.accessor(view, at, F32, p.uvs.len(), "VEC2", ""));
                at += 8 * p.uvs.len();
            }
        }
        if MAX_BYTES < self.length as u64 {
            return Err(WriteError::TooLarge { what: "bytes", limit: u64::from(u32::MAX) });
        }
        Ok(all)
    }

    /// A view with what `write` writes of each primitive.
    fn stream(
        &mut self,
        length: usize,
        more: &str,
        primitives: &[&'a Primitive],
        write: for<'t> fn(&'t mut [u8], &Primitive) -> &'t mut [u8],
    ) -> usize {
        let primitives = primitives.to_vec();
        self.view(length, more, move |to| {
            primitives.iter().fold(to, |rest, primitive| write(rest, primitive));
        })
    }

    /// The accessors of the translations and the rotations of instances, for each mesh that has some.
    fn places(&mut self, shared: &'a [Shared]) -> Vec<[usize; 2]> {
        let lists = shared.iter().filter_map(|mesh| match &mesh.places {
            Places::Instances(places) => Some(&places[..]),
            Places::Nodes(_) => None,
        });
        let lists: Vec<&[Place]> = lists.collect();
        let count = lists.iter().map(|list| list.len()).sum::<usize>();
        if count == 0 {
            return Vec::new();
        }
        let all = lists.clone();
        let translations = self.view(12 * count, "", move |to| {
            let words = all.iter().copied().flatten().flat_map(|place| place.translation).map(f32::to_le_bytes);
            put(to, words);
        });
        let all = lists.clone();
        let rotations = self.view(16 * count, "", move |to| {
            let words = all.iter().copied().flatten().flat_map(|place| place.rotation).map(f32::to_le_bytes);
            put(to, words);
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

fn write_indices<'t>(to: &'t mut [u8], primitive: &Primitive) -> &'t mut [u8] {
    put(to, primitive.indices.items().iter().map(|index| index.to_le_bytes()))
}

fn write_positions<'t>(to: &'t mut [u8], primitive: &Primitive) -> &'t mut [u8] {
    put(to, primitive.positions.items().as_flattened().iter().map(|c| c.to_le_bytes()))
}

fn write_normals<'t>(to: &'t mut [u8], primitive: &Primitive) -> &'t mut [u8] {
    put(to, primitive.normals.items().as_flattened().iter().map(|c| c.to_le_bytes()))
}

fn write_rule_numbers<'t>(to: &'t mut [u8], primitive: &Primitive) -> &'t mut [u8] {
    primitive.rules().fold(to, |rest, (rule, vertices)| {
        let word = (rule as f32).to_le_bytes();
        put(rest, std::iter::repeat_n(word, vertices.len()))
    })
}

fn write_uvs<'t>(to: &'t mut [u8], primitive: &Primitive) -> &'t mut [u8] {
    put(to, primitive.uvs.as_flattened().iter().map(|c| c.to_le_bytes()))
}

/// The members `min` and `max`. Every digit of the `f32`s is written: readers compare.
fn extremes(positions: &[[f32; 3]]) -> Result<String, WriteError> {
    let (low, high) = bounds(positions).ok_or(WriteError::NotFinite)?;
    Ok(format!(",\"min\":[{}],\"max\":[{}]", list(&low.map(f64::from)), list(&high.map(f64::from))))
}

/// The least and the largest coordinates, if all are finite.
fn bounds(positions: &[[f32; 3]]) -> Option<([f32; 3], [f32; 3])> {
    // Four positions at once, as they are three whole vectors.
    const WIDE: usize = 12;
    let (chunks, rest) = positions.as_flattened().as_chunks::<WIDE>();
    let (mut low, mut high, mut zero) = ([f32::INFINITY; WIDE], [f32::NEG_INFINITY; WIDE], [0.0f32; WIDE]);
    for chunk in chunks {
        for (i, &c) in chunk.iter().enumerate() {
            low[i] = if c < low[i] { c } else { low[i] };
            high[i] = if high[i] < c { c } else { high[i] };
            // What is not finite becomes NaN, and stays it.
            zero[i] += 0.0 * c;
        }
    }
    for (i, &c) in rest.iter().enumerate() {
        low[i] = low[i].min(c);
        high[i] = high[i].max(c);
        zero[i] += 0.0 * c;
    }
    for i in 3..WIDE {
        low[i % 3] = low[i % 3].min(low[i]);
        high[i % 3] = high[i % 3].max(high[i]);
    }
    zero.iter().all(|zero| *zero == 0.0).then_some(([low[0], low[1], low[2]], [high[0], high[1], high[2]]))
}
