//! The builder of meshes, which checks that all data is finite, in range and long enough.
//!
//! Points at the same position (bit for bit, with -0 equal to 0) are merged. Then corners equal to their predecessor
//! are removed, and so are loops with fewer than three corners. A hole whose outline was removed stays, because a
//! closed mesh must stay closed. Unused points are dropped. Otherwise the order of points, faces and corners is kept.

use std::ops::Range;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::weld::weld;
use super::{Derived, FaceTag, Mesh, MeshError, TagSet, UvSets};
use crate::material::Material;

/// Takes points and faces and makes a checked [`Mesh`].
///
/// ```
/// use cga_runtime::geometry::mesh::{FaceTag, MeshBuilder};
///
/// let mut builder = MeshBuilder::new();
/// let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, -1.0]].map(|p| builder.point(p));
/// builder.face(&corners, &[], FaceTag::PLAIN);
/// let mesh = builder.build()?;
/// assert_eq!(mesh.area(), 1.0);
/// # Ok::<(), cga_runtime::geometry::mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct MeshBuilder {
    points: Vec<DVec3>,
    corners: Vec<u32>,
    loop_ends: Vec<usize>,
    face_ends: Vec<usize>,
    tags: Vec<FaceTag>,
    /// Each list grows with `corners` while every face has values, with the number of those faces.
    uvs: Vec<(Vec<DVec2>, usize)>,
    normals: Vec<DVec3>,
    normal_faces: usize,
    groups: Arc<[String]>,
    materials: Arc<[Material]>,
    tag_sets: Arc<[TagSet]>,
    wrong: Option<MeshError>,
}

impl MeshBuilder {
    /// An empty builder.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a point and returns its index.
    pub fn point(&mut self, position: impl Into<[f64; 3]>) -> u32 {
        let index = self.points.len();
        self.points.push(DVec3::from(position.into()));
        index as u32
    }

    /// Adds a face: its outline, counter-clockwise as seen from outside, and its holes, clockwise.
    pub fn face(&mut self, outer: &[u32], holes: &[&[u32]], tag: FaceTag) -> &mut Self {
        for ring in std::iter::once(&outer).chain(holes) {
            if ring.len() < 3 {
                let ring = self.loop_ends.len() - self.face_ends.last().copied().unwrap_or(0);
                self.wrong.get_or_insert(MeshError::ShortLoop { face: self.tags.len(), ring });
            }
            self.corners.extend_from_slice(ring);
            self.loop_ends.push(self.corners.len());
        }
        self.face_ends.push(self.loop_ends.len());
        self.tags.push(tag);
        self
    }

    /// Sets the texture coordinates of the last added face in set 0: one pair per corner, outline first. The mesh keeps
    /// them only if every face has some.
    pub fn uvs(&mut self, uvs: &[DVec2]) -> &mut Self {
        self.uv_set(0, uvs)
    }

    /// Sets the texture coordinates of the last added face in a set, 0 to 9; see [`MeshBuilder::uvs`].
    pub fn uv_set(&mut self, set: usize, uvs: &[DVec2]) -> &mut Self {
        if UvSets::MOST <= set {
            self.wrong.get_or_insert(MeshError::UvSet { set });
            return self;
        }
        if self.uvs.len() <= set {
            self.uvs.resize_with(set + 1, Default::default);
        }
        let (list, faces) = &mut self.uvs[set];
        if list.len() + uvs.len() == self.corners.len() {
            list.extend_from_slice(uvs);
            *faces += 1;
        } else if self.last_corner_count() != uvs.len() {
            self.wrong.get_or_insert(MeshError::CornerCount { face: self.tags.len().saturating_sub(1) });
        }
        self
    }

    /// Sets the normals of the last added face: one per corner, outline first. The mesh keeps them only if every face
    /// has some.
    pub fn normals(&mut self, normals: &[DVec3]) -> &mut Self {
        if self.normals.len() + normals.len() == self.corners.len() {
            self.normals.extend_from_slice(normals);
            self.normal_faces += 1;
        } else if self.last_corner_count() != normals.len() {
            self.wrong.get_or_insert(MeshError::CornerCount { face: self.tags.len().saturating_sub(1) });
        }
        self
    }

    /// Sets the names of groups, which tags index.
    pub fn groups(&mut self, groups: impl Into<Arc<[String]>>) -> &mut Self {
        self.groups = groups.into();
        self
    }

    /// Sets the materials, which tags index.
    pub fn materials(&mut self, materials: impl Into<Arc<[Material]>>) -> &mut Self {
        self.materials = materials.into();
        self
    }

    /// Sets the sets of component tags, which tags of faces index.
    pub fn tag_sets(&mut self, sets: impl Into<Arc<[TagSet]>>) -> &mut Self {
        self.tag_sets = sets.into();
        self
    }

    fn last_corner_count(&self) -> usize {
        self.tags.len().checked_sub(1).map_or(0, |face| self.face_corners(face).len())
    }

    fn face_corners(&self, face: usize) -> Range<usize> {
        let start = if face == 0 { 0 } else { self.loop_ends[self.face_ends[face - 1] - 1] };
        start..self.loop_ends[self.face_ends[face] - 1]
    }

    /// Checks all data and makes the mesh.
    ///
    /// # Errors
    /// An error if a coordinate is not finite, if an index, a tag or a texture set is out of range, or if a loop has
    /// fewer than three corners.
    pub fn build(self) -> Result<Mesh, MeshError> {
        self.check()?;
        let same = weld(&self.points);
        let has_all =
            |(list, faces): &(Vec<DVec2>, usize)| *faces == self.tags.len() && list.len() == self.corners.len();
        let mut given = UvSets::default();
        for (set, (list, _)) in self.uvs.into_iter().enumerate().filter(|(_, uvs)| has_all(uvs)) {
            given.set(set, list);
        }
        let with_normals = self.normal_faces == self.tags.len() && self.normals.len() == self.corners.len();
        let uvs = given.alike(self.corners.len());
        let mut mesh =
            Mesh { uvs, groups: self.groups, materials: self.materials, tag_sets: self.tag_sets, ..Mesh::default() };
        let (mut start, mut first_loop) = (0, 0);
        for (face, &end_loop) in self.face_ends.iter().enumerate() {
            let face_start = mesh.loop_ends.len();
            for ring in first_loop..end_loop {
                let range = start..self.loop_ends[ring];
                start = range.end;
                let kept_from = mesh.corners.len();
                for corner in range.clone() {
                    let before = if corner == range.start { range.end - 1 } else { corner - 1 };
                    let point = same[self.corners[corner] as usize];
                    if point == same[self.corners[before] as usize] {
                        continue;
                    }
                    mesh.corners.push(point);
                    mesh.uvs.push_from(&given, |list| list[corner]);
                    if with_normals {
                        mesh.normals.push(self.normals[corner]);
                    }
                }
                if mesh.corners.len() - kept_from < 3 {
                    mesh.corners.truncate(kept_from);
                    mesh.uvs.truncate(kept_from);
                    mesh.normals.truncate(kept_from);
                } else {
                    mesh.end_loop();
                }
            }
            first_loop = end_loop;
            if mesh.loop_ends.len() > face_start {
                mesh.end_face(self.tags[face]);
            }
        }
        mesh.points = keep_used(&self.points, &mut mesh.corners);
        mesh.derived = Derived::default();
        Ok(mesh)
    }

    fn check(&self) -> Result<(), MeshError> {
        if let Some(wrong) = &self.wrong {
            return Err(wrong.clone());
        }
        if self.points.len().max(self.corners.len()) >= (u32::MAX / 2) as usize {
            return Err(MeshError::TooLarge);
        }
        if let Some(point) = self.points.iter().position(|p| !p.is_finite()) {
            return Err(MeshError::NotFinite { point });
        }
        for (face, tag) in self.tags.iter().enumerate() {
            let mut corners = self.corners[self.face_corners(face)].iter();
            if let Some(&index) = corners.find(|&&point| self.points.len() <= point as usize) {
                return Err(MeshError::OutOfRange { face, index });
            }
            let fits = |index: u32, len: usize| index == FaceTag::NONE || (index as usize) < len;
            let all = [
                fits(tag.group, self.groups.len()),
                fits(tag.material, self.materials.len()),
                fits(tag.tags, self.tag_sets.len()),
            ];
            if all.contains(&false) {
                return Err(MeshError::Tag { face });
            }
        }
        let finite = self.uvs.iter().flat_map(|(list, _)| list).all(|uv| uv.is_finite())
            && self.normals.iter().all(|n| n.is_finite());
        if finite { Ok(()) } else { Err(MeshError::NotFinite { point: self.points.len() }) }
    }
}

/// The points that corners use, in their old order. Renumbers the corners; -0 becomes 0.
pub(crate) fn keep_used(points: &[DVec3], corners: &mut [u32]) -> Vec<DVec3> {
    let mut new = vec![u32::MAX; points.len()];
    for &c in corners.iter() {
        new[c as usize] = 0;
    }
    let mut kept = Vec::with_capacity(points.len());
    for (slot, &p) in new.iter_mut().zip(points) {
        if *slot == 0 {
            *slot = kept.len() as u32;
            kept.push(p + 0.0);
        }
    }
    for c in corners {
        *c = new[*c as usize];
    }
    kept
}

/// The points that corners use, in the order of their first use. Renumbers the corners; -0 becomes 0.
pub(super) fn in_order_of_use(points: &[DVec3], corners: &mut [u32]) -> Vec<DVec3> {
    let mut new = vec![u32::MAX; points.len()];
    let mut kept = Vec::with_capacity(points.len());
    for corner in corners {
        let number = &mut new[*corner as usize];
        if *number == u32::MAX {
            *number = kept.len() as u32;
            kept.push(points[*corner as usize] + 0.0);
        }
        *corner = *number;
    }
    kept
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
    fn texture_coordinates_of_some_faces_only_are_dropped() {
        let mut b = MeshBuilder::new();
        let p = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|p| b.point(p));
        b.face(&p, &[], FaceTag::PLAIN).uvs(&[DVec2::ZERO; 3]);
        assert_eq!(b.clone().build().unwrap().uvs().len(), 3);
        b.face(&p, &[], FaceTag::PLAIN);
        assert!(b.build().unwrap().uvs().is_empty());
    }
}
