//! The recording of templates: a rule runs at the origin, into a sink that keeps the leaves.

use std::collections::VecDeque;
use std::rc::Rc;
use std::sync::Arc;

use glam::{DAffine3, DMat3};

use super::key::TemplateKey;
use super::mesh_leaf::{LeafGeometry, MeshLeaf};
use super::slot::RepeatedSlot;
use super::tape::Tape;
use super::{
    Found, Hole, INHERITED, LeafRange, LeafRow, MOST, Mark, Template, TemplateBody, TemplateBreak, TemplateCounts,
    TemplateEntry, TemplateLeaf, Templates,
};
use crate::geometry::Axis;
use crate::geometry::mesh::Mesh;
use crate::geometry::small_sort::SmallSort;
use crate::run::context::Cx;
use crate::run::env::records::{MOST_TAPED, TapedReport};
use crate::run::settings::Repeats;
use crate::run::sink::{Filled, Flow, Leaf, Sink};
use crate::shape::ShapeRef;
use crate::shape::axes::Axes;
use crate::shape::base::{Base, Form};
use crate::shape::look_id::LookId;
use crate::shape::seed::Seed;
use crate::value::read::KeptRead;

/// The call of a rule on a part that repeats.
pub(super) type PartFn<'f, C> = &'f mut dyn FnMut(&mut Cx<'_, C>, &ShapeRef<'_>) -> Flow;

/// The reason why a recording fails.
enum Lost {
    /// The rule makes something that templates do not hold.
    Never,
    /// A limit or a watch ended the derivation.
    Ended,
}

/// The lists of a recording. They grow once for all templates of a session.
#[derive(Debug, Default)]
pub(super) struct RecordedLists {
    leaves: Vec<TemplateLeaf>,
    frames: Vec<DMat3>,
    segments: Vec<LeafRange>,
    marks: Vec<Mark>,
    rows: Vec<LeafRow>,
}

/// A sink that keeps leaves.
struct Recorder<'r> {
    base: &'r Base,
    /// True if leaves may be meshes.
    is_whole: bool,
    lists: RecordedLists,
    /// The leaves that do not fill their scopes, each with the number of leaves before it that do.
    others: Vec<(usize, MeshLeaf)>,
}

impl Recorder<'_> {
    fn add(&mut self, leaf: &Leaf<'_>, geometry: LeafGeometry) -> Flow {
        if !self.is_whole || MOST <= self.others.len() {
            return Flow::Break(());
        }
        self.others.push((self.lists.leaves.len(), MeshLeaf::of(leaf, geometry)));
        Flow::Continue(())
    }
}

impl Sink for Recorder<'_> {
    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        let shape = leaf.shape;
        // Coordinates follow from projections of the base.
        let is_known = !shape.look.get().may_have_coordinates() || std::ptr::eq(shape.base, self.base);
        if !is_known || MOST <= self.lists.leaves.len() {
            return Flow::Break(());
        }
        // The first frame has the axes of the base.
        let frame = if std::ptr::eq(shape.axes, self.base.axes()) { 0 } else { self.lists.frame(&shape.axes.matrix) };
        self.lists.leaves.push(TemplateLeaf {
            origin: shape.origin(),
            size: shape.size.get(),
            unit: shape.unit.get(),
            form: shape.form,
            frame,
            rule: leaf.rule,
            look: shape.look.get(),
        });
        Flow::Continue(())
    }

    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.add(leaf, LeafGeometry::Instance(mesh.clone(), *placement))
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.add(leaf, LeafGeometry::Mesh(mesh.clone(), *placement))
    }

    fn placement(&mut self, leaf: &Leaf<'_>) -> Flow {
        self.add(leaf, LeafGeometry::Placement)
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
        let is_raised = shape.axes.is(&tape.base.raised().matrix);
        let has_axes = is_raised || shape.axes.is(&tape.base.axes().matrix);
        let is_filled = !matches!(shape.form, Form::Other);
        let has_base = std::ptr::eq(shape.base, tape.base) || (is_filled && shape.base.differs_in_look(tape.base));
        let has_number = shape.look.get() != LookId::OF_BASE;
        if !has_base || !has_axes || !has_number || MOST <= tape.holes.len() {
            return Flow::Break(());
        }
        tape.holes.push(Hole {
            at: (self.env.filled - tape.filled) as usize,
            others: (self.env.leaves - tape.leaves) as usize,
            reports: self.env.taped_reports.len(),
            origin: shape.origin(),
            size: shape.size.get(),
            unit: shape.unit.get(),
            form: shape.form,
            is_raised,
            look: shape.look.get(),
            seed: [shape.seed.get().factor(), shape.seed.get().value()],
            split: shape.split.get(),
            levels,
            stack,
            call,
            trail: self.env.trail[tape.trail..].into(),
        });
        Flow::Continue(())
    }

    /// Makes the template for a shape with that hash and keeps it, or keeps the knowledge that there is none. It is recorded with the look
    /// `look`.
    #[cold]
    #[inline(never)]
    pub(super) fn prepare(
        &mut self,
        hash: u64,
        slot: RepeatedSlot<'_>,
        (part, look): (&ShapeRef<'_>, LookId),
        rule: PartFn<'_, C>,
    ) -> Option<Found<C>> {
        let (least, too_small) = (self.env.least_split, self.env.too_small);
        self.env.least_split = f64::INFINITY;
        let key = TemplateKey::of(&slot, part, look);
        let template = self.record(slot, (part, look), rule, key.reads.clone());
        // Two runs with different thresholds agree on extents above the largest possible threshold.
        let no_matter = crate::run::env::TOO_SMALL.1 < self.env.least_split;
        self.env.least_split = least.min(self.env.least_split);
        let too_small = if no_matter { f64::NAN } else { too_small };
        // Another run of the session may have room for it.
        let is_ended = matches!(template, Err(Lost::Ended));
        let template = template.ok().map(Rc::new);
        let is_lasting = look.is_lasting() && template.as_ref().is_none_or(|template| template.is_lasting);
        let mut entry = TemplateEntry { key, too_small, template, turned: Vec::new(), paints: Vec::new() };
        let turned = entry.turned(part.axes).map(|(template, turned, _)| (template, turned));
        let paint = entry.paint(part.look.get(), &mut self.env.leaf_tables.looks);
        let found = turned.zip(paint).map(|((template, turned), paint)| Found { template, turned, paint });
        if self.env.settings.repeats == Repeats::Kept && !is_ended && is_lasting {
            self.templates.keep(hash, entry);
        }
        found
    }

    /// Derives a rule at the origin. An error if it makes a fault, too many leaves, or a leaf that a template of the slot cannot hold.
    fn record(
        &mut self,
        slot: RepeatedSlot<'_>,
        (part, look): (&ShapeRef<'_>, LookId),
        rule: PartFn<'_, C>,
        reads: Box<[KeptRead]>,
    ) -> Result<Template<C>, Lost> {
        let (before, count) = (self.env.state(), self.env.shape_count());
        let checkpoint = self.env.measure_room();
        let base = Base::at_origin(part, look, slot.reads_axes);
        let lists = self.templates.lists.begun(base.axes().matrix);
        let mut recorder = Recorder { base: &base, is_whole: slot.is_whole, lists, others: Vec::new() };
        let (filled, leaves, trail) = (self.env.filled, self.env.leaves, self.env.trail.len());
        let tape = Tape { base: &base, filled, leaves, trail, holes: Vec::new() };
        self.env.reach = None;
        self.env.taped_reports.clear();
        let mut templates = Templates::default();
        let mut cx = Cx {
            env: self.env,
            sink: &mut recorder,
            waiting: VecDeque::new(),
            stack: self.stack,
            depth: self.depth,
            templates: &mut templates,
            tape: Some(tape),
            is_operand: self.is_operand,
        };
        let shape = base.shape();
        // So the seeds of holes are sums, and say which factor the seed of a repetition gets.
        shape.seed.set(Seed::new(0));
        shape.split.set(INHERITED);
        let flow = rule(&mut cx, &shape);
        let is_complete = flow.is_continue() && cx.waiting.is_empty();
        let holes = cx.tape.take().map(|tape| tape.holes).unwrap_or_default();
        let Recorder { lists, others, .. } = recorder;
        self.templates.lists = lists;
        let shapes = self.env.shapes.saturating_sub(before.shapes);
        let meshes = self.env.state().meshes.since(before.meshes);
        let reach = self.env.reach.take();
        let mut reports = std::mem::take(&mut self.env.taped_reports);
        reports.iter_mut().for_each(|report| drop(report.trail.drain(..trail)));
        let room = self.env.measured_room(checkpoint).saturating_sub(count);
        let is_ended = self.env.ended();
        let is_quiet = self.env.restore(before);
        if is_ended {
            return Err(Lost::Ended);
        }
        let has_missed = base.shape.state.projections().has_missed();
        if !is_complete || !is_quiet || has_missed || MOST_TAPED < reports.len() {
            return Err(Lost::Never);
        }
        let hole_looks: Vec<LookId> = holes.iter().map(|hole| hole.look).collect();
        let (ends, breaks): (Vec<usize>, Vec<_>) = in_order(holes, others, reports).into_iter().unzip();
        let lists = &mut self.templates.lists;
        lists.divide(ends.into_iter());
        let looks = || lists.marks.iter().map(|mark| mark.look).chain(hole_looks.iter().copied());
        let is_lasting = looks().all(LookId::is_lasting);
        let mut open: Vec<LookId> = looks().filter(|look| self.env.leaf_tables.looks.is_open(*look)).collect();
        open.small_sort_unstable_by(|a, b| a.0.cmp(&b.0));
        open.dedup();
        let counts = TemplateCounts { shapes, room, meshes };
        let (body, open) = (lists.taken(!slot.reads_axes), open.into());
        Ok(Template { counts, body, breaks, reach, reads, open, is_lasting })
    }
}

/// The breaks in order, each with the number of leaves before it that fill their scopes.
fn in_order<C>(
    holes: Vec<Hole<C>>,
    others: Vec<(usize, MeshLeaf)>,
    reports: Vec<TapedReport>,
) -> Vec<(usize, TemplateBreak<C>)> {
    let (mut breaks, mut passed, mut reported) = (Vec::new(), 0, 0);
    let mut others = others.into_iter().map(|(at, leaf)| (at, TemplateBreak::Leaf(leaf)));
    let mut reports = reports.into_iter().map(TemplateBreak::Report);
    for hole in holes {
        breaks.extend(others.by_ref().take(hole.others - passed));
        // Calls report, too. The place among leaves does not matter.
        breaks.extend(reports.by_ref().take(hole.reports - reported).map(|report| (hole.at, report)));
        (passed, reported) = (hole.others, hole.reports);
        breaks.push((hole.at, TemplateBreak::Hole(hole)));
    }
    breaks.extend(others);
    let end = breaks.last().map_or(0, |(at, _)| *at);
    breaks.extend(reports.map(|report| (end, report)));
    breaks
}

impl RecordedLists {
    /// Takes the lists for a recording of a shape with those axes.
    fn begun(&mut self, axes: DMat3) -> Self {
        let mut lists = std::mem::take(self);
        lists.leaves.clear();
        lists.leaves.reserve(MOST);
        lists.frames.clear();
        lists.frames.push(axes);
        lists
    }

    /// The index of axes among the frames.
    fn frame(&mut self, axes: &DMat3) -> u32 {
        let known = self.frames.iter().position(|frame| frame == axes);
        known.unwrap_or_else(|| {
            self.frames.push(*axes);
            self.frames.len() - 1
        }) as u32
    }

    /// The body of the template. Takes everything out of the lists.
    fn taken(&mut self, is_turned: bool) -> TemplateBody {
        TemplateBody {
            is_turned,
            leaves: self.leaves.drain(..).collect(),
            frames: self.frames.drain(..).map(Axes::new).collect(),
            segments: self.segments.drain(..).collect(),
            marks: self.marks.drain(..).collect(),
            rows: self.rows.drain(..).collect(),
        }
    }

    /// Divides the leaves at the breaks, and finds consecutive leaves that are alike.
    fn divide(&mut self, breaks: impl Iterator<Item = usize>) {
        let Self { leaves, segments, marks, rows, .. } = self;
        let is_box = |leaf: &TemplateLeaf| leaf.form == Form::Box;
        let mut start = 0;
        for end in breaks.chain([leaves.len()]) {
            let (first_mark, first_row, leaves) = (marks.len(), rows.len(), &leaves[start.min(end)..end]);
            let mut corners = 0;
            for alike in leaves.chunk_by(|a, b| a.rule == b.rule && a.look == b.look) {
                let TemplateLeaf { rule, look, .. } = alike[0];
                let own = alike.iter().map(|leaf| 4 * leaf.unit.face_count()).sum();
                marks.push(Mark { rule, look, leaves: alike.len(), corners: own, before: corners as u32 });
                corners += own;
            }
            let mut at = start;
            for row in leaves.chunk_by(|a, b| is_box(a) == is_box(b) && a.frame == b.frame) {
                rows.push(LeafRow { is_box: is_box(&row[0]), frame: row[0].frame, leaves: at..at + row.len() });
                at += row.len();
            }
            segments.push(LeafRange {
                leaves: start..end,
                marks: first_mark..marks.len(),
                rows: first_row..rows.len(),
                corners,
                is_plain: leaves.iter().all(|leaf| matches!(leaf.form, Form::Rect(Axis::Z) | Form::Box)),
                may_have_coordinates: marks[first_mark..].iter().any(|mark| mark.look.may_have_coordinates()),
            });
            start = end;
        }
    }
}
