//! Repeating a template: its leaves go to the sink, its holes are called.

use std::cell::Cell;

use glam::DVec3;

use super::{Body, Hole, INHERITED, Mark, Placed, Record, Row, Segment, Template, Turned};
use crate::derive::{Cx, ResumeFn, RuleFn};
use crate::env::LeafTables;
use crate::seed::Seed;
use crate::shape::ShapeRef;
use crate::shape::axes::Axes;
use crate::shape::base::Form;
use crate::sink::{Filled, Flow, Sink};

/// Leaves of a part that repeats, at one of its places. All of them fill their scopes.
#[derive(Clone, Copy, Debug)]
pub struct Replay<'a> {
    part: &'a ShapeRef<'a>,
    tables: &'a LeafTables,
    body: &'a Body,
    turned: &'a Turned,
    segment: &'a Segment,
}

impl<'a> Replay<'a> {
    /// The number of leaves.
    pub fn leaf_count(&self) -> usize {
        self.segment.leaves.len()
    }

    /// The number of vertices when faces share none.
    pub fn corner_count(&self) -> usize {
        self.segment.corners
    }

    /// Hands the leaves one by one to [`Sink::filled`].
    #[inline]
    pub fn each<S: Sink + ?Sized>(&self, sink: &mut S) -> Flow {
        let range = self.segment.leaves.clone();
        for (record, placed) in self.body.leaves[range.clone()].iter().zip(&self.turned.leaves[range]) {
            let shape = ShapeRef {
                origin: self.part.origin + placed.origin,
                size: record.size,
                axes: &self.turned.axes[record.frame as usize],
                unit: record.unit,
                form: record.form,
                material: Cell::new(record.material),
                ..self.part.clone()
            };
            sink.filled(&Filled { shape: &shape, tables: self.tables, rule: record.rule })?;
        }
        Flow::Continue(())
    }

    /// True if all leaves are boxes or rectangles across z.
    pub(crate) fn is_plain(&self) -> bool {
        self.segment.is_plain
    }

    /// The numbers of the template and of the segment: parts with equal numbers differ only in their place and their axes, and
    /// where a material has no number in that.
    pub(crate) fn number(&self) -> (u64, usize) {
        (self.body.number, self.segment.leaves.start)
    }

    /// The leaves after each other with equal rule and material.
    pub(crate) fn marks(&self) -> &'a [Mark] {
        &self.body.marks[self.segment.marks.clone()]
    }

    /// A leaf with the rule of a mark. Its shape is the whole part.
    pub(crate) fn leaf_of(&self, mark: Mark) -> Filled<'a> {
        Filled { shape: self.part, tables: self.tables, rule: mark.rule }
    }

    /// The leaves in rows: boxes or rectangles, their axes, their places and their records.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&'a Row, &'a Axes, &'a [Placed], &'a [Record])> {
        let Replay { body, turned, segment, .. } = *self;
        body.rows[segment.rows.clone()].iter().map(move |row| {
            let axes = &turned.axes[row.frame as usize];
            (row, axes, &turned.leaves[row.leaves.clone()], &body.leaves[row.leaves.clone()])
        })
    }

    /// The place of the repetition.
    #[inline]
    pub(crate) fn origin(&self) -> DVec3 {
        self.part.origin
    }
}

impl<C: Clone> Cx<'_, C> {
    /// Runs a rigid rule on a part that repeats: from its template, which is made first if there is none yet.
    #[inline]
    pub fn repeat<G>(
        &mut self,
        place: u32,
        g: &G,
        part: &ShapeRef<'_>,
        rule: RuleFn<G, C>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        let is_filled = matches!(part.form, Form::Rect(_) | Form::Box);
        if self.tape.is_some() || !is_filled || !std::ptr::eq(part.axes, part.base.axes()) {
            return rule(g, self, part);
        }
        let turned = match self.templates.find(place, part, self.env.too_small) {
            Some(entry) => entry.turned(part.axes),
            None => self.prepare(place, g, part, rule),
        };
        match turned {
            None => rule(g, self, part),
            Some((template, turned)) => self.replay(&template, &turned, g, part, resume),
        }
    }

    #[inline(never)]
    fn replay<G>(
        &mut self,
        template: &Template<C>,
        turned: &Turned,
        g: &G,
        part: &ShapeRef<'_>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        let body = &template.body;
        let count = template.shapes + body.leaves.len() as u64;
        if !self.env.has_room(count) {
            self.env.make_room(count)?;
        }
        self.env.shapes += template.shapes;
        let mut holes = template.holes.iter().zip(&turned.holes);
        for segment in &body.segments {
            if !segment.leaves.is_empty() {
                self.env.filled += segment.leaves.len() as u64;
                self.sink.replay(&Replay { part, tables: &self.env.leaf_tables, body, turned, segment })?;
            }
            if let Some((hole, offset)) = holes.next() {
                self.fill(hole, part.origin + *offset, g, part, resume)?;
            }
        }
        Flow::Continue(())
    }

    /// Calls the rule of a hole.
    fn fill<G>(&mut self, hole: &Hole<C>, origin: DVec3, g: &G, part: &ShapeRef<'_>, resume: ResumeFn<G, C>) -> Flow {
        let [factor, sum] = hole.seed;
        let shape = ShapeRef {
            origin,
            size: hole.size,
            axes: if hole.is_raised { part.base.raised() } else { part.axes },
            unit: hole.unit,
            form: hole.form,
            material: Cell::new(hole.material),
            seed: Cell::new(Seed::new(part.seed.get().value().wrapping_mul(factor).wrapping_add(sum))),
            split: if hole.split == INHERITED { part.split } else { hole.split },
            base: part.base,
        };
        let trail = self.env.trail_len();
        self.env.extend_trail(&hole.trail);
        let flow = if hole.stack == 0 {
            resume(g, self, &shape, hole.call.clone())
        } else if self.descend(hole.levels, hole.stack) {
            let flow = resume(g, self, &shape, hole.call.clone());
            self.ascend(hole.levels, hole.stack);
            flow
        } else {
            self.defer(&shape, hole.levels, hole.call.clone())
        };
        self.env.cut_trail(trail);
        flow
    }
}
