//! Faces in compact form, until their triangles are written.
//!
//! A box takes 112 bytes instead of the 720 bytes of its vertices and indices, a rectangle 60 instead of 120. Writers make the vertices
//! at their final place, so the memory of a file is filled once.

use std::borrow::Cow;
use std::convert::Infallible;

#[cfg(feature = "gltf")]
use glam::Vec3;
use glam::{DAffine3, DVec3, Vec4};

use super::buffers::Vertex;
#[cfg(feature = "gltf")]
use super::extremes::Extremes;
use super::flatten::{FlatMesh, PlacedFace};
use super::triangles::Triangles;
use crate::geometry::mesh::Mesh;
use crate::run::sink::corners::PlacedBox;
use crate::shape::axes::without_zero;
use crate::shape::unit::UnitMesh;

/// The faces of rectangles, boxes and meshes, in order. Faces share no vertices.
#[derive(Clone, Debug, Default)]
pub(super) struct PackedFaces {
    runs: Vec<FaceRun>,
    quads: Vec<PackedQuad>,
    boxes: Vec<PackedBox>,
    /// The normals of the sides of boxes, once for consecutive boxes with equal normals.
    sides: Vec<[[f32; 3]; 6]>,
    /// All other faces, with indices into these vertices.
    loose: Triangles,
    vertices: usize,
    indices: usize,
}

/// The beginning of consecutive faces of a kind.
#[derive(Clone, Copy, Debug)]
struct FaceRun {
    kind: FaceKind,
    /// The number of its first rectangle, its first box, or its first vertex and index among the loose ones.
    start: [usize; 2],
    /// The number of its first vertex among all.
    vertex: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FaceKind {
    Quads,
    Boxes,
    Loose,
}

/// A rectangle: its corners and its normal.
#[derive(Clone, Copy, Debug)]
struct PackedQuad {
    corners: [[f32; 3]; 4],
    normal: [f32; 3],
}

/// A box: its corners, in the order of [`PlacedBox::box_corners`], and the number of the normals of its sides.
#[derive(Clone, Copy, Debug)]
struct PackedBox {
    corners: [[f32; 3]; 8],
    sides: u32,
    unit: UnitMesh,
}

/// Consecutive faces of a kind.
enum Faces<'a> {
    Quads(&'a [PackedQuad]),
    Boxes(&'a [PackedBox]),
    /// Vertices, indices, and the number of the first vertex in these indices.
    Loose(&'a [Vertex], &'a [u32], u32),
}

/// A corner without its fourth coordinate. A zero has no sign.
#[inline]
fn point(corner: Vec4) -> [f32; 3] {
    (corner + Vec4::ZERO).truncate().to_array()
}

/// Takes the items of a list, in order.
pub(super) trait Collect<T> {
    /// The reason why no more are taken.
    type Error;

    /// Takes a few items.
    ///
    /// # Errors
    /// No more are taken.
    fn add<const N: usize>(&mut self, items: [T; N]) -> Result<(), Self::Error>;
}

impl<T> Collect<T> for Vec<T> {
    type Error = Infallible;

    #[inline]
    fn add<const N: usize>(&mut self, items: [T; N]) -> Result<(), Infallible> {
        self.extend(items);
        Ok(())
    }
}

impl PackedFaces {
    /// The number of vertices.
    #[inline]
    pub(super) fn vertex_count(&self) -> usize {
        self.vertices
    }

    /// The number of indices: three for each triangle.
    #[inline]
    pub(super) fn index_count(&self) -> usize {
        self.indices
    }

    /// Adds a rectangle.
    #[inline]
    pub(super) fn quad(&mut self, placed: &PlacedBox, normal: Vec4) {
        self.begin(FaceKind::Quads);
        let corners = placed.quad_corners().map(point);
        self.quads.push(PackedQuad { corners, normal: without_zero(normal) });
        self.vertices += 4;
        self.indices += 6;
    }

    /// Adds a box; `normals` are the normals of its sides.
    #[inline]
    pub(super) fn cuboid(&mut self, placed: &PlacedBox, unit: UnitMesh, normals: &[Vec4; 6]) {
        self.begin(FaceKind::Boxes);
        let normals = normals.map(without_zero);
        if self.sides.last() != Some(&normals) {
            self.sides.push(normals);
        }
        let corners = placed.box_corners().map(point);
        self.boxes.push(PackedBox { corners, sides: self.sides.len() as u32 - 1, unit });
        self.vertices += 24;
        self.indices += 36;
    }

    /// Adds triangles of a face, relative to an origin.
    pub(super) fn face(&mut self, face: &PlacedFace<'_>, origin: DVec3) {
        self.begin(FaceKind::Loose);
        self.loose.face(face, origin, face.corners.clone(), face.triangles);
        self.count_loose(face.corners.len(), 3 * face.triangles.len());
    }

    /// Adds all faces of a mesh, relative to an origin.
    pub(super) fn mesh(&mut self, flat: &FlatMesh, mesh: &Mesh, placement: &DAffine3, origin: DVec3) {
        self.begin(FaceKind::Loose);
        self.loose.mesh(flat, mesh, placement, origin);
        self.count_loose(mesh.corners().len(), 3 * flat.triangle_count());
    }

    /// Adds vertices and indices; index 0 is the first of these vertices.
    #[cfg(feature = "gltf")]
    pub(super) fn extend(
        &mut self,
        vertices: impl ExactSizeIterator<Item = Vertex>,
        indices: impl ExactSizeIterator<Item = u32>,
    ) {
        self.begin(FaceKind::Loose);
        let (start, counts) = (self.loose.vertices.len() as u32, [vertices.len(), indices.len()]);
        self.loose.vertices.extend(vertices);
        self.loose.indices.extend(indices.map(|index| start + index));
        self.count_loose(counts[0], counts[1]);
    }

    fn count_loose(&mut self, vertices: usize, indices: usize) {
        self.vertices += vertices;
        self.indices += indices;
    }

    /// Begins a run unless the last one continues.
    #[inline]
    fn begin(&mut self, kind: FaceKind) {
        if self.runs.last().is_none_or(|last| last.kind != kind) {
            let start = match kind {
                FaceKind::Quads => [self.quads.len(), 0],
                FaceKind::Boxes => [self.boxes.len(), 0],
                FaceKind::Loose => [self.loose.vertices.len(), self.loose.indices.len()],
            };
            self.runs.push(FaceRun { kind, start, vertex: self.vertices });
        }
    }

    /// The runs, each with the number of its first vertex.
    fn runs(&self) -> impl Iterator<Item = (usize, Faces<'_>)> {
        let mut ends = [self.quads.len(), self.boxes.len(), self.loose.vertices.len(), self.loose.indices.len()];
        // From the last run to the first, as a run ends where the next one of its kind begins.
        let mut list: Vec<(usize, Faces<'_>)> = Vec::with_capacity(self.runs.len());
        for FaceRun { kind, start: [first, index], vertex } in self.runs.iter().rev().copied() {
            let faces = match kind {
                FaceKind::Quads => Faces::Quads(&self.quads[first..std::mem::replace(&mut ends[0], first)]),
                FaceKind::Boxes => Faces::Boxes(&self.boxes[first..std::mem::replace(&mut ends[1], first)]),
                FaceKind::Loose => {
                    let vertices = &self.loose.vertices.items()[first..std::mem::replace(&mut ends[2], first)];
                    let indices = &self.loose.indices.items()[index..std::mem::replace(&mut ends[3], index)];
                    Faces::Loose(vertices, indices, first as u32)
                }
            };
            list.push((vertex, faces));
        }
        list.into_iter().rev()
    }

    /// Passes the positions of all vertices on, in order.
    pub(super) fn positions<C: Collect<[f32; 3]>>(&self, to: &mut C) -> Result<(), C::Error> {
        self.runs().try_for_each(|(_, faces)| match faces {
            Faces::Quads(quads) => quads.iter().try_for_each(|quad| to.add(quad.corners)),
            Faces::Boxes(boxes) => boxes.iter().try_for_each(|block| to.add(block.positions())),
            Faces::Loose(vertices, ..) => vertices.iter().try_for_each(|&[x, y, z, ..]| to.add([[x, y, z]])),
        })
    }

    /// Passes the normals of all vertices on, in order.
    pub(super) fn normals<C: Collect<[f32; 3]>>(&self, to: &mut C) -> Result<(), C::Error> {
        self.runs().try_for_each(|(_, faces)| match faces {
            Faces::Quads(quads) => quads.iter().try_for_each(|quad| to.add([quad.normal; 4])),
            Faces::Boxes(boxes) => boxes.iter().try_for_each(|block| to.add(self.box_normals(block))),
            Faces::Loose(vertices, ..) => vertices.iter().try_for_each(|&[.., x, y, z]| to.add([[x, y, z]])),
        })
    }

    /// Passes all indices on, in order.
    pub(super) fn indices<C: Collect<u32>>(&self, to: &mut C) -> Result<(), C::Error> {
        let quad = |first: u32| [first, first + 1, first + 2, first, first + 2, first + 3];
        self.runs().try_for_each(|(vertex, faces)| {
            let first = vertex as u32;
            let mut quads = |count: usize| (0..count as u32).try_for_each(|number| to.add(quad(first + 4 * number)));
            match faces {
                Faces::Quads(list) => quads(list.len()),
                Faces::Boxes(boxes) => quads(6 * boxes.len()),
                Faces::Loose(_, indices, own) => indices.iter().try_for_each(|index| to.add([index - own + first])),
            }
        })
    }

    /// The vertices and indices as lists.
    pub(super) fn triangles(&self) -> Cow<'_, Triangles> {
        if self.loose.vertices.len() == self.vertices {
            return Cow::Borrowed(&self.loose);
        }
        let mut all = Triangles::default();
        for (_, faces) in self.runs() {
            let mut add = |positions: &[[f32; 3]], normals: &[[f32; 3]]| {
                all.vertices
                    .extend(positions.iter().zip(normals).map(|([x, y, z], [u, v, w])| [*x, *y, *z, *u, *v, *w]));
            };
            match faces {
                Faces::Quads(quads) => quads.iter().for_each(|quad| add(&quad.corners, &[quad.normal; 4])),
                Faces::Boxes(boxes) => boxes.iter().for_each(|block| add(&block.positions(), &self.box_normals(block))),
                Faces::Loose(vertices, ..) => all.vertices.extend(vertices.iter().copied()),
            }
        }
        let mut indices = Vec::with_capacity(self.indices);
        let Ok(()) = self.indices(&mut indices);
        all.indices.extend(indices.into_iter());
        Cow::Owned(all)
    }

    /// The same faces as vertices and indices, so that parts of them can be taken.
    #[cfg(feature = "gltf")]
    pub(super) fn into_loose(self) -> Self {
        if self.loose.vertices.len() == self.vertices {
            return self;
        }
        let loose = self.triangles().into_owned();
        let runs = vec![FaceRun { kind: FaceKind::Loose, start: [0, 0], vertex: 0 }];
        PackedFaces { runs, vertices: self.vertices, indices: self.indices, loose, ..PackedFaces::default() }
    }

    /// The least and the largest coordinates, if all are finite.
    #[cfg(feature = "gltf")]
    pub(super) fn bounds(&self) -> Option<(Vec3, Vec3)> {
        let mut extremes = Extremes::default();
        self.quads.iter().flat_map(|quad| &quad.corners).for_each(|corner| extremes.add(corner));
        self.boxes.iter().flat_map(|block| &block.corners).for_each(|corner| extremes.add(corner));
        self.loose.vertices.items().iter().for_each(|[x, y, z, ..]| extremes.add(&[*x, *y, *z]));
        extremes.found()
    }

    fn box_normals(&self, block: &PackedBox) -> [[f32; 3]; 24] {
        let normals = &self.sides[block.sides as usize];
        let sides = block.unit.sides();
        std::array::from_fn(|vertex| normals[sides[vertex / 4].side as usize])
    }
}

impl PackedBox {
    fn positions(&self) -> [[f32; 3]; 24] {
        let sides = self.unit.sides();
        std::array::from_fn(|vertex| self.corners[usize::from(sides[vertex / 4].corners[vertex % 4] & 7)])
    }
}

#[cfg(all(test, feature = "gltf"))]
mod tests {
    use glam::DVec4;

    use super::*;

    fn placed(origin: [f64; 3]) -> PlacedBox {
        let side = |x, y, z| DVec4::new(x, y, z, 0.0);
        let origin = DVec3::from_array(origin).extend(0.0);
        PlacedBox { origin, sides: [side(2.0, 0.0, 0.0), side(0.0, 3.0, 0.0), side(0.0, 0.0, 4.0)] }
    }

    /// Rectangles, boxes and loose triangles in turn, packed and as triangles.
    fn both() -> (PackedFaces, Triangles) {
        let (mut packed, mut plain) = (PackedFaces::default(), Triangles::default());
        let normals = crate::shape::axes::Axes::new(glam::DMat3::IDENTITY).normals;
        let turned = crate::shape::axes::Axes::new(glam::DMat3::from_rotation_y(1.0)).normals;
        for turn in 0..7 {
            let at = placed([f64::from(turn), 0.5, -1.0]);
            match turn % 3 {
                0 => {
                    packed.quad(&at, normals[0]);
                    plain.quad(at, normals[0]);
                }
                1 => {
                    let normals = if turn == 1 { &normals } else { &turned };
                    for unit in [UnitMesh::cuboid(), UnitMesh::cube()] {
                        packed.cuboid(&at, unit, normals);
                        plain.cuboid(&at, unit, normals);
                    }
                }
                _ => {
                    let vertex = |x: f32| [x, 1.0, f32::from(turn as u8), 0.0, 1.0, 0.0];
                    packed.extend([0.0, 1.0, 2.0].map(vertex).into_iter(), [0, 2, 1].into_iter());
                    let start = plain.vertices.len() as u32;
                    plain.vertices.extend([0.0, 1.0, 2.0].map(vertex).into_iter());
                    plain.indices.extend([0, 2, 1].map(|index| start + index).into_iter());
                }
            }
        }
        (packed, plain)
    }

    #[test]
    fn packed_faces_have_the_vertices_and_indices_of_triangles() {
        let (packed, plain) = both();
        assert_eq!((packed.vertex_count(), packed.index_count()), (plain.vertices.len(), plain.indices.len()));
        for packed in [packed.clone(), packed.into_loose()] {
            let made = packed.triangles();
            assert_eq!((made.vertices.items(), made.indices.items()), (plain.vertices.items(), plain.indices.items()));
            let (mut positions, mut normals, mut indices) = (Vec::new(), Vec::new(), Vec::new());
            let Ok(()) = packed.positions(&mut positions);
            let Ok(()) = packed.normals(&mut normals);
            let Ok(()) = packed.indices(&mut indices);
            let vertices: Vec<Vertex> =
                positions.iter().zip(&normals).map(|([x, y, z], [u, v, w])| [*x, *y, *z, *u, *v, *w]).collect();
            assert_eq!((&vertices[..], &indices[..]), (plain.vertices.items(), plain.indices.items()));
        }
    }

    #[test]
    fn an_error_ends_the_work() {
        /// Takes nothing.
        struct Full(usize);
        impl Collect<[f32; 3]> for Full {
            type Error = ();
            fn add<const N: usize>(&mut self, _: [[f32; 3]; N]) -> Result<(), ()> {
                self.0 += 1;
                Err(())
            }
        }
        let ((packed, _), mut full) = (both(), Full(0));
        let ended = packed.positions(&mut full);
        assert_eq!((ended, full.0), (Err(()), 1));
    }

    #[test]
    fn bounds_are_of_all_positions_and_finite() {
        let (packed, plain) = both();
        let (low, high) = packed.bounds().expect("finite");
        let point = |v: &Vertex| Vec3::new(v[0], v[1], v[2]);
        let all = || plain.vertices.items().iter().map(point);
        assert_eq!(low, all().fold(Vec3::INFINITY, Vec3::min));
        assert_eq!(high, all().fold(Vec3::NEG_INFINITY, Vec3::max));
        for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e39] {
            let normals = crate::shape::axes::Axes::new(glam::DMat3::IDENTITY).normals;
            let (mut quads, mut boxes, mut loose) = (packed.clone(), packed.clone(), packed.clone());
            quads.quad(&placed([0.0, odd, 0.0]), normals[0]);
            boxes.cuboid(&placed([0.0, 0.0, odd]), UnitMesh::cuboid(), &normals);
            loose.extend([[odd as f32, 0.0, 0.0, 0.0, 0.0, 1.0]].into_iter(), [0, 0, 0].into_iter());
            assert!([quads, boxes, loose].iter().all(|faces| faces.bounds().is_none()), "{odd}");
        }
    }
}
