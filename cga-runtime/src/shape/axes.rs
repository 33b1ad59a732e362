//! Axes with the normals that sinks need.

use glam::{DMat3, DVec3};

use crate::scope::Axis;

/// The axes of scopes, orthonormal, and the normals of whatever is aligned to them, rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    pub(crate) matrix: DMat3,
    /// By side of a box, as [`Side`](crate::unit::Side) counts them: front, right, back, left, top, bottom.
    pub(crate) normals: [[f32; 3]; 6],
}

impl Axes {
    #[inline]
    pub(crate) fn new(matrix: DMat3) -> Self {
        let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(round);
        let [left, bottom, back] = [x, y, z].map(opposite);
        Axes { matrix, normals: [z, x, back, left, y, bottom] }
    }

    /// The axes of a rectangle across z that has grown: y points where z did, x stays.
    #[inline]
    pub(crate) fn raised(&self) -> Self {
        let [x, y, z] = [self.matrix.x_axis, self.matrix.y_axis, self.matrix.z_axis];
        let [front, right, back, left, top, bottom] = self.normals;
        Axes { matrix: DMat3::from_cols(x, z, -y), normals: [bottom, right, top, left, front, back] }
    }

    /// The axes as columns.
    pub fn matrix(&self) -> &DMat3 {
        &self.matrix
    }

    /// The direction of an axis, rounded: the normal of a rectangle across it.
    pub fn normal(&self, axis: Axis) -> [f32; 3] {
        match axis {
            Axis::X => self.normals[1],
            Axis::Y => self.normals[4],
            Axis::Z => self.normals[0],
        }
    }
}

fn round(v: DVec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}

fn opposite([x, y, z]: [f32; 3]) -> [f32; 3] {
    [-x, -y, -z]
}
