//! Repetitions of a template: its leaves go to the sink, its holes are called.

use std::cell::Cell;
use std::rc::Rc;

use glam::DVec3;

use super::replay::Replay;
use super::{Hole, INHERITED, Template, Turned};
use crate::geometry::Axis;
use crate::run::context::{Cx, ResumeFn, RuleFn};
use crate::run::sink::Flow;
use crate::shape::ShapeRef;
use crate::shape::base::Form;
use crate::shape::seed::Seed;
use crate::shape::unit::UnitMesh;

/// The template of the last repetition of a slot: the next one is often as large, and the parts of a split do not differ in
/// more than their place, one extent and the unit mesh.
pub struct Last<C>(Option<LastTemplate<C>>);

/// The extent and the unit mesh of a repetition, and its template.
type LastTemplate<C> = (f64, UnitMesh, Rc<Template<C>>, Rc<Turned>);

impl<C> Drop for Last<C> {
    /// Compiled once: rules have many of these.
    #[inline(never)]
    fn drop(&mut self) {
        self.0 = None;
    }
}

impl<C> Default for Last<C> {
    fn default() -> Self {
        Last(None)
    }
}

impl<C: Clone> Cx<'_, C> {
    /// Runs a rigid rule on a part that repeats along an axis, from its template, which is made on first use.
    #[inline]
    pub fn repeat<G>(
        &mut self,
        place: u32,
        last: &mut Last<C>,
        g: &G,
        (part, axis): (&ShapeRef<'_>, Axis),
        rule: RuleFn<G, C>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        let (extent, unit) = (part.size.along(axis), part.unit.get());
        match &last.0 {
            Some((known, of, template, turned)) if *known == extent && of.is(unit) => {
                self.replay_within(template, turned, g, part, rule, resume)
            }
            _ => {
                *last = Last(
                    self.template(place, g, part, rule).map(|(template, turned)| (extent, unit, template, turned)),
                );
                match &last.0 {
                    None => rule(g, self, part),
                    Some((_, _, template, turned)) => self.replay_within(template, turned, g, part, rule, resume),
                }
            }
        }
    }

    /// The template for a part.
    #[inline(never)]
    fn template<G>(
        &mut self,
        place: u32,
        g: &G,
        part: &ShapeRef<'_>,
        rule: RuleFn<G, C>,
    ) -> Option<(Rc<Template<C>>, Rc<Turned>)> {
        let is_filled = matches!(part.form, Form::Rect(_) | Form::Box);
        if self.tape.is_some() || !is_filled || !std::ptr::eq(part.axes, part.base.axes()) {
            return None;
        }
        match self.templates.find(place, part, self.env.too_small) {
            Some(entry) => entry.turned(part.axes),
            None => self.prepare(place, g, part, rule),
        }
    }

    #[inline(never)]
    fn replay_within<G>(
        &mut self,
        template: &Template<C>,
        turned: &Turned,
        g: &G,
        part: &ShapeRef<'_>,
        rule: RuleFn<G, C>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        if !self.env.has_room(template.room) {
            // Beyond the limit the rule runs directly, so it ends at the same shape with and without a template.
            if !self.env.is_within_limit(template.room) {
                return rule(g, self, part);
            }
            self.env.make_room(template.room)?;
        }
        let body = &template.body;
        self.env.shapes += template.shapes;
        let mut holes = template.holes.iter().zip(&turned.holes);
        for segment in &body.segments {
            if !segment.leaves.is_empty() {
                self.env.filled += segment.leaves.len() as u64;
                self.sink.replay(&Replay { part, tables: &self.env.leaf_tables, body, turned, segment })?;
            }
            if let Some((hole, offset)) = holes.next() {
                self.fill(hole, part.origin() + *offset, g, part, resume)?;
            }
        }
        Flow::Continue(())
    }

    /// Calls the rule of a hole.
    fn fill<G>(&mut self, hole: &Hole<C>, origin: DVec3, g: &G, part: &ShapeRef<'_>, resume: ResumeFn<G, C>) -> Flow {
        let [factor, sum] = hole.seed;
        let shape = ShapeRef {
            origin: Cell::new(origin.extend(0.0)),
            size: hole.size.into(),
            axes: if hole.is_raised { part.base.raised() } else { part.axes },
            unit: Cell::new(hole.unit),
            form: hole.form,
            look: Cell::new(hole.look),
            seed: Cell::new(Seed::new(part.seed.get().value().wrapping_mul(factor).wrapping_add(sum))),
            split: Cell::new(if hole.split == INHERITED { part.split.get() } else { hole.split }),
            base: part.base,
        };
        let trail = self.env.trail.len();
        self.env.trail.extend_from_slice(&hole.trail);
        let flow = if hole.stack == 0 {
            resume(g, self, &shape, hole.call.clone())
        } else if self.descend(hole.levels, hole.stack) {
            let flow = resume(g, self, &shape, hole.call.clone());
            self.ascend(hole.levels, hole.stack);
            flow
        } else {
            self.defer(&shape, hole.levels, hole.stack, hole.call.clone())
        };
        self.env.trail.truncate(trail);
        flow
    }
}
