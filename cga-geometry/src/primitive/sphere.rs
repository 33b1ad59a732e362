//! The sphere.

use glam::{DVec2, DVec3};

use super::{FaceBuilder, circle};
use crate::each::Each;
use crate::mesh::Mesh;
use crate::work;

/// The units of work of a face.
const FACE: usize = 16;

/// A closed sphere with its poles on the vertical through the centre: `divisions` rows of `sides` faces from the bottom
/// up, each row counter-clockwise as seen from above, with triangles at the poles. The minimum is three sides and two
/// divisions. Around the sphere u goes once from 0 to 1, and v goes from pole to pole in
/// equal steps. Each triangle has its pole in the middle of its range of u. If the work of a
/// [`Supervisor`](crate::work::Supervisor) ends meanwhile, the mesh is empty.
pub fn sphere(sides: usize, divisions: usize) -> Mesh {
    let sides = circle::sides(sides);
    let divisions = divisions.clamp(2, (1 << 22) / sides);
    let ring: Vec<DVec2> = circle::corners(sides).map(|p| p - 0.5).collect();
    let mut points = vec![DVec3::new(0.5, 0.0, 0.5)];
    for j in 1..divisions {
        let (sin, cos) = circle::sin_cos(j, 2 * divisions);
        points.extend(ring.iter().map(|p| DVec3::new(0.5 + sin * p.x, 0.5 - 0.5 * cos, 0.5 + sin * p.y)));
    }
    points.push(DVec3::new(0.5, 1.0, 0.5));
    let north = points.len() - 1;
    let mut faces = FaceBuilder::new(points, sides * (4 * divisions - 2));
    let at = |row: usize, i: usize| 1 + (row - 1) * sides + i % sides;
    let uv = |row: usize, i: f64| DVec2::new(i / sides as f64, row as f64 / divisions as f64);
    for row in 0..divisions {
        if !work::spend(FACE * sides) {
            return Mesh::default();
        }
        for i in 0..sides {
            let [left, middle, right] = [0.0, 0.5, 1.0].each(|part| i as f64 + part);
            let lower = [(row, left, i), (row, right, i + 1)];
            let upper = [(row + 1, right, i + 1), (row + 1, left, i)];
            let corner = |(row, u, i): (usize, f64, usize)| (at(row, i), uv(row, u));
            if row == 0 {
                faces.face([(0, uv(0, middle))].into_iter().chain(upper.each(corner)));
            } else if row + 1 == divisions {
                faces.face(lower.each(corner).into_iter().chain([(north, uv(divisions, middle))]));
            } else {
                faces.face(lower.into_iter().chain(upper).map(corner));
            }
        }
    }
    faces.finish(true)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_go_from_pole_to_pole() {
        let sphere = sphere(8, 4);
        assert_eq!((sphere.face_count(), sphere.points().len()), (32, 26));
        let corners: Vec<usize> = sphere.faces().map(|face| face.corner_count()).collect();
        assert!((0..32).all(|face| corners[face] == if (8..24).contains(&face) { 4 } else { 3 }));
        assert!((0..31).all(|face| sphere.face(face).normal().y <= sphere.face(face + 1).normal().y + 1e-15));
        let octahedron = super::sphere(4, 2);
        assert_eq!((octahedron.face_count(), octahedron.points().len()), (8, 6));
    }

    #[test]
    fn corners_are_on_the_sphere() {
        for (sides, divisions) in [(3, 2), (16, 16), (7, 5)] {
            let far = |p: &DVec3| (p.distance(DVec3::splat(0.5)) - 0.5).abs();
            assert!(sphere(sides, divisions).points().iter().all(|p| far(p) < 1e-15));
        }
    }
}
