//! Meshes of planar polygons with holes.
//!
//! Storage is flat: positions; corners (indices into the positions) loop after loop; loops face after face. The first
//! loop of a face is its outline, counter-clockwise seen from outside; the others are holes, clockwise. Faces carry a
//! group, a material and whether a cut made them; corners may carry texture coordinates and normals. Coordinates are
//! local: whoever holds a mesh knows where it stands.
//!
//! What always holds: every coordinate is finite, every index in range, every loop has three corners or more and no
//! corner repeats the one before it, every point is used. Two faces share an edge when they share its two point
//! *indices*; positions are made unique by [`MeshBuilder`] and never compared again. Faces may be degenerate (no
//! area): a mesh stays closed with them and would not be without.

mod adjacency;
mod along_uv;
mod build;
pub mod check;
mod convex;
mod error;
pub mod extrude;
mod extrude_wire;
mod face;
mod layout;
pub(crate) mod map;
mod measure;
pub(crate) mod offset;
mod polygon;
pub mod primitive;
pub(crate) mod solid;
mod spread;
pub(crate) mod table;
mod tag;
pub(crate) mod uv;
mod weld;

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use glam::{DVec2, DVec3};

use crate::material::Material;

pub(crate) use adjacency::Adjacency;
pub use along_uv::{AlongUv, HeightAlignment, HeightDirection, insert_along_uv};
pub use build::MeshBuilder;
pub(crate) use build::keep_used;
pub use check::Flaw;
pub use error::{MeshError, TooManyCorners};
pub use extrude::{Extrude, extrude};
pub(crate) use extrude_wire::{extrude_wire, point_normals};
pub use face::FaceRef;
pub(crate) use face::unit;
pub(crate) use layout::{FaceEnds, Tags};
pub(crate) use map::flip;
pub use offset::OffsetFaces;
pub use tag::TagSet;
pub(crate) use tag::matches as tag_matches;
pub(crate) use uv::UvSets;
pub use uv::{TextureSpace, UvAxis, UvExtent};

/// Faces with holes over shared points. Made by [`MeshBuilder`], never changed afterwards.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    pub(crate) points: Vec<DVec3>,
    /// Point of each corner, loop after loop.
    pub(crate) corners: Vec<u32>,
    /// For each loop, where it ends in `corners`.
    pub(crate) loop_ends: Vec<u32>,
    /// For each face, where it ends in `loop_ends`.
    pub(crate) face_ends: FaceEnds,
    /// One a face.
    pub(crate) tags: Tags,
    pub(crate) uvs: UvSets,
    /// Normals, one a corner, or empty.
    pub(crate) normals: Vec<DVec3>,
    /// Names of groups; [`FaceTag::group`] counts in here.
    pub(crate) groups: Arc<[String]>,
    /// Materials; [`FaceTag::material`] counts in here.
    pub(crate) materials: Arc<[Material]>,
    /// Component tags; [`FaceTag::tags`] counts in here.
    pub(crate) tag_sets: Arc<[TagSet]>,
    pub(crate) derived: Derived,
}

/// What a face carries besides its corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaceTag {
    /// Index into the mesh's groups, or [`FaceTag::NONE`].
    pub group: u32,
    /// Index into the mesh's materials, or [`FaceTag::NONE`].
    pub material: u32,
    /// Index into the mesh's sets of component tags, or [`FaceTag::NONE`].
    pub tags: u32,
    /// Whether a cut made this face.
    pub cap: bool,
}

impl FaceTag {
    /// No group, no material.
    pub const NONE: u32 = u32::MAX;
    /// A face without group and material that is not a cap.
    pub const PLAIN: FaceTag = FaceTag { group: Self::NONE, material: Self::NONE, tags: Self::NONE, cap: false };
    /// A face made by a cut.
    pub const CAP: FaceTag = FaceTag { cap: true, ..FaceTag::PLAIN };
}

impl Default for FaceTag {
    fn default() -> Self {
        FaceTag::PLAIN
    }
}

/// What is computed once, when first asked for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Derived {
    pub(crate) bounds: OnceLock<Bounds>,
    pub(crate) closed: OnceLock<bool>,
    pub(crate) adjacency: OnceLock<Arc<Adjacency>>,
}

impl Derived {
    /// Of the same faces with other points.
    fn of_moved(&self) -> Self {
        Derived { bounds: OnceLock::new(), ..self.clone() }
    }
}

/// An axis-aligned box; of nothing, `low` is +∞ and `high` is −∞.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates.
    pub low: DVec3,
    /// Largest coordinates.
    pub high: DVec3,
}

impl Bounds {
    /// Of nothing.
    pub const EMPTY: Bounds = Bounds { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// Extent along each axis, zero for nothing.
    pub fn size(&self) -> DVec3 {
        (self.high - self.low).max(DVec3::ZERO)
    }

    /// A power of two that makes the longest extent about 1, so that areas and volumes neither overflow nor vanish.
    pub(crate) fn scale_to_one(&self) -> f64 {
        const EXPONENT: u64 = 0x7ff << 52;
        // Halves of the largest numbers have a difference.
        let half = (self.high * 0.5 - self.low * 0.5).max_element();
        1.0 / f64::from_bits(half.max(f64::MIN_POSITIVE).to_bits() & EXPONENT)
    }

    /// The box of some points.
    pub fn of(points: impl IntoIterator<Item = DVec3>) -> Bounds {
        points.into_iter().fold(Bounds::EMPTY, |b, p| Bounds { low: b.low.min(p), high: b.high.max(p) })
    }
}

impl Mesh {
    /// The positions; every one is used by a face.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// The corners of all faces, as indices into [`Mesh::points`]; see [`FaceRef::corner_range`].
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// Texture coordinates of set 0, one a corner, or nothing at all.
    pub fn uvs(&self) -> &[DVec2] {
        self.uvs.get(0)
    }

    /// Texture coordinates of a set (0 to 9), one a corner, or nothing at all.
    pub fn uv_set(&self, set: usize) -> &[DVec2] {
        self.uvs.get(set)
    }

    /// The numbers of the sets that it has.
    #[inline]
    pub(crate) fn uv_numbers(&self) -> impl Iterator<Item = usize> + use<'_> {
        self.uvs.numbers()
    }

    /// Normals, one a corner, or nothing at all.
    pub fn normals(&self) -> &[DVec3] {
        &self.normals
    }

    /// How many faces there are.
    pub fn face_count(&self) -> usize {
        self.face_ends.len()
    }

    /// Whether there is no face.
    pub fn is_empty(&self) -> bool {
        self.face_ends.is_empty()
    }

    /// One face.
    ///
    /// # Panics
    /// When there are not that many.
    pub fn face(&self, index: usize) -> FaceRef<'_> {
        assert!(index < self.face_count(), "face {index} of {}", self.face_count());
        FaceRef { mesh: self, index }
    }

    /// All faces.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = FaceRef<'_>> + DoubleEndedIterator + Clone {
        (0..self.face_count()).map(|index| FaceRef { mesh: self, index })
    }

    /// Names of groups, by [`FaceTag::group`].
    pub fn groups(&self) -> &[String] {
        &self.groups
    }

    /// Materials, by [`FaceTag::material`].
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// Which faces meet where.
    pub(crate) fn adjacency(&self) -> &Arc<Adjacency> {
        self.derived.adjacency.get_or_init(|| Arc::new(Adjacency::of(self)))
    }

    /// Where an edge of the adjacency starts and ends, as the first face that has it runs it.
    pub(crate) fn edge_ends(&self, edge: usize) -> [DVec3; 2] {
        let from = self.adjacency().uses(edge)[0];
        [from, self.adjacency().next(from)].map(|corner| self.points[self.corners[corner as usize] as usize])
    }

    /// Sets of component tags, by [`FaceTag::tags`].
    pub fn tag_sets(&self) -> &[TagSet] {
        &self.tag_sets
    }

    /// A mesh without faces that may have the same groups, materials, tags and texture sets, with room for the coordinates
    /// of some corners.
    pub(crate) fn alike(&self, corners: usize) -> Mesh {
        Mesh {
            uvs: self.uvs.alike(corners),
            groups: self.groups.clone(),
            materials: self.materials.clone(),
            tag_sets: self.tag_sets.clone(),
            ..Mesh::default()
        }
    }

    /// Where a loop lies in `corners`.
    pub(crate) fn loop_range(&self, index: usize) -> Range<usize> {
        let start = if index == 0 { 0 } else { self.loop_ends[index - 1] };
        start as usize..self.loop_ends[index] as usize
    }

    /// Which loops a face has.
    pub(crate) fn face_loops(&self, index: usize) -> Range<usize> {
        self.face_ends.loops(index)
    }
}
