//! Operations that divide a boundary into sections by a pattern, and the rest.

use std::ops::ControlFlow;

use cga_split::{Item, Size};

use super::faces::{Faces, by_shape};
use super::{Arm, Mode};
use crate::fault::FaultKind;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::seed::{self, Tag};
use crate::shape::{Counter, Shape, ShapeRef};

/// The limit on sections, because each is set back on its own.
const MOST_SECTIONS: u64 = 500;

/// The depth of a written section, by number, with the shape that is divided and the counters of the section.
pub(crate) type Depth<'d> = dyn FnMut(&mut Env, u32, &mut Shape) -> f64 + 'd;

/// The sections that a pattern gives.
pub struct Sections<'a> {
    shape: &'a Shape,
    pattern: &'a [Item],
    sizes: &'a mut [Size],
    depth: &'a mut Depth<'a>,
    /// The written section of each section that was made.
    slots: Vec<u32>,
}

/// A section of a boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Section {
    /// Where it begins along the boundary, in metres.
    pub(crate) start: f64,
    /// Where it ends.
    pub(crate) end: f64,
    /// Its depth in metres.
    pub(crate) depth: f64,
}

impl<'a> Sections<'a> {
    pub(crate) fn new(
        shape: &'a Shape,
        (pattern, sizes): (&'a [Item], &'a mut [Size]),
        depth: &'a mut Depth<'a>,
    ) -> Self {
        Sections { shape, pattern, sizes, depth, slots: Vec::new() }
    }

    /// The shape that is divided.
    pub(crate) fn shape(&self) -> &Shape {
        self.shape
    }

    /// Divides a length in metres by the pattern and evaluates the depth of each section. Faces of a section have its number as
    /// their arm, and faces of the rest have the arm of [`Sections::rest`]. No sections, with a fault, if there are too many.
    pub(crate) fn along(&mut self, env: &mut Env, length: f64, name: &str) -> Vec<Section> {
        for size in &mut *self.sizes {
            size.value = env.finite(size.value, format_args!("a length of `{name}`"));
        }
        let mut lengths = vec![0.0; self.sizes.len()];
        let solution = cga_split::solve(self.pattern, self.sizes, &mut lengths, length);
        if MOST_SECTIONS < solution.at_most() {
            env.fault(
                FaultKind::Geometry,
                format!("`{name}`: there are more than {MOST_SECTIONS} sections; none is made"),
            );
            return Vec::new();
        }
        let pieces = solution.pieces();
        self.slots = pieces.iter().map(|piece| piece.slot).collect();
        let mut sections = Vec::with_capacity(pieces.len());
        for (index, piece) in pieces.iter().enumerate() {
            let mut shape = self.shape.clone();
            shape.seed = self.shape.seed.child(Tag::Candidate, index as u32);
            shape.split = Counter::new(index, pieces.len());
            let depth = (self.depth)(env, piece.slot, &mut shape);
            let depth = env.finite(depth, format_args!("a depth of `{name}`"));
            sections.push(Section { start: piece.start, end: piece.end, depth });
        }
        sections
    }

    /// The arm of the rest.
    pub(crate) fn rest(&self) -> Option<u32> {
        Some(self.slots.len() as u32)
    }
}

/// Divides a shape into the faces that `make` gives, and calls `visit` with each section, as one shape, and then with the
/// rest: the number of the written section, or of the arm of the rest after them, and the shape. `number` counts the children that
/// the rule makes.
#[allow(clippy::too_many_arguments, reason = "generated code calls it")]
pub fn sections<C>(
    cx: &mut Cx<'_, C>,
    shape: &ShapeRef<'_>,
    number: u32,
    pattern: (&[Item], &mut [Size]),
    rest: &[Arm],
    depth: &mut Depth<'_>,
    make: impl FnOnce(&mut Env, &mut Sections<'_>) -> ControlFlow<(), Faces>,
    visit: &mut dyn FnMut(&mut Cx<'_, C>, u32, &ShapeRef<'_>) -> Flow,
) -> Flow {
    cx.env.ask()?;
    let mut whole = cx.env.whole(&shape.child(seed::key(Tag::Split, number)));
    whole.bake();
    let written = pattern.1.len() as u32;
    let mut depth = |env: &mut Env, slot: u32, shape: &mut Shape| depth(env, slot, shape);
    let mut all = Sections::new(&whole, pattern, &mut depth);
    let made = make(cx.env, &mut all)?;
    let slots = all.slots;
    cx.env.count_corners(made.mesh.corners().len() as u64)?;
    let by_section = made.by_arm(slots.len() + 1);
    let mut give = |cx: &mut Cx<'_, C>, slot: u32, counter: Option<Counter>, key: u32, faces: &[u32]| {
        let mut part = made.shape(&whole, faces, whole.seed.part(slot, u64::from(key)));
        part.split = counter.unwrap_or(part.split);
        let base = cx.env.base(part);
        visit(cx, slot, &base.shape())
    };
    for (index, &slot) in slots.iter().enumerate() {
        for faces in by_shape(by_section.of(index), Mode::Together) {
            give(cx, slot, Some(Counter::new(index, slots.len())), index as u32, faces)?;
        }
    }
    let Some(arm) = rest.first() else { return Flow::Continue(()) };
    by_shape(by_section.of(slots.len()), arm.mode).try_for_each(|faces| give(cx, written, None, faces[0], faces))
}
