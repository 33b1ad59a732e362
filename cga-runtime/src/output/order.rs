//! The order in which flat faces are painted over each other.
//!
//! If two faces overlap in the picture, their depth at a common point decides. Faces that do not overlap need no
//! order, and the farther one comes first. Cycles, which only cutting could resolve, are broken at the farthest face.
//!
//! Time and memory are bounded. After [`MOST_WORK`] the middles of faces decide.

use crate::geometry::each::Each;
use crate::geometry::small_sort::SmallSort;
use glam::{DVec2, DVec3};

/// A face in the picture. Depth grows towards the viewer.
#[derive(Debug)]
pub(crate) struct DepthFace {
    outline: Vec<DVec2>,
    low: DVec2,
    high: DVec2,
    /// The depth as a plane over the picture: the middle, and the slopes.
    middle: DVec3,
    slope: DVec2,
}

impl DepthFace {
    /// A face from corners in the picture with depth: at least three, not on a line.
    pub(crate) fn new(corners: &[DVec3]) -> DepthFace {
        let outline: Vec<DVec2> = corners.iter().map(|corner| corner.truncate()).collect();
        let low = outline.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = outline.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let count = corners.len() as f64;
        let middle = corners.iter().fold(DVec3::ZERO, |sum, &corner| sum + corner / count);
        // The normal, as a sum over all edges.
        let edges = corners.iter().zip(corners.iter().cycle().skip(1));
        let n = edges.fold(DVec3::ZERO, |sum, (&a, &b)| sum + (a - middle).cross(b - middle));
        let slope = if n.z == 0.0 { DVec2::ZERO } else { -n.truncate() / n.z };
        DepthFace { outline, low, high, middle, slope }
    }

    fn depth(&self, at: DVec2) -> f64 {
        self.middle.z + self.slope.x * (at.x - self.middle.x) + self.slope.y * (at.y - self.middle.y)
    }
}

/// Faces that overlap by less than this, in the units of the picture, only touch.
const SLIGHT: f64 = 0.05;

/// The limit of the work of finding an order. A unit is a comparison of two faces, or of a corner with an edge.
const MOST_WORK: usize = 1 << 27;

/// The limit of the number of faces in all cells of the grid, beside one for each face.
const MOST_ENTRIES: usize = 1 << 22;

/// The limit of the number of pairs of faces that overlap.
const MOST_PAIRS: usize = 1 << 24;

/// Counts down the work that is left.
struct Budget {
    work: usize,
    pairs: usize,
}

impl Budget {
    /// Takes units of work. Returns false if there are too few.
    fn spend(&mut self, units: usize) -> bool {
        match self.work.checked_sub(units) {
            Some(left) => self.work = left,
            None => self.work = 0,
        }
        0 < self.work
    }
}

/// The amount by which `a` is nearer than `b` where they overlap; 0 if they do not overlap, the order is unclear or too little work
/// is left.
fn nearer(a: &DepthFace, b: &DepthFace, budget: &mut Budget) -> f64 {
    if (a.high - SLIGHT).cmple(b.low).any() || (b.high - SLIGHT).cmple(a.low).any() {
        return 0.0;
    }
    // For small faces, the common part of the convex hulls is close enough to the common part of the faces.
    let common = clip(&a.outline, &b.outline, budget);
    if area(&common).abs() < SLIGHT * SLIGHT {
        return 0.0;
    }
    let count = common.len() as f64;
    let middle = common.iter().fold(DVec2::ZERO, |sum, &point| sum + point / count);
    a.depth(middle) - b.depth(middle)
}

fn area(ring: &[DVec2]) -> f64 {
    let twice: f64 = ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b)).sum();
    0.5 * twice
}

/// The part of one outline within another, which is treated as convex. Empty if too little work is left.
fn clip(subject: &[DVec2], window: &[DVec2], budget: &mut Budget) -> Vec<DVec2> {
    let mut kept = subject.to_vec();
    let turn = area(window).signum();
    for (a, b) in window.iter().zip(window.iter().cycle().skip(1)) {
        if !budget.spend(1 + kept.len()) {
            return Vec::new();
        }
        let side = |p: DVec2| turn * (b - a).perp_dot(p - a);
        let mut next = Vec::with_capacity(kept.len() + 1);
        for (&p, &q) in kept.iter().zip(kept.iter().cycle().skip(1)) {
            let (sp, sq) = (side(p), side(q));
            if 0.0 <= sp {
                next.push(p);
            }
            if (0.0 < sp && sq < 0.0) || (sp < 0.0 && 0.0 < sq) {
                next.push(p + (q - p) * (sp / (sp - sq)));
            }
        }
        kept = next;
    }
    kept
}

/// The indices of the faces in the order of painting.
pub(crate) fn back_to_front(faces: &[&DepthFace]) -> Vec<usize> {
    back_to_front_within(Budget { work: MOST_WORK, pairs: MOST_PAIRS }, faces)
}

fn back_to_front_within(budget: Budget, faces: &[&DepthFace]) -> Vec<usize> {
    // Farther middles first, as a start and wherever other rules do not decide; equal ones in their given order.
    let mut start: Vec<usize> = (0..faces.len()).collect();
    start.small_sort_unstable_by(|&a, &b| faces[a].middle.z.total_cmp(&faces[b].middle.z).then(a.cmp(&b)));
    let behind = behind(faces, &start, budget);
    // Paints the faces behind a face before it: a depth-first walk, without recursion.
    let mut order = Vec::with_capacity(faces.len());
    let mut state = vec![0u8; faces.len()];
    let mut stack: Vec<(usize, usize)> = Vec::new();
    for &root in &start {
        if state[root] != 0 {
            continue;
        }
        state[root] = 1;
        stack.push((root, 0));
        while let Some((face, next)) = stack.pop() {
            match behind[face].get(next) {
                Some(&other) => {
                    let other = other as usize;
                    stack.push((face, next + 1));
                    if state[other] == 0 {
                        state[other] = 1;
                        stack.push((other, 0));
                    }
                }
                None => order.push(face),
            }
        }
    }
    order
}

/// A grid over the picture.
struct Grid {
    low: DVec2,
    size: DVec2,
    /// The number of cells along a side.
    cells: usize,
}

impl Grid {
    /// A grid in whose cells all faces together are at most [`MOST_ENTRIES`] times, beside once each.
    fn new(faces: &[&DepthFace]) -> Grid {
        let low = faces.iter().fold(DVec2::INFINITY, |low, face| low.min(face.low));
        let high = faces.iter().fold(DVec2::NEG_INFINITY, |high, face| high.max(face.high));
        let cells = 1.max((faces.len() as f64).sqrt() as usize / 2).min(256);
        let mut grid = Grid { low, size: (high - low).max(DVec2::splat(1e-9)), cells };
        while 1 < grid.cells && MOST_ENTRIES < grid.entries(faces) {
            grid.cells /= 2;
        }
        grid
    }

    fn entries(&self, faces: &[&DepthFace]) -> usize {
        let of = |face: &&DepthFace| {
            let [[left, bottom], [right, top]] = self.covered(face);
            (right - left + 1) * (top - bottom + 1)
        };
        faces.iter().map(of).sum()
    }

    /// The first and the last cell of a face, each as column and row.
    fn covered(&self, face: &DepthFace) -> [[usize; 2]; 2] {
        [self.cell(face.low), self.cell(face.high)]
    }

    fn cell(&self, at: DVec2) -> [usize; 2] {
        let place = (at - self.low) / self.size * self.cells as f64;
        place.to_array().each(|place| (place as usize).min(self.cells - 1))
    }
}

/// For each face the faces behind it, found among neighbours on a grid.
fn behind(faces: &[&DepthFace], start: &[usize], mut budget: Budget) -> Vec<Vec<u32>> {
    let mut behind = vec![Vec::new(); faces.len()];
    let grid = Grid::new(faces);
    let mut lists = vec![Vec::new(); grid.cells * grid.cells];
    for &face in start {
        let [[left, bottom], [right, top]] = grid.covered(faces[face]);
        for y in bottom..=top {
            for x in left..=right {
                let list: &mut Vec<u32> = &mut lists[y * grid.cells + x];
                for &other in list.iter() {
                    if !budget.spend(1) || budget.pairs == 0 {
                        return behind;
                    }
                    let (face_number, near) = (face as u32, other as usize);
                    // Each pair is compared once: in the cell where the common part of their boxes begins.
                    if grid.cell(faces[near].low.max(faces[face].low)) != [x, y] {
                        continue;
                    }
                    let (front, back) = match nearer(faces[face], faces[near], &mut budget) {
                        d if 1e-9 < d => (face, other),
                        d if d < -1e-9 => (near, face_number),
                        _ => continue,
                    };
                    behind[front].push(back);
                    budget.pairs -= 1;
                }
                list.push(face as u32);
            }
        }
    }
    behind
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square over the whole picture at a depth, with that many corners along its lower side.
    fn square(corners: usize, depth: f64) -> DepthFace {
        let side = (0..corners).map(|corner| DVec3::new(100.0 * corner as f64 / corners as f64, 0.0, depth));
        let rest = [[100.0, 0.0], [100.0, 100.0], [0.0, 100.0]].map(|[x, y]| DVec3::new(x, y, depth));
        DepthFace::new(&side.chain(rest).collect::<Vec<_>>())
    }

    #[test]
    fn an_order_takes_bounded_time_and_memory() {
        // Without a limit a hundred million comparisons, and two with five billion.
        let many: Vec<DepthFace> = (0..15_000).map(|number| square(1, f64::from(number * 7919 % 15_000))).collect();
        let large = [square(70_000, 3.0), square(70_000, 1.0), square(1, 2.0)];
        for faces in [&many[..], &large] {
            let faces: Vec<&DepthFace> = faces.iter().collect();
            assert!(Grid::new(&faces).entries(&faces) <= MOST_ENTRIES);
            let order = back_to_front_within(Budget { work: 1 << 20, pairs: 1 << 16 }, &faces);
            let depths: Vec<f64> = order.iter().map(|face| faces[*face].middle.z).collect();
            assert!(depths.len() == faces.len() && depths.is_sorted(), "{:?}", &depths[..3]);
        }
    }

    #[test]
    fn few_pairs_are_compared_in_full() {
        // The middle of the slope is nearer, and the low end of it is behind the square.
        let slope = DepthFace::new(
            &[[0.0, 0.0, 0.0], [100.0, 0.0, 100.0], [100.0, 10.0, 100.0], [0.0, 10.0, 0.0]].map(DVec3::from),
        );
        let small = DepthFace::new(
            &[[0.0, 0.0, 40.0], [10.0, 0.0, 40.0], [10.0, 10.0, 40.0], [0.0, 10.0, 40.0]].map(DVec3::from),
        );
        assert_eq!(back_to_front(&[&slope, &small]), [0, 1]);
        assert_eq!(back_to_front_within(Budget { work: 3, pairs: 1 }, &[&slope, &small]), [1, 0]);
    }
}
