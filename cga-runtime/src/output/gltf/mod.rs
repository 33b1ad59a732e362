//! GLB 2.0: one binary file with geometry, materials and rule names.
//!
//! Triangles are grouped into one primitive for each material. Each vertex has the number of its rule (`_FEATURE_ID_0`) and of its
//! building (`_FEATURE_ID_1`, both `EXT_mesh_features`), and property tables (`EXT_structural_metadata`) have the names of
//! the rules, and of each building the name, the grammar, the seed, attributes and reports. On request, rules or buildings are nodes
//! instead ([`Glb::by_rule`], [`Glb::by_building`]). Assets inserted more than once are stored once and placed by nodes, with
//! the number of their building in `extras`. On request, parts that rules repeat are stored once
//! with a list of their places (`EXT_mesh_gpu_instancing`) and of their buildings (`EXT_instance_features`). Colours are converted from sRGB to linear light.
//! On request, positions have 16 bits and normals 8 bits (`KHR_mesh_quantization`, [`Glb::with_quantization`]).
//! Materials are double sided by default, as in CGA. Equal leaves and images give equal bytes.
//!
//! Images are embedded if the assets are known ([`Glb::with_assets`]; a model of a run knows them), otherwise they
//! are referenced by relative address. Colour, opacity, normal, emissive, occlusion, roughness and metallic maps
//! become maps of glTF, each with its set of texture coordinates and its placement (`KHR_texture_transform`). glTF
//! keeps opacity in the colour image and metallic in the roughness image. Two images of CGA are then combined into
//! one, with the larger size. An opacity map without an alpha channel is read by its brightness. Two maps in one
//! image share the set and the placement of the first. Bump, dirt and specular maps are left out: glTF has no such
//! maps.

mod binary;
mod buffers;
mod buildings;
mod combine;
mod container;
mod images;
mod joined;
mod json;
mod look;
mod models;
mod nodes;
mod pack;
mod parts;
mod primitive;
mod property_table;
mod quantized;
mod scene;
mod shared_images;
mod single_sided;
mod streams;
mod textures;
mod words;

use std::io;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use self::buildings::BuildingList;
use self::look::Looks;
use self::parts::RepeatedParts;
use self::primitive::{
    BUILDING_BYTES, INDEX_BYTES, Owner, Primitive, Primitives, QUANTIZED_BYTES, RULE_BYTES, UV_BYTES, VERTEX_BYTES,
};
use self::scene::{Division, MeshPlacement, SceneMesh};
use self::shared_images::SharedImages;
use self::single_sided::SingleSided;
use super::error::WriteError;
use super::flatten::{Flattener, has_one_material};
use super::leaf_numbers::Numbers;
use super::normals;
use super::placed_assets::AssetList;
use crate::asset::Assets;
use crate::geometry::Axis;
use crate::geometry::mesh::Mesh;
use crate::geometry::uv_map::{self, SetMap};
use crate::material::layer::SetMask;
use crate::output::measure::{cuboid_volume, mesh_volume};
use crate::run::building::Building;
use crate::run::sink::corners::{PlacedBox, four};
use crate::run::sink::{Cuboid, Filled, Flow, Leaf, Quad, Replay, Sink};
use crate::shape::base::Form;
use crate::shape::scope::Scope;
use crate::value::Value;

/// Collects leaves for a GLB file.
#[derive(Debug, Default)]
pub struct Glb {
    origin: DVec3,
    numbers: Numbers,
    looks: Looks,
    primitives: Primitives,
    /// The inserted assets; each place has the number of its building.
    assets: AssetList<u32>,
    buildings: BuildingList,
    /// The rows of the table of buildings, once all leaves are there.
    rows: Vec<Building>,
    /// The repeated parts, if they become instances.
    parts: Option<RepeatedParts>,
    flattener: Flattener,
    bytes: u64,
    /// The assets that contain the images.
    files: Option<Arc<Assets>>,
    references_images: bool,
    /// The addresses of images that several files share, if they are wanted.
    shared_images: Option<SharedImages>,
    name: Option<String>,
    division: Division,
    /// The single-sided materials of closed leaves, if they are wanted.
    single_sided: Option<SingleSided>,
    /// Leaves without faces, if they are written.
    placements: Option<Vec<(Owner, Scope)>>,
    /// Names and JSON texts of values.
    extras: Vec<(String, String)>,
    /// The most metres by which quantization may move positions, if it is wanted.
    quantization: Option<f64>,
    /// True if vertices have no numbers of rules.
    has_no_rules: bool,
    /// True if vertices have no normals, and faces share vertices.
    has_no_normals: bool,
}

/// The largest 32-bit length of the format, less room for the description.
const MAX_BYTES: u64 = u32::MAX as u64 - (1 << 24);

/// The usual length of a node without a mesh.
const NODE_BYTES: u64 = 256;

impl Glb {
    /// A file without leaves.
    pub fn new() -> Self {
        Glb::default()
    }

    /// Stores positions relative to a point of the world, in metres. A node moves them back. Far from the world's
    /// origin 32-bit floats alone are too coarse.
    pub fn with_origin(mut self, origin: DVec3) -> Self {
        self.origin = origin;
        self
    }

    /// Embeds images from an asset folder. A missing or broken file becomes a checker pattern.
    pub fn with_assets(mut self, assets: Arc<Assets>) -> Self {
        self.files = Some(assets);
        self
    }

    /// References image files by their names, relative to the file, instead of embedding them. Only images without a
    /// file are embedded: built-in textures, images inside glTF files, and images combined from two.
    pub fn with_referenced_images(mut self) -> Self {
        self.references_images = true;
        self
    }

    /// Stores each repeated part once, with the list of its places (`EXT_mesh_gpu_instancing`). The file is smaller
    /// and shows the same triangles; a reader must support the extension.
    ///
    /// Parts are known only during a run, so the sink must take the leaves of the run itself. A [`Model`](crate::output::model::Model) keeps
    /// single leaves.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::gltf::Glb;
    ///
    /// let glb = Glb::new().with_instances();
    /// // … `grammar.run(&shape, &settings, &mut glb)?`, then:
    /// assert!(glb.into_bytes().unwrap().starts_with(b"glTF"));
    /// ```
    pub fn with_instances(mut self) -> Self {
        self.parts = Some(RepeatedParts::default());
        self
    }

    /// Names the file's root node and its mesh, "model" by default: a grammar, or the address of a house.
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into());
        self
    }

    /// Writes a node and a mesh for each rule, with the name of the rule, below the root node. Programs that ignore the
    /// extension for rule names (most do) then show the rules as objects. A rule has a primitive for each of its
    /// materials, and vertices have no rule numbers.
    pub fn by_rule(mut self) -> Self {
        self.division.by_rule = true;
        self
    }

    /// Writes a node and a mesh for each building, with its name and its data as `extras`, below the root node. A building is an initial
    /// shape: in a file of many, programs that ignore the extensions for features then show each as an object. With
    /// [`by_rule`](Glb::by_rule) the nodes of its rules are below it.
    pub fn by_building(mut self) -> Self {
        self.division.by_building = true;
        self
    }

    /// Shows closed leaves with a positive volume from outside alone, where rules and assets do not set `material.doubleSided`: a card
    /// then draws half of their triangles. As in CGA, all materials show both sides by default.
    pub fn with_single_sided_solids(mut self) -> Self {
        self.single_sided = Some(SingleSided::default());
        self
    }

    /// Writes a node without a mesh for each leaf without faces, below the root node: the name of the rule, translation and rotation, and the
    /// size in metres as the member `size` of `extras`. Without it the file has leaves with faces alone.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::gltf::Glb;
    ///
    /// let glb = Glb::new().with_placements();
    /// # let _ = glb;
    /// ```
    pub fn with_placements(mut self) -> Self {
        self.placements = Some(Vec::new());
        self
    }

    /// Adds a value to the member `extras` of the root node, where programs show custom properties: an attribute, the
    /// seed. A value that is not finite is written as null.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::gltf::Glb;
    ///
    /// let glb = Glb::new().named("Tower").by_rule().with_extra("height", 24.0);
    /// # let _ = glb;
    /// ```
    pub fn with_extra(mut self, name: impl Into<String>, value: impl Into<Value>) -> Self {
        self.extras.push((name.into(), json::value(&value.into())));
        self
    }

    /// The bytes of vertices and indices so far, at least: [`with_quantization`](Glb::with_quantization) cannot shorten all of them. Corners that
    /// faces share [without normals](Glb::without_normals) are known at the end, and count for each face. Description, metadata and images
    /// come on top. A program that divides its output into files can stop when one is full.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::gltf::Glb;
    ///
    /// assert_eq!(Glb::new().size(), 0);
    /// ```
    pub fn size(&self) -> u64 {
        self.bytes
    }

    /// Completes the file.
    ///
    /// # Errors
    /// [`WriteError::TooLarge`] for more than 4 GiB, [`WriteError::NotFinite`] for coordinates beyond the range of
    /// `f32`.
    pub fn into_bytes(mut self) -> Result<Vec<u8>, WriteError> {
        let meshes = self.meshes()?;
        pack::pack(&self, &meshes)?.into_bytes()
    }

    /// Writes the completed file in blocks, without a copy of it in memory, and flushes `out`.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::gltf::Glb;
    ///
    /// let mut bytes = Vec::new();
    /// Glb::new().write_to(&mut bytes).unwrap(); // or a socket, or an entry of an archive
    /// assert!(bytes == Glb::new().into_bytes().unwrap());
    /// ```
    ///
    /// # Errors
    /// As [`Glb::into_bytes`], before anything is written, and [`WriteError::Io`] with an error of `out`.
    pub fn write_to(mut self, mut out: impl io::Write) -> Result<(), WriteError> {
        let meshes = self.meshes()?;
        Ok(pack::pack(&self, &meshes)?.write(&mut out)?)
    }

    /// Writes the completed file with its name.
    fn write_file(mut self, path: &Path) -> Result<(), WriteError> {
        let meshes = self.meshes()?;
        pack::pack(&self, &meshes)?.write_file(path)
    }

    /// The meshes of the scene.
    fn meshes(&mut self) -> Result<Vec<SceneMesh>, WriteError> {
        let mut shared = self.place_assets();
        if let Some(parts) = self.parts.take() {
            shared.extend(self.place_parts(parts));
        }
        check_size(self.bytes)?;
        let is_finite = |(_, scope): &(Owner, Scope)| {
            (scope.origin - self.origin).as_vec3().is_finite() && scope.size.as_vec3().is_finite()
        };
        if !self.placements.iter().flatten().all(is_finite) {
            return Err(WriteError::NotFinite);
        }
        let main = std::mem::take(&mut self.primitives).into_list();
        let mut meshes = vec![SceneMesh { primitives: main, places: MeshPlacement::Root, building: None }];
        meshes.extend(shared);
        self.end_buildings(&mut meshes);
        meshes = meshes.into_iter().flat_map(|mesh| mesh.divided(self.division)).collect();
        meshes.retain(|mesh| !mesh.primitives.is_empty());
        self.join_vertices(meshes)
    }

    /// Turns assets at several places into separate meshes; the others join the rest.
    fn place_assets(&mut self) -> Vec<SceneMesh> {
        let mut shared = Vec::new();
        for mut asset in std::mem::take(&mut self.assets).into_list() {
            let (own, single) = asset.shared_and_single();
            let (rule, material, mesh) = (asset.rule, asset.material, &asset.mesh);
            if !own.is_empty() {
                // Filled in the mesh's own coordinates, with a separate list of primitives.
                let main = std::mem::take(&mut self.primitives);
                let origin = std::mem::take(&mut self.origin);
                self.add_mesh(Owner { rule, building: 0 }, material, mesh, &DAffine3::IDENTITY);
                self.origin = origin;
                let primitives = std::mem::replace(&mut self.primitives, main).into_list();
                shared.push(SceneMesh { primitives, places: MeshPlacement::Nodes(own), building: None });
            }
            for (place, building) in single {
                self.add_mesh(Owner { rule, building }, material, mesh, &place);
            }
        }
        shared
    }

    #[inline]
    fn owner(&self, rule: u32) -> Owner {
        Owner { rule, building: self.buildings.next() }
    }

    /// Makes the rows of the table of buildings, and gives all leaves the numbers of their rows. A file without buildings is not divided by
    /// them.
    fn end_buildings(&mut self, meshes: &mut [SceneMesh]) {
        let placements = &mut self.placements;
        let mut each = |each: &mut dyn FnMut(&mut u32)| {
            meshes.iter_mut().for_each(|mesh| mesh.each_building(&mut *each));
            placements.iter_mut().flatten().for_each(|(owner, _)| each(&mut owner.building));
        };
        let mut used = Vec::new();
        each(&mut |building| used.push(*building));
        let (rows, row_of) = std::mem::take(&mut self.buildings).into_rows(&used);
        each(&mut |building| *building = row_of[*building as usize]);
        self.division.by_building &= !rows.is_empty();
        self.rows = rows;
    }

    /// Counts the bytes of vertices with a number of sets of texture coordinates, and of indices.
    fn add(&mut self, vertices: usize, indices: usize, sets: usize) -> Flow {
        let vertex = VERTEX_BYTES + sets as u64 * UV_BYTES + if self.buildings.is_empty() { 0 } else { BUILDING_BYTES };
        let saved = if self.has_no_rules { RULE_BYTES } else { 0 };
        let (saved, index) = match self.quantization {
            Some(_) => (saved + QUANTIZED_BYTES, INDEX_BYTES / 2),
            None => (saved, INDEX_BYTES),
        };
        self.add_bytes(vertices as u64 * (vertex - saved) + indices as u64 * index)
    }

    fn add_bytes(&mut self, bytes: u64) -> Flow {
        self.bytes += bytes;
        if MAX_BYTES < self.bytes { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// The primitive for a material without texture coordinates.
    #[inline]
    fn plain(&mut self, material: u32) -> &mut Primitive {
        self.primitives.plain(&mut self.looks, &self.numbers.table, material)
    }

    /// The primitive for a material on a rectangle or a box.
    fn primitive(&mut self, material: u32, uvs: &[SetMap]) -> &mut Primitive {
        if uvs.is_empty() {
            return self.plain(material);
        }
        let sets = SetMask::of(|set| uv_map::find(uvs, set).is_some());
        self.primitives.of(&mut self.looks, &self.numbers.table, material, sets)
    }

    fn add_mesh(&mut self, owner: Owner, material: u32, mesh: &Arc<Mesh>, placement: &DAffine3) {
        let Glb { origin, numbers, looks, primitives, flattener, single_sided, .. } = self;
        let sets = SetMask::of(|set| !mesh.uv_set(set).is_empty());
        let mut single_sided = single_sided.as_mut().filter(|_| mesh.is_closed() && 0.0 < mesh_volume(mesh, placement));
        if mesh.face_count() != 0 && has_one_material(mesh) {
            let shown = single_sided.map_or(material, |materials| materials.of(material, &mut numbers.table));
            let primitive = primitives.of(looks, &numbers.table, shown, sets);
            return flattener.whole(mesh, |flat| primitive.mesh(flat, mesh, placement, owner, *origin));
        }
        flattener.faces(mesh, placement, |face| {
            let shown = face.material(&mut numbers.table, material);
            let shown = single_sided.as_mut().map_or(shown, |materials| materials.of(shown, &mut numbers.table));
            primitives.of(looks, &numbers.table, shown, sets).face(&face, owner, *origin);
            true
        });
    }
}

impl Sink for Glb {
    fn begin(&mut self) {
        self.numbers.begin();
        self.parts.iter_mut().for_each(RepeatedParts::begin);
    }

    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        if !leaf.uvs().is_empty() {
            return leaf.pass_to(self);
        }
        let shape = leaf.shape;
        let placed = PlacedBox::of(shape).moved(-four(self.origin));
        match shape.form {
            Form::Rect(Axis::Z) => {
                let (rule, material) = self.numbers.filled(leaf);
                let owner = self.owner(rule);
                self.plain(material).quad(owner, placed, shape.axes.normals[0]);
                self.add(4, 6, 0)
            }
            Form::Box if self.single_sided.is_some() => leaf.pass_to(self),
            Form::Box => {
                let (rule, material) = self.numbers.filled(leaf);
                let owner = self.owner(rule);
                self.plain(material).cuboid(owner, &placed, shape.unit.get(), &shape.axes.normals);
                self.add(24, 36, 0)
            }
            Form::Rect(_) | Form::Empty | Form::Other => leaf.pass_to(self),
        }
    }

    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        if replay.has_uvs() {
            return replay.each(self);
        }
        if let Some(mut parts) = self.parts.take() {
            let flow = self.place_part(&mut parts, replay);
            self.parts = Some(parts);
            return flow;
        }
        if !replay.is_plain() || self.single_sided.is_some() {
            return replay.each(self);
        }
        let (mut leaf, origin) = (0, four(self.origin));
        for (filled, mark) in replay.marks() {
            let (rule, material) = self.numbers.with_look(&filled, mark.look);
            let leaves = leaf..leaf + mark.leaves;
            leaf = leaves.end;
            let owner = self.owner(rule);
            self.plain(material).repeat(owner, replay, leaves, origin);
        }
        self.add(replay.corner_count(), replay.corner_count() / 4 * 6, 0)
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        let (rule, material) = self.numbers.leaf(leaf);
        let (owner, placed) = (self.owner(rule), PlacedBox::from(quad).moved(-four(self.origin)));
        let primitive = self.primitive(material, leaf.uvs());
        primitive.quad(owner, placed, normals::of_quad(leaf, quad));
        primitive.uvs(leaf.uvs(), quad.corners().into_iter());
        self.add(4, 6, leaf.uvs().len())
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        let (rule, mut material) = self.numbers.leaf(leaf);
        let (owner, placed) = (self.owner(rule), PlacedBox::from(cuboid).moved(-four(self.origin)));
        if let Some(single_sided) = self.single_sided.as_mut().filter(|_| 0.0 < cuboid_volume(cuboid)) {
            material = single_sided.of(material, &mut self.numbers.table);
        }
        let primitive = self.primitive(material, leaf.uvs());
        primitive.cuboid(owner, &placed, cuboid.unit, &normals::of_cuboid(leaf, cuboid));
        primitive.uvs(leaf.uvs(), cuboid.face_corners());
        self.add(24, 36, leaf.uvs().len())
    }

    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let (rule, material) = self.numbers.leaf(leaf);
        let building = self.buildings.next();
        self.assets.add(mesh, rule, material, (*placement, building));
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let (rule, material) = self.numbers.leaf(leaf);
        self.add_mesh(self.owner(rule), material, mesh, placement);
        self.add(mesh.corners().len(), 3 * mesh.corners().len(), mesh.uv_numbers().count())
    }

    fn placement(&mut self, leaf: &Leaf<'_>) -> Flow {
        let building = self.buildings.next();
        let Some(placements) = &mut self.placements else { return ControlFlow::Continue(()) };
        let rule = self.numbers.table.rule(leaf.rule);
        placements.push((Owner { rule, building }, leaf.scope()));
        self.add_bytes(NODE_BYTES)
    }

    fn begin_building(&mut self, name: &str, seed: u64) {
        self.buildings.begin(name, seed);
    }

    fn end_building(&mut self, building: &dyn Fn() -> Building) {
        self.buildings.end(building());
    }

    fn keeps_tree(&self) -> bool {
        false
    }
}

/// An error for more bytes than the format allows.
fn check_size(bytes: u64) -> Result<(), WriteError> {
    if MAX_BYTES < bytes { Err(WriteError::TooLarge { what: "bytes", limit: u64::from(u32::MAX) }) } else { Ok(()) }
}
