//! Vertex and index buffers for a graphics card.
//!
//! A vertex is six `f32`: position, then unit normal. Vertices are not shared between faces: a quad takes 4 and two
//! triangles, a box 24 and twelve. Coordinates are computed as `f64` and rounded last. Front faces are counter-clockwise.

mod chunks;

pub use chunks::Chunks;

use std::ops::{ControlFlow, Range};
use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3, Vec4};

use super::error::WriteError;
use super::flatten::{FlatFace, Flattener, corner_point, normal_map, unit};
use super::room::Room;
use super::table::Table;
use super::{Cuboid, Filled, Flow, Leaf, Quad, Replay, Sink};
use crate::material::Material;
use crate::material::ids::MaterialId;
use crate::mesh::Mesh;
use crate::scope::Axis;
use crate::shape::axes::Axes;
use crate::shape::base::Form;

/// Position x, y, z and normal x, y, z.
pub type Vertex = [f32; 6];

/// Collects leaves as triangles. Can be cleared and used again without giving memory back.
#[derive(Debug)]
pub struct Buffers {
    vertices: Room<Vertex>,
    indices: Room<u32>,
    /// One a vertex, or empty as long as nothing had any.
    uvs: Vec<[f32; 2]>,
    runs: Vec<Run>,
    table: Table,
    origin: DVec3,
    limit: usize,
    full: bool,
    flattener: Flattener,
    ids: Ids,
}

/// The numbers of the run under way as numbers of the table.
#[derive(Debug, Default)]
struct Ids {
    rules: Vec<u32>,
    materials: Vec<u32>,
    /// Rule and material of the last leaf that fills its scope, unless another leaf came after it.
    last: Option<(u32, u32)>,
    /// Parts that were replayed, each at the place that its number gives.
    replayed: [Marks; PARTS_KNOWN],
}

/// The marks of a part that repeats, as numbers of the table.
#[derive(Debug, Default)]
struct Marks {
    part: (u64, usize),
    /// True if no two after each other are equal.
    is_distinct: bool,
    marks: Vec<(u32, u32)>,
}

/// Parts that repeat whose marks are known.
const PARTS_KNOWN: usize = 32;

/// Not yet known.
const UNKNOWN: u32 = u32::MAX;

impl Ids {
    /// Finds a number, or asks for it and keeps it.
    #[inline]
    fn find(list: &mut Vec<u32>, number: u32, ask: impl FnOnce() -> u32) -> u32 {
        let at = number as usize;
        if list.len() <= at {
            list.resize(at + 1, UNKNOWN);
        }
        if list[at] == UNKNOWN {
            list[at] = ask();
        }
        list[at]
    }
}

/// Consecutive triangles with one rule and one material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Counts in [`Buffers::rules`].
    pub rule: u32,
    /// Counts in [`Buffers::materials`].
    pub material: u32,
    /// Its indices.
    pub indices: Range<usize>,
    /// The vertices those name, and no others do.
    pub vertices: Range<usize>,
}

/// Where a part starts; it ends where the next one does.
#[derive(Clone, Copy, Debug)]
struct Run {
    rule: u32,
    material: u32,
    index: usize,
    vertex: u32,
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

    /// Empty buffers with room for this many vertices and indices.
    pub fn with_capacity(vertices: usize, indices: usize) -> Self {
        Buffers {
            vertices: Room::with_capacity(vertices),
            indices: Room::with_capacity(indices),
            uvs: Vec::new(),
            runs: Vec::new(),
            table: Table::new(),
            origin: DVec3::ZERO,
            limit: u32::MAX as usize,
            full: false,
            flattener: Flattener::default(),
            ids: Ids::default(),
        }
    }

    /// Subtracts a point of the world, in metres, from every position before it is rounded. Far from the world's
    /// origin (map coordinates) `f32` alone is not fine enough.
    pub fn with_origin(mut self, origin: DVec3) -> Self {
        self.origin = origin;
        self
    }

    /// Ends the run once there would be more than this many vertices. Never more than a `u32` can count.
    pub fn with_limit(mut self, vertices: usize) -> Self {
        self.limit = vertices.min(u32::MAX as usize);
        self
    }

    /// Forgets the contents, keeps memory, origin and limit.
    pub fn clear(&mut self) {
        self.vertices.clear();
        self.indices.clear();
        self.uvs.clear();
        self.runs.clear();
        self.table.clear();
        self.begin();
        self.ids.replayed.iter_mut().for_each(|known| known.part = (0, 0));
        self.full = false;
    }

    /// The vertices.
    pub fn vertices(&self) -> &[Vertex] {
        self.vertices.items()
    }

    /// Three a triangle.
    pub fn indices(&self) -> &[u32] {
        self.indices.items()
    }

    /// Texture coordinates, one pair a vertex, v upwards; empty when no geometry has any, (0, 0) where it has none.
    pub fn uvs(&self) -> &[[f32; 2]] {
        &self.uvs
    }

    /// The point that was subtracted from all positions.
    pub fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The parts, in order; together they are everything.
    pub fn parts(&self) -> impl ExactSizeIterator<Item = Part> + '_ {
        self.runs.iter().enumerate().map(|(i, run)| {
            let (index, vertex) = match self.runs.get(i + 1) {
                Some(next) => (next.index, next.vertex as usize),
                None => (self.indices.len(), self.vertices.len()),
            };
            Part {
                rule: run.rule,
                material: run.material,
                indices: run.index..index,
                vertices: run.vertex as usize..vertex,
            }
        })
    }

    /// Rule names by number.
    pub fn rules(&self) -> &[&'static str] {
        self.table.rules()
    }

    /// Materials by number.
    pub fn materials(&self) -> &[Arc<Material>] {
        self.table.materials()
    }

    /// How many triangles there are.
    pub fn triangle_count(&self) -> usize {
        self.indices.len() / 3
    }

    /// Whether everything that was handed over is in here.
    pub fn check(&self) -> Result<(), WriteError> {
        match self.full {
            true => Err(WriteError::TooLarge { what: "vertices", limit: self.limit as u64 }),
            false => Ok(()),
        }
    }

    /// Starts a new part unless the last one goes on.
    #[inline]
    fn run(&mut self, rule: u32, material: u32) {
        self.run_at(rule, material, self.indices.len(), self.vertices.len() as u32);
    }

    #[inline]
    fn run_at(&mut self, rule: u32, material: u32, index: usize, vertex: u32) {
        match self.runs.last() {
            Some(last) if last.rule == rule && last.material == material => {}
            _ => {
                let run = Run { rule, material, index, vertex };
                self.runs.push(run);
            }
        }
    }

    fn leaf(&mut self, leaf: &Leaf<'_>) {
        self.ids.last = None;
        let rule = self.table.rule(leaf.rule);
        let material = self.table.material(leaf.material);
        self.run(rule, material);
    }

    /// Notes rule and material of a leaf that fills its scope.
    #[inline(always)]
    fn mark(&mut self, leaf: &Filled<'_>) {
        if self.ids.last != Some((leaf.rule, leaf.shape.material.get().0)) {
            self.mark_other(leaf);
        }
    }

    #[inline(never)]
    fn mark_other(&mut self, leaf: &Filled<'_>) {
        let (rule, material) = self.numbers(leaf, leaf.shape.material.get());
        self.ids.last = leaf.material_number().map(|material| (leaf.rule, material));
        self.run(rule, material);
    }

    /// The numbers of the rule of a leaf and of a material in the table.
    #[inline]
    fn numbers(&mut self, leaf: &Filled<'_>, material: MaterialId) -> (u32, u32) {
        let Buffers { table, ids, .. } = self;
        let rule = Ids::find(&mut ids.rules, leaf.rule, || table.rule(leaf.rule()));
        let material = if material == MaterialId::OF_BASE {
            table.material(leaf.of_id(material))
        } else {
            Ids::find(&mut ids.materials, material.0, || table.material(leaf.of_id(material)))
        };
        (rule, material)
    }

    #[cold]
    #[inline(never)]
    fn pass(&mut self, leaf: &Filled<'_>) -> Flow {
        leaf.pass_to(self)
    }

    #[inline(never)]
    fn rectangle(&mut self, leaf: &Filled<'_>) -> Flow {
        let Some(start) = self.room(4) else { return ControlFlow::Break(()) };
        self.mark(leaf);
        let axes = &leaf.shape.axes.matrix;
        let sides = [axes.x_axis * leaf.shape.size.x, axes.y_axis * leaf.shape.size.y];
        self.write_quad(start, leaf.shape.origin - self.origin, sides, leaf.shape.axes.normals[0]);
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    #[inline(never)]
    fn block(&mut self, leaf: &Filled<'_>) -> Flow {
        let Some(start) = self.room(24) else { return ControlFlow::Break(()) };
        self.mark(leaf);
        let axes = &leaf.shape.axes.matrix;
        let sides = DMat3::from_cols(
            axes.x_axis * leaf.shape.size.x,
            axes.y_axis * leaf.shape.size.y,
            axes.z_axis * leaf.shape.size.z,
        );
        let cuboid = Cuboid { origin: leaf.shape.origin - self.origin, sides, unit: leaf.shape.unit };
        self.write_box(start, &cuboid, &leaf.shape.axes.normals);
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    /// Writes leaves of a part that repeats, for which there is room.
    #[inline(never)]
    fn repeat(&mut self, replay: &Replay<'_>, count: usize) {
        let (start, first_index) = (self.vertices.len() as u32, self.indices.len());
        self.mark_all(replay, start, first_index);
        write_quad_indices(self.indices.take(count / 4 * 6), start);
        let base = replay.origin() - self.origin;
        let (mut faces, _) = self.vertices.take(count).as_chunks_mut::<4>();
        for (row, axes, placed, records) in replay.rows() {
            let each = if row.is_box { 6 } else { 1 };
            let (own, rest) = faces.split_at_mut(each * placed.len());
            faces = rest;
            if row.is_box {
                for ((to, placed), record) in own.as_chunks_mut::<6>().0.iter_mut().zip(placed).zip(records) {
                    let cuboid = Cuboid { origin: base + placed.origin, sides: placed.sides, unit: record.unit };
                    write_box(to, &cuboid, &axes.normals);
                }
            } else {
                let normal = axes.normals[0];
                for (to, placed) in own.iter_mut().zip(placed) {
                    let a = base + placed.origin;
                    let (b, d) = (a + placed.sides.x_axis, a + placed.sides.y_axis);
                    write_face(to, [four(a), four(b), four(b + placed.sides.y_axis), four(d)], normal);
                }
            }
        }
    }

    /// Finds the numbers of rules and materials of a part that repeats.
    #[cold]
    #[inline(never)]
    fn find_marks(&mut self, replay: &Replay<'_>, place: usize) {
        let mut marks = std::mem::take(&mut self.ids.replayed[place].marks);
        marks.clear();
        marks.extend(replay.marks().iter().map(|mark| self.numbers(&replay.leaf_of(*mark), mark.material)));
        // The material of a base is another one for the next base.
        let is_known = replay.marks().iter().all(|mark| mark.material != MaterialId::OF_BASE);
        let is_distinct = marks.windows(2).all(|pair| pair[0] != pair[1]);
        let part = if is_known { replay.number() } else { (0, 0) };
        self.ids.replayed[place] = Marks { part, is_distinct, marks };
    }

    /// Notes rules and materials of leaves that repeat.
    #[inline]
    fn mark_all(&mut self, replay: &Replay<'_>, start: u32, first_index: usize) {
        let number = replay.number();
        let place = (number.0 as usize ^ number.1) % PARTS_KNOWN;
        if self.ids.replayed[place].part != number {
            self.find_marks(replay, place);
        }
        self.ids.last = None;
        let Buffers { ids, runs, .. } = self;
        let Marks { is_distinct, marks: numbers, .. } = &ids.replayed[place];
        let new = replay.marks().iter().zip(numbers).map(|(mark, &(rule, material))| Run {
            rule,
            material,
            index: first_index + mark.corners as usize / 4 * 6,
            vertex: start + mark.corners,
        });
        let goes_on = |last: &Run, next: &Run| (last.rule, last.material) == (next.rule, next.material);
        if *is_distinct {
            let first = numbers.first().zip(runs.last());
            let skip = first.is_some_and(|(first, last)| *first == (last.rule, last.material));
            runs.extend(new.skip(usize::from(skip)));
        } else {
            new.for_each(|next| {
                if !runs.last().is_some_and(|last| goes_on(last, &next)) {
                    runs.push(next);
                }
            });
        }
    }

    /// Writes a rectangle with that first corner and those sides.
    #[inline(always)]
    fn write_quad(&mut self, start: u32, a: DVec3, [u, v]: [DVec3; 2], normal: [f32; 3]) {
        let b = a + u;
        if let Some(to) = self.vertices.take(4).first_chunk_mut::<4>() {
            write_face(to, [four(a), four(b), four(b + v), four(a + v)], normal);
        }
        if let Some(to) = self.indices.take(6).first_chunk_mut::<6>() {
            *to = [start, start + 1, start + 2, start, start + 2, start + 3];
        }
    }

    /// Writes a box; `normals` are those of its sides.
    #[inline(always)]
    fn write_box(&mut self, start: u32, cuboid: &Cuboid, normals: &[[f32; 3]; 6]) {
        let (faces, _) = self.vertices.take(24).as_chunks_mut::<4>();
        if let Some(to) = faces.first_chunk_mut::<6>() {
            write_box(to, cuboid, normals);
        }
        write_quad_indices(self.indices.take(36), start);
    }

    /// The number of the next vertex, if `more` of them fit.
    #[inline]
    fn room(&mut self, more: usize) -> Option<u32> {
        let start = self.vertices.len();
        if self.limit - start < more {
            self.full = true;
            return None;
        }
        Some(start as u32)
    }

    /// Adds a vertex for a corner of a face.
    #[inline]
    fn corner(&mut self, mesh: &Mesh, placement: &DAffine3, turn: &DMat3, face: &FlatFace<'_>, corner: usize) {
        let point = placement.transform_point3(corner_point(mesh, corner)) - self.origin;
        let normal = mesh.normals.get(corner).map_or(face.normal, |&n| unit(*turn * n));
        self.vertices.push(vertex(short(point), short(normal)));
        if let Some(uv) = mesh.uvs().get(corner) {
            self.uvs.push([uv.x as f32, uv.y as f32]);
        }
    }

    #[inline]
    fn pad_uvs(&mut self) {
        if !self.uvs.is_empty() {
            self.uvs.resize(self.vertices.len(), [0.0; 2]);
        }
    }
}

/// A corner, rounded.
#[inline(always)]
fn four(p: DVec3) -> Vec4 {
    Vec4::new(p.x as f32, p.y as f32, p.z as f32, 0.0)
}

/// Writes the faces of a box; `normals` are those of its sides.
#[inline(always)]
fn write_box(to: &mut [[Vertex; 4]; 6], cuboid: &Cuboid, normals: &[[f32; 3]; 6]) {
    // Each corner is rounded once, so the three faces that meet there agree. Whole vectors are stored and loaded: parts of
    // one would have to wait for each other.
    let (o, [x, y, z]) = (cuboid.origin, [cuboid.sides.x_axis, cuboid.sides.y_axis, cuboid.sides.z_axis]);
    let (p, q) = (o + y, o + z);
    let r = p + z;
    let corners = [four(o), four(o + x), four(p), four(p + x), four(q), four(q + x), four(r), four(r + x)];
    for (face, to) in cuboid.unit.sides().iter().zip(to) {
        write_face(to, face.corners.map(|corner| corners[usize::from(corner & 7)]), normals[face.side as usize]);
    }
}

/// Writes the indices of quads whose vertices follow each other.
#[inline(always)]
fn write_quad_indices(to: &mut [u32], start: u32) {
    const PAIR: [u32; 12] = [0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7];
    let (pairs, rest) = to.as_chunks_mut::<12>();
    let mut first = start;
    for pair in pairs {
        *pair = PAIR.map(|corner| first + corner);
        first += 8;
    }
    for (to, corner) in rest.iter_mut().zip(PAIR) {
        *to = first + corner;
    }
}

/// Writes the four vertices of a face as six vectors.
#[inline(always)]
fn write_face(to: &mut [Vertex; 4], [a, b, c, d]: [Vec4; 4], [u, v, w]: [f32; 3]) {
    let vectors = [
        Vec4::new(a.x, a.y, a.z, u),
        Vec4::new(v, w, b.x, b.y),
        Vec4::new(b.z, u, v, w),
        Vec4::new(c.x, c.y, c.z, u),
        Vec4::new(v, w, d.x, d.y),
        Vec4::new(d.z, u, v, w),
    ];
    let (chunks, _) = to.as_flattened_mut().as_chunks_mut::<4>();
    for (to, vector) in chunks.iter_mut().zip(vectors) {
        *to = vector.to_array();
    }
}

#[inline]
fn vertex(p: [f32; 3], n: [f32; 3]) -> Vertex {
    [p[0], p[1], p[2], n[0], n[1], n[2]]
}

#[inline]
fn short(v: DVec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}

impl Sink for Buffers {
    fn begin(&mut self) {
        self.ids.rules.clear();
        self.ids.materials.clear();
        self.ids.last = None;
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
        if !replay.is_plain() || self.limit - self.vertices.len() < count {
            return replay.each(self);
        }
        self.repeat(replay, count);
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        let Some(start) = self.room(4) else { return ControlFlow::Break(()) };
        self.leaf(leaf);
        let normal = short(unit(quad.u.cross(quad.v)));
        self.write_quad(start, quad.origin - self.origin, [quad.u, quad.v], normal);
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        let Some(start) = self.room(24) else { return ControlFlow::Break(()) };
        self.leaf(leaf);
        let [x, y, z] = [cuboid.sides.x_axis, cuboid.sides.y_axis, cuboid.sides.z_axis];
        // From cross products, not from the axes: they turn round together with the winding when a side is negative.
        let normals = Axes::new(DMat3::from_cols(unit(y.cross(z)), unit(z.cross(x)), unit(x.cross(y)))).normals;
        self.write_box(start, &Cuboid { origin: cuboid.origin - self.origin, ..*cuboid }, &normals);
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        if self.room(mesh.corners.len()).is_none() {
            return ControlFlow::Break(());
        }
        self.ids.last = None;
        let rule = self.table.rule(leaf.rule);
        let material = self.table.material(leaf.material);
        if !mesh.uvs().is_empty() && self.uvs.is_empty() {
            self.uvs.resize(self.vertices.len(), [0.0; 2]);
        }
        let turn = normal_map(&placement.matrix3);
        let mut flattener = std::mem::take(&mut self.flattener);
        flattener.faces(mesh, placement, |face| {
            let shown = self.table.face_material(material, &mesh.materials, mesh.tags[face.index].material);
            self.run(rule, shown);
            let start = self.vertices.len() as u32;
            face.corners.clone().for_each(|corner| self.corner(mesh, placement, &turn, &face, corner));
            let triangles = face.triangles.as_flattened();
            for (index, corner) in self.indices.take(triangles.len()).iter_mut().zip(triangles) {
                *index = start + corner;
            }
            true
        });
        self.flattener = flattener;
        self.pad_uvs();
        ControlFlow::Continue(())
    }
}
