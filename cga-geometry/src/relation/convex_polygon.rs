//! Convex polygons with a normal, and what they divide.

use glam::DVec3;

use super::plane_cut::{clip, clip_to_prism, crossing, edge_planes, is_wider};

/// The share of the tolerance by which a part extends beyond a plane before it is cut. Cuts along coplanar faces coincide up to
/// rounding, and must not make slivers.
const LEAST_BEYOND: f64 = 0.25;

/// The least cosine between the normals of planes that may be near each other over an area.
const PARALLEL: f64 = 0.5;

/// A convex polygon and its unit normal.
#[derive(Clone, Copy)]
pub(super) struct ConvexPolygon<'p> {
    pub(super) corners: &'p [DVec3],
    pub(super) normal: DVec3,
}

impl ConvexPolygon<'_> {
    /// The area that another polygon has in common with this one: the part above it, if all of it is within the tolerance.
    pub(super) fn common_area(&self, other: &ConvexPolygon<'_>, tolerance: f64) -> Option<Vec<DVec3>> {
        if other.normal.dot(self.normal).abs() < PARALLEL {
            return None;
        }
        let above = clip_to_prism(other.corners, self.corners, self.normal, 0.0);
        let is_near = |point: &DVec3| self.height(*point).abs() <= tolerance;
        (is_wider(&above, tolerance) && above.iter().all(is_near)).then_some(above)
    }

    /// The signed distance of a point from the plane.
    pub(super) fn height(&self, point: DVec3) -> f64 {
        (point - self.corners[0]).dot(self.normal)
    }

    /// Divides a convex part of another polygon, which has the normal. Returns false if this polygon does not divide it.
    pub(super) fn divide(&self, part: &[DVec3], normal: DVec3, tolerance: f64, made: &mut Vec<Vec<DVec3>>) -> bool {
        let beyond = LEAST_BEYOND * tolerance;
        let [low, high] = range(part, |point| self.height(point));
        if tolerance < low || high < -tolerance {
            return false;
        }
        if self.common_area(&ConvexPolygon { corners: part, normal }, tolerance).is_some() {
            return self.divide_around(part, beyond, made);
        }
        if -beyond < low || high < beyond || !self.meets_plane_of(part, beyond) {
            return false;
        }
        for sign in [1.0, -1.0] {
            let mut side = Vec::with_capacity(part.len() + 2);
            clip(part, |point| sign * self.height(point), &mut side);
            made.push(side);
        }
        true
    }

    /// Divides a part into the part above this polygon and the parts beside it.
    fn divide_around(&self, part: &[DVec3], beyond: f64, made: &mut Vec<Vec<DVec3>>) -> bool {
        let before = made.len();
        let mut rest = part.to_vec();
        for [a, inwards] in edge_planes(self.corners, self.normal) {
            let [low, high] = range(&rest, |point| (point - a).dot(inwards));
            if -beyond < low || high < beyond {
                continue;
            }
            let [mut inner, mut outer] = [Vec::with_capacity(rest.len() + 2), Vec::with_capacity(rest.len() + 2)];
            clip(&rest, |point| (point - a).dot(inwards), &mut inner);
            clip(&rest, |point| -(point - a).dot(inwards), &mut outer);
            made.push(outer);
            rest = inner;
        }
        if made.len() == before {
            return false;
        }
        made.push(rest);
        true
    }

    /// Returns true if the line in which a part crosses the plane meets this polygon, or passes it closely.
    fn meets_plane_of(&self, part: &[DVec3], slack: f64) -> bool {
        let mut ends = [DVec3::ZERO; 2];
        let mut count = 0;
        let Some(&last) = part.last() else { return false };
        let (mut a, mut from) = (last, self.height(last));
        for &b in part {
            let to = self.height(b);
            if (from < 0.0) != (to < 0.0) && count < 2 {
                ends[count] = crossing([a, b], [from, to]);
                count += 1;
            }
            (a, from) = (b, to);
        }
        // The shares of the line above all edges.
        let [mut start, mut end] = [0.0, 1.0];
        for [a, inwards] in edge_planes(self.corners, self.normal) {
            let [from, to] = ends.map(|point| (point - a).dot(inwards) + slack);
            if from < 0.0 && to < 0.0 {
                return false;
            }
            if from < 0.0 {
                start = f64::max(start, from / (from - to));
            } else if to < 0.0 {
                end = f64::min(end, from / (from - to));
            }
        }
        count == 2 && start <= end
    }
}

/// The least and the largest value at some points.
fn range(points: &[DVec3], value: impl Fn(DVec3) -> f64) -> [f64; 2] {
    let values = points.iter().map(|point| value(*point));
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}
