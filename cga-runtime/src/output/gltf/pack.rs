//! Combines streams and description into one file.

use std::fmt::Write as _;
use std::sync::Arc;

use glam::{DVec3, Vec4};

use super::binary::{Binary, container, text};
use super::images::Images;
use super::json::joined;
use super::parts::Instance;
use super::primitive::Primitive;
use super::streams::Stream;
use super::textures::LookTexture;
use super::{Glb, Instances, MAX_BYTES, Shared};
use crate::output::error::WriteError;
use crate::output::number::list;

/// Component types and buffer targets of the format.
const U32: u32 = 5125;
const F32: u32 = 5126;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// The accessors of one primitive.
#[derive(Clone, Copy, Default)]
struct Accessors {
    indices: usize,
    position: usize,
    normal: usize,
    rule: usize,
    /// The first of its accessors of texture coordinates, one for each set.
    uv: usize,
    tangent: Option<usize>,
}

pub(super) fn pack(glb: &Glb, main: &[Primitive], shared: &[Shared]) -> Result<Vec<u8>, WriteError> {
    let main = Some(main).filter(|primitives| !primitives.is_empty());
    let meshes: Vec<&[Primitive]> = main.into_iter().chain(shared.iter().map(|s| &s.primitives[..])).collect();
    let flat: Vec<&Primitive> = meshes.iter().copied().flatten().collect();
    let mut binary = Binary::default();
    let images = Images::of(glb.looks.textures(), glb.files.get().map(Arc::as_ref), glb.references_images);
    let mut accessors = binary.primitives(&flat)?;
    for (primitive, accessors) in flat.iter().copied().zip(&mut accessors) {
        accessors.tangent = glb.looks.normal_space(primitive.look, &images).map(|space| {
            let more = format!(",\"byteStride\":16,\"target\":{VERTICES}");
            let count = primitive.vertex_count();
            let view = binary.view(16 * count, &more, move |to| primitive.write_tangents(&space, to));
            binary.accessor(view, 0, F32, count, "VEC4", "")
        });
    }
    let places = binary.places(shared);

    let mut json = String::from("{\"asset\":{\"generator\":\"cga\",\"version\":\"2.0\"},");
    if flat.is_empty() {
        json.push_str("\"scene\":0,\"scenes\":[{}]}");
        return container(&json, &Binary::default());
    }
    let rules = glb.numbers.table.rules();
    let images = Images::of(glb.looks.textures(), glb.files.get().map(Arc::as_ref), glb.references_images);
    let has_transforms = glb.looks.textures().any(LookTexture::is_transformed);
    write_rules(&mut json, &mut binary, rules, has_transforms, !places.is_empty());
    json.push_str("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],");
    write_nodes(&mut json, glb.origin, main.is_some(), shared, &places);
    let mut next = accessors.into_iter();
    let mesh = |primitives: &&[Primitive]| {
        let list = primitives.iter().zip(&mut next).map(|(p, a)| primitive(p, &a, rules.len()));
        format!("{{\"primitives\":[{}]}}", joined(list))
    };
    let _ = write!(json, "\"meshes\":[{}],", joined(meshes.iter().map(mesh)));
    glb.looks.write(&mut json, &images);
    images.write(&mut json, &mut binary);
    if MAX_BYTES < binary.length as u64 {
        return Err(WriteError::TooLarge { what: "bytes", limit: u64::from(u32::MAX) });
    }
    let _ = write!(json, "\"accessors\":[{}],", binary.accessors.join(","));
    let _ = write!(json, "\"bufferViews\":[{}],", binary.views.join(","));
    // The chunk is padded, and readers complain if the buffer is shorter than the chunk.
    binary.align();
    let _ = write!(json, "\"buffers\":[{{\"byteLength\":{}}}]}}", binary.length);
    container(&json, &binary)
}

/// Writes the rule names: a string table with one row for each rule.
fn write_rules(json: &mut String, binary: &mut Binary<'_>, rules: &[&str], has_transforms: bool, has_instances: bool) {
    let mut offsets = vec![0u32];
    let mut names = Vec::new();
    for rule in rules {
        names.extend_from_slice(rule.as_bytes());
        offsets.push(names.len() as u32);
    }
    let values = binary.view(names.len(), "", move |to| text(to, &names, 0));
    let offsets = binary.view(4 * offsets.len(), "", move |to| to.extend(offsets.iter().map(|o| o.to_le_bytes())));
    json.push_str("\"extensionsUsed\":[\"EXT_mesh_features\",\"EXT_structural_metadata\"");
    if has_transforms {
        json.push_str(",\"KHR_texture_transform\"");
    }
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

/// Writes the nodes. The first node contains all others, so that one translation moves everything.
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
            Instances::Nodes(nodes) => children.extend(nodes.iter().map(|place| {
                let [x, y, z] = [place.matrix3.x_axis, place.matrix3.y_axis, place.matrix3.z_axis];
                let columns = [x.extend(0.0), y.extend(0.0), z.extend(0.0), (place.translation - origin).extend(1.0)];
                let matrix = list(columns.map(|column| column.to_array()).as_flattened());
                format!("{{\"mesh\":{mesh},\"matrix\":[{matrix}]}}")
            })),
            Instances::Instances(_) => children.extend(places.next().map(|[translation, rotation]| {
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
    let tangent = at.tangent.map_or(String::new(), |tangent| format!(",\"TANGENT\":{tangent}"));
    let uvs: String = (0..primitive.uvs.len()).map(|set| format!(",\"TEXCOORD_{set}\":{}", at.uv + set)).collect();
    format!(
        "{{\"attributes\":{{\"POSITION\":{},\"NORMAL\":{},\"_FEATURE_ID_0\":{}{uvs}{tangent}}},\"indices\":{},\"material\":{},\
         \"extensions\":{{\"EXT_mesh_features\":{{\"featureIds\":[{{\"featureCount\":{rules},\"attribute\":0,\
         \"propertyTable\":0}}]}}}}}}",
        at.position, at.normal, at.rule, at.indices, primitive.look
    )
}

impl<'a> Binary<'a> {
    /// Adds one view for each stream of all primitives together, and accessors for each primitive.
    fn primitives(&mut self, primitives: &[&'a Primitive]) -> Result<Vec<Accessors>, WriteError> {
        let mut all = vec![Accessors::default(); primitives.len()];
        if primitives.is_empty() {
            return Ok(all);
        }
        let target = |target: u32| format!(",\"target\":{target}");
        let strided = |stride: u32| format!(",\"byteStride\":{stride},\"target\":{VERTICES}");
        let vertices = primitives.iter().map(|p| p.vertex_count()).sum::<usize>();

        let count = primitives.iter().map(|p| p.index_count()).sum::<usize>();
        let (view, mut at) = (self.stream(4 * count, &target(INDICES), primitives, Primitive::write_indices), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            a.indices = self.accessor(view, at, U32, p.index_count(), "SCALAR", "");
            at += 4 * p.index_count();
        }
        let (view, mut at) = (self.stream(12 * vertices, &strided(12), primitives, Primitive::write_positions), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            let range = extremes(p.positions.items())?;
            a.position = self.accessor(view, at, F32, p.vertex_count(), "VEC3", &range);
            at += 12 * p.vertex_count();
        }
        let (view, mut at) = (self.stream(12 * vertices, &strided(12), primitives, Primitive::write_normals), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            a.normal = self.accessor(view, at, F32, p.vertex_count(), "VEC3", "");
            at += 12 * p.vertex_count();
        }
        let (view, mut at) = (self.stream(4 * vertices, &strided(4), primitives, Primitive::write_rules), 0);
        for (p, a) in primitives.iter().zip(&mut all) {
            a.rule = self.accessor(view, at, F32, p.vertex_count(), "SCALAR", "");
            at += 4 * p.vertex_count();
        }
        let count = primitives.iter().flat_map(|p| &p.uvs).map(Vec::len).sum::<usize>();
        if 0 < count {
            let (view, mut at) = (self.stream(8 * count, &strided(8), primitives, Primitive::write_uvs), 0);
            for (p, a) in primitives.iter().zip(&mut all) {
                a.uv = self.accessors.len();
                for list in &p.uvs {
                    if !list.as_flattened().iter().all(|number| number.is_finite()) {
                        return Err(WriteError::NotFinite);
                    }
                    self.accessor(view, at, F32, list.len(), "VEC2", "");
                    at += 8 * list.len();
                }
            }
        }
        if MAX_BYTES < self.length as u64 {
            return Err(WriteError::TooLarge { what: "bytes", limit: u64::from(u32::MAX) });
        }
        Ok(all)
    }

    /// Adds a view with the output of `write` for each primitive.
    fn stream(&mut self, length: usize, more: &str, primitives: &[&'a Primitive], write: Stream) -> usize {
        let primitives = primitives.to_vec();
        self.view(length, more, move |to| primitives.iter().for_each(|primitive| write(primitive, to)))
    }

    /// The accessors of the translations and the rotations of instances, for each mesh with instances.
    fn places(&mut self, shared: &'a [Shared]) -> Vec<[usize; 2]> {
        let lists = shared.iter().filter_map(|mesh| match &mesh.places {
            Instances::Instances(places) => Some(&places[..]),
            Instances::Nodes(_) => None,
        });
        let lists: Vec<&[Instance]> = lists.collect();
        let count = lists.iter().map(|list| list.len()).sum::<usize>();
        if count == 0 {
            return Vec::new();
        }
        let all = lists.clone();
        let translations = self.view(12 * count, "", move |to| {
            all.iter().copied().flatten().for_each(|place| to.extend(place.translation.map(f32::to_le_bytes)));
        });
        let all = lists.clone();
        let rotations = self.view(16 * count, "", move |to| {
            all.iter().copied().flatten().for_each(|place| to.extend(place.rotation.map(f32::to_le_bytes)));
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
fn extremes(positions: &[[f32; 3]]) -> Result<String, WriteError> {
    let (low, high) = bounds(positions).ok_or(WriteError::NotFinite)?;
    Ok(format!(",\"min\":[{}],\"max\":[{}]", list(&low.map(f64::from)), list(&high.map(f64::from))))
}

/// The least and the largest coordinates, if all are finite.
fn bounds(positions: &[[f32; 3]]) -> Option<([f32; 3], [f32; 3])> {
    // Four positions at once, as they are three whole vectors.
    let (chunks, rest) = positions.as_flattened().as_chunks::<12>();
    let (mut lows, mut highs) = ([Vec4::INFINITY; 3], [Vec4::NEG_INFINITY; 3]);
    // Coordinates that are not finite make the sum NaN.
    let mut zeros = [Vec4::ZERO; 3];
    for chunk in chunks {
        for (i, c) in chunk.as_chunks::<4>().0.iter().map(|c| Vec4::from_array(*c)).enumerate() {
            lows[i] = lows[i].min(c);
            highs[i] = highs[i].max(c);
            zeros[i] += c * 0.0;
        }
    }
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    let flat = |vectors: [Vec4; 3]| vectors.map(|vector| vector.to_array());
    for (i, &c) in flat(lows).as_flattened().iter().chain(rest).enumerate() {
        low[i % 3] = low[i % 3].min(c);
    }
    for (i, &c) in flat(highs).as_flattened().iter().chain(rest).enumerate() {
        high[i % 3] = high[i % 3].max(c);
    }
    let is_finite = flat(zeros).as_flattened().iter().all(|zero| *zero == 0.0) && rest.iter().all(|c| c.is_finite());
    is_finite.then_some((low, high))
}

#[cfg(test)]
mod tests {
    use super::bounds;

    #[test]
    fn bounds_are_those_of_all_positions_and_finite() {
        let mut positions: Vec<[f32; 3]> = (0..11).map(|i| [i as f32, -(i as f32), 0.5]).collect();
        assert_eq!(bounds(&positions), Some(([0.0, -10.0, 0.5], [10.0, 0.0, 0.5])));
        for (at, odd) in [(0, f32::NAN), (10, f32::NAN), (3, f32::INFINITY), (9, f32::NEG_INFINITY)] {
            let kept = std::mem::replace(&mut positions[at][1], odd);
            assert_eq!(bounds(&positions), None);
            positions[at][1] = kept;
        }
        assert_eq!(bounds(&positions[..2]), Some(([0.0, -1.0, 0.5], [1.0, 0.0, 0.5])));
    }
}
