//! The values of new corners: texture coordinates and normals, as mixes of the values at the corners of an old face.

use std::ops::Range;

use glam::{DMat2, DVec2, DVec3};

use super::{FaceOrigin, PointOrigin};
use crate::each::Each;
use crate::mesh::{Mesh, unit};
use crate::small_sort::SmallSort;
use crate::work;

/// The values of a corner, as values of corners of the old mesh.
pub(crate) enum Mix<'w> {
    /// The values of a corner.
    One(u32),
    /// Values between two corners, at a share of the way.
    Two([u32; 2], f64),
    /// The values of three corners with weights.
    Three([(u32, f64); 3]),
    /// The values of some corners with weights, which add up to 1.
    All(Range<usize>, &'w [f64]),
}

impl Mesh {
    /// Adds the values of a corner, as a mix of values of corners of this mesh.
    pub(crate) fn add_own_mixed(&mut self, mix: &Mix<'_>) {
        for list in self.uvs.lists_mut() {
            list.push(mixed(list, mix));
        }
        if !self.normals.is_empty() {
            self.normals.push(mixed_normal(&self.normals, mix));
        }
    }

    /// Adds the values of a corner of this mesh again.
    pub(super) fn add_again(&mut self, corner: usize, has_normals: bool) {
        for list in self.uvs.lists_mut() {
            list.push(list[corner]);
        }
        if has_normals {
            self.normals.push(self.normals[corner]);
        }
    }

    /// Adds the values of a corner. With `is_turned` its face looks in the opposite direction of the old one.
    pub(super) fn add_mixed(&mut self, source: &Mesh, mix: &Mix<'_>, has_normals: bool, is_turned: bool) {
        for (to, from) in self.uvs.lists_mut_beside(&source.uvs) {
            to.push(mixed(from, mix));
        }
        if has_normals {
            let normal = mixed_normal(&source.normals, mix);
            self.normals.push(if is_turned { -normal } else { normal });
        }
    }
}

/// A mix of texture coordinates.
#[inline]
fn mixed(list: &[DVec2], mix: &Mix<'_>) -> DVec2 {
    match mix {
        Mix::One(corner) => list[*corner as usize],
        Mix::Two([a, b], share) => list[*a as usize].lerp(list[*b as usize], *share),
        Mix::Three(corners) => corners.iter().map(|(corner, weight)| list[*corner as usize] * *weight).sum(),
        Mix::All(corners, weights) => {
            list[corners.clone()].iter().zip(*weights).map(|(&uv, &weight)| uv * weight).sum()
        }
    }
}

/// A mix of normals, of length 1.
#[inline]
fn mixed_normal(list: &[DVec3], mix: &Mix<'_>) -> DVec3 {
    match mix {
        Mix::One(corner) => list[*corner as usize],
        Mix::Two([a, b], share) => {
            let [a, b] = [a, b].each(|corner| list[*corner as usize]);
            a.lerp(b, *share).normalize_or(a)
        }
        Mix::Three(corners) => unit(corners.iter().map(|(corner, weight)| list[*corner as usize] * *weight).sum()),
        Mix::All(corners, weights) => {
            unit(list[corners.clone()].iter().zip(*weights).map(|(&normal, &weight)| normal * weight).sum())
        }
    }
}

/// The corners of a face of the old mesh by their points, and its plane.
pub(super) struct OldFace<'s> {
    source: &'s Mesh,
    face: Option<u32>,
    range: Range<usize>,
    /// The points and corners of a face with many corners, sorted.
    by_point: Vec<(u32, u32)>,
    plane: Option<Continued>,
    weights: Vec<f64>,
    /// The last place whose values were continued, if its face was turned, and the corner of the new mesh there.
    last: Option<(DVec3, bool, usize)>,
}

impl<'s> OldFace<'s> {
    /// The number of corners up to which corners are found one by one.
    const FEW: usize = 16;

    pub(super) fn new(source: &'s Mesh) -> Self {
        OldFace { source, face: None, range: 0..0, by_point: Vec::new(), plane: None, weights: Vec::new(), last: None }
    }

    /// Goes to a face.
    pub(super) fn enter(&mut self, face: u32) {
        if self.face.replace(face) == Some(face) {
            return;
        }
        self.range = self.source.face_corners(face as usize);
        self.plane = None;
        self.last = None;
        self.by_point.clear();
        if Self::FEW < self.range.len() {
            let corners = self.range.clone().map(|corner| (self.source.corners()[corner], corner as u32));
            self.by_point.extend(corners);
            self.by_point.small_sort();
        }
    }

    /// The values at a place of a loop of new points, in a face with that origin, if they are values of one or two corners.
    pub(super) fn mix_at(
        &self,
        ring: &[u32],
        place: usize,
        origins: &[PointOrigin],
        origin: &FaceOrigin,
    ) -> Option<Mix<'static>> {
        let known = |place: usize| match origins[ring[place % ring.len()] as usize] {
            PointOrigin::Old(point) | PointOrigin::Moved(point) => Some(point),
            PointOrigin::Between { .. } | PointOrigin::Grown | PointOrigin::New => None,
        };
        // In the direction of the old face.
        let beside = || {
            let [before, next] = [place + ring.len() - 1, place + 1].each(known);
            if origin.is_turned() { [next, before] } else { [before, next] }
        };
        match origins[ring[place] as usize] {
            PointOrigin::Old(point) | PointOrigin::Moved(point) => {
                self.corner(point, origin.edge(), &beside).map(Mix::One)
            }
            PointOrigin::Between { ends, share } => match ends.each(|end| self.corner(end, origin.edge(), &beside)) {
                [Some(a), Some(b)] => Some(Mix::Two([a, b], share)),
                _ => None,
            },
            PointOrigin::Grown | PointOrigin::New => None,
        }
    }

    /// The corner of the new mesh with the last values that [`continued`](OldFace::continued) gave, if they are of this place.
    pub(super) fn continued_before(&self, at: DVec3, is_turned: bool) -> Option<usize> {
        self.last.filter(|last| (last.0, last.1) == (at, is_turned)).map(|last| last.2)
    }

    /// The corner at a point.
    fn corner(&self, point: u32, edge: Option<[u32; 2]>, beside: &dyn Fn() -> [Option<u32>; 2]) -> Option<u32> {
        let is_here = |corner: &u32| self.source.corners()[*corner as usize] == point;
        if let Some(corner) = edge.and_then(|edge| edge.into_iter().find(is_here)) {
            return Some(corner);
        }
        if self.by_point.is_empty() {
            let all = || self.range.clone().map(|corner| corner as u32).filter(is_here);
            return self.one_of(&mut all(), beside);
        }
        let from = self.by_point.partition_point(|known| known.0 < point);
        let all = self.by_point[from..].iter().take_while(|known| known.0 == point);
        self.one_of(&mut all.map(|known| known.1), beside)
    }

    /// The first of several corners at one point. If there are more, the first one that has most neighbours in common with the new
    /// corner.
    fn one_of(&self, all: &mut dyn Iterator<Item = u32>, beside: &dyn Fn() -> [Option<u32>; 2]) -> Option<u32> {
        let first = all.next()?;
        let Some(second) = all.next() else { return Some(first) };
        let (wanted, face) = (beside(), self.source.face(self.face? as usize));
        let common = |corner: u32| {
            let ring = face.loop_ranges().find(|ring| ring.contains(&(corner as usize)));
            let ring = ring.unwrap_or(self.range.clone());
            let turn = |by: usize| ring.start + (corner as usize - ring.start + by) % ring.len();
            let own = [turn(ring.len() - 1), turn(1)].each(|corner| Some(self.source.corners()[corner]));
            own.iter().zip(wanted).filter(|(own, wanted)| *own == wanted).count()
        };
        let better = |best: u32, next: u32| if common(best) < common(next) { next } else { best };
        Some(all.fold(better(first, second), better))
    }

    /// The values at a place in the plane of the face, or over it, for a corner of the new mesh.
    pub(super) fn continued(&mut self, at: DVec3, is_turned: bool, corner: usize) -> Mix<'_> {
        self.last = Some((at, is_turned, corner));
        // If the work is to end, the values do not matter.
        if !work::spend(self.range.len()) {
            return Mix::One(self.range.start as u32);
        }
        let OldFace { source, face, range, plane, weights, .. } = self;
        let plane = plane.get_or_insert_with(|| Continued::of(source, face.unwrap_or_default() as usize));
        plane.weights(at, weights);
        Mix::All(range.clone(), weights)
    }
}

/// Extends the values at the corners of a face over its plane, by the best-fitting affine map. The map is exact for projected and
/// other affine texture coordinates.
struct Continued {
    origin: DVec3,
    axes: [DVec3; 2],
    /// The corners in the plane, their mean, and the inverse of their moments about it.
    corners: Vec<DVec2>,
    middle: DVec2,
    inverse: DMat2,
}

impl Continued {
    fn of(mesh: &Mesh, face: usize) -> Self {
        let face = mesh.face(face);
        let origin = face.position(face.corner_range().start);
        let axes = face.plane_axes(face.normal()).unwrap_or([DVec3::ZERO; 2]);
        let flat = |corner: usize| axes.each(|axis| (face.position(corner) - origin).dot(axis)).into();
        let corners: Vec<DVec2> = face.corner_range().map(flat).collect();
        let middle = corners.iter().sum::<DVec2>() / corners.len() as f64;
        let outer = |d: DVec2| DMat2::from_cols(d * d.x, d * d.y);
        let moments = corners.iter().fold(DMat2::ZERO, |sum, &p| sum + outer(p - middle));
        // A face without an area has the mean of its values everywhere.
        let inverse = if moments.determinant() == 0.0 { DMat2::ZERO } else { moments.inverse() };
        Continued { origin, axes, corners, middle, inverse }
    }

    /// The weight of each corner at a place.
    fn weights(&self, at: DVec3, weights: &mut Vec<f64>) {
        let at: DVec2 = self.axes.each(|axis| (at - self.origin).dot(axis)).into();
        let to = self.inverse * (at - self.middle);
        let share = 1.0 / self.corners.len() as f64;
        weights.clear();
        weights.extend(self.corners.iter().map(|&corner| share + to.dot(corner - self.middle)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_map_is_continued() {
        let outline = [[0.0, 0.0], [4.0, 1.0], [5.0, 5.0], [3.0, 6.0], [-2.0, 6.0]];
        let place = |[x, y]: [f64; 2]| DVec3::new(1.0 + x, 2.0 * x + 3.0, -y);
        let mesh = Mesh::from_polygon(&outline.map(place), &[]).expect("a polygon");
        let map = |[x, y]: [f64; 2]| 3.0 * x - 0.5 * y + 7.0;
        let (plane, mut weights) = (Continued::of(&mesh, 0), Vec::new());
        for at in [[10.0, -3.0], [1.0, 1.0]] {
            plane.weights(place(at), &mut weights);
            let value: f64 = weights.iter().zip(outline).map(|(weight, corner)| weight * map(corner)).sum();
            assert!((value - map(at)).abs() < 1e-11, "{value}");
        }
    }
}
