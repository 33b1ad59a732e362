//! `setNormals` and `softenNormals`: the normals that sinks shade with, and the sides to which faces look.

use glam::DVec3;

use crate::geometry::conform::conform;
use crate::op::face::refused::report_refused;
use crate::run::env::Env;
use crate::shape::Shape;

/// The normals of `setNormals`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalsMode {
    /// The normals of faces.
    Hard,
    /// The normals of faces, which are turned to the same side as their neighbours.
    Conform,
    /// The average of all faces at a vertex.
    Soft,
    /// The same across edges flatter than 30 degrees.
    Auto,
}

/// `setNormals(mode)` (*setNormals operation*): `soft` is `softenNormals(180)`, `auto` is `softenNormals(30)`, `hard` is
/// `softenNormals(0)` and removes the normals of vertices.
///
/// `conform` does the same as `hard` and turns faces, which keep their first edges. Faces that share an edge, and at that edge
/// with no other faces, look to the same side. Closed faces look outwards, and faces of cavities into the cavity. Open faces look
/// up rather than down in the world; upright ones look where most of their area looks. Parts that cannot agree, such as a
/// Möbius strip, stay as they are, with a fault.
pub fn set_normals(env: &mut Env, shape: &mut Shape, mode: NormalsMode) {
    match mode {
        NormalsMode::Hard => soften(env, shape, 0.0),
        NormalsMode::Auto => soften(env, shape, 30.0),
        NormalsMode::Soft => soften(env, shape, 180.0),
        NormalsMode::Conform => {
            turn(env, shape);
            soften(env, shape, 0.0);
        }
    }
}

/// `softenNormals(angle)` (*softenNormals operation*): edges whose faces meet at an angle below `angle` in degrees are smooth. A
/// vertex has the average of the normals of the faces that smooth edges connect there; faces in one plane count once. Other
/// edges are hard. Vertices must be shared, as in closed geometry. The scope and the geometry stay.
pub fn soften_normals(env: &mut Env, shape: &mut Shape, angle: f64) {
    let angle = env.finite(angle, "the angle of `softenNormals`");
    soften(env, shape, angle);
}

fn soften(env: &mut Env, shape: &mut Shape, angle: f64) {
    if angle <= 0.0 {
        if shape.geometry.placed().is_some_and(|placed| !placed.mesh.normals().is_empty()) {
            shape.change_mesh(|mesh| mesh.without_normals());
        }
        return;
    }
    // A size stretches angles, so they are measured in the scope.
    let mesh = shape.to_mesh();
    let softened = mesh.softened(angle);
    if env.spend(0).is_break() {
        return;
    }
    if softened.normals() == mesh.normals() || env.count_vertices(&mesh).is_break() {
        return;
    }
    shape.put_mesh(softened);
}

/// Turns faces until neighbours agree.
fn turn(env: &mut Env, shape: &mut Shape) {
    let Some(placed) = shape.geometry.placed() else { return };
    let up = shape.scope.axes.transpose() * DVec3::Y;
    let mesh = shape.to_mesh();
    let found = conform(&mesh, up);
    if env.spend(0).is_break() {
        return;
    }
    let refused: Vec<(usize, ())> = found.refused.iter().map(|face| (*face, ())).collect();
    report_refused(env, "setNormals(conform)", &refused, &[((), "has neighbours that cannot agree")]);
    if !found.turned.contains(&true) || env.count_vertices(&mesh).is_break() {
        return;
    }
    let mesh = placed.mesh.turned(|face| found.turned[face]);
    shape.hold_as_mesh();
    shape.change_mesh(|_| mesh);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::mesh::Mesh;
    use crate::geometry::primitive;
    use crate::op::{self, Length};
    use crate::shape::Geometry;

    fn prism() -> Shape {
        Shape::mesh_axis_aligned(primitive::cylinder(12))
    }

    #[test]
    fn modes_are_angles() {
        let env = &mut Env::for_tests();
        for (mode, angle) in [(NormalsMode::Soft, 180.0), (NormalsMode::Auto, 30.0), (NormalsMode::Hard, 0.0)] {
            let [mut one, mut two] = [prism(), prism()];
            set_normals(env, &mut one, mode);
            soften_normals(env, &mut two, angle);
            assert_eq!(one.to_mesh().normals(), two.to_mesh().normals());
            assert_eq!(one.scope, prism().scope);
        }
        let mut shape = prism();
        set_normals(env, &mut shape, NormalsMode::Soft);
        assert_eq!(shape.to_mesh().normals().len(), shape.to_mesh().corners().len());
        // The sides meet at 30 degrees exactly, so they are hard.
        set_normals(env, &mut shape, NormalsMode::Auto);
        assert!(shape.to_mesh().normals().is_empty());
        assert!(env.take_faults().0.is_empty());
    }

    #[test]
    fn angles_that_are_no_number_are_none() {
        let env = &mut Env::for_tests();
        for (angle, faults, is_soft) in [
            (f64::NAN, 1, false),
            (f64::INFINITY, 1, false),
            (f64::NEG_INFINITY, 1, false),
            (-30.0, 0, false),
            (1e300, 0, true),
        ] {
            let mut shape = prism();
            soften_normals(env, &mut shape, angle);
            let found = (env.take_faults().0.len(), !shape.to_mesh().normals().is_empty());
            assert_eq!(found, (faults, is_soft), "{angle}");
            assert_eq!(shape.to_mesh().points(), prism().to_mesh().points());
        }
    }

    #[test]
    fn angles_are_those_of_the_stretched_shape() {
        let env = &mut Env::for_tests();
        let mut shape = prism();
        // Stretched along x, some sides meet at less than 30 degrees.
        op::size(env, &mut shape, Length::Absolute(5.0), Length::Absolute(1.0), Length::Absolute(1.0));
        set_normals(env, &mut shape, NormalsMode::Auto);
        let (mesh, size) = (shape.to_mesh(), shape.scope.size);
        assert!(!mesh.normals().is_empty() && mesh.normals().iter().all(|n| (n.length() - 1.0).abs() < 1e-12));
        // Stretched back, they keep standing at right angles to the surface that they were computed for.
        op::size(env, &mut shape, Length::Absolute(1.0), Length::Absolute(1.0), Length::Absolute(1.0));
        let back = shape.to_mesh();
        for (one, other) in mesh.normals().iter().zip(back.normals()) {
            assert!((*one * size).normalize().distance(*other) < 1e-12);
        }
    }

    #[test]
    fn boxes_and_rectangles_stay_what_they_are_unless_an_edge_is_smooth() {
        let env = &mut Env::for_tests();
        for mode in [NormalsMode::Hard, NormalsMode::Auto, NormalsMode::Conform] {
            for mut shape in [Shape::cuboid(1.0, 2.0, 3.0), Shape::rectangle(2.0, 2.0)] {
                set_normals(env, &mut shape, mode);
                assert!(!matches!(shape.geometry, Geometry::Mesh(_)), "{mode:?}");
            }
        }
        let mut shape = Shape::cuboid(1.0, 2.0, 3.0);
        set_normals(env, &mut shape, NormalsMode::Soft);
        let mesh = shape.to_mesh();
        let share = 3f64.sqrt().recip();
        assert!(mesh.normals().iter().all(|n| (n.abs() - DVec3::splat(share)).length() < 1e-12));
    }

    #[test]
    fn conform_prefers_up_in_the_world() {
        let env = &mut Env::for_tests();
        let mut lot = Shape::rectangle(3.0, 2.0);
        op::rotate(env, &mut lot, 180.0, 0.0, 0.0);
        let before = (lot.scope, lot.to_mesh());
        set_normals(env, &mut lot, NormalsMode::Conform);
        let mesh = lot.to_mesh();
        assert_eq!((lot.scope, mesh.points()), (before.0, before.1.points()));
        assert!((lot.scope.axes * mesh.face(0).normal() - DVec3::Y).length() < 1e-12);
        // The first edge stays, turned.
        let first = |mesh: &Mesh| [0, 1].map(|k| mesh.corners()[k]);
        let [a, b] = first(&before.1);
        assert_eq!(first(&mesh), [b, a]);
        assert!(env.take_faults().0.is_empty());
    }
}
