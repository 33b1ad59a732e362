//! The edges of an arrangement: outlines of facets, and lines where facets meet.

use glam::DVec3;

use super::growing_lists::GrowingLists;
use super::point_set::PointSet;
use crate::mesh::in_order;
use crate::mesh::pair_table::PairTable;
use crate::small_sort::SmallSort;

/// The number for "not a corner".
pub(super) const NO_CORNER: u32 = u32::MAX;

/// A facet in whose plane an edge lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeOwner {
    pub(super) facet: u32,
    /// The number of times that the outline of the facet follows the edge, less the number of times that it follows it
    /// backwards.
    pub(super) count: i32,
    /// The corner of the facet at which the outline's edge starts that contains this edge, or [`NO_CORNER`].
    pub(super) corner: u32,
}

/// An edge between two points, the smaller number first.
#[derive(Clone, Copy, Debug)]
pub(super) struct ArrangedEdge {
    pub(super) ends: [u32; 2],
    /// The direction of the line that the edge is part of, from the first point to the second, and the line's length.
    /// An edge may be so short that its ends do not give a direction.
    pub(super) direction: DVec3,
    length: f64,
}

/// All edges, their numbers by the numbers of their points, and the facets in whose planes they are.
#[derive(Default)]
pub(super) struct EdgeTable {
    pub(super) list: Vec<ArrangedEdge>,
    /// For each edge the facets, in increasing order. Empty if the edge was divided.
    owners: GrowingLists<EdgeOwner>,
    /// For each facet the edges in its plane.
    lines: GrowingLists<u32>,
    /// The number of owners of all edges.
    pub(super) owner_count: usize,
    /// The numbers of edges by their ends, or [`DIVIDED`].
    at: PairTable,
}

/// The number of an edge that was divided.
const DIVIDED: u32 = u32::MAX;

impl EdgeTable {
    pub(super) fn find(&self, ends: [u32; 2]) -> Option<u32> {
        let [a, b] = in_order(ends);
        self.at.get(a, b).filter(|number| *number != DIVIDED)
    }

    /// The facets in whose planes an edge is, in increasing order. None if the edge was divided.
    pub(super) fn owners(&self, edge: u32) -> &[EdgeOwner] {
        self.owners.of(edge)
    }

    /// The edges in the plane of a facet.
    pub(super) fn lines(&self, facet: u32) -> &[u32] {
        self.lines.of(facet)
    }

    /// The owner of an edge that is a facet.
    pub(super) fn owner(&self, edge: u32, facet: u32) -> Option<&EdgeOwner> {
        let owners = self.owners(edge);
        owners.binary_search_by_key(&facet, |owner| owner.facet).ok().map(|at| &owners[at])
    }

    /// Adds an edge to a facet. `count` and `corner` belong to the edge from `a` to `b`. `direction` is the whole line
    /// from `a` to `b`.
    pub(super) fn add(&mut self, [a, b]: [u32; 2], direction: DVec3, owner: EdgeOwner) {
        let (ends, turned) = ([a.min(b), a.max(b)], b < a);
        let (direction, count) = if turned { (-direction, -owner.count) } else { (direction, owner.count) };
        let (number, _) = self.at.entry(ends[0], ends[1], DIVIDED);
        if *number == DIVIDED {
            *number = self.list.len() as u32;
            self.list.push(ArrangedEdge { ends, direction: DVec3::ZERO, length: -1.0 });
        }
        let number = *number;
        let edge = &mut self.list[number as usize];
        let length = direction.length();
        if edge.length < length {
            (edge.direction, edge.length) = (direction / length, length);
        }
        match self.owners.of(number).binary_search_by_key(&owner.facet, |known| known.facet) {
            Ok(at) => {
                let known = &mut self.owners.of_mut(number)[at];
                known.count += count;
                if known.corner == NO_CORNER {
                    known.corner = owner.corner;
                }
            }
            Err(at) => {
                self.owners.insert(number, at, EdgeOwner { count, ..owner });
                self.owner_count += 1;
                self.lines.push(owner.facet, number);
            }
        }
    }

    /// Removes an owner of an edge. The facet still lists the edge, until [`drop_foreign`](Self::drop_foreign).
    pub(super) fn disown(&mut self, edge: u32, facet: u32) {
        let before = self.owners(edge).len();
        self.owners.retain(edge, |owner| owner.facet != facet);
        self.owner_count -= before - self.owners(edge).len();
    }

    /// Drops the lines of a facet that it does not own any more.
    pub(super) fn drop_foreign(&mut self, facet: u32) {
        let owners = &self.owners;
        let is_own = |line: &u32| owners.of(*line).binary_search_by_key(&facet, |owner| owner.facet).is_ok();
        self.lines.retain(facet, is_own);
    }

    /// Divides an edge at points on it. The facets that own it are added to `changed`; they still list the edge, which has no
    /// owners any more.
    pub(super) fn divide(&mut self, points: &PointSet, edge: u32, cuts: &mut [u32], changed: &mut Vec<u32>) {
        let ArrangedEdge { ends, direction, length } = self.list[edge as usize];
        let owners = self.owners(edge).to_vec();
        self.owners.clear(edge);
        self.owner_count -= owners.len();
        *self.at.entry(ends[0], ends[1], DIVIDED).0 = DIVIDED;
        let place = |point: u32| points.at[point as usize];
        let along = |point: u32| (place(point) - place(ends[0])).dot(place(ends[1]) - place(ends[0]));
        cuts.small_sort_by(|&a, &b| along(a).total_cmp(&along(b)).then(a.cmp(&b)));
        for owner in owners {
            changed.push(owner.facet);
            let mut from = ends[0];
            for &to in cuts.iter().chain([&ends[1]]) {
                if from != to {
                    self.add([from, to], direction * length, owner);
                }
                from = to;
            }
        }
    }
}
