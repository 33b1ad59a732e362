//! Passing the leaves of a model to a sink, as a run does.

use std::cell::Cell;
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use super::leaf_store::ModelLeaf;
use super::leaf_view::LeafView;
use super::{Model, Stored};
use crate::run::sink::corners::four;
use crate::run::sink::{Filled, Flow, LeafTables, Sink};
use crate::shape::axes::Axes;
use crate::shape::base::{Base, Form};
use crate::shape::look::Look;
use crate::shape::look_id::LookId;
use crate::shape::{Counter, Shape, ShapeRef};

impl Model {
    /// Passes every leaf to a sink, in order, until it ends the run. It begins with [`Sink::begin`], like a run.
    pub fn replay<S: Sink + ?Sized>(&self, sink: &mut S) -> Flow {
        sink.begin();
        let (mut done, mut run) = (0, ReplayedRun::of(self));
        for (building, own) in &self.buildings {
            run.pass_all(done..own.start, sink)?;
            sink.begin_building(&building.name, building.seed);
            let flow = run.pass_all(own.clone(), sink);
            sink.end_building(&|| building.clone());
            flow?;
            done = own.end;
        }
        run.pass_all(done..self.len(), sink)
    }
}

/// A run that makes the leaves of a model. Its numbers of rules are the numbers of the model.
struct ReplayedRun<'m> {
    model: &'m Model,
    tables: LeafTables,
    /// The looks of the materials, by number.
    looks: Vec<LookId>,
    base: Base,
    /// The axes of the last leaf.
    axes: Axes,
}

impl<'m> ReplayedRun<'m> {
    fn of(model: &'m Model) -> Self {
        let mut tables = LeafTables { names: model.rules().into(), ..LeafTables::default() };
        let look = |material: &Arc<_>| {
            let look = Look { material: Arc::clone(material), ..Look::default() };
            tables.looks.number(&Arc::new(look))
        };
        let looks = model.materials().iter().map(look).collect();
        let base = Base::new(Shape::cuboid(1.0, 1.0, 1.0), LookId::OF_BASE);
        ReplayedRun { model, tables, looks, axes: *base.axes(), base }
    }

    /// Passes the leaves with numbers in a range on.
    fn pass_all<S: Sink + ?Sized>(&mut self, range: Range<usize>, sink: &mut S) -> Flow {
        self.model.store.runs(range).try_for_each(|run| {
            let mut leaves = (run.first..).zip(run.leaves);
            leaves.try_for_each(|(number, leaf)| self.pass(number, leaf, run.place, sink))
        })
    }

    /// Passes a leaf on. One that fills its scope gets the numbers of its rule and its material, so that a sink need not look them up.
    #[inline]
    fn pass<S: Sink + ?Sized>(&mut self, number: usize, leaf: &ModelLeaf, place: Option<DVec3>, sink: &mut S) -> Flow {
        let view = || LeafView::of(self.model, number, place.map_or(*leaf, |place| leaf.at(place)));
        let (form, unit) = match leaf.stored {
            Stored::Rect(axis, unit) => (Form::Rect(axis), unit),
            Stored::Full(unit) => (Form::Box, unit),
            Stored::Other(_) | Stored::Placement => return view().replay(sink),
        };
        let (scope, look) = (&leaf.scope, self.looks[leaf.material as usize]);
        let is_plain = 0.0 <= scope.size.min_element() && self.model.uvs.of(number).is_empty();
        if !is_plain || look == LookId::OF_BASE {
            return view().replay(sink);
        }
        if !self.axes.is(&scope.axes) {
            self.axes = Axes::new(scope.axes);
        }
        let shape = ShapeRef {
            origin: Cell::new(four(place.map_or(scope.origin, |place| place + scope.origin))),
            size: scope.size.into(),
            axes: &self.axes,
            base: &self.base,
            unit: Cell::new(unit),
            seed: Cell::new(self.base.shape.seed),
            split: Cell::new(Counter::NONE),
            form,
            look: Cell::new(look),
        };
        sink.filled(&Filled { shape: &shape, tables: &self.tables, rule: leaf.rule })
    }
}
