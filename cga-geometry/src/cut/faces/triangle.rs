//! Triangles that one plane cuts without going through a corner: nearly all cut faces of most meshes.
//!
//! Corner `l` is alone on its side, and `m` and `n` are the next corners. The plane meets `l m` at `x` and `n l` at
//! `y`. The tip is `l x y` and the rest is `x m n y`, both rotated to begin with the remaining part of the first edge,
//! as defined in [`crate::cut::faces::first_edge`]. The three corners are different points, as in every mesh.

use std::ops::Range;

use crate::cut::points::{Location, PieceCorner};
use crate::cut::state::CutState;
use crate::mesh::{FaceTag, Mesh};

/// Cuts a triangle by the plane between its two slabs. The corner with number `lone` is alone on its side.
pub(crate) fn clip(
    state: &mut CutState,
    mesh: &Mesh,
    tag: FaceTag,
    corners: Range<usize>,
    places: [Location; 3],
    plane: u32,
    lone: usize,
) {
    let CutState { points, parts, rim, .. } = state;
    let corner = |at: usize| {
        let at = if at < 3 { at } else { at - 3 };
        PieceCorner::corner(corners.start + at, places[at])
    };
    let [l, m, n] = [corner(lone), corner(lone + 1), corner(lone + 2)];
    let x = points.crossing(parts, mesh, plane, l.from, m.from);
    let y = points.crossing(parts, mesh, plane, n.from, l.from);
    let tip_is_below = l.place.class.slab() == plane;
    let (from, to) = if tip_is_below { (x, y) } else { (y, x) };
    rim.cut(plane, from.place.number, to.place.number);
    let (tip_side, rest_side) = if tip_is_below { (0, 1) } else { (1, 0) };
    let (tip, rest) = (plane as usize + tip_side, plane as usize + rest_side);
    // Numbers in the slab of the piece.
    let inside = [l.place.number, m.place.number, n.place.number];
    let level = &points.levels[plane as usize];
    let (at_x, at_y) = (level.numbers[x.place.number as usize], level.numbers[y.place.number as usize]);
    let (on_tip, on_rest) = ([at_x[tip_side], at_y[tip_side]], [at_x[rest_side], at_y[rest_side]]);
    let (tip_numbers, rest_numbers) = pieces(lone, inside, on_tip, on_rest);
    parts[tip].piece(tag, tip_numbers);
    parts[rest].piece(tag, rest_numbers);
    if points.mixes {
        let (tip_nodes, rest_nodes) = pieces(lone, [l, m, n], [x, y], [x, y]);
        parts[tip].carry(points, mesh, &tip_nodes);
        parts[rest].carry(points, mesh, &rest_nodes);
    }
}

/// The corners of the tip and the rest, rotated to begin with the first edge of the triangle, which is l m, n l or m n.
#[inline(always)]
fn pieces<T>(lone: usize, [l, m, n]: [T; 3], [tip_x, tip_y]: [T; 2], [rest_x, rest_y]: [T; 2]) -> ([T; 3], [T; 4]) {
    match lone {
        0 => ([l, tip_x, tip_y], [rest_x, m, n, rest_y]),
        1 => ([tip_y, l, tip_x], [n, rest_y, rest_x, m]),
        _ => ([tip_x, tip_y, l], [m, n, rest_y, rest_x]),
    }
}
