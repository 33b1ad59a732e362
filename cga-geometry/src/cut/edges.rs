//! A map from edges of a mesh to their crossings.
//!
//! Each edge is in a list at the end with the lower index. Neighbouring faces of a mesh share points, so successive
//! look-ups access nearby memory; a hash table would lose this locality. Where very many edges meet at a point, the
//! edges after the first ones are in a hash table nevertheless.

use crate::mesh::pair_table::PairTable;

/// The end of a list.
const END: u32 = u32::MAX;

/// The largest number of edges in a list.
const CROWD: usize = 16;

/// A map from edges to numbers.
#[derive(Default)]
pub(super) struct Edges {
    /// The first link of each point.
    heads: Vec<u32>,
    links: Vec<EdgeEntry>,
    crowded: PairTable,
}

struct EdgeEntry {
    /// The other end.
    end: u32,
    number: u32,
    next: u32,
}

impl Edges {
    /// Clears the map for a mesh with `points` points.
    pub(super) fn reset(&mut self, points: usize) {
        self.heads.clear();
        self.heads.resize(points, END);
        self.links.clear();
        self.crowded.clear();
    }

    /// The number of an edge, and whether the edge is new. A new edge gets the number `initial`.
    #[inline(always)]
    pub(super) fn entry(&mut self, a: u32, b: u32, initial: u32) -> (u32, bool) {
        let (low, high) = (a.min(b), a.max(b));
        let (mut last, mut at) = (END, self.heads[low as usize]);
        for _ in 0..CROWD {
            if at == END {
                let new = self.links.len() as u32;
                self.links.push(EdgeEntry { end: high, number: initial, next: END });
                *(if last == END { &mut self.heads[low as usize] } else { &mut self.links[last as usize].next }) = new;
                return (initial, true);
            }
            let link = &self.links[at as usize];
            if link.end == high {
                return (link.number, false);
            }
            (last, at) = (at, link.next);
        }
        let (number, new) = self.crowded.entry(low, high, initial);
        (*number, new)
    }

    /// All edges as pairs of ends, with their numbers, in unspecified order.
    pub(super) fn all(&self) -> impl Iterator<Item = ([u32; 2], u32)> + '_ {
        let list = |(low, &head): (usize, &u32)| {
            let first = self.links.get(head as usize);
            let links = std::iter::successors(first, |link| self.links.get(link.next as usize));
            links.map(move |link| ([low as u32, link.end], link.number))
        };
        self.heads.iter().enumerate().flat_map(list).chain(self.crowded.pairs())
    }
}

#[cfg(test)]
mod tests {
    use super::Edges;

    #[test]
    fn an_edge_is_found_either_way_round_also_in_a_crowd() {
        let mut edges = Edges::default();
        edges.reset(100);
        for end in 1..100 {
            assert_eq!(edges.entry(0, end, 10 * end), (10 * end, true));
        }
        for end in 1..100 {
            assert_eq!(edges.entry(end, 0, 7), (10 * end, false));
        }
        let mut all: Vec<_> = edges.all().collect();
        all.sort_unstable();
        assert!(all.into_iter().eq((1..100).map(|end| ([0, end], 10 * end))));
        assert_eq!(edges.entry(5, 6, 8), (8, true));
        edges.reset(100);
        assert_eq!(edges.entry(0, 99, 3), (3, true));
    }
}
