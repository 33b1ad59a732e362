//! The split operation on a shape: every slot that gets room becomes a shape.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;

use super::solve::{Solution, solve};
use super::{Item, Size};
use crate::cut;
use crate::derive::Cx;
use crate::env::Env;
use crate::fault::{FaultKind, LimitKind};
use crate::mesh::Mesh;
use crate::scope::{Axis, Scope};
use crate::seed::{Seed, Tag};
use crate::shape::{Counter, Geometry, Placed, ShapeRef};
use crate::sink::{Flow, Sink};

/// Whether parts shrink to what is in them (*split operation*, adjustSelector).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Adjust {
    /// `adjust`, the default: the scope is the bounding box of the part's geometry.
    Adjust,
    /// `noAdjust`: the scope fills its slot.
    NoAdjust,
}

/// Splits a shape and calls `visit` with every part's slot and shape, from the low end to the high end. Says whether the
/// shape was divided: one too small to be split, or flat along the axis, stays as it is, which makes it a leaf
/// (*Subdivision split*: recursion stops at small geometry).
#[inline]
pub fn split<S: Sink + ?Sized, C>(
    cx: &mut Cx<'_, S, C>,
    shape: &mut ShapeRef<'_>,
    (axis, adjust): (Axis, Adjust),
    pattern: &[Item],
    sizes: &mut [Size],
    mut visit: impl FnMut(&mut Cx<'_, S, C>, u32, &mut ShapeRef<'_>) -> Flow,
) -> ControlFlow<(), bool> {
    let parts = divide(&mut cx.env, shape, axis, adjust, pattern, sizes)?;
    parts.each(|slot, part| visit(cx, slot, part))?;
    ControlFlow::Continue(0 < parts.total)
}

/// A split that is solved and cut, ready to hand out its parts.
#[derive(Debug)]
struct Parts<'s> {
    parent: &'s ShapeRef<'s>,
    axis: Axis,
    adjust: Adjust,
    solution: Solution<'s>,
    total: usize,
    seed: u64,
    ordinal: u32,
    /// One a piece, when the geometry is a mesh.
    slabs: Vec<Option<Arc<Mesh>>>,
}

/// Solves a split of `shape` and cuts its geometry. `Break` when a limit was reached.
fn divide<'s>(
    env: &mut Env,
    shape: &'s mut ShapeRef<'_>,
    axis: Axis,
    adjust: Adjust,
    pattern: &'s [Item],
    sizes: &'s mut [Size],
) -> ControlFlow<(), Parts<'s>> {
    for size in sizes.iter_mut() {
        size.value = env.finite(size.value, "a size of `split`");
    }
    let extent = shape.scope.extent(axis).abs();
    let big_enough = env.too_small < extent;
    let solution = solve(pattern, sizes, if big_enough { extent } else { 0.0 });
    // Before anything is laid out: a bound on the work to come.
    let bound = solution.at_most();
    if env.settings.limits.shapes < env.shapes.saturating_add(bound) {
        // The bound counts slots that get no room, so ask exactly when it is small enough to count.
        let exact = if bound <= env.settings.limits.shapes.saturating_mul(4) { solution.total() } else { bound };
        if env.settings.limits.shapes < env.shapes.saturating_add(exact) {
            return env.limit(LimitKind::Shapes, env.settings.limits.shapes);
        }
    }
    let total = solution.total() as usize;
    let ordinal = shape.seed.reserve(total.min(u32::MAX as usize) as u32);
    let seed = shape.seed.value();
    let slabs = match &shape.geometry {
        Geometry::Mesh(placed) if 0 < total => slabs(env, placed, shape.scope.size, axis, &solution, total),
        _ => Vec::new(),
    };
    for mesh in slabs.iter().flatten() {
        env.count_vertices(mesh)?;
    }
    ControlFlow::Continue(Parts { parent: shape, axis, adjust, solution, total, seed, ordinal, slabs })
}

impl<'s> Parts<'s> {
    #[inline]
    fn each(&self, mut visit: impl FnMut(u32, &mut ShapeRef<'s>) -> Flow) -> Flow {
        let parent = self.parent;
        let at = self.axis.index();
        // A negative size runs the other way from the origin.
        let sign = if parent.scope.size[at] < 0.0 { -1.0 } else { 1.0 };
        let along = parent.scope.axes.col(at) * sign;
        let mut index = 0;
        self.solution.each(|piece| {
            let mut scope = Scope {
                origin: parent.scope.origin + along * piece.start,
                axes: parent.scope.axes,
                size: with(parent.scope.size, self.axis, sign * piece.length),
            };
            let geometry = self.geometry(index, piece.start, piece.length, &mut scope);
            let mut part = ShapeRef {
                scope,
                pivot: parent.pivot,
                geometry,
                seed: Seed::child(self.seed, Tag::Split, self.ordinal.wrapping_add(index as u32)),
                split: Counter::new(index, self.total),
                comp: parent.comp,
                selector: parent.selector,
                state: parent.state.lend(),
            };
            index += 1;
            visit(piece.slot, &mut part)
        })
    }

    /// What fills a part; shrinks its scope when asked to.
    #[inline]
    fn geometry(&self, index: usize, start: f64, length: f64, scope: &mut Scope) -> Geometry {
        match &self.parent.geometry {
            Geometry::Empty => Geometry::Empty,
            Geometry::Box => Geometry::Box,
            Geometry::Rect(normal) if *normal != self.axis => Geometry::Rect(*normal),
            // A flat face in a thick scope stands at the low end.
            Geometry::Rect(normal) if start == 0.0 => {
                if self.adjust == Adjust::Adjust {
                    scope.size[self.axis.index()] = 0.0;
                }
                Geometry::Rect(*normal)
            }
            Geometry::Rect(_) => Geometry::Empty,
            Geometry::Mesh(whole) => {
                let slab = self.slabs.get(index).and_then(Option::as_ref);
                slab.map_or(Geometry::Empty, |mesh| self.part(whole, mesh, start, length, scope))
            }
        }
    }

    fn part(&self, whole: &Placed, mesh: &Arc<Mesh>, start: f64, length: f64, scope: &mut Scope) -> Geometry {
        let at = self.axis.index();
        let size = self.parent.scope.size;
        let stretch = whole.stretch(size);
        let (mut low, mut fit) = (whole.low, whole.size);
        low[at] += start / stretch[at].abs();
        fit[at] = length / stretch[at].abs();
        if self.adjust == Adjust::Adjust {
            let bounds = mesh.bounds();
            if !bounds.low.is_finite() {
                return Geometry::Empty;
            }
            let moved: DVec3 = (bounds.low - low) * stretch;
            scope.origin += scope.axes * moved;
            scope.size = bounds.size() * stretch;
            (low, fit) = (bounds.low, bounds.size());
        }
        Geometry::Mesh(Arc::new(Placed { mesh: mesh.clone(), low, size: fit, whole: false }))
    }
}

/// A size with another extent along an axis. Not by index: that would go through memory and stall there.
#[inline]
fn with(size: DVec3, axis: Axis, extent: f64) -> DVec3 {
    match axis {
        Axis::X => DVec3::new(extent, size.y, size.z),
        Axis::Y => DVec3::new(size.x, extent, size.z),
        Axis::Z => DVec3::new(size.x, size.y, extent),
    }
}

/// Cuts a mesh at the borders of all pieces in one pass; one slab a piece.
fn slabs(
    env: &mut Env,
    placed: &Placed,
    size: DVec3,
    axis: Axis,
    solution: &Solution<'_>,
    pieces: usize,
) -> Vec<Option<Arc<Mesh>>> {
    let at = axis.index();
    // Planes in mesh coordinates, so that no vertex moves.
    let stretch = placed.stretch(size)[at].abs();
    let plane = |distance: f64| placed.low[at] + distance / stretch;
    let high = plane(size[at].abs());
    let mut offsets: Vec<f64> = Vec::new();
    // The slab each piece is in: pieces touch, so after the first border every piece ends one.
    let _ = solution.each(|piece| {
        let end = plane(piece.end);
        // The scope's own end is no cut; rounding must not leave a sliver there.
        if piece.end < size[at].abs() && end < high {
            offsets.push(end);
        }
        Flow::Continue(())
    });
    let mut rising = offsets.clone();
    rising.dedup();
    let cut = cut::slabs(&placed.mesh, axis, &rising);
    // *split operation*: surfaces get no caps. An asset that was meant to be a solid is worth a word, a face is not.
    if !cut.open.is_empty() && placed.whole && 1 < placed.mesh.face_count() {
        env.fault(
            FaultKind::Geometry,
            "the inserted mesh is not closed where `split` cuts it; the cut stays open there",
        );
    }
    let mut parts = cut.parts.into_iter();
    let mut list = Vec::with_capacity(pieces);
    for piece in 0..pieces {
        // Borders that rounding has made equal leave nothing between them.
        let empty = 0 < piece && piece < offsets.len() && offsets[piece] == offsets[piece - 1];
        list.push(if empty { None } else { parts.next().flatten() });
    }
    list
}
