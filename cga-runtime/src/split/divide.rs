//! The split operations, as rules call them.

use std::ops::ControlFlow;

use super::area::Profile;
use super::parts::{Parts, Row, within_limit};
use super::{Adjust, Item, Piece, Prefix, Size, solve};
use crate::derive::Cx;
use crate::env::Env;
use crate::scope::Axis;
use crate::shape::ShapeRef;
use crate::sink::{Flow, Sink};

/// Splits a shape and calls `visit` with every part's slot and shape, from the low end to the high end. Says whether the
/// shape was divided: one too small to be split, or flat along the axis, stays as it is, which makes it a leaf
/// (*Subdivision split*: recursion stops at small geometry).
#[inline]
pub fn split<S: Sink + ?Sized, C, const N: usize>(
    cx: &mut Cx<'_, S, C>,
    shape: &mut ShapeRef<'_>,
    how: (Axis, Adjust),
    pattern: &[Item],
    mut sizes: [Size; N],
    visit: impl FnMut(&mut Cx<'_, S, C>, u32, &mut ShapeRef<'_>) -> Flow,
) -> ControlFlow<(), bool> {
    check(&mut cx.env, &mut sizes, "a size of `split`");
    let mut lengths = [0.0; N];
    let solution = solve(pattern, &sizes, &mut lengths, extent(&cx.env, shape, how.0));
    hand_out(cx, shape, how, &solution, visit)
}

/// As [`split`], where the macro knows the extent and has solved the split.
#[inline]
pub fn split_solved<S: Sink + ?Sized, C>(
    cx: &mut Cx<'_, S, C>,
    shape: &mut ShapeRef<'_>,
    how: (Axis, Adjust),
    solved: f64,
    pieces: &'static [Piece],
    visit: impl FnMut(&mut Cx<'_, S, C>, u32, &mut ShapeRef<'_>) -> Flow,
) -> ControlFlow<(), bool> {
    debug_assert_eq!(shape.scope.extent(how.0).abs(), solved, "the macro knows the extent");
    let pieces = if extent(&cx.env, shape, how.0) == 0.0 { &[] } else { pieces };
    hand_out(cx, shape, how, pieces, visit)
}

/// Splits a shape into parts of given areas (*splitArea operation*). What lies across the axis has no extent along it and
/// does not count, so of a box, which the reference does not speak of, shares are those of its four sides along the axis.
/// Caps that a cut makes do not count either. Otherwise as [`split`].
pub fn split_area<S: Sink + ?Sized, C, const N: usize>(
    cx: &mut Cx<'_, S, C>,
    shape: &mut ShapeRef<'_>,
    how: (Axis, Adjust),
    pattern: &[Item],
    mut sizes: [Size; N],
    visit: impl FnMut(&mut Cx<'_, S, C>, u32, &mut ShapeRef<'_>) -> Flow,
) -> ControlFlow<(), bool> {
    check(&mut cx.env, &mut sizes, "an area of `splitArea`");
    let mut lengths = [0.0; N];
    let extent = extent(&cx.env, shape, how.0);
    let profile = Profile::new(shape, how.0);
    if extent == 0.0 || profile.total() <= 0.0 {
        return ControlFlow::Continue(false);
    }
    if let Profile::Even(area) = profile {
        // The same area everywhere along the axis: areas are lengths.
        for size in sizes.iter_mut().filter(|size| size.prefix != Prefix::Relative) {
            size.value *= extent / area;
        }
        let solution = solve(pattern, &sizes, &mut lengths, extent);
        return hand_out(cx, shape, how, &solution, visit);
    }
    let solution = solve(pattern, &sizes, &mut lengths, profile.total());
    within_limit(&mut cx.env, &solution)?;
    let mut pieces = Vec::new();
    let mut start = 0.0;
    let _ = solution.each(|piece| {
        let end = profile.distance(piece.end, extent);
        // An area may be too small to be told from none.
        if start < end {
            pieces.push(Piece { slot: piece.slot, start, end, length: end - start });
            start = end;
        }
        Flow::Continue(())
    });
    hand_out(cx, shape, how, pieces.as_slice(), visit)
}

/// Numbers that are none become zero, with a fault.
#[inline]
fn check(env: &mut Env, sizes: &mut [Size], what: &'static str) {
    for size in sizes {
        size.value = env.finite(size.value, what);
    }
}

/// The extent to split: zero when there is nothing to divide, or too little.
#[inline]
fn extent(env: &Env, shape: &ShapeRef<'_>, axis: Axis) -> f64 {
    let extent = shape.scope.extent(axis).abs();
    if env.too_small < extent { extent } else { 0.0 }
}

#[inline]
fn hand_out<S: Sink + ?Sized, C>(
    cx: &mut Cx<'_, S, C>,
    shape: &mut ShapeRef<'_>,
    (axis, adjust): (Axis, Adjust),
    row: &(impl Row + ?Sized),
    mut visit: impl FnMut(&mut Cx<'_, S, C>, u32, &mut ShapeRef<'_>) -> Flow,
) -> ControlFlow<(), bool> {
    let mut parts = Parts::new(&mut cx.env, shape, axis, adjust, row)?;
    row.each(|piece| visit(cx, piece.slot, &mut parts.next(piece)))?;
    ControlFlow::Continue(0 < parts.total())
}
