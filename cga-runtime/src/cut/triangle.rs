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
    let at = |turn: usize| (lone + turn) % 3;
    let [l, m, n] = [at(0), at(1), at(2)].map(|corner| (corners.start + corner, places[corner]));
    let x = state.points.crossing(&mut state.parts, mesh, plane, l.0, m.0);
    let y = state.points.crossing(&mut state.parts, mesh, plane, n.0, l.0);
    let is_below = l.1.class / 2 == plane;
    let (below_start, below_end) = if is_below { (x, y) } else { (y, x) };
    state.rim.cut(plane, below_start.place.number, below_end.place.number);
    let [l, m, n] = [l, m, n].map(|(corner, place)| Node::corner(corner, place));
    // The first edge is l m, n l or m n.
    let (one, other) = match lone {
        0 => ([l, x, y], [x, m, n, y]),
        1 => ([y, l, x], [n, y, x, m]),
        _ => ([x, y, l], [m, n, y, x]),
    };
    let (one_slab, other_slab) = if is_below { (plane, plane + 1) } else { (plane + 1, plane) };
    state.parts[one_slab as usize].face(&mut state.points, mesh, tag, &one, one_slab);
    state.parts[other_slab as usize].face(&mut state.points, mesh, tag, &other, other_slab);
}
