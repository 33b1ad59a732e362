//! Triangles that one plane cuts in two without going through a corner: nearly all cut faces of most meshes.
//!
//! The corner that is alone on its side is `l`, the next ones are `m` and `n`; the plane meets `l m` in `x` and `n l` in `y`. The
//! pieces are `l x y` and `x m n y`, turned so that they begin with what is left of the first edge, as [`super::first`] has it. The three
//! corners are different points, as in every mesh.

use std::ops::Range;

use super::points::{Node, Place};
use super::state::State;
use crate::mesh::{FaceTag, Mesh};

/// Cuts a triangle by the plane between its two slabs; the corner with number `lone` is alone on its side.
pub(super) fn clip(
    state: &mut State,
    mesh: &Mesh,
    tag: FaceTag,
    corners: Range<usize>,
    places: [Place; 3],
    plane: u32,
    lone: usize,
) {
    let State { points, parts, rim, .. } = state;
    let corner = |at: usize| {
        let at = if at < 3 { at } else { at - 3 };
        Node::corner(corners.start + at, places[at])
    };
    let [l, m, n] = [corner(lone), corner(lone + 1), corner(lone + 2)];
    let x = points.crossing(parts, mesh, plane, l.from as usize, m.from as usize);
    let y = points.crossing(parts, mesh, plane, n.from as usize, l.from as usize);
    let is_below = l.place.class / 2 == plane;
    let (from, to) = if is_below { (x, y) } else { (y, x) };
    rim.cut(plane, from.place.number, to.place.number);
    // With their numbers on the side of l, and on the other.
    let numbers = |node: Node| points.levels[plane as usize].numbers[node.place.number as usize];
    let (one_side, other_side) = if is_below { (0, 1) } else { (1, 0) };
    let ([x_numbers, y_numbers], own) = ([numbers(x), numbers(y)], |node: Node| (node, node.place.number));
    let (l, m, n) = (own(l), own(m), own(n));
    let [x, other_x] = [one_side, other_side].map(|side| (x, x_numbers[side]));
    let [y, other_y] = [one_side, other_side].map(|side| (y, y_numbers[side]));
    // The first edge is l m, n l or m n.
    let (one, other) = match lone {
        0 => ([l, x, y], [other_x, m, n, other_y]),
        1 => ([y, l, x], [n, other_y, other_x, m]),
        _ => ([x, y, l], [m, n, other_y, other_x]),
    };
    parts[plane as usize + one_side].face(points, mesh, tag, one);
    parts[plane as usize + other_side].face(points, mesh, tag, other);
}
