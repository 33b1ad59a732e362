//! Meshes made of other meshes: what follows from the origins of points and faces.
//!
//! An operation that makes or divides faces gives each new point and each new face with its origin ([`PointOrigin`],
//! [`FaceOrigin`]). From these follow
//!
//! - texture coordinates and normals: at an old point, and at a point that was moved from there, they are the values of the old face
//!   at this point; between two points they are between their values; at other points they continue the values of the old face
//!   over its plane;
//! - groups and materials, and the tags of faces: of the old face, of the edge out of which a face grows, and of the operation;
//! - the tags of edges and vertices: an edge along an old edge has its tags, and a vertex at an old point has the tags there;
//! - the trace of points for recomposition.
//!
//! So an operation is a list of points and faces. This one makes triangles over the edges of each face, around a point in its
//! middle, with a tag of its own:
//!
//! ```
//! use cga_geometry::derive::{CornerValues, Derivation, FaceOrigin, PointOrigin};
//! use cga_geometry::glam::DVec3;
//! use cga_geometry::mesh::Mesh;
//! use cga_geometry::primitive;
//!
//! fn fan(mesh: &Mesh) -> Mesh {
//!     // All points of the mesh under their numbers, so that faces share them as before.
//!     let mut made = Derivation::new(mesh, CornerValues::All, 0).with_old_points();
//!     for face in mesh.faces() {
//!         let outline = face.outer();
//!         let middle = face.outline().sum::<DVec3>() / outline.len() as f64;
//!         let middle = made.point(middle, PointOrigin::New);
//!         // The edges of the outline come before the edges of holes.
//!         for (edge, k) in face.edges().zip(0..outline.len()) {
//!             let triangle = [outline[k], outline[(k + 1) % outline.len()], middle];
//!             made.face([triangle], FaceOrigin::over_edge(&face, "fan.side", edge));
//!         }
//!     }
//!     made.finish()
//! }
//!
//! let fans = fan(&primitive::cube());
//! assert_eq!((fans.face_count(), fans.area(), fans.is_closed()), (24, 6.0, true));
//! assert!(fans.faces().all(|face| face.tags().is_some_and(|tags| tags.has("fan.side"))));
//! ```
//!
//! A point or a face whose origin is forgotten does not compile:
//!
//! ```compile_fail,E0061
//! # use cga_geometry::derive::{CornerValues, Derivation, FaceOrigin, PointOrigin};
//! # use cga_geometry::glam::DVec3;
//! # use cga_geometry::primitive;
//! # let mesh = primitive::quad();
//! let mut made = Derivation::new(&mesh, CornerValues::All, 0);
//! let middle = made.point(DVec3::new(0.5, 0.0, 0.5));
//! ```
//!
//! ```compile_fail,E0061
//! # use cga_geometry::derive::{CornerValues, Derivation, FaceOrigin, PointOrigin};
//! # use cga_geometry::primitive;
//! # let mesh = primitive::quad();
//! let mut made = Derivation::new(&mesh, CornerValues::All, 0);
//! let points: Vec<u32> = (0..4).map(|point| made.old_point(point)).collect();
//! made.face([points]);
//! ```
//!
//! With their origins both compile:
//!
//! ```
//! # use cga_geometry::derive::{CornerValues, Derivation, FaceOrigin, PointOrigin};
//! # use cga_geometry::glam::DVec3;
//! # use cga_geometry::primitive;
//! # let mesh = primitive::quad();
//! let mut made = Derivation::new(&mesh, CornerValues::All, 0);
//! let middle = made.point(DVec3::new(0.5, 0.0, 0.5), PointOrigin::New);
//! let points: Vec<u32> = (0..4).map(|point| made.old_point(point)).collect();
//! made.face([points], FaceOrigin::piece(&mesh.face(0)));
//! ```
//!
//! Cuts by planes are the one exception: they carry values along their planes while they classify corners
//! ([`cut`](super::cut)), which is several times faster.

mod edges;
mod faces;
mod origin;
mod values;

use glam::DVec3;

use crate::mesh::{FaceRef, FaceTag, LoopEnds, Mesh, SharedList, TagSet};
pub use crate::origin::PointOrigin;
use crate::work;
use edges::EdgeOrigins;
use faces::FaceTags;
pub use origin::FaceOrigin;
pub(crate) use origin::{EdgeOrigin, EdgeSource};
pub(crate) use values::Mix;
use values::OldFace;

/// The units of work of a corner whose point gets another number.
const USE: usize = 2;

/// The number of sets of tags that parts of a mesh share with it, whether their faces have these tags or not.
pub(crate) const FEW_SETS: usize = 8;

/// The values of corners that an operation keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CornerValues {
    /// None.
    Dropped,
    /// Texture coordinates.
    Coordinates,
    /// Texture coordinates and normals.
    All,
}

/// A mesh that is made of the points and faces of another one.
///
/// The caller keeps the mesh valid: loops have at least three corners, no corner equals its predecessor, corners are numbers of
/// points that were added, and faces and edges of origins belong to the source. Methods panic on numbers that are out of range.
/// In debug builds [`Derivation::finish`] panics if the structure of the mesh is wrong.
pub struct Derivation<'s> {
    source: &'s Mesh,
    made: Mesh,
    has_normals: bool,
    has_trace: bool,
    /// True if the mesh has sets of tags of its own: the source has many sets, or some faces have other tags than their old faces. Otherwise
    /// the sets of the source serve all.
    has_face_tags: bool,
    /// True if the origins of points are kept: for values, tags or traces.
    has_origins: bool,
    /// The origin of each point.
    origins: Vec<PointOrigin>,
    /// Made when the first face or edge needs them: most extracts of single faces never do.
    tags: Option<Box<DerivedTags<'s>>>,
    old: Option<Box<OldFace<'s>>>,
}

/// The tags of a mesh under construction.
struct DerivedTags<'s> {
    faces: FaceTags<'s>,
    edges: EdgeOrigins,
}

impl<'s> Derivation<'s> {
    /// A mesh without faces and points, with capacity for a number of corners.
    pub fn new(source: &'s Mesh, values: CornerValues, corners: usize) -> Self {
        let mut made = source.alike(if values == CornerValues::Dropped { 0 } else { corners });
        if values == CornerValues::Dropped {
            made.uvs = Default::default();
        }
        let has_normals = values == CornerValues::All && !source.normals().is_empty();
        let has_origins = has_normals || !made.uvs.is_empty() || source.needs_origins();
        Self::with(source, made, has_normals, has_origins)
    }

    /// The same for an operation that gives all faces by their corners ([`Derivation::corner`], [`Derivation::keep`]), with all values:
    /// origins of points are kept only for tags and traces.
    #[inline(always)]
    pub(crate) fn by_corners(source: &'s Mesh, corners: usize) -> Self {
        Self::with(source, source.alike(corners), !source.normals().is_empty(), source.needs_origins())
    }

    #[inline(always)]
    fn with(source: &'s Mesh, made: Mesh, has_normals: bool, has_origins: bool) -> Self {
        let (origins, tags, old) = (Vec::new(), None, None);
        // Parts of a mesh with a set for each face have their own sets alone.
        let has_face_tags = FEW_SETS < source.tag_sets.len();
        Derivation { source, made, has_normals, has_trace: true, has_face_tags, has_origins, origins, tags, old }
    }

    /// Makes room for some points, corners and loops, before the first one.
    #[inline]
    pub(crate) fn make_room(&mut self, points: usize, corners: usize, loops: usize) {
        self.made.points = Vec::with_capacity(points);
        self.made.corners = Vec::with_capacity(corners);
        self.made.loop_ends = LoopEnds::with_capacity(loops);
        if self.has_origins {
            self.origins = Vec::with_capacity(points);
        }
    }

    fn tags(&mut self) -> &mut DerivedTags<'s> {
        let source = self.source;
        let new = || Box::new(DerivedTags { faces: FaceTags::new(source), edges: EdgeOrigins::default() });
        self.tags.get_or_insert_with(new)
    }

    /// The same without the trace of points: recomposition does not connect the parts again.
    pub fn without_trace(self) -> Self {
        Derivation { has_trace: false, ..self }
    }

    /// Returns true if edges or vertices of the source have tags.
    pub(crate) fn has_component_tags(&self) -> bool {
        !self.source.subcomponent_tags.is_empty()
    }

    /// The number of points.
    pub(crate) fn point_count(&self) -> usize {
        self.made.points.len()
    }

    /// Adds a point and returns its number.
    #[inline]
    pub fn point(&mut self, at: DVec3, origin: PointOrigin) -> u32 {
        if self.has_origins {
            self.origins.push(origin);
        }
        self.made.add_point(at)
    }

    /// Adds another copy of a point of the source and returns its number. Faces that share points need
    /// [`with_old_points`](Derivation::with_old_points), or one call for each point.
    pub fn old_point(&mut self, point: u32) -> u32 {
        self.point(self.source.points()[point as usize], PointOrigin::Old(point))
    }

    /// Adds a face: its outline, and then its holes.
    pub fn face<R: AsRef<[u32]>>(&mut self, loops: impl IntoIterator<Item = R>, origin: FaceOrigin) {
        let has_values = self.has_values();
        for ring in loops {
            let ring = ring.as_ref();
            self.made.corners.extend_from_slice(ring);
            if has_values {
                self.add_values(ring, &origin);
            }
            self.end_loop();
        }
        self.end_face(origin);
    }

    /// Adds the values of the corners of a loop.
    fn add_values(&mut self, ring: &[u32], origin: &FaceOrigin) {
        let source = self.source;
        let old = self.old.get_or_insert_with(|| Box::new(OldFace::new(source)));
        old.enter(origin.face);
        let (first, is_turned) = (self.made.corners.len() - ring.len(), origin.is_turned());
        for place in 0..ring.len() {
            let (at, corner) = (self.made.points[ring[place] as usize], first + place);
            if let Some(mix) = old.mix_at(ring, place, &self.origins, origin) {
                self.made.add_mixed(self.source, &mix, self.has_normals, is_turned);
            } else if let Some(before) = old.continued_before(at, is_turned) {
                // All faces of a fan have its middle.
                self.made.add_again(before, self.has_normals);
            } else {
                let mix = old.continued(at, is_turned, corner);
                self.made.add_mixed(self.source, &mix, self.has_normals, is_turned);
            }
        }
    }

    /// The same with all points of the source, under their numbers.
    pub fn with_old_points(mut self) -> Self {
        self.made.points = self.source.points().to_vec();
        if self.has_origins {
            self.origins = (0..self.made.points.len() as u32).map(PointOrigin::Old).collect();
        }
        self
    }

    /// The same with all points of the source at other places, and with room for more points and for corners. Texture coordinates and
    /// normals stay as in the source: points at new places get the values of the source's plane, so only points between others
    /// ([`PointOrigin::Between`]) may follow.
    pub fn with_old_points_at(mut self, places: &[DVec3], points: usize, corners: usize) -> Self {
        self.made.points = Vec::with_capacity(places.len() + points);
        self.made.points.extend_from_slice(places);
        self.made.corners = Vec::with_capacity(corners);
        self.made.loop_ends = LoopEnds::with_capacity(corners / 3);
        if self.has_origins {
            self.origins = (0..places.len() as u32).map(PointOrigin::Old).collect();
        }
        self
    }

    /// Adds a face with corners of the source, in a mesh with the points of the source.
    pub fn keep<R: IntoIterator<Item = usize>>(&mut self, loops: impl IntoIterator<Item = R>, origin: FaceOrigin) {
        let corners = self.source.corners();
        self.keep_at(loops.into_iter().map(|ring| ring.into_iter().map(|corner| (corners[corner], corner))), origin);
    }

    /// Adds a face with corners at points of their own, and the values of corners of the source.
    pub(crate) fn keep_at<R: IntoIterator<Item = (u32, usize)>>(
        &mut self,
        loops: impl IntoIterator<Item = R>,
        origin: FaceOrigin,
    ) {
        for ring in loops {
            ring.into_iter().for_each(|(point, corner)| self.corner(point, &Mix::One(corner as u32), false));
            self.end_loop();
        }
        self.end_face(origin);
    }

    /// Adds a corner at a point, with a mix of values of corners of the source. With `is_turned` the face looks in the opposite
    /// direction of the old one.
    #[inline]
    pub(crate) fn corner(&mut self, point: u32, mix: &Mix<'_>, is_turned: bool) {
        self.made.corners.push(point);
        if self.has_values() {
            self.made.add_mixed(self.source, mix, self.has_normals, is_turned);
        }
    }

    /// Ends a loop with the last corner.
    #[inline]
    pub(crate) fn end_loop(&mut self) {
        self.made.end_loop();
    }

    /// Ends a face with the last loop.
    #[inline(always)]
    pub(crate) fn end_face(&mut self, origin: FaceOrigin) {
        let is_piece = origin.is_piece() || (origin.is_strip() && !self.has_component_tags());
        let own = self.source.tags[origin.face as usize];
        let keeps = is_piece && (!self.has_face_tags || own.tags == FaceTag::NONE);
        let tag = if keeps { own } else { self.face_tags().of(&origin) };
        self.made.end_face(tag);
    }

    /// The tags of faces, for the first face that needs others than its old face, and all faces after it.
    fn face_tags(&mut self) -> &mut FaceTags<'s> {
        if !std::mem::replace(&mut self.has_face_tags, true) {
            let before = std::mem::take(&mut self.made.tags);
            let tags = self.tags();
            self.made.tags = before.mapped(|own| tags.faces.same(own));
        }
        &mut self.tags().faces
    }

    /// Ends a face with the last loop. Its tags do not follow from its origin.
    pub(crate) fn end_tagged_face(&mut self, origin: FaceOrigin, tags: &TagSet) {
        let tag = self.face_tags().with(&origin, tags);
        self.made.end_face(tag);
    }

    /// Returns true if corners have values, so that their mixes matter.
    #[inline]
    pub(crate) fn has_values(&self) -> bool {
        self.has_normals || !self.made.uvs.is_empty()
    }

    /// Adds a copy of a face with points of its own. Returns its loops.
    pub fn copy(&mut self, face: &FaceRef<'_>) -> Vec<Vec<u32>> {
        let mut numbers = std::collections::BTreeMap::new();
        let mut number = |point: u32| *numbers.entry(point).or_insert_with(|| self.old_point(point));
        let rings: Vec<Vec<u32>> = face.loops().map(|ring| ring.iter().map(|&point| number(point)).collect()).collect();
        self.face(&rings, FaceOrigin::piece(face));
        rings
    }

    /// Gives the origin of an edge, in place of the origin that follows from its points.
    pub(crate) fn edge(&mut self, ends: [u32; 2], origin: EdgeOrigin) {
        if origin.tag.is_some() || self.has_component_tags() {
            self.tags().edges.add(ends, origin);
        }
    }

    /// Gives an edge more tags than follow from its points.
    pub fn tag_edge(&mut self, ends: [u32; 2], tags: &TagSet) {
        self.tags().edges.tag_edge(ends, tags);
    }

    /// Gives a vertex more tags than follow from its point.
    pub fn tag_vertex(&mut self, point: u32, tags: &TagSet) {
        self.tags().edges.tag_vertex(point, tags);
    }

    /// The mesh, with all points in the order in which they were added. Faces must use every point; see
    /// [`Derivation::finish_by_use`].
    #[inline(always)]
    pub fn finish(mut self) -> Mesh {
        if self.tags.is_some() || self.source.needs_origins() {
            self.finish_tags();
        } else if self.has_face_tags {
            self.made.tag_sets = SharedList::default();
        }
        self.made.check_structure();
        self.made
    }

    #[cold]
    fn finish_tags(&mut self) {
        if self.has_trace {
            self.made.trace = self.source.trace.pick(&mut self.origins.iter().map(|origin| origin.old()));
        }
        self.tags();
        let Some(DerivedTags { faces, edges }) = self.tags.take().map(|tags| *tags) else { return };
        if self.has_face_tags {
            self.made.tag_sets = faces.finish().into();
        }
        self.made.subcomponent_tags = edges.tags(self.source, &self.made, &self.origins);
    }

    /// The mesh with the points that faces use, in their order; empty if the work of a
    /// [`Supervisor`](crate::work::Supervisor) is to end.
    pub fn finish_used(mut self) -> Mesh {
        if !work::spend(USE * self.made.corners.len()) {
            return Mesh::default();
        }
        let before = self.made.number_used();
        if !work::spend(USE * self.made.corners.len()) {
            return Mesh::default();
        }
        self.renumbered(&before).finish()
    }

    /// The same mesh, and the origins of its points, if the source has values, tags or a trace.
    pub fn finish_with_origins(mut self) -> (Mesh, Vec<PointOrigin>) {
        if !work::spend(USE * self.made.corners.len()) {
            return (Mesh::default(), Vec::new());
        }
        let before = self.made.number_used();
        let origins: Vec<PointOrigin> = match self.has_origins {
            true => before.iter().map(|point| self.origins[*point as usize]).collect(),
            false => Vec::new(),
        };
        (self.renumbered(&before).finish(), origins)
    }

    /// The mesh with its points in the order of their first use; unused ones are dropped. It is empty if the work of a
    /// [`Supervisor`](crate::work::Supervisor) is to end.
    pub fn finish_by_use(mut self) -> Mesh {
        if !work::spend(USE * self.made.corners.len()) {
            return Mesh::default();
        }
        let before = self.made.number_by_use();
        if !work::spend(USE * self.made.corners.len()) {
            return Mesh::default();
        }
        self.renumbered(&before).finish()
    }

    /// The same after points got other numbers. `before` are their old ones.
    fn renumbered(mut self, before: &[u32]) -> Self {
        // Only tags and traces need them from here on.
        if self.has_origins && (self.tags.is_some() || self.source.needs_origins()) {
            self.origins = before.iter().map(|point| self.origins[*point as usize]).collect();
        }
        if let Some(tags) = &mut self.tags {
            tags.edges.renumber(before);
        }
        self
    }
}

#[cfg(test)]
mod tests;
