//! Texture coordinates of vertices, set by set.

use glam::{DVec2, DVec4};

use crate::geometry::each::Each;
use crate::geometry::mesh::Mesh;
use crate::geometry::uv_map::{FaceMaps, SetMap, UvMap};
use crate::output::flatten::PlacedFace;
use crate::run::sink::Replay;
use crate::run::sink::corners::PlacedBox;
use crate::shape::base::Form;
use crate::shape::texture::SETS;
use crate::shape::unit::UnitMesh;

/// Lists of coordinates by set: one pair for each vertex in the sets that some geometry has, and empty lists
/// otherwise.
#[derive(Clone, Debug, Default)]
pub(super) struct UvLists(Vec<Vec<[f32; 2]>>);

impl UvLists {
    /// Returns true while no geometry has coordinates.
    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn get(&self, set: usize) -> &[[f32; 2]] {
        self.0.get(set).map_or(&[], Vec::as_slice)
    }

    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// The bytes reserved.
    pub(super) fn memory(&self) -> usize {
        self.0.iter().map(|list| size_of::<[f32; 2]>() * list.capacity()).sum()
    }

    /// The list of a set, filled with (0, 0) for vertices before `end` without coordinates.
    fn list(&mut self, set: usize, end: usize) -> Option<&mut Vec<[f32; 2]>> {
        if SETS <= set {
            return None;
        }
        if self.0.len() <= set {
            self.0.resize_with(set + 1, Vec::new);
        }
        let list = &mut self.0[set];
        if list.len() < end {
            list.resize(end, [0.0; 2]);
        }
        Some(list)
    }

    /// Extends all lists to the number of vertices.
    #[inline]
    pub(super) fn pad(&mut self, vertices: usize) {
        for list in &mut self.0 {
            if !list.is_empty() {
                list.resize(vertices, [0.0; 2]);
            }
        }
    }

    /// Adds the coordinates of mesh corners that became vertices, beginning at `vertex`.
    pub(super) fn face(&mut self, face: &PlacedFace<'_>, corners: impl Iterator<Item = usize> + Clone, vertex: usize) {
        for set in face.mesh.uv_numbers() {
            if let Some(list) = self.list(set, vertex) {
                list.extend(corners.clone().map(|corner| face.mesh.uv_set(set)[corner].as_vec2().to_array()));
            }
        }
    }

    /// Adds the coordinates of all corners of a mesh, which became vertices, beginning at `vertex`.
    pub(super) fn mesh(&mut self, mesh: &Mesh, vertex: usize) {
        for set in mesh.uv_numbers() {
            if let Some(list) = self.list(set, vertex) {
                list.extend(mesh.uv_set(set).iter().map(|uv| uv.as_vec2().to_array()));
            }
        }
    }

    /// Adds the coordinates of a rectangle, or of all faces of a box, whose vertices begin at `vertex`.
    pub(super) fn place(&mut self, maps: &[SetMap], placed: &PlacedBox, block: Option<UnitMesh>, vertex: usize) {
        let end = vertex + 4 * block.map_or(1, |unit| unit.face_count());
        for SetMap { set, maps } in maps {
            if let Some(list) = self.list(*set, end) {
                let (faces, _) = list[vertex..end].as_chunks_mut::<4>();
                match (maps, block) {
                    (FaceMaps::Each(maps), Some(unit)) => {
                        for ((to, face), map) in faces.iter_mut().zip(unit.sides()).zip(&**maps) {
                            *to = Corners::of(&Columns::from(map), placed).side(face.corners);
                        }
                    }
                    _ => Corners::of(&Columns::from(maps.of_face(0)), placed).write(faces, block),
                }
            }
        }
    }

    /// Adds the coordinates of repeated leaves, whose `count` vertices begin at `vertex`.
    pub(super) fn replay(&mut self, replay: &Replay<'_>, vertex: usize, count: usize) {
        let (place, mut first) = (replay.origin(), 0);
        for (leaf, mark) in replay.marks() {
            let (range, vertex_of_mark) = (first..first + mark.leaves, vertex + mark.before as usize);
            first = range.end;
            for SetMap { set, maps } in leaf.uvs_of(mark.look) {
                let Some(list) = self.list(*set, vertex + count) else { continue };
                // Faces of a leaf of a template have the same map.
                let map = Columns::from(maps.of_face(0));
                let (mut faces, _) = list[vertex_of_mark..][..mark.corners].as_chunks_mut::<4>();
                for (placed, record, _) in replay.leaves(range.clone()) {
                    let (own, rest) = faces.split_at_mut(record.unit.face_count());
                    faces = rest;
                    let block = (record.form == Form::Box).then_some(record.unit);
                    Corners::of(&map, &placed.moved(place)).write(own, block);
                }
            }
        }
    }
}

/// A map by columns: the growth of both coordinates along each axis of the world, and their values at the world's
/// origin.
struct Columns {
    axes: [DVec2; 3],
    origin: DVec2,
}

impl From<&UvMap> for Columns {
    fn from(map: &UvMap) -> Self {
        let UvMap { u, v } = map;
        let axes = [DVec2::new(u.x, v.x), DVec2::new(u.y, v.y), DVec2::new(u.z, v.z)];
        Columns { axes, origin: DVec2::new(u.w, v.w) }
    }
}

/// The coordinates at the first corner of a rectangle or a box, and along its sides.
struct Corners {
    first: DVec2,
    sides: [DVec2; 3],
}

impl Corners {
    #[inline]
    fn of(map: &Columns, placed: &PlacedBox) -> Self {
        let [x, y, z] = map.axes;
        let along = |side: DVec4| x * side.x + y * side.y + z * side.z;
        Corners { first: along(placed.origin) + map.origin, sides: placed.sides.each(along) }
    }

    /// Writes the coordinates of a rectangle, or of the faces of a box.
    #[inline]
    fn write(&self, faces: &mut [[[f32; 2]; 4]], block: Option<UnitMesh>) {
        if let Some(unit) = block {
            let points = self.block();
            for (to, face) in faces.iter_mut().zip(unit.sides()) {
                *to = face.corners.each(|corner| points[usize::from(corner & 7)]);
            }
        } else if let [to] = faces {
            *to = self.quad();
        }
    }

    /// The coordinates of a side of a box, whose corners are numbers x + 2y + 4z.
    #[inline]
    fn side(&self, corners: [u8; 4]) -> [[f32; 2]; 4] {
        let (o, [x, y, z]) = (self.first, self.sides);
        let share = |corner: u8, bit: u8| f64::from(corner >> bit & 1);
        corners.each(|at| (o + x * share(at, 0) + y * share(at, 1) + z * share(at, 2)).as_vec2().to_array())
    }

    /// The coordinates of a rectangle in the order of its vertices.
    #[inline]
    fn quad(&self) -> [[f32; 2]; 4] {
        let (a, [u, v, _]) = (self.first, self.sides);
        let b = a + u;
        [a, b, b + v, a + v].each(|uv| uv.as_vec2().to_array())
    }

    /// The coordinates of a box; the corner (x, y, z) has the index x + 2y + 4z.
    #[inline]
    fn block(&self) -> [[f32; 2]; 8] {
        let (o, [x, y, z]) = (self.first, self.sides);
        let (p, q) = (o + y, o + z);
        let r = p + z;
        [o, o + x, p, p + x, q, q + x, r, r + x].map(|uv| uv.as_vec2().to_array())
    }
}
