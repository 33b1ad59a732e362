//! Traces: the origin of points, for recomposition.
//!
//! While an operation that recomposes derives its operand, the points of all shapes have numbers. Points with the same number
//! are one point of the result, wherever rules have moved them. A point without a number has no origin.

use crate::each::Each;
use std::collections::HashMap;

use glam::DVec3;

/// The number of a point without an origin.
pub const UNTRACED: u32 = u32::MAX;

/// The origin of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TracedPoint {
    /// The number of the point, or [`UNTRACED`].
    pub id: u32,
    /// The place of the point in the world when the part was made.
    pub begin: DVec3,
}

impl TracedPoint {
    /// A point without an origin.
    pub const NONE: TracedPoint = TracedPoint { id: UNTRACED, begin: DVec3::ZERO };
}

/// The origins of all points of a mesh or a wire, for one operand.
#[derive(Clone, Debug, Default)]
pub struct TraceLayer {
    /// The division that made the part.
    pub division: u32,
    /// One for each point.
    pub points: Vec<TracedPoint>,
}

/// The origins for all operands that are being derived, the outermost first. Empty outside of operands.
#[derive(Clone, Debug, Default)]
pub struct Trace(Option<Box<TraceLayers>>);

#[derive(Clone, Debug, Default)]
struct TraceLayers {
    list: Vec<TraceLayer>,
    /// True if the part was removed.
    is_gone: bool,
}

impl Trace {
    /// A trace with these layers.
    pub fn of(list: Vec<TraceLayer>) -> Self {
        Trace((!list.is_empty()).then(|| Box::new(TraceLayers { list, is_gone: false })))
    }

    /// Returns true outside of operands.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// The layers, the outermost operand first.
    pub fn layers(&self) -> &[TraceLayer] {
        self.0.as_ref().map_or(&[], |layers| &layers.list)
    }

    /// The layers, for changes.
    pub fn layers_mut(&mut self) -> &mut [TraceLayer] {
        self.0.as_mut().map_or(&mut [], |layers| &mut layers.list)
    }

    /// The trace of points that are points of this one, or new ones.
    pub fn pick(&self, points: &mut dyn Iterator<Item = Option<u32>>) -> Trace {
        if self.is_empty() {
            return Trace::default();
        }
        let points: Vec<Option<u32>> = points.collect();
        let layer = |layer: &TraceLayer| TraceLayer {
            division: layer.division,
            points: points
                .iter()
                .map(|point| {
                    point.and_then(|point| layer.points.get(point as usize)).copied().unwrap_or(TracedPoint::NONE)
                })
                .collect(),
        };
        Trace::of(self.layers().iter().map(layer).collect())
    }

    /// The trace of points that are at the same places as some of the points with this one, the first ones there.
    pub fn at_places(&self, points: &[DVec3], places: &[DVec3]) -> Trace {
        if self.is_empty() {
            return Trace::default();
        }
        let key = |place: &DVec3| (*place + 0.0).to_array().each(f64::to_bits);
        let mut first = HashMap::new();
        for (number, point) in (0..).zip(points) {
            first.entry(key(point)).or_insert(number);
        }
        let found: Vec<Option<u32>> = places.iter().map(|place| first.get(&key(place)).copied()).collect();
        self.pick(&mut found.into_iter())
    }

    /// The trace with exactly `depth` layers of `points` points each. Missing ones have no origin.
    pub fn filled(mut self, depth: usize, points: usize) -> Trace {
        let mut list = self.0.take().map_or_else(Vec::new, |layers| layers.list);
        list.iter_mut().filter(|layer| layer.points.len() != points).for_each(|layer| layer.points.clear());
        list.resize_with(depth, TraceLayer::default);
        list.iter_mut().for_each(|layer| layer.points.resize(points, TracedPoint::NONE));
        Trace::of(list)
    }

    /// Adds the origins of other points behind these, which have `count` points. Layers that one of them lacks are dropped.
    pub(crate) fn append(&mut self, count: usize, other: &Trace) {
        let depth = if count == 0 { other.layers().len() } else { self.layers().len().min(other.layers().len()) };
        let mut list = std::mem::take(self).filled(depth, count).0.map_or_else(Vec::new, |layers| layers.list);
        for (own, other) in list.iter_mut().zip(other.layers()) {
            own.points.extend_from_slice(&other.points);
            own.division = own.division.max(other.division);
        }
        *self = Trace::of(list);
    }

    /// Drops the layers of operands that have ended.
    pub fn cut_to(&mut self, depth: usize) {
        if let Some(layers) = &mut self.0 {
            layers.list.truncate(depth);
            if depth == 0 && !layers.is_gone {
                self.0 = None;
            }
        }
    }

    /// Marks the part as removed.
    pub fn remove(&mut self) {
        if let Some(layers) = &mut self.0 {
            layers.is_gone = true;
        }
    }

    /// Returns true if the part was removed.
    pub fn is_gone(&self) -> bool {
        self.0.as_ref().is_some_and(|layers| layers.is_gone)
    }
}
