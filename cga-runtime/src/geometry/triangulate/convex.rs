//! Fans of convex polygons.

use glam::DVec2;

use crate::geometry::exact::orient;

/// Appends a fan if the loop is convex and a fan has no triangle without area. Returns whether it did.
pub(super) fn fan(points: &[DVec2], out: &mut Vec<[u32; 3]>) -> bool {
    let count = points.len();
    if count == 3 {
        out.push([0, 1, 2]);
        return true;
    }
    // A convex loop never turns right, and it changes from right to left and back only once.
    let mut apex = None;
    let mut turns = 0;
    let (mut previous, mut here) = (points[count - 2], points[count - 1]);
    let mut heading = direction(previous, here);
    let mut last_corner = false;
    let mut run = 0;
    let mut collinear = false;
    for (i, &next) in points.iter().enumerate() {
        let side = orient(previous, here, next);
        if side < 0 || here == next {
            return false;
        }
        let now = direction(here, next);
        if now != heading {
            turns += 1;
            heading = now;
        }
        if side == 0 {
            if (here - previous).dot(next - here) < 0.0 {
                return false;
            }
            collinear = true;
        }
        // A fan may start at a corner if both its neighbours are proper corners.
        run = if side > 0 { run + 1 } else { 0 };
        if run >= 3 && apex.is_none() {
            apex = Some((i + count - 2) % count);
        }
        last_corner |= side > 0;
        (previous, here) = (here, next);
    }
    if turns > 2 || !last_corner {
        return false;
    }
    let apex = if collinear {
        match apex {
            Some(apex) => apex as u32,
            None => return false,
        }
    } else {
        0
    };
    let count = count as u32;
    let at = |k: u32| if apex + k >= count { apex + k - count } else { apex + k };
    out.extend((1..count - 1).map(|k| [apex, at(k), at(k + 1)]));
    true
}

/// Returns true if an edge points right, or straight up.
fn direction(a: DVec2, b: DVec2) -> bool {
    a.x < b.x || (a.x == b.x && a.y < b.y)
}
