//! Combines streams and description into one file.

use std::fmt::Write as _;
use std::io;

use super::binary::BinaryChunk;
use super::container::Container;
use super::images::Images;
use super::json::{joined, quoted};
use super::nodes::{name, nodes};
use super::primitive::Primitive;
use super::property_table::{self, PropertyTable, Tables};
use super::quantized::{ByteNormals, Grid, GridPositions, QUANTIZATION, has_short_indices};
use super::scene::{Division, INSTANCING, MeshInstance, MeshPlacement, NodePlaces, SceneMesh};
use super::textures::LookTexture;
use super::words::Words;
use super::{Glb, check_size};
use crate::geometry::each::Each;
use crate::output::error::WriteError;
use crate::output::number_text::list;
use crate::output::packed::PackedFaces;

/// The component types of the format.
const I8: u32 = 5120;
const U16: u32 = 5123;
const U32: u32 = 5125;
const F32: u32 = 5126;

/// The items of a stream: their type, the type of their components, and their bytes.
struct VertexLayout {
    kind: &'static str,
    component: u32,
    bytes: usize,
}

const INDEX: VertexLayout = VertexLayout { kind: "SCALAR", component: U32, bytes: 4 };
const SHORT_INDEX: VertexLayout = VertexLayout { kind: "SCALAR", component: U16, bytes: 2 };
const FEATURE: VertexLayout = VertexLayout { kind: "SCALAR", component: F32, bytes: 4 };
const UV: VertexLayout = VertexLayout { kind: "VEC2", component: F32, bytes: 8 };
const POINT: VertexLayout = VertexLayout { kind: "VEC3", component: F32, bytes: 12 };
/// A point on a grid. Vertices begin at whole words.
const GRID_POINT: VertexLayout = VertexLayout { kind: "VEC3", component: U16, bytes: 8 };
const BYTE_NORMAL: VertexLayout = VertexLayout { kind: "VEC3", component: I8, bytes: 4 };
const TANGENT: VertexLayout = VertexLayout { kind: "VEC4", component: F32, bytes: 16 };

/// The accessors of one primitive.
struct Accessors {
    indices: usize,
    position: usize,
    normal: Option<usize>,
    /// The numbers of rules and of buildings, unless these have nodes of their own.
    rule: Option<usize>,
    building: Option<usize>,
    /// The first of its accessors of texture coordinates, one for each set.
    uv: usize,
    tangent: Option<usize>,
}

/// The streams whose numbers are small.
#[derive(Clone, Copy)]
struct SmallNumbers {
    /// True for normals of bytes, and for indices of 16 bits where they suffice.
    is_wanted: bool,
    has_normals: bool,
    grid: Option<Grid>,
    /// The number of the first primitives, whose positions are on the grid.
    on_grid: usize,
}

pub(super) fn pack<'a>(glb: &'a Glb, meshes: &'a [SceneMesh]) -> Result<Container<'a>, WriteError> {
    let flat: Vec<&Primitive> = meshes.iter().flat_map(|mesh| &mesh.primitives).collect();
    let mut binary = BinaryChunk::default();
    let images =
        Images::of(glb.looks.textures(), glb.files.as_deref(), glb.references_images, glb.shared_images.as_ref());
    let rules = Some(glb.numbers.table.rules()).filter(|_| !glb.division.by_rule && !glb.has_no_rules);
    let buildings = Some(&glb.rows[..]).filter(|list| !list.is_empty() && !glb.division.by_building);
    let grid = glb.grid(meshes)?;
    let rooted = meshes.iter().filter(|mesh| matches!(mesh.places, MeshPlacement::Root));
    let small = SmallNumbers {
        is_wanted: glb.quantization.is_some(),
        has_normals: !glb.has_no_normals,
        grid,
        on_grid: if grid.is_some() { rooted.map(|mesh| mesh.primitives.len()).sum() } else { 0 },
    };
    let mut accessors = binary.primitives(&flat, rules.is_some(), small)?;
    // Meshes at several places follow the others.
    let owned: usize = meshes.iter().filter(|mesh| mesh.is_in_place()).map(|mesh| mesh.primitives.len()).sum();
    if let Some(buildings) = buildings {
        let first = binary.buildings(&flat[..owned], buildings.len());
        accessors[..owned].iter_mut().zip(first..).for_each(|(own, number)| own.building = Some(number));
    }
    for (primitive, accessors) in flat.iter().copied().zip(&mut accessors) {
        let space = glb.looks.normal_space(primitive.look, &images).filter(|_| small.has_normals);
        accessors.tangent = space.map(|space| {
            binary.stream(
                &TANGENT,
                &[primitive],
                |p: &Primitive| p.faces.vertex_count(),
                &[],
                move |p, to| p.write_tangents(&space, to),
            )
        });
    }
    let places = binary.places(meshes, &glb.division, buildings.is_some());

    let rules = rules.filter(|_| !flat.is_empty());
    let tables = Tables { rules: rules.map(<[_]>::len), buildings: buildings.map(<[_]>::len) };
    let mut json = String::from("{\"asset\":{\"generator\":\"cga\",\"version\":\"2.0\"},");
    let has_transforms = glb.looks.textures().any(LookTexture::is_transformed);
    let has_features = accessors.iter().any(|own| own.rule.is_some() || own.building.is_some());
    let is_quantized = small.is_wanted && !flat.is_empty();
    write_extensions(&mut json, &tables, [has_features, has_transforms, is_quantized], &places);
    let list = rules.map(PropertyTable::of_rules).into_iter().chain(buildings.map(PropertyTable::of_buildings));
    let list: Vec<PropertyTable> = list.collect();
    if !list.is_empty() {
        let extension =
            property_table::extension(list, |bytes| binary.view(bytes.len(), "", move |to| to.bytes(&bytes, 0)));
        let _ = write!(json, "\"extensions\":{{{extension}}},");
    }
    let has_placements = glb.placements.as_ref().is_some_and(|placements| !placements.is_empty());
    if flat.is_empty() && !has_placements && !glb.division.by_building && glb.extras.is_empty() {
        json.push_str("\"scene\":0,\"scenes\":[{}]");
    } else {
        json.push_str("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],");
        json.push_str(&nodes(glb, meshes, &places, &tables, grid.as_ref()));
    }
    if !flat.is_empty() {
        write_meshes(&mut json, glb, meshes, accessors, &tables);
        json.push(',');
        glb.looks.write(&mut json, &images);
        images.write(&mut json, &mut binary);
        let _ = write!(json, "\"accessors\":[{}]", binary.accessors.join(","));
    }
    check_size(json.len() as u64)?;
    check_size(binary.length as u64)?;
    if !binary.views.is_empty() {
        let _ = write!(json, ",\"bufferViews\":[{}],", binary.views.join(","));
        // The chunk is padded, and readers complain if the buffer is shorter than the chunk.
        binary.align();
        let _ = write!(json, "\"buffers\":[{{\"byteLength\":{}}}]", binary.length);
    }
    json.push('}');
    Container::new(json, binary)
}

/// Writes the meshes, with a comma before them.
fn write_meshes(json: &mut String, glb: &Glb, meshes: &[SceneMesh], accessors: Vec<Accessors>, tables: &Tables) {
    let mut next = accessors.into_iter();
    let mesh = |mesh: &SceneMesh| {
        let list = mesh.primitives.iter().zip(&mut next).map(|(p, a)| primitive(p, &a, tables));
        format!("{{\"name\":{},\"primitives\":[{}]}}", quoted(&name(glb, mesh)), joined(list))
    };
    let _ = write!(json, ",\"meshes\":[{}]", joined(meshes.iter().map(mesh)));
}

/// Writes the names of the used extensions.
fn write_extensions(
    json: &mut String,
    tables: &Tables,
    [has_features, has_transforms, is_quantized]: [bool; 3],
    places: &[NodePlaces],
) {
    let used = [
        (is_quantized, QUANTIZATION),
        (has_features, "EXT_mesh_features"),
        (tables.rules.is_some() || tables.buildings.is_some(), "EXT_structural_metadata"),
        (has_transforms, "KHR_texture_transform"),
        (!places.is_empty(), INSTANCING),
        (places.iter().any(|place| place.buildings.is_some()), "EXT_instance_features"),
    ];
    let used = joined(used.into_iter().filter(|(is_used, _)| *is_used).map(|(_, name)| quoted(name)));
    if !used.is_empty() {
        let _ = write!(json, "\"extensionsUsed\":[{used}],");
    }
    // A reader without instances would show each part once, at a wrong place.
    let required = [(is_quantized, QUANTIZATION), (!places.is_empty(), INSTANCING)];
    let required = joined(required.into_iter().filter(|(is_used, _)| *is_used).map(|(_, name)| quoted(name)));
    if !required.is_empty() {
        let _ = write!(json, "\"extensionsRequired\":[{required}],");
    }
}

fn primitive(primitive: &Primitive, at: &Accessors, tables: &Tables) -> String {
    let normal = at.normal.map_or(String::new(), |normal| format!(",\"NORMAL\":{normal}"));
    let tangent = at.tangent.map_or(String::new(), |tangent| format!(",\"TANGENT\":{tangent}"));
    let uvs: String = (0..primitive.uvs.len()).map(|set| format!(",\"TEXCOORD_{set}\":{}", at.uv + set)).collect();
    let ids = [(at.rule, tables.rules, 0), (at.building, tables.buildings, tables.of_buildings())];
    let (mut attributes, mut features) = (String::new(), Vec::new());
    for (attribute, (id, rows, table)) in
        ids.into_iter().filter_map(|(id, rows, table)| Some((id?, rows?, table))).enumerate()
    {
        let _ = write!(attributes, ",\"_FEATURE_ID_{attribute}\":{id}");
        features.push(format!("{{\"featureCount\":{rows},\"attribute\":{attribute},\"propertyTable\":{table}}}"));
    }
    let features = match features.len() {
        0 => String::new(),
        _ => format!(",\"extensions\":{{\"EXT_mesh_features\":{{\"featureIds\":[{}]}}}}", features.join(",")),
    };
    format!(
        "{{\"attributes\":{{\"POSITION\":{}{normal}{attributes}{uvs}{tangent}}},\"indices\":{},\"material\":{}{features}}}",
        at.position, at.indices, primitive.look
    )
}

impl<'a> BinaryChunk<'a> {
    /// Adds one view for each stream of all primitives together, and accessors for each primitive.
    fn primitives(
        &mut self,
        primitives: &[&'a Primitive],
        has_rules: bool,
        small: SmallNumbers,
    ) -> Result<Vec<Accessors>, WriteError> {
        if primitives.is_empty() {
            return Ok(Vec::new());
        }
        let (on_grid, others) = primitives.split_at(small.on_grid);
        let ranges = others.iter().map(|p| extremes(&p.faces)).collect::<Result<Vec<_>, _>>()?;
        let lists: Vec<&Vec<[f32; 2]>> = primitives.iter().flat_map(|p| &p.uvs).collect();
        if !lists.iter().all(|list| list.as_flattened().iter().all(|number| number.is_finite())) {
            return Err(WriteError::NotFinite);
        }
        let corners = |p: &Primitive| p.faces.index_count();
        let indices = match small.is_wanted && has_short_indices(primitives) {
            true => self.stream(&SHORT_INDEX, primitives, corners, &[], Primitive::write_short_indices),
            false => self.stream(&INDEX, primitives, corners, &[], Primitive::write_indices),
        };
        let vertices = |p: &Primitive| p.faces.vertex_count();
        let mut positions = Vec::new();
        if let Some(grid) = small.grid {
            let ranges = on_grid.iter().map(|p| grid_extremes(&grid, &p.faces)).collect::<Result<Vec<_>, _>>()?;
            let first = self.stream(&GRID_POINT, on_grid, vertices, &ranges, move |p, to| {
                p.faces.positions(&mut GridPositions { to, grid })
            });
            positions.extend(first..first + on_grid.len());
        }
        if !others.is_empty() {
            let first = self.stream(&POINT, others, vertices, &ranges, Primitive::write_positions);
            positions.extend(first..first + others.len());
        }
        let normal = small.has_normals.then(|| match small.is_wanted {
            true => {
                let normalized = vec![",\"normalized\":true".to_owned(); primitives.len()];
                let write = |p: &Primitive, to: &mut Words<'_>| p.faces.normals(&mut ByteNormals(to));
                self.stream(&BYTE_NORMAL, primitives, vertices, &normalized, write)
            }
            false => self.stream(&POINT, primitives, vertices, &[], Primitive::write_normals),
        });
        let rule = has_rules.then(|| self.stream(&FEATURE, primitives, vertices, &[], Primitive::write_rules));
        let mut uv = self.accessors.len();
        if !lists.is_empty() {
            uv = self.stream(&UV, &lists, |list| list.len(), &[], |list, to| to.floats(list.as_flattened()));
        }
        let accessors = primitives.iter().enumerate().map(|(i, primitive)| {
            let (indices, position) = (indices + i, positions[i]);
            let normal = normal.map(|normal| normal + i);
            let rule = rule.map(|rule| rule + i);
            let own = Accessors { indices, position, normal, rule, building: None, uv, tangent: None };
            uv += primitive.uvs.len();
            own
        });
        Ok(accessors.collect())
    }

    /// Adds the buildings of vertices. Returns the accessor of the first primitive. The items of an accessor without a view are 0.
    fn buildings(&mut self, primitives: &[&'a Primitive], count: usize) -> usize {
        let first = self.accessors.len();
        if 1 < count {
            return self.stream(&FEATURE, primitives, |p| p.faces.vertex_count(), &[], Primitive::write_buildings);
        }
        let accessors = primitives.iter().map(|primitive| {
            let count = primitive.faces.vertex_count();
            format!("{{\"componentType\":{F32},\"count\":{count},\"type\":\"SCALAR\"}}")
        });
        self.accessors.extend(accessors);
        first
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
        let usage = match (kind, component) {
            ("SCALAR", U16 | U32) => ",\"target\":34963".to_owned(),
            _ => format!(",\"byteStride\":{bytes},\"target\":34962"),
        };
        // Parts begin at whole words.
        let length = |part: &T| (bytes * count(part)).next_multiple_of(4);
        let (total, all) = (parts.iter().map(|part| length(part)).sum::<usize>(), parts.to_vec());
        let view = self.view(total, &usage, move |to| all.iter().try_for_each(|part| write(part, to)));
        let (first, mut offset) = (self.accessors.len(), 0);
        for (i, part) in parts.iter().enumerate() {
            let more = more.get(i).map_or("", String::as_str);
            self.accessor(view, offset, component, count(part), kind, more);
            offset += length(part);
        }
        first
    }

    /// The nodes of meshes with instances: one for each mesh, or one for each building that has such instances.
    fn places(&mut self, meshes: &'a [SceneMesh], division: &Division, has_features: bool) -> Vec<NodePlaces> {
        let mut lists: Vec<(usize, Option<u32>, &[MeshInstance])> = Vec::new();
        for (number, mesh) in meshes.iter().enumerate() {
            let MeshPlacement::Instances(places) = &mesh.places else { continue };
            if division.by_building {
                let runs = places.chunk_by(|a, b| a.building == b.building);
                lists.extend(runs.map(|run| (number, Some(run[0].building), run)));
            } else {
                lists.push((number, None, places));
            }
        }
        let count = lists.iter().map(|(.., list)| list.len()).sum::<usize>();
        if count == 0 {
            return Vec::new();
        }
        let all: Vec<&[MeshInstance]> = lists.iter().map(|(.., list)| *list).collect();
        let own = all.clone();
        let translations = self.view(12 * count, "", move |to| {
            own.iter().try_for_each(|list| to.each(list, |place| place.translation.each(f32::to_le_bytes)))
        });
        let own = all.clone();
        let rotations = self.view(16 * count, "", move |to| {
            own.iter().try_for_each(|list| to.each(list, |place| place.rotation.each(f32::to_le_bytes)))
        });
        let buildings = has_features.then(|| {
            self.view(4 * count, "", move |to| {
                all.iter().try_for_each(|list| to.each(list, |place| [(place.building as f32).to_le_bytes()]))
            })
        });
        let mut at = 0;
        let nodes = lists.into_iter().map(|(mesh, building, list)| {
            let translations = self.accessor(translations, 12 * at, F32, list.len(), "VEC3", "");
            let rotations = self.accessor(rotations, 16 * at, F32, list.len(), "VEC4", "");
            let buildings = buildings.map(|view| self.accessor(view, 4 * at, F32, list.len(), "SCALAR", ""));
            at += list.len();
            NodePlaces { mesh, building, translations, rotations, buildings }
        });
        nodes.collect()
    }
}

/// The members `min` and `max`. All digits of the `f32`s are written, as readers compare.
fn extremes(faces: &PackedFaces) -> Result<String, WriteError> {
    let (low, high) = faces.bounds().ok_or(WriteError::NotFinite)?;
    Ok(format!(",\"min\":[{}],\"max\":[{}]", list(&low.as_dvec3().to_array()), list(&high.as_dvec3().to_array())))
}

/// The members `min` and `max` of positions on a grid.
fn grid_extremes(grid: &Grid, faces: &PackedFaces) -> Result<String, WriteError> {
    let (low, high) = faces.bounds().ok_or(WriteError::NotFinite)?;
    let [low, high] = [low, high].each(|corner| joined(grid.numbers(corner.to_array()).map(|n| n.to_string())));
    Ok(format!(",\"min\":[{low}],\"max\":[{high}]"))
}
