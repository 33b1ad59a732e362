//! Primitives in the unit box, 0 to 1 along each axis. Whoever inserts one fits it to its scope.

use glam::{DMat3, DVec3};

use super::{Derived, FaceEnds, FaceTag, Mesh, Tags};
use crate::sink::{Cuboid, Quad};

/// A box: six faces in the order of [`Cuboid::faces`], closed.
pub fn cube() -> Mesh {
    Mesh::from_cuboid(&Cuboid { origin: DVec3::ZERO, sides: DMat3::IDENTITY })
}

/// A square on the ground that faces up; its first edge runs along x, at z = 1.
pub fn quad() -> Mesh {
    Mesh::from_quad(&Quad { origin: DVec3::Z, u: DVec3::X, v: DVec3::NEG_Z })
}

/// A cylinder about the vertical through the middle: `sides` side faces counter-clockwise seen from above, then top and
/// bottom, closed. The first corner is at the right (x = 1). Fewer than three sides count as three.
pub fn cylinder(sides: usize) -> Mesh {
    let sides = sides.clamp(3, 1 << 20);
    let mut points = Vec::with_capacity(2 * sides);
    for y in [0.0, 1.0] {
        for i in 0..sides {
            let angle = std::f64::consts::TAU * i as f64 / sides as f64;
            points.push(DVec3::new(0.5 + 0.5 * libm::cos(angle), y, 0.5 - 0.5 * libm::sin(angle)));
        }
    }
    let count = sides as u32;
    let mut corners = Vec::with_capacity(6 * sides);
    let mut loop_ends = Vec::with_capacity(sides + 2);
    for i in 0..count {
        let next = (i + 1) % count;
        corners.extend([i, next, count + next, count + i]);
        loop_ends.push(4 * (i + 1));
    }
    corners.extend(count..2 * count);
    loop_ends.push(5 * count);
    // Turned over, first edge first: 1 0 n-1 … 2.
    corners.extend([1, 0]);
    corners.extend((2..count).rev());
    loop_ends.push(6 * count);
    let derived = Derived::default();
    let _ = derived.closed.set(true);
    Mesh {
        points,
        corners,
        loop_ends,
        face_ends: FaceEnds::single(sides + 2),
        tags: Tags::uniform(sides + 2, FaceTag::PLAIN),
        derived,
        ..Mesh::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn primitives_are_closed_and_look_outwards() {
        for mesh in [cube(), cylinder(3), cylinder(16)] {
            assert!(mesh.count_closed());
            assert!(mesh.volume() > 0.0);
            assert!(mesh.check().is_empty());
            assert_eq!(mesh.bounds().low.y, 0.0);
        }
        assert_eq!(cube().volume(), 1.0);
        assert_eq!(quad().face(0).normal(), DVec3::Y);
        assert_eq!(cylinder(16).face(16).normal(), DVec3::Y);
        assert_eq!(cylinder(16).face(17).normal(), DVec3::NEG_Y);
        assert_eq!(cylinder(4).face_count(), 6);
    }

    #[test]
    fn a_cylinder_has_the_volume_of_its_prism() {
        let exact = 64.0 / 8.0 * libm::sin(std::f64::consts::TAU / 64.0);
        assert!((cylinder(64).volume() - exact).abs() < 1e-14);
    }
}
