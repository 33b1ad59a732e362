//! Texture coordinates: up to ten sets, each with one pair per corner or empty.

mod extent;

use std::ops::Range;

use glam::DVec2;
use smallvec::SmallVec;

use super::Mesh;
use super::layout::to_front;
use crate::tol::TEXTURE_EPSILON;
use crate::uv_map::SetMap;
pub use extent::UvExtent;
pub use extent::{range, spread};

/// The unit of the sizes of a split in texture space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextureSpace {
    /// Texture coordinates: `uvSpace`.
    Uv,
    /// Metres on the surface: `unitSpace`.
    Unit,
}

/// One of the two texture coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UvAxis {
    /// The first coordinate.
    U,
    /// The second coordinate.
    V,
}

impl UvAxis {
    /// 0 for u, 1 for v: the index into a `DVec2`.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// The sets of a mesh. Some lists may be empty, but a mesh without texture coordinates has no lists at all.
#[derive(Clone, Debug, Default)]
pub struct UvSets {
    /// Most meshes have set 0 alone.
    lists: SmallVec<[Vec<DVec2>; 1]>,
}

impl UvSets {
    /// The largest number of sets.
    pub const MOST: usize = 10;

    /// A set; empty if it has no coordinates.
    #[inline]
    pub(crate) fn get(&self, set: usize) -> &[DVec2] {
        self.lists.get(set).map_or(&[], Vec::as_slice)
    }

    /// The numbers of the sets with coordinates.
    #[inline]
    pub(crate) fn numbers(&self) -> impl Iterator<Item = usize> + use<'_> {
        self.lists.iter().enumerate().filter(|(_, list)| !list.is_empty()).map(|(set, _)| set)
    }

    /// Returns true if no set has coordinates.
    #[inline]
    pub(crate) fn is_empty(&self) -> bool {
        self.lists.is_empty()
    }

    /// Returns true if each set is empty or has `corners` pairs.
    pub(crate) fn fit(&self, corners: usize) -> bool {
        self.lists.iter().all(|list| [0, corners].contains(&list.len()))
    }

    /// Replaces a set. An empty list removes the set.
    pub(crate) fn set(&mut self, set: usize, list: Vec<DVec2>) {
        if set < self.lists.len() || !list.is_empty() {
            *self.list_mut(set) = list;
        }
    }

    /// A set, to be changed.
    pub(super) fn list_mut(&mut self, set: usize) -> &mut Vec<DVec2> {
        if self.lists.len() <= set {
            self.lists.resize_with(set + 1, Vec::new);
        }
        &mut self.lists[set]
    }

    /// Removes empty lists after the last set with coordinates.
    pub(super) fn forget_empty(&mut self) {
        let used = self.lists.iter().rposition(|list| !list.is_empty()).map_or(0, |last| last + 1);
        self.lists.truncate(used);
    }

    /// The same sets without coordinates, with capacity for `room` corners.
    pub(crate) fn alike(&self, room: usize) -> UvSets {
        let room = |list: &Vec<DVec2>| if list.is_empty() { Vec::new() } else { Vec::with_capacity(room) };
        UvSets { lists: self.lists.iter().map(room).collect() }
    }

    /// Returns true if the sets may have other corners of the same source.
    pub(crate) fn is_alike(&self, other: &UvSets) -> bool {
        self.lists.len() == other.lists.len()
    }

    /// Removes all corners.
    pub(crate) fn clear(&mut self) {
        self.lists.iter_mut().for_each(Vec::clear);
    }

    /// Adds to each set the result of `value` for the source's list.
    #[inline]
    pub(crate) fn push(&mut self, source: &UvSets, mut value: impl FnMut(&[DVec2]) -> DVec2) {
        for (to, from) in self.lists.iter_mut().zip(&source.lists) {
            if !from.is_empty() {
                to.push(value(from));
            }
        }
    }

    /// The lists of the sets with coordinates.
    pub(crate) fn lists_mut(&mut self) -> impl Iterator<Item = &mut Vec<DVec2>> {
        self.lists.iter_mut().filter(|list| !list.is_empty())
    }

    /// The lists beside the lists of a source, for the sets that have coordinates there.
    #[inline]
    pub(crate) fn lists_mut_beside<'s>(
        &mut self,
        source: &'s UvSets,
    ) -> impl Iterator<Item = (&mut Vec<DVec2>, &'s Vec<DVec2>)> {
        self.lists.iter_mut().zip(&source.lists).filter(|(_, from)| !from.is_empty())
    }

    /// Copies some corners of the source to each set.
    #[inline(always)]
    pub(crate) fn copy_from(&mut self, source: &UvSets, corners: Range<usize>) {
        for (to, from) in self.lists.iter_mut().zip(&source.lists) {
            if !from.is_empty() {
                to.extend_from_slice(&from[corners.clone()]);
            }
        }
    }

    /// Shrinks lists that have much more capacity than they need.
    pub(super) fn give_back_room(&mut self) {
        self.lists.iter_mut().for_each(super::layout::give_back_room);
    }

    /// Removes all corners from a number on.
    pub(super) fn truncate(&mut self, corners: usize) {
        self.lists.iter_mut().for_each(|list| list.truncate(corners));
    }

    /// Changes a range of corners in each set.
    pub(crate) fn change(&mut self, corners: Range<usize>, mut change: impl FnMut(&mut [DVec2])) {
        self.lists.iter_mut().filter(|list| !list.is_empty()).for_each(|list| change(&mut list[corners.clone()]));
    }

    /// Moves a range of corners to the front of each set.
    pub(super) fn bring_to_front(&mut self, corners: &Range<usize>) {
        self.lists.iter_mut().filter(|list| !list.is_empty()).for_each(|list| to_front(list, corners.clone()));
    }
}

impl Mesh {
    /// This mesh, whose points are in the world, with coordinates computed by maps in the sets that have a map. Maps of sets
    /// above 9 are ignored. Coordinates that are not finite change as in [`Mesh::with_uv_set`].
    pub fn with_uvs(mut self, maps: &[SetMap]) -> Mesh {
        for SetMap { set, maps } in maps.iter().filter(|known| known.set < UvSets::MOST) {
            let mut list = Vec::with_capacity(self.corners.len());
            for face in self.faces() {
                let (map, corners) = (maps.of_face(face.index()), &self.corners[face.corner_range()]);
                list.extend(corners.iter().map(|&corner| map.at(self.points[corner as usize])));
            }
            self.put_uv_set(*set, list);
        }
        self
    }
}

/// Returns true if two pairs of coordinates are equal, except for rounding and a tolerance.
pub(crate) fn are_uvs_near(a: DVec2, b: DVec2, tolerance: f64) -> bool {
    let size = a.abs().max(b.abs()).max_element().max(1.0);
    (a - b).abs().max_element() <= TEXTURE_EPSILON * size + tolerance
}

impl Mesh {
    /// Returns true if all sets of texture coordinates are equal at two corners, except for rounding.
    pub(crate) fn has_same_texture(&self, one: u32, other: u32) -> bool {
        self.uv_numbers().all(|set| {
            let uvs = self.uv_set(set);
            are_uvs_near(uvs[one as usize], uvs[other as usize], 0.0)
        })
    }

    /// The mesh with other coordinates in a set, one pair per corner, or without the set if the list is empty. Infinite
    /// coordinates become the largest finite numbers, and NaN becomes 0.
    ///
    /// # Panics
    /// Panics if the number of coordinates is neither 0 nor the number of corners, or if the set is not in 0 to 9.
    pub fn with_uv_set(&self, set: usize, uvs: Vec<DVec2>) -> Mesh {
        let mut mesh = self.clone();
        mesh.put_uv_set(set, uvs);
        mesh
    }

    /// The same as [`Mesh::with_uv_set`], in place.
    ///
    /// # Panics
    /// Panics if the number of coordinates is neither 0 nor the number of corners, or if the set is not in 0 to 9.
    pub fn put_uv_set(&mut self, set: usize, mut uvs: Vec<DVec2>) {
        let corners = self.corners.len();
        assert!(set < UvSets::MOST, "texture set {set} does not exist; use 0 to 9");
        assert!([0, corners].contains(&uvs.len()), "{} texture coordinates for {corners} corners", uvs.len());
        self.derived.forget_variants();
        uvs.iter_mut().filter(|uv| !uv.is_finite()).for_each(|uv| {
            let finite = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(-f64::MAX, f64::MAX) };
            *uv = DVec2::new(finite(uv.x), finite(uv.y));
        });
        self.uvs.set(set, uvs);
        self.uvs.forget_empty();
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DVec2, DVec3};

    use crate::Axis;
    use crate::cut;
    use crate::extrude::{Extrude, extrude};
    use crate::mesh::{FaceTag, Mesh, MeshBuilder, MeshError};

    fn square(sets: &[usize]) -> Result<Mesh, MeshError> {
        let mut builder = MeshBuilder::new();
        let points = [[0.0, 0.0], [2.0, 0.0], [2.0, -2.0], [0.0, -2.0]];
        let corners = points.map(|[x, z]| builder.point([x, 0.0, z]));
        builder.face(&corners, &[], FaceTag::PLAIN);
        for &set in sets {
            builder.uv_set(set, &points.map(|[x, z]| DVec2::new(x, z) * (set + 1) as f64));
        }
        builder.build()
    }

    /// Checks that every corner of every face except caps has the coordinates of its point in each set.
    fn all_hold(mesh: &Mesh) {
        assert_eq!(mesh.check(), []);
        for face in mesh.faces().filter(|face| !face.tag().cap) {
            for corner in face.corner_range() {
                let DVec3 { x, z, .. } = mesh.points()[mesh.corners()[corner] as usize];
                for set in [1, 9] {
                    assert_eq!(mesh.uv_set(set)[corner], DVec2::new(x, z) * (set + 1) as f64);
                }
            }
        }
    }

    impl super::UvSets {
        /// The bytes of all sets, and the bytes of their capacity.
        pub(crate) fn bytes(&self) -> [usize; 2] {
            let sum =
                |count: fn(&Vec<DVec2>) -> usize| self.lists.iter().map(count).sum::<usize>() * size_of::<DVec2>();
            [sum(Vec::len), sum(Vec::capacity)]
        }
    }

    #[test]
    fn sets_stay_with_their_corners() {
        let mesh = square(&[9, 1]).unwrap();
        assert!(mesh.uvs().is_empty() && mesh.uv_set(10).is_empty());
        all_hold(&mesh);
        all_hold(&mesh.reversed());
        let block = Arc::new(extrude(&mesh, Extrude::FaceNormal, 3.0));
        all_hold(&block);
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let cut = cut::slabs(&block, axis, &[-1.25, -0.5, 0.75, 1.5]);
            cut.parts.iter().flatten().for_each(|part| all_hold(part));
            assert!(cut.parts.iter().flatten().count() > 1, "{axis:?}");
        }
        assert_eq!(square(&[10]).unwrap_err(), MeshError::UvSet { set: 10 });
    }

    #[test]
    fn coordinates_are_replaced_by_finite_ones() {
        let mesh = square(&[0]).unwrap();
        let odd = [DVec2::new(f64::INFINITY, 1.0), DVec2::new(f64::NAN, f64::NEG_INFINITY), DVec2::ONE, DVec2::ZERO];
        let changed = mesh.with_uv_set(3, odd.to_vec());
        assert_eq!(changed.uv_set(3)[..2], [DVec2::new(f64::MAX, 1.0), DVec2::new(0.0, -f64::MAX)]);
        assert_eq!((changed.uvs(), changed.check()), (mesh.uvs(), Vec::new()));
        assert!(changed.with_uv_set(3, Vec::new()).uv_set(3).is_empty());
    }
}
