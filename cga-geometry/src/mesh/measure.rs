//! Measures of a whole mesh. The bounds and whether it is closed are cached.

use glam::DVec3;

use super::face::area_vector_of_few;
use super::pair_table::PairTable;
use super::{Bounds, FaceRef, Mesh};
use crate::each::Each;
use crate::tol::VOLUME_EPSILON;
use crate::vector::{unit, well_scaled};
use crate::work;

/// The units of work of counting an edge.
const EDGE: usize = 16;

/// The units of work of a corner for the normal of its face.
const NORMAL: usize = 4;

/// The corners of one loop that are counted at once.
const CORNERS_A_QUESTION: usize = 4096;

impl Mesh {
    /// The bounding box of all points; [`Bounds::EMPTY`] for a mesh without faces.
    pub fn bounds(&self) -> Bounds {
        *self.derived.bounds.get_or_init(|| Bounds::of(self.points.iter().copied()))
    }

    /// Returns true if the faces enclose a volume: each edge is used equally often in both directions. False for a mesh
    /// without faces. Also false if the work of a [`Supervisor`](crate::work::Supervisor) ends before all edges are counted.
    pub fn is_closed(&self) -> bool {
        self.whether_closed().unwrap_or(false)
    }

    /// [`is_closed`](Self::is_closed). `None` if the work is to end; then nothing is cached, as others may hold this mesh.
    pub(crate) fn whether_closed(&self) -> Option<bool> {
        if let Some(closed) = self.derived.closed.get() {
            return Some(*closed);
        }
        self.count_closed().map(|closed| *self.derived.closed.get_or_init(|| closed))
    }

    /// [`is_closed`](Self::is_closed), counted again. `None` if the work is to end.
    pub(crate) fn count_closed(&self) -> Option<bool> {
        if self.is_empty() {
            return Some(false);
        }
        let mut net = PairTable::with_capacity(self.corners.len() / 2 + 1);
        let mut start = 0;
        for &end in &self.loop_ends {
            let ring = &self.corners[start..end as usize];
            start = end as usize;
            let mut a = ring[ring.len() - 1];
            for part in ring.chunks(CORNERS_A_QUESTION) {
                if !work::spend(EDGE * part.len()) {
                    return None;
                }
                for &b in part {
                    let (value, _) = net.entry(a.min(b), a.max(b), 0);
                    *value = if a < b { value.wrapping_add(1) } else { value.wrapping_sub(1) };
                    a = b;
                }
            }
        }
        Some(net.pairs().all(|(_, count)| count == 0))
    }

    /// The unit normal of each face; zero for a face without area.
    pub fn face_normals(&self) -> Vec<DVec3> {
        let Some(ends) = self.loop_ends_of_polygons() else { return self.faces().map(|face| face.normal()).collect() };
        let mut start = 0;
        let normal = |(index, &end): (usize, &u32)| {
            let corners = &self.corners[std::mem::replace(&mut start, end as usize)..end as usize];
            match area_vector_of_few(corners, |point| self.points[point as usize]) {
                Some(sum) => unit(well_scaled(sum, || self.face(index).area_vector_at_one())),
                None => self.face(index).normal(),
            }
        };
        ends.iter().enumerate().map(normal).collect()
    }

    /// The normal of each face. `None` if the work is to end.
    pub(crate) fn face_normals_in_time(&self) -> Option<Vec<DVec3>> {
        let normal = |face: FaceRef<'_>| work::spend(NORMAL * face.corner_count()).then(|| face.normal());
        self.faces().map(normal).collect()
    }

    /// The unit normals of all faces, for algorithms that move along them: zero for faces thinner than rounding, whose normals mean
    /// nothing. `None` if the work is to end.
    pub(crate) fn sound_normals_in_time(&self) -> Option<Vec<DVec3>> {
        let normal = |face: FaceRef<'_>| if face.is_thin() { DVec3::ZERO } else { face.normal() };
        self.faces().map(|face| work::spend(NORMAL * face.corner_count()).then(|| normal(face))).collect()
    }

    /// The area of all faces, in square metres.
    pub fn area(&self) -> f64 {
        // The empty sum is −0.
        self.faces().map(|face| face.area()).sum::<f64>() + 0.0
    }

    /// The enclosed volume in cubic metres, negative if the faces look inwards. For an open mesh, the signed volume of the cone from
    /// the centre of its bounds to its faces. If the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile, the sum so far.
    pub fn volume(&self) -> f64 {
        self.volume_of(|p| p)
    }

    /// The volume of the mesh after it is enlarged by a factor: volumes of very large and very small meshes overflow or vanish.
    pub(crate) fn scaled_volume(&self, scale: f64) -> f64 {
        self.volume_of(|p| p * scale)
    }

    /// Returns true if the mesh is closed and its faces look inwards.
    pub(crate) fn is_inside_out(&self) -> bool {
        let bounds = self.bounds();
        let scale = bounds.scale_to_one();
        let size = (bounds.high * scale - bounds.low * scale).max_element();
        self.is_closed() && self.scaled_volume(scale) < -VOLUME_EPSILON * size * size * size
    }

    /// The volume after `place` is applied to the points relative to the centre. If the work is to end, the sum so far.
    #[inline(always)]
    fn volume_of(&self, place: impl Fn(DVec3) -> DVec3) -> f64 {
        if self.is_empty() {
            return 0.0;
        }
        let bounds = self.bounds();
        let centre = bounds.low * 0.5 + bounds.high * 0.5;
        let mut sum = 0.0;
        for face in self.faces() {
            if !work::spend(face.corner_count()) {
                break;
            }
            let mut six = 0.0;
            if face.is_bent() {
                let place = |point: DVec3| place(point - centre);
                let triangles = face.bent_triangles().into_iter();
                sum += triangles.map(|triangle| triangle.each(place)).map(|[a, b, c]| a.dot(b.cross(c))).sum::<f64>();
                continue;
            }
            for ring in face.loops() {
                let at = |i: usize| place(self.points[ring[i] as usize] - centre);
                let first = at(0);
                let mut fan = DVec3::ZERO;
                for i in 1..ring.len() - 1 {
                    fan += (at(i) - first).cross(at(i + 1) - first);
                }
                six += first.dot(fan);
            }
            sum += six;
        }
        sum / 6.0
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::rc::Rc;

    use glam::DVec3;

    use crate::Axis;
    use crate::mesh::join::join;
    use crate::mesh::{Derived, Mesh};
    use crate::primitive;
    use crate::work::Supervisor;

    #[test]
    fn normals_of_all_faces_are_the_normals_of_each() {
        let square = |low: f64, high: f64| {
            [[low, low], [high, low], [high, high], [low, high]].map(|[x, z]| DVec3::new(x, 0.0, -z))
        };
        let ring = Mesh::from_polygon(&square(0.0, 9.0), &[square(3.0, 6.0).to_vec()]).expect("a ring");
        let tiny = primitive::sphere(9, 7)
            .with_points(primitive::sphere(9, 7).points.iter().map(|point| *point * 1e-200).collect());
        for mesh in [primitive::sphere(9, 7), primitive::cylinder(5), primitive::disk(3, Axis::Y), ring, tiny] {
            let bits = |normal: DVec3| normal.to_array().map(f64::to_bits);
            let all: Vec<_> = mesh.face_normals().into_iter().map(bits).collect();
            let each: Vec<_> = mesh.faces().map(|face| bits(face.normal())).collect();
            assert_eq!(all, each);
            assert!(mesh.faces().all(|face| face.normal().is_normalized()));
        }
    }

    #[test]
    fn a_count_that_has_ended_early_is_not_kept() {
        for (mesh, is_closed) in [(primitive::sphere(100, 100), true), (primitive::disk(100_000, Axis::Y), false)] {
            let mesh = Mesh { derived: Derived::default(), ..mesh };
            let asked = Rc::new(Cell::new(0));
            let count = asked.clone();
            let supervisor = Supervisor::new(move |_| count.replace(count.get() + 1) < 1);
            assert_eq!((mesh.whether_closed(), asked.get()), (None, 2));
            let joined = join([&mesh, &mesh].into_iter());
            drop(supervisor);
            assert_eq!((mesh.is_closed(), joined.is_empty()), (is_closed, true));
        }
    }
}
