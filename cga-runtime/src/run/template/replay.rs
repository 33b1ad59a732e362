//! The leaves of a template at one of its places.

use std::ops::Range;

use glam::{DAffine3, DMat3, DVec4};

use super::paint::Paint;
use super::part_id::PartId;
use super::{LeafRange, LeafRow, Mark, TemplateBody, TemplateLeaf, Turned};
use crate::run::sink::corners::{PlacedBox, four};
use crate::run::sink::{Filled, Flow, LeafTables, Sink};
use crate::shape::ShapeRef;
use crate::shape::axes::Axes;

/// The leaves of a part that repeats, at one of its places. All of them fill their scopes.
///
/// A sink can keep such a part once, with a list of its placements, for programs that draw instances:
///
/// ```
/// use std::collections::HashMap;
/// use std::sync::Arc;
///
/// # use cga_runtime::facade as cga;
/// use cga::sink::buffers::Buffers;
/// use cga::sink::{Filled, PartId, Replay};
/// use cga::{Flow, Leaf, Mesh, Sink};
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
///     // Numbers and identities hold in one run.
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
    pub(super) part: &'a ShapeRef<'a>,
    pub(super) tables: &'a LeafTables,
    pub(super) body: &'a TemplateBody,
    pub(super) turned: &'a Turned,
    pub(super) paint: &'a Paint,
    pub(super) segment: &'a LeafRange,
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
        self.segment.may_have_coordinates && self.marks().any(|(leaf, mark)| !leaf.uvs_of(mark.look).is_empty())
    }

    /// The identity of the part, which does not depend on its place.
    pub fn part(&self) -> PartId {
        PartId { template: self.paint.number, segment: self.segment.leaves.start }
    }

    /// The map from the coordinates of the part to the world: a rotation and a translation.
    pub fn placement(&self) -> DAffine3 {
        let matrix3 = if self.body.is_turned { self.part.axes.matrix } else { DMat3::IDENTITY };
        DAffine3 { matrix3, translation: self.part.origin() }
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
            shape.look.set(self.paint.of(record.look));
            sink.filled(&Filled { shape: &shape, tables: self.tables, rule: record.rule })?;
        }
        Flow::Continue(())
    }

    /// Returns true if all leaves are boxes or rectangles across z.
    pub(crate) fn is_plain(&self) -> bool {
        self.segment.is_plain
    }

    /// The numbers of the template and of the segment. Parts with equal numbers differ only in their place and axes.
    pub(crate) fn number(&self) -> (u64, usize) {
        (self.paint.number, self.segment.leaves.start)
    }

    /// The groups of consecutive leaves with equal rule and look, each with its first leaf.
    pub(crate) fn marks(&self) -> impl Iterator<Item = (Filled<'a>, Mark)> {
        let Replay { part, tables, paint, .. } = *self;
        let marks = self.body.marks[self.segment.marks.clone()].iter();
        marks.map(move |mark| {
            (Filled { shape: part, tables, rule: mark.rule }, Mark { look: paint.of(mark.look), ..*mark })
        })
    }

    /// A range of leaves: their positions, their records, and their axes.
    #[inline]
    pub(crate) fn leaves(
        &self,
        range: Range<usize>,
    ) -> impl Iterator<Item = (&'a PlacedBox, &'a TemplateLeaf, &'a Axes)> {
        let (axes, first) = (&self.turned.axes, self.segment.leaves.start);
        let range = first + range.start..first + range.end;
        let records = &self.body.leaves[range.clone()];
        let placed = self.turned.leaves[range].iter().zip(records);
        placed.map(move |(placed, record)| (placed, record, &axes[record.frame as usize]))
    }

    /// The leaves in rows of boxes or rectangles, with their axes, positions and records.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&'a LeafRow, &'a Axes, &'a [PlacedBox], &'a [TemplateLeaf])> {
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
