//! Short lists without memory of their own.
//!
//! An arrangement has hundreds of thousands of edges and cells, each with a few numbers. To release them one by one took most of the
//! time from a stop to the return, so all lists of a kind share two allocations.

use std::ops::Range;

use crate::each::Each;

/// Lists that are made one after the other. The last list is open: it gets elements until it ends.
#[derive(Debug)]
pub(super) struct Lists<T> {
    items: Vec<T>,
    ends: Vec<u32>,
}

impl<T> Default for Lists<T> {
    fn default() -> Self {
        Lists { items: Vec::new(), ends: Vec::new() }
    }
}

impl<T: Copy> Lists<T> {
    /// The number of lists, without the open one.
    pub(super) fn len(&self) -> u32 {
        self.ends.len() as u32
    }

    /// Adds an element to the open list.
    pub(super) fn push(&mut self, item: T) {
        self.items.push(item);
    }

    /// The open list.
    pub(super) fn open(&self) -> &[T] {
        &self.items[self.start(self.len())..]
    }

    /// Ends the open list, and opens the next one.
    pub(super) fn end(&mut self) {
        self.ends.push(self.items.len() as u32);
    }

    /// Adds elements to the open list and ends it.
    pub(super) fn add(&mut self, items: impl IntoIterator<Item = T>) {
        self.items.extend(items);
        self.end();
    }

    pub(super) fn of(&self, number: u32) -> &[T] {
        &self.items[self.start(number)..self.ends[number as usize] as usize]
    }

    pub(super) fn of_mut(&mut self, number: u32) -> &mut [T] {
        let range = self.start(number)..self.ends[number as usize] as usize;
        &mut self.items[range]
    }

    /// All lists, the open one excluded.
    pub(super) fn iter(&self) -> impl Iterator<Item = &[T]> {
        (0..self.len()).map(|number| self.of(number))
    }

    fn start(&self, number: u32) -> usize {
        number.checked_sub(1).map_or(0, |last| self.ends[last as usize] as usize)
    }
}

/// A polygon: an outline and holes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rings<'a, T> {
    /// The corners of all rings.
    pub(super) corners: &'a [T],
    /// The end of each ring in `corners`.
    pub(super) ends: &'a [u32],
}

impl<'a, T: Copy> Rings<'a, T> {
    pub(super) const EMPTY: Self = Rings { corners: &[], ends: &[] };

    /// The ranges of the rings in `corners`.
    fn ranges(self) -> impl Iterator<Item = Range<usize>> + 'a {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(self.ends).map(|(start, end)| start as usize..*end as usize)
    }

    pub(super) fn iter(self) -> impl Iterator<Item = &'a [T]> + 'a {
        self.ranges().map(move |ring| &self.corners[ring])
    }

    /// The edges of the rings, as the numbers of their corners.
    pub(super) fn rim(self) -> impl Iterator<Item = [usize; 2]> + 'a {
        self.ranges().flat_map(|ring| {
            let (start, end) = (ring.start, ring.end);
            ring.map(move |corner| [corner, if corner + 1 == end { start } else { corner + 1 }])
        })
    }

    /// The edges of the rings, as their corners.
    pub(super) fn edges(self) -> impl Iterator<Item = [T; 2]> + 'a {
        self.rim().map(move |edge| edge.each(|corner| self.corners[corner]))
    }
}

/// Polygons that are made one after the other.
#[derive(Debug)]
pub(super) struct Polygons<T> {
    corners: Lists<T>,
    ends: Lists<u32>,
}

impl<T> Default for Polygons<T> {
    fn default() -> Self {
        Polygons { corners: Lists::default(), ends: Lists::default() }
    }
}

impl<T: Copy> Polygons<T> {
    /// The number of polygons, without the open one.
    pub(super) fn len(&self) -> u32 {
        self.corners.len()
    }

    /// Adds a ring to the open polygon.
    pub(super) fn add_ring(&mut self, ring: impl IntoIterator<Item = T>) {
        self.corners.items.extend(ring);
        self.ends.push(self.corners.open().len() as u32);
    }

    /// Ends the open polygon, and opens the next one.
    pub(super) fn end(&mut self) {
        self.corners.end();
        self.ends.end();
    }

    /// The number of rings of the open polygon.
    pub(super) fn open_rings(&self) -> usize {
        self.ends.open().len()
    }

    pub(super) fn of(&self, number: u32) -> Rings<'_, T> {
        Rings { corners: self.corners.of(number), ends: self.ends.of(number) }
    }

    /// All polygons, the open one excluded.
    pub(super) fn iter(&self) -> impl Iterator<Item = Rings<'_, T>> {
        (0..self.len()).map(|number| self.of(number))
    }

    /// Reverses each ring of a polygon.
    pub(super) fn reverse(&mut self, number: u32) {
        let (corners, mut start) = (self.corners.of_mut(number), 0);
        for &end in self.ends.of(number) {
            corners[start..end as usize].reverse();
            start = end as usize;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_have_the_rings_that_were_added() {
        let mut polygons = Polygons::default();
        polygons.add_ring([1, 2, 3]);
        polygons.add_ring([4, 5, 6, 7]);
        assert_eq!((polygons.len(), polygons.open_rings()), (0, 2));
        polygons.end();
        polygons.end();
        polygons.add_ring([8, 9, 10]);
        polygons.end();
        let rings = |number| polygons.of(number).iter().map(<[u32]>::to_vec).collect::<Vec<_>>();
        assert_eq!([0, 1, 2].map(rings), [vec![vec![1, 2, 3], vec![4, 5, 6, 7]], vec![], vec![vec![8, 9, 10]]]);
        let edges: Vec<[u32; 2]> = polygons.of(0).edges().collect();
        assert_eq!(edges, [[1, 2], [2, 3], [3, 1], [4, 5], [5, 6], [6, 7], [7, 4]]);
        polygons.reverse(0);
        assert_eq!((polygons.of(0).corners, polygons.of(0).ends), (&[3, 2, 1, 7, 6, 5, 4][..], &[3, 7][..]));
        assert_eq!(polygons.of(2).corners, [8, 9, 10]);
    }
}
