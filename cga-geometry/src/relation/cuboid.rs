//! Boxes in any position, also flat ones: rectangles.

use glam::{DAffine3, DMat3, DVec3};

use crate::bounds::Bounds;
use crate::each::Each;
use crate::mesh::{Mesh, unit};

/// The largest deviation from right angles and from the corners of a box, relative to its sides.
const SKEW: f64 = 1e-9;

/// A number above the square root of 3: no corner of a box is farther from its centre than this multiple of half of its longest side.
pub(super) const CORNER: f64 = 1.75;

/// A number that is not less than the largest coordinate of a box.
#[inline]
pub(super) fn far(centre: DVec3, half: DVec3) -> f64 {
    centre.abs().max_element() + CORNER * half.abs().max_element()
}

/// A box with orthogonal sides. A rectangle has no extent along its last axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cuboid {
    pub(super) centre: DVec3,
    /// Unit vectors along the sides.
    pub(super) axes: DMat3,
    /// Half of each side.
    pub(super) half: DVec3,
}

impl Cuboid {
    /// The box with a corner and the sides from it. `None` if the sides are not at right angles.
    pub(super) fn of_sides(corner: DVec3, sides: [DVec3; 3]) -> Option<Self> {
        let lengths = sides.each(|side| side.length());
        let [x, y, z] = sides;
        let is_right = |a: DVec3, b: DVec3| a.dot(b).abs() <= SKEW * a.length() * b.length();
        if !(is_right(x, y) && is_right(y, z) && is_right(z, x)) {
            return None;
        }
        let units = sides.each(unit);
        // A flat box needs all three axes.
        let axes = match lengths.each(|length| 0.0 < length) {
            [true, true, true] => units,
            [true, true, false] => [units[0], units[1], units[0].cross(units[1])],
            [false, true, true] => [units[1], units[2], units[1].cross(units[2])],
            [true, false, true] => [units[2], units[0], units[2].cross(units[0])],
            _ => return None,
        };
        let half = match lengths.each(|length| 0.0 < length) {
            [false, ..] => [lengths[1], lengths[2], 0.0],
            [_, false, _] => [lengths[2], lengths[0], 0.0],
            _ => lengths,
        };
        let centre = corner + (x + y + z) * 0.5;
        Some(Cuboid { centre, axes: DMat3::from_cols(axes[0], axes[1], axes[2]), half: DVec3::from(half) * 0.5 })
    }

    /// The box or rectangle that a mesh is after it is placed.
    pub(super) fn of_mesh(mesh: &Mesh, placement: &DAffine3) -> Option<Self> {
        let points = mesh.points();
        let at = |point: u32| points[point as usize];
        let far = mesh.bounds().low.abs().max(mesh.bounds().high.abs()).max_element();
        if mesh.corners().len() == 4 * mesh.face_count() && points.len() == 4 && mesh.face_count() == 1 {
            let [a, b, c, d] = *mesh.face(0).outer() else { return None };
            let sides = [at(b) - at(a), at(d) - at(a)];
            let off = (at(c) - at(b) - sides[1]).abs().max_element();
            let shorter = sides[0].length().min(sides[1].length());
            if SKEW * shorter < off {
                return None;
            }
            let [x, y] = sides.each(|side| placement.matrix3 * side);
            return Self::of_sides(placement.transform_point3(at(a)), [x, y, DVec3::ZERO]);
        }
        if points.len() != 8 || mesh.face_count() != 6 || mesh.corners().len() != 24 {
            return None;
        }
        let mut sides = [DVec3::ZERO; 3];
        let mut count = 0;
        for [from, to] in mesh.face_edges() {
            let side = at(to) - at(from);
            if from == 0 && !sides[..count].contains(&side) {
                *sides.get_mut(count)? = side;
                count += 1;
            }
        }
        let inverse = DMat3::from_cols(sides[0], sides[1], sides[2]).inverse();
        let shortest = sides.iter().fold(f64::INFINITY, |least: f64, side| least.min(side.length()));
        let slack = (SKEW + 8.0 * f64::EPSILON * far / shortest).min(1e3 * SKEW);
        // The corner of the box at which each point is.
        let mut numbers = [0u8; 8];
        for (number, point) in numbers.iter_mut().zip(points) {
            let place = inverse * (*point - points[0]);
            let whole = place.round();
            // A singular matrix makes them NaN.
            let is_corner = (place - whole).abs().max_element() <= slack && whole.cmpge(DVec3::ZERO).all();
            if !is_corner || !whole.cmple(DVec3::ONE).all() {
                return None;
            }
            *number = whole.x as u8 | (whole.y as u8) << 1 | (whole.z as u8) << 2;
        }
        let mut found = 0u8;
        for face in mesh.faces() {
            let [a, b, c, d] = *face.outer() else { return None };
            let [a, b, c, d] = [a, b, c, d].each(|point| numbers[point as usize]);
            let is_side =
                [a ^ b, b ^ c, c ^ d, d ^ a].iter().all(|changed| changed.count_ones() == 1) && a ^ b == c ^ d;
            let (low, high) = (!(a | b | c | d) & 7, a & b & c & d);
            if !is_side || a ^ b == b ^ c {
                return None;
            }
            found |= low | high << 3;
        }
        if found != 0b11_1111 {
            return None;
        }
        Self::of_sides(placement.transform_point3(points[0]), sides.each(|side| placement.matrix3 * side))
    }

    /// Returns true if the box is not flat.
    #[inline]
    pub(super) fn is_solid(&self) -> bool {
        self.half.z != 0.0
    }

    /// The box along the axes of the world around it.
    #[inline]
    pub(super) fn bounds(&self) -> Bounds {
        let DMat3 { x_axis, y_axis, z_axis } = self.axes;
        let half = x_axis.abs() * self.half.x + y_axis.abs() * self.half.y + z_axis.abs() * self.half.z;
        Bounds { low: self.centre - half, high: self.centre + half }
    }

    /// The length of the longest side.
    #[inline]
    pub(super) fn extent(&self) -> f64 {
        2.0 * self.half.max_element()
    }

    /// The corners of the faces, counter-clockwise as seen from outside: six, or the one of a rectangle.
    pub(super) fn faces(&self) -> Vec<[DVec3; 4]> {
        let at = |x: f64, y: f64, z: f64| self.centre + self.axes * (self.half * DVec3::new(x, y, z));
        let front = [at(-1.0, -1.0, 1.0), at(1.0, -1.0, 1.0), at(1.0, 1.0, 1.0), at(-1.0, 1.0, 1.0)];
        if !self.is_solid() {
            return vec![front];
        }
        let back = [at(-1.0, -1.0, -1.0), at(1.0, -1.0, -1.0), at(1.0, 1.0, -1.0), at(-1.0, 1.0, -1.0)];
        let mut faces = vec![front, [back[3], back[2], back[1], back[0]]];
        let sides = [(0, 1), (1, 2), (2, 3), (3, 0)];
        faces.extend(sides.map(|(a, b)| [back[a], back[b], front[b], front[a]]));
        faces
    }
}
