//! Changing texture sets as a whole. What changes nothing gives nothing: the caller keeps its mesh.

use std::ops::Range;

use glam::{DAffine2, DVec2};

use super::{UvExtent, UvSets};
use crate::mesh::Mesh;

/// The coordinates that `normalizeUV` changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NormalizeUv {
    /// Both, each by its own range.
    Both,
    /// Both, by the larger of the two ranges, so that proportions stay.
    Uniform,
    /// The first one.
    U,
    /// The second one.
    V,
}

/// The faces that `normalizeUV` takes together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NormalizeFaces {
    /// Each face by its own range.
    Separate,
    /// All faces by the range of all.
    Collective,
}

/// The tiles of `tileUV` along one coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tiles {
    /// The coordinate stays as it is.
    Keep,
    /// Tiles of a size in metres on the surface; negative ones mirror, and 0 keeps the coordinate.
    Metres(f64),
    /// A number of tiles on all of the range; a negative one mirrors, and 0 keeps the coordinate.
    Count(f64),
}

impl Tiles {
    /// The factor for a coordinate with a range and an extent in metres.
    fn factor(self, range: f64, metres: f64) -> f64 {
        let factor = match self {
            Tiles::Keep => 1.0,
            Tiles::Metres(size) => metres / range / size,
            Tiles::Count(count) => count / range,
        };
        if factor.is_finite() && factor != 0.0 { factor } else { 1.0 }
    }
}

impl Mesh {
    /// The mesh with other coordinates in a set, one pair a corner, or without the set if there are none. Coordinates that
    /// are infinite become the largest numbers, and NaN becomes 0.
    ///
    /// # Panics
    /// When the number of coordinates is another one, or the set is none of 0 to 9.
    pub fn with_uv_set(&self, set: usize, mut uvs: Vec<DVec2>) -> Mesh {
        assert!(set < UvSets::MOST && [0, self.corners.len()].contains(&uvs.len()), "{} coordinates", uvs.len());
        uvs.iter_mut().filter(|uv| !uv.is_finite()).for_each(|uv| {
            let finite = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(-f64::MAX, f64::MAX) };
            *uv = DVec2::new(finite(uv.x), finite(uv.y));
        });
        let mut mesh = self.clone();
        mesh.uvs.set(set, uvs);
        mesh.uvs.forget_empty();
        mesh
    }

    /// The mesh with the coordinates of a set mapped: `translateUV`, `scaleUV`, `rotateUV`. Nothing if it does not have the
    /// set.
    pub fn map_uvs(&self, set: usize, map: &DAffine2) -> Option<Mesh> {
        let uvs = self.uv_set(set);
        let mapped = uvs.iter().map(|&uv| map.transform_point2(uv)).collect();
        (!uvs.is_empty()).then(|| self.with_uv_set(set, mapped))
    }

    /// The mesh with the coordinates of a set moved and scaled to [0, 1] (*normalizeUV operation*). A coordinate without a
    /// range becomes 0. Nothing if the mesh does not have the set.
    pub fn normalize_uvs(&self, set: usize, mode: NormalizeUv, faces: NormalizeFaces) -> Option<Mesh> {
        let mut uvs = self.uv_set(set).to_vec();
        if uvs.is_empty() {
            return None;
        }
        match faces {
            NormalizeFaces::Collective => normalize(&mut uvs, mode),
            NormalizeFaces::Separate => {
                let ranges: Vec<Range<usize>> = self.faces().map(|face| face.corner_range()).collect();
                ranges.into_iter().for_each(|range| normalize(&mut uvs[range], mode));
            }
        }
        Some(self.with_uv_set(set, uvs))
    }

    /// The mesh with the coordinates of a set scaled about (0, 0), so that tiles have a size on the surface (*tileUV
    /// operation*). Tiles begin at 0, whatever the range. A coordinate without a range, or a surface without area, stays as
    /// it is. Nothing if the mesh does not have the set.
    ///
    /// The extent is that of [`Mesh::uv_extent`] for this set.
    pub fn tile_uvs(&self, set: usize, extent: &UvExtent, u: Tiles, v: Tiles) -> Option<Mesh> {
        let size = extent.size();
        let factors = DVec2::new(u.factor(size.x, extent.metres.x), v.factor(size.y, extent.metres.y));
        self.map_uvs(set, &DAffine2::from_scale(factors))
    }

    /// The mesh with a copy of a set in another one (*copyUV operation*). Nothing if it does not have the set, or the sets are
    /// the same or none of 0 to 9.
    pub fn copy_uvs(&self, from: usize, to: usize) -> Option<Mesh> {
        let uvs = self.uv_set(from);
        (!uvs.is_empty() && from != to && to < UvSets::MOST).then(|| self.with_uv_set(to, uvs.to_vec()))
    }

    /// The mesh without a set (*deleteUV operation*). Nothing if it does not have the set.
    pub fn delete_uvs(&self, set: usize) -> Option<Mesh> {
        (!self.uv_set(set).is_empty()).then(|| self.with_uv_set(set, Vec::new()))
    }
}

fn normalize(uvs: &mut [DVec2], mode: NormalizeUv) {
    let none = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let (low, high) = uvs.iter().fold(none, |(low, high), &uv| (low.min(uv), high.max(uv)));
    // Halves of the largest numbers have a difference.
    let half = if (high - low).is_finite() { 1.0 } else { 0.5 };
    let mut size = high * half - low * half;
    if mode == NormalizeUv::Uniform {
        size = DVec2::splat(size.max_element());
    }
    let changed = [mode != NormalizeUv::V, mode != NormalizeUv::U];
    for axis in (0..2).filter(|&axis| changed[axis]) {
        for uv in &mut *uvs {
            let offset = uv[axis] * half - low[axis] * half;
            uv[axis] = if size[axis] == 0.0 { 0.0 } else { offset / size[axis] };
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::mesh::{FaceTag, MeshBuilder};

    /// Two squares of 10 beside each other, with these coordinates.
    fn mesh(uvs: [[[f64; 2]; 4]; 2]) -> Mesh {
        let mut builder = MeshBuilder::new();
        for (x, uvs) in [0.0, 10.0].into_iter().zip(uvs) {
            let corners = [[x, 0.0], [x + 10.0, 0.0], [x + 10.0, 10.0], [x, 10.0]];
            let corners = corners.map(|[x, y]| builder.point([x, y, 0.0]));
            builder.face(&corners, &[], FaceTag::PLAIN).uvs(&uvs.map(DVec2::from));
        }
        builder.build().unwrap()
    }

    fn strip() -> Mesh {
        mesh([[[2.0, 1.0], [4.0, 1.0], [4.0, 2.0], [2.0, 2.0]], [[4.0, 1.0], [6.0, 1.0], [6.0, 2.0], [4.0, 2.0]]])
    }

    fn range(mesh: &Mesh) -> [[f64; 2]; 2] {
        mesh.uv_range(0).unwrap().map(|uv| uv.to_array())
    }

    #[test]
    fn coordinates_are_normalized_in_every_mode() {
        use NormalizeFaces::{Collective, Separate};
        let of = |mode, faces| strip().normalize_uvs(0, mode, faces).unwrap();
        assert_eq!(range(&of(NormalizeUv::Both, Collective)), [[0.0, 0.0], [1.0, 1.0]]);
        assert_eq!(range(&of(NormalizeUv::Uniform, Collective)), [[0.0, 0.0], [1.0, 0.25]]);
        assert_eq!(range(&of(NormalizeUv::U, Collective)), [[0.0, 1.0], [1.0, 2.0]]);
        assert_eq!(range(&of(NormalizeUv::V, Collective)), [[2.0, 0.0], [6.0, 1.0]]);
        assert_eq!(of(NormalizeUv::Both, Collective).uvs()[1], DVec2::new(0.5, 0.0));
        let separate = of(NormalizeUv::Both, Separate);
        assert_eq!(separate.uvs()[..4], separate.uvs()[4..]);
        assert_eq!(separate.uvs()[..3], [DVec2::ZERO, DVec2::X, DVec2::ONE]);
    }

    #[test]
    fn constant_and_huge_coordinates_stay_finite() {
        let constant = mesh([[[3.0, -7.0]; 4]; 2]);
        let huge = mesh([[[-f64::MAX, 0.0], [f64::MAX, 0.0], [f64::MAX, 1.0], [0.0, 1.0]]; 2]);
        for mode in [NormalizeUv::Both, NormalizeUv::Uniform, NormalizeUv::U, NormalizeUv::V] {
            let of = |mesh: &Mesh| mesh.normalize_uvs(0, mode, NormalizeFaces::Separate).unwrap();
            assert!(of(&constant).uvs().iter().all(|uv| [0.0, 3.0].contains(&uv.x) && [0.0, -7.0].contains(&uv.y)));
            assert!(of(&huge).uvs().iter().all(|uv| uv.is_finite()));
        }
        assert_eq!(huge.normalize_uvs(0, NormalizeUv::U, NormalizeFaces::Collective).unwrap().uvs()[3].x, 0.5);
        let far = huge.map_uvs(0, &DAffine2::from_scale(DVec2::splat(8.0))).unwrap();
        assert_eq!(far.uvs()[1], DVec2::new(f64::MAX, 0.0));
        let extent = constant.uv_extent(0, DVec3::ONE).unwrap();
        let tiled = constant.tile_uvs(0, &extent, Tiles::Metres(2.0), Tiles::Count(3.0)).unwrap();
        assert_eq!(tiled.uvs(), constant.uvs());
    }

    #[test]
    fn tiles_have_their_size_on_the_surface() {
        let unit = strip().normalize_uvs(0, NormalizeUv::Both, NormalizeFaces::Collective).unwrap();
        let extent = unit.uv_extent(0, DVec3::ONE).unwrap();
        assert_eq!(extent.metres, DVec2::new(20.0, 10.0));
        let of = |u, v| range(&unit.tile_uvs(0, &extent, u, v).unwrap())[1];
        assert_eq!(of(Tiles::Metres(5.0), Tiles::Metres(0.0)), [4.0, 1.0]);
        assert_eq!(of(Tiles::Count(3.0), Tiles::Keep), [3.0, 1.0]);
        let mirrored = unit.tile_uvs(0, &extent, Tiles::Metres(-4.0), Tiles::Metres(2.5)).unwrap();
        assert_eq!(range(&mirrored), [[-5.0, 0.0], [0.0, 4.0]]);
        // The street of *tileUV operation*: about 80 m by 14 m, (20, 10) leaves a part of the second row.
        assert_eq!(of(Tiles::Metres(20.0), Tiles::Metres(7.5)), [1.0, 10.0 / 7.5]);
    }

    #[test]
    fn sets_are_copied_and_deleted() {
        let mesh = strip();
        let copy = mesh.copy_uvs(0, 9).unwrap();
        assert_eq!(copy.uv_set(9), mesh.uvs());
        assert!(mesh.copy_uvs(1, 2).is_none() && mesh.copy_uvs(0, 10).is_none() && mesh.copy_uvs(0, 0).is_none());
        let back = copy.delete_uvs(0).unwrap();
        assert!(back.uvs().is_empty() && back.uv_set(9) == mesh.uvs() && back.check().is_empty());
        assert!(back.delete_uvs(9).unwrap().uvs.is_empty() && back.delete_uvs(0).is_none());
        assert!(mesh.map_uvs(3, &DAffine2::IDENTITY).is_none());
    }
}
