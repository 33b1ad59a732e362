//! Meshes with one polygon, for footprints and facades.

use std::ops::Range;

use glam::DVec3;

use super::map::flip;
use super::{FaceTag, Mesh, MeshBuilder, MeshError, simple_loops};
use crate::triangulate::PlaneProjection;
use crate::vector::{area_vector, unit};

impl Mesh {
    /// A mesh with one face from an outline, counter-clockwise as seen from the front, and holes with any winding.
    /// Repeated corners are removed. Loops are checked in time `n log n` for `n` corners.
    ///
    /// # Errors
    /// An error if a coordinate is not finite, a loop has fewer than three different corners, the outline has no area,
    /// or edges cross, overlap, or touch except at corners.
    pub fn from_polygon(outer: &[DVec3], holes: &[Vec<DVec3>]) -> Result<Mesh, MeshError> {
        let mut points: Vec<DVec3> = Vec::new();
        let mut rings: Vec<Range<usize>> = Vec::new();
        let mut given = 0;
        for (ring, loop_points) in std::iter::once(outer).chain(holes.iter().map(Vec::as_slice)).enumerate() {
            if let Some(point) = loop_points.iter().position(|p| !p.is_finite()) {
                return Err(MeshError::NotFinite { point: given + point });
            }
            given += loop_points.len();
            let start = points.len();
            for (i, &p) in loop_points.iter().enumerate() {
                let before = loop_points[if i == 0 { loop_points.len() - 1 } else { i - 1 }];
                if p != before {
                    points.push(p + 0.0);
                }
            }
            if points.len() - start < 3 {
                return Err(MeshError::ShortLoop { face: 0, ring });
            }
            rings.push(start..points.len());
        }
        let normal = ring_area(&points[rings[0].clone()]);
        if unit(normal) == DVec3::ZERO || !normal.is_finite() {
            return Err(MeshError::ZeroArea);
        }
        for ring in &rings[1..] {
            if ring_area(&points[ring.clone()]).dot(normal) > 0.0 {
                flip(&mut points[ring.clone()]);
            }
        }
        let flat = PlaneProjection::along(normal);
        let in_plane = |ring: &Range<usize>| points[ring.clone()].iter().map(|&p| flat.apply(p)).collect();
        simple_loops::check(&rings.iter().map(in_plane).collect::<Vec<_>>())?;

        let mut builder = MeshBuilder::new();
        let indices: Vec<u32> = points.iter().map(|&p| builder.point(p)).collect();
        let holes: Vec<&[u32]> = rings[1..].iter().map(|ring| &indices[ring.clone()]).collect();
        builder.face(&indices[rings[0].clone()], &holes, FaceTag::PLAIN);
        builder.build()
    }
}

/// The area vector of a loop.
fn ring_area(ring: &[DVec3]) -> DVec3 {
    area_vector([ring.iter().copied()].into_iter())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(points: &[(f64, f64)]) -> Vec<DVec3> {
        points.iter().map(|&(x, z)| DVec3::new(x, 0.0, -z)).collect()
    }

    #[test]
    fn holes_lie_inside_the_outline_and_outside_of_each_other() {
        let square = |from: f64, to: f64| flat(&[(from, from), (to, from), (to, to), (from, to)]);
        let outer = square(0.0, 5.0);
        let place = |holes: &[Vec<DVec3>]| Mesh::from_polygon(&outer, holes).map(|mesh| mesh.area());
        assert_eq!(place(&[square(1.0, 2.0), square(3.0, 4.0)]), Ok(23.0));
        assert_eq!(place(&[square(10.0, 11.0)]), Err(MeshError::HolePlace { hole: 0, within: None }));
        let nested = [square(2.0, 3.0), square(1.0, 4.0)];
        assert_eq!(place(&nested), Err(MeshError::HolePlace { hole: 0, within: Some(1) }));
    }

    #[test]
    fn holes_are_turned_the_right_way() {
        let outer = flat(&[(0.0, 0.0), (4.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        let hole = flat(&[(1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0)]);
        let mut turned = hole.clone();
        turned.reverse();
        for hole in [hole, turned] {
            let mesh = Mesh::from_polygon(&outer, &[hole]).unwrap();
            assert_eq!(mesh.area(), 15.0);
            assert_eq!(mesh.face(0).normal(), DVec3::Y);
            assert_eq!(mesh.face(0).outer().len(), 4);
        }
    }

    #[test]
    fn crossing_and_empty_outlines_are_named() {
        let bow = flat(&[(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 3.0)]);
        let crossing = MeshError::SelfCrossing { first: (0, 0), second: (0, 2) };
        assert_eq!(Mesh::from_polygon(&bow, &[]).unwrap_err(), crossing);
        let line = flat(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]);
        assert_eq!(Mesh::from_polygon(&line, &[]).unwrap_err(), MeshError::ZeroArea);
        let two = flat(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.0)]);
        assert_eq!(Mesh::from_polygon(&two, &[]).unwrap_err(), MeshError::ShortLoop { face: 0, ring: 0 });
        let spike = flat(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (4.0, 6.0), (4.0, 4.0), (0.0, 4.0)]);
        assert!(Mesh::from_polygon(&spike, &[]).is_err());
    }

    #[test]
    fn a_pinched_outline_is_allowed() {
        let pinched =
            flat(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (4.0, 2.0), (4.0, 4.0), (2.0, 4.0), (2.0, 2.0), (0.0, 2.0)]);
        assert_eq!(Mesh::from_polygon(&pinched, &[]).unwrap().area(), 8.0);
    }
}
