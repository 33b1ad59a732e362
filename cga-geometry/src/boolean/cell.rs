//! The cells into which lines divide a facet.
//!
//! The lines are a planar graph. Its cycles, each with an area on its left, are the outlines of cells. Connected parts of
//! the graph that lie inside a cell are its holes, or lines that do not divide it. Across a line, the number of times that
//! outlines wind around a place changes by the number of times that they follow the line.

use glam::DVec2;

use super::budget::Budget;
use super::edge_table::EdgeTable;
use super::facet::Facet;
use super::operation::BooleanError;
use super::point_set::PointSet;
use super::progress::{goes_on, sort};
use crate::bounds_tree::{BoundsTree, overlap};
use crate::buckets::Buckets;
use crate::disjoint::DisjointSets;
use crate::each::Each;
use crate::exact::orient;
use crate::mesh::Bounds;
use crate::small_sort::SmallSort;

/// The number of times that outlines wind around a place.
pub(super) trait Winding: Clone + Default + PartialEq {
    /// The number beyond a line that outlines follow `count` times: on its left, or on its right with `to_right`.
    fn across(&self, count: &Self, to_right: bool) -> Self;

    /// Returns true outside of all outlines.
    fn is_outside(&self) -> bool;

    /// The number of values.
    fn len(&self) -> usize;
}

impl Winding for i32 {
    fn across(&self, count: &Self, to_right: bool) -> Self {
        if to_right { self - count } else { self + count }
    }

    fn is_outside(&self) -> bool {
        *self == 0
    }

    fn len(&self) -> usize {
        1
    }
}

/// A region of a plane without edges that divide it.
#[derive(Debug)]
pub(super) struct Cell<W> {
    /// The number of times that outlines wind around it. Not 0.
    pub(super) winding: W,
    /// The outline, counter-clockwise in the facet's plane, and the holes.
    pub(super) rings: Vec<Vec<u32>>,
    /// Edges inside that do not divide it.
    pub(super) inner: Vec<u32>,
}

/// A line of the graph, and the number of times that the outline follows it, less the number of times backwards.
pub(super) struct GraphLine<W> {
    pub(super) ends: [u32; 2],
    pub(super) count: W,
}

/// The cells that the lines with a count enclose. `at` gives the place of a point in the plane.
pub(super) fn cells<W: Winding>(
    lines: &[GraphLine<W>],
    at: &dyn Fn(u32) -> DVec2,
    budget: &mut Budget,
) -> Result<Vec<Cell<W>>, BooleanError> {
    let ends: Vec<[u32; 2]> = lines.iter().map(|line| line.ends).collect();
    LineGraph::new(&ends, at)?.cells(lines, budget)
}

/// The cells of a facet.
pub(super) fn cells_of(
    points: &PointSet,
    edges: &EdgeTable,
    number: u32,
    facet: &Facet,
    budget: &mut Budget,
) -> Result<Vec<Cell<i32>>, BooleanError> {
    let count = |line: u32| edges.owner(line, number).map_or(0, |owner| owner.count);
    if facet.lines.len() == facet.corners.len() && facet.is_convex && facet.lines.iter().all(|line| count(*line) != 0) {
        return Ok(vec![Cell { winding: 1, rings: vec![facet.corners.clone()], inner: Vec::new() }]);
    }
    let line = |line: &u32| GraphLine { ends: edges.list[*line as usize].ends, count: count(*line) };
    let lines: Vec<GraphLine<i32>> = facet.lines.iter().map(line).collect();
    let mut cells = cells(&lines, &|point| facet.flat(points.at[point as usize]), budget)?;
    cells.iter_mut().flat_map(|cell| &mut cell.inner).for_each(|line| *line = facet.lines[*line as usize]);
    // Lines that were led through points move by up to epsilon. A lost cell is much larger.
    let area: f64 = cells.iter().map(|cell| f64::from(cell.winding) * double_area(points, facet, &cell.rings)).sum();
    let length: f64 = lines.iter().map(|line| points.length(line.ends)).sum();
    let is_whole = (area - facet.double_area(points)).abs() <= 8.0 * points.epsilon * length;
    if is_whole { Ok(cells) } else { Err(BooleanError::Tangled) }
}

/// Twice the area of rings in a facet's plane.
pub(super) fn double_area(points: &PointSet, facet: &Facet, rings: &[Vec<u32>]) -> f64 {
    let flat = |point: u32| facet.flat(points.at[point as usize]);
    let from = flat(rings[0][0]);
    let ring_area = |ring: &Vec<u32>| -> f64 {
        let ends = ring.iter().zip(ring.iter().cycle().skip(1));
        ends.map(|(a, b)| (flat(*a) - from).perp_dot(flat(*b) - from)).sum()
    };
    rings.iter().map(ring_area).sum()
}

const NONE: u32 = u32::MAX;

/// Lines as pairs of half-edges: half-edge `2 i` follows line `i`, half-edge `2 i + 1` runs back.
struct LineGraph {
    /// The points, by their numbers in the graph.
    points: Vec<u32>,
    flat: Vec<DVec2>,
    /// The start of each half-edge.
    starts: Vec<u32>,
    /// The half-edges that leave each point, counter-clockwise.
    leaving: Buckets,
    /// The place of each half-edge among all of these.
    places: Vec<u32>,
}

/// A cycle of half-edges with a face on its left.
struct Cycle {
    area: f64,
    bounds: Bounds,
    ring: Vec<u32>,
}

impl LineGraph {
    fn new(lines: &[[u32; 2]], at: &dyn Fn(u32) -> DVec2) -> Result<Self, BooleanError> {
        let mut points = lines.as_flattened().to_vec();
        sort(&mut points)?;
        points.dedup();
        goes_on(lines.len())?;
        let flat: Vec<DVec2> = points.iter().map(|point| at(*point)).collect();
        let number = |point: u32| points.binary_search(&point).unwrap_or_default() as u32;
        let mut starts = Vec::with_capacity(2 * lines.len());
        for line in lines {
            goes_on(2)?;
            starts.extend(line.each(number));
        }
        let mut leaving = Buckets::by(points.len(), starts.iter().copied());
        let mut places = vec![0; starts.len()];
        for point in 0..points.len() {
            let range = leaving.range(point);
            let (first, list) = (range.start as u32, &mut leaving.items[range]);
            goes_on(list.len())?;
            let end = |half: u32| flat[starts[half as usize ^ 1] as usize];
            let lower = |half: u32| {
                let step = end(half) - flat[point];
                step.y < 0.0 || (step.y == 0.0 && step.x < 0.0)
            };
            let turn = |a: u32, b: u32| orient(flat[point], end(a), end(b));
            list.small_sort_by(|&a, &b| lower(a).cmp(&lower(b)).then_with(|| turn(b, a).cmp(&0)).then(a.cmp(&b)));
            if list.windows(2).any(|pair| lower(pair[0]) == lower(pair[1]) && turn(pair[0], pair[1]) <= 0) {
                return Err(BooleanError::Tangled);
            }
            (first..).zip(list).for_each(|(place, half)| places[*half as usize] = place);
        }
        Ok(LineGraph { points, flat, starts, leaving, places })
    }

    /// The half-edge after another one in the cycle on its left, among those that are kept.
    fn next(&self, half: u32, is_kept: impl Fn(u32) -> bool) -> u32 {
        let back = half ^ 1;
        let around = self.leaving.range(self.starts[back as usize] as usize);
        let mut place = self.places[back as usize] as usize;
        loop {
            place = if place == around.start { around.end } else { place } - 1;
            let half = self.leaving.items[place];
            if is_kept(half) {
                return half;
            }
        }
    }

    /// All cycles of the kept half-edges, and the cycle of each half-edge.
    fn cycles(&self, is_kept: impl Fn(u32) -> bool + Copy) -> Result<(Vec<Cycle>, Vec<u32>), BooleanError> {
        let mut of_half = vec![NONE; self.starts.len()];
        let mut cycles = Vec::new();
        for first in 0..self.starts.len() as u32 {
            if of_half[first as usize] != NONE || !is_kept(first) {
                continue;
            }
            let mut half = first;
            let mut ring = Vec::new();
            while of_half[half as usize] == NONE {
                of_half[half as usize] = cycles.len() as u32;
                ring.push(self.starts[half as usize]);
                half = self.next(half, is_kept);
            }
            goes_on(ring.len())?;
            let at = |point: u32| self.flat[point as usize];
            let from = at(ring[0]);
            let ends = ring.iter().zip(ring.iter().cycle().skip(1));
            let area = ends.map(|(a, b)| (at(*a) - from).perp_dot(at(*b) - from)).sum();
            let bounds = Bounds::of(ring.iter().map(|point| at(*point).extend(0.0)));
            cycles.push(Cycle { area, bounds, ring });
        }
        Ok((cycles, of_half))
    }

    /// The cells that the lines with a count enclose.
    fn cells<W: Winding>(&self, lines: &[GraphLine<W>], budget: &mut Budget) -> Result<Vec<Cell<W>>, BooleanError> {
        let (cycles, of_half) = self.cycles(|_| true)?;
        let parts = self.connected_parts(&of_half)?;
        // The cell of each cycle, as the number of its outline, or `NONE` outside of all.
        let mut cell: Vec<u32> = (0..cycles.len() as u32).collect();
        let mut winding = vec![W::default(); cycles.len()];
        let (mut open, mut windings): (Vec<u32>, usize) = (Vec::new(), 0);
        let boxes: Vec<Bounds> = cycles.iter().map(|cycle| cycle.bounds).collect();
        let tree = BoundsTree::of(&boxes);
        let (mut is_done, mut is_known) = (vec![false; cycles.len()], vec![false; cycles.len()]);
        for (outer, halves) in parts.iter().map(|part| (part.outer, &part.halves)) {
            let around = self.smallest_around(&cycles, &tree, &is_done, cycles[outer as usize].ring[0], budget)?;
            cell[outer as usize] = around;
            winding[outer as usize] = if around == NONE { W::default() } else { winding[around as usize].clone() };
            let mut seen = vec![outer];
            open.push(outer);
            let mut by_cycle: Vec<(u32, u32)> = halves.iter().map(|half| (of_half[*half as usize], *half)).collect();
            sort(&mut by_cycle)?;
            is_known[outer as usize] = true;
            while let Some(cycle) = open.pop() {
                let from = by_cycle.partition_point(|entry| entry.0 < cycle);
                for &(_, half) in by_cycle[from..].iter().take_while(|entry| entry.0 == cycle) {
                    let beyond = of_half[half as usize ^ 1];
                    // The left side of a line has `count` more than its right side.
                    let value = winding[cycle as usize].across(&lines[half as usize / 2].count, half % 2 == 0);
                    budget.spend(value.len())?;
                    if !std::mem::replace(&mut is_known[beyond as usize], true) {
                        windings += value.len();
                        if budget.windings < windings {
                            return Err(BooleanError::TooMany);
                        }
                        winding[beyond as usize] = value;
                        seen.push(beyond);
                        open.push(beyond);
                    } else if winding[beyond as usize] != value {
                        return Err(BooleanError::Tangled);
                    }
                }
            }
            seen.into_iter().filter(|cycle| *cycle != outer).for_each(|cycle| is_done[cycle as usize] = true);
        }
        self.collect(&cell, &winding, &of_half)
    }

    /// The cycles of half-edges between different cells, and the cycle of each half-edge.
    fn borders(&self, cell: &[u32], of_half: &[u32]) -> Result<(Vec<Cycle>, Vec<u32>), BooleanError> {
        let cell_of = |half: u32| cell[of_half[half as usize] as usize];
        self.cycles(|half| cell_of(half) != cell_of(half ^ 1))
    }

    /// The cells with a winding number, with their rings.
    fn collect<W: Winding>(&self, cell: &[u32], winding: &[W], of_half: &[u32]) -> Result<Vec<Cell<W>>, BooleanError> {
        let cell_of = |half: u32| cell[of_half[half as usize] as usize];
        let (rings, ring_of) = self.borders(cell, of_half)?;
        let mut cells: Vec<Cell<W>> = Vec::new();
        let mut number_of = vec![NONE; cell.len()];
        let mut is_done = vec![false; rings.len()];
        for half in 0..self.starts.len() as u32 {
            let outline = cell_of(half);
            if outline == NONE || winding[outline as usize].is_outside() {
                continue;
            }
            if number_of[outline as usize] == NONE {
                number_of[outline as usize] = cells.len() as u32;
                let winding = winding[outline as usize].clone();
                cells.push(Cell { winding, rings: Vec::new(), inner: Vec::new() });
            }
            let made = &mut cells[number_of[outline as usize] as usize];
            let ring = ring_of[half as usize];
            if ring == NONE {
                if half % 2 == 0 {
                    made.inner.push(half / 2);
                }
            } else if !std::mem::replace(&mut is_done[ring as usize], true) {
                self.add_simple_rings(&rings[ring as usize].ring, &mut made.rings);
            }
        }
        for cell in &mut cells {
            let area = |ring: &Vec<u32>| self.area(ring);
            let outlines = cell.rings.iter().filter(|ring| 0.0 < area(ring)).count();
            let Some(outline) = cell.rings.iter().position(|ring| 0.0 < area(ring)).filter(|_| outlines == 1) else {
                return Err(BooleanError::Tangled);
            };
            cell.rings[..=outline].rotate_right(1);
            cell.rings.iter_mut().flatten().for_each(|point| *point = self.points[*point as usize]);
        }
        Ok(cells)
    }

    fn area(&self, ring: &[u32]) -> f64 {
        let at = |i: usize| self.flat[ring[i % ring.len()] as usize] - self.flat[ring[0] as usize];
        (1..ring.len()).map(|i| at(i).perp_dot(at(i + 1))).sum()
    }

    /// Divides a ring that meets itself into rings that have each point once.
    fn add_simple_rings(&self, ring: &[u32], rings: &mut Vec<Vec<u32>>) {
        let mut sorted = ring.to_vec();
        sorted.small_sort();
        if sorted.windows(2).all(|pair| pair[0] != pair[1]) {
            return rings.push(ring.to_vec());
        }
        let mut stack: Vec<u32> = Vec::new();
        // The place of each point on the stack.
        let mut places = std::collections::BTreeMap::new();
        for &point in ring {
            if let Some(start) = places.get(&point).copied() {
                let found = stack.split_off(start as usize);
                found.iter().for_each(|point| _ = places.remove(point));
                rings.extend((3 <= found.len()).then_some(found));
            }
            places.insert(point, stack.len() as u32);
            stack.push(point);
        }
        rings.extend((3 <= stack.len()).then_some(stack));
    }

    /// The connected parts of the graph, those with large boxes first.
    fn connected_parts(&self, of_half: &[u32]) -> Result<Vec<GraphPart>, BooleanError> {
        let mut sets = DisjointSets::new(self.points.len());
        for line in self.starts.chunks_exact(2) {
            sets.unite(line[0], line[1]);
        }
        goes_on(self.points.len())?;
        let mut parts: Vec<GraphPart> = Vec::new();
        for set in sets.sets() {
            goes_on(set.len())?;
            let at = |point: u32| self.flat[point as usize];
            let lowest = set.iter().copied().min_by(|&a, &b| {
                let [a, b] = [at(a), at(b)];
                a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
            });
            let Some(lowest) = lowest else { continue };
            // All lines lead to the right, or straight up. The outer face is beyond the steepest one.
            let around = self.leaving.of(lowest as usize);
            let rises = |half: u32| self.flat[self.starts[half as usize ^ 1] as usize].y >= at(lowest).y;
            let steepest = around.iter().rev().find(|half| rises(**half)).or(around.last());
            let Some(&steepest) = steepest else { continue };
            let size =
                set.iter().fold([at(lowest); 2], |[low, high], point| [low.min(at(*point)), high.max(at(*point))]);
            let halves = set.iter().flat_map(|point| self.leaving.of(*point as usize).iter().copied()).collect();
            parts.push(GraphPart {
                outer: of_half[steepest as usize],
                halves,
                size: (size[1] - size[0]).max_element(),
            });
        }
        parts.sort_by(|a, b| b.size.total_cmp(&a.size));
        Ok(parts)
    }

    /// The smallest of some cycles around a point that is on none of them.
    fn smallest_around(
        &self,
        cycles: &[Cycle],
        tree: &BoundsTree,
        counts: &[bool],
        point: u32,
        budget: &mut Budget,
    ) -> Result<u32, BooleanError> {
        let place = self.flat[point as usize];
        let here = Bounds::of([place.extend(0.0)]);
        let mut near: Vec<u32> = Vec::new();
        let mut visited = 0;
        tree.visit(
            |around| overlap(around, &here),
            |number| {
                visited += 1;
                let is_near = counts[number as usize] && overlap(&cycles[number as usize].bounds, &here);
                near.extend(is_near.then_some(number));
                true
            },
        );
        budget.spend(visited)?;
        let area = |number: u32| cycles[number as usize].area;
        near.small_sort_by(|&a, &b| area(a).total_cmp(&area(b)).then(a.cmp(&b)));
        for number in near {
            let ring = &cycles[number as usize].ring;
            budget.spend(ring.len())?;
            let mut turns = 0;
            for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                let [a, b] = [a, b].each(|point| self.flat[*point as usize]);
                if a.y <= place.y && place.y < b.y {
                    turns += i32::from(0 < orient(a, b, place));
                } else if b.y <= place.y && place.y < a.y {
                    turns -= i32::from(orient(a, b, place) < 0);
                }
            }
            if turns != 0 {
                return Ok(number);
            }
        }
        Ok(NONE)
    }
}

/// A connected part of the graph.
struct GraphPart {
    /// The cycle around it, with the outside on its left.
    outer: u32,
    halves: Vec<u32>,
    size: f64,
}
