//! `resetGeometry`: the geometry of the initial shape again.

use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::trim::Trims;

/// `resetGeometry()`: replaces geometry, scope and pivot by the ones of the initial shape (*resetGeometry operation*). Trim planes
/// are removed. Attributes, the material, values of `set` and the projections of `setupProjection` stay; texture coordinates and
/// tags are taken from the initial shape.
pub fn reset_geometry(env: &mut Env, shape: &mut Shape) {
    let Some(initial) = &env.initial.shape else { return };
    (shape.scope, shape.pivot) = (initial.scope, initial.pivot);
    shape.geometry = initial.geometry.clone();
    shape.trims = Trims::None;
    let coordinates = initial.state.coordinates();
    if shape.state.coordinates() != coordinates {
        shape.state.change_look().coordinates = coordinates.clone();
    }
    if shape.state.get().is_some_and(|state| state.foreign) {
        shape.state.change().foreign = false;
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::geometry::mesh::Mesh;
    use crate::op;
    use crate::run::settings::Settings;
    use crate::shape::Geometry;
    use cga_split::Size;

    #[test]
    fn geometry_scope_and_pivot_come_back_and_the_rest_stays() {
        let corners = [(0.0, 9.0), (8.0, 9.0), (6.0, 0.0), (0.0, 0.0)].map(|(x, z)| glam::DVec3::new(x, 1.0, z));
        let mesh = Mesh::from_polygon(&corners, &[]).unwrap();
        let initial = Shape::mesh(mesh.with_uv_set(3, vec![DVec2::ONE; 4])).named("Lot");
        let env = &mut Env::with_names(&Settings::default(), &["Lot"], &initial, "Lot");
        let mut shape = initial.clone();
        op::color_rgb(env, &mut shape, 1.0, 0.0, 0.0);
        op::translate(env, &mut shape, op::Length::Absolute(5.0), op::Length::Absolute(1.0), op::Length::Absolute(2.0));
        op::rotate(env, &mut shape, 10.0, 20.0, 30.0);
        op::cube(env, &mut shape);
        let one = Size::absolute(1.0);
        op::setup_projection(env, &mut shape, 0.0, op::ProjectionAxes::ScopeXy, one, one);
        op::project_uv(env, &mut shape, 0.0);
        let colour = shape.material().color;
        reset_geometry(env, &mut shape);
        assert_eq!((shape.scope, shape.pivot), (initial.scope, initial.pivot));
        let (mesh, first) = (shape.to_mesh(), initial.to_mesh());
        assert_eq!((mesh.points(), mesh.corners(), mesh.uv_set(3)), (first.points(), first.corners(), first.uv_set(3)));
        assert!(mesh.uv_set(0).is_empty() && matches!(shape.trims, Trims::None));
        assert!(shape.material().color == colour && colour.is_some());
        assert!(!shape.state.get().unwrap().foreign);
        op::project_uv(env, &mut shape, 0.0);
        assert_eq!(shape.to_mesh().uv_set(0).len(), 4);
        assert!(matches!(initial.geometry, Geometry::Mesh(_)) && env.take_faults().0.is_empty());
    }
}
