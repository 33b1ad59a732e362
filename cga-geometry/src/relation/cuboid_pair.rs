//! The relation of boxes, rectangles, segments and points to a box.
//!
//! Boxes and rectangles overlap if they cannot be separated by a move of the tolerance. The shortest move of two convex bodies is along a
//! normal of a face, or across an edge of each.

use glam::{DMat3, DVec3};

use super::Relation;
use super::cuboid::Cuboid;
use super::plane_cut::{clip, is_wider};

/// The least sine of the angle between two edges that span a plane. Rounding errors are divided by it.
const LEAST_SINE: f64 = 1e-6;

/// The largest sum of the other components of an axis that is an axis of the occluder, too. Rounding errors of turned buildings are below it,
/// and it moves no corner by a part of the tolerance.
const SKEW: f64 = 1e-12;

/// The least cosine between the normals of faces with a common area.
const PARALLEL: f64 = 0.5;

/// The relation of a box or a rectangle to a box.
pub(super) fn relate(geometry: &Cuboid, occluder: &Cuboid, tolerance: f64, wanted: Relation) -> Relation {
    if let Some(outer) = aligned_half(occluder, &geometry.axes) {
        let away = geometry.axes.transpose() * (geometry.centre - occluder.centre);
        return relate_aligned(geometry.half, outer, away, tolerance, wanted);
    }
    let inverse = occluder.axes.transpose();
    let axes = inverse * geometry.axes;
    let sizes = DMat3::from_cols(axes.x_axis.abs(), axes.y_axis.abs(), axes.z_axis.abs());
    let pair = Pair {
        centre: inverse * (geometry.centre - occluder.centre),
        axes,
        sizes,
        half: geometry.half,
        reach: sizes * geometry.half,
        outer: occluder.half,
        tolerance,
    };
    let Some(depth) = pair.depth() else { return Relation::NONE };
    let is_inside = pair.is_inside();
    let is_thick = geometry.is_solid() || tolerance < 2.0 * occluder.half.min_element();
    let overlaps = tolerance < depth && is_thick;
    let contact = wanted.touches && !is_inside && !overlaps && pair.has_contact(geometry.is_solid());
    Relation::of(is_inside, overlaps, contact)
}

/// Half of the extents of an occluder along some axes, if these are its own axes in any order. Most pairs of a building have the same axes.
pub(super) fn aligned_half(occluder: &Cuboid, axes: &DMat3) -> Option<DVec3> {
    let DMat3 { x_axis, y_axis, z_axis } = occluder.axes.transpose() * *axes;
    let sizes = [x_axis.abs(), y_axis.abs(), z_axis.abs()];
    let is_axis = |axis: DVec3| axis.x + axis.y + axis.z <= axis.max_element() + SKEW;
    sizes.into_iter().all(is_axis).then(|| DVec3::from(sizes.map(|size| size.dot(occluder.half))))
}

/// [`relate`] for a geometry and an occluder with the same axes: half of their extents, and the way from the centre of the occluder to the
/// centre of the geometry, along these axes. A rectangle has one extent of 0.
#[inline]
pub(super) fn relate_aligned(half: DVec3, outer: DVec3, away: DVec3, tolerance: f64, wanted: Relation) -> Relation {
    let depth = (outer + half - away.abs()).min_element();
    if depth < -tolerance {
        return Relation::NONE;
    }
    let is_solid = half.cmpne(DVec3::ZERO).all();
    let is_inside = (away.abs() + half).cmple(outer + tolerance).all();
    let is_thick = is_solid || tolerance < 2.0 * outer.min_element();
    let overlaps = tolerance < depth && is_thick;
    let contact = wanted.touches && !is_inside && !overlaps && {
        // The part that both have in common, as extents.
        let common = (away + half).min(outer) - (away - half).max(-outer);
        // A face across an axis, by the position, half of the extents and the sides of the common area.
        let is_common = |away: f64, half: f64, outer: f64, [a, b]: [f64; 2]| {
            let is_near = |side: f64| (side.abs() - outer).abs() <= tolerance;
            (is_solid || half == 0.0)
                && 0.0 < a
                && 0.0 < b
                && tolerance * (a + b) < a * b
                && (is_near(away + half) || is_near(away - half))
        };
        is_common(away.x, half.x, outer.x, [common.y, common.z])
            || is_common(away.y, half.y, outer.y, [common.z, common.x])
            || is_common(away.z, half.z, outer.z, [common.x, common.y])
    };
    Relation::of(is_inside, overlaps, contact)
}

/// The geometry in the coordinates of the occluder.
struct Pair {
    centre: DVec3,
    axes: DMat3,
    /// The sizes of the components of the axes.
    sizes: DMat3,
    half: DVec3,
    /// Half of the extents of the geometry along the axes of the occluder.
    reach: DVec3,
    /// Half of the sides of the occluder.
    outer: DVec3,
    tolerance: f64,
}

impl Pair {
    /// The length of the shortest move that separates the two. `None` if they are farther apart than the tolerance.
    fn depth(&self) -> Option<f64> {
        let Pair { centre, axes, sizes, half, reach, outer, tolerance } = self;
        let depths = *outer + *reach - centre.abs();
        let mut depth = depths.min_element();
        if depth < -tolerance {
            return None;
        }
        // Along the axes of the geometry.
        depth = depth.min((*half + sizes.transpose() * *outer - (axes.transpose() * *centre).abs()).min_element());
        if depth < -tolerance {
            return None;
        }
        let [x, y, z] = [axes.x_axis * half.x, axes.y_axis * half.y, axes.z_axis * half.z];
        for side in [axes.x_axis, axes.y_axis, axes.z_axis] {
            for across in
                [DVec3::new(0.0, side.z, -side.y), DVec3::new(-side.z, 0.0, side.x), DVec3::new(side.y, -side.x, 0.0)]
            {
                let length = across.length();
                if length < LEAST_SINE {
                    continue;
                }
                let reach = x.dot(across).abs() + y.dot(across).abs() + z.dot(across).abs();
                let apart = outer.dot(across.abs()) + reach - centre.dot(across).abs();
                depth = depth.min(apart / length);
                if depth < -tolerance {
                    return None;
                }
            }
        }
        Some(depth)
    }

    /// Returns true if no corner is farther outside than the tolerance.
    fn is_inside(&self) -> bool {
        (self.centre.abs() + self.reach).cmple(self.outer + self.tolerance).all()
    }

    /// Returns true if a face of the geometry has an area in common with a face of the box.
    fn has_contact(&self, is_solid: bool) -> bool {
        let axes = [self.axes.x_axis, self.axes.y_axis, self.axes.z_axis];
        for (number, normal) in axes.iter().enumerate().skip(if is_solid { 0 } else { 2 }) {
            for across in 0..3 {
                if normal[across].abs() < PARALLEL {
                    continue;
                }
                let signs: &[f64] = if is_solid { &[1.0, -1.0] } else { &[1.0] };
                for sign in signs {
                    let middle = self.centre + *normal * (sign * self.half[number]);
                    let sides = [(number + 1) % 3, (number + 2) % 3].map(|side| axes[side] * self.half[side]);
                    let slack = self.tolerance + sides[0][across].abs() + sides[1][across].abs();
                    let is_near = (middle[across].abs() - self.outer[across]).abs() <= slack;
                    if is_near && self.is_common([middle, sides[0], sides[1]], across) {
                        return true;
                    }
                }
            }
        }
        false
    }

    /// Returns true if the part of a rectangle above a face of the box is wide enough, and nowhere farther than the tolerance.
    fn is_common(&self, [middle, a, b]: [DVec3; 3], across: usize) -> bool {
        let mut part = vec![middle + a + b, middle - a + b, middle - a - b, middle + a - b];
        let mut next = Vec::with_capacity(8);
        for side in [(across + 1) % 3, (across + 2) % 3] {
            for sign in [1.0, -1.0] {
                next.clear();
                clip(&part, |point| self.outer[side] - sign * point[side], &mut next);
                std::mem::swap(&mut part, &mut next);
            }
        }
        let plane = self.outer[across].copysign(middle[across]);
        is_wider(&part, self.tolerance) && part.iter().all(|point| (point[across] - plane).abs() <= self.tolerance)
    }
}

/// The relation of a segment to a box.
pub(super) fn relate_segment(ends: [DVec3; 2], occluder: &Cuboid, tolerance: f64) -> Relation {
    let inverse = occluder.axes.transpose();
    let [a, b] = ends.map(|end| inverse * (end - occluder.centre));
    let is_inside = a.abs().max(b.abs()).cmple(occluder.half + tolerance).all();
    // The shares of the segment between the planes of all faces.
    let (mut start, mut end) = (0.0f64, 1.0f64);
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let [from, to] = [a, b].map(|point| occluder.half[axis] - sign * point[axis]);
            if from < 0.0 && to < 0.0 {
                return Relation::of(is_inside, false, false);
            }
            if from < 0.0 {
                start = start.max(from / (from - to));
            } else if to < 0.0 {
                end = end.min(from / (from - to));
            }
        }
    }
    let middle = a + (b - a) * (0.5 * (start + end));
    let overlaps = start < end && tolerance < (occluder.half - middle.abs()).min_element();
    Relation::of(is_inside, overlaps, false)
}

/// The relation of a point to a box.
pub(super) fn relate_point(point: DVec3, occluder: &Cuboid, tolerance: f64) -> Relation {
    let depth = (occluder.half - (occluder.axes.transpose() * (point - occluder.centre)).abs()).min_element();
    Relation::of(-tolerance <= depth, tolerance < depth, false)
}
