//! Loops that occur several times, as in a mesh with duplicate faces.

use crate::small_sort::{SmallSort, sort_owned_by};
use std::cmp::Ordering;
use std::collections::HashMap;
use std::ops::Range;

use glam::DVec2;

use super::contour::FlatLoops;
use super::extent::Extent;

/// Groups of loops through the same points in the same order.
#[derive(Default)]
pub(crate) struct Twins {
    groups: Vec<Vec<usize>>,
    /// For each loop of a group: the group, and the number of loops of the group before it.
    places: HashMap<usize, (usize, usize)>,
    order: Vec<(DVec2, DVec2, usize)>,
}

impl Twins {
    /// Finds the groups among loops, which are given by their corners and bounding boxes.
    pub(crate) fn find(
        &mut self,
        section: &FlatLoops<'_>,
        loops: impl Iterator<Item = (Range<usize>, Extent)> + Clone,
    ) {
        self.groups.clear();
        self.places.clear();
        self.order.clear();
        self.order.extend(loops.clone().enumerate().map(|(number, (_, Extent { low, high }))| (low, high, number)));
        let key = |&(low, high, number): &(DVec2, DVec2, usize)| (low.x, low.y, high.x, high.y, number);
        self.order.small_sort_by(|a, b| key(a).partial_cmp(&key(b)).unwrap_or(a.2.cmp(&b.2)));
        if self.order.windows(2).all(|pair| (pair[0].0, pair[0].1) != (pair[1].0, pair[1].1)) {
            return;
        }
        let ranges: Vec<Range<usize>> = loops.map(|(range, _)| range).collect();
        for same_box in self.order.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).filter(|group| group.len() > 1) {
            let mut rings: Vec<CanonicalLoop> =
                same_box.iter().map(|&(.., number)| CanonicalLoop::of(section, &ranges[number], number)).collect();
            sort_owned_by(&mut rings, |a, b| a.order(b).then(a.number.cmp(&b.number)));
            for kind in rings.chunk_by(|a, b| a.order(b).is_eq()).filter(|kind| kind.len() > 1) {
                let places = kind.iter().enumerate().map(|(rank, ring)| (ring.number, (self.groups.len(), rank)));
                self.places.extend(places);
                self.groups.push(kind.iter().map(|ring| ring.number).collect());
            }
        }
    }

    /// The first loop of a loop's group, and the number of loops of the group before it.
    pub(crate) fn first(&self, number: usize) -> (usize, usize) {
        self.places.get(&number).map_or((number, 0), |&(group, rank)| (self.groups[group][0], rank))
    }

    /// Each later loop of a group with the first loop of the group.
    pub(crate) fn others(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.groups.iter().flat_map(|group| group[1..].iter().map(|&number| (number, group[0])))
    }

    /// Loop number `number` of a group, which is given by its first loop. Wraps around after the last.
    pub(crate) fn nth(&self, first: usize, number: usize) -> usize {
        let group = self.places.get(&first).map(|&(group, _)| &self.groups[group]);
        group.map_or(first, |group| group[number % group.len()])
    }
}

/// The points of a loop from its least start, which are equal for twins.
struct CanonicalLoop {
    number: usize,
    places: Vec<DVec2>,
}

impl CanonicalLoop {
    fn of(section: &FlatLoops<'_>, range: &Range<usize>, number: usize) -> Self {
        let mut places: Vec<DVec2> = section.ring(range).iter().map(|&at| section.flat[at as usize]).collect();
        let start = least_start(&places);
        places.rotate_left(start);
        CanonicalLoop { number, places }
    }

    fn order(&self, other: &CanonicalLoop) -> Ordering {
        let count = self.places.len().cmp(&other.places.len());
        let pairs = || self.places.iter().zip(&other.places);
        count
            .then_with(|| pairs().map(|(&a, &b)| by_place(a, b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal))
    }
}

/// The start from which the points of a ring are lexicographically least. Takes two or three times as many steps as
/// there are points, also if points repeat.
fn least_start(places: &[DVec2]) -> usize {
    let count = places.len();
    let at = |i: usize| places[if i < count { i } else { i - count }];
    // Compares two starts. All starts from the worse one up to the difference are worse than some other start.
    let (mut a, mut b, mut same) = (0, 1, 0);
    while a < count && b < count && same < count {
        match by_place(at(a + same), at(b + same)) {
            Ordering::Equal => {
                same += 1;
                continue;
            }
            Ordering::Greater => a += same + 1,
            Ordering::Less => b += same + 1,
        }
        if a == b {
            b += 1;
        }
        same = 0;
    }
    a.min(b)
}

fn by_place(a: DVec2, b: DVec2) -> Ordering {
    a.x.partial_cmp(&b.x).unwrap_or(Ordering::Equal).then(a.y.partial_cmp(&b.y).unwrap_or(Ordering::Equal))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_start_is_the_same_wherever_a_ring_starts() {
        let rings: [&[i32]; 5] =
            [&[3, 1, 2], &[1, 2, 1, 2], &[1, 1, 2, 1, 1, 1], &[2, 2, 2], &[0, 1, 0, 2, 0, 1, 0, 1]];
        for ring in rings {
            let places: Vec<DVec2> = ring.iter().map(|&x| DVec2::new(0.0, f64::from(x))).collect();
            let turned = |start: usize| -> Vec<f64> {
                places[start..].iter().chain(&places[..start]).map(|place| place.y).collect()
            };
            let least = (0..ring.len()).map(turned).min_by(|a, b| a.partial_cmp(b).unwrap());
            assert_eq!(Some(turned(least_start(&places))), least);
        }
    }

    #[test]
    fn twins_are_told_from_others_with_their_box() {
        let at = |x: f64, y: f64| DVec2::new(x, y);
        let flat = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0), at(1.0, 1.0)];
        let corners = [0, 1, 2, 3, 3, 2, 1, 0, 4, 3, 0, 1, 0, 2, 3, 2, 3, 0, 1];
        let ends = [4, 8, 12, 15, 19];
        let section = FlatLoops { flat: &flat, corners: &corners, ends: &ends };
        let starts = [0].into_iter().chain(ends);
        let loops = starts.zip(ends).map(|(start, end)| (start..end, Extent { low: DVec2::ZERO, high: DVec2::ONE }));
        let mut twins = Twins::default();
        twins.find(&section, loops);
        assert_eq!([0, 1, 2, 3, 4].map(|number| twins.first(number)), [(0, 0), (1, 0), (0, 1), (3, 0), (0, 2)]);
        assert_eq!([0, 1, 2, 3].map(|rank| twins.nth(0, rank)), [0, 2, 4, 0]);
    }
}
