//! Vertex and index buffers for a graphics card.
//!
//! A vertex is six `f32`: position, then unit normal. Faces do not share vertices: a quad has 4 vertices and 2
//! triangles, a box 24 and 12. Coordinates are computed as `f64` and rounded at the end. Front faces are
//! counter-clockwise. Texture coordinates are separate lists beside the vertices, one for each set.

mod buildings;
mod chunk_result;
mod chunks;
mod replayed;
pub(crate) mod size;
mod submesh;
mod uvs;

pub use super::triangles::Vertex;
pub use chunk_result::ChunkResult;
pub use chunks::Chunks;
pub use size::BufferSize;
pub use submesh::Submesh;

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DAffine3, DVec3, DVec4};

use self::buildings::Buildings;
use self::replayed::{Marks, Replayed};
use self::submesh::SubmeshStart;
use self::uvs::UvLists;
use super::error::WriteError;
use super::flatten::{Flattener, PlacedFace, has_one_material};
use super::leaf_numbers::Numbers;
use super::normals;
use super::room::Room;
use super::triangles::{Triangles, marked, write_box, write_quad};
use crate::geometry::Axis;
use crate::geometry::mesh::Mesh;
use crate::material::Material;
use crate::run::building::Building;
use crate::run::sink::corners::{PlacedBox, four};
use crate::run::sink::{Cuboid, Filled, Flow, Leaf, Quad, Replay, Sink};
use crate::shape::base::Form;
use crate::shape::texture::SETS;
use crate::value::text::Text;

/// Collects leaves as triangles. It can be cleared and used again without releasing its memory.
#[derive(Clone, Debug)]
pub struct Buffers {
    triangles: Triangles,
    uvs: UvLists,
    runs: Vec<SubmeshStart>,
    numbers: Numbers,
    replayed: Replayed,
    /// The rule and the material of the last leaf that fills its scope, unless another leaf came after it.
    last: Option<(u32, u32)>,
    /// With a fourth coordinate of 0.
    origin: DVec4,
    limit: usize,
    full: bool,
    flattener: Flattener,
    /// The buildings, if they are recorded.
    buildings: Option<Buildings>,
}

impl PartialEq for Buffers {
    /// Compares vertices, indices, texture coordinates and submeshes with their rules and materials, the origins and the buildings.
    fn eq(&self, other: &Self) -> bool {
        self.vertices() == other.vertices()
            && self.indices() == other.indices()
            && (0..SETS).all(|set| self.uv_set(set) == other.uv_set(set))
            && self.submeshes().eq(other.submeshes())
            && self.rules() == other.rules()
            && self.materials() == other.materials()
            && self.origin() == other.origin()
            && self.buildings().eq(other.buildings())
    }
}

impl Default for Buffers {
    fn default() -> Self {
        Buffers::with_capacity(0, 0)
    }
}

impl Buffers {
    /// Empty buffers.
    pub fn new() -> Self {
        Buffers::default()
    }

    /// Empty buffers with room for numbers of vertices and indices.
    pub fn with_capacity(vertices: usize, indices: usize) -> Self {
        Buffers {
            triangles: Triangles { vertices: Room::with_capacity(vertices), indices: Room::with_capacity(indices) },
            uvs: UvLists::default(),
            runs: Vec::new(),
            numbers: Numbers::default(),
            replayed: Replayed::default(),
            last: None,
            origin: DVec4::ZERO,
            limit: u32::MAX as usize,
            full: false,
            flattener: Flattener::default(),
            buildings: None,
        }
    }

    /// Subtracts a point of the world, in metres, from every position before it is rounded. Far from the world's
    /// origin (map coordinates) `f32` alone is too coarse.
    pub fn with_origin(mut self, origin: DVec3) -> Self {
        self.origin = four(origin);
        self
    }

    /// Ends the run at the first leaf that would exceed this number of vertices. The largest limit is `u32::MAX`.
    pub fn with_limit(mut self, vertices: usize) -> Self {
        self.limit = vertices.min(u32::MAX as usize);
        self
    }

    /// Removes the contents but keeps memory, origin and limit.
    pub fn clear(&mut self) {
        self.triangles.vertices.clear();
        self.triangles.indices.clear();
        self.uvs.clear();
        self.runs.clear();
        self.numbers.clear();
        self.replayed = Replayed::default();
        self.last = None;
        self.full = false;
        self.buildings.iter_mut().for_each(Buildings::clear);
    }

    /// The vertices.
    pub fn vertices(&self) -> &[Vertex] {
        self.triangles.vertices.items()
    }

    /// The indices, three for each triangle.
    pub fn indices(&self) -> &[u32] {
        self.triangles.indices.items()
    }

    /// The texture coordinates of set 0, one pair for each vertex, v upwards. The list is empty if no geometry has
    /// any. A vertex without coordinates has (0, 0).
    pub fn uvs(&self) -> &[[f32; 2]] {
        self.uv_set(0)
    }

    /// The texture coordinates of a set, 0 to 9, in the form of [`Buffers::uvs`]. A material shows each of its maps
    /// in the set with the number of the [`Layer`](crate::material::Layer), or in set 0 where that is empty.
    pub fn uv_set(&self, set: usize) -> &[[f32; 2]] {
        self.uvs.get(set)
    }

    /// The point that was subtracted from all positions.
    pub fn origin(&self) -> DVec3 {
        self.origin.truncate()
    }

    /// The submeshes, in order. Together they cover all triangles.
    pub fn submeshes(&self) -> impl ExactSizeIterator<Item = Submesh> + '_ {
        self.runs.iter().enumerate().map(|(i, run)| {
            let (index, vertex) = match self.runs.get(i + 1) {
                Some(next) => (next.index(), next.vertex as usize),
                None => (self.triangles.indices.len(), self.triangles.vertices.len()),
            };
            Submesh {
                rule: run.rule,
                material: run.material,
                indices: run.index()..index,
                vertices: run.vertex as usize..vertex,
            }
        })
    }

    /// The rule names by number.
    pub fn rules(&self) -> &[Text] {
        self.numbers.table.rules()
    }

    /// The materials by number.
    pub fn materials(&self) -> &[Arc<Material>] {
        self.numbers.table.materials()
    }

    /// The number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles.indices.len() / 3
    }

    /// Checks that no leaf is missing because of the limit.
    ///
    /// # Errors
    /// [`WriteError::TooLarge`] with the limit.
    pub fn check(&self) -> Result<(), WriteError> {
        match self.full {
            true => Err(WriteError::TooLarge { what: "vertices", limit: self.limit as u64 }),
            false => Ok(()),
        }
    }

    /// Starts a new submesh unless the last one continues.
    #[inline]
    fn run(&mut self, rule: u32, material: u32) {
        let Triangles { vertices, indices } = &self.triangles;
        let next = SubmeshStart { rule, material, triangle: indices.len() as u32 / 3, vertex: vertices.len() as u32 };
        if !self.runs.last().is_some_and(|last| last.is_like(&next)) {
            self.runs.push(next);
        }
    }

    fn leaf(&mut self, leaf: &Leaf<'_>) {
        self.last = None;
        let (rule, material) = self.numbers.leaf(leaf);
        self.run(rule, material);
    }

    /// Returns true if a leaf with that number of vertices has the rule and the material of the last one, and there
    /// is room for it.
    #[inline(always)]
    fn goes_on(&self, leaf: &Filled<'_>, vertices: usize) -> bool {
        self.last == Some((leaf.rule, leaf.shape.look.get().0))
            && vertices <= self.limit - self.triangles.vertices.len()
            && self.triangles.vertices.has(vertices)
            && self.triangles.indices.has(vertices / 4 * 6)
            && self.uvs.is_empty()
    }

    /// Writes a leaf that does not continue the last submesh, or needs memory. A separate function, so that the fast
    /// path needs fewer registers.
    #[inline(never)]
    fn other(&mut self, leaf: &Filled<'_>, vertices: usize) -> Flow {
        self.room(vertices)?;
        self.triangles.vertices.reserve(vertices);
        self.triangles.indices.reserve(vertices / 4 * 6);
        let (rule, material) = self.numbers.filled(leaf);
        let (uvs, start) = (leaf.uvs(), self.triangles.vertices.len());
        // A leaf that continues the submesh has the same number, so it has no coordinates either.
        self.last = if uvs.is_empty() { leaf.material_number().map(|material| (leaf.rule, material)) } else { None };
        self.run(rule, material);
        let block = (leaf.shape.form == Form::Box).then(|| leaf.shape.unit.get());
        match block {
            Some(_) => self.write_block(leaf),
            None => self.write_rectangle(leaf),
        }
        if !uvs.is_empty() {
            self.uvs.place(uvs, &PlacedBox::of(leaf.shape), block, start);
        }
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    #[cold]
    #[inline(never)]
    fn pass(&mut self, leaf: &Filled<'_>) -> Flow {
        leaf.pass_to(self)
    }

    #[inline(never)]
    fn rectangle(&mut self, leaf: &Filled<'_>) -> Flow {
        if !self.goes_on(leaf, 4) {
            return self.other(leaf, 4);
        }
        self.write_rectangle(leaf);
        ControlFlow::Continue(())
    }

    #[inline(never)]
    fn block(&mut self, leaf: &Filled<'_>) -> Flow {
        if !self.goes_on(leaf, 24) {
            return self.other(leaf, 24);
        }
        self.write_block(leaf);
        ControlFlow::Continue(())
    }

    #[inline(always)]
    fn write_rectangle(&mut self, leaf: &Filled<'_>) {
        self.triangles.quad(PlacedBox::of(leaf.shape).moved(-self.origin), leaf.shape.axes.normals[0]);
    }

    #[inline(always)]
    fn write_block(&mut self, leaf: &Filled<'_>) {
        let placed = PlacedBox::of(leaf.shape).moved(-self.origin);
        self.triangles.cuboid(&placed, leaf.shape.unit.get(), &leaf.shape.axes.normals);
    }

    #[cold]
    #[inline(never)]
    fn each(&mut self, replay: &Replay<'_>) -> Flow {
        replay.each(self)
    }

    /// Writes the leaves of a part that repeats, for which there is room.
    #[inline(never)]
    fn repeat(&mut self, replay: &Replay<'_>, count: usize) -> Flow {
        let start = self.triangles.vertices.len() as u32;
        self.mark_all(replay, start);
        let (place, origin) = (replay.origin(), self.origin);
        let mut faces = self.triangles.quads(count / 4);
        for (row, axes, placed, records) in replay.rows() {
            let each = if row.is_box { 6 } else { 1 };
            let (own, rest) = faces.split_at_mut(each * placed.len());
            faces = rest;
            if row.is_box {
                for ((to, placed), record) in own.as_chunks_mut::<6>().0.iter_mut().zip(placed).zip(records) {
                    write_box(to, &placed.moved(place).moved(-origin), record.unit, &axes.normals);
                }
            } else {
                let normal = axes.normals[0];
                let place = marked(place, normal);
                for (to, placed) in own.iter_mut().zip(placed) {
                    write_quad(to, &placed.moved(place).moved(-origin), normal);
                }
            }
        }
        if replay.has_uvs() {
            self.uvs.replay(replay, start as usize, count);
        }
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    /// Records the rules and materials of leaves that repeat.
    #[inline]
    fn mark_all(&mut self, replay: &Replay<'_>, start: u32) {
        self.last = None;
        let triangle = self.triangles.indices.len() / 3;
        let Marks { is_distinct, runs: marks, .. } = self.replayed.of(replay, &mut self.numbers);
        let runs = &mut self.runs;
        let moved = |run: &SubmeshStart| run.moved(triangle as u32, start);
        if *is_distinct {
            let goes_on = marks.first().zip(runs.last()).is_some_and(|(first, last)| first.is_like(last));
            runs.extend(marks[usize::from(goes_on)..].iter().map(moved));
        } else {
            for next in marks {
                if !runs.last().is_some_and(|last| last.is_like(next)) {
                    runs.push(moved(next));
                }
            }
        }
    }

    /// `Break` if `more` vertices do not fit.
    #[inline]
    fn room(&mut self, more: usize) -> Flow {
        if self.limit - self.triangles.vertices.len() < more {
            self.full = true;
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }

    /// Adds triangles of a face of a leaf with a rule and a material; see [`Triangles::face`].
    fn face(
        &mut self,
        face: &PlacedFace<'_>,
        (rule, material): (u32, u32),
        corners: impl ExactSizeIterator<Item = usize> + Clone,
        triangles: &[[u32; 3]],
    ) {
        let shown = face.material(&mut self.numbers.table, material);
        self.run(rule, shown);
        let start = self.triangles.vertices.len();
        self.triangles.face(face, self.origin.truncate(), corners.clone(), triangles);
        self.uvs.face(face, corners, start);
    }

    #[inline]
    fn pad_uvs(&mut self) {
        if !self.uvs.is_empty() {
            self.uvs.pad(self.triangles.vertices.len());
        }
    }
}

impl Sink for Buffers {
    fn begin_building(&mut self, name: &str, seed: u64) {
        let at = self.end();
        self.buildings.iter_mut().for_each(|buildings| buildings.begin(name, seed, at));
    }

    fn end_building(&mut self, building: &dyn Fn() -> Building) {
        let end = self.end();
        self.buildings.iter_mut().for_each(|buildings| buildings.end(building(), end));
    }

    fn begin(&mut self) {
        self.numbers.begin();
        self.last = None;
    }

    #[inline]
    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        match leaf.shape.form {
            Form::Rect(Axis::Z) => self.rectangle(leaf),
            Form::Box => self.block(leaf),
            Form::Rect(_) | Form::Empty | Form::Other => self.pass(leaf),
        }
    }

    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        let count = replay.corner_count();
        if !replay.is_plain() || self.limit - self.triangles.vertices.len() < count {
            return self.each(replay);
        }
        self.repeat(replay, count)
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.room(4)?;
        self.leaf(leaf);
        let (normal, start) = (normals::of_quad(leaf, quad), self.triangles.vertices.len());
        self.triangles.quad(PlacedBox::from(quad).moved(-self.origin), normal);
        self.uvs.place(leaf.uvs(), &PlacedBox::from(quad), None, start);
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.room(24)?;
        self.leaf(leaf);
        let (normals, start) = (normals::of_cuboid(leaf, cuboid), self.triangles.vertices.len());
        self.triangles.cuboid(&PlacedBox::from(cuboid).moved(-self.origin), cuboid.unit, &normals);
        self.uvs.place(leaf.uvs(), &PlacedBox::from(cuboid), Some(cuboid.unit), start);
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        // A face with holes may have more triangles than vertices, but less than twice the number.
        let corners = mesh.corners().len();
        self.full |= u32::MAX as usize - self.triangle_count() < 2 * corners;
        self.room(corners)?;
        if self.full {
            return ControlFlow::Break(());
        }
        self.last = None;
        let numbers = self.numbers.leaf(leaf);
        if corners != 0 && has_one_material(mesh) {
            let start = self.triangles.vertices.len();
            self.run(numbers.0, numbers.1);
            let Buffers { flattener, triangles, origin, .. } = self;
            flattener.whole(mesh, |flat| triangles.mesh(flat, mesh, placement, origin.truncate()));
            self.uvs.mesh(mesh, start);
        } else {
            let mut flattener = std::mem::take(&mut self.flattener);
            flattener.faces(mesh, placement, |face| {
                self.face(&face, numbers, face.corners.clone(), face.triangles);
                true
            });
            self.flattener = flattener;
        }
        self.pad_uvs();
        ControlFlow::Continue(())
    }
}
