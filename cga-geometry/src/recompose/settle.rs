//! The places of points after all movements.

use crate::each::Each;
use crate::small_sort::SmallSort;
use glam::DVec3;

use super::origins::{Movement, NO_EDGE, Origins};

/// The divisions as a tree: each contains the numbers of those below it.
struct DivisionTree {
    /// For each division its number in depth-first order, and the number after all divisions below it.
    ranges: Vec<[u32; 2]>,
}

impl DivisionTree {
    /// `above` has the division above each, which comes before it.
    fn new(above: &[u32]) -> Self {
        let mut sizes = vec![1u32; above.len()];
        for division in (1..above.len()).rev() {
            sizes[above[division] as usize] += sizes[division];
        }
        let mut ranges = vec![[0, 0]; above.len()];
        // The next number below each division.
        let mut next = vec![1u32; above.len()];
        for division in 0..above.len() {
            let mut start = 0;
            if division != 0 {
                let parent = above[division] as usize;
                start = next[parent];
                next[parent] += sizes[division];
            }
            ranges[division] = [start, start + sizes[division]];
            next[division] = start + 1;
        }
        DivisionTree { ranges }
    }

    /// Returns true if a division is another one, or above it.
    fn is_above(&self, above: u32, below: u32) -> bool {
        let [start, end] = self.ranges[above as usize];
        (start..end).contains(&self.ranges[below as usize][0])
    }
}

/// The movements at each point, one for each division.
struct Movements {
    list: Vec<Movement>,
    /// The end of each point's movements in the list.
    ends: Vec<usize>,
}

impl Movements {
    fn new(origins: &mut Origins) -> Self {
        let mut list = std::mem::take(&mut origins.movements);
        list.small_sort_by_key(|movement| (movement.point, movement.division));
        list.dedup_by(|next, sum| {
            let same = (next.point, next.division) == (sum.point, sum.division);
            if same {
                sum.by += next.by;
            }
            same
        });
        let mut ends = vec![0; origins.points.len()];
        list.iter().for_each(|movement| ends[movement.point as usize] += 1);
        let mut sum = 0;
        for end in &mut ends {
            sum += *end;
            *end = sum;
        }
        Movements { list, ends }
    }

    fn at(&self, point: u32) -> &[Movement] {
        let end = |point: usize| self.ends[point];
        let start = (point as usize).checked_sub(1).map_or(0, end);
        &self.list[start..end(point as usize)]
    }

    fn sum_at(&self, point: u32) -> DVec3 {
        self.at(point).iter().map(|movement| movement.by).sum()
    }
}

impl Origins {
    /// The place of each point: the original place and all movements.
    pub fn settle(&mut self) -> Vec<DVec3> {
        let mut places: Vec<DVec3> = self.points.iter().map(|point| point.place).collect();
        if self.movements.is_empty() {
            return places;
        }
        let movements = Movements::new(self);
        let tree = DivisionTree::new(&self.divisions);
        // The movements that a point has from others on its edge.
        let mut followed = vec![DVec3::ZERO; places.len()];
        for edge in &self.edges {
            let [a, b] = edge.ends;
            let points: Vec<(f64, u32)> = [(0.0, a)].into_iter().chain(edge.inner()).chain([(1.0, b)]).collect();
            for at in 0..points.len() {
                for movement in movements.at(points[at].1) {
                    let is_coarse = |point: u32| self.is_coarse(&tree, point, movement.division);
                    let up = points[at + 1..].iter();
                    follow(up, points[at].0, movement.by, is_coarse, &mut followed);
                    follow(points[..at].iter().rev(), points[at].0, movement.by, is_coarse, &mut followed);
                }
            }
        }
        // Ends come before the points on their edges.
        let mut sums = vec![DVec3::ZERO; places.len()];
        for (number, point) in self.points.iter().enumerate() {
            let own = movements.sum_at(number as u32);
            // Movements of the ends that come from elsewhere.
            let inherited = match self.edges.get(point.edge as usize).filter(|_| point.edge != NO_EDGE) {
                None => DVec3::ZERO,
                Some(edge) => {
                    let [a, b] = edge.ends.each(|end| sums[end as usize] - movements.sum_at(end));
                    a + (b - a) * point.share
                }
            };
            sums[number] = own + followed[number] + inherited;
        }
        for (place, sum) in places.iter_mut().zip(sums) {
            let moved = *place + sum;
            if moved.is_finite() {
                *place = moved;
            }
        }
        places
    }

    /// Returns true if parts of a division have a point at first, or may have it.
    fn is_coarse(&self, tree: &DivisionTree, point: u32, division: u32) -> bool {
        let first = self.points[point as usize].birth;
        let more = self.births.get(&point).map_or(&[][..], |list| list);
        std::iter::once(&first).chain(more).any(|birth| tree.is_above(*birth, division))
    }
}

/// Moves the points from a point up to the next coarse one, or to the end of the edge.
fn follow<'p>(
    points: impl Iterator<Item = &'p (f64, u32)> + Clone,
    from: f64,
    by: DVec3,
    is_coarse: impl Fn(u32) -> bool,
    followed: &mut [DVec3],
) {
    let mut fine = 0;
    let mut end = None;
    for (share, point) in points.clone() {
        end = Some(*share);
        if is_coarse(*point) {
            break;
        }
        fine += 1;
    }
    let Some(end) = end else { return };
    // The end of the edge itself gets its movements elsewhere.
    for (share, point) in points.take(fine).filter(|(share, _)| *share != end) {
        followed[*point as usize] += by * (1.0 - (share - from) / (end - from));
    }
}
