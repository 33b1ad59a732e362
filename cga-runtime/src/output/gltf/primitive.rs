//! The triangles of one material, growing leaf by leaf.

use std::collections::HashMap;
use std::hash::{Hash, Hasher};
use std::ops::Range;

use glam::{DAffine3, DVec2, DVec3, DVec4, Vec4};

use super::look::Looks;
use crate::geometry::mesh::Mesh;
use crate::geometry::mesh::map::normal_map;
use crate::geometry::uv_map::{self, SetMap};
use crate::material::layer::SetMask;
use crate::output::flatten::{FlatMesh, PlacedFace};
use crate::output::packed::PackedFaces;
use crate::output::sink_table::SinkTable;
use crate::output::triangles::vertex;
use crate::run::sink::Replay;
use crate::run::sink::corners::PlacedBox;
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
#[derive(Debug, Default)]
pub(super) struct Primitive {
    pub(super) look: u32,
    /// Relative to the origin of the file.
    pub(super) faces: PackedFaces,
    pub(super) sets: SetMask,
    /// One list for each set, one pair for each vertex.
    pub(super) uvs: Vec<Vec<[f32; 2]>>,
    /// The owners of consecutive vertices, each with the number of its first vertex.
    pub(super) owners: Vec<(Owner, usize)>,
}

/// What vertices belong to: the numbers of their rule and of their building.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Owner {
    pub(super) rule: u32,
    pub(super) building: u32,
}

/// The bytes of a vertex without texture coordinates, and of an index.
pub(super) const VERTEX_BYTES: u64 = 28;
/// The bytes of the number of its building, in a file of several.
pub(super) const BUILDING_BYTES: u64 = 4;
pub(super) const INDEX_BYTES: u64 = 4;
/// The bytes of the number of its rule.
pub(super) const RULE_BYTES: u64 = 4;
/// The bytes that quantization saves: positions of 8 bytes and normals of 4 bytes.
pub(super) const QUANTIZED_BYTES: u64 = 12;

/// The bytes of a vertex for each set of texture coordinates.
pub(super) const UV_BYTES: u64 = 8;

impl Primitives {
    /// The primitive for a material without texture coordinates.
    #[inline]
    pub(super) fn plain(&mut self, looks: &mut Looks, table: &SinkTable, material: u32) -> &mut Primitive {
        let index = match self.plain.get(material as usize) {
            Some(&Some(index)) => index as usize,
            _ => self.find_plain(looks, table, material),
        };
        &mut self.list[index]
    }

    /// The primitive for a material on a mesh with the sets `sets`.
    pub(super) fn of(&mut self, looks: &mut Looks, table: &SinkTable, material: u32, sets: SetMask) -> &mut Primitive {
        let index = self.find(looks, table, material, sets);
        &mut self.list[index]
    }

    #[cold]
    #[inline(never)]
    fn find_plain(&mut self, looks: &mut Looks, table: &SinkTable, material: u32) -> usize {
        let index = self.find(looks, table, material, SetMask::default());
        let at = material as usize;
        self.plain.resize(self.plain.len().max(at + 1), None);
        self.plain[at] = Some(index as u32);
        index
    }

    fn find(&mut self, looks: &mut Looks, table: &SinkTable, material: u32, sets: SetMask) -> usize {
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

    /// Adds vertices and indices of a primitive to that with its look.
    pub(super) fn add_part(&mut self, of: &Primitive, owner: Owner, vertices: Range<usize>, indices: Range<usize>) {
        let index = self.with_look(of.look, of.sets);
        let own = &mut self.list[index];
        own.begin(owner);
        let (triangles, first) = (of.faces.triangles(), vertices.start as u32);
        let moved = triangles.indices.items()[indices].iter().map(|index| index - first);
        own.faces.extend(triangles.vertices.items()[vertices.clone()].iter().copied(), moved);
        for (list, from) in own.uvs.iter_mut().zip(&of.uvs) {
            list.extend_from_slice(&from[vertices.clone()]);
        }
    }

    /// The primitives with triangles: the format does not allow empty lists, and a face can be too thin for a
    /// triangle.
    pub(super) fn into_list(self) -> Vec<Primitive> {
        let mut list = self.list;
        list.retain(|primitive| primitive.faces.index_count() != 0);
        list
    }
}

/// Texture coordinates with v downwards, as in glTF.
fn flipped(uv: DVec2) -> [f32; 2] {
    [uv.x as f32, (1.0 - uv.y) as f32]
}

impl PartialEq for Primitive {
    fn eq(&self, other: &Self) -> bool {
        let (own, others) = (self.faces.triangles(), other.faces.triangles());
        self.look == other.look
            && self.sets == other.sets
            && self.owners == other.owners
            && own.vertices.items() == others.vertices.items()
            && own.indices.items() == others.indices.items()
            && self.uvs == other.uvs
    }
}

impl Hash for Primitive {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.look.hash(state);
        self.owners.hash(state);
        // Equal numbers must have equal hashes: adding 0 removes the sign of −0.
        let triangles = self.faces.triangles();
        triangles.vertices.items().as_flattened().iter().for_each(|number| (number + 0.0).to_bits().hash(state));
        triangles.indices.items().hash(state);
    }
}

impl Primitive {
    /// The vertices of consecutive leaves with the same owner.
    pub(super) fn owned(&self) -> impl Iterator<Item = (Owner, Range<usize>)> + '_ {
        let ends = self.owners.iter().skip(1).map(|(_, vertex)| *vertex).chain([self.faces.vertex_count()]);
        self.owners.iter().zip(ends).map(|((owner, start), end)| (*owner, *start..end))
    }

    /// Passes the vertices and the indices of consecutive leaves with the same owner to `each`.
    pub(super) fn each_owner(&self, mut each: impl FnMut(Owner, Range<usize>, Range<usize>)) {
        let (mut index, triangles) = (0, self.faces.triangles());
        for (owner, vertices) in self.owned() {
            // The triangles are in the order of their vertices.
            let first = index;
            index += triangles.indices.items()[first..].partition_point(|&vertex| (vertex as usize) < vertices.end);
            each(owner, vertices, first..index);
        }
    }

    /// Begins the vertices of an owner unless the vertices of the last one continue.
    #[inline]
    pub(super) fn begin(&mut self, owner: Owner) {
        if self.owners.last().is_none_or(|(last, _)| *last != owner) {
            self.owners.push((owner, self.faces.vertex_count()));
        }
    }

    /// Adds a rectangle.
    pub(super) fn quad(&mut self, owner: Owner, placed: PlacedBox, normal: Vec4) {
        self.begin(owner);
        self.faces.quad(&placed, normal);
    }

    /// Adds a box; `normals` are the normals of its sides.
    pub(super) fn cuboid(&mut self, owner: Owner, placed: &PlacedBox, unit: UnitMesh, normals: &[Vec4; 6]) {
        self.begin(owner);
        self.faces.cuboid(placed, unit, normals);
    }

    /// Adds the texture coordinates of the last vertices, four for each face, from their points in the world.
    pub(super) fn uvs(&mut self, maps: &[SetMap], points: impl Iterator<Item = DVec3> + Clone) {
        for (set, list) in self.sets.sets().zip(&mut self.uvs) {
            if let Some(maps) = uv_map::find(maps, set) {
                let uv = |(corner, point)| flipped(maps.of_face(corner / 4).at(point));
                list.extend(points.clone().enumerate().map(uv));
            }
        }
    }

    /// Adds leaves of a part that repeats, with one owner.
    #[inline(never)]
    pub(super) fn repeat(&mut self, owner: Owner, replay: &Replay<'_>, leaves: Range<usize>, origin: DVec4) {
        self.begin(owner);
        let place = replay.origin();
        for (placed, record, axes) in replay.leaves(leaves) {
            let placed = placed.moved(place).moved(-origin);
            match record.form {
                Form::Box => self.faces.cuboid(&placed, record.unit, &axes.normals),
                _ => self.faces.quad(&placed, axes.normals[0]),
            }
        }
    }

    /// Adds the triangles of another primitive, moved to a place in a building.
    pub(super) fn add_moved(&mut self, other: &Primitive, placement: &DAffine3, building: u32, origin: DVec3) {
        let start = self.faces.vertex_count();
        self.owners.extend(other.owners.iter().map(|(of, vertex)| (Owner { building, ..*of }, start + vertex)));
        let turn = normal_map(&placement.matrix3);
        let wide = |x, y, z| DVec3::new(f64::from(x), f64::from(y), f64::from(z));
        let triangles = other.faces.triangles();
        let moved = triangles.vertices.items().iter().map(|&[x, y, z, u, v, w]| {
            vertex(placement.transform_point3(wide(x, y, z)) - origin, turn * wide(u, v, w))
        });
        self.faces.extend(moved, triangles.indices.items().iter().copied());
    }

    /// Adds all faces of a mesh.
    pub(super) fn mesh(&mut self, flat: &FlatMesh, mesh: &Mesh, placement: &DAffine3, owner: Owner, origin: DVec3) {
        self.begin(owner);
        self.faces.mesh(flat, mesh, placement, origin);
        for (set, list) in self.sets.sets().zip(&mut self.uvs) {
            list.extend(mesh.uv_set(set).iter().map(|&uv| flipped(uv)));
        }
    }

    /// Adds a face of a mesh.
    pub(super) fn face(&mut self, face: &PlacedFace<'_>, owner: Owner, origin: DVec3) {
        self.begin(owner);
        self.faces.face(face, origin);
        for (set, list) in self.sets.sets().zip(&mut self.uvs) {
            list.extend(face.uvs(set).iter().map(|&uv| flipped(uv)));
        }
    }
}
