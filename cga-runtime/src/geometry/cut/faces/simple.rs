//! Faces that rise once and fall once: triangles, convex faces, and most others.
//!
//! Such a loop meets each plane at one point on its way up and one on its way down, so each slab gets one piece, and no
//! geometric test is needed. A way that runs along a plane in between is left to [`super::general`].

use std::ops::Range;

use crate::geometry::cut::caps::rim::PlaneSide;
use crate::geometry::cut::class::{Class, Span};
use crate::geometry::cut::faces::first_edge::{first_node, first_node_of_band};
use crate::geometry::cut::points::{Location, PieceCorner};
use crate::geometry::cut::state::State;
use crate::geometry::mesh::{FaceTag, Mesh};

/// Buffers.
#[derive(Default)]
pub(crate) struct Simple {
    /// The way up, with all nodes at the lowest and the highest level.
    up: Vec<PieceCorner>,
    /// The way down, from the top.
    down: Vec<PieceCorner>,
}

impl Simple {
    /// Cuts a face with one loop into its slabs. Returns `false`, without any change, if the face is not of this kind.
    /// `places` are the places of its corners, and `span` is their span.
    pub(crate) fn clip(
        &mut self,
        state: &mut State,
        mesh: &Mesh,
        tag: FaceTag,
        corners: Range<usize>,
        places: &[Location],
        span: Span,
    ) -> bool {
        if !self.walk(state, mesh, corners.clone(), places, span) {
            return false;
        }
        let (mut up, mut down) = (0, self.down.len());
        let State { parts, points, rim, .. } = state;
        for slab in span.slabs() {
            let ceiling = Class::on(slab);
            let up_start = up;
            while up < self.up.len() && self.up[up].class() <= ceiling {
                up += 1;
            }
            let mut down_start = down;
            while down_start > 0 && self.down[down_start - 1].class() <= ceiling {
                down_start -= 1;
            }
            let ahead = &self.up[up_start..up];
            let mut back = &self.down[down_start..down];
            down = down_start;
            let cut = up < self.up.len();
            if cut {
                // Both ways have a node on the upper plane, and the next slab begins with it.
                let (left, right) = (self.up[up - 1], self.down[down_start]);
                up -= 1;
                down += 1;
                if left.place == right.place {
                    back = &back[1..];
                } else {
                    rim.cut(slab, left.place.number, right.place.number);
                }
            }
            // If the loop meets itself on a plane, the same corner must not follow itself.
            if back.last().is_some_and(|last| last.place == ahead[0].place) {
                back = &back[..back.len() - 1];
            }
            let part = &mut parts[slab as usize];
            if ahead.len() + back.len() < 3 {
                part.dropped = true;
                continue;
            }
            let first = match (ahead, back) {
                ([a, b], [c, d]) if a.is_on_edge_of(b) && c.is_on_edge_of(d) => first_node_of_band([a, c], &corners),
                _ => first_node(ahead.iter().chain(back), &corners),
            };
            let runs = match first.checked_sub(ahead.len()) {
                None => [&ahead[first..], back, &ahead[..first]],
                Some(first) => [&back[first..], ahead, &back[..first]],
            };
            for run in runs {
                part.corners(points, mesh, run, slab);
            }
            part.end_loop();
            part.end_face(tag);
        }
        // Edges along the lowest and the highest plane are on the way up.
        for (level, side) in [(span.low, PlaneSide::Above), (span.high, PlaneSide::Below)] {
            if level.is_on_plane() {
                for pair in self.up.windows(2).filter(|pair| pair[0].class() == level && pair[1].class() == level) {
                    rim.edge(level.plane(), pair[0].place.number, pair[1].place.number, side);
                }
            }
        }
        true
    }

    /// Fills both ways. Returns `false` if the loop is not of this kind.
    fn walk(&mut self, state: &mut State, mesh: &Mesh, corners: Range<usize>, places: &[Location], span: Span) -> bool {
        // Checks the way by classes alone first, because crossings are never removed.
        if places.len() > 3 && !is_simple(places.iter().map(|place| place.class), span) {
            return false;
        }
        self.up.clear();
        self.down.clear();
        let count = places.len();
        let after = |i: usize| if i + 1 == count { 0 } else { i + 1 };
        let node = |i: usize| PieceCorner::corner(corners.start + i, places[i]);
        let mut before = places[count - 1].class;
        let Some(start) = places
            .iter()
            .position(|place| std::mem::replace(&mut before, place.class) != span.low && place.class == span.low)
        else {
            return false;
        };
        let mut here = start;
        loop {
            self.up.push(node(here));
            let next = after(here);
            if places[here].class == span.high && places[next].class != span.high {
                break;
            }
            let [a, b] = [here, next].map(|i| (corners.start + i, places[i]));
            state.points.cross(&mut state.parts, mesh, a, b, &mut self.up);
            here = next;
        }
        loop {
            let next = after(here);
            let [a, b] = [here, next].map(|i| (corners.start + i, places[i]));
            state.points.cross(&mut state.parts, mesh, a, b, &mut self.down);
            if next == start {
                return true;
            }
            self.down.push(node(next));
            here = next;
        }
    }
}

/// Returns true if a cycle of classes rises once and falls once, without running along a plane in between.
fn is_simple(classes: impl Iterator<Item = Class> + Clone, span: Span) -> bool {
    let mut turns = 0;
    let mut rising = None;
    let mut last = None;
    for class in classes.clone().chain(classes) {
        if let Some(last) = last {
            if class == last {
                if class.is_on_plane() && class != span.low && class != span.high {
                    return false;
                }
            } else {
                let now = class > last;
                if rising.is_some_and(|rising| rising != now) {
                    turns += 1;
                }
                rising = Some(now);
            }
        }
        last = Some(class);
    }
    // Two rounds: four turns, or three if the start is between two turns.
    turns <= 4
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_rise_and_one_fall_are_simple() {
        let simple = |classes: &[Class]| is_simple(classes.iter().copied(), Span::of(classes.iter().copied()));
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
