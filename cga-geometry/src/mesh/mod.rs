//! Meshes of planar polygons with holes.
//!
//! The storage is flat: positions; corners (indices into the positions) loop by loop; loops face by face. The first
//! loop of a face is its outline, counter-clockwise as seen from outside; the others are holes, clockwise. Faces have a
//! group, a material and a flag for faces made by cuts. Corners may have texture coordinates and normals. Faces, edges and
//! vertices may have tags. Coordinates are local; the owner of a mesh defines their frame.
//!
//! Invariants: every coordinate is finite, every index is in range, every loop has at least three corners, no corner
//! equals its predecessor, and every point is used. Two faces share an edge if they share its two point *indices*.
//! [`MeshBuilder`] makes positions unique, and they are never compared again. Faces may be degenerate (without area),
//! because a closed mesh may need them to be closed.

mod access;
mod adjacency;
mod assemble;
mod bent;
mod build;
pub mod check;
mod convex;
mod distinct;
mod equal;
mod error;
pub(crate) mod face;
mod face_triangles;
mod flat_face;
pub mod join;
mod layout;
pub mod map;
mod materials;
mod measure;
mod numbering;
pub(crate) mod pair_table;
mod polygon;
mod shared;
mod simple_loops;
mod subcomponent_tags;
mod tag;
mod tagging;
pub mod uv;
mod variants;
mod weld;

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use glam::{DVec2, DVec3};

use crate::each::Each;
use crate::origin::PointOrigin;
use crate::trace::Trace;
use crate::work;

pub use crate::bounds::Bounds;
pub use crate::vector::unit;
pub use adjacency::Adjacency;
pub use build::MeshBuilder;
pub use check::Flaw;
pub use error::{MeshError, TooManyCorners};
pub use face::FaceRef;
pub(crate) use flat_face::FlatFace;
pub(crate) use layout::{FaceEnds, LoopEnds, Tags};
pub use map::flip;
pub use materials::Materials;
pub(crate) use numbering::keep_used;
pub(crate) use shared::SharedList;
pub use subcomponent_tags::{SubcomponentTags, SubcomponentTagsBuilder};
pub(crate) use subcomponent_tags::{in_order, whole_edge};
pub(crate) use tag::TagSetTable;
pub use tag::{TagSet, TaggedComponents};
pub use uv::UvSets;
pub(crate) use uv::are_uvs_near;
pub use uv::{TextureSpace, UvAxis, UvExtent};
pub use variants::Variant;
use variants::Variants;

/// Faces with holes over shared points. Made by [`MeshBuilder`].
///
/// The methods that change a mesh keep its lists consistent. Transformations such as [`Mesh::map`] may overflow: then some
/// coordinates are infinite or NaN. Such a mesh is safe to use, but its measures have no meaning, and operations may refuse it
/// or leave it as it is. [`Mesh::check`] lists such points.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    pub(crate) points: Vec<DVec3>,
    /// The point of each corner, loop by loop.
    pub(crate) corners: Vec<u32>,
    /// The end of each loop in `corners`.
    pub(crate) loop_ends: LoopEnds,
    /// The end of each face in `loop_ends`.
    pub(crate) face_ends: FaceEnds,
    /// One tag per face.
    pub(crate) tags: Tags,
    pub(crate) uvs: UvSets,
    /// One normal per corner, or empty.
    pub(crate) normals: Vec<DVec3>,
    /// The names of groups, indexed by [`FaceTag::group`].
    pub(crate) groups: SharedList<String>,
    /// The materials, indexed by [`FaceTag::material`].
    pub(crate) materials: Materials,
    /// The sets of component tags, indexed by [`FaceTag::tags`].
    pub(crate) tag_sets: SharedList<TagSet>,
    pub(crate) subcomponent_tags: SubcomponentTags,
    /// A direction along which bent faces have no folds ([`bent`]). Zero if all faces count as planar.
    pub(crate) bent: DVec3,
    /// The origins of points, in operands.
    pub(crate) trace: Trace,
    pub(crate) derived: Derived,
}

/// The attributes of a face besides its corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaceTag {
    /// Index into the mesh's groups, or [`FaceTag::NONE`].
    pub group: u32,
    /// Index into the mesh's materials, or [`FaceTag::NONE`].
    pub material: u32,
    /// Index into the mesh's sets of component tags, or [`FaceTag::NONE`].
    pub tags: u32,
    /// True if a cut made this face.
    pub cap: bool,
    /// True for a cap that an operation on texture coordinates has reached. Before, its coordinates are (0, 0).
    pub mapped: bool,
}

impl FaceTag {
    /// The index for "none": no group, no material, no tags.
    pub const NONE: u32 = u32::MAX;
    /// A face without group, material and tags that is not a cap.
    pub const PLAIN: FaceTag =
        FaceTag { group: Self::NONE, material: Self::NONE, tags: Self::NONE, cap: false, mapped: false };
    /// A face made by a cut.
    pub const CAP: FaceTag = FaceTag { cap: true, ..FaceTag::PLAIN };

    /// The same attributes of a face that is not a cap.
    pub(crate) fn uncapped(self) -> FaceTag {
        FaceTag { cap: false, mapped: false, ..self }
    }

    /// Returns true for a cap that no operation on texture coordinates has reached.
    pub fn is_unmapped_cap(self) -> bool {
        self.cap && !self.mapped
    }
}

impl Default for FaceTag {
    fn default() -> Self {
        FaceTag::PLAIN
    }
}

/// Properties that are computed on demand and cached.
#[derive(Clone, Debug, Default)]
pub(crate) struct Derived {
    pub(crate) bounds: OnceLock<Bounds>,
    pub(crate) closed: OnceLock<bool>,
    pub(crate) adjacency: OnceLock<Arc<Adjacency>>,
    variants: Variants,
}

impl Derived {
    /// The properties of a mesh of which the bounds are known.
    pub(crate) fn bounded(bounds: Bounds) -> Self {
        Derived { bounds: OnceLock::from(bounds), ..Derived::default() }
    }

    /// Forgets all properties of a mesh that has become another one, of which the bounds are known.
    pub(crate) fn reset(&mut self, bounds: Bounds) {
        match self.bounds.get_mut() {
            Some(known) => *known = bounds,
            None => self.bounds = OnceLock::from(bounds),
        }
        self.closed.take();
        self.adjacency.take();
        self.variants.forget();
    }

    /// The properties of the same faces with other points.
    fn of_moved(&self) -> Self {
        Derived { bounds: OnceLock::new(), ..self.clone() }
    }

    /// Forgets the forms of a mesh that is about to change.
    fn forget_variants(&mut self) {
        self.variants = Variants::default();
    }

    /// Forgets the properties that change with the points.
    fn forget_moved(&mut self) {
        self.bounds = OnceLock::new();
        self.forget_variants();
    }

    /// The properties of the same faces and points with other attributes.
    fn of_changed(self) -> Self {
        Derived { variants: Variants::default(), ..self }
    }
}

impl Mesh {
    /// The positions. Every position is used by a face.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// The corners of all faces, as indices into [`Mesh::points`]; see [`FaceRef::corner_range`].
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// The texture coordinates of set 0, one pair per corner, or an empty slice.
    pub fn uvs(&self) -> &[DVec2] {
        self.uvs.get(0)
    }

    /// The texture coordinates of a set (0 to 9), one pair per corner, or an empty slice. A set with a larger number is empty.
    pub fn uv_set(&self, set: usize) -> &[DVec2] {
        self.uvs.get(set)
    }

    /// The numbers of the mesh's texture sets.
    #[inline]
    pub fn uv_numbers(&self) -> impl Iterator<Item = usize> + use<'_> {
        self.uvs.numbers()
    }

    /// The normals, one per corner, or an empty slice.
    pub fn normals(&self) -> &[DVec3] {
        &self.normals
    }

    /// The number of faces.
    pub fn face_count(&self) -> usize {
        self.face_ends.len()
    }

    /// Returns true if the mesh has no faces.
    pub fn is_empty(&self) -> bool {
        self.face_ends.is_empty()
    }

    /// The face with a number.
    ///
    /// # Panics
    /// Panics if the face does not exist.
    pub fn face(&self, index: usize) -> FaceRef<'_> {
        assert!(index < self.face_count(), "face {index} of {}", self.face_count());
        FaceRef { mesh: self, index }
    }

    /// All faces.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = FaceRef<'_>> + DoubleEndedIterator + Clone {
        (0..self.face_count()).map(|index| FaceRef { mesh: self, index })
    }

    /// The names of groups, indexed by [`FaceTag::group`].
    pub fn groups(&self) -> &[String] {
        &self.groups
    }

    /// The materials, indexed by [`FaceTag::material`].
    /// Empty if they are of another type.
    pub fn materials<M: 'static>(&self) -> &[M] {
        self.materials.list()
    }

    /// The adjacency of faces, edges and points. It is computed at the first call, in time `n log n` for `n` corners at most.
    pub fn adjacency(&self) -> &Arc<Adjacency> {
        let all = |units: usize| {
            // The caller needs the whole adjacency, so that a stop only counts after it.
            let _ = work::spend(units);
            true
        };
        self.derived.adjacency.get_or_init(|| Arc::new(Adjacency::of(self, all).unwrap_or_default()))
    }

    /// [`adjacency`](Self::adjacency). `None` if the work of a [`Supervisor`](crate::work::Supervisor) ends before all edges are known.
    pub fn adjacency_in_time(&self) -> Option<&Arc<Adjacency>> {
        if self.derived.adjacency.get().is_none() {
            let adjacency = Arc::new(Adjacency::of(self, work::spend)?);
            let _ = self.derived.adjacency.set(adjacency);
        }
        Some(self.adjacency())
    }

    /// The positions of the start and the end of an edge of the adjacency, in the direction of the first face that has it.
    ///
    /// # Panics
    /// Panics if the edge does not exist.
    pub fn edge_ends(&self, edge: usize) -> [DVec3; 2] {
        let from = self.adjacency().uses(edge)[0];
        [from, self.adjacency().next(from)].each(|corner| self.points[self.corners[corner as usize] as usize])
    }

    /// The sets of component tags, indexed by [`FaceTag::tags`].
    pub fn tag_sets(&self) -> &[TagSet] {
        &self.tag_sets
    }

    /// The tags of the edge between two points; `None` if it has none, or does not exist.
    pub fn edge_tags(&self, ends: [u32; 2]) -> Option<&TagSet> {
        self.subcomponent_tags.edge(ends)
    }

    /// The tags of the vertex at a point; `None` if it has none, or does not exist.
    pub fn vertex_tags(&self, point: u32) -> Option<&TagSet> {
        self.subcomponent_tags.vertex(point)
    }

    /// Returns true if parts of the mesh need the origins of their points: for a trace, or for tags of edges and vertices.
    #[inline]
    pub(crate) fn needs_origins(&self) -> bool {
        !self.trace.is_empty() || !self.subcomponent_tags.is_empty()
    }

    /// The two points of every edge, once for each face at the edge.
    pub fn face_edges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.faces().flat_map(|face| face.edges()).map(|edge| edge.each(|corner| self.corners[corner]))
    }

    /// Takes over the tags of edges and vertices of a mesh of which this is a part: parts of an edge have its tags. `origin` gives
    /// the origin of each point.
    pub(crate) fn divide_tags(&mut self, source: &Mesh, origin: impl Fn(u32) -> PointOrigin) {
        if !source.subcomponent_tags.is_empty() {
            let tags = source.subcomponent_tags.carried(&mut self.face_edges(), self.points.len(), &origin);
            self.subcomponent_tags = tags;
        }
    }

    /// The mesh with other tags of edges and vertices. Tags of an edge that no face has, or of a point that does not exist, are
    /// dropped.
    pub fn with_subcomponent_tags(self, tags: SubcomponentTagsBuilder) -> Mesh {
        let tags = tags.finish().carried(&mut self.face_edges(), self.points.len(), &PointOrigin::Old);
        Mesh { subcomponent_tags: tags, derived: self.derived.of_changed(), ..self }
    }

    /// A mesh without faces that has the same groups, materials, tag sets and texture sets, with capacity for the
    /// coordinates of some corners.
    pub(crate) fn alike(&self, corners: usize) -> Mesh {
        Mesh {
            uvs: if self.uvs.is_empty() { UvSets::default() } else { self.uvs.alike(corners) },
            groups: self.groups.clone(),
            materials: self.materials.clone(),
            tag_sets: self.tag_sets.clone(),
            bent: self.bent,
            ..Mesh::default()
        }
    }

    /// Returns true if the mesh shares the names, materials and tag sets of another one, and has the same texture sets, as after [`Mesh::alike`].
    pub(crate) fn is_alike(&self, other: &Mesh) -> bool {
        self.groups.is(&other.groups)
            && self.tag_sets.is(&other.tag_sets)
            && self.materials.is_same_list(&other.materials)
            && self.uvs.is_alike(&other.uvs)
    }

    /// The same mesh, which is known to be closed or not.
    pub(crate) fn known_closed(self, closed: bool) -> Mesh {
        let _ = self.derived.closed.set(closed);
        self
    }

    /// The range of a loop in `corners`.
    #[inline]
    pub(crate) fn loop_range(&self, index: usize) -> Range<usize> {
        let start = if index == 0 { 0 } else { self.loop_ends[index - 1] };
        start as usize..self.loop_ends[index] as usize
    }

    /// The end of each face in `corners`, if each face has one loop.
    pub(crate) fn loop_ends_of_polygons(&self) -> Option<&[u32]> {
        (self.face_ends.len() == self.loop_ends.len()).then_some(&self.loop_ends)
    }

    /// The loops of a face.
    #[inline]
    pub(crate) fn face_loops(&self, index: usize) -> Range<usize> {
        self.face_ends.loops(index)
    }

    /// The range of a face in `corners`.
    #[inline]
    pub(crate) fn face_corners(&self, index: usize) -> Range<usize> {
        self.corners_of(&self.face_loops(index))
    }

    /// The range of some loops in `corners`.
    #[inline]
    pub(crate) fn corners_of(&self, loops: &Range<usize>) -> Range<usize> {
        self.loop_range(loops.start).start..self.loop_ends[loops.end - 1] as usize
    }
}
