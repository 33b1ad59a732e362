//! Triangle meshes for engines and renderers: separate lists of positions, normals, tangents and texture coordinates.

use std::collections::HashMap;
use std::ops::{ControlFlow, Range};
use std::sync::Arc;

use glam::{DAffine3, DVec2, DVec3, Vec2};

use super::flatten::{Flattener, has_one_material};
use super::leaf_numbers::Numbers;
use super::model::Model;
use super::normals;
use super::packed::PackedFaces;
use super::placed_assets::AssetList;
use super::sink_table::SinkTable;
use super::tangents::tangents;
use crate::fixed_hash::FixedState;
use crate::geometry::Axis;
use crate::geometry::each::Each;
use crate::geometry::mesh::Mesh;
use crate::geometry::uv_map;
use crate::material::layer::{self, Placement, SetMask};
use crate::material::{Layer, Material};
use crate::run::sink::corners::{PlacedBox, four};
use crate::run::sink::{Cuboid, Filled, Flow, Leaf, Quad, Sink};
use crate::shape::base::Form;
use crate::value::text::Text;

/// The division of a model into meshes. A mesh always has one material.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Granularity {
    /// A mesh for each material: the fewest draw calls.
    #[default]
    Material,
    /// A mesh for each building and material. A building is an initial shape; see [`Model::buildings`].
    Building,
    /// A mesh for each rule and material.
    Rule,
    /// A mesh for each leaf and material.
    Leaf,
}

/// The meshes of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Meshes {
    /// The point of the world, in metres, to which positions and places are relative: the origin, or for a model far
    /// from it a point near the model, because 32-bit floats are too coarse there.
    pub origin: DVec3,
    /// The meshes, in the order of their first leaf; meshes at several places follow.
    pub list: Vec<TriangleMesh>,
}

/// A mesh of one material. Faces share no vertices, and front faces are counter-clockwise.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TriangleMesh {
    /// The rule or leaf symbol of all leaves; `None` for a mesh with leaves of any rule.
    pub rule: Option<Text>,
    /// The index of the building of all leaves in [`Model::buildings`]; `None` for a mesh with leaves of any building, and for leaves that
    /// belong to none.
    pub building: Option<usize>,
    /// The material, with attributes of the asset where rules set none.
    pub material: Arc<Material>,
    /// A position for each vertex, in metres.
    pub positions: Vec<[f32; 3]>,
    /// A unit normal for each vertex.
    pub normals: Vec<[f32; 3]>,
    /// The direction of growing u of the normal map for each vertex, and in the fourth number 1 if v grows to its left,
    /// as seen from outside, otherwise −1. Empty without a normal map.
    pub tangents: Vec<[f32; 4]>,
    /// Texture coordinates by set, v upwards: empty, or a pair for each vertex. A layer of the material uses the set
    /// [`TriangleMesh::set_of`].
    pub uvs: [Vec<[f32; 2]>; 10],
    /// Three indices of vertices for each triangle.
    pub indices: Vec<u32>,
    /// The leaves, in the order of their triangles. A mesh with places has one leaf for each place.
    pub leaves: Vec<MeshLeaf>,
    /// The places of a mesh that is shown several times, each relative to [`Meshes::origin`]: an asset that rules
    /// insert. Empty for a mesh that is in its place.
    pub places: Vec<DAffine3>,
}

/// The triangles of a leaf.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshLeaf {
    /// The index of the leaf in [`Model::leaves`].
    pub leaf: usize,
    /// The range of its indices in [`TriangleMesh::indices`].
    pub indices: Range<usize>,
}

impl TriangleMesh {
    /// The set of texture coordinates of a layer of the material: the set with its own number, otherwise set 0. `None` if the
    /// mesh has neither.
    pub fn set_of(&self, layer: Layer) -> Option<usize> {
        layer::set(layer, SetMask::of(|set| !self.uvs[set].is_empty()))
    }
}

impl Meshes {
    /// The meshes, as in `list`.
    pub fn iter(&self) -> std::slice::Iter<'_, TriangleMesh> {
        self.list.iter()
    }
}

impl IntoIterator for Meshes {
    type Item = TriangleMesh;
    type IntoIter = std::vec::IntoIter<TriangleMesh>;

    fn into_iter(self) -> Self::IntoIter {
        self.list.into_iter()
    }
}

impl<'a> IntoIterator for &'a Meshes {
    type Item = &'a TriangleMesh;
    type IntoIter = std::slice::Iter<'a, TriangleMesh>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl Model {
    /// The model as triangle meshes. Assets that rules insert at several places become one mesh with a list of places.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::meshes::Granularity;
    /// use cga::Model;
    ///
    /// fn draw_calls(model: &Model) -> usize {
    ///     let meshes = model.meshes(Granularity::Material);
    ///     for mesh in &meshes {
    ///         assert_eq!(mesh.positions.len(), mesh.normals.len());
    ///     }
    ///     meshes.list.len()
    /// }
    /// assert_eq!(draw_calls(&Model::new()), 0);
    /// ```
    pub fn meshes(&self, granularity: Granularity) -> Meshes {
        let buildings = self.buildings().map(|(_, leaves)| leaves).collect();
        let mut sink = MeshSink { granularity, origin: self.near_origin(), buildings, ..MeshSink::default() };
        // It never stops the run.
        let _ = self.replay(&mut sink);
        sink.finish()
    }
}

/// The leaves of a mesh under construction have in common: material, sets of texture coordinates, and by granularity the
/// building, the rule or the leaf.
type MeshKey = (u32, SetMask, Option<usize>, Option<u32>, Option<usize>);

/// A mesh under construction.
#[derive(Debug, Default)]
struct MeshBuild {
    rule: Option<u32>,
    building: Option<usize>,
    material: u32,
    sets: SetMask,
    faces: PackedFaces,
    uvs: [Vec<[f32; 2]>; 10],
    leaves: Vec<MeshLeaf>,
    places: Vec<DAffine3>,
}

/// Collects the leaves of a model.
#[derive(Debug, Default)]
struct MeshSink {
    granularity: Granularity,
    origin: DVec3,
    numbers: Numbers,
    list: Vec<MeshBuild>,
    /// Only for look-ups, never iterated.
    by_key: HashMap<MeshKey, usize, FixedState>,
    assets: AssetList<usize>,
    flattener: Flattener,
    /// The number of leaves so far.
    leaf: usize,
    /// The ranges of leaves of buildings.
    buildings: Arc<[Range<usize>]>,
}

impl MeshSink {
    /// The number of the next leaf.
    fn next(&mut self) -> usize {
        self.leaf += 1;
        self.leaf - 1
    }

    /// The mesh for a leaf, and the start of the leaf's triangles.
    fn build(&mut self, rule: u32, material: u32, sets: SetMask, leaf: usize) -> &mut MeshBuild {
        let rule = matches!(self.granularity, Granularity::Rule | Granularity::Leaf).then_some(rule);
        let by_building = matches!(self.granularity, Granularity::Building | Granularity::Leaf);
        let building = by_building.then(|| building_of(&self.buildings, leaf)).flatten();
        let key = (material, sets, building, rule, (self.granularity == Granularity::Leaf).then_some(leaf));
        let list = &mut self.list;
        let index = *self.by_key.entry(key).or_insert_with(|| {
            list.push(MeshBuild { rule, building, material, sets, ..MeshBuild::default() });
            list.len() - 1
        });
        let build = &mut self.list[index];
        if build.leaves.last().is_none_or(|last| last.leaf != leaf) {
            let start = build.faces.index_count();
            build.leaves.push(MeshLeaf { leaf, indices: start..start });
        }
        build
    }

    /// Adds the faces of a mesh.
    fn add(&mut self, rule: u32, material: u32, mesh: &Arc<Mesh>, placement: &DAffine3, leaf: usize) {
        let sets = SetMask::of(|set| !mesh.uv_set(set).is_empty());
        let (mut flattener, origin) = (std::mem::take(&mut self.flattener), self.origin);
        if mesh.face_count() != 0 && has_one_material(mesh) {
            let build = self.build(rule, material, sets, leaf);
            flattener.whole(mesh, |flat| build.faces.mesh(flat, mesh, placement, origin));
            for set in sets.sets() {
                build.uvs[set].extend(mesh.uv_set(set).iter().map(|uv| uv.as_vec2().to_array()));
            }
            build.end();
            self.flattener = flattener;
            return;
        }
        flattener.faces(mesh, placement, |face| {
            let shown = face.material(&mut self.numbers.table, material);
            let build = self.build(rule, shown, sets, leaf);
            build.faces.face(&face, origin);
            for set in sets.sets() {
                build.uvs[set].extend(face.uvs(set).iter().map(|uv| uv.as_vec2().to_array()));
            }
            build.end();
            true
        });
        self.flattener = flattener;
    }

    fn finish(mut self) -> Meshes {
        let mut shared = Vec::new();
        for mut asset in std::mem::take(&mut self.assets).into_list() {
            let (own, single) = asset.shared_and_single();
            let (rule, material) = (asset.rule, asset.material);
            for (place, leaf) in single {
                self.add(rule, material, &asset.mesh, &place, leaf);
            }
            if own.is_empty() {
                continue;
            }
            let by_building = self.granularity == Granularity::Building;
            let buildings = self.buildings.clone();
            let is_together =
                |a: usize, b: usize| !by_building || building_of(&buildings, a) == building_of(&buildings, b);
            for own in own.chunk_by(|a, b| is_together(a.1, b.1)) {
                // Built in the mesh's own coordinates, apart from the others.
                let (numbers, granularity) = (std::mem::take(&mut self.numbers), self.granularity);
                let mut local = MeshSink { granularity, numbers, buildings: buildings.clone(), ..MeshSink::default() };
                local.add(rule, material, &asset.mesh, &DAffine3::IDENTITY, own[0].1);
                self.numbers = local.numbers;
                for mut build in local.list {
                    let whole = 0..build.faces.index_count();
                    let leaf = |leaf: usize| MeshLeaf { leaf, indices: whole.clone() };
                    let is_of_one = own.iter().all(|(_, leaf)| building_of(&buildings, *leaf) == build.building);
                    build.building = build.building.filter(|_| is_of_one);
                    build.leaves = own.iter().map(|(_, number)| leaf(*number)).collect();
                    let moved = |place: &DAffine3| DAffine3 { translation: place.translation - self.origin, ..*place };
                    build.places = own.iter().map(|(place, _)| moved(place)).collect();
                    shared.push(build);
                }
            }
        }
        let MeshSink { list, numbers, origin, .. } = self;
        let all = list.into_iter().chain(shared).filter(|build| build.faces.index_count() != 0);
        Meshes { origin, list: all.map(|build| build.into_mesh(&numbers.table)).collect() }
    }
}

impl MeshBuild {
    /// Ends the triangles of the last leaf.
    fn end(&mut self) {
        let end = self.faces.index_count();
        if let Some(last) = self.leaves.last_mut() {
            last.indices.end = end;
        }
    }

    /// Adds the texture coordinates of the last vertices, four for each face, from their points in the world.
    fn uvs(&mut self, leaf: &Leaf<'_>, points: impl Iterator<Item = DVec3> + Clone) {
        for set in self.sets.sets() {
            if let Some(maps) = uv_map::find(leaf.uvs(), set) {
                let uv = |(corner, point)| maps.of_face(corner / 4).at(point).as_vec2().to_array();
                self.uvs[set].extend(points.clone().enumerate().map(uv));
            }
        }
    }

    fn into_mesh(self, table: &SinkTable) -> TriangleMesh {
        let material = table.materials()[self.material as usize].clone();
        let set = layer::set(Layer::Normal, self.sets).filter(|_| layer::image(&material, Layer::Normal).is_some());
        let tangents = set.map_or_else(Vec::new, |set| {
            let (map, uvs) = (Placement::of(&material, Layer::Normal).map(), &self.uvs[set]);
            let uv = |at: usize| -> Vec2 {
                let [u, v] = uvs[at].each(f64::from);
                map.at(DVec2::new(u, v)).as_vec2()
            };
            let triangles = self.faces.triangles();
            tangents(triangles.vertices.items(), triangles.indices.items(), uv)
        });
        let vertices = self.faces.vertex_count();
        let [mut positions, mut normals] = [(); 2].map(|()| Vec::with_capacity(vertices));
        let mut indices = Vec::with_capacity(self.faces.index_count());
        let Ok(()) = self.faces.positions(&mut positions);
        let Ok(()) = self.faces.normals(&mut normals);
        let Ok(()) = self.faces.indices(&mut indices);
        TriangleMesh {
            rule: self.rule.map(|rule| table.rules()[rule as usize].clone()),
            building: self.building,
            material,
            positions,
            normals,
            tangents,
            indices,
            uvs: self.uvs,
            leaves: self.leaves,
            places: self.places,
        }
    }
}

impl Sink for MeshSink {
    fn begin(&mut self) {
        self.numbers.begin();
    }

    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        let shape = leaf.shape;
        let is_box = match shape.form {
            Form::Rect(Axis::Z) => false,
            Form::Box => true,
            Form::Rect(_) | Form::Empty | Form::Other => return leaf.pass_to(self),
        };
        if !leaf.uvs().is_empty() {
            return leaf.pass_to(self);
        }
        let ((rule, material), number) = (self.numbers.filled(leaf), self.next());
        let placed = PlacedBox::of(shape).moved(-four(self.origin));
        let build = self.build(rule, material, SetMask::default(), number);
        match is_box {
            true => build.faces.cuboid(&placed, shape.unit.get(), &shape.axes.normals),
            false => build.faces.quad(&placed, shape.axes.normals[0]),
        }
        build.end();
        ControlFlow::Continue(())
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        let ((rule, material), number) = (self.numbers.leaf(leaf), self.next());
        let placed = PlacedBox::from(quad).moved(-four(self.origin));
        let build = self.build(rule, material, sets(leaf), number);
        build.faces.quad(&placed, normals::of_quad(leaf, quad));
        build.uvs(leaf, quad.corners().into_iter());
        build.end();
        ControlFlow::Continue(())
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        let ((rule, material), number) = (self.numbers.leaf(leaf), self.next());
        let placed = PlacedBox::from(cuboid).moved(-four(self.origin));
        let build = self.build(rule, material, sets(leaf), number);
        build.faces.cuboid(&placed, cuboid.unit, &normals::of_cuboid(leaf, cuboid));
        build.uvs(leaf, cuboid.face_corners());
        build.end();
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let ((rule, material), number) = (self.numbers.leaf(leaf), self.next());
        self.add(rule, material, mesh, placement, number);
        ControlFlow::Continue(())
    }

    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let ((rule, material), number) = (self.numbers.leaf(leaf), self.next());
        self.assets.add(mesh, rule, material, (*placement, number));
        ControlFlow::Continue(())
    }

    fn placement(&mut self, _: &Leaf<'_>) -> Flow {
        // Its number belongs to no mesh.
        self.next();
        ControlFlow::Continue(())
    }
}

/// The building of a leaf, if it has one, by the ranges of the buildings' leaves.
fn building_of(buildings: &[Range<usize>], leaf: usize) -> Option<usize> {
    let building = buildings.partition_point(|leaves| leaves.end <= leaf);
    buildings.get(building)?.contains(&leaf).then_some(building)
}

/// The sets of a rectangle or a box.
fn sets(leaf: &Leaf<'_>) -> SetMask {
    SetMask::of(|set| uv_map::find(leaf.uvs(), set).is_some())
}
