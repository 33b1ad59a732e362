//! Vertex and index buffers for a graphics card.
//!
//! A vertex is six `f32`: position, then unit normal. Vertices are not shared between faces: a quad takes 4 and two
//! triangles, a box 24 and twelve. Coordinates are computed as `f64` and rounded last. Front faces are counter-clockwise.

mod chunks;

pub use chunks::Chunks;

use std::ops::{ControlFlow, Range};
use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use super::error::WriteError;
use super::flatten::{FlatFace, Flattener, corner_point, normal_map, unit};
use super::table::Table;
use super::{Cuboid, Flow, Leaf, Quad, Sink};
use crate::material::Material;
use crate::mesh::Mesh;

/// Position x, y, z and normal x, y, z.
pub type Vertex = [f32; 6];

/// Collects leaves as triangles. Can be cleared and used again without giving memory back.
#[derive(Debug)]
pub struct Buffers {
    vertices: Vec<Vertex>,
    indices: Vec<u32>,
    /// One a vertex, or empty as long as nothing had any.
    uvs: Vec<[f32; 2]>,
    runs: Vec<Run>,
    table: Table,
    origin: DVec3,
    limit: usize,
    full: bool,
    flattener: Flattener,
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
            vertices: Vec::with_capacity(vertices),
            indices: Vec::with_capacity(indices),
            uvs: Vec::new(),
            runs: Vec::new(),
            table: Table::new(),
            origin: DVec3::ZERO,
            limit: u32::MAX as usize,
            full: false,
            flattener: Flattener::default(),
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
        self.full = false;
    }

    /// The vertices.
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Three a triangle.
    pub fn indices(&self) -> &[u32] {
        &self.indices
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
        match self.runs.last() {
            Some(last) if last.rule == rule && last.material == material => {}
            _ => {
                let run = Run { rule, material, index: self.indices.len(), vertex: self.vertices.len() as u32 };
                self.runs.push(run);
            }
        }
    }

    #[inline]
    fn leaf(&mut self, leaf: &Leaf<'_>) {
        let rule = self.table.rule(leaf.rule);
        let material = self.table.material(leaf.material);
        self.run(rule, material);
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

#[inline]
fn vertex(p: [f32; 3], n: [f32; 3]) -> Vertex {
    [p[0], p[1], p[2], n[0], n[1], n[2]]
}

#[inline]
fn short(v: DVec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}

impl Sink for Buffers {
    #[inline]
    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        let Some(start) = self.room(4) else { return ControlFlow::Break(()) };
        self.leaf(leaf);
        let normal = short(unit(quad.u.cross(quad.v)));
        let a = quad.origin - self.origin;
        let b = a + quad.u;
        self.vertices.extend_from_slice(&[
            vertex(short(a), normal),
            vertex(short(b), normal),
            vertex(short(b + quad.v), normal),
            vertex(short(a + quad.v), normal),
        ]);
        self.indices.extend_from_slice(&[start, start + 1, start + 2, start, start + 2, start + 3]);
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    #[inline]
    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        let Some(start) = self.room(24) else { return ControlFlow::Break(()) };
        self.leaf(leaf);
        let [x, y, z] = [cuboid.sides.x_axis, cuboid.sides.y_axis, cuboid.sides.z_axis];
        // Each corner is rounded once, so the three faces that meet there agree.
        // Four numbers each: they are stored and loaded as one.
        let corners = Cuboid { origin: cuboid.origin - self.origin, ..*cuboid }.corners().map(|p| {
            let [x, y, z] = short(p);
            [x, y, z, 0.0]
        });
        // From cross products, not from the axes: they turn round together with the winding when a side is negative.
        let [right, top, front] = [y.cross(z), z.cross(x), x.cross(y)].map(unit).map(short);
        let [left, bottom, back] = [right, top, front].map(|n| n.map(|c| -c));
        let normals = [front, right, back, left, top, bottom];
        // Written in place: building the vertices elsewhere and copying them takes twice as long.
        self.vertices.extend_from_slice(&[[0.0; 6]; 24]);
        let (faces, _) = self.vertices[start as usize..].as_chunks_mut::<4>();
        for (to, face) in faces.iter_mut().zip(cuboid.unit.sides()) {
            let [u, v, w] = normals[face.side as usize];
            for (to, corner) in to.iter_mut().zip(face.corners) {
                let [x, y, z, _] = corners[usize::from(corner % 8)];
                *to = [x, y, z, u, v, w];
            }
        }
        self.indices
            .extend_from_slice([0, 4, 8, 12, 16, 20].map(|f| [0, 1, 2, 0, 2, 3].map(|i| start + f + i)).as_flattened());
        self.pad_uvs();
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        if self.room(mesh.corners.len()).is_none() {
            return ControlFlow::Break(());
        }
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
            self.indices.extend(face.triangles.as_flattened().iter().map(|i| start + i));
            true
        });
        self.flattener = flattener;
        self.pad_uvs();
        ControlFlow::Continue(())
    }
}
