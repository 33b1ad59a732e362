//! `taper`: a pyramid over a face.

use glam::DVec3;

use crate::geometry::derive::{CornerValues, Derivation, FaceOrigin, PointOrigin};
use crate::geometry::each::Each;
use crate::geometry::mesh::{Bounds, FaceRef, Mesh, flip};
use crate::op::create::extrude::stand;
use crate::run::env::Env;
use crate::shape::Shape;

/// `taper(height)`: a closed pyramid over the first face that has an area, with its apex that far above the face's centre of
/// gravity (*taper operation*). The new scope's y axis is the normal of the face, its x axis stays as near to the old one as it
/// can, and the pivot stays. A negative height gives a negative size along y, and faces that look inwards.
pub fn taper(env: &mut Env, shape: &mut Shape, height: f64) {
    let height = env.finite(height, "the height of `taper`");
    if height == 0.0 || !shape.geometry.has_surface() {
        return;
    }
    let mesh = shape.to_mesh();
    let Some(face) = mesh.faces().find(|face| face.normal() != DVec3::ZERO) else { return };
    if env.count_corners(4 * face.corner_count() as u64).is_break() {
        return;
    }
    stand(env, shape, pyramid(&mesh, &face, height), face.normal(), height, "`taper`");
}

/// The face turned over, then a triangle for each of its edges, outline before holes.
fn pyramid(source: &Mesh, face: &FaceRef<'_>, height: f64) -> Mesh {
    let mut made = Derivation::new(source, CornerValues::Coordinates, 4 * face.corner_count());
    let range = face.corner_range();
    // Each corner has a point of its own.
    range.clone().for_each(|corner| _ = made.old_point(source.corners()[corner]));
    let apex = made.point(centre_of_gravity(face) + face.normal() * height, PointOrigin::Grown);
    let number = |corner: usize| (corner - range.start) as u32;
    let turned = face.loop_ranges().map(|ring| {
        let mut ring: Vec<u32> = ring.map(number).collect();
        flip(&mut ring);
        ring
    });
    made.face(turned, FaceOrigin::over(face, "taper.bottom").turned());
    for edge in face.edges() {
        let [a, b] = edge.each(number);
        made.face([[a, b, apex]], FaceOrigin::over_edge(face, "taper.side", edge));
    }
    made.finish()
}

/// The centre of gravity of a face, without its holes.
fn centre_of_gravity(face: &FaceRef<'_>) -> DVec3 {
    let (normal, origin) = (face.normal(), face.position(face.corner_range().start));
    // At a size of about 1 no product overflows or vanishes.
    let scale = Bounds::of(face.corner_range().map(|corner| face.position(corner) - origin)).scale_to_one();
    let (mut area, mut moment) = (0.0, DVec3::ZERO);
    for ring in face.loop_ranges() {
        for corner in ring.clone() {
            let next = if corner + 1 == ring.end { ring.start } else { corner + 1 };
            let [a, b] = [corner, next].each(|corner| (face.position(corner) - origin) * scale);
            let twice = a.cross(b).dot(normal);
            area += twice;
            moment += (a + b) * twice;
        }
    }
    let middle = moment / (3.0 * area) / scale;
    if middle.is_finite() {
        return origin + middle;
    }
    // So thin that even then its area vanishes.
    let corners = face.corner_range().map(|corner| face.position(corner) - origin);
    origin + corners.sum::<DVec3>() / face.corner_count() as f64
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::geometry::mesh::Mesh;

    fn tapered(mut shape: Shape, height: f64) -> Shape {
        let env = &mut Env::for_tests();
        let pivot = shape.pivot;
        taper(env, &mut shape, height);
        assert!(env.take_faults().0.is_empty());
        assert_eq!(shape.pivot, pivot);
        shape
    }

    #[test]
    fn a_rectangle_becomes_a_pyramid_of_five_faces() {
        let shape = tapered(Shape::rectangle(10.0, 8.0), 10.0);
        let mesh = shape.to_mesh();
        assert_eq!((mesh.face_count(), mesh.points().len()), (5, 5));
        assert!(mesh.is_closed() && mesh.check().is_empty());
        assert!((mesh.volume() - 10.0 * 8.0 * 10.0 / 3.0).abs() < 1e-9);
        assert_eq!(shape.scope.size, DVec3::new(10.0, 10.0, 8.0));
        let tags = |face: usize, tag| mesh.tag_sets()[mesh.face(face).tag().tags as usize].has(tag);
        assert!(tags(0, "taper.bottom") && (1..5).all(|face| tags(face, "taper.side")));
    }

    #[test]
    fn a_negative_height_leads_downwards() {
        let shape = tapered(Shape::rectangle(10.0, 8.0), -6.0);
        assert_eq!(shape.scope.size, DVec3::new(10.0, -6.0, 8.0));
        assert!((shape.to_mesh().volume() + 160.0).abs() < 1e-9 && shape.to_mesh().is_closed());
    }

    #[test]
    fn the_apex_stands_over_the_centre_of_gravity() {
        let hole = [[1.0, 0.0, -1.0], [1.0, 0.0, -3.0], [3.0, 0.0, -3.0], [3.0, 0.0, -1.0]].map(DVec3::from_array);
        for (outline, holes, centre, volume) in [
            (
                [[0.0, 0.0, 0.0], [6.0, 0.0, 0.0], [0.0, 0.0, -9.0]].map(DVec3::from_array).to_vec(),
                vec![],
                (2.0, -3.0),
                27.0,
            ),
            (
                [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 0.0, -4.0], [0.0, 0.0, -4.0]]
                    .map(DVec3::from_array)
                    .to_vec(),
                vec![hole.to_vec()],
                (192.0 / 36.0, -2.0),
                36.0,
            ),
        ] {
            let shape = Shape::mesh_axis_aligned(Mesh::from_polygon(&outline, &holes).expect("a face"));
            let shape = tapered(shape, 3.0);
            let mesh = shape.to_mesh();
            let apex = mesh.points()[mesh.points().len() - 1];
            let apex = shape.scope.origin + shape.scope.axes * apex;
            assert!((apex - DVec3::new(centre.0, 3.0, centre.1)).length() < 1e-9, "{apex}");
            assert!(mesh.is_closed() && mesh.check().is_empty(), "{:?}", mesh.check());
            assert!((mesh.volume() - volume).abs() < 1e-9, "{}", mesh.volume());
        }
    }

    #[test]
    fn only_the_first_face_is_tapered() {
        let mut builder = crate::geometry::mesh::MeshBuilder::new();
        for x in [0.0, 20.0] {
            let ring = [[x, 0.0, 0.0], [x + 10.0, 0.0, 0.0], [x + 10.0, 0.0, -8.0], [x, 0.0, -8.0]];
            let points = ring.map(|at| builder.point(at));
            builder.face(&points, &[], Default::default());
        }
        let shape = tapered(Shape::mesh_axis_aligned(builder.build().expect("two faces")), 10.0);
        assert_eq!((shape.to_mesh().face_count(), shape.scope.size), (5, DVec3::new(10.0, 10.0, 8.0)));
    }

    #[test]
    fn texture_coordinates_are_kept() {
        let mut builder = crate::geometry::mesh::MeshBuilder::new();
        let ring = [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [5.0, 0.0, -6.0], [0.0, 0.0, -4.0]];
        let points = ring.map(|at| builder.point(at));
        builder.face(&points, &[], Default::default());
        builder.uvs(&ring.map(|[x, _, z]| DVec2::new(0.5 * x, 2.0 * z + 1.0)));
        let shape = tapered(Shape::mesh_axis_aligned(builder.build().expect("a face")), 1.0);
        let mesh = shape.to_mesh();
        for (corner, uv) in mesh.corners().iter().zip(mesh.uvs()) {
            let at = shape.scope.origin + mesh.points()[*corner as usize];
            let expected = DVec2::new(0.5 * at.x, 2.0 * at.z + 1.0);
            assert!((*uv - expected).length() < 1e-9, "{at} {uv}");
        }
        assert_eq!(mesh.uvs().len(), mesh.corners().len());
    }

    #[test]
    fn a_second_taper_replaces_the_tags_of_the_first() {
        let mesh = tapered(tapered(Shape::rectangle(10.0, 8.0), 3.0), 2.0).to_mesh();
        let names = |face: usize| mesh.tag_sets()[mesh.face(face).tag().tags as usize].names().len();
        assert!((0..mesh.face_count()).all(|face| names(face) == 1));
    }

    #[test]
    fn the_apex_of_a_face_that_is_almost_nothing_is_finite() {
        for [width, depth] in [[5e-324, 1.0], [1e-310, 1e-310], [1e-200, 1e-160], [1e100, 5e-324]] {
            let mesh = tapered(Shape::rectangle(width, depth), 2.0).to_mesh();
            assert!(mesh.points().iter().all(|point| point.is_finite()), "{width} by {depth}");
        }
    }

    #[test]
    fn nothing_to_taper_stays_as_it_is() {
        for (shape, height) in
            [(Shape::rectangle(1.0, 1.0), 0.0), (Shape::line([0.0; 3], [2.0, 0.0, 0.0]).unwrap(), 3.0)]
        {
            let before = shape.scope;
            assert_eq!(tapered(shape, height).scope, before);
        }
        let (env, mut shape) = (&mut Env::for_tests(), Shape::rectangle(1.0, 1.0));
        taper(env, &mut shape, f64::NAN);
        assert_eq!(env.take_faults().0.len(), 1);
    }
}
