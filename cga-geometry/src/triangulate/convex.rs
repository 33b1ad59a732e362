//! Convex loops and their fans.

use glam::DVec2;

use crate::exact::{comes_first, orient};

/// Appends a fan if the loop is convex and a fan has no triangle without area. Returns whether it did.
pub(super) fn fan(points: &[DVec2], out: &mut Vec<[u32; 3]>) -> bool {
    let count = points.len() as u32;
    if count == 3 {
        out.push([0, 1, 2]);
        return true;
    }
    let Some(Some(apex)) = apex(points.len(), |i| points[i]) else { return false };
    let apex = apex as u32;
    let at = |k: u32| if apex + k >= count { apex + k - count } else { apex + k };
    out.extend((1..count - 1).map(|k| [apex, at(k), at(k + 1)]));
    true
}

/// Where the fan of a convex loop may start, if anywhere. `None` for a loop that is not convex. Straight corners are
/// allowed.
#[inline]
pub(crate) fn apex(count: usize, at: impl Fn(usize) -> DVec2) -> Option<Option<usize>> {
    // A convex loop never turns right, and it changes from right to left and back only once.
    let mut apex = None;
    let mut turns = 0;
    let (mut previous, mut here) = (at(count - 2), at(count - 1));
    let mut heading = comes_first(previous, here);
    let (mut has_corner, mut is_straight) = (false, false);
    let mut run = 0;
    for i in 0..count {
        let next = at(i);
        let side = orient(previous, here, next);
        if side < 0 || here == next || (side == 0 && (here - previous).dot(next - here) < 0.0) {
            return None;
        }
        let now = comes_first(here, next);
        turns += usize::from(now != heading);
        heading = now;
        // A fan may start at a corner if both its neighbours are proper corners.
        run = if side > 0 { run + 1 } else { 0 };
        if run >= 3 && apex.is_none() {
            apex = Some((i + count - 2) % count);
        }
        has_corner |= side > 0;
        is_straight |= side == 0;
        (previous, here) = (here, next);
    }
    (turns <= 2 && has_corner).then_some(if is_straight { apex } else { Some(0) })
}
