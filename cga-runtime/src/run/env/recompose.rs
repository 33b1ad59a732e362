//! The connectivity of the shapes of an operand that will be recomposed (*Shape recomposition*).

use std::sync::Arc;

use super::Env;
use crate::geometry::each::Each;
use crate::geometry::mesh::Mesh;
use crate::geometry::origin::PointOrigin;
use crate::geometry::recompose::Origins;
use crate::geometry::trace::{Trace, TraceLayer, TracedPoint, UNTRACED};
use crate::shape::base::Base;
use crate::shape::{Shape, ShapeRef};

/// The operands that are being derived for recomposition, the outermost first.
#[derive(Debug, Default)]
pub(crate) struct Recompositions {
    list: Vec<Origins>,
    /// The setting of the run outside of them.
    as_meshes: bool,
}

impl Recompositions {
    /// Returns true outside of such operands.
    #[inline]
    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }
}

impl Env {
    /// Begins an operand that is recomposed: a copy of the current shape, whose points have numbers from now on.
    /// [`Env::end_recomposition`] ends it.
    pub fn begin_recomposition(&mut self, shape: &ShapeRef<'_>) -> Base {
        let mut whole = self.whole(shape);
        if self.recompositions.is_empty() {
            self.recompositions.as_meshes = self.initial.as_meshes;
            self.initial.as_meshes = true;
        }
        // For operands around this one, the result is a part of the shape.
        self.divide_trace(&mut whole);
        self.begin_part(&mut whole);
        self.recompositions.list.push(Origins::new());
        self.number_points(&mut whole);
        self.begin_part(&mut whole);
        self.base(whole)
    }

    /// Ends the innermost operand.
    pub(crate) fn end_recomposition(&mut self) -> Origins {
        let origins = self.recompositions.list.pop().unwrap_or_default();
        if self.recompositions.is_empty() {
            self.initial.as_meshes = self.recompositions.as_meshes;
        }
        origins
    }

    /// The number of operands around the current shape.
    pub(crate) fn recomposed_depth(&self) -> usize {
        self.recompositions.list.len()
    }

    /// Begins a division of a shape: its movements so far are the movements of one part. Parts with this trace belong to the division.
    pub(crate) fn divide_trace(&mut self, shape: &mut Shape) {
        if self.recompositions.is_empty() {
            return;
        }
        self.number_points(shape);
        let Some(origins) = self.recompositions.list.last_mut() else { return };
        let places = shape.world_points();
        shape.change_trace(|trace| {
            let Some(layer) = trace.layers_mut().last_mut() else { return };
            for (point, place) in layer.points.iter().zip(&places) {
                origins.moved(point.id, layer.division, *place - point.begin);
            }
            layer.division = origins.divide(layer.division);
        });
    }

    /// Runs a division whose parts have no origins: the movements of the shape so far count, and recomposition appends the
    /// parts.
    pub(crate) fn without_origins<T>(&mut self, mut whole: Shape, divide: impl FnOnce(&mut Env, Shape) -> T) -> T {
        self.divide_trace(&mut whole);
        whole.change_trace(|trace| *trace = Trace::default());
        let origins = std::mem::take(&mut self.recompositions.list);
        let made = divide(self, whole);
        self.recompositions.list = origins;
        made
    }

    /// Begins a part of a division: it has not moved yet.
    pub(crate) fn begin_part(&mut self, part: &mut Shape) {
        if self.recompositions.is_empty() || part.trace().is_none_or(Trace::is_empty) {
            return;
        }
        let places = part.world_points();
        part.change_trace(|trace| {
            let Some(layer) = trace.layers_mut().last_mut() else { return };
            layer.points.iter_mut().zip(&places).for_each(|(point, place)| point.begin = *place);
        });
    }

    /// The movements and points of a leaf. Returns the numbers of its points.
    pub(crate) fn end_trace(&mut self, leaf: &mut Shape) -> Vec<u32> {
        self.number_points(leaf);
        let Some(origins) = self.recompositions.list.last_mut() else { return Vec::new() };
        let places = leaf.world_points();
        let Some(layer) = leaf.trace().and_then(|trace| trace.layers().last()) else { return Vec::new() };
        for (point, place) in layer.points.iter().zip(&places) {
            origins.moved(point.id, layer.division, *place - point.begin);
        }
        let points: Vec<u32> = layer.points.iter().map(|point| point.id).collect();
        origins.mark(&points);
        points
    }

    /// Gives numbers to points without one.
    fn number_points(&mut self, shape: &mut Shape) {
        let depth = self.recompositions.list.len();
        let Some(origins) = self.recompositions.list.last_mut() else { return };
        let is_numbered = |trace: &Trace| {
            let layers = trace.layers();
            layers.len() == depth && layers[depth - 1].points.iter().all(|point| point.id != UNTRACED)
        };
        shape.hold_as_points();
        let Some(count) = shape.points().map(<[_]>::len) else { return };
        let is_whole = |trace: &Trace| trace.layers().iter().all(|layer| layer.points.len() == count);
        if shape.trace().is_some_and(|trace| is_numbered(trace) && is_whole(trace)) {
            return;
        }
        let places = shape.world_points();
        shape.change_trace(|trace| {
            *trace = std::mem::take(trace).filled(depth, count);
            let Some(layer) = trace.layers_mut().last_mut() else { return };
            for (point, place) in layer.points.iter_mut().zip(&places).filter(|(point, _)| point.id == UNTRACED) {
                *point = TracedPoint { id: origins.point(*place), begin: *place };
            }
        });
    }

    /// The trace of a part that was cut from a whole.
    pub(crate) fn cut_trace(&mut self, whole: &Trace, points: &[PointOrigin]) -> Trace {
        let mut list = Vec::with_capacity(whole.layers().len());
        for (layer, origins) in whole.layers().iter().zip(&mut self.recompositions.list) {
            let point = |point: &PointOrigin| {
                let of = |end: u32| layer.points.get(end as usize).copied().unwrap_or(TracedPoint::NONE);
                let PointOrigin::Between { ends, share } = *point else {
                    return point.old().map_or(TracedPoint::NONE, of);
                };
                let [a, b] = ends.each(of);
                let id = origins.on_edge([a.id, b.id], share, layer.division);
                TracedPoint { id, begin: a.begin + (b.begin - a.begin) * share }
            };
            let points = points.iter().map(point).collect();
            list.push(TraceLayer { division: layer.division, points });
        }
        Trace::of(list)
    }

    /// The part of a mesh that was cut, with its trace.
    pub(crate) fn with_cut_trace(&mut self, whole: &Mesh, part: &mut Arc<Mesh>, points: &[PointOrigin]) {
        if part.trace().is_empty() && points.len() == part.points().len() {
            let trace = self.cut_trace(whole.trace(), points);
            Arc::make_mut(part).set_trace(trace);
        }
    }
}
