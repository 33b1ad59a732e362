//! The pieces of a split: checks sizes, and turns areas into lengths.

use cga_split::{Item, Piece, Prefix, Size, Solution, solve};

use super::area::Profile;
use super::parts::within_limit;
use crate::geometry::Axis;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::ShapeRef;

/// Sets NaN and infinite sizes to zero, with a fault.
#[inline]
pub(super) fn check(env: &mut Env, sizes: &mut [Size], what: &'static str) {
    for size in sizes {
        size.value = env.finite(size.value, what);
    }
}

/// The extent to split: zero if it is too small.
#[inline]
pub fn extent(env: &mut Env, shape: &ShapeRef<'_>, axis: Axis) -> f64 {
    let extent = shape.size.along(axis).abs();
    if extent < env.least_split {
        env.least_split = extent;
    }
    if env.too_small < extent { extent } else { 0.0 }
}

/// The pieces of a split that the macro has solved; empty if the shape is too small to be split.
#[inline]
pub(super) fn solved<'p>(
    env: &mut Env,
    shape: &ShapeRef<'_>,
    axis: Axis,
    known: f64,
    pieces: &'p [Piece],
) -> &'p [Piece] {
    debug_assert_eq!(shape.size.along(axis).abs(), known, "the macro knows the extent");
    if extent(env, shape, axis) == 0.0 { &[] } else { pieces }
}

/// The pieces of given areas (*splitArea operation*). A face across the axis has no extent along it and does not
/// count. So the areas of a box, which the reference does not mention, are the areas of its four sides along the axis.
/// Caps of cuts do not count either.
pub(super) fn areas(
    env: &mut Env,
    shape: &ShapeRef<'_>,
    axis: Axis,
    pattern: &[Item],
    sizes: &mut [Size],
    lengths: &mut [f64],
) -> Vec<Piece> {
    check(env, sizes, "an area of `splitArea`");
    let extent = extent(env, shape, axis);
    let profile = Profile::new(&env.whole(shape), axis);
    if extent == 0.0 || profile.total() <= 0.0 {
        return Vec::new();
    }
    if let Profile::Even(area) = profile {
        // The area is evenly distributed along the axis, so areas are proportional to lengths.
        for size in sizes.iter_mut().filter(|size| size.prefix != Prefix::Relative) {
            size.value *= extent / area;
        }
        return listed(env, &solve(pattern, sizes, lengths, extent));
    }
    let mut pieces = listed(env, &solve(pattern, sizes, lengths, profile.total()));
    let mut start = 0.0;
    pieces.retain_mut(|piece| {
        let end = profile.distance(piece.end, extent);
        // An area may be too small to be distinguished from zero.
        let is_piece = start < end;
        if is_piece {
            (piece.start, piece.end, piece.length) = (start, end, end - start);
            start = end;
        }
        is_piece
    });
    pieces
}

/// The pieces of a solution; empty if there are too many, which ends the run.
pub(super) fn listed(env: &mut Env, solution: &Solution<'_>) -> Vec<Piece> {
    let within: Flow = within_limit(env, solution);
    if within.is_continue() { solution.pieces() } else { Vec::new() }
}
