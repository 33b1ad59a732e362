//! The recording of templates: a rule runs at the origin, into a sink that keeps the leaves.

use std::collections::VecDeque;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::{DAffine3, DMat3};

use super::{
    Hole, INHERITED, LeafRange, LeafRow, MOST, Mark, Template, TemplateBody, TemplateEntry, TemplateKey, TemplateLeaf,
    Templates, Turned,
};
use crate::geometry::Axis;
use crate::geometry::mesh::Mesh;
use crate::run::context::{Cx, RuleFn};
use crate::run::settings::Repeats;
use crate::run::sink::{Filled, Flow, Leaf, Sink};
use crate::shape::ShapeRef;
use crate::shape::axes::Axes;
use crate::shape::base::{Base, Form};
use crate::shape::seed::Seed;

/// The number of the next template. Numbers distinguish the templates of all sessions, and are in no output.
static NUMBER: AtomicU64 = AtomicU64::new(1);

/// The recording of a template under construction.
pub(crate) struct Tape<'r, C> {
    /// The base of the shape at the origin.
    base: &'r Base,
    /// The number of leaves of the run, and of rules on its trail, before the template.
    leaves: u64,
    trail: usize,
    holes: Vec<Hole<C>>,
}

/// The reason why a recording fails.
enum Lost {
    /// The rule makes something that templates do not hold.
    Never,
    /// A limit or a watch ended the derivation.
    Ended,
}

/// A sink that keeps leaves.
struct Recorder<'r> {
    base: &'r Base,
    leaves: Vec<TemplateLeaf>,
    frames: Vec<DMat3>,
}

impl Sink for Recorder<'_> {
    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        let shape = leaf.shape;
        // A look without a number is the base's, and coordinates follow from projections of the base.
        let is_known = !shape.look.get().may_have_coordinates() || std::ptr::eq(shape.base, self.base);
        if !is_known || MOST <= self.leaves.len() {
            return Flow::Break(());
        }
        let matrix = shape.axes.matrix;
        let frame = self.frames.iter().position(|frame| *frame == matrix).unwrap_or_else(|| {
            self.frames.push(matrix);
            self.frames.len() - 1
        });
        self.leaves.push(TemplateLeaf {
            origin: shape.origin(),
            size: shape.size.get(),
            unit: shape.unit.get(),
            form: shape.form,
            frame: frame as u32,
            rule: leaf.rule,
            look: shape.look.get(),
        });
        Flow::Continue(())
    }

    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        Flow::Break(())
    }

    fn placement(&mut self, _: &Leaf<'_>) -> Flow {
        Flow::Break(())
    }
}

impl<C: Clone> Cx<'_, C> {
    /// Returns true while a template is recorded: calls that are not rigid become holes.
    #[inline]
    pub fn records(&self) -> bool {
        self.tape.is_some()
    }

    /// Keeps a call as a hole of the recorded template. The call reserves `levels` of recursion and `stack` units of
    /// the stack.
    #[cold]
    #[inline(never)]
    pub fn hole(&mut self, shape: &ShapeRef<'_>, levels: u32, stack: u32, call: C) -> Flow {
        let Some(tape) = &mut self.tape else { return Flow::Break(()) };
        let is_raised = std::ptr::eq(shape.axes, tape.base.raised());
        let has_base = std::ptr::eq(shape.base, tape.base);
        if !has_base || !(is_raised || std::ptr::eq(shape.axes, tape.base.axes())) || MOST <= tape.holes.len() {
            return Flow::Break(());
        }
        tape.holes.push(Hole {
            at: (self.env.filled - tape.leaves) as usize,
            origin: shape.origin(),
            size: shape.size.get(),
            unit: shape.unit.get(),
            form: shape.form,
            is_raised,
            look: shape.look.get(),
            seed: [0, shape.seed.get().value()],
            split: shape.split.get(),
            levels,
            stack,
            call,
            trail: self.env.trail[tape.trail..].into(),
        });
        Flow::Continue(())
    }

    /// Makes the template for a shape and keeps it, or keeps the knowledge that there is none.
    #[cold]
    #[inline(never)]
    pub(super) fn prepare<G>(
        &mut self,
        place: u32,
        g: &G,
        part: &ShapeRef<'_>,
        rule: RuleFn<G, C>,
    ) -> Option<(Rc<Template<C>>, Rc<Turned>)> {
        let (least, too_small, repeats) = (self.env.least_split, self.env.too_small, self.env.settings.repeats);
        if repeats == Repeats::Direct {
            let key = TemplateKey::of(part, too_small);
            self.templates.keep(place, TemplateEntry { key, template: None, turned: Vec::new() });
            return None;
        }
        self.env.least_split = f64::INFINITY;
        let template = self.record(g, part, rule, 0).and_then(|mut template| {
            if template.holes.is_empty() {
                return Ok(template);
            }
            // A seed is affine in the seed of the repetition: two points determine the line.
            let other = self.record(g, part, rule, 1)?;
            for (hole, other) in template.holes.iter_mut().zip(&other.holes) {
                let [_, at_zero] = hole.seed;
                hole.seed = [other.seed[1].wrapping_sub(at_zero), at_zero];
            }
            if template.holes.len() == other.holes.len() { Ok(template) } else { Err(Lost::Never) }
        });
        // Two runs with different thresholds agree on extents above the largest possible threshold.
        let no_matter = crate::run::env::TOO_SMALL.1 < self.env.least_split;
        self.env.least_split = least.min(self.env.least_split);
        let key = TemplateKey::of(part, if no_matter { f64::NAN } else { too_small });
        // Another run of the session may have room for it.
        let is_ended = matches!(template, Err(Lost::Ended));
        let mut entry = TemplateEntry { key, template: template.ok().map(Rc::new), turned: Vec::new() };
        if repeats == Repeats::Kept && !is_ended {
            return self.templates.keep(place, entry)?.turned(part.axes);
        }
        entry.turned(part.axes)
    }

    /// Derives a rule at the origin. An error if it makes anything but holes and leaves that fill their scopes.
    fn record<G>(&mut self, g: &G, part: &ShapeRef<'_>, rule: RuleFn<G, C>, seed: u64) -> Result<Template<C>, Lost> {
        let (before, count) = (self.env.state(), self.env.shape_count());
        let checkpoint = self.env.measure_room();
        let base = Base::at_origin(part);
        let mut recorder = Recorder { base: &base, leaves: Vec::new(), frames: vec![DMat3::IDENTITY] };
        let tape = Tape { base: &base, leaves: self.env.filled, trail: self.env.trail.len(), holes: Vec::new() };
        let mut templates = Templates::default();
        let mut cx = Cx {
            env: self.env,
            sink: &mut recorder,
            waiting: VecDeque::new(),
            stack: self.stack,
            depth: self.depth,
            templates: &mut templates,
            tape: Some(tape),
        };
        let shape = base.shape();
        shape.seed.set(Seed::new(seed));
        shape.split.set(INHERITED);
        let flow = rule(g, &mut cx, &shape);
        let is_complete = flow.is_continue() && cx.waiting.is_empty();
        let holes = cx.tape.take().map(|tape| tape.holes).unwrap_or_default();
        let Recorder { leaves, frames, .. } = recorder;
        let shapes = self.env.shapes.saturating_sub(before.shapes);
        let room = self.env.measured_room(checkpoint).saturating_sub(count);
        let is_ended = self.env.ended();
        let is_quiet = self.env.restore(before);
        if is_ended {
            return Err(Lost::Ended);
        }
        if !is_complete || !is_quiet {
            return Err(Lost::Never);
        }
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let body = TemplateBody {
            number,
            leaves,
            frames: frames.into_iter().map(Axes::new).collect(),
            segments: Vec::new(),
            marks: Vec::new(),
            rows: Vec::new(),
        };
        Ok(Template { shapes, room, body: body.divided(holes.iter().map(|hole| hole.at)), holes })
    }
}

impl TemplateBody {
    /// Divides the leaves at the holes, and finds consecutive leaves that are alike.
    fn divided(mut self, holes: impl Iterator<Item = usize>) -> Self {
        let ends = holes.chain([self.leaves.len()]);
        let mut start = 0;
        for end in ends {
            let (first_mark, first_row) = (self.marks.len(), self.rows.len());
            let (mut corners, mut is_plain, mut may_have_coordinates) = (0, true, false);
            for (at, leaf) in self.leaves[..end].iter().enumerate().skip(start) {
                is_plain &= matches!(leaf.form, Form::Rect(Axis::Z) | Form::Box);
                may_have_coordinates |= leaf.look.may_have_coordinates();
                let own = 4 * leaf.unit.face_count();
                match self.marks[first_mark..].last_mut() {
                    Some(mark) if mark.rule == leaf.rule && mark.look == leaf.look => {
                        mark.leaves += 1;
                        mark.corners += own;
                    }
                    _ => {
                        let TemplateLeaf { rule, look, .. } = *leaf;
                        self.marks.push(Mark { rule, look, leaves: 1, corners: own, before: corners as u32 });
                    }
                }
                let is_box = leaf.form == Form::Box;
                match self.rows[first_row..].last_mut() {
                    Some(row) if row.is_box == is_box && row.frame == leaf.frame => row.leaves.end += 1,
                    _ => self.rows.push(LeafRow { is_box, frame: leaf.frame, leaves: at..at + 1 }),
                }
                corners += own;
            }
            self.segments.push(LeafRange {
                leaves: start..end,
                marks: first_mark..self.marks.len(),
                rows: first_row..self.rows.len(),
                corners,
                is_plain,
                may_have_coordinates,
            });
            start = end;
        }
        self
    }
}
