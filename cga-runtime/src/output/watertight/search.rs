//! The search for points inside of edges.
//!
//! Most edges of a building have one of few directions. Seen along such a direction, an edge is a point, so a table has the edges at each
//! place across it, and each point of the shape is looked up once. Other edges are compared with a tree of all points.

use std::collections::HashMap;

use glam::{DVec3, Vec3Swizzles};

use crate::fixed_hash::FixedState;
use crate::geometry::bounds_tree::BoundsTree;
use crate::geometry::each::Each;
use crate::geometry::long_sort::long_sort_by;
use crate::geometry::mesh::Bounds;
use crate::geometry::work;

/// Directions are equal if their coordinates differ by less than this.
const DIRECTION: f64 = 1e-7;

/// If edges have more directions than [`FEW_DIRECTIONS`], a direction has a table if it has at least this share of edges for each point.
const EDGES_A_POINT: f64 = 0.05;

/// If edges have at most this number of directions, each direction has a table. More tables take longer than a tree of all points.
const FEW_DIRECTIONS: usize = 16;

/// Points of a cell are sorted if there are more.
const MANY: usize = 32;

/// The most comparisons of a point with an edge, for each point and edge of the shape, and for every shape. Only shapes with very many parts
/// in one place need more. Their last edges get no points.
const MOST_COMPARISONS: (usize, usize) = (64, 1 << 20);

/// The most points inside of edges, for each point and edge of the shape, and for every shape.
const MOST_INSIDE: (usize, usize) = (8, 1 << 16);

/// The points and edges of a shape.
pub(super) struct Search<'a> {
    pub(super) points: &'a [DVec3],
    pub(super) edges: &'a [[u32; 2]],
    /// Coordinates are rounded relative to it.
    pub(super) origin: DVec3,
    /// The distance from an edge within which a point is in it.
    pub(super) near: f64,
}

/// For each edge a range, and the numbers of points to which the ranges belong.
type Inside = (Vec<[u32; 2]>, Vec<u32>);

/// A direction and the numbers of its edges.
type Direction = (DVec3, Vec<u32>);

/// An edge seen along its direction: the range of lengths along it, and the cells of the table in which its points may be.
struct Seen {
    edge: u32,
    segment: Segment,
    lengths: [f64; 2],
    cells: [u32; 4],
}

/// The number of no cell.
const NO_CELL: u32 = u32::MAX;

/// A point in a cell of a table, with its length along the direction.
#[derive(Clone, Copy)]
struct InCell {
    point: u32,
    length: f64,
}

/// The points found so far.
struct Finder<'a> {
    search: &'a Search<'a>,
    ranges: Vec<[u32; 2]>,
    inside: Vec<u32>,
    comparisons: usize,
    /// The comparisons that are counted as work.
    told: usize,
    /// The points inside of the edge that is compared, with their distances from its start.
    found: Vec<(f64, u32)>,
}

/// An edge that is compared with points.
#[derive(Clone, Copy)]
struct Segment {
    from: DVec3,
    along: DVec3,
    length: f64,
}

impl Search<'_> {
    /// Finds the points inside of all edges, for each edge from its first to its second end. `None` if the work is to end.
    pub(super) fn points_in_edges(&self) -> Option<Inside> {
        let mut finder = Finder {
            search: self,
            ranges: vec![[0; 2]; self.edges.len()],
            inside: Vec::new(),
            comparisons: 0,
            told: 0,
            found: Vec::new(),
        };
        let (classes, mut others) = self.directions()?;
        for (along, edges) in classes {
            finder.of_direction(along, &edges, &mut others)?;
        }
        others.sort_unstable();
        finder.of_edges(&others)?;
        Some((finder.ranges, finder.inside))
    }

    /// The directions of many edges, each with the numbers of its edges, and the other edges.
    fn directions(&self) -> Option<(Vec<Direction>, Vec<u32>)> {
        let mut numbers: HashMap<[i32; 3], u32, FixedState> = HashMap::default();
        // For each direction its longest edge.
        let mut found: Vec<(f64, DVec3, Vec<u32>)> = Vec::new();
        for number in 0..self.edges.len() as u32 {
            if !work::spend(1) {
                return None;
            }
            let Some(Segment { along, length, .. }) = self.segment(number) else { continue };
            let size = along.abs();
            let main = (0..3).fold(0, |most, axis| if size[most] < size[axis] { axis } else { most });
            let along = if along[main] < 0.0 { -along } else { along };
            let key = (along / DIRECTION).round().to_array().each(|c| c as i32);
            let at = *numbers.entry(key).or_insert(found.len() as u32) as usize;
            if at == found.len() {
                found.push((length, along, Vec::new()));
            }
            let (longest, direction, edges) = &mut found[at];
            if *longest < length {
                (*longest, *direction) = (length, along);
            }
            edges.push(number);
        }
        let least = if found.len() <= FEW_DIRECTIONS { 0.0 } else { EDGES_A_POINT * self.points.len() as f64 };
        let (mut classes, mut others) = (Vec::new(), Vec::new());
        for (_, direction, edges) in found {
            if least <= edges.len() as f64 {
                classes.push((direction, edges));
            } else {
                others.extend(edges);
            }
        }
        Some((classes, others))
    }

    /// The edge with a number, if it is long enough for a point.
    fn segment(&self, edge: u32) -> Option<Segment> {
        let [from, to] = self.edges[edge as usize].each(|end| self.points[end as usize]);
        let length = (to - from).length();
        let is_long = 2.0 * self.near < length && length.is_finite();
        is_long.then(|| Segment { from, along: (to - from) / length, length })
    }
}

impl Finder<'_> {
    /// Finds the points inside of edges with about one direction. Edges with a slightly different one are added to `others`. `None` if the
    /// work is to end.
    fn of_direction(&mut self, along: DVec3, edges: &[u32], others: &mut Vec<u32>) -> Option<()> {
        let Search { points, origin, near, .. } = *self.search;
        let (u, v) = along.any_orthonormal_pair();
        let cell_size = 8.0 * near;
        let seen = |point: DVec3| [u, v, along].map(|axis| (point - origin).dot(axis));
        let cell = |u: f64, v: f64| [u, v].each(|c| whole(c / cell_size));
        let mut cells: HashMap<[i64; 2], u32, FixedState> = HashMap::default();
        let mut lines = Vec::with_capacity(edges.len());
        for &edge in edges {
            if !work::spend(2) {
                return None;
            }
            let [from, to] = self.search.edges[edge as usize].each(|end| seen(points[end as usize]));
            let slant = (from[0] - to[0]).abs().max((from[1] - to[1]).abs());
            if slant.is_nan() || 0.25 * near < slant {
                others.push(edge);
                continue;
            }
            let Some(segment) = self.search.segment(edge) else { continue };
            let reach = 1.25 * near;
            let mut own = [NO_CELL; 4];
            let mut last = None;
            for (corner, [at_u, at_v]) in
                [[-reach, -reach], [-reach, reach], [reach, -reach], [reach, reach]].into_iter().enumerate()
            {
                let place = cell(from[0] + at_u, from[1] + at_v);
                // Most edges are in one cell.
                if last == Some(place) {
                    continue;
                }
                last = Some(place);
                let next = cells.len() as u32;
                let number = *cells.entry(place).or_insert(next);
                if !own.contains(&number) {
                    own[corner] = number;
                }
            }
            lines.push(Seen { edge, segment, lengths: [from[2].min(to[2]), from[2].max(to[2])], cells: own });
        }
        let mut in_cells = Vec::new();
        // The number of points in each cell; later the end of its points.
        let mut ends = vec![0_u32; cells.len() + 1];
        for (point, &place) in (0..).zip(points) {
            if !work::spend(1) {
                return None;
            }
            let [u, v, length] = seen(place);
            if let Some(&cell) = cells.get(&cell(u, v)) {
                ends[cell as usize + 1] += 1;
                in_cells.push((cell, InCell { point, length }));
            }
        }
        (0..cells.len()).for_each(|cell| ends[cell + 1] += ends[cell]);
        let mut sorted = vec![InCell { point: 0, length: 0.0 }; in_cells.len()];
        for (cell, at) in in_cells {
            let end = &mut ends[cell as usize];
            sorted[*end as usize] = at;
            *end += 1;
        }
        let range = |cell: usize| if cell == 0 { 0 } else { ends[cell - 1] as usize }..ends[cell] as usize;
        for cell in 0..cells.len() {
            let points = &mut sorted[range(cell)];
            let order = |a: &InCell, b: &InCell| a.length.total_cmp(&b.length).then(a.point.cmp(&b.point));
            if MANY < points.len() && !long_sort_by(points, order) {
                return None;
            }
        }
        for line in &lines {
            if self.is_full() {
                break;
            }
            for &cell in line.cells.iter().filter(|cell| **cell != NO_CELL) {
                let points = &sorted[range(cell as usize)];
                let [low, high] = line.lengths;
                let first = if MANY < points.len() { points.partition_point(|at| at.length < low) } else { 0 };
                let last =
                    if MANY < points.len() { points.partition_point(|at| at.length <= high) } else { points.len() };
                for at in points[first..last].iter().filter(|at| low <= at.length && at.length <= high) {
                    self.compare(&line.segment, at.point);
                }
            }
            self.end_edge(line.edge)?;
        }
        Some(())
    }

    /// Finds the points inside of edges of any directions. `None` if the work is to end.
    fn of_edges(&mut self, edges: &[u32]) -> Option<()> {
        if edges.is_empty() {
            return Some(());
        }
        let Search { points, near, .. } = *self.search;
        // Often these edges are in a small part of the shape.
        let ends = edges.iter().flat_map(|edge| self.search.edges[*edge as usize]);
        let around = Bounds::of(ends.map(|end| points[end as usize]).filter(|point| point.is_finite()));
        let (low, high) = (around.low - near, around.high + near);
        let is_near = |point: &DVec3| low.cmple(*point).all() && point.cmple(high).all();
        let numbers: Vec<u32> =
            (0..).zip(points).filter(|(_, point)| is_near(point)).map(|(number, _)| number).collect();
        if !work::spend(points.len()) {
            return None;
        }
        let boxes: Vec<Bounds> =
            numbers.iter().map(|&number| points[number as usize]).map(|at| Bounds { low: at, high: at }).collect();
        let tree = BoundsTree::of(&boxes);
        drop(boxes);
        for &edge in edges {
            if self.is_full() {
                break;
            }
            let Some(segment) = self.search.segment(edge) else { continue };
            let half = segment.along * (0.5 * segment.length);
            let (middle, size) = (segment.from + half, half.abs());
            let meets = |bounds: &Bounds| {
                let reach = (bounds.high - bounds.low) * 0.5 + near;
                let apart = (bounds.low + bounds.high) * 0.5 - middle;
                let turned = reach.zxy() * size.yzx() + reach.yzx() * size.zxy();
                apart.abs().cmple(reach + size).all() && apart.cross(half).abs().cmple(turned).all()
            };
            self.comparisons += tree.visit(meets, |at| {
                self.compare(&segment, numbers[at as usize]);
                true
            });
            self.end_edge(edge)?;
        }
        Some(())
    }

    /// Notes a point if it is inside of an edge.
    #[inline]
    fn compare(&mut self, segment: &Segment, point: u32) {
        let near = self.search.near;
        let offset = self.search.points[point as usize] - segment.from;
        let distance = offset.dot(segment.along);
        let is_between = near < distance && distance < segment.length - near;
        if is_between && (offset - segment.along * distance).length_squared() <= near * near {
            self.found.push((distance, point));
        }
        self.comparisons += 1;
    }

    /// Returns true after the most comparisons or points.
    fn is_full(&self) -> bool {
        let things = self.search.points.len() + self.search.edges.len();
        let most = |(each, all): (usize, usize)| each * things + all;
        most(MOST_COMPARISONS) < self.comparisons || most(MOST_INSIDE) < self.inside.len()
    }

    /// Ends the comparison of an edge with points. `None` if the work is to end.
    fn end_edge(&mut self, edge: u32) -> Option<()> {
        let units = 1 + self.comparisons - std::mem::replace(&mut self.told, self.comparisons);
        if !self.found.is_empty() {
            // The points of several cells, or in the order of the tree.
            self.found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let start = self.inside.len() as u32;
            self.inside.extend(self.found.drain(..).map(|(_, point)| point));
            self.ranges[edge as usize] = [start, self.inside.len() as u32];
        }
        work::spend(units).then_some(())
    }
}

/// The largest whole number that is at most `number`; faster than the library's where processors have no instruction for it.
#[inline]
fn whole(number: f64) -> i64 {
    let towards_zero = number as i64;
    towards_zero.saturating_sub(i64::from(number < towards_zero as f64))
}
