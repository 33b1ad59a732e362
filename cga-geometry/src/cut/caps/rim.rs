//! The edges of pieces in the cut planes, and the edges without a partner among them.
//!
//! A side of a plane is closed there if each of its edges in the plane is used equally often in both directions. Caps
//! must bound the missing edges. If both sides together lack the same edge, the mesh itself is open along it, and no
//! cap ends there.

use crate::buckets::Buckets;
use crate::each::Each;
use crate::long_sort::long_sort_by;

/// The side of a plane that a face is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlaneSide {
    Below,
    Above,
}

impl PlaneSide {
    /// The side of a face in a slab that touches a plane.
    pub(crate) fn of(slab: u32, plane: u32) -> Self {
        if slab == plane { PlaneSide::Below } else { PlaneSide::Above }
    }
}

/// An edge in a plane, directed as in its face.
#[derive(Clone, Copy)]
struct PlaneEdge {
    plane: u32,
    a: u32,
    b: u32,
}

/// All edges in all planes.
#[derive(Default)]
pub(crate) struct Rim {
    /// Edges made by a cut: the face below has them in this direction, the face above in the opposite direction.
    cuts: Vec<PlaneEdge>,
    /// All other uses of edges, with ends in increasing order. Each is 1 or -1 by its direction, for a face below or
    /// for a face above.
    edges: Vec<(PlaneEdge, [i32; 2])>,
    /// `cuts` by planes.
    by_plane: Buckets,
}

impl Rim {
    /// The number of edges that the buffers can hold.
    pub(crate) fn capacity(&self) -> usize {
        self.cuts.capacity() + self.edges.capacity()
    }

    pub(crate) fn reset(&mut self) {
        self.cuts.clear();
        self.edges.clear();
    }

    #[inline]
    pub(crate) fn cut(&mut self, plane: u32, a: u32, b: u32) {
        self.cuts.push(PlaneEdge { plane, a, b });
    }

    pub(crate) fn edge(&mut self, plane: u32, a: u32, b: u32, side: PlaneSide) {
        let by = if a < b { 1 } else { -1 };
        let count = if side == PlaneSide::Below { [by, 0] } else { [0, by] };
        self.edges.push((PlaneEdge { plane, a: a.min(b), b: a.max(b) }, count));
    }

    /// Prepares calls of [`Rim::missing`]. Returns false if the work is to end.
    #[must_use]
    pub(crate) fn sort(&mut self, planes: usize) -> bool {
        let key = |(edge, _): &(PlaneEdge, [i32; 2])| (edge.plane, edge.a, edge.b);
        if !long_sort_by(&mut self.edges, |a, b| key(a).cmp(&key(b))) {
            return false;
        }
        self.by_plane.fill(planes, self.cuts.iter().map(|cut| cut.plane));
        true
    }

    /// The edges that the cap of the side below a plane must have: the reversed edges of its faces without a partner.
    /// The cap above has the same edges in the opposite direction.
    pub(crate) fn missing(&self, plane: usize, out: &mut Vec<[u32; 2]>) {
        out.clear();
        let cuts = self.by_plane.of(plane).iter().map(|&cut| self.cuts[cut as usize]);
        out.extend(cuts.map(|cut| [cut.b, cut.a]));
        let [start, end] =
            [plane, plane + 1].each(|plane| self.edges.partition_point(|(edge, _)| (edge.plane as usize) < plane));
        for same in self.edges[start..end].chunk_by(|(e, _), (f, _)| (e.a, e.b) == (f.a, f.b)) {
            let [below, above] = same.iter().fold([0; 2], |net, (_, count)| [net[0] + count[0], net[1] + count[1]]);
            // Edges that both sides lack, each in the opposite direction.
            if below.signum() * above.signum() < 0 {
                let PlaneEdge { a, b, .. } = same[0].0;
                let edge = if below > 0 { [b, a] } else { [a, b] };
                out.extend(std::iter::repeat_n(edge, below.abs().min(above.abs()) as usize));
            }
        }
    }
}
