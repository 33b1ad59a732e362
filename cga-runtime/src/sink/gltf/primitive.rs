//! The triangles of one material, growing leaf by leaf.

use std::collections::HashMap;
use std::hash::{Hash, Hasher};
use std::ops::Range;

use glam::{DAffine3, DVec2, DVec3, Vec4};

use super::look::Looks;
use crate::mesh::Mesh;
use crate::shape::base::Form;
use crate::sink::buffers::write::{box_corners, four, write_quad_indices};
use crate::sink::flatten::{FlatFace, corner_point, normal_map, unit};
use crate::sink::room::Room;
use crate::sink::table::Table;
use crate::sink::{Cuboid, Replay};

/// The primitives of a glTF mesh, in the order in which they are first asked for.
#[derive(Debug, Default)]
pub(super) struct Primitives {
    pub(super) list: Vec<Primitive>,
    /// By look and whether they have texture coordinates. Only ever asked, never walked.
    by_look: HashMap<(u32, bool), usize>,
    /// Those without texture coordinates, by number of the material.
    plain: Vec<Option<u32>>,
}

/// Streams of one glTF primitive. Texture coordinates are there for all vertices or for none.
#[derive(Debug, Default)]
pub(super) struct Primitive {
    pub(super) look: u32,
    pub(super) positions: Room<[f32; 3]>,
    pub(super) normals: Room<[f32; 3]>,
    pub(super) uvs: Vec<[f32; 2]>,
    pub(super) indices: Room<u32>,
    /// Stretches of vertices with one rule: the rule and the first vertex.
    rules: Vec<(u32, u32)>,
}

/// Bytes that a vertex without texture coordinates takes, and an index.
pub(super) const VERTEX_BYTES: u64 = 28;
pub(super) const INDEX_BYTES: u64 = 4;

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

    /// The primitive for a material, with or without texture coordinates.
    pub(super) fn of(&mut self, looks: &mut Looks, table: &Table, material: u32, has_uvs: bool) -> &mut Primitive {
        let index = self.find(looks, table, material, has_uvs);
        &mut self.list[index]
    }

    #[cold]
    #[inline(never)]
    fn find_plain(&mut self, looks: &mut Looks, table: &Table, material: u32) -> usize {
        let index = self.find(looks, table, material, false);
        let at = material as usize;
        self.plain.resize(self.plain.len().max(at + 1), None);
        self.plain[at] = Some(index as u32);
        index
    }

    fn find(&mut self, looks: &mut Looks, table: &Table, material: u32, has_uvs: bool) -> usize {
        let look = looks.of(material, &table.materials()[material as usize], has_uvs);
        self.with_look(look, has_uvs)
    }

    /// The number of the primitive with a look.
    pub(super) fn with_look(&mut self, look: u32, has_uvs: bool) -> usize {
        let list = &mut self.list;
        *self.by_look.entry((look, has_uvs)).or_insert_with(|| {
            list.push(Primitive { look, ..Primitive::default() });
            list.len() - 1
        })
    }

    /// Drops primitives without triangles: the format knows no empty lists, and a face can be too thin for a triangle.
    pub(super) fn into_list(self) -> Vec<Primitive> {
        let mut list = self.list;
        list.retain(|primitive| primitive.indices.len() != 0);
        list
    }
}

fn short(v: DVec3) -> [f32; 3] {
    v.to_array().map(|c| c as f32)
}

/// glTF counts v downwards.
fn flipped(uv: DVec2) -> [f32; 2] {
    [uv.x as f32, (1.0 - uv.y) as f32]
}

impl PartialEq for Primitive {
    fn eq(&self, other: &Self) -> bool {
        self.look == other.look
            && self.rules == other.rules
            && self.positions.items() == other.positions.items()
            && self.normals.items() == other.normals.items()
            && self.indices.items() == other.indices.items()
            && self.uvs == other.uvs
    }
}

impl Hash for Primitive {
    fn hash<H: Hasher>(&self, state: &mut H) {
        // Equal numbers have equal hashes: adding 0 takes the sign off −0.
        let bits = |c: &f32| (c + 0.0).to_bits();
        self.look.hash(state);
        self.rules.hash(state);
        self.positions.items().as_flattened().iter().for_each(|c| bits(c).hash(state));
        self.indices.items().hash(state);
    }
}

impl Primitive {
    /// The rules of the vertices: stretches of vertices, each with its rule.
    pub(super) fn rules(&self) -> impl Iterator<Item = (u32, Range<usize>)> {
        self.rules.iter().enumerate().map(|(i, &(rule, first))| {
            let end = self.rules.get(i + 1).map_or(self.positions.len(), |&(_, next)| next as usize);
            (rule, first as usize..end)
        })
    }

    /// Says whose vertices follow.
    #[inline]
    pub(super) fn rule(&mut self, rule: u32) {
        match self.rules.last() {
            Some(&(last, _)) if last == rule => {}
            _ => self.rules.push((rule, self.positions.len() as u32)),
        }
    }

    /// Adds a rectangle with that first corner, relative to the origin of the file, and those sides.
    pub(super) fn quad(&mut self, rule: u32, a: DVec3, [u, v]: [DVec3; 2], normal: [f32; 3]) {
        self.rule(rule);
        let start = self.positions.len() as u32;
        write_quad_indices(self.indices.take(6), start);
        let mut faces = faces(&mut self.positions, &mut self.normals, 4);
        if let Some(to) = faces.next() {
            write_quad(to, a, [u, v], normal);
        }
    }

    /// Adds a box, relative to the origin of the file; `normals` are those of its sides.
    pub(super) fn cuboid(&mut self, rule: u32, cuboid: &Cuboid, normals: &[[f32; 3]; 6]) {
        self.rule(rule);
        let start = self.positions.len() as u32;
        write_quad_indices(self.indices.take(36), start);
        write_box(faces(&mut self.positions, &mut self.normals, 24), cuboid, normals);
    }

    /// Adds leaves of a part that repeats, with one rule and this many corners.
    #[inline(never)]
    pub(super) fn stretch(
        &mut self,
        rule: u32,
        replay: &Replay<'_>,
        leaves: Range<usize>,
        corners: usize,
        file_origin: DVec3,
    ) {
        self.rule(rule);
        let start = self.positions.len() as u32;
        write_quad_indices(self.indices.take(corners / 4 * 6), start);
        let mut faces = faces(&mut self.positions, &mut self.normals, corners);
        for (placed, record, axes) in replay.leaves(leaves) {
            let (origin, sides) = (replay.origin() + placed.origin - file_origin, placed.sides);
            if record.form == Form::Box {
                write_box(faces.by_ref(), &Cuboid { origin, sides, unit: record.unit }, &axes.normals);
            } else if let Some(to) = faces.next() {
                write_quad(to, origin, [sides.x_axis, sides.y_axis], axes.normals[0]);
            }
        }
    }

    /// Adds the triangles of another primitive without texture coordinates, moved to a place.
    pub(super) fn add(&mut self, other: &Primitive, placement: &DAffine3, origin: DVec3) {
        let start = self.positions.len() as u32;
        self.rules.extend(other.rules.iter().map(|&(rule, first)| (rule, first + start)));
        let wide = |v: &[f32; 3]| DVec3::from_array(v.map(f64::from));
        let turn = normal_map(&placement.matrix3);
        let (positions, normals) = (other.positions.items(), other.normals.items());
        self.positions.extend(positions.iter().map(|p| short(placement.transform_point3(wide(p)) - origin)));
        self.normals.extend(normals.iter().map(|n| short(turn * wide(n))));
        self.indices.extend(other.indices.items().iter().map(|index| index + start));
    }

    /// Adds a face of a mesh.
    pub(super) fn face(&mut self, mesh: &Mesh, placement: &DAffine3, face: &FlatFace<'_>, rule: u32, origin: DVec3) {
        self.rule(rule);
        let start = self.positions.len() as u32;
        let turn = normal_map(&placement.matrix3);
        for corner in face.corners.clone() {
            let point = placement.transform_point3(corner_point(mesh, corner)) - origin;
            let normal = mesh.normals.get(corner).map_or(face.normal, |&n| unit(turn * n));
            self.positions.push(short(point));
            self.normals.push(short(normal));
        }
        if !mesh.uvs().is_empty() {
            self.uvs.extend(mesh.uvs()[face.corners.clone()].iter().map(|&uv| flipped(uv)));
        }
        self.indices.extend(face.triangles.as_flattened().iter().map(|i| start + i));
    }
}

/// The places of the positions and the normals of a face.
type FacePlaces<'a> = (&'a mut [[f32; 3]; 4], &'a mut [[f32; 3]; 4]);

/// The places of the next faces, with this many corners in all.
#[inline(always)]
fn faces<'a>(
    positions: &'a mut Room<[f32; 3]>,
    normals: &'a mut Room<[f32; 3]>,
    corners: usize,
) -> impl Iterator<Item = FacePlaces<'a>> {
    let (positions, _) = positions.take(corners).as_chunks_mut::<4>();
    let (normals, _) = normals.take(corners).as_chunks_mut::<4>();
    positions.iter_mut().zip(normals)
}

#[inline(always)]
fn write_quad(to: FacePlaces<'_>, a: DVec3, [u, v]: [DVec3; 2], normal: [f32; 3]) {
    let b = a + u;
    write_face(to, [four(a), four(b), four(b + v), four(a + v)], normal);
}

#[inline(always)]
fn write_box<'a>(faces: impl Iterator<Item = FacePlaces<'a>>, cuboid: &Cuboid, normals: &[[f32; 3]; 6]) {
    let corners = box_corners(cuboid);
    for (face, to) in cuboid.unit.sides().iter().zip(faces) {
        write_face(to, face.corners.map(|corner| corners[usize::from(corner & 7)]), normals[face.side as usize]);
    }
}

/// Writes the corners of a face as three vectors, and the normals.
#[inline(always)]
fn write_face((positions, normals): FacePlaces<'_>, [a, b, c, d]: [Vec4; 4], [u, v, w]: [f32; 3]) {
    let put = |to: &mut [[f32; 3]; 4], vectors: [Vec4; 3]| {
        let (chunks, _) = to.as_flattened_mut().as_chunks_mut::<4>();
        for (to, vector) in chunks.iter_mut().zip(vectors) {
            *to = vector.to_array();
        }
    };
    put(positions, [Vec4::new(a.x, a.y, a.z, b.x), Vec4::new(b.y, b.z, c.x, c.y), Vec4::new(c.z, d.x, d.y, d.z)]);
    put(normals, [Vec4::new(u, v, w, u), Vec4::new(v, w, u, v), Vec4::new(w, u, v, w)]);
}
