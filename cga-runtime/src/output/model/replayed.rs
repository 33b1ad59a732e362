//! Passing the leaves of a model to a sink, as a run does.

use std::cell::Cell;
use std::sync::Arc;

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
        let (mut leaves, mut run) = (self.leaves(), ReplayedRun::of(self));
        for (building, own) in &self.buildings {
            let before = leaves.len() + own.start - self.len();
            leaves.by_ref().take(before).try_for_each(|leaf| run.pass(&leaf, sink))?;
            sink.begin_building(&building.name, building.seed);
            let flow = leaves.by_ref().take(own.len()).try_for_each(|leaf| run.pass(&leaf, sink));
            sink.end_building(&|| building.clone());
            flow?;
        }
        leaves.try_for_each(|leaf| run.pass(&leaf, sink))
    }
}

/// A run that makes the leaves of a model. Its numbers of rules are the numbers of the model.
struct ReplayedRun {
    tables: LeafTables,
    /// The looks of the materials, by number.
    looks: Vec<LookId>,
    base: Base,
    /// The axes of the last leaf.
    axes: Axes,
}

impl ReplayedRun {
    fn of(model: &Model) -> Self {
        let mut tables = LeafTables { names: model.rules().into(), ..LeafTables::default() };
        let look = |material: &Arc<_>| {
            let look = Look { material: Arc::clone(material), ..Look::default() };
            tables.looks.number(&Arc::new(look))
        };
        let looks = model.materials().iter().map(look).collect();
        let base = Base::new(Shape::cuboid(1.0, 1.0, 1.0), LookId::OF_BASE);
        ReplayedRun { tables, looks, axes: *base.axes(), base }
    }

    /// Passes a leaf on. One that fills its scope gets the numbers of its rule and its material, so that a sink need not look them up.
    #[inline]
    fn pass<S: Sink + ?Sized>(&mut self, leaf: &LeafView<'_>, sink: &mut S) -> Flow {
        let (form, unit) = match leaf.record.stored {
            Stored::Rect(axis, unit) => (Form::Rect(axis), unit),
            Stored::Full(unit) => (Form::Box, unit),
            Stored::Other(_) | Stored::Placement => return leaf.replay(sink),
        };
        let (scope, look) = (&leaf.record.scope, self.looks[leaf.material_index()]);
        let is_plain = 0.0 <= scope.size.min_element() && leaf.uvs().is_empty();
        if !is_plain || look == LookId::OF_BASE {
            return leaf.replay(sink);
        }
        if !self.axes.is(&scope.axes) {
            self.axes = Axes::new(scope.axes);
        }
        let shape = ShapeRef {
            origin: Cell::new(four(scope.origin)),
            size: scope.size.into(),
            axes: &self.axes,
            base: &self.base,
            unit: Cell::new(unit),
            seed: Cell::new(self.base.shape.seed),
            split: Cell::new(Counter::NONE),
            form,
            look: Cell::new(look),
        };
        sink.filled(&Filled { shape: &shape, tables: &self.tables, rule: leaf.record.rule })
    }
}
