//! Edges of a mesh → their crossings.
//!
//! An edge hangs on the end with the lower index, in a list: faces that follow each other in a mesh share points, so what is
//! looked for is near what was looked for before, which a hash table would undo. Where very many edges meet in a point, those
//! after the first ones are in such a table all the same.

use crate::geometry::mesh::table::PairTable;

/// No link.
const END: u32 = u32::MAX;

/// How many edges a list has at most.
const CROWD: usize = 16;

/// How many edges of a list are looked at ahead of time.
const NEAR: usize = 4;

/// Edge → number.
#[derive(Default)]
pub(super) struct Edges {
    /// Of each point, its first link.
    heads: Vec<u32>,
    links: Vec<Link>,
    crowded: PairTable,
}

struct Link {
    /// The other end.
    end: u32,
    number: u32,
    next: u32,
}

impl Edges {
    /// Forgets everything; there are so many points.
    pub(super) fn reset(&mut self, points: usize) {
        self.heads.clear();
        self.heads.resize(points, END);
        self.links.clear();
        self.crowded.clear();
    }

    /// The number of an edge, which becomes `initial` when it is new, and whether it is.
    #[inline(always)]
    pub(super) fn entry(&mut self, a: u32, b: u32, initial: u32) -> (u32, bool) {
        let (low, high) = (a.min(b), a.max(b));
        let (mut last, mut at) = (END, self.heads[low as usize]);
        for _ in 0..CROWD {
            if at == END {
                let new = self.links.len() as u32;
                self.links.push(Link { end: high, number: initial, next: END });
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

    /// Where the list with an edge starts, given its lower end.
    #[inline]
    pub(super) fn head(&self, low: u32) -> u32 {
        self.heads[low as usize]
    }

    /// The number of an edge that is near the start of its list.
    #[inline]
    pub(super) fn near(&self, head: u32, high: u32) -> Option<u32> {
        let mut at = head;
        for _ in 0..NEAR {
            let link = self.links.get(at as usize)?;
            if link.end == high {
                return Some(link.number);
            }
            at = link.next;
        }
        None
    }

    /// All edges, as their ends, and their numbers, in no useful order.
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
