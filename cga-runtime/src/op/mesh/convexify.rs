//! `convexify`: cuts concave faces into convex ones.

use crate::geometry::convexify::convexify as convexify_mesh;
use crate::op::face::refused::report_refused;
use crate::run::env::Env;
use crate::shape::{Geometry, Shape};

/// `convexify()`: cuts each concave face, and each face with holes, into convex faces (*convexify operation*). Convex faces stay
/// as they are; straight corners count as convex. Points at the ends of cuts are in all faces around them, so faces stay
/// connected, as straight corners of neighbours, and closed geometry stays closed. Parts keep the tags, the group and the
/// material of their face; texture coordinates and normals are interpolated along edges. Bent faces keep their bend.
///
/// A cut begins at a concave corner and continues one of its edges to the other side of the face, or joins two concave corners.
/// The shortest cut is made first; of two with equal lengths the one that needs no new point. The parts come in the place of
/// their face, in the order of its edges, and begin with these.
///
/// A face that crosses itself stays, with a fault.
pub fn convexify(env: &mut Env, shape: &mut Shape) {
    cut(env, shape, f64::INFINITY);
}

/// `convexify(maxLength)`: the same with cuts that are shorter than `maxLength` metres. Parts may stay concave or keep holes. A
/// cut that would leave the face in one piece is not made.
pub fn convexify_within(env: &mut Env, shape: &mut Shape, max_length: f64) {
    let longest = env.finite(max_length, "the length of `convexify`");
    cut(env, shape, longest);
}

fn cut(env: &mut Env, shape: &mut Shape, longest: f64) {
    // The faces of boxes and rectangles are convex.
    if !matches!(shape.geometry, Geometry::Mesh(_)) {
        return;
    }
    let mesh = shape.to_mesh();
    let made = convexify_mesh(&mesh, longest);
    let refused: Vec<(usize, ())> = made.refused.iter().map(|face| (*face, ())).collect();
    report_refused(env, "convexify", &refused, &[((), "touches or crosses itself")]);
    if let Some((mut made, origins)) = made.made
        && env.count_vertices(&made).is_continue()
    {
        if !mesh.trace().is_empty() {
            made.set_trace(env.cut_trace(mesh.trace(), &origins));
        }
        shape.put_mesh(made);
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::extrude::{Extrude, extrude};
    use crate::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
    use crate::op::{self, Length};

    fn l(length: f64) -> Mesh {
        let corners = [(0.0, 10.0), (10.0, 10.0), (10.0, 5.0), (5.0, 5.0), (5.0, 0.0), (0.0, 0.0)];
        Mesh::from_polygon(&corners.map(|(x, z)| DVec3::new(x * length / 10.0, 0.0, z)), &[]).unwrap()
    }

    fn areas(shape: &Shape) -> Vec<f64> {
        shape.to_mesh().faces().map(|face| face.area()).collect()
    }

    #[test]
    fn the_scope_stays_and_lengths_are_those_of_the_scope() {
        let env = &mut Env::for_tests();
        let mut shape = Shape::mesh_axis_aligned(l(10.0));
        op::size(env, &mut shape, Length::Absolute(100.0), Length::Absolute(0.0), Length::Absolute(10.0));
        let before = shape.scope;
        // Across the arm the cut is 50 m long, along it 5 m.
        convexify_within(env, &mut shape, 5.0);
        assert_eq!(areas(&shape).len(), 1);
        convexify_within(env, &mut shape, 5.5);
        assert_eq!((areas(&shape), shape.scope), (vec![500.0, 250.0], before));
        op::size(env, &mut shape, Length::Absolute(10.0), Length::Absolute(0.0), Length::Absolute(10.0));
        assert_eq!(areas(&shape), [50.0, 25.0]);
        assert!(env.take_faults().0.is_empty());
    }

    #[test]
    fn mirrored_and_unadjusted_scopes_stay_as_they_are() {
        let env = &mut Env::for_tests();
        let block = extrude(&l(10.0), Extrude::FaceNormal, 4.0);
        let mut mirrored = Shape::mesh_axis_aligned(block.clone());
        op::size(env, &mut mirrored, Length::Absolute(-10.0), Length::Absolute(4.0), Length::Absolute(10.0));
        let mut wide = Shape::mesh_axis_aligned(block);
        wide.scope.size.x = 20.0;
        let Geometry::Mesh(placed) = &wide.geometry else { panic!("a mesh") };
        let placed = crate::shape::Placed { size: wide.scope.size, ..crate::shape::Placed::clone(placed) };
        wide.geometry = Geometry::Mesh(std::sync::Arc::new(placed));
        for mut shape in [mirrored, wide] {
            let (scope, inwards, before) = (shape.scope, shape.looks_inwards(), shape.to_mesh());
            convexify(env, &mut shape);
            let mesh = shape.to_mesh();
            assert_eq!((shape.scope, shape.looks_inwards()), (scope, inwards));
            assert_eq!((mesh.face_count(), mesh.volume()), (before.face_count() + 2, before.volume()));
            assert_eq!(&mesh.points()[..12], before.points());
        }
        assert!(env.take_faults().0.is_empty());
    }

    #[test]
    fn faces_that_cross_themselves_leave_a_fault() {
        let mut builder = MeshBuilder::new();
        let bow = [(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 3.0)].map(|(x, z)| builder.point([x, 0.0, z]));
        builder.face(&bow, &[], FaceTag::PLAIN);
        let mut shape = Shape::mesh_axis_aligned(builder.build().unwrap());
        let (env, before) = (&mut Env::for_tests(), shape.to_mesh());
        convexify(env, &mut shape);
        let (faults, _) = env.take_faults();
        assert_eq!(faults[0].message, "`convexify`: face 0 touches or crosses itself; it stays as it is");
        assert_eq!(shape.to_mesh().corners(), before.corners());
        convexify_within(env, &mut shape, f64::NAN);
        assert_eq!(env.take_faults().0.len(), 1);
    }
}
