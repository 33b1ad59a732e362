//! The cylinder.

use glam::{DVec2, DVec3};

use super::{FaceBuilder, circle};
use crate::each::Each;
use crate::mesh::Mesh;

/// A closed cylinder about the vertical through the centre: `sides` side faces counter-clockwise as seen from above,
/// then the top and the bottom. The minimum is three sides. Around the sides u goes
/// once from 0 to 1, and v goes from bottom to top. The top and the bottom show the texture as seen from outside, with
/// x to the right.
pub fn cylinder(sides: usize) -> Mesh {
    let sides = circle::sides(sides);
    let ring: Vec<DVec2> = circle::corners(sides).collect();
    let points = [0.0, 1.0].iter().flat_map(|&y| ring.iter().map(move |p| DVec3::new(p.x, y, p.y))).collect();
    let mut faces = FaceBuilder::new(points, 6 * sides);
    let around = |i: usize| i as f64 / sides as f64;
    for i in 0..sides {
        let next = (i + 1) % sides;
        let [left, right] = [i, i + 1].each(around);
        faces.face([
            (i, DVec2::new(left, 0.0)),
            (next, DVec2::new(right, 0.0)),
            (sides + next, DVec2::new(right, 1.0)),
            (sides + i, DVec2::new(left, 1.0)),
        ]);
    }
    faces.face((0..sides).map(|i| (sides + i, circle::from_above(ring[i]))));
    faces.face(turned_over(sides).map(|i| (i, ring[i])));
    faces.finish(true)
}

/// The corners of a reversed ring that keeps its first edge: 1 0 n-1 … 2.
pub(super) fn turned_over(sides: usize) -> impl Iterator<Item = usize> {
    [1, 0].into_iter().chain((2..sides).rev())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_come_first_then_top_and_bottom() {
        assert_eq!(cylinder(16).face(16).normal(), DVec3::Y);
        assert_eq!(cylinder(16).face(17).normal(), DVec3::NEG_Y);
        let square = cylinder(4);
        let normals: Vec<DVec3> = square.faces().map(|face| face.normal()).collect();
        assert_eq!(normals, [DVec3::Z, DVec3::X, DVec3::NEG_Z, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y]);
    }
}
