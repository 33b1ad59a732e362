//! Axes with the normals that sinks need.

use glam::{DMat3, DVec3};

/// The axes of scopes, orthonormal, and the same rounded: the normals of whatever is aligned to them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    pub(crate) matrix: DMat3,
    pub(crate) normals: [[f32; 3]; 3],
}

impl Axes {
    /// The axes of the world.
    pub(crate) const WORLD: Axes =
        Axes { matrix: DMat3::IDENTITY, normals: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] };

    #[inline]
    pub(crate) fn new(matrix: DMat3) -> Self {
        let round = |v: DVec3| [v.x as f32, v.y as f32, v.z as f32];
        Axes { matrix, normals: [round(matrix.x_axis), round(matrix.y_axis), round(matrix.z_axis)] }
    }

    /// The axes of a rectangle across z that has grown: y points where z did, x stays.
    #[inline]
    pub(crate) fn raised(&self) -> Self {
        let ([x, y, z], [nx, ny, nz]) = ([self.matrix.x_axis, self.matrix.y_axis, self.matrix.z_axis], self.normals);
        Axes { matrix: DMat3::from_cols(x, z, -y), normals: [nx, nz, ny.map(|c| -c)] }
    }

    /// The axes as columns.
    pub fn matrix(&self) -> &DMat3 {
        &self.matrix
    }

    /// The axes, rounded.
    pub fn normals(&self) -> &[[f32; 3]; 3] {
        &self.normals
    }
}
