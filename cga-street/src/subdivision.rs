//! A subdivision of the plane by polygons, with the polygons that cover each of its faces.

use super::grid::{Point, cross, sides, twice_area, winding};
use super::outline::bounds;
use super::progress::{EDGE, sort_and_dedup, spend};
use super::rounding::divide;
use super::segment_tree::SegmentTree;
use super::{MOST_CROSSINGS, StreetError};
use cga_geometry::disjoint::DisjointSets;
use cga_geometry::each::Each;
use cga_geometry::long_sort::long_sort_by;
use cga_geometry::small_sort::SmallSort;

/// The limit on the edges of all polygons, which bounds memory: an edge takes about 400 bytes.
const MOST_EDGES: usize = 10_000_000;

/// The limit on polygons that cover faces, over all faces, which bounds memory where very many polygons lie over each other.
const MOST_COVERS: usize = 20_000_000;

/// An error if polygons have more edges than a subdivision may have.
pub(super) fn check_edges(count: usize) -> Result<(), StreetError> {
    if MOST_EDGES < count { Err(StreetError::TooLarge { most: MOST_EDGES }) } else { Ok(()) }
}

/// The number for "no owner".
pub(super) const NONE: u32 = u32::MAX;

/// Half-edges `2 e` and `2 e + 1` are the two directions of edge `e`. A cycle is a loop of half-edges with one face on
/// its left: the outline of a face, or the outer border of a connected component.
pub(super) struct Subdivision {
    points: Vec<Point>,
    origin: Vec<u32>,
    next: Vec<u32>,
    pub(super) cycle: Vec<u32>,
    /// One half-edge of each cycle.
    first: Vec<u32>,
    /// The numbers of the polygons that cover the face, by cycle.
    pub(super) covers: Vec<Vec<u32>>,
}

/// A polygon, and the change of its winding number from the right of an edge to the left.
type Change = (u32, i32);

impl Subdivision {
    /// Divides the plane by counter-clockwise polygons, which may overlap. An error if they have too many edges, or if these cross too
    /// often.
    pub(super) fn new(polygons: &[Vec<Point>]) -> Result<Self, StreetError> {
        Subdivision::within(polygons, MOST_COVERS)
    }

    /// The same with a limit on polygons that cover faces.
    pub(super) fn within(polygons: &[Vec<Point>], most_covers: usize) -> Result<Self, StreetError> {
        check_edges(polygons.iter().map(Vec::len).sum())?;
        let sorted = |[a, b]: [Point; 2]| if a < b { [a, b] } else { [b, a] };
        let mut segments: Vec<[Point; 2]> =
            polygons.iter().flat_map(|ring| sides(ring)).filter(|[a, b]| a != b).map(sorted).collect();
        sort_and_dedup(&mut segments)?;
        let chains = divide(&segments, MOST_CROSSINGS)?;
        let mut points: Vec<Point> = chains.iter().flatten().copied().collect();
        sort_and_dedup(&mut points)?;
        let number = |point: &Point| points.binary_search(point).unwrap_or_default() as u32;
        let numbers = |chain: &Vec<Point>| {
            spend(EDGE * chain.len())?;
            Ok(chain.iter().map(number).collect())
        };
        let chains: Vec<Vec<u32>> = chains.iter().map(numbers).collect::<Result<_, StreetError>>()?;

        let mut uses: Vec<([u32; 2], u32, i32)> = Vec::new();
        for (polygon, ring) in polygons.iter().enumerate() {
            spend(EDGE * ring.len())?;
            // A side without length is not in the list.
            for side in sides(ring) {
                let Ok(at) = segments.binary_search(&sorted(side)) else { continue };
                let forward = side == segments[at];
                spend(EDGE * chains[at].len())?;
                for edge in chains[at].windows(2) {
                    let along = if edge[0] < edge[1] { 1 } else { -1 };
                    let ends = [edge[0].min(edge[1]), edge[0].max(edge[1])];
                    uses.push((ends, polygon as u32, if forward { along } else { -along }));
                }
            }
        }
        if !long_sort_by(&mut uses, Ord::cmp) {
            return Err(StreetError::Stopped);
        }
        let (mut edges, mut changes) = (Vec::<[u32; 2]>::new(), Vec::<Vec<Change>>::new());
        for group in uses.chunk_by(|a, b| a.0 == b.0) {
            spend(EDGE)?;
            let sums = group.chunk_by(|a, b| a.1 == b.1);
            let sums = sums.map(|uses| (uses[0].1, uses.iter().map(|one| one.2).sum()));
            let change: Vec<Change> = sums.filter(|&(_, sum)| sum != 0).collect();
            if !change.is_empty() {
                edges.push(group[0].0);
                changes.push(change);
            }
        }
        let origin: Vec<u32> = edges.iter().flatten().copied().collect();
        let next = successors(&points, &origin)?;
        spend(EDGE * next.len() / 8)?;
        let (cycle, first) = cycles(&next);
        let mut made = Subdivision { points, origin, next, cycle, first, covers: Vec::new() };
        made.cover(polygons, &changes, most_covers)?;
        Ok(made)
    }

    /// The points of a cycle.
    pub(super) fn ring(&self, cycle: usize) -> Vec<Point> {
        let from = self.first[cycle];
        let mut ring = Vec::new();
        let mut at = from;
        loop {
            ring.push(self.points[self.origin[at as usize] as usize]);
            at = self.next[at as usize];
            if at == from {
                return ring;
            }
        }
    }

    /// The ends of a half-edge.
    pub(super) fn ends(&self, half: usize) -> [Point; 2] {
        [half, half ^ 1].each(|half| self.points[self.origin[half] as usize])
    }

    /// Finds the covering polygons of all faces, from the outer border of each connected part inwards.
    fn cover(&mut self, polygons: &[Vec<Point>], changes: &[Vec<Change>], most: usize) -> Result<(), StreetError> {
        let faces = self.first.len();
        let mut count = 0;
        let mut add = |more: usize| {
            spend(more)?;
            count += more;
            if count <= most { Ok(()) } else { Err(StreetError::TooDense { most: MOST_CROSSINGS }) }
        };
        let mut windings: Vec<Option<Vec<Change>>> = vec![None; faces];
        let mut members: Vec<Vec<u32>> = vec![Vec::new(); faces];
        spend(EDGE * faces)?;
        for (half, &cycle) in self.cycle.iter().enumerate() {
            members[cycle as usize].push(half as u32);
        }
        let mut components = DisjointSets::new(faces);
        self.cycle.as_chunks::<2>().0.iter().for_each(|[a, b]| components.unite(*a, *b));
        let parts = components.sets();
        let mut part = vec![0; faces];
        for (number, cycles) in parts.iter().enumerate() {
            cycles.iter().for_each(|&cycle| part[cycle as usize] = number);
        }
        // The polygons of each component, if there are several, and their boxes.
        let mut homes: Vec<(usize, u32)> = Vec::new();
        if 1 < parts.len() {
            for (half, &cycle) in self.cycle.iter().enumerate().step_by(2) {
                homes.extend(changes[half / 2].iter().map(|change| (part[cycle as usize], change.0)));
            }
            homes.sort_unstable();
            homes.dedup();
        }
        let boxes: Vec<[Point; 2]> = homes.iter().map(|home| bounds(&polygons[home.1 as usize])).collect();
        let tree = SegmentTree::of(boxes.iter().copied());
        for (number, list) in parts.iter().enumerate() {
            spend(EDGE * list.iter().map(|&cycle| members[cycle as usize].len()).sum::<usize>())?;
            let outer = list.iter().copied().min_by_key(|&cycle| twice_area(&self.ring(cycle as usize)));
            let Some(outer) = outer else { continue };
            // A component may be inside polygons of other components.
            let corner = self.points[self.origin[self.first[outer as usize] as usize] as usize];
            let (mut around, mut sides) = (Vec::new(), 0);
            let near = tree.near([corner; 2], 0, |at| {
                let (home, polygon) = homes[at as usize];
                if home != number && holds(boxes[at as usize], corner) {
                    sides += polygons[polygon as usize].len();
                    let turns = winding(&polygons[polygon as usize], corner);
                    around.extend((turns != 0).then_some((polygon, turns)));
                }
            });
            spend(EDGE + near + sides)?;
            add(around.len())?;
            around.small_sort();
            windings[outer as usize] = Some(around);
            let mut waiting = vec![outer];
            while let Some(cycle) = waiting.pop() {
                spend(EDGE * members[cycle as usize].len())?;
                for &half in &members[cycle as usize] {
                    let other = self.cycle[(half ^ 1) as usize] as usize;
                    if windings[other].is_none() {
                        // The change from the left of this half-edge to the left of its twin.
                        let sign = if half % 2 == 0 { -1 } else { 1 };
                        let here = windings[cycle as usize].as_deref().unwrap_or_default();
                        let sum = added(here, &changes[half as usize / 2], sign);
                        add(sum.len())?;
                        windings[other] = Some(sum);
                        waiting.push(other as u32);
                    }
                }
            }
        }
        let polygons = |list: Option<Vec<Change>>| list.unwrap_or_default().iter().map(|change| change.0).collect();
        self.covers = windings.into_iter().map(polygons).collect();
        Ok(())
    }

    /// The outlines of the areas of each owner, given the owner of each cycle: loops with the owner on their left.
    pub(super) fn outlines(&self, owner: &[u32]) -> Vec<(u32, Vec<Point>)> {
        let of = |half: usize| owner[self.cycle[half] as usize];
        let mut seen = vec![false; self.next.len()];
        let mut loops = Vec::new();
        for from in 0..self.next.len() {
            if seen[from] || of(from) == NONE || of(from) == of(from ^ 1) {
                continue;
            }
            let mut ring = Vec::new();
            let mut at = from;
            loop {
                seen[at] = true;
                ring.push(self.points[self.origin[at] as usize]);
                at = self.next[at] as usize;
                while of(at ^ 1) == of(from) {
                    at = self.next[at ^ 1] as usize;
                }
                if at == from || seen[at] {
                    break;
                }
            }
            loops.push((of(from), ring));
        }
        loops
    }
}

fn holds([low, high]: [Point; 2], point: Point) -> bool {
    low.x <= point.x && point.x <= high.x && low.y <= point.y && point.y <= high.y
}

/// The sums of winding numbers and changes, without zeros.
fn added(here: &[Change], changes: &[Change], sign: i32) -> Vec<Change> {
    let mut sum: Vec<Change> = here.to_vec();
    for &(polygon, change) in changes {
        match sum.binary_search_by_key(&polygon, |one| one.0) {
            Ok(at) => {
                sum[at].1 += sign * change;
                if sum[at].1 == 0 {
                    sum.remove(at);
                }
            }
            Err(at) => sum.insert(at, (polygon, sign * change)),
        }
    }
    sum
}

/// For each half-edge the next one around the face on its left. An error if the layout is to end.
fn successors(points: &[Point], origin: &[u32]) -> Result<Vec<u32>, StreetError> {
    let mut around: Vec<u32> = (0..origin.len() as u32).collect();
    let along = |half: u32| points[origin[(half ^ 1) as usize] as usize].from(points[origin[half as usize] as usize]);
    let upper = |(x, y): (i128, i128)| u8::from(!(0 < y || y == 0 && 0 < x));
    let is_sorted = long_sort_by(&mut around, |&a, &b| {
        let by_angle = || {
            let (a, b) = (along(a), along(b));
            upper(a).cmp(&upper(b)).then_with(|| cross(b, a).cmp(&0))
        };
        origin[a as usize].cmp(&origin[b as usize]).then_with(by_angle).then_with(|| a.cmp(&b))
    });
    if !is_sorted {
        return Err(StreetError::Stopped);
    }
    let mut next = vec![0; origin.len()];
    for group in around.chunk_by(|&a, &b| origin[a as usize] == origin[b as usize]) {
        for (at, &half) in group.iter().enumerate() {
            // From the twin of `half`, the face on the left continues with the next half-edge clockwise.
            next[(half ^ 1) as usize] = group[(at + group.len() - 1) % group.len()];
        }
    }
    Ok(next)
}

fn cycles(next: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let (mut cycle, mut first) = (vec![NONE; next.len()], Vec::new());
    for from in 0..next.len() {
        let mut at = from;
        if cycle[at] != NONE {
            continue;
        }
        while cycle[at] == NONE {
            cycle[at] = first.len() as u32;
            at = next[at] as usize;
        }
        first.push(from as u32);
    }
    (cycle, first)
}
