//! Triangulation of polygons with holes.
//!
//! Triangles use only the corners of the polygon, have its orientation, and together have its outline as their rim:
//! each edge of each loop belongs to exactly one triangle, collinear corners included. So a closed mesh gives closed
//! triangles. With `n` corners and `h` holes there are `n + 2h − 2` triangles, unless loops touch.
//!
//! Convex polygons become fans. The others are swept (`sweep.rs`) in time proportional to `n log n`. Triangles that the
//! sweep reverses, where loops cross, are repaired where possible (`unfold.rs`). If no correct triangulation exists,
//! the result still has every edge of the loops once, and the signed area. Nothing here panics, and the same input
//! gives the same triangles.

mod cap;
mod convex;
mod filled;
mod highest;
mod sweep;
mod unfold;

use std::ops::Range;

use glam::{DVec2, DVec3};

use crate::each::Each;
use crate::nesting::extent::Extent;
use crate::tol::TOUCH_EPSILON;
use cap::Cap;
pub(crate) use convex::{apex, is_surely_convex};
pub(crate) use filled::{doubled_area, filling, is_filled};
pub(crate) use highest::highest;
use sweep::MonotoneSweep;
use unfold::Unfold;

/// The two coordinates that remain when a face is projected, in an order that keeps counter-clockwise loops
/// counter-clockwise. The projection drops one coordinate without arithmetic, so collinear points stay exactly
/// collinear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlaneProjection {
    u: usize,
    v: usize,
}

impl PlaneProjection {
    /// Drops the coordinate with the largest component of the normal.
    pub fn along(normal: DVec3) -> Self {
        let size = normal.abs();
        let axis = if size.x >= size.y && size.x >= size.z {
            0
        } else if size.y >= size.z {
            1
        } else {
            2
        };
        PlaneProjection::without(axis, normal)
    }

    /// Keeps a coordinate, unless the projection would be very thin: drops the one of the other two with the larger
    /// component of the normal.
    pub(crate) fn keeping(kept: usize, normal: DVec3) -> Self {
        const LEAST: f64 = 0.25;
        let (u, v) = ((kept + 1) % 3, (kept + 2) % 3);
        let axis = if normal[u].abs() >= normal[v].abs() { u } else { v };
        if normal[axis].abs() < LEAST * normal[kept].abs() {
            return PlaneProjection::along(normal);
        }
        PlaneProjection::without(axis, normal)
    }

    fn without(axis: usize, normal: DVec3) -> Self {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        if normal[axis] < 0.0 { PlaneProjection { u: v, v: u } } else { PlaneProjection { u, v } }
    }

    /// The place of a point in the plane.
    #[inline]
    pub fn apply(self, p: DVec3) -> DVec2 {
        DVec2::new(p[self.u], p[self.v])
    }
}

/// A triangulator of faces, which reuses its buffers.
#[derive(Default)]
pub struct Triangulator {
    flat: Vec<DVec2>,
    ends: Vec<u32>,
    cap: Cap,
    sweep: MonotoneSweep,
    unfold: Unfold,
}

impl std::fmt::Debug for Triangulator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Triangulator").finish_non_exhaustive()
    }
}

impl Triangulator {
    /// A triangulator with empty buffers.
    pub fn new() -> Self {
        Self::default()
    }

    /// Appends the triangles of a planar polygon in space, whose corners have consecutive numbers, as these numbers. With a normal it is
    /// seen along it; without one it is a cap, and the caps on both sides of a cut have the same triangles, reversed.
    pub(crate) fn polygon_in_space(
        &mut self,
        loops: impl Iterator<Item = Range<usize>> + Clone,
        place: impl Fn(usize) -> DVec3,
        normal: Option<DVec3>,
        out: &mut Vec<[u32; 3]>,
    ) {
        let mut flat = std::mem::take(&mut self.flat);
        let mut ends = std::mem::take(&mut self.ends);
        let start = loops.clone().next().map_or(0, |ring| ring.start);
        flat.clear();
        ends.clear();
        ends.extend(loops.clone().map(|ring| (ring.end - start) as u32));
        let from = out.len();
        if let Some(normal) = normal {
            let projection = PlaneProjection::along(normal);
            flat.extend(loops.flatten().map(|corner| projection.apply(place(corner))));
            self.polygon(&flat, &ends, out);
            out[from..].iter_mut().flatten().for_each(|corner| *corner += start as u32);
        } else {
            let mut cap = std::mem::take(&mut self.cap);
            cap.read(loops, place);
            let projection = PlaneProjection::along(cap.normal(&ends));
            flat.extend(cap.points.iter().map(|&point| projection.apply(point)));
            self.polygon(&flat, &ends, out);
            out[from..].iter_mut().for_each(|t| *t = cap.triangle(*t));
            self.cap = cap;
        }
        (self.flat, self.ends) = (flat, ends);
    }

    /// Appends the triangles of a polygon as indices of its points. Points are given loop by loop, the outline
    /// counter-clockwise, holes clockwise; `loop_ends` are the ends of the loops. No triangles if a coordinate is not
    /// finite.
    pub fn polygon(&mut self, points: &[DVec2], loop_ends: &[u32], out: &mut Vec<[u32; 3]>) {
        let count = points.len();
        let rises = loop_ends.windows(2).all(|w| w[0] <= w[1]);
        if !rises || loop_ends.last().copied() != Some(count as u32) || count < 3 {
            return;
        }
        if !points.iter().all(|p| p.is_finite()) {
            return;
        }
        if loop_ends.len() == 1 && convex::fan(points, out) {
            return;
        }
        let from = out.len();
        self.sweep.triangulate(points, loop_ends, 0.0, out);
        let folded = turned_over(points, &out[from..]);
        if 0.0 < folded {
            self.repair(points, loop_ends, folded, from, out);
        }
    }

    /// Reduces the area of reversed triangles.
    #[cold]
    fn repair(&mut self, points: &[DVec2], loop_ends: &[u32], folded: f64, from: usize, out: &mut Vec<[u32; 3]>) {
        let Extent { low, high } = Extent::of(points.iter().copied());
        let extent = (high - low).max_element();
        if TOUCH_EPSILON * extent * extent < folded {
            self.once_more(points, loop_ends, TOUCH_EPSILON * extent, folded, from, out);
        }
        self.unfold.repair(points, loop_ends.len(), out, from);
    }

    /// Loops that cross by a rounding error should only touch. Slack or another direction of the sweep may reduce the
    /// reversed area.
    fn once_more(
        &mut self,
        points: &[DVec2],
        loop_ends: &[u32],
        slack: f64,
        mut folded: f64,
        from: usize,
        out: &mut Vec<[u32; 3]>,
    ) {
        let turned: Vec<DVec2> = points.iter().map(|p| p.perp()).collect();
        let mut found = Vec::new();
        for (points, slack) in [(points, slack), (&turned, slack), (&turned, 0.0)] {
            found.clear();
            self.sweep.triangulate(points, loop_ends, slack, &mut found);
            let now = turned_over(points, &found);
            if now < folded {
                folded = now;
                out.truncate(from);
                out.extend_from_slice(&found);
            }
            if folded <= slack * slack {
                return;
            }
        }
    }
}

/// Twice the area of the reversed triangles.
fn turned_over(points: &[DVec2], triangles: &[[u32; 3]]) -> f64 {
    let area = |t: &[u32; 3]| {
        let [a, b, c] = t.each(|i| points[i as usize]);
        (b - a).perp_dot(c - a)
    };
    triangles.iter().map(area).filter(|area| *area < 0.0).sum::<f64>().abs()
}

#[cfg(test)]
mod tests;
