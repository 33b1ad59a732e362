//! Axes with the normals that sinks need.

use glam::{DMat3, DVec3, DVec4, Vec4};

use crate::geometry::Axis;
use crate::geometry::each::Each;
use crate::shape::unit::BoxSide;

/// The orthonormal axes of scopes, with the rounded normals of everything aligned to them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    pub(crate) matrix: DMat3,
    /// The columns, each with a fourth coordinate of 0.
    columns: [DVec4; 3],
    /// The normals by side of a box, in the order of [`BoxSide`]: front, right, back, left, top, bottom. Each follows a
    /// 0, see [`normal`].
    pub(crate) normals: [Vec4; 6],
}

impl Axes {
    #[inline]
    pub(crate) fn new(matrix: DMat3) -> Self {
        let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis].each(normal);
        let [left, bottom, back] = [x, y, z].each(opposite);
        Axes { matrix, columns: columns(&matrix), normals: [z, x, back, left, y, bottom] }
    }

    /// The axes after a rectangle across z has grown: y is the old z, x stays.
    #[inline]
    pub(crate) fn raised(&self) -> Self {
        let [x, y, z] = [self.matrix.x_axis, self.matrix.y_axis, self.matrix.z_axis];
        let [front, right, back, left, top, bottom] = self.normals;
        let matrix = DMat3::from_cols(x, z, -y);
        Axes { matrix, columns: columns(&matrix), normals: [bottom, right, top, left, front, back] }
    }

    /// The direction of an axis, with a fourth coordinate of 0.
    #[inline(always)]
    pub(crate) fn along(&self, axis: Axis) -> DVec4 {
        self.columns[axis.index()]
    }

    /// Returns true if all bits of the axes are equal. Axes that differ in the sign of a 0 are different.
    #[inline]
    pub(crate) fn is(&self, matrix: &DMat3) -> bool {
        // One by one: arrays of bits would be stored in memory and loaded again at once.
        let columns = |matrix: &DMat3| [matrix.x_axis, matrix.y_axis, matrix.z_axis];
        let is_same = |a: DVec3, b: DVec3| {
            a.x.to_bits() == b.x.to_bits() && a.y.to_bits() == b.y.to_bits() && a.z.to_bits() == b.z.to_bits()
        };
        let [a, b] = [columns(&self.matrix), columns(matrix)];
        is_same(a[0], b[0]) && is_same(a[1], b[1]) && is_same(a[2], b[2])
    }

    /// The axes as columns.
    pub fn matrix(&self) -> &DMat3 {
        &self.matrix
    }

    /// The direction of an axis, rounded to f32: the normal of a rectangle across it.
    pub fn normal(&self, axis: Axis) -> [f32; 3] {
        let side = match axis {
            Axis::X => BoxSide::Right,
            Axis::Y => BoxSide::Top,
            Axis::Z => BoxSide::Front,
        };
        without_zero(self.normals[side as usize])
    }
}

#[inline]
fn columns(matrix: &DMat3) -> [DVec4; 3] {
    [matrix.x_axis, matrix.y_axis, matrix.z_axis].each(|axis| axis.extend(0.0))
}

/// A normal rounded to f32, after a 0, in the form in which writers of vertices add it to a coordinate. A zero has no
/// sign.
#[inline]
pub(crate) fn normal(v: DVec3) -> Vec4 {
    DVec4::new(0.0, v.x, v.y, v.z).as_vec4() + Vec4::ZERO
}

/// The three numbers of a normal that follows a 0.
#[inline]
pub(crate) fn without_zero(normal: Vec4) -> [f32; 3] {
    [normal.y, normal.z, normal.w]
}

fn opposite(normal: Vec4) -> Vec4 {
    Vec4::ZERO - normal
}
