//! Measures of a whole mesh. The bounds and whether it is closed are cached.

use glam::DVec3;

use super::pair_table::PairTable;
use super::{Bounds, Mesh};
use crate::each::Each;
use crate::tol::VOLUME_EPSILON;

impl Mesh {
    /// The bounding box of all points; [`Bounds::EMPTY`] for a mesh without faces.
    pub fn bounds(&self) -> Bounds {
        *self.derived.bounds.get_or_init(|| Bounds::of(self.points.iter().copied()))
    }

    /// Returns true if the faces enclose a volume: each edge is used equally often in both directions. False for a mesh
    /// without faces.
    pub fn is_closed(&self) -> bool {
        *self.derived.closed.get_or_init(|| self.count_closed())
    }

    pub(crate) fn count_closed(&self) -> bool {
        if self.is_empty() {
            return false;
        }
        let mut net = PairTable::with_capacity(self.corners.len() / 2 + 1);
        let mut start = 0;
        for &end in &self.loop_ends {
            let ring = &self.corners[start..end as usize];
            start = end as usize;
            let mut a = ring[ring.len() - 1];
            for &b in ring {
                let (value, _) = net.entry(a.min(b), a.max(b), 0);
                *value = if a < b { value.wrapping_add(1) } else { value.wrapping_sub(1) };
                a = b;
            }
        }
        net.pairs().all(|(_, count)| count == 0)
    }

    /// The area of all faces, in square metres.
    pub fn area(&self) -> f64 {
        // The empty sum is −0.
        self.faces().map(|face| face.area()).sum::<f64>() + 0.0
    }

    /// The enclosed volume in cubic metres, negative if the faces look inwards. For an open mesh, the signed volume of the cone from
    /// the centre of its bounds to its faces.
    pub fn volume(&self) -> f64 {
        self.volume_of(|p| p)
    }

    /// Returns true if the mesh is closed and its faces look inwards.
    pub(crate) fn is_inside_out(&self) -> bool {
        let bounds = self.bounds();
        let scale = bounds.scale_to_one();
        let size = (bounds.high * scale - bounds.low * scale).max_element();
        self.is_closed() && self.volume_of(|p| p * scale) < -VOLUME_EPSILON * size * size * size
    }

    /// The volume after `place` is applied to the points relative to the centre.
    #[inline(always)]
    fn volume_of(&self, place: impl Fn(DVec3) -> DVec3) -> f64 {
        if self.is_empty() {
            return 0.0;
        }
        let bounds = self.bounds();
        let centre = bounds.low * 0.5 + bounds.high * 0.5;
        let mut sum = 0.0;
        for face in self.faces() {
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
