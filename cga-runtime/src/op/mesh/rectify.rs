//! `rectify`: right angles.

use crate::fault::FaultKind;
use crate::geometry::rectify::rectify as rectify_mesh;
use crate::op::mesh::same_scope::put_reshaped;
use crate::run::env::Env;
use crate::shape::{Geometry, Shape};

/// `rectify(angle)` (*rectify operation*): makes edges parallel to the axes of the scope that deviate from them by less than `angle`
/// degrees, from 0 to 45, as seen along the axis across most of the geometry. Values outside count as the nearest of them.
///
/// An edge turns about its middle, and its ends are where the turned edges meet. Faces in one plane stay in it. Holes that vanish are
/// removed; lines that move over each other leave faces that cross themselves, as the page warns. The scope is fitted to the
/// geometry. If a face would vanish or turn over, the shape stays as it is, with a fault.
pub fn rectify(env: &mut Env, shape: &mut Shape, angle: f64) {
    let limit = env.finite(angle, "the angle of `rectify`").clamp(0.0, 45.0);
    // The edges of boxes and rectangles are parallel to the axes.
    let Geometry::Mesh(_) = shape.geometry else { return };
    let mesh = shape.to_mesh();
    if limit == 0.0 || env.count_vertices(&mesh).is_break() {
        return;
    }
    match rectify_mesh(&mesh, limit) {
        Ok(None) => {}
        Ok(Some(made)) => put_reshaped(shape, made),
        Err(collapsed) => {
            let message =
                format!("`rectify`: face {} would vanish or turn over; the shape stays as it is", collapsed.face);
            env.fault(FaultKind::Geometry, message);
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::mesh::Mesh;
    use crate::op;

    fn lot(corners: &[(f64, f64)]) -> Shape {
        let corners: Vec<DVec3> = corners.iter().map(|&(x, z)| DVec3::new(x, 0.0, -z)).collect();
        Shape::mesh_axis_aligned(Mesh::from_polygon(&corners, &[]).unwrap())
    }

    #[test]
    fn edges_follow_the_scope_and_the_scope_the_geometry() {
        let env = &mut Env::for_tests();
        let mut shape = lot(&[(0.0, 0.0), (10.0, 1.0), (10.0, 9.0), (1.0, 8.0)]);
        op::rotate(env, &mut shape, 20.0, 30.0, 40.0);
        rectify(env, &mut shape, 15.0);
        // Heights of 0.5 and 8.5, and x of 0.5 and 10.
        assert!((shape.scope.size - DVec3::new(9.5, 0.0, 8.0)).length() < 1e-12, "{}", shape.scope.size);
        assert!((shape.to_mesh().area() - 76.0).abs() < 1e-9);
        assert!(env.take_faults().0.is_empty());
    }

    #[test]
    fn a_face_that_would_vanish_leaves_a_fault_and_boxes_stay() {
        let env = &mut Env::for_tests();
        let mut flat = lot(&[(0.0, 0.0), (10.0, 0.0), (5.0, 1.0)]);
        let before = (flat.scope, flat.to_mesh().points().to_vec());
        rectify(env, &mut flat, 90.0);
        assert_eq!((flat.scope, flat.to_mesh().points().to_vec()), before);
        let message = "`rectify`: face 0 would vanish or turn over; the shape stays as it is";
        assert_eq!(env.take_faults().0[0].message, message);
        let mut shape = Shape::rectangle(3.0, 2.0);
        rectify(env, &mut shape, 45.0);
        assert!(matches!(shape.geometry, Geometry::Rect(..)));
        for (angle, faults) in [(f64::NAN, 1), (f64::INFINITY, 1), (f64::NEG_INFINITY, 1), (-20.0, 0)] {
            rectify(env, &mut flat, angle);
            assert_eq!((flat.scope, flat.to_mesh().points()), (before.0, before.1.as_slice()));
            assert_eq!(env.take_faults().0.len(), faults, "{angle}");
        }
    }
}
