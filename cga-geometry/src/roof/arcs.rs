//! The arcs of rings: their sides, each from a point to the next one.

use crate::buckets::Buckets;

/// The arcs of a ring.
pub(super) fn arcs(ring: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]])
}

/// The union of regions that share arcs, as rings.
pub(super) fn joined<'r>(rings: impl Iterator<Item = &'r [u32]>) -> Vec<Vec<u32>> {
    rings_of(rings.flat_map(arcs))
}

/// Joins arcs to rings. Arcs back and forth are not sides.
pub(super) fn rings_of(arcs: impl Iterator<Item = [u32; 2]>) -> Vec<Vec<u32>> {
    let mut all: Vec<[u32; 2]> = Vec::new();
    for arc in arcs {
        match all.iter().position(|other| *other == [arc[1], arc[0]]) {
            Some(against) => _ = all.remove(against),
            None => all.push(arc),
        }
    }
    let mut found = Vec::new();
    while !all.is_empty() {
        let start = all.remove(0);
        let (mut ring, mut end) = (vec![start[0]], start[1]);
        while end != start[0] {
            let Some(next) = all.iter().position(|arc| arc[0] == end) else { break };
            ring.push(end);
            end = all.remove(next)[1];
        }
        if 3 <= ring.len() {
            found.push(ring);
        }
    }
    found
}

/// The arcs of some faces by their ends, each with the number of the face on its left.
#[derive(Debug)]
pub(super) struct FaceArcs {
    all: Vec<([u32; 2], usize)>,
    from: Buckets,
    to: Buckets,
}

impl FaceArcs {
    /// The arcs of faces with some rings. Points are below `count`.
    pub(super) fn of<'r>(rings: impl Iterator<Item = &'r [u32]>, count: usize) -> Self {
        let all: Vec<_> = rings.enumerate().flat_map(|(face, ring)| arcs(ring).map(move |arc| (arc, face))).collect();
        let by = |end: usize| Buckets::by(count, all.iter().map(|(arc, _)| arc[end]));
        let (from, to) = (by(0), by(1));
        FaceArcs { all, from, to }
    }

    /// Returns the face on the left of an arc. If two faces have the arc, it is the later face.
    pub(super) fn left_of(&self, arc: [u32; 2]) -> Option<usize> {
        let found = self.from.of(arc[0] as usize).iter().rev().map(|&index| self.all[index as usize]);
        found.filter(|found| found.0 == arc).map(|found| found.1).next()
    }

    /// All arcs, each with its face.
    pub(super) fn iter(&self) -> impl Iterator<Item = ([u32; 2], usize)> + '_ {
        self.all.iter().copied()
    }

    /// The arcs from a point and to it, each with the point at its other end and its face.
    pub(super) fn around(&self, point: u32) -> impl Iterator<Item = (u32, usize)> + '_ {
        let found = |&index: &u32| self.all[index as usize];
        let from = self.from.of(point as usize).iter().map(found).map(|([_, end], face)| (end, face));
        from.chain(self.to.of(point as usize).iter().map(found).map(|([end, _], face)| (end, face)))
    }
}
