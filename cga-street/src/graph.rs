//! The graph of centre lines: lines are divided at meeting points, and ends near other lines are moved onto them.

use cga_geometry::each::Each;
use cga_geometry::small_sort::SmallSort;
use std::collections::{BTreeMap, BTreeSet};

use glam::{DVec2, DVec3};

use super::grid::{GridMap, Point};
use super::input::{Centerline, NetworkOptions};
use super::progress::{EDGE, spend};
use super::rounding::divide;
use super::segment_tree::SegmentTree;
use super::{MOST_CROSSINGS, StreetError};

/// A straight part of a centre line between two vertices, in the direction of the line.
#[derive(Clone, Copy, Debug)]
pub(super) struct StreetEdge {
    pub(super) ends: [u32; 2],
    pub(super) line: u32,
}

/// Vertices, edges, and the edges at each vertex.
#[derive(Debug, Default)]
pub(super) struct Graph {
    /// The vertices in plan, each with its height as z.
    pub(super) points: Vec<DVec3>,
    pub(super) edges: Vec<StreetEdge>,
    pub(super) around: Vec<Vec<u32>>,
}

/// A point of a line with its height.
type LinePoint = (Point, f64);

/// A segment of a line.
struct LineSegment {
    ends: [LinePoint; 2],
    line: u32,
}

impl Graph {
    /// The graph of checked lines.
    pub(super) fn new(lines: &[Centerline], options: &NetworkOptions) -> Result<Self, StreetError> {
        let mut paths: Vec<Vec<LinePoint>> = Vec::with_capacity(lines.len());
        for line in lines {
            spend(EDGE * line.points.len())?;
            paths.push(path(line));
        }
        if 0.0 < options.snap {
            join_ends(&mut paths, options.snap)?;
            reach_segments(&mut paths, options.snap)?;
        }
        let (mut segments, mut known) = (Vec::new(), BTreeSet::new());
        for (line, path) in paths.iter().enumerate() {
            spend(EDGE * path.len())?;
            let ends = path.windows(2).map(|ends| LineSegment { ends: [ends[0], ends[1]], line: line as u32 });
            // Each segment once, for the first of its lines.
            segments.extend(ends.filter(|segment| {
                let [a, b] = segment.ends.each(|end| end.0);
                a != b && known.insert([a.min(b), a.max(b)])
            }));
        }
        let mut graph = Graph::divided(&segments)?;
        if 0.0 < options.snap {
            // Moved ends may make edges meet in new places.
            graph = Graph::divided(&graph.contracted(options.snap)?)?;
        }
        Ok(graph)
    }

    /// The graph of segments, which may meet anywhere.
    fn divided(segments: &[LineSegment]) -> Result<Self, StreetError> {
        let plain: Vec<[Point; 2]> = segments.iter().map(|segment| segment.ends.each(|end| end.0)).collect();
        let chains = divide(&plain, MOST_CROSSINGS)?;
        let mut graph = Graph::default();
        let mut numbers: GridMap<Point, u32> = GridMap::default();
        let mut known: BTreeSet<[u32; 2]> = BTreeSet::new();
        // Ends of segments keep their heights; a crossing gets the height of the first line.
        for segment in segments {
            spend(2 * EDGE)?;
            for (point, height) in segment.ends {
                graph.vertex(&mut numbers, point, height);
            }
        }
        for (segment, chain) in segments.iter().zip(&chains) {
            let [(a, low), (b, high)] = segment.ends;
            let length = a.place().distance(b.place());
            let mut before = None;
            spend(2 * EDGE * chain.len())?;
            for &point in chain {
                let height = low + (high - low) * (a.place().distance(point.place()) / length);
                let here = graph.vertex(&mut numbers, point, height);
                if let Some(before) = before.replace(here).filter(|&before| before != here) {
                    let key = [here.min(before), here.max(before)];
                    if known.insert(key) {
                        let number = graph.edges.len() as u32;
                        graph.edges.push(StreetEdge { ends: [before, here], line: segment.line });
                        graph.around[before as usize].push(number);
                        graph.around[here as usize].push(number);
                    }
                }
            }
        }
        Ok(graph)
    }

    fn vertex(&mut self, numbers: &mut GridMap<Point, u32>, point: Point, height: f64) -> u32 {
        *numbers.entry(point).or_insert_with(|| {
            self.points.push(point.place().extend(height));
            self.around.push(Vec::new());
            self.points.len() as u32 - 1
        })
    }

    /// The edges with short ones contracted. No vertex moves farther than `snap`.
    fn contracted(&self, snap: f64) -> Result<Vec<LineSegment>, StreetError> {
        let mut to: Vec<u32> = (0..self.points.len() as u32).collect();
        let find = |to: &[u32], mut at: u32| {
            while to[at as usize] != at {
                at = to[at as usize];
            }
            at
        };
        let distance = |ends: [u32; 2]| {
            let [a, b] = ends.each(|end| self.points[end as usize].truncate());
            a.distance(b)
        };
        let length = |edge: &StreetEdge| distance(edge.ends);
        let mut short: Vec<&StreetEdge> = self.edges.iter().filter(|edge| length(edge) < snap).collect();
        short.small_sort_by(|a, b| length(a).total_cmp(&length(b)));
        for edge in short {
            spend(EDGE)?;
            let [a, b] = edge.ends.each(|end| find(&to, end));
            if a != b && distance([a, b]) < snap {
                // Junctions and ends stay in place; bends move.
                let rank = |at: u32| match self.around[at as usize].len() {
                    2 => 0,
                    1 => 1,
                    more => more,
                };
                let (kept, other) = if rank(a) < rank(b) { (b, a) } else { (a, b) };
                to[other as usize] = kept;
            }
        }
        let end = |at: u32| {
            let at = find(&to, at) as usize;
            (Point::near(self.points[at].truncate()), self.points[at].z)
        };
        let moved = self.edges.iter().map(|edge| LineSegment { ends: edge.ends.each(end), line: edge.line });
        Ok(moved.filter(|segment| segment.ends[0].0 != segment.ends[1].0).collect())
    }
}

/// The points of a line on the grid, without repetitions.
fn path(line: &Centerline) -> Vec<LinePoint> {
    let point = |&[x, y, z]: &[f64; 3]| (Point::near(DVec2::new(x, -z)), y + 0.0);
    let mut path: Vec<LinePoint> = line.points.iter().map(point).collect();
    path.dedup_by_key(|vertex| vertex.0);
    if path.len() < 2 {
        path.clear();
    }
    path
}

/// Moves an end that is near an earlier end onto it.
fn join_ends(paths: &mut [Vec<LinePoint>], snap: f64) -> Result<(), StreetError> {
    let cell = |place: DVec2| ((place.x / snap).floor() as i64, (place.y / snap).floor() as i64);
    let mut kept: GridMap<(i64, i64), Vec<LinePoint>> = GridMap::default();
    for path in paths.iter_mut() {
        let last = path.len().saturating_sub(1);
        if last == 0 {
            continue;
        }
        for at in [0, last] {
            spend(8 * EDGE)?;
            let place = path[at].0.place();
            let (x, y) = cell(place);
            let near = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy)));
            let near = near.flat_map(|cell| kept.get(&cell).into_iter().flatten());
            let distance = |vertex: &LinePoint| vertex.0.place().distance(place);
            let nearest = near.filter(|vertex| distance(vertex) <= snap);
            let nearest = nearest.min_by(|a, b| distance(a).total_cmp(&distance(b)).then(a.0.cmp(&b.0))).copied();
            match nearest {
                Some(vertex) => path[at] = vertex,
                None => kept.entry((x, y)).or_default().push(path[at]),
            }
        }
    }
    Ok(())
}

/// Moves ends that are not shared onto the nearest segment of another line, if one is near.
fn reach_segments(paths: &mut [Vec<LinePoint>], snap: f64) -> Result<(), StreetError> {
    let mut ends: GridMap<Point, u32> = GridMap::default();
    let (mut segments, mut homes) = (Vec::new(), Vec::new());
    for (line, path) in paths.iter().enumerate() {
        spend(EDGE * path.len())?;
        for vertex in path.first().into_iter().chain(path.last()) {
            *ends.entry(vertex.0).or_default() += 1;
        }
        for (at, ends) in path.windows(2).enumerate() {
            segments.push([ends[0].0, ends[1].0]);
            homes.push((line, at));
        }
    }
    let tree = SegmentTree::of(segments.iter().copied());
    let margin = (snap / super::grid::UNIT) as i64 + 1;
    let mut added: BTreeMap<(usize, usize), Vec<LinePoint>> = BTreeMap::new();
    for line in 0..paths.len() {
        let last = paths[line].len().saturating_sub(1);
        if last == 0 {
            continue;
        }
        for at in [0, last] {
            let end = paths[line][at].0;
            if 1 < ends.get(&end).copied().unwrap_or_default() {
                continue;
            }
            let place = end.place();
            let mut best: Option<(f64, u32)> = None;
            let near = tree.near([end, end], margin, |number| {
                let (other, _) = homes[number as usize];
                let distance = nearest_on(segments[number as usize], place).distance(place);
                let better = best.is_none_or(|(least, first)| (distance, number) < (least, first));
                if other != line && distance <= snap && better {
                    best = Some((distance, number));
                }
            });
            spend(EDGE + near)?;
            let Some((_, number)) = best else { continue };
            let (segment, home) = (segments[number as usize], homes[number as usize]);
            let foot = nearest_on(segment, place);
            let [low, high] = [0, 1].each(|end| paths[home.0][home.1 + end].1);
            let near_end = |end: Point| {
                end.place().distance(foot) < snap.min(0.25 * segment[0].place().distance(segment[1].place()))
            };
            let new = match () {
                () if near_end(segment[0]) => (segment[0], low),
                () if near_end(segment[1]) => (segment[1], high),
                () => {
                    let [a, b] = segment.each(Point::place);
                    let new = (Point::near(foot), low + (high - low) * (a.distance(foot) / a.distance(b)));
                    added.entry(home).or_default().push(new);
                    new
                }
            };
            paths[line][at] = new;
        }
    }
    // From the last segment to the first, so that the numbers of earlier segments stay valid.
    for ((line, at), mut new) in added.into_iter().rev() {
        let from = paths[line][at].0.place();
        new.small_sort_by(|a, b| a.0.place().distance(from).total_cmp(&b.0.place().distance(from)));
        paths[line].splice(at + 1..at + 1, new);
    }
    for path in paths {
        path.dedup_by_key(|vertex| vertex.0);
    }
    Ok(())
}

fn nearest_on(segment: [Point; 2], place: DVec2) -> DVec2 {
    let [a, b] = segment.each(Point::place);
    let part = ((place - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    a + (b - a) * part
}
