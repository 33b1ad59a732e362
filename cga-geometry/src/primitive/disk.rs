//! The disk.

use glam::{DVec2, DVec3};

use super::{FaceBuilder, circle};
use crate::Axis;
use crate::mesh::Mesh;

/// A disk with its normal along an axis, in the plane where that coordinate is 0. The minimum is three corners.
/// Its texture fills the square around it.
pub fn disk(sides: usize, across: Axis) -> Mesh {
    flat(&circle::corners(circle::sides(sides)).map(circle::from_above).collect::<Vec<_>>(), across)
}

/// A square with its normal along an axis, in the plane where that coordinate is 0, with the same texture as a disk
/// there.
pub(super) fn square(across: Axis) -> Mesh {
    flat(&[DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y], across)
}

/// A face across an axis, given by its texture coordinates.
fn flat(texture: &[DVec2], across: Axis) -> Mesh {
    let mut faces = FaceBuilder::new(texture.iter().map(|&uv| lying(uv, across)).collect(), texture.len());
    faces.face(texture.iter().copied().enumerate());
    faces.finish(false)
}

/// The position of a texture coordinate on a primitive across an axis. In the pictures of *primitiveQuad* and
/// *primitiveDisk* u is along x, or along -y if x is constant; v is along -z, or along y if z is constant.
fn lying(uv: DVec2, across: Axis) -> DVec3 {
    match across {
        Axis::X => DVec3::new(0.0, 1.0 - uv.x, 1.0 - uv.y),
        Axis::Y => DVec3::new(uv.x, 0.0, 1.0 - uv.y),
        Axis::Z => DVec3::new(uv.x, uv.y, 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::primitive::circle::area;

    #[test]
    fn a_disk_looks_along_its_axis() {
        for (across, normal) in [(Axis::X, DVec3::X), (Axis::Y, DVec3::Y), (Axis::Z, DVec3::Z)] {
            for sides in [3, 8, 16] {
                let disk = disk(sides, across);
                assert_eq!((disk.face_count(), disk.check()), (1, Vec::new()));
                assert!((disk.face(0).normal() - normal).length() < 1e-15);
                assert!((disk.area() - area(sides)).abs() < 1e-15);
                assert_eq!(disk.bounds().high[across.index()], 0.0);
                let flat = disk.points().iter().zip(disk.uvs()).all(|(&p, &uv)| p == lying(uv, across));
                assert!(flat && disk.count_closed() == Some(false));
            }
        }
    }
}
