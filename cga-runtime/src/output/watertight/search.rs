//! The search for points inside of edges.
//!
//! Most edges of a building have one of few directions. Seen along such a direction, an edge is a point, so a table has the edges at each
//! place across it, and each point of the shape is looked up once. Other edges are compared with a tree of all points.

use std::ops::Range;

use glam::{DVec3, Vec3Swizzles};

use super::numbered_keys::NumberedKeys;
use crate::geometry::bounds_tree::BoundsTree;
use crate::geometry::each::Each;
use crate::geometry::long_sort::long_sort_by;
use crate::geometry::mesh::Bounds;
use crate::geometry::small_sort::SmallSort;
use crate::geometry::work;

/// Directions are equal if their coordinates differ by less than this.
const DIRECTION: f64 = 1e-7;

/// If edges have more directions than [`FEW_DIRECTIONS`], a direction has a table if it has at least this share of edges for each point.
const EDGES_A_POINT: f64 = 0.01;

/// With less edges for each point, only the points in the bounds of the edges are seen along the direction.
const MANY_EDGES_A_POINT: f64 = 0.15;

/// An edge has the direction of an axis if its ends differ by less than this across it, for each metre of its length.
const ALONG_AXIS: f64 = 1e-9;

/// If edges have at most this number of directions, each direction has a table. More tables take longer than a tree of all points.
const FEW_DIRECTIONS: usize = 16;

/// Directions that are compared one by one, before a table has the others.
const FIRST_DIRECTIONS: usize = 6;

/// Points of a cell are sorted if there are more.
const MANY: usize = 32;

/// The side of a cell, and the reach of an edge around it, in distances within which a point is in an edge. Most edges are in one cell.
const CELL: f64 = 30.901_699_437_5;
const REACH: f64 = 1.25;

/// An edge is seen as a point if its ends are nearer, in the same unit.
const SLANT: f64 = 0.25;

/// Points at the ends of an edge are not compared with it: along a direction they are nearer to an end than this, in the same unit. An edge
/// and its direction differ by less than the rest.
const AT_END: f64 = 0.5;

/// The points or edges between two counts of work.
const BLOCK: usize = 1024;

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

/// An edge seen along its direction, and the cells of the table in which its points may be: up to four, and then [`NO_CELL`].
struct Line {
    edge: u32,
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
    table: Table,
}

/// The points and edges as they are seen along a direction. It keeps its lists from direction to direction.
#[derive(Default)]
struct Table {
    /// The points that may be in the cells.
    near: Vec<u32>,
    /// For each of these points, by its number, its place across the direction and along it.
    seen: Vec<[f64; 3]>,
    places: NumberedKeys<[i64; 2]>,
    lines: Vec<Line>,
    /// For each of these points, by its number, its cell or [`NO_CELL`].
    cells: Vec<u32>,
    /// For each cell the end of its points in `sorted`.
    ends: Vec<u32>,
    sorted: Vec<InCell>,
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
            table: Table::default(),
        };
        let (classes, mut others) = self.directions()?;
        for (along, edges) in classes {
            finder.of_direction(along, &edges, &mut others)?;
        }
        others.small_sort_unstable();
        finder.of_edges(&others)?;
        Some((finder.ranges, finder.inside))
    }

    /// The directions of many edges, each with the numbers of its edges, and the other edges.
    fn directions(&self) -> Option<(Vec<Direction>, Vec<u32>)> {
        let mut keys: NumberedKeys<[i64; 3]> = NumberedKeys::default();
        // For each direction its longest edge.
        let mut found: Vec<(f64, DVec3, Vec<u32>)> = Vec::new();
        for number in 0..self.edges.len() as u32 {
            if !work::spend(1) {
                return None;
            }
            let Some((key, along, length)) = self.direction(number) else { continue };
            // Most edges have one of the first directions.
            let first = keys.keys().iter().take(FIRST_DIRECTIONS).position(|known| *known == key);
            let at = first.unwrap_or_else(|| keys.number(key) as usize);
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

    /// The direction of an edge as whole numbers and as a vector, and its length, if it is long enough for a point.
    fn direction(&self, edge: u32) -> Option<([i64; 3], DVec3, f64)> {
        let [from, to] = self.edges[edge as usize].each(|end| self.points[end as usize]);
        let size = (to - from).abs();
        for (axis, along) in DVec3::AXES.into_iter().enumerate() {
            let (length, across) = (size[axis], ALONG_AXIS * size[axis]);
            if size[(axis + 1) % 3] <= across && size[(axis + 2) % 3] <= across {
                let is_long = 2.0 * self.near < length && length.is_finite();
                let key = along.to_array().each(|c| (c / DIRECTION) as i64);
                return is_long.then_some((key, along, length));
            }
        }
        let Segment { along, length, .. } = self.segment(edge)?;
        let main = (0..3).fold(0, |most, axis| if size[most] < size[axis] { axis } else { most });
        let along = if along[main] < 0.0 { -along } else { along };
        Some((along.to_array().each(|c| whole(c * (1.0 / DIRECTION) + 0.5)), along, length))
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
        let mut table = std::mem::take(&mut self.table);
        let goes_on = table.fill(self.search, along, edges, others);
        let goes_on = goes_on.and_then(|()| table.lines.iter().try_for_each(|line| self.of_line(&table, line)));
        self.table = table;
        goes_on
    }

    /// Finds the points inside of an edge in the cells of a table. `None` if the work is to end.
    fn of_line(&mut self, table: &Table, line: &Line) -> Option<()> {
        if self.is_full() {
            return Some(());
        }
        let [from, to] = self.search.edges[line.edge as usize].each(|end| table.seen[end as usize][2]);
        let end = AT_END * self.search.near;
        let (low, high) = (from.min(to) + end, from.max(to) - end);
        let mut segment = None;
        for &cell in line.cells.iter().take_while(|cell| **cell != NO_CELL) {
            let mut points = &table.sorted[table.range(cell as usize)];
            if MANY < points.len() {
                let first = points.partition_point(|at| at.length <= low);
                points = &points[first..];
                points = &points[..points.partition_point(|at| at.length < high)];
            }
            for at in points.iter().filter(|at| low < at.length && at.length < high) {
                segment = segment.or_else(|| self.search.segment(line.edge));
                if let Some(segment) = &segment {
                    self.compare(segment, at.point);
                }
            }
        }
        self.end_edge(line.edge)
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
            self.found.small_sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let start = self.inside.len() as u32;
            self.inside.extend(self.found.drain(..).map(|(_, point)| point));
            self.ranges[edge as usize] = [start, self.inside.len() as u32];
        }
        work::spend(units).then_some(())
    }
}

impl Table {
    /// Fills the table with the edges of a direction, and with the points in their cells. Edges with a slightly different direction are
    /// added to `others`. `None` if the work is to end.
    fn fill(&mut self, search: &Search<'_>, along: DVec3, edges: &[u32], others: &mut Vec<u32>) -> Option<()> {
        let Search { points, origin, near, .. } = *search;
        let (u, v) = along.any_orthonormal_pair();
        self.find_near(search, edges)?;
        self.seen.resize(points.len(), [0.0; 3]);
        self.cells.resize(points.len(), NO_CELL);
        for block in self.near.chunks(BLOCK) {
            if !work::spend(block.len()) {
                return None;
            }
            for &point in block {
                let from_origin = points[point as usize] - origin;
                self.seen[point as usize] = [u, v, along].each(|axis| from_origin.dot(axis));
                self.cells[point as usize] = NO_CELL;
            }
        }
        self.places.clear();
        self.lines.clear();
        let (reach, cells_a_metre) = (REACH * near, 1.0 / (CELL * near));
        // Zero is in the middle of a cell: many edges are there.
        let cell = |c: f64| whole(c * cells_a_metre + 0.5);
        for block in edges.chunks(BLOCK) {
            if !work::spend(2 * block.len()) {
                return None;
            }
            for &edge in block {
                let [a, b] = search.edges[edge as usize].each(|end| end as usize);
                let [from, to] = [a, b].each(|end| self.seen[end]);
                let slant = (from[0] - to[0]).abs().max((from[1] - to[1]).abs());
                if slant.is_nan() || SLANT * near < slant {
                    others.push(edge);
                    continue;
                }
                let [[u, last_u], [v, last_v]] = [from[0], from[1]].each(|c| [cell(c - reach), cell(c + reach)]);
                let mut own = [NO_CELL; 4];
                if (u, v) == (last_u, last_v) {
                    // Both ends are in the one cell.
                    own[0] = self.cells[a].min(self.cells[b]);
                    if own[0] == NO_CELL {
                        own[0] = self.places.number([u, v]);
                    }
                    self.cells[a] = own[0];
                    self.cells[b] = own[0];
                } else {
                    let mut count = 0;
                    for u in u..=last_u {
                        for v in v..=last_v {
                            own[count % 4] = self.places.number([u, v]);
                            count += 1;
                        }
                    }
                }
                self.lines.push(Line { edge, cells: own });
            }
        }
        self.sort_points(|[u, v, _]| [cell(u), cell(v)])
    }

    /// Finds the points that may be inside of some edges, and the ends of the edges. `None` if the work is to end.
    fn find_near(&mut self, search: &Search<'_>, edges: &[u32]) -> Option<()> {
        let points = search.points;
        if !work::spend(points.len()) {
            return None;
        }
        self.near.clear();
        if MANY_EDGES_A_POINT * points.len() as f64 <= edges.len() as f64 {
            self.near.extend(0..points.len() as u32);
            return Some(());
        }
        let ends = edges.iter().flat_map(|edge| search.edges[*edge as usize]).map(|end| points[end as usize]);
        let around = Bounds::of(ends);
        let (low, high) = (around.low - search.near, around.high + search.near);
        let is_near = |point: &DVec3| low.cmple(*point).all() && point.cmple(high).all();
        self.near.extend((0..).zip(points).filter(|(_, point)| is_near(point)).map(|(number, _)| number));
        Some(())
    }

    /// The points of a cell in `sorted`.
    fn range(&self, cell: usize) -> Range<usize> {
        let start = if cell == 0 { 0 } else { self.ends[cell - 1] };
        start as usize..self.ends[cell] as usize
    }

    /// Finds the cell of each point that is not an end of an edge, and sorts the points by cells. `None` if the work is to end.
    fn sort_points(&mut self, place: impl Fn([f64; 3]) -> [i64; 2]) -> Option<()> {
        let count = self.places.keys().len();
        self.ends.clear();
        self.ends.resize(count + 1, 0);
        for block in self.near.chunks(BLOCK) {
            if !work::spend(block.len()) {
                return None;
            }
            for &point in block {
                let cell = &mut self.cells[point as usize];
                if *cell == NO_CELL {
                    *cell = self.places.get(place(self.seen[point as usize])).unwrap_or(NO_CELL);
                }
                if *cell != NO_CELL {
                    self.ends[*cell as usize + 1] += 1;
                }
            }
        }
        (0..count).for_each(|cell| self.ends[cell + 1] += self.ends[cell]);
        self.sorted.clear();
        self.sorted.resize(self.ends[count] as usize, InCell { point: 0, length: 0.0 });
        for &point in &self.near {
            let cell = self.cells[point as usize];
            if cell != NO_CELL {
                let end = &mut self.ends[cell as usize];
                self.sorted[*end as usize] = InCell { point, length: self.seen[point as usize][2] };
                *end += 1;
            }
        }
        for cell in 0..count {
            let range = self.range(cell);
            let order = |a: &InCell, b: &InCell| a.length.total_cmp(&b.length).then(a.point.cmp(&b.point));
            if MANY < range.len() && !long_sort_by(&mut self.sorted[range], order) {
                return None;
            }
        }
        Some(())
    }
}

/// The largest whole number that is at most `number`; faster than the library's where processors have no instruction for it.
#[inline]
fn whole(number: f64) -> i64 {
    let towards_zero = number as i64;
    towards_zero.saturating_sub(i64::from(number < towards_zero as f64))
}
