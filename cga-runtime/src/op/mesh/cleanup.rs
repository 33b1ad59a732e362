//! `cleanupGeometry`: merges parts that are nearly the same.

use crate::fault::FaultKind;
use crate::geometry::cleanup::{Parts, cleanup};
use crate::op::mesh::same_scope::put_reshaped;
use crate::run::env::Env;
use crate::shape::{Geometry, Shape};

/// The parts that `cleanupGeometry` cleans up. All of them merge vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CleanupComponents {
    /// Vertices between collinear edges.
    Vertices,
    /// Edges between coplanar faces.
    Edges,
    /// Doubled and small faces.
    Faces,
    /// All of these.
    All,
}

/// `cleanupGeometry(components, tolerance)` (*cleanupGeometry operation*). With the tolerance 0 only parts go that change nothing
/// except for rounding. With the tolerance `t` vertices less than `t` metres apart are one, edges and normals less than `10 t` degrees
/// apart are collinear and coplanar if nothing moves by `t` metres, and faces below `t` square metres go. Values outside 0 to 1
/// count as the nearest of them.
///
/// A vertex becomes the first one near it, except where that would turn a face over. Edges stay if they have tags, if their faces
/// differ in tags, group or material, if the texture is not continuous across them, or if more than two faces have them. Vertices
/// with tags stay, and so do those between edges with different tags. First edges stay.
///
/// A closed mesh stays closed: a face that closes it stays however small it is, and of two opposite faces inside a solid both go.
/// Otherwise one of doubled or opposite faces stays. The scope is fitted to the geometry. If nothing is left, the shape has no
/// geometry. A closed mesh with an area that is not small stays instead, with a fault.
pub fn cleanup_geometry(env: &mut Env, shape: &mut Shape, components: CleanupComponents, tolerance: f64) {
    let tolerance = env.finite(tolerance, "the tolerance of `cleanupGeometry`").clamp(0.0, 1.0);
    let parts = |one: CleanupComponents| components == one || components == CleanupComponents::All;
    let parts = Parts {
        vertices: parts(CleanupComponents::Vertices),
        edges: parts(CleanupComponents::Edges),
        faces: parts(CleanupComponents::Faces),
    };
    if is_clean(shape, tolerance) {
        return;
    }
    let mesh = shape.to_mesh();
    if env.count_vertices(&mesh).is_continue()
        && let Some(made) = cleanup(&mesh, parts, tolerance)
    {
        if made.is_empty() && mesh.is_closed() && tolerance <= mesh.area() {
            env.fault(
                FaultKind::Geometry,
                "`cleanupGeometry`: no face would be left; the shape stays as it is".to_owned(),
            );
        } else {
            put_reshaped(shape, made);
        }
    }
}

/// Returns true for boxes and rectangles that are larger than the tolerance, and for geometry without faces.
fn is_clean(shape: &Shape, tolerance: f64) -> bool {
    let size = shape.scope.size.abs();
    let is_large = |lengths: &[f64]| lengths.iter().all(|&length| tolerance < length);
    match shape.geometry {
        Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => true,
        Geometry::Box(_) => is_large(&size.to_array()),
        Geometry::Rect(axis, _) => {
            let sides: Vec<f64> = (0..3).filter(|&other| other != axis.index()).map(|other| size[other]).collect();
            is_large(&sides) && tolerance < sides[0] * sides[1]
        }
        Geometry::Mesh(_) => false,
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::geometry::extrude::{Extrude, extrude};
    use crate::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
    use crate::op;

    /// A block over a square, whose outline has a point in the middle of each side, and a thin strip beside it.
    fn block() -> Mesh {
        let corners = [(0., 0.), (5., 0.), (10., 0.), (10., -5.), (10., -10.), (5., -10.), (0., -10.), (0., -5.)];
        extrude(
            &Mesh::from_polygon(&corners.map(|(x, z)| DVec3::new(x, 0.0, z)), &[]).unwrap(),
            Extrude::FaceNormal,
            3.0,
        )
    }

    fn counts(shape: &Shape) -> [usize; 2] {
        let mesh = shape.to_mesh();
        [mesh.face_count(), mesh.points().len()]
    }

    #[test]
    fn components_are_cleaned_up_by_their_words() {
        let env = &mut Env::for_tests();
        for (components, expected) in [
            (CleanupComponents::Vertices, [10, 16]),
            (CleanupComponents::Faces, [10, 16]),
            (CleanupComponents::Edges, [6, 16]),
            (CleanupComponents::All, [6, 8]),
        ] {
            let mut shape = Shape::mesh_axis_aligned(block());
            let scope = shape.scope;
            cleanup_geometry(env, &mut shape, components, 0.0);
            assert_eq!((counts(&shape), shape.scope), (expected, scope), "{components:?}");
        }
        // Values out of range are the nearest ones; NaN is 0, with a fault.
        for (tolerance, faults) in [(-1.0, 0), (f64::NAN, 1), (f64::INFINITY, 1), (f64::NEG_INFINITY, 1), (7.0, 0)] {
            let mut shape = Shape::mesh_axis_aligned(block());
            cleanup_geometry(env, &mut shape, CleanupComponents::All, tolerance);
            assert_eq!((counts(&shape), env.take_faults().0.len()), ([6, 8], faults), "{tolerance}");
        }
    }

    #[test]
    fn the_scope_is_fitted_if_it_was_the_box() {
        let env = &mut Env::for_tests();
        let mut builder = MeshBuilder::new();
        for [low, high] in [[0.0, 4.0], [5.0, 5.1]] {
            let ring = [[low, 0.0], [high, 0.0], [high, -1.0], [low, -1.0]].map(|[x, z]| builder.point([x, 0.0, z]));
            builder.face(&ring, &[], FaceTag::PLAIN);
        }
        let strips = Shape::mesh_axis_aligned(builder.build().unwrap());
        let mut shape = strips.clone();
        op::rotate(env, &mut shape, 0.0, 30.0, 0.0);
        cleanup_geometry(env, &mut shape, CleanupComponents::Faces, 0.15);
        assert!((shape.scope.size - DVec3::new(4.0, 0.0, 1.0)).length() < 1e-12);
        assert_eq!(counts(&shape), [1, 4]);
        // A scope that is larger stays, and lengths refer to the scope.
        let mut wide = strips;
        wide.scope.size.x *= 2.0;
        cleanup_geometry(env, &mut wide, CleanupComponents::Faces, 0.15);
        assert_eq!(counts(&wide), [2, 8]);
        cleanup_geometry(env, &mut wide, CleanupComponents::Faces, 0.25);
        assert_eq!((counts(&wide), wide.scope.size.x), ([1, 4], 8.0));
        // Nothing is left. A strip as wide as the tolerance would stay.
        cleanup_geometry(env, &mut wide, CleanupComponents::Vertices, 1.0);
        assert_eq!(counts(&wide), [1, 4]);
        wide.scope.size.z *= 0.999;
        cleanup_geometry(env, &mut wide, CleanupComponents::Vertices, 1.0);
        assert_eq!(counts(&wide), [0, 0]);
        assert!(env.take_faults().0.is_empty());
    }

    /// Merged points leave nothing of thin parts, and so do pairs of faces without an area.
    #[test]
    fn closed_geometry_with_an_area_is_not_lost() {
        let env = &mut Env::for_tests();
        let pair = |corners: &[[f64; 2]]| {
            let mut builder = MeshBuilder::new();
            let front: Vec<u32> = corners.iter().map(|[x, z]| builder.point([*x, 0.0, *z])).collect();
            builder.face(&front, &[], FaceTag::PLAIN);
            builder.face(&front.iter().rev().copied().collect::<Vec<_>>(), &[], FaceTag::PLAIN);
            Shape::mesh_axis_aligned(builder.build().unwrap())
        };
        let strip = pair(&[[0.0, 0.0], [40.0, 0.0], [40.0, 0.05], [0.0, 0.05]]);
        let line = pair(&[[0.0, 0.0], [4.0, 0.0], [1.0, 0.0]]);
        let beam = Shape::cuboid(40.0, 0.05, 0.05);
        let words =
            [CleanupComponents::Vertices, CleanupComponents::Edges, CleanupComponents::Faces, CleanupComponents::All];
        let mut faults = [0; 3];
        for (count, shape) in faults.iter_mut().zip([strip, line, beam]) {
            for (words, tolerance) in words.into_iter().flat_map(|words| [0.0, 0.1, 1.0].map(|t| (words, t))) {
                let mut made = shape.clone();
                cleanup_geometry(env, &mut made, words, tolerance);
                let found = env.take_faults().0;
                let is_small = shape.to_mesh().area() < tolerance;
                assert!(made.geometry.has_surface() || is_small, "{words:?} {tolerance}");
                if !found.is_empty() {
                    let message = "`cleanupGeometry`: no face would be left; the shape stays as it is";
                    assert!(found.len() == 1 && found[0].message == message && !is_small);
                    assert_eq!((made.scope, made.to_mesh().corners()), (shape.scope, shape.to_mesh().corners()));
                    *count += 1;
                }
            }
        }
        assert_eq!(faults, [8, 4, 8]);
        // A tile below the tolerance is a small face, also if it has two sides.
        let mut tile = pair(&[[0.0, 0.0], [0.3, 0.0], [0.3, 0.3]]);
        cleanup_geometry(env, &mut tile, CleanupComponents::All, 0.5);
        assert!(matches!(tile.geometry, Geometry::Empty) && env.take_faults().0.is_empty());
    }

    /// Opposite faces may be divided differently. Then they go when the edges between their parts are gone.
    #[test]
    fn solids_that_touch_are_joined() {
        let env = &mut Env::for_tests();
        let parts = [[0.0, 0.0, 2.0, 4.0], [2.0, 0.0, 2.0, 2.0], [2.0, 2.0, 2.0, 2.0]].map(|[x, y, width, height]| {
            let at = |p: DVec3| DVec3::new(x + width * p.x, y + height * p.y, 4.0 * p.z);
            let cube = crate::geometry::primitive::cube();
            cube.with_points(cube.points().iter().copied().map(at).collect())
        });
        let whole = Shape::mesh_axis_aligned(crate::geometry::mesh::join::join(parts.iter()));
        for tolerance in [0.0, 0.01, 0.1] {
            let mut shape = whole.clone();
            cleanup_geometry(env, &mut shape, CleanupComponents::All, tolerance);
            assert_eq!((counts(&shape), shape.to_mesh().is_closed()), ([6, 8], true), "{tolerance}");
            let before = shape.to_mesh();
            cleanup_geometry(env, &mut shape, CleanupComponents::All, tolerance);
            assert_eq!(shape.to_mesh().points(), before.points());
        }
    }

    #[test]
    fn boxes_stay_boxes_unless_they_are_small() {
        let env = &mut Env::for_tests();
        for mut shape in [Shape::cuboid(1.0, 2.0, 3.0), Shape::rectangle(2.0, 2.0), Shape::rectangle(0.9, 2.0)] {
            let before = shape.clone();
            cleanup_geometry(env, &mut shape, CleanupComponents::All, 0.8);
            assert_eq!((shape.scope, counts(&shape)), (before.scope, counts(&before)));
            assert!(!matches!(shape.geometry, Geometry::Mesh(_)));
        }
        let mut tile = Shape::rectangle(0.5, 0.5);
        cleanup_geometry(env, &mut tile, CleanupComponents::Faces, 0.4);
        assert!(matches!(tile.geometry, Geometry::Empty));
    }
}
