//! The cone.

use glam::{DVec2, DVec3};

use super::cylinder::turned_over;
use super::{FaceBuilder, circle};
use crate::mesh::Mesh;

/// A closed cone about the vertical through the centre, with its tip up: `sides` triangles counter-clockwise as seen
/// from above, then the bottom. The minimum is three sides. Along the bottom edges u goes
/// once from 0 to 1; the tip is at (0.5, 1), so that the sides together show the texture as one triangle.
pub fn cone(sides: usize) -> Mesh {
    let sides = circle::sides(sides);
    let ring: Vec<DVec2> = circle::corners(sides).collect();
    let tip = DVec3::new(0.5, 1.0, 0.5);
    let points = ring.iter().map(|p| DVec3::new(p.x, 0.0, p.y)).chain([tip]).collect();
    let mut faces = FaceBuilder::new(points, 4 * sides);
    let around = |i: usize| DVec2::new(i as f64 / sides as f64, 0.0);
    for i in 0..sides {
        faces.face([(i, around(i)), ((i + 1) % sides, around(i + 1)), (sides, DVec2::new(0.5, 1.0))]);
    }
    faces.face(turned_over(sides).map(|i| (i, ring[i])));
    faces.finish(true)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_come_first_then_the_bottom() {
        let cone = cone(5);
        assert_eq!((cone.face_count(), cone.points().len()), (6, 6));
        assert!((0..5).all(|face| 0.0 < cone.face(face).normal().y));
        assert_eq!(cone.face(5).normal(), DVec3::NEG_Y);
    }
}
