//! The points at which holes are tested.

use glam::DVec2;

use crate::exact::orient;
use crate::small_sort::SmallSort;

/// A point so close to a place that no edge goes through it, even if an edge goes through the place.
pub(crate) struct Probe {
    /// The place. The point is off it by ε to the left of `ahead`, and by ε² in the direction of `ahead`.
    pub(super) at: DVec2,
    ahead: DVec2,
}

impl Probe {
    /// A point beside the middle of a ring's longest edge, to its left or its right.
    pub(crate) fn beside(ring: &[u32], to_the_right: bool, flat: impl Fn(u32) -> DVec2) -> Self {
        let at = |i: usize| flat(ring[i % ring.len()]);
        let length = |i: usize| at(i).distance_squared(at(i + 1));
        let longest = (0..ring.len()).max_by(|&i, &j| length(i).total_cmp(&length(j))).unwrap_or(0);
        let (a, b) = (at(longest), at(longest + 1));
        let ahead = b * 0.5 - a * 0.5;
        Probe { at: a * 0.5 + b * 0.5, ahead: if to_the_right { -ahead } else { ahead } }
    }

    /// A point well inside a ring: in the middle of the widest chord at the middle of the widest gap between heights of
    /// corners. `None` for a ring without an interior.
    pub(crate) fn inside(ring: &[u32], flat: impl Fn(u32) -> DVec2) -> Option<Self> {
        let corners: Vec<DVec2> = ring.iter().map(|&corner| flat(corner)).collect();
        let mut heights: Vec<f64> = corners.iter().map(|p| p.y).collect();
        heights.small_sort_by(f64::total_cmp);
        let gap = |pair: &&[f64]| pair[1] * 0.5 - pair[0] * 0.5;
        let widest = heights.windows(2).max_by(|a, b| gap(a).total_cmp(&gap(b)))?;
        let level = widest[0] * 0.5 + widest[1] * 0.5;
        // The crossings of edges with that height, with their directions: 1 up, -1 down.
        let mut met: Vec<(f64, i32)> = Vec::new();
        let mut a = corners[corners.len() - 1];
        for &b in &corners {
            let up = i32::from(a.y <= level) - i32::from(b.y <= level);
            if up != 0 {
                let share = (level * 0.5 - a.y * 0.5) / (b.y * 0.5 - a.y * 0.5);
                met.push((a.x * (1.0 - share) + b.x * share, up));
            }
            a = b;
        }
        met.small_sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut turns = 0;
        let mut best: Option<(f64, f64)> = None;
        for pair in met.windows(2) {
            turns += pair[0].1;
            let width = pair[1].0 * 0.5 - pair[0].0 * 0.5;
            if turns != 0 && best.is_none_or(|(widest, _)| widest < width) {
                best = Some((width, pair[0].0 * 0.5 + pair[1].0 * 0.5));
            }
        }
        best.map(|(_, middle)| Probe { at: DVec2::new(middle, level), ahead: DVec2::X })
    }

    /// The contribution of a path between two points far to the right: 1 upwards past the point, -1 downwards.
    pub(crate) fn rise(&self, from: DVec2, to: DVec2) -> i32 {
        i32::from(self.is_above(from)) - i32::from(self.is_above(to))
    }

    /// Returns true if the point is above another point.
    fn is_above(&self, p: DVec2) -> bool {
        let rise = if self.ahead.x != 0.0 { self.ahead.x } else { self.ahead.y };
        p.y < self.at.y || (p.y == self.at.y && 0.0 < rise)
    }

    /// The contribution of an edge to the winding number: 1 if a ray to the right meets it on its way up, -1 on its way
    /// down.
    pub(crate) fn turn(&self, a: DVec2, b: DVec2) -> i32 {
        let (up, down) = (self.is_above(a) && !self.is_above(b), self.is_above(b) && !self.is_above(a));
        if !up && !down {
            return 0;
        }
        let mut side = orient(a, b, self.at);
        if side == 0 {
            let along = b * 0.5 - a * 0.5;
            let (left, ahead) = (along.dot(self.ahead), along.perp_dot(self.ahead));
            side = if left != 0.0 { left.signum() as i32 } else { ahead.signum() as i32 };
        }
        i32::from(up && side > 0) - i32::from(down && side < 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_inside_a_ring_is_well_inside() {
        let inside = |ring: &[[f64; 2]]| {
            let corners: Vec<u32> = (0..ring.len() as u32).collect();
            Probe::inside(&corners, |corner| DVec2::from(ring[corner as usize])).map(|probe| probe.at.to_array())
        };
        assert_eq!(inside(&[[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]]), Some([2.0, 1.0]));
        // A U: the point is in the wider of its arms.
        let u = [[0.0, 0.0], [9.0, 0.0], [9.0, 8.0], [4.0, 8.0], [4.0, 1.0], [3.0, 1.0], [3.0, 8.0], [0.0, 8.0]];
        assert_eq!(inside(&u), Some([6.5, 4.5]));
        assert_eq!(inside(&[[0.0, 1.0], [4.0, 1.0], [2.0, 1.0]]), None);
    }
}
