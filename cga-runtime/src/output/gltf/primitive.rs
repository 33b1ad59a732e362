//! The triangles of one material, growing leaf by leaf.

use std::collections::HashMap;
use std::hash::{Hash, Hasher};
use std::ops::Range;

use glam::{DAffine3, DVec2, DVec3, DVec4, Vec4};

use super::look::Looks;
use crate::geometry::mesh::map::normal_map;
use crate::geometry::uv_map::{self, SetMap};
use crate::material::layer::SetMask;
use crate::output::flatten::FlatFace;
use crate::output::room::Room;
use crate::output::table::Table;
use crate::run::sink::Replay;
use crate::run::sink::corners::Placed;
use crate::shape::axes::without_zero;
use crate::shape::base::Form;
use crate::shape::unit::UnitMesh;

/// The primitives of a glTF mesh, in the order of their first use.
#[derive(Debug, Default)]
pub(super) struct Primitives {
    pub(super) list: Vec<Primitive>,
    /// The primitives by look and sets of texture coordinates. Only for look-ups, never iterated.
    by_look: HashMap<(u32, SetMask), usize>,
    /// The primitives without texture coordinates, by material number.
    plain: Vec<Option<u32>>,
}

/// The triangles of one glTF primitive. All vertices have the same sets of texture coordinates.
///
/// A quad has four vertices, one normal, and indices that follow from its place. Faces of meshes have explicit
/// normals and indices. The streams of the file are made of both when it is written (`streams.rs`).
#[derive(Debug, Default)]
pub(super) struct Primitive {
    pub(super) look: u32,
    pub(super) positions: Room<[f32; 3]>,
    pub(super) sets: SetMask,
    /// One list for each set, one pair for each vertex.
    pub(super) uvs: Vec<Vec<[f32; 2]>>,
    /// The normals of quads, one for each.
    pub(super) quad_normals: Room<[f32; 3]>,
    /// The normals of mesh vertices, one for each.
    pub(super) normals: Vec<[f32; 3]>,
    /// The indices of meshes.
    pub(super) indices: Vec<u32>,
    pub(super) stretches: Vec<Stretch>,
}

/// Consecutive vertices with one rule, of quads or of meshes. A stretch ends where the next one begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Stretch {
    pub(super) rule: u32,
    pub(super) is_quads: bool,
    /// The first vertex.
    pub(super) vertex: u32,
    /// The first index, among those of meshes.
    pub(super) index: u32,
}

/// The bytes of a vertex without texture coordinates, and of an index.
pub(super) const VERTEX_BYTES: u64 = 28;
pub(super) const INDEX_BYTES: u64 = 4;

/// The bytes of a vertex for each set of texture coordinates.
pub(super) const UV_BYTES: u64 = 8;

impl Primitives {
    /// The primitive for a material without texture coordinates.
    #[inline]
    pub(super) fn plain(&mut self, looks: &mut Looks, table: &Table, material: u32) -> &mut Primitive {
        let index = match self.plain.get(material as usize) {
            Some(&Some(index)) => index as usize,
            _ => self.find_plain(looks, table, material),
        };
        &mut self.list[index]
    }

    /// The primitive for a material on a mesh with the sets `sets`.
    pub(super) fn of(&mut self, looks: &mut Looks, table: &Table, material: u32, sets: SetMask) -> &mut Primitive {
        let index = self.find(looks, table, material, sets);
        &mut self.list[index]
    }

    #[cold]
    #[inline(never)]
    fn find_plain(&mut self, looks: &mut Looks, table: &Table, material: u32) -> usize {
        let index = self.find(looks, table, material, SetMask::default());
        let at = material as usize;
        self.plain.resize(self.plain.len().max(at + 1), None);
        self.plain[at] = Some(index as u32);
        index
    }

    fn find(&mut self, looks: &mut Looks, table: &Table, material: u32, sets: SetMask) -> usize {
        let (look, sets) = looks.of(material, &table.materials()[material as usize], sets);
        self.with_look(look, sets)
    }

    /// The index of the primitive with a look and some sets.
    pub(super) fn with_look(&mut self, look: u32, sets: SetMask) -> usize {
        let list = &mut self.list;
        *self.by_look.entry((look, sets)).or_insert_with(|| {
            let uvs = sets.sets().map(|_| Vec::new()).collect();
            list.push(Primitive { look, sets, uvs, ..Primitive::default() });
            list.len() - 1
        })
    }

    /// The primitives with triangles: the format does not allow empty lists, and a face can be too thin for a
    /// triangle.
    pub(super) fn into_list(self) -> Vec<Primitive> {
        let mut list = self.list;
        list.retain(|primitive| primitive.index_count() != 0);
        list
    }
}

fn short(v: DVec3) -> [f32; 3] {
    v.to_array().map(|c| c as f32)
}

/// Texture coordinates with v downwards, as in glTF.
fn flipped(uv: DVec2) -> [f32; 2] {
    [uv.x as f32, (1.0 - uv.y) as f32]
}

impl PartialEq for Primitive {
    fn eq(&self, other: &Self) -> bool {
        self.look == other.look
            && self.sets == other.sets
            && self.stretches == other.stretches
            && self.positions.items() == other.positions.items()
            && self.quad_normals.items() == other.quad_normals.items()
            && self.normals == other.normals
            && self.indices == other.indices
            && self.uvs == other.uvs
    }
}

impl Hash for Primitive {
    fn hash<H: Hasher>(&self, state: &mut H) {
        // Equal numbers must have equal hashes: adding 0 removes the sign of −0.
        let bits = |c: &f32| (c + 0.0).to_bits();
        self.look.hash(state);
        self.stretches.hash(state);
        self.positions.items().as_flattened().iter().for_each(|c| bits(c).hash(state));
        self.indices.hash(state);
    }
}

impl Primitive {
    /// The number of vertices.
    pub(super) fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// The number of indices.
    pub(super) fn index_count(&self) -> usize {
        self.indices.len() + 6 * self.quad_normals.len()
    }

    /// Begins a stretch unless the last one continues.
    #[inline]
    pub(super) fn begin(&mut self, rule: u32, is_quads: bool) {
        match self.stretches.last() {
            Some(last) if last.rule == rule && last.is_quads == is_quads => {}
            _ => {
                let (vertex, index) = (self.positions.len() as u32, self.indices.len() as u32);
                self.stretches.push(Stretch { rule, is_quads, vertex, index });
            }
        }
    }

    /// Adds a rectangle, relative to the origin of the file.
    pub(super) fn quad(&mut self, rule: u32, placed: &Placed, normal: Vec4) {
        if let Some(to) = self.quads(rule, 1).next() {
            write_quad(to, placed, normal);
        }
    }

    /// Adds a box, relative to the origin of the file; `normals` are the normals of its sides.
    pub(super) fn cuboid(&mut self, rule: u32, placed: &Placed, unit: UnitMesh, normals: &[Vec4; 6]) {
        write_box(self.quads(rule, 6), placed, unit, normals);
    }

    /// Adds the texture coordinates of the last vertices, from their points in the world.
    pub(super) fn uvs(&mut self, maps: &[SetMap], points: impl Iterator<Item = DVec3> + Clone) {
        for (set, list) in self.sets.sets().zip(&mut self.uvs) {
            if let Some(map) = uv_map::find(maps, set) {
                list.extend(points.clone().map(|point| flipped(map.at(point))));
            }
        }
    }

    /// Adds leaves of a part that repeats, with one rule and `faces` faces.
    #[inline(never)]
    pub(super) fn repeat(&mut self, rule: u32, replay: &Replay<'_>, leaves: Range<usize>, faces: usize, origin: DVec4) {
        let (mut faces, place) = (self.quads(rule, faces), replay.origin());
        for (placed, record, axes) in replay.leaves(leaves) {
            let placed = placed.moved(place).moved(-origin);
            if record.form == Form::Box {
                write_box(faces.by_ref(), &placed, record.unit, &axes.normals);
            } else if let Some(to) = faces.next() {
                write_quad(to, &placed, axes.normals[0]);
            }
        }
    }

    /// The places of the next quads.
    #[inline(always)]
    fn quads(&mut self, rule: u32, count: usize) -> impl Iterator<Item = QuadPlace<'_>> {
        self.begin(rule, true);
        let (positions, _) = self.positions.take(4 * count).as_chunks_mut::<4>();
        positions.iter_mut().zip(self.quad_normals.take(count))
    }

    /// Adds the quads of another primitive that has only quads, moved to a place.
    pub(super) fn add_quads(&mut self, other: &Primitive, placement: &DAffine3, origin: DVec3) {
        let start = self.positions.len() as u32;
        let index = self.indices.len() as u32;
        let moved = |stretch: &Stretch| Stretch { vertex: start + stretch.vertex, index, ..*stretch };
        self.stretches.extend(other.stretches.iter().map(moved));
        let wide = |v: &[f32; 3]| DVec3::from_array(v.map(f64::from));
        let turn = normal_map(&placement.matrix3);
        let (positions, normals) = (other.positions.items(), other.quad_normals.items());
        self.positions.extend(positions.iter().map(|p| short(placement.transform_point3(wide(p)) - origin)));
        self.quad_normals.extend(normals.iter().map(|n| short(turn * wide(n))));
    }

    /// Adds a face of a mesh.
    pub(super) fn face(&mut self, face: &FlatFace<'_>, rule: u32, origin: DVec3) {
        self.begin(rule, false);
        let start = self.positions.len() as u32;
        for corner in face.corners.clone() {
            self.positions.push(short(face.point(corner) - origin));
            self.normals.push(short(face.normal_at(corner)));
        }
        for (set, list) in self.sets.sets().zip(&mut self.uvs) {
            list.extend(face.uvs(set).iter().map(|&uv| flipped(uv)));
        }
        self.indices.extend(face.triangles.as_flattened().iter().map(|i| start + i));
    }
}

/// The places of the positions and of the normal of a quad.
type QuadPlace<'a> = (&'a mut [[f32; 3]; 4], &'a mut [f32; 3]);

#[inline(always)]
fn write_quad(to: QuadPlace<'_>, placed: &Placed, normal: Vec4) {
    write_face(to, placed.quad_corners(), normal);
}

#[inline(always)]
fn write_box<'a>(faces: impl Iterator<Item = QuadPlace<'a>>, placed: &Placed, unit: UnitMesh, normals: &[Vec4; 6]) {
    let corners = placed.box_corners();
    for (face, to) in unit.sides().iter().zip(faces) {
        write_face(to, face.corners.map(|corner| corners[usize::from(corner & 7)]), normals[face.side as usize]);
    }
}

/// Writes the corners of a face as three vectors, and its normal.
#[inline(always)]
fn write_face((positions, to_normal): QuadPlace<'_>, [a, b, c, d]: [Vec4; 4], normal: Vec4) {
    let vectors = [Vec4::new(a.x, a.y, a.z, b.x), Vec4::new(b.y, b.z, c.x, c.y), Vec4::new(c.z, d.x, d.y, d.z)];
    let (chunks, _) = positions.as_flattened_mut().as_chunks_mut::<4>();
    for (to, vector) in chunks.iter_mut().zip(vectors) {
        *to = vector.to_array();
    }
    *to_normal = without_zero(normal);
}
