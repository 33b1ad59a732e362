//! The cells into which lines divide a facet.
//!
//! The lines are a planar graph. Its cycles, each with an area on its left, are the outlines of cells. Connected parts of
//! the graph that lie inside a cell are its holes, or lines that do not divide it. Across a line, the number of times that
//! outlines wind around a place changes by the number of times that they follow the line.

use glam::DVec2;

use super::budget::Budget;
use super::edge_table::EdgeTable;
use super::facet::Facet;
use super::lists::{Lists, Polygons};
use super::operation::BooleanError;
use super::point_set::PointSet;
use super::progress::{goes_on, sort};
use crate::bounds_tree::{BoundsTree, overlap};
use crate::buckets::Buckets;
use crate::disjoint::DisjointSets;
use crate::each::Each;
use crate::exact::orient;
use crate::mesh::Bounds;
use crate::small_sort::{SmallSort, sort_owned_by};

/// A facet whose outline winds around a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct FacetWinding {
    pub(super) facet: u32,
    /// The number of times, seen from the front of the place. Not 0.
    pub(super) winding: i32,
}

/// Makes the windings beyond a line that outlines follow `count` times: on its left, or on its right with `to_right`. Both lists are in
/// the order of the facets.
fn pass(windings: &mut Vec<FacetWinding>, count: &[FacetWinding], to_right: bool) {
    for step in count {
        let change = if to_right { -step.winding } else { step.winding };
        match windings.binary_search_by_key(&step.facet, |known| known.facet) {
            Ok(at) => {
                windings[at].winding += change;
                if windings[at].winding == 0 {
                    windings.remove(at);
                }
            }
            Err(at) => windings.insert(at, FacetWinding { facet: step.facet, winding: change }),
        }
    }
}

/// Regions of planes without edges that divide them.
#[derive(Debug, Default)]
pub(super) struct Cells {
    /// The outline, counter-clockwise in the facet's plane, and the holes.
    pub(super) rings: Polygons<u32>,
    /// The facets that are there, in order. Not empty.
    pub(super) windings: Lists<FacetWinding>,
    /// Edges inside that do not divide it.
    pub(super) inner: Lists<u32>,
}

/// Lines of a plane.
#[derive(Debug, Default)]
pub(super) struct GraphLines {
    /// The edge of each line, and its points.
    edges: Vec<u32>,
    ends: Vec<[u32; 2]>,
    /// For each line the facets whose outlines follow it, and the number of times, less the number of times backwards.
    counts: Lists<FacetWinding>,
}

impl GraphLines {
    /// Adds a line that is an edge between two points. The facets of `count` are in order.
    pub(super) fn push(&mut self, edge: u32, ends: [u32; 2], count: impl IntoIterator<Item = FacetWinding>) {
        self.edges.push(edge);
        self.ends.push(ends);
        self.counts.add(count);
    }
}

impl Cells {
    pub(super) fn len(&self) -> u32 {
        self.rings.len()
    }

    /// Adds the cells that lines with a count enclose. `at` gives the place of a point in the plane.
    pub(super) fn add(
        &mut self,
        lines: &GraphLines,
        at: &dyn Fn(u32) -> DVec2,
        budget: &mut Budget,
    ) -> Result<(), BooleanError> {
        LineGraph::new(&lines.ends, at)?.cells(lines, self, budget)
    }

    /// Adds the cells of a facet.
    pub(super) fn add_facet(
        &mut self,
        points: &PointSet,
        edges: &EdgeTable,
        number: u32,
        facet: &Facet<'_>,
        budget: &mut Budget,
    ) -> Result<(), BooleanError> {
        let own = edges.lines(number);
        let count = |line: &u32| edges.owner(*line, number).map_or(0, |owner| owner.count);
        if own.len() == facet.rings.corners.len() && facet.is_convex && own.iter().all(|line| count(line) != 0) {
            self.rings.add_ring(facet.rings.corners.iter().copied());
            self.rings.end();
            self.windings.add([FacetWinding { facet: number, winding: 1 }]);
            self.inner.end();
            return Ok(());
        }
        let mut lines = GraphLines::default();
        for line in own {
            let winding = count(line);
            let count = (winding != 0).then_some(FacetWinding { facet: number, winding });
            lines.push(*line, edges.list[*line as usize].ends, count);
        }
        let first = self.len();
        self.add(&lines, &|point| facet.flat(points.at[point as usize]), budget)?;
        // Lines that were led through points move by up to epsilon. A lost cell is much larger.
        let area_of = |cell| {
            let winding = self.windings.of(cell)[0].winding;
            f64::from(winding) * facet.double_area(points, self.rings.of(cell))
        };
        let area: f64 = (first..self.len()).map(area_of).sum();
        let length: f64 = lines.ends.iter().map(|ends| points.length(*ends)).sum();
        let is_whole = (area - facet.double_area(points, facet.rings)).abs() <= 8.0 * points.epsilon * length;
        if is_whole { Ok(()) } else { Err(BooleanError::Tangled) }
    }
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

    /// All cycles of the kept half-edges, each with an area on its left, and the cycle of each half-edge.
    fn cycles(&self, is_kept: impl Fn(u32) -> bool + Copy) -> Result<(Lists<u32>, Vec<u32>), BooleanError> {
        let mut of_half = vec![NONE; self.starts.len()];
        let mut cycles = Lists::default();
        for first in 0..self.starts.len() as u32 {
            if of_half[first as usize] != NONE || !is_kept(first) {
                continue;
            }
            let mut half = first;
            while of_half[half as usize] == NONE {
                of_half[half as usize] = cycles.len();
                cycles.push(self.starts[half as usize]);
                half = self.next(half, is_kept);
            }
            goes_on(cycles.open().len())?;
            cycles.end();
        }
        Ok((cycles, of_half))
    }

    /// Adds the cells that the lines with a count enclose.
    fn cells(&self, lines: &GraphLines, cells: &mut Cells, budget: &mut Budget) -> Result<(), BooleanError> {
        let (cycles, of_half) = self.cycles(|_| true)?;
        let parts = self.connected_parts(&of_half)?;
        let count = cycles.len() as usize;
        // The cell of each cycle, as the number of its outline, or `NONE` outside of all.
        let mut cell: Vec<u32> = (0..cycles.len()).collect();
        // The windings of each cycle, as the number of a list. The first list is the one outside of all.
        let (mut windings, mut winding) = (Lists::default(), vec![0; count]);
        windings.end();
        let (mut open, mut all, mut value): (Vec<u32>, usize, Vec<FacetWinding>) = (Vec::new(), 0, Vec::new());
        let bounds = |ring: &[u32]| Bounds::of(ring.iter().map(|point| self.flat[*point as usize].extend(0.0)));
        let boxes: Vec<Bounds> = cycles.iter().map(bounds).collect();
        let tree = BoundsTree::of(&boxes);
        let (mut is_done, mut is_known) = (vec![false; count], vec![false; count]);
        for (outer, halves) in parts.iter().map(|part| (part.outer, &part.halves)) {
            let first = cycles.of(outer)[0];
            let around = self.smallest_around(&cycles, (&boxes, &tree), &is_done, first, budget)?;
            cell[outer as usize] = around;
            winding[outer as usize] = if around == NONE { 0 } else { winding[around as usize] };
            let mut seen = vec![outer];
            open.push(outer);
            let mut by_cycle: Vec<(u32, u32)> = halves.iter().map(|half| (of_half[*half as usize], *half)).collect();
            sort(&mut by_cycle)?;
            is_known[outer as usize] = true;
            while let Some(cycle) = open.pop() {
                let from = by_cycle.partition_point(|entry| entry.0 < cycle);
                let here = winding[cycle as usize];
                for &(_, half) in by_cycle[from..].iter().take_while(|entry| entry.0 == cycle) {
                    let beyond = of_half[half as usize ^ 1];
                    value.clear();
                    value.extend(windings.of(here));
                    // The left side of a line has `count` more than its right side.
                    pass(&mut value, lines.counts.of(half / 2), half % 2 == 0);
                    let len = value.len().max(1);
                    budget.spend(len)?;
                    if !std::mem::replace(&mut is_known[beyond as usize], true) {
                        all += len;
                        if budget.windings < all {
                            return Err(BooleanError::TooMany);
                        }
                        let is_new = windings.of(here) != value;
                        winding[beyond as usize] = if is_new { windings.len() } else { here };
                        if is_new {
                            windings.add(value.iter().copied());
                        }
                        seen.push(beyond);
                        open.push(beyond);
                    } else if windings.of(winding[beyond as usize]) != value {
                        return Err(BooleanError::Tangled);
                    }
                }
            }
            seen.into_iter().filter(|cycle| *cycle != outer).for_each(|cycle| is_done[cycle as usize] = true);
        }
        let windings_of = |cycle: u32| windings.of(winding[cycle as usize]);
        self.collect(&cell, windings_of, &of_half, &lines.edges, cells)
    }

    /// The cycles of half-edges between different cells, and the cycle of each half-edge.
    fn borders(&self, cell: &[u32], of_half: &[u32]) -> Result<(Lists<u32>, Vec<u32>), BooleanError> {
        let cell_of = |half: u32| cell[of_half[half as usize] as usize];
        self.cycles(|half| cell_of(half) != cell_of(half ^ 1))
    }

    /// Adds the cells with a winding number, with their rings.
    fn collect<'w>(
        &self,
        cell: &[u32],
        windings_of: impl Fn(u32) -> &'w [FacetWinding],
        of_half: &[u32],
        edges: &[u32],
        cells: &mut Cells,
    ) -> Result<(), BooleanError> {
        let cell_of = |half: u32| cell[of_half[half as usize] as usize];
        let (borders, border_of) = self.borders(cell, of_half)?;
        let mut number_of = vec![NONE; cell.len()];
        let mut is_done = vec![false; borders.len() as usize];
        // The outline of each new cell, as the number of a cycle.
        let mut outlines: Vec<u32> = Vec::new();
        // All rings and inner edges, and the cell of each.
        let (mut rings, mut cell_of_ring) = (Lists::default(), Vec::new());
        let (mut inner, mut cell_of_inner) = (Vec::new(), Vec::new());
        for half in 0..self.starts.len() as u32 {
            let outline = cell_of(half);
            if outline == NONE || windings_of(outline).is_empty() {
                continue;
            }
            let number = &mut number_of[outline as usize];
            if *number == NONE {
                *number = outlines.len() as u32;
                outlines.push(outline);
            }
            let border = border_of[half as usize];
            if border == NONE {
                if half % 2 == 0 {
                    inner.push(edges[half as usize / 2]);
                    cell_of_inner.push(*number);
                }
            } else if !std::mem::replace(&mut is_done[border as usize], true) {
                self.add_simple_rings(borders.of(border), &mut rings);
                cell_of_ring.resize(rings.len() as usize, *number);
            }
        }
        let rings_of = Buckets::by(outlines.len(), cell_of_ring.iter().copied());
        let inner_of = Buckets::by(outlines.len(), cell_of_inner.iter().copied());
        for (number, outline) in outlines.into_iter().enumerate() {
            let own = rings_of.of(number);
            let mut outer = own.iter().filter(|ring| 0.0 < self.area(rings.of(**ring)));
            let (Some(first), None) = (outer.next(), outer.next()) else { return Err(BooleanError::Tangled) };
            for ring in [first].into_iter().chain(own.iter().filter(|ring| *ring != first)) {
                cells.rings.add_ring(rings.of(*ring).iter().map(|point| self.points[*point as usize]));
            }
            cells.rings.end();
            cells.windings.add(windings_of(outline).iter().copied());
            cells.inner.add(inner_of.of(number).iter().map(|at| inner[*at as usize]));
        }
        Ok(())
    }

    fn area(&self, ring: &[u32]) -> f64 {
        let at = |i: usize| self.flat[ring[i % ring.len()] as usize] - self.flat[ring[0] as usize];
        (1..ring.len()).map(|i| at(i).perp_dot(at(i + 1))).sum()
    }

    /// Divides a ring that meets itself into rings that have each point once.
    fn add_simple_rings(&self, ring: &[u32], rings: &mut Lists<u32>) {
        let mut sorted = ring.to_vec();
        sorted.small_sort();
        if sorted.windows(2).all(|pair| pair[0] != pair[1]) {
            return rings.add(ring.iter().copied());
        }
        let mut stack: Vec<u32> = Vec::new();
        // The place of each point on the stack.
        let mut places = std::collections::BTreeMap::new();
        for &point in ring {
            if let Some(start) = places.get(&point).copied() {
                let found = stack.split_off(start as usize);
                found.iter().for_each(|point| _ = places.remove(point));
                if 3 <= found.len() {
                    rings.add(found);
                }
            }
            places.insert(point, stack.len() as u32);
            stack.push(point);
        }
        if 3 <= stack.len() {
            rings.add(stack);
        }
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
        sort_owned_by(&mut parts, |a, b| b.size.total_cmp(&a.size));
        Ok(parts)
    }

    /// The smallest of some cycles around a point that is on none of them.
    fn smallest_around(
        &self,
        cycles: &Lists<u32>,
        (boxes, tree): (&[Bounds], &BoundsTree),
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
                let is_near = counts[number as usize] && overlap(&boxes[number as usize], &here);
                near.extend(is_near.then_some(number));
                true
            },
        );
        budget.spend(visited)?;
        let area = |number: u32| self.area(cycles.of(number));
        near.small_sort_by(|&a, &b| area(a).total_cmp(&area(b)).then(a.cmp(&b)));
        for number in near {
            let ring = cycles.of(number);
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
