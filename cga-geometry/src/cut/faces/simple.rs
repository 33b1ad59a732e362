//! Faces that rise once and fall once: triangles, convex faces, and most others.
//!
//! Such a loop meets each plane at one point on its way up and one on its way down, so each slab gets one piece, and no
//! geometric test is needed. A way that runs along a plane in between is left to [`super::general`].

use std::ops::Range;

use super::chain::{Chain, rises_once, runs};
use crate::cut::caps::rim::PlaneSide;
use crate::cut::class::{Class, ClassRange};
use crate::cut::points::{Location, PieceCorner};
use crate::cut::state::CutState;
use crate::mesh::{FaceTag, Mesh};

/// Cuts a face with one loop into its slabs. Returns `false`, without any change, if the face is not of this kind.
/// `places` are the places of its corners, and `span` is their span.
pub(crate) fn clip(
    chain: &mut Chain,
    state: &mut CutState,
    mesh: &Mesh,
    tag: FaceTag,
    corners: Range<usize>,
    places: &[Location],
    span: ClassRange,
) -> bool {
    // Checks the way by classes alone first, because crossings are never removed.
    if places.len() > 3 && !is_simple(places.iter().map(|place| place.class), span) {
        return false;
    }
    let CutState { parts, points, rim, .. } = state;
    let node = |i: usize| PieceCorner::corner(corners.start + i, places[i]);
    chain.walk(places.len(), span, node, |from, to, nodes| points.cross(parts, mesh, from, to, nodes));
    chain.pieces(span, |slab, ahead, back, borders| {
        if borders.upper {
            let [left, right] = [ahead[ahead.len() - 1].place, back[0].place];
            if left != right {
                rim.cut(slab, left.number, right.number);
            }
        }
        let part = &mut parts[slab as usize];
        let Some(runs) = runs(ahead, back, &corners) else {
            part.dropped = true;
            return;
        };
        for run in runs {
            part.corners(points, mesh, run, slab);
        }
        part.mesh.end_loop();
        part.mesh.end_face(tag);
    });
    // Edges along the lowest and the highest plane are on the way up.
    for (level, side) in [(span.low, PlaneSide::Above), (span.high, PlaneSide::Below)] {
        if level.is_on_plane() {
            for pair in chain.up().windows(2).filter(|pair| pair[0].class() == level && pair[1].class() == level) {
                rim.edge(level.plane(), pair[0].place.number, pair[1].place.number, side);
            }
        }
    }
    true
}

/// Returns true if a cycle of classes rises once and falls once, without running along a plane in between.
fn is_simple(classes: impl DoubleEndedIterator<Item = Class> + Clone, span: ClassRange) -> bool {
    rises_once(classes, |class| !class.is_on_plane() || class == span.low || class == span.high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_rise_and_one_fall_are_simple() {
        let simple = |classes: &[Class]| is_simple(classes.iter().copied(), ClassRange::of(classes.iter().copied()));
        let slabs = |slabs: &[u32]| simple(&slabs.iter().map(|&slab| Class::inside(slab)).collect::<Vec<_>>());
        assert!(slabs(&[0, 1, 2]));
        assert!(slabs(&[2, 0, 1]));
        assert!(slabs(&[0, 0, 1, 1, 2, 1]));
        assert!(!slabs(&[0, 1, 0, 1]));
        let (inside, on) = (Class::inside, Class::on);
        assert!(simple(&[on(0), on(0), on(1), on(2), on(2), on(1)]));
        assert!(!simple(&[inside(0), on(1), on(1), inside(2), inside(1)]));
        assert!(!simple(&[inside(0), inside(2), on(0), inside(2)]));
    }
}
