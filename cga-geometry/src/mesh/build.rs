//! The builder of meshes, which checks that all data is finite, in range and long enough.
//!
//! Points at the same position (bit for bit, with -0 equal to 0) are merged. Then corners equal to their predecessor
//! are removed, and so are loops with fewer than three corners. A hole whose outline was removed stays, because a
//! closed mesh must stay closed. Unused points are dropped. Otherwise the order of points, faces and corners is kept.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::numbering::keep_used;
use super::weld::weld;
use super::{FaceTag, Materials, Mesh, MeshError, SubcomponentTagsBuilder, TagSet, UvSets};
use crate::trace::UNTRACED;
use crate::work;

/// The units of work of a corner that is checked or copied, and of a point that is compared.
const CHECKING: usize = 4;
const WELDING: usize = 8;

/// Takes points and faces and makes a checked [`Mesh`].
///
/// ```
/// # mod cga { pub use cga_geometry::mesh; pub use cga_geometry::mesh::MeshBuilder; }
/// use cga::MeshBuilder;
/// use cga::mesh::FaceTag;
///
/// let mut builder = MeshBuilder::new();
/// let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, -1.0]].map(|p| builder.point(p));
/// builder.face(&corners, &[], FaceTag::PLAIN);
/// let mesh = builder.build()?;
/// assert_eq!(mesh.area(), 1.0);
/// # Ok::<(), cga_geometry::mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct MeshBuilder {
    /// The data as given. The lists of values grow with the corners while every face has values.
    given: Mesh,
    /// For each texture set, and for the normals, the number of faces with values.
    uv_faces: [usize; UvSets::MOST],
    normal_faces: usize,
    tagger: SubcomponentTagsBuilder,
    wrong: Option<MeshError>,
}

impl MeshBuilder {
    /// An empty builder.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a point with coordinates in metres, and returns its index.
    pub fn point(&mut self, position: impl Into<[f64; 3]>) -> u32 {
        self.given.add_point(DVec3::from(position.into()))
    }

    /// Adds a face without holes, tags and material: its corners, counter-clockwise as seen from outside.
    ///
    /// ```
    /// # mod cga { pub use cga_geometry::mesh::MeshBuilder; }
    /// use cga::MeshBuilder;
    ///
    /// let mut builder = MeshBuilder::new();
    /// let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(|corner| builder.point(corner));
    /// builder.polygon(&corners);
    /// assert_eq!(builder.build().unwrap().area(), 6.0);
    /// ```
    pub fn polygon(&mut self, corners: &[u32]) -> &mut Self {
        self.face(corners, &[], FaceTag::PLAIN)
    }

    /// Adds a face: its outline, counter-clockwise as seen from outside, and its holes, clockwise. All are lists of at least three
    /// indices of points; [`MeshBuilder::build`] returns an error if they are shorter or out of range. It does not check
    /// whether loops cross; see [`Mesh::from_polygon`].
    pub fn face(&mut self, outer: &[u32], holes: &[&[u32]], tag: FaceTag) -> &mut Self {
        for (number, ring) in std::iter::once(&outer).chain(holes).enumerate() {
            if ring.len() < 3 {
                let face = self.given.face_count();
                self.wrong.get_or_insert(MeshError::ShortLoop { face, ring: number });
            }
            self.given.corners.extend_from_slice(ring);
            self.given.end_loop();
        }
        self.given.end_face(tag);
        self
    }

    /// Sets the texture coordinates of the last added face in set 0: one pair per corner, outline first. The mesh keeps
    /// them only if every face has some. Of several calls for one face, the first one counts.
    pub fn uvs(&mut self, uvs: &[DVec2]) -> &mut Self {
        self.uv_set(0, uvs)
    }

    /// Sets the texture coordinates of the last added face in a set, 0 to 9; see [`MeshBuilder::uvs`].
    pub fn uv_set(&mut self, set: usize, uvs: &[DVec2]) -> &mut Self {
        if UvSets::MOST <= set {
            self.wrong.get_or_insert(MeshError::UvSet { set });
            return self;
        }
        let corners = self.given.corners.len();
        let fits = add_values(self.given.uvs.list_mut(set), &mut self.uv_faces[set], uvs, corners);
        self.expect(fits, uvs.len())
    }

    /// Sets the normals of the last added face: one per corner, outline first. The mesh keeps them only if every face
    /// has some.
    pub fn normals(&mut self, normals: &[DVec3]) -> &mut Self {
        let corners = self.given.corners.len();
        let fits = add_values(&mut self.given.normals, &mut self.normal_faces, normals, corners);
        self.expect(fits, normals.len())
    }

    /// Reports a number of values that differs from the number of corners of the last face.
    fn expect(&mut self, fits: bool, values: usize) -> &mut Self {
        let last = self.given.faces().next_back();
        if !fits && last.map_or(0, |face| face.corner_count()) != values {
            self.wrong.get_or_insert(MeshError::CornerCount { face: last.map_or(0, |face| face.index()) });
        }
        self
    }

    /// Sets the names of groups, which tags index.
    pub fn groups(&mut self, groups: impl Into<Arc<[String]>>) -> &mut Self {
        self.given.groups = groups.into().into();
        self
    }

    /// Sets the materials, which tags index.
    pub fn materials(&mut self, materials: impl Into<Materials>) -> &mut Self {
        self.given.materials = materials.into();
        self
    }

    /// Sets the sets of component tags, which tags of faces index.
    pub fn tag_sets(&mut self, sets: impl Into<Arc<[TagSet]>>) -> &mut Self {
        self.given.tag_sets = sets.into().into();
        self
    }

    /// Adds tags to the edge between two points. They are dropped if no face has the edge.
    pub fn edge_tags(&mut self, ends: [u32; 2], tags: &TagSet) -> &mut Self {
        self.tagger.edge(ends, tags);
        self
    }

    /// Adds tags to the vertex at a point. They are dropped if no face has the vertex.
    pub fn vertex_tags(&mut self, point: u32, tags: &TagSet) -> &mut Self {
        self.tagger.vertex(point, tags);
        self
    }

    /// Checks all data and makes the mesh.
    ///
    /// # Errors
    /// An error if a coordinate is not finite, if an index, a tag or a texture set is out of range, or if a loop has
    /// fewer than three corners.
    pub fn build(self) -> Result<Mesh, MeshError> {
        Ok(self.build_by(|_| true)?.unwrap_or_default())
    }

    /// [`build`](Self::build). `None` if the work is to end.
    pub(crate) fn build_in_time(self) -> Result<Option<Mesh>, MeshError> {
        self.build_by(work::spend)
    }

    /// Makes the mesh. `None` if the work is to end: `spend` counts units of work, and returns false then.
    fn build_by(self, spend: impl Fn(usize) -> bool) -> Result<Option<Mesh>, MeshError> {
        if !spend(CHECKING * self.given.corners.len()) {
            return Ok(None);
        }
        self.check()?;
        if !spend(WELDING * self.given.points.len()) {
            return Ok(None);
        }
        let MeshBuilder { mut given, uv_faces, normal_faces, tagger, .. } = self;
        let (faces, corners) = (given.face_count(), given.corners.len());
        for (set, with_values) in uv_faces.into_iter().enumerate() {
            if with_values != faces || given.uv_set(set).len() != corners {
                given.uvs.set(set, Vec::new());
            }
        }
        given.uvs.forget_empty();
        if normal_faces != faces || given.normals.len() != corners {
            given.normals.clear();
        }
        let same = weld(&given.points);
        let mut mesh = given.alike(corners);
        for face in given.faces() {
            if !spend(CHECKING * face.corner_count()) {
                return Ok(None);
            }
            let first_loop = mesh.loop_ends.len();
            for ring in face.loop_ranges() {
                let start = mesh.corners.len();
                let mut last = same[given.corners[ring.end - 1] as usize];
                for corner in ring {
                    let point = same[given.corners[corner] as usize];
                    if point != std::mem::replace(&mut last, point) {
                        mesh.corners.push(point);
                        mesh.add_values(&given, corner..corner + 1);
                    }
                }
                if mesh.corners.len() - start < 3 {
                    mesh.corners.truncate(start);
                    mesh.uvs.truncate(start);
                    mesh.normals.truncate(start);
                } else {
                    mesh.end_loop();
                }
            }
            if first_loop < mesh.loop_ends.len() {
                mesh.end_face(face.tag());
            }
        }
        let before = if tagger.is_empty() { Vec::new() } else { mesh.corners.clone() };
        mesh.points = keep_used(&given.points, &mut mesh.corners);
        if !tagger.is_empty() {
            let mut welded = SubcomponentTagsBuilder::default();
            welded.append(&tagger.finish(), &|point| same.get(point as usize).copied().unwrap_or(UNTRACED));
            mesh.subcomponent_tags = welded.finish();
            mesh.renumber_tags(&before);
        }
        Ok(Some(mesh.checked()))
    }

    fn check(&self) -> Result<(), MeshError> {
        if let Some(wrong) = &self.wrong {
            return Err(wrong.clone());
        }
        let given = &self.given;
        if given.points.len().max(given.corners.len()) >= (u32::MAX / 2) as usize {
            return Err(MeshError::TooLarge);
        }
        if let Some(point) = given.points.iter().position(|p| !p.is_finite()) {
            return Err(MeshError::NotFinite { point });
        }
        for view in given.faces() {
            let face = view.index();
            let mut corners = given.corners[view.corner_range()].iter();
            if let Some(&index) = corners.find(|&&point| given.points.len() <= point as usize) {
                return Err(MeshError::OutOfRange { face, index });
            }
            let tag = view.tag();
            let lists = [
                (tag.group, given.groups.len()),
                (tag.material, given.materials.len()),
                (tag.tags, given.tag_sets.len()),
            ];
            if lists.iter().any(|&(index, len)| index != FaceTag::NONE && len <= index as usize) {
                return Err(MeshError::Tag { face });
            }
        }
        let finite = given.uv_numbers().flat_map(|set| given.uv_set(set)).all(|uv| uv.is_finite())
            && given.normals.iter().all(|n| n.is_finite());
        if finite { Ok(()) } else { Err(MeshError::NotFinite { point: given.points.len() }) }
    }
}

/// Adds the values of a face to a list if it has values for all corners before the face. Returns whether it does.
fn add_values<T: Copy>(list: &mut Vec<T>, faces: &mut usize, values: &[T], corners: usize) -> bool {
    let fits = list.len() + values.len() == corners;
    if fits {
        list.extend_from_slice(values);
        *faces += 1;
    }
    fits
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_points_become_one_and_unused_ones_go() {
        let mut b = MeshBuilder::new();
        let at = [[0.0, 0.0, 0.0], [9.0, 9.0, 9.0], [1.0, 0.0, 0.0], [1.0, -0.0, 0.0], [0.0, 1.0, 0.0]];
        let p = at.map(|p| b.point(p));
        b.face(&[p[0], p[2], p[3], p[4]], &[], FaceTag::PLAIN);
        let mesh = b.build().unwrap();
        assert_eq!(mesh.points().len(), 3);
        assert_eq!(mesh.face(0).outer(), [0, 1, 2]);
    }

    #[test]
    fn bad_input_is_named() {
        let mut b = MeshBuilder::new();
        b.point([f64::NAN, 0.0, 0.0]);
        assert_eq!(b.build().unwrap_err(), MeshError::NotFinite { point: 0 });
        let mut b = MeshBuilder::new();
        b.point([0.0; 3]);
        b.face(&[0, 0, 7], &[], FaceTag::PLAIN);
        assert_eq!(b.build().unwrap_err(), MeshError::OutOfRange { face: 0, index: 7 });
        let mut b = MeshBuilder::new();
        b.point([0.0; 3]);
        b.face(&[0, 0], &[], FaceTag::PLAIN);
        assert_eq!(b.build().unwrap_err(), MeshError::ShortLoop { face: 0, ring: 0 });
    }

    #[test]
    fn edges_and_vertices_keep_their_tags_under_new_numbers() {
        let mut b = MeshBuilder::new();
        let at = [[9.0, 9.0, 9.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, -0.0, 0.0], [0.0, 1.0, 0.0]];
        let p = at.map(|p| b.point(p));
        let [edge, vertex, other] = ["e", "v", "w"].map(|name| TagSet::new([name]));
        b.face(&[p[1], p[2], p[4]], &[], FaceTag::PLAIN);
        b.edge_tags([p[3], p[1]], &edge).edge_tags([p[2], p[1]], &other).edge_tags([p[0], p[1]], &other);
        b.vertex_tags(p[3], &vertex).vertex_tags(p[0], &other).vertex_tags(77, &other);
        let mesh = b.build().unwrap();
        assert_eq!(mesh.check(), []);
        assert_eq!((mesh.edge_tags([0, 1]), mesh.edge_tags([0, 2])), (Some(&edge.union(&other)), None));
        assert_eq!([0, 1, 2].map(|point| mesh.vertex_tags(point)), [None, Some(&vertex), None]);
        assert_eq!(mesh.subcomponent_tags.vertices().len(), 1);
    }

    #[test]
    fn texture_coordinates_of_some_faces_only_are_dropped() {
        let mut b = MeshBuilder::new();
        let p = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|p| b.point(p));
        b.face(&p, &[], FaceTag::PLAIN).uvs(&[DVec2::ZERO; 3]);
        assert_eq!(b.clone().build().unwrap().uvs().len(), 3);
        b.face(&p, &[], FaceTag::PLAIN);
        assert!(b.build().unwrap().uvs().is_empty());
    }
}
