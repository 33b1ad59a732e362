//! Primitives in the unit box, 0 to 1 along each axis.
//!
//! Round primitives have their corners on a circle of diameter 1 about the centre, so with few corners they do not
//! reach the sides of the box. They begin in front (z = 1) with a face that looks along z, and continue
//! counter-clockwise as seen from above. Texture
//! coordinates are in set 0.

mod circle;
mod cone;
mod cylinder;
mod disk;
mod sphere;

use glam::{DVec2, DVec3};

use crate::Axis;
use crate::mesh::{FaceTag, Mesh};
use crate::provenance::Provenance;
use crate::solid::{corner, square, unit_box};

pub use cone::cone;
pub use cylinder::cylinder;
pub use disk::disk;
pub use sphere::sphere;

/// A closed box: bottom, top, front, right, back, left. Vertices go around the bottom, then
/// around the top.
pub fn cube() -> Mesh {
    let points = [0, 1, 5, 4, 2, 3, 7, 6].map(corner);
    unit_box(points, [[0, 1, 2, 3], [7, 6, 5, 4], [3, 2, 6, 7], [2, 1, 5, 6], [1, 0, 4, 5], [0, 3, 7, 4]])
}

/// A square on the ground that faces up. Its first edge is along x, at z = 1.
pub fn quad() -> Mesh {
    square(Axis::Y, Provenance::Unknown)
}

/// The parameters of a primitive that is a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PrimitiveKind {
    /// See [`cylinder()`].
    Cylinder {
        /// The number of sides, at least 3.
        sides: u32,
    },
    /// See [`cone()`].
    Cone {
        /// The number of sides, at least 3.
        sides: u32,
    },
    /// See [`disk()`].
    Disk {
        /// The number of sides, at least 3.
        sides: u32,
        /// The axis of its normal.
        across: Axis,
    },
    /// A square with texture coordinates from 0 to 1.
    Square {
        /// The axis of its normal.
        across: Axis,
    },
    /// See [`sphere()`].
    Sphere {
        /// The number of sides, at least 3.
        sides: u32,
        /// The number of divisions from pole to pole, at least 2.
        divisions: u32,
    },
}

impl PrimitiveKind {
    /// The total number of corners of its faces. Numbers of sides and divisions below their least ones count as these; numbers
    /// above the limits of the mesh count in full, so the mesh may have fewer corners.
    pub fn corner_count(self) -> u64 {
        let at_least = |least: u32, count: u32| u64::from(count.max(least));
        match self {
            PrimitiveKind::Cylinder { sides } => 6 * at_least(3, sides),
            PrimitiveKind::Cone { sides } => 4 * at_least(3, sides),
            PrimitiveKind::Disk { sides, .. } => at_least(3, sides),
            PrimitiveKind::Square { .. } => 4,
            PrimitiveKind::Sphere { sides, divisions } => {
                at_least(3, sides).saturating_mul(4 * at_least(2, divisions) - 2)
            }
        }
    }

    /// Makes the mesh. Numbers of sides are limited to 3 to 2^20, and the divisions of a sphere so that it has at most 2^22 points.
    pub fn mesh(self) -> Mesh {
        match self {
            PrimitiveKind::Cylinder { sides } => cylinder(sides as usize),
            PrimitiveKind::Cone { sides } => cone(sides as usize),
            PrimitiveKind::Disk { sides, across } => disk(sides as usize, across),
            PrimitiveKind::Square { across } => disk::square(across),
            PrimitiveKind::Sphere { sides, divisions } => sphere(sides as usize, divisions as usize),
        }
    }
}

/// A builder of faces with one loop, with texture coordinates at each corner.
struct FaceBuilder {
    mesh: Mesh,
    uvs: Vec<DVec2>,
}

impl FaceBuilder {
    fn new(points: Vec<DVec3>, corners: usize) -> Self {
        let mesh = Mesh { points, corners: Vec::with_capacity(corners), ..Mesh::default() };
        FaceBuilder { mesh, uvs: Vec::with_capacity(corners) }
    }

    fn face(&mut self, corners: impl IntoIterator<Item = (usize, DVec2)>) {
        for (point, uv) in corners {
            self.mesh.corners.push(point as u32);
            self.uvs.push(uv);
        }
        self.mesh.end_loop();
        self.mesh.end_face(FaceTag::PLAIN);
    }

    fn finish(mut self, closed: bool) -> Mesh {
        self.mesh.uvs.set(0, self.uvs);
        self.mesh.known_closed(closed)
    }
}

#[cfg(test)]
mod tests {
    use super::circle::area;
    use super::*;

    #[test]
    fn primitives_are_closed_and_look_outwards() {
        let round = [3, 4, 5, 16].into_iter().flat_map(|n| [cylinder(n), cone(n), sphere(n, 2), sphere(n, 7)]);
        for mesh in round.chain([cube()]) {
            assert_eq!(mesh.count_closed(), Some(true));
            assert!(mesh.volume() > 0.0);
            assert_eq!(mesh.check(), []);
            assert_eq!((mesh.bounds().low.y, mesh.bounds().high.y), (0.0, 1.0));
            // Convex about the centre: each face looks away from it.
            let away =
                |face: crate::mesh::FaceRef<'_>| face.normal().dot(face.position(face.corner_range().start) - 0.5);
            assert!(mesh.faces().all(|face| 0.0 < away(face)));
        }
        assert_eq!(cube().volume(), 1.0);
        assert_eq!(quad().face(0).normal(), DVec3::Y);
    }

    #[test]
    fn volumes_are_those_of_the_polyhedra() {
        for sides in [3, 8, 17, 64] {
            let base = area(sides);
            let near = |mesh: &Mesh, volume: f64| assert!((mesh.volume() - volume).abs() < 1e-14, "{sides} sides");
            near(&cylinder(sides), base);
            near(&cone(sides), base / 3.0);
            for divisions in [2, 5, 16] {
                // Frustums between rings; their areas scale with the square of the radius.
                let ring = |j: usize| {
                    let (sin, cos) = libm::sincos(std::f64::consts::PI * j as f64 / divisions as f64);
                    (sin, -0.5 * cos)
                };
                let frustum = |j: usize| {
                    let ((r, low), (q, high)) = (ring(j), ring(j + 1));
                    (high - low) / 3.0 * base * (r * r + r * q + q * q)
                };
                near(&sphere(sides, divisions), (0..divisions).map(frustum).sum());
            }
        }
    }

    #[test]
    fn the_first_face_looks_to_the_front_and_starts_at_its_left_end() {
        for sides in [3, 4, 8, 16, 31] {
            for mesh in [cylinder(sides), cone(sides)] {
                let normal = mesh.face(0).normal();
                assert!(normal.x.abs() < 1e-15 && 0.0 < normal.z, "{normal}");
                let [a, b] = [0, 1].map(|i| mesh.points()[mesh.face(0).outer()[i] as usize]);
                assert!(a.x < b.x && a.z == b.z && (a.y, b.y) == (0.0, 0.0));
                assert_eq!(mesh.uvs()[0], DVec2::ZERO);
            }
            let [a, b] = [0, 1].map(|i| disk(sides, Axis::Y).points()[i]);
            assert!(a.x < b.x && a.z == b.z && 0.5 < a.z);
        }
    }

    #[test]
    fn what_is_said_of_corners_is_so() {
        let all = [
            PrimitiveKind::Cylinder { sides: 9 },
            PrimitiveKind::Cone { sides: 5 },
            PrimitiveKind::Disk { sides: 7, across: Axis::Z },
            PrimitiveKind::Square { across: Axis::X },
            PrimitiveKind::Sphere { sides: 5, divisions: 2 },
            PrimitiveKind::Sphere { sides: 4, divisions: 9 },
        ];
        for made in all {
            let mesh = made.mesh();
            assert_eq!(mesh.corners().len() as u64, made.corner_count(), "{made:?}");
            assert_eq!(mesh.uvs().len(), mesh.corners().len());
            assert!(mesh.uvs().iter().all(|uv| uv.cmpge(DVec2::ZERO).all() && uv.cmple(DVec2::ONE).all()));
        }
    }
}
