//! The arcs of rings: their sides, each from a point to the next one.

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

/// The arcs of some faces, sorted, each with the number of the face on its left.
#[derive(Debug)]
pub(super) struct Lefts(Vec<([u32; 2], usize)>);

impl Lefts {
    /// The arcs of faces with some rings.
    pub(super) fn of<'r>(rings: impl Iterator<Item = &'r [u32]>) -> Self {
        let mut all: Vec<_> =
            rings.enumerate().flat_map(|(face, ring)| arcs(ring).map(move |arc| (arc, face))).collect();
        all.sort_unstable();
        // Of two faces with one arc, the later one counts.
        all.dedup_by(|next, kept| {
            let is_same = next.0 == kept.0;
            if is_same {
                kept.1 = next.1;
            }
            is_same
        });
        Lefts(all)
    }

    /// The face on the left of an arc.
    pub(super) fn face(&self, arc: [u32; 2]) -> Option<usize> {
        self.0.binary_search_by_key(&arc, |found| found.0).ok().map(|index| self.0[index].1)
    }

    /// All arcs in their order, each with its face.
    pub(super) fn iter(&self) -> impl Iterator<Item = ([u32; 2], usize)> + '_ {
        self.0.iter().copied()
    }
}
