//! `reduceGeometry`: the geometry with fewer vertices.

use crate::geometry::reduce::reduce;
use crate::op::mesh::same_scope::put_reshaped;
use crate::op::tagging::delete_tags::delete_tags;
use crate::run::env::Env;
use crate::shape::Shape;

/// `reduceGeometry(tolerance)` (*reduceGeometry operation*): removes that share of the vertices, from 0 to 1, and all tags. Values
/// outside that range count as the nearest in it.
///
/// Edges collapse, those first that change the form least: a vertex becomes one of its neighbours. Faces without a change stay as they
/// are; of the others triangles are left. Borders, borders between groups and materials, and seams of textures collapse along
/// themselves alone. A closed mesh stays closed. Fewer vertices are removed if no further edge can collapse without turning a
/// triangle over or joining two sheets, and none where more than two faces share an edge. The scope is fitted to the geometry.
pub fn reduce_geometry(env: &mut Env, shape: &mut Shape, tolerance: f64) {
    let share = env.finite(tolerance, "the tolerance of `reduceGeometry`").clamp(0.0, 1.0);
    delete_tags(env, shape);
    if share == 0.0 || !shape.geometry.has_surface() {
        return;
    }
    let mesh = shape.to_mesh();
    if env.count_vertices(&mesh).is_continue()
        && let Some(made) = reduce(&mesh, share)
    {
        put_reshaped(shape, made);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::primitive;
    use crate::op;

    #[test]
    fn a_share_of_the_vertices_and_all_tags_go() {
        let env = &mut Env::for_tests();
        let mut ball = Shape::mesh_axis_aligned(primitive::sphere(24, 12));
        op::tag(env, &mut ball, "a".into(), op::TagTarget::Auto);
        op::tag(env, &mut ball, "b".into(), op::TagTarget::Edges);
        let before = ball.to_mesh().points().len();
        for (share, expected) in [(0.0, before), (-3.0, before), (0.2, before * 4 / 5)] {
            let mut shape = ball.clone();
            reduce_geometry(env, &mut shape, share);
            let mesh = shape.to_mesh();
            assert_eq!((mesh.points().len(), mesh.is_closed()), (expected, true), "{share}");
            assert!(shape.found_tags(None, op::TaggedComponents::All).next().is_none());
            assert!((mesh.bounds().size() - shape.scope.size).abs().max_element() < 1e-12);
        }
        for share in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            reduce_geometry(env, &mut ball, share);
            assert_eq!((ball.to_mesh().points().len(), env.take_faults().0.len()), (before, 1), "{share}");
        }
        reduce_geometry(env, &mut ball.clone(), 7.0);
        assert!(env.take_faults().0.is_empty());
        let mut line = Shape::rectangle(1.0, 2.0);
        reduce_geometry(env, &mut line, 0.25);
        assert_eq!((line.to_mesh().points().len(), line.to_mesh().face_count()), (3, 1));
    }
}
