//! Repetitions of a template: its leaves go to the sink, its holes are called.

use std::cell::Cell;
use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::key::TemplateKey;
use super::record::PartFn;
use super::replay::Replay;
use super::slot::RepeatedSlot;
use super::{Found, Hole, INHERITED, TemplateBreak, TemplateCounts};
use crate::geometry::Axis;
use crate::geometry::mesh::Bounds;
use crate::geometry::tol::PLANAR_EPSILON;
use crate::run::context::{Cx, ResumeFn};
use crate::run::settings::Repeats;
use crate::run::sink::Flow;
use crate::shape::ShapeRef;
use crate::shape::base::Form;
use crate::shape::look_id::LookId;
use crate::shape::seed::Seed;
use crate::shape::trim::TrimPlane;
use crate::shape::unit::UnitMesh;
use crate::value::read;

/// The template of the last repetition of a slot: the next one is often as large, and the parts of a split do not differ in
/// more than their place, one extent, the unit mesh and the values that they read.
pub struct Last<C>(Option<LastTemplate<C>>);

/// A template for the parts of one base.
struct LastTemplate<C> {
    /// The extent and the unit mesh of the last repetition.
    extent: f64,
    unit: UnitMesh,
    found: Found<C>,
    /// The trim planes of the base that may cut the template.
    planes: Option<Arc<[TrimPlane]>>,
}

/// Returns true if everything that operations on whole shapes read moves with the part: it has the axes of its pivot, and no texture
/// coordinates. Projections do not move; a rule that reads them has no template.
fn moves_as_a_whole(part: &ShapeRef<'_>) -> bool {
    part.axes.is(&part.base.shape.pivot.axes) && !part.has_coordinates()
}

impl<C> LastTemplate<C> {
    /// Returns true if a trim plane of the base may cut the template at a part.
    #[inline]
    fn is_cut(&self, part: &ShapeRef<'_>) -> bool {
        match (&self.found.template.reach, &self.planes) {
            (Some(reach), Some(planes)) => {
                let turn =
                    if self.found.template.body.is_turned { part.axes.matrix.transpose() } else { DMat3::IDENTITY };
                planes.iter().any(|plane| is_beyond(plane, turn * plane.normal, part, reach))
            }
            _ => false,
        }
    }
}

/// Returns true if some point of a box, relative to a part, is beyond a plane. `normal` is the plane's in the coordinates of the box.
fn is_beyond(plane: &TrimPlane, normal: DVec3, part: &ShapeRef<'_>, reach: &Bounds) -> bool {
    let low = (normal * reach.low).min(normal * reach.high).element_sum();
    let near = PLANAR_EPSILON * reach.size().max_element();
    let distance = (part.origin() - plane.point).dot(plane.normal) + low;
    distance.is_nan() || distance < -near
}

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
    /// Runs a rule on a part that repeats along an axis, from its template, which is made on first use.
    #[inline]
    pub fn repeat<G>(
        &mut self,
        slot: RepeatedSlot<'_>,
        last: &mut Last<C>,
        g: &G,
        (part, axis): (&ShapeRef<'_>, Axis),
        rule: PartFn<'_, C>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        let (extent, unit) = (part.size.along(axis), part.unit.get());
        match &last.0 {
            Some(last)
                if last.extent == extent && last.unit.is(unit) && read::are(&last.found.template.reads, slot.reads) =>
            {
                self.replay_within(last, g, part, rule, resume)
            }
            _ => self.repeat_anew(slot, last, g, (part, extent), rule, resume),
        }
    }

    #[inline(never)]
    fn repeat_anew<G>(
        &mut self,
        slot: RepeatedSlot<'_>,
        last: &mut Last<C>,
        g: &G,
        (part, extent): (&ShapeRef<'_>, f64),
        rule: PartFn<'_, C>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        let (look, temporary) = (part.look.get(), self.env.leaf_tables.looks.temporary_count());
        let Some(found) = self.template(slot, part, rule) else {
            *last = Last(None);
            if !part.look.get().is_lasting() {
                part.look.set(look);
            }
            self.env.leaf_tables.looks.end_temporary(temporary);
            return rule(self, part);
        };
        let base = &part.base.shape;
        let planes = found.template.reach.map(|_| base.trims.planes(&base.pivot));
        let new = LastTemplate { extent, unit: part.unit.get(), found, planes };
        let flow = self.replay_within(&new, g, part, rule, resume);
        let Found { template, paint, .. } = &new.found;
        let is_lasting = template.is_lasting && paint.is_lasting && part.look.get().is_lasting();
        *last = Last(is_lasting.then_some(new));
        if !is_lasting {
            part.look.set(look);
            self.env.leaf_tables.looks.end_temporary(temporary);
        }
        flow
    }

    /// The template for a part, whose look gets a number.
    fn template(&mut self, slot: RepeatedSlot<'_>, part: &ShapeRef<'_>, rule: PartFn<'_, C>) -> Option<Found<C>> {
        let is_filled = matches!(part.form, Form::Rect(_) | Form::Box);
        let is_direct = self.env.settings.repeats == Repeats::Direct;
        if self.tape.is_some() || is_direct || !is_filled || !std::ptr::eq(part.axes, part.base.axes()) {
            return None;
        }
        if slot.is_whole && (self.is_operand || !moves_as_a_whole(part)) {
            return None;
        }
        if part.look.get() == LookId::OF_BASE {
            part.look.set(self.env.leaf_tables.looks.number_at_least_for_now(part.base.shape.state.look()));
            if part.look.get() == LookId::OF_BASE {
                return None;
            }
        }
        let looks = &mut self.env.leaf_tables.looks;
        let own = part.look.get();
        let look = if slot.is_whole { own } else { looks.open(own) };
        let hash = TemplateKey::hash(&slot, part, look);
        match self.templates.find(hash, &slot, (part, look), self.env.too_small) {
            Some(entry) => {
                let (template, turned, is_new) = entry.turned(part.axes)?;
                let paint = entry.paint(own, looks)?;
                if is_new {
                    self.templates.make_room(template.len());
                }
                Some(Found { template, turned, paint })
            }
            None => self.prepare(hash, slot, (part, look), rule),
        }
    }

    #[inline(never)]
    fn replay_within<G>(
        &mut self,
        last: &LastTemplate<C>,
        g: &G,
        part: &ShapeRef<'_>,
        rule: PartFn<'_, C>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        let Found { template, turned, paint } = &last.found;
        let TemplateCounts { shapes, room, meshes } = template.counts;
        if last.is_cut(part) {
            return rule(self, part);
        }
        if !self.env.has_room(room) {
            // Beyond the limit the rule runs directly, so it ends at the same shape with and without a template.
            if !self.env.is_within_limit(room) {
                return rule(self, part);
            }
            self.env.make_room(room)?;
        }
        if !self.env.count_again(meshes, room) {
            return rule(self, part);
        }
        let body = &template.body;
        self.env.shapes += shapes;
        let mut breaks = template.breaks.iter().zip(&turned.breaks);
        for segment in &body.segments {
            if !segment.leaves.is_empty() {
                self.env.filled += segment.leaves.len() as u64;
                self.sink.replay(&Replay { part, tables: &self.env.leaf_tables, body, turned, paint, segment })?;
            }
            match breaks.next() {
                Some((TemplateBreak::Hole(hole), at)) => {
                    self.fill(hole, (part.origin() + at.origin, paint.of(hole.look)), g, part, resume)?;
                }
                Some((TemplateBreak::Leaf(leaf), at)) => {
                    self.env.leaves += 1;
                    leaf.pass(self.sink, part.origin(), at)?;
                }
                Some((TemplateBreak::Report(report), _)) => {
                    let trail = self.env.trail.len();
                    self.env.trail.extend_from_slice(&report.trail);
                    self.env.report(report.key.clone(), report.value.clone());
                    self.env.trail.truncate(trail);
                }
                None => {}
            }
        }
        Flow::Continue(())
    }

    /// Calls the rule of a hole.
    fn fill<G>(
        &mut self,
        hole: &Hole<C>,
        (origin, look): (DVec3, LookId),
        g: &G,
        part: &ShapeRef<'_>,
        resume: ResumeFn<G, C>,
    ) -> Flow {
        let [factor, sum] = hole.seed;
        let shape = ShapeRef {
            origin: Cell::new(origin.extend(0.0)),
            size: hole.size.into(),
            axes: if hole.is_raised { part.base.raised() } else { part.axes },
            unit: Cell::new(hole.unit),
            form: hole.form,
            look: Cell::new(look),
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
