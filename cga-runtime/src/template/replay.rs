//! Repeating a template: its leaves go to the sink, its holes are called.

use std::ops::Range;

use glam::DVec3;

use super::{INHERITED, Mark, Placed, Record, Template, Turned};
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
    axes: &'a [Axes],
    records: &'a [Record],
    placed: &'a [Placed],
    marks: &'a [Mark],
    corners: usize,
    is_plain: bool,
}

impl<'a> Replay<'a> {
    fn new<C>(
        template: &'a Template<C>,
        turned: &'a Turned<C>,
        segment: usize,
        part: &'a ShapeRef<'a>,
        tables: &'a LeafTables,
    ) -> Self {
        let segment = &template.segments[segment];
        Replay {
            part,
            tables,
            axes: &turned.axes,
            records: &template.leaves[segment.leaves.clone()],
            placed: &turned.leaves[segment.leaves.clone()],
            marks: &template.marks[segment.marks.clone()],
            corners: segment.corners,
            is_plain: segment.is_plain,
        }
    }

    /// The number of leaves.
    pub fn leaf_count(&self) -> usize {
        self.records.len()
    }

    /// The number of vertices when faces share none.
    pub fn corner_count(&self) -> usize {
        self.corners
    }

    /// Hands the leaves one by one to [`Sink::filled`].
    #[inline]
    pub fn each<S: Sink + ?Sized>(&self, sink: &mut S) -> Flow {
        for (record, placed) in self.records.iter().zip(self.placed) {
            let shape = ShapeRef {
                origin: self.part.origin + placed.origin,
                size: record.size,
                axes: &self.axes[record.frame as usize],
                unit: record.unit,
                form: record.form,
                material: record.material,
                ..*self.part
            };
            sink.filled(&Filled { shape: &shape, tables: self.tables, rule: record.rule })?;
        }
        Flow::Continue(())
    }

    /// True if all leaves are boxes or rectangles across z.
    pub(crate) fn is_plain(&self) -> bool {
        self.is_plain
    }

    /// The leaves after each other with equal rule and material, each with its first leaf.
    pub(crate) fn marks(&self) -> impl Iterator<Item = (Filled<'a>, Mark)> {
        let Replay { part, tables, .. } = *self;
        self.marks.iter().map(move |mark| (Filled { shape: part, tables, rule: mark.rule }, *mark))
    }

    /// A stretch of leaves: their places, and the normals and units of their boxes.
    #[inline]
    pub(crate) fn leaves(&self, range: Range<usize>) -> impl Iterator<Item = (&'a Placed, &'a Record, &'a Axes)> {
        let axes = self.axes;
        let records = &self.records[range.clone()];
        self.placed[range]
            .iter()
            .zip(records)
            .map(move |(placed, record)| (placed, record, &axes[record.frame as usize]))
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
        part: &mut ShapeRef<'_>,
        rule: RuleFn<G, C>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        let is_filled = matches!(part.form, Form::Rect(_) | Form::Box);
        if self.tape.is_some() || !is_filled || !std::ptr::eq(part.axes, part.base.axes()) {
            return rule(g, self, part);
        }
        let turned = match self.templates.find(place, part, self.env.too_small) {
            None => self.prepare(place, g, part, rule),
            Some(entry) => {
                if let Some(turned) = &mut entry.turned
                    && turned.base != part.base.number
                {
                    *turned = turned.template.turned(part.base.number, part.axes).into();
                }
                entry.turned.clone()
            }
        };
        match turned {
            None => rule(g, self, part),
            Some(turned) => {
                if !self.env.has_room(turned.template.room) {
                    return self.replay_at_checkpoint(&turned, g, part, rule, resume);
                }
                self.replay(&turned, g, part, resume)
            }
        }
    }

    /// Replays a template that passes the checkpoint. Where it passes the limit, the rule runs directly: it ends at the same
    /// shape whether a template is there or not.
    #[cold]
    #[inline(never)]
    fn replay_at_checkpoint<G>(
        &mut self,
        turned: &Turned<C>,
        g: &G,
        part: &mut ShapeRef<'_>,
        rule: RuleFn<G, C>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        let room = turned.template.room;
        if !self.env.is_within_limit(room) {
            return rule(g, self, part);
        }
        self.env.make_room(room)?;
        self.replay(turned, g, part, resume)
    }

    #[inline(never)]
    fn replay<G>(&mut self, turned: &Turned<C>, g: &G, part: &ShapeRef<'_>, resume: ResumeFn<G, C>) -> Flow {
        let template = &*turned.template;
        self.env.shapes += template.shapes;
        for (segment, leaves) in template.segments.iter().enumerate() {
            if !leaves.leaves.is_empty() {
                self.env.filled += leaves.leaves.len() as u64;
                let replay = Replay::new(template, turned, segment, part, &self.env.leaf_tables);
                self.sink.replay(&replay)?;
            }
            if segment < template.holes.len() {
                self.fill(turned, segment, g, part, resume)?;
            }
        }
        Flow::Continue(())
    }

    /// Calls the rule of a hole.
    fn fill<G>(
        &mut self,
        turned: &Turned<C>,
        number: usize,
        g: &G,
        part: &ShapeRef<'_>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        let hole = &turned.template.holes[number];
        let [factor, sum] = hole.seed;
        let mut shape = ShapeRef {
            origin: part.origin + turned.holes[number],
            size: hole.size,
            axes: if hole.is_raised { part.base.raised() } else { part.axes },
            unit: hole.unit,
            form: hole.form,
            material: hole.material,
            seed: Seed::new(part.seed.value().wrapping_mul(factor).wrapping_add(sum)),
            split: if hole.split == INHERITED { part.split } else { hole.split },
            ..*part
        };
        let trail = self.env.trail_len();
        self.env.extend_trail(&hole.trail);
        let flow = if hole.stack == 0 {
            resume(g, self, &mut shape, hole.call.clone())
        } else if self.descend(hole.levels, hole.stack) {
            let flow = resume(g, self, &mut shape, hole.call.clone());
            self.ascend(hole.levels, hole.stack);
            flow
        } else {
            self.defer(&shape, hole.levels, hole.call.clone())
        };
        self.env.cut_trail(trail);
        flow
    }
}
