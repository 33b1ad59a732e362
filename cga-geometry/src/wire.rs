//! Edges and points without faces.

use std::collections::HashMap;

use glam::DVec3;

use crate::Frame;
use crate::each::Each;
use crate::mesh::{SubcomponentTags, unit};
use crate::origin::PointOrigin;
use crate::trace::Trace;

/// Edges between points, or points without edges.
///
/// The fields are public, so the caller keeps them consistent: edges have indices of points, and there is one normal for each
/// edge, or for each point if there are no edges. Methods panic if an edge ends at a point that does not exist.
#[derive(Clone, Debug, Default)]
pub struct Wire {
    /// The points.
    pub points: Vec<DVec3>,
    /// The two points of each edge.
    pub edges: Vec<[u32; 2]>,
    /// The normal of each edge, or of each point if there are no edges: of length 1, or zero if unknown.
    pub normals: Vec<DVec3>,
    /// The tags of edges and points.
    pub tags: SubcomponentTags,
    /// The origins of points, in operands.
    pub trace: Trace,
}

impl Wire {
    /// A line along x from the origin, of a length in metres, with its normal along z.
    pub fn edge(length: f64) -> Self {
        Wire {
            points: vec![DVec3::ZERO, DVec3::X * length],
            edges: vec![[0, 1]],
            normals: vec![DVec3::Z],
            ..Wire::default()
        }
    }

    /// A point at the origin, with its normal along z.
    pub fn point() -> Self {
        Wire { points: vec![DVec3::ZERO], normals: vec![DVec3::Z], ..Wire::default() }
    }

    /// The wire of some edges between `points` with tags and a trace, with the points that they use. `normals` has one normal for
    /// each edge.
    ///
    /// # Panics
    /// Panics if an edge has a point that does not exist.
    pub fn of_edges(
        points: &[DVec3],
        tags: &SubcomponentTags,
        trace: &Trace,
        edges: &mut dyn Iterator<Item = [u32; 2]>,
        normals: Vec<DVec3>,
    ) -> Self {
        let (mut used, mut numbers) = (Vec::new(), HashMap::new());
        let mut number = |point: u32| {
            *numbers.entry(point).or_insert_with(|| {
                used.push(point);
                used.len() as u32 - 1
            })
        };
        let edges: Vec<[u32; 2]> = edges.map(|edge| edge.each(&mut number)).collect();
        let trace = trace.pick(&mut used.iter().map(|point| Some(*point)));
        let tags =
            tags.carried(&mut edges.iter().copied(), used.len(), &|point| PointOrigin::Old(used[point as usize]));
        Wire { points: used.iter().map(|point| points[*point as usize]).collect(), edges, normals, tags, trace }
    }

    /// The wire of some points with tags and a trace, without edges. `numbers` are the numbers of the points there, and `normals`
    /// their normals.
    ///
    /// # Panics
    /// Panics if `points` and `numbers` have different lengths.
    pub fn of_points(
        points: Vec<DVec3>,
        tags: &SubcomponentTags,
        trace: &Trace,
        numbers: &[u32],
        normals: Vec<DVec3>,
    ) -> Self {
        assert_eq!(points.len(), numbers.len(), "one number for each point");
        let tags =
            tags.carried(&mut std::iter::empty(), numbers.len(), &|point| PointOrigin::Old(numbers[point as usize]));
        let trace = trace.pick(&mut numbers.iter().map(|point| Some(*point)));
        Wire { points, edges: Vec::new(), normals, tags, trace }
    }

    /// Returns true if points and edges have no tags and no origins.
    pub fn is_plain(&self) -> bool {
        self.tags.is_empty() && self.trace.is_empty()
    }

    /// The wire in the coordinates of a frame.
    pub fn seen_from(mut self, frame: &Frame) -> Self {
        let turn = frame.axes.transpose();
        self.points.iter_mut().for_each(|point| *point = frame.to_local(*point));
        self.normals.iter_mut().for_each(|normal| *normal = turn * *normal);
        self
    }

    /// The wire stretched along the axes and then moved. Negative factors mirror it.
    pub fn stretched(&self, stretch: DVec3, by: DVec3) -> Self {
        let mut moved = self.clone();
        moved.points.iter_mut().for_each(|point| *point = *point * stretch + by);
        // The inverse factors keep normals perpendicular.
        let squeeze = DVec3::select(stretch.cmpeq(DVec3::ZERO), DVec3::ONE, stretch.recip());
        moved.normals.iter_mut().for_each(|normal| *normal = unit(*normal * squeeze));
        moved
    }

    /// The part between two offsets along a direction, with edges cut off there. Edges and points exactly at an offset
    /// are below it. Points that edges share are shared in the part too.
    /// Parts of edges keep their tags. The part has no trace, but comes with the origins of its points. It is empty unless
    /// `low` is at most `high`.
    pub fn between(&self, along: DVec3, low: f64, high: f64) -> (Wire, Vec<PointOrigin>) {
        let (mut part, mut origins) = (Wire::default(), Vec::new());
        if low.partial_cmp(&high).is_none_or(std::cmp::Ordering::is_gt) {
            return (part, origins);
        }
        let mut numbers = HashMap::new();
        for (edge, &normal) in (0..self.edges.len()).zip(&self.normals) {
            let [a, b] = self.ends(edge);
            let (from, to) = (a.dot(along), b.dot(along));
            if from.max(to) <= low || high < from.min(to) || (high == from.min(to) && from != to) {
                continue;
            }
            let [first, last] = self.edges[edge];
            // Edges between the same points are cut at one point, in both directions.
            let (min, max) = (first.min(last), first.max(last));
            let [start, end] = [min, max].each(|point| self.points[point as usize]);
            let own = start.dot(along);
            let mut number = |point: u32, place: f64| {
                let inside = place.clamp(low, high);
                let share = |at: f64| (at - own) / (end.dot(along) - own);
                let (key, share) = match inside == place {
                    true => (CutEnd::Point(point), None),
                    false if inside == low => (CutEnd::Low(min, max), Some(share(low))),
                    false => (CutEnd::High(min, max), Some(share(high))),
                };
                *numbers.entry(key).or_insert_with(|| {
                    let found = share.map_or(self.points[point as usize], |share| start + (end - start) * share);
                    let old = PointOrigin::Old(point);
                    origins.push(share.map_or(old, |share| PointOrigin::Between { ends: [min, max], share }));
                    part.points.push(found);
                    part.points.len() as u32 - 1
                })
            };
            let cut = [number(first, from), number(last, to)];
            part.edges.push(cut);
            part.normals.push(normal);
        }
        if self.edges.is_empty() {
            for ((number, &point), &normal) in (0..).zip(&self.points).zip(&self.normals) {
                if low < point.dot(along) && point.dot(along) <= high {
                    part.points.push(point);
                    part.normals.push(normal);
                    origins.push(PointOrigin::Old(number));
                }
            }
        }
        part.tags = self.tags.carried(&mut part.edges.iter().copied(), origins.len(), &|point| origins[point as usize]);
        (part, origins)
    }

    /// The positions of the start and the end of an edge.
    ///
    /// # Panics
    /// Panics if the edge or one of its points does not exist.
    pub fn ends(&self, edge: usize) -> [DVec3; 2] {
        self.edges[edge].each(|point| self.points[point as usize])
    }
}

/// An end of an edge of a part: a point of the wire, or the cut of the edge between two points.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum CutEnd {
    Point(u32),
    Low(u32, u32),
    High(u32, u32),
}
