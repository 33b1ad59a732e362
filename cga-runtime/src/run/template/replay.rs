//! The replay of a template: its leaves go to the sink, and its holes are called.

use std::cell::Cell;
use std::ops::Range;
use std::rc::Rc;

use glam::{DAffine3, DVec3, DVec4};

use super::{Body, Hole, INHERITED, Mark, Record, Row, Segment, Template, Turned};
use crate::geometry::Axis;
use crate::run::context::{Cx, ResumeFn, RuleFn};
use crate::run::sink::LeafTables;
use crate::run::sink::corners::{Placed, four};
use crate::run::sink::{Filled, Flow, Sink};
use crate::shape::ShapeRef;
use crate::shape::axes::Axes;
use crate::shape::base::Form;
use crate::shape::look_ids::MaterialId;
use crate::shape::seed::Seed;
use crate::shape::unit::UnitMesh;

/// The leaves of a part that repeats, at one of its places. All of them fill their scopes.
///
/// A sink can keep such a part once, with a list of its placements, for programs that draw instances:
///
/// ```
/// use std::collections::HashMap;
/// use std::sync::Arc;
///
/// use cga_runtime::geometry::mesh::Mesh;
/// use cga_runtime::output::buffers::Buffers;
/// use cga_runtime::run::sink::{Filled, Flow, Leaf, PartId, Replay, Sink};
/// use glam::DAffine3;
///
/// /// Meshes with their places, and everything that does not repeat.
/// #[derive(Default)]
/// struct Scene {
///     parts: Vec<(Buffers, Vec<DAffine3>)>,
///     by_id: HashMap<PartId, usize>,
///     rest: Buffers,
/// }
///
/// impl Sink for Scene {
///     // Numbers and identities are those of a run.
///     fn begin(&mut self) {
///         self.by_id.clear();
///         self.rest.begin();
///     }
///
///     fn replay(&mut self, replay: &Replay<'_>) -> Flow {
///         let parts = &mut self.parts;
///         let index = *self.by_id.entry(replay.part()).or_insert_with(|| {
///             let mut mesh = Buffers::new();
///             let _ = replay.each_local(&mut mesh);
///             parts.push((mesh, Vec::new()));
///             parts.len() - 1
///         });
///         self.parts[index].1.push(replay.placement());
///         Flow::Continue(())
///     }
///
///     fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
///         self.rest.filled(leaf)
///     }
///
///     fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
///         self.rest.mesh(leaf, mesh, placement)
///     }
/// }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Replay<'a> {
    part: &'a ShapeRef<'a>,
    tables: &'a LeafTables,
    body: &'a Body,
    turned: &'a Turned,
    segment: &'a Segment,
}

/// The identity of a repeated part within a run. Parts with equal identities are equal. Equal parts may have
/// different identities, as a run keeps few of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PartId {
    template: u64,
    segment: usize,
    /// The number of the base whose material some leaves have; 0 if none has.
    base: u64,
}

impl<'a> Replay<'a> {
    /// The number of leaves.
    pub fn leaf_count(&self) -> usize {
        self.segment.leaves.len()
    }

    /// The number of vertices if faces share none.
    pub fn corner_count(&self) -> usize {
        self.segment.corners
    }

    /// Returns true if some of the leaves have texture coordinates. These follow from the position of a leaf in the
    /// world, so they may differ between repetitions.
    pub fn has_uvs(&self) -> bool {
        self.segment.may_have_coordinates && self.marks().any(|(leaf, mark)| !leaf.uvs_of(mark.material).is_empty())
    }

    /// The identity of the part, which does not depend on its place.
    pub fn part(&self) -> PartId {
        let has_own = self.mark_list().iter().any(|mark| mark.material == MaterialId::OF_BASE);
        let base = if has_own { self.part.base.number } else { 0 };
        PartId { template: self.body.number, segment: self.segment.leaves.start, base }
    }

    /// The map from the coordinates of the part to the world: a rotation and a translation.
    pub fn placement(&self) -> DAffine3 {
        DAffine3 { matrix3: self.part.axes.matrix, translation: self.part.origin() }
    }

    /// Passes the leaves one by one to [`Sink::filled`], in the coordinates of the part, which are the same at all of
    /// its places. Texture coordinates are meant for points in the world; see [`Replay::has_uvs`].
    pub fn each_local<S: Sink + ?Sized>(&self, sink: &mut S) -> Flow {
        let placed = self.body.leaves[self.segment.leaves.clone()].iter().map(|record| four(record.origin));
        self.hand(sink, placed, &self.body.frames)
    }

    /// Passes the leaves one by one to [`Sink::filled`].
    #[inline]
    pub fn each<S: Sink + ?Sized>(&self, sink: &mut S) -> Flow {
        let range = self.segment.leaves.clone();
        let placed = self.turned.leaves[range].iter().map(|placed| self.part.origin.get() + placed.origin);
        self.hand(sink, placed, &self.turned.axes)
    }

    /// Passes the leaves to a sink, with those origins and axes.
    #[inline(always)]
    fn hand<S: Sink + ?Sized>(&self, sink: &mut S, origins: impl Iterator<Item = DVec4>, axes: &'a [Axes]) -> Flow {
        let mut shape = self.part.clone();
        for (record, origin) in self.body.leaves[self.segment.leaves.clone()].iter().zip(origins) {
            shape.origin.set(origin);
            shape.size.set(record.size);
            shape.axes = &axes[record.frame as usize];
            shape.unit.set(record.unit);
            shape.form = record.form;
            shape.material.set(record.material);
            sink.filled(&Filled { shape: &shape, tables: self.tables, rule: record.rule })?;
        }
        Flow::Continue(())
    }

    /// Returns true if all leaves are boxes or rectangles across z.
    pub(crate) fn is_plain(&self) -> bool {
        self.segment.is_plain
    }

    /// The numbers of the template and of the segment. Parts with equal numbers differ only in their place and axes,
    /// and in materials without a number.
    pub(crate) fn number(&self) -> (u64, usize) {
        (self.body.number, self.segment.leaves.start)
    }

    /// The groups of consecutive leaves with equal rule and material, each with its first leaf.
    pub(crate) fn marks(&self) -> impl Iterator<Item = (Filled<'a>, Mark)> {
        let Replay { part, tables, .. } = *self;
        self.mark_list().iter().map(move |mark| (Filled { shape: part, tables, rule: mark.rule }, *mark))
    }

    /// The groups of consecutive leaves with equal rule and material.
    pub(crate) fn mark_list(&self) -> &'a [Mark] {
        &self.body.marks[self.segment.marks.clone()]
    }

    /// A range of leaves: their positions, their records, and their axes.
    #[inline]
    pub(crate) fn leaves(&self, range: Range<usize>) -> impl Iterator<Item = (&'a Placed, &'a Record, &'a Axes)> {
        let (axes, first) = (&self.turned.axes, self.segment.leaves.start);
        let range = first + range.start..first + range.end;
        let records = &self.body.leaves[range.clone()];
        let placed = self.turned.leaves[range].iter().zip(records);
        placed.map(move |(placed, record)| (placed, record, &axes[record.frame as usize]))
    }

    /// The leaves in rows of boxes or rectangles, with their axes, positions and records.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&'a Row, &'a Axes, &'a [Placed], &'a [Record])> {
        let Replay { body, turned, segment, .. } = *self;
        body.rows[segment.rows.clone()].iter().map(move |row| {
            let axes = &turned.axes[row.frame as usize];
            (row, axes, &turned.leaves[row.leaves.clone()], &body.leaves[row.leaves.clone()])
        })
    }

    /// The origin of the repetition, with a fourth coordinate of 0.
    #[inline]
    pub(crate) fn origin(&self) -> DVec4 {
        self.part.origin.get()
    }
}

/// The template of the last repetition of a slot. The next repetition often has the same size, and the parts of a
/// split differ only in their place, one extent and the unit mesh.
pub struct Last<C>(Option<Known<C>>);

/// The extent and the unit mesh of a repetition, and its template.
type Known<C> = (f64, UnitMesh, Rc<Template<C>>, Rc<Turned>);

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
            material: Cell::new(hole.material),
            seed: Cell::new(Seed::new(part.seed.get().value().wrapping_mul(factor).wrapping_add(sum))),
            split: Cell::new(if hole.split == INHERITED { part.split.get() } else { hole.split }),
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
