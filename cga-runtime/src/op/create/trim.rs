//! `trim`, and the trimming of geometry that is inserted at a face with trim planes.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use crate::geometry::cut::{self, Plane};
use crate::geometry::tol::PLANAR_EPSILON;
use crate::run::env::Env;
use crate::shape::trim::{TrimPlane, Trims};
use crate::shape::{Geometry, Inserted, Placed, Shape};

/// `trim()`: cuts the geometry at the shape's trim planes that `trim.vertical` and `trim.horizontal` switch on (*trim
/// operation*). The shape's pivot decides which switch a plane has. The cuts stay open, and the scope stays.
pub fn trim(env: &mut Env, shape: &mut Shape) {
    let (switches, pivot) = (shape.state.trim(), shape.pivot);
    if !switches.vertical && !switches.horizontal {
        return;
    }
    env.reach(&shape.scope);
    if matches!(shape.trims, Trims::None) || !shape.geometry.has_surface() {
        return;
    }
    for plane in &*shape.trims.planes(&pivot) {
        if if plane.is_horizontal(&pivot) { switches.horizontal } else { switches.vertical } {
            cut(shape, plane);
        }
    }
}

fn cut(shape: &mut Shape, plane: &TrimPlane) {
    let scope = shape.scope;
    let local = Plane { point: scope.frame().to_local(plane.point), normal: scope.axes.transpose() * plane.normal };
    let near = PLANAR_EPSILON * scope.size.abs().max_element();
    // Usually the whole scope is on the near side.
    let below =
        (DVec3::ZERO - local.point).dot(local.normal) + (scope.size * local.normal).min(DVec3::ZERO).element_sum();
    if -near <= below {
        return;
    }
    // In a scope with positive sizes, as negative sizes mirror the contents.
    let (size, sign) = (scope.size.abs(), DVec3::ONE.copysign(scope.size));
    let Some(placed) = shape.geometry.placed() else { return };
    let place = placed.to_scope(size);
    let mesh = if place == DAffine3::IDENTITY { placed.mesh } else { Arc::new(placed.mesh.map(&place)) };
    let local = Plane { point: local.point * sign, normal: local.normal * sign };
    let kept = cut::above(&mesh, &local, near);
    if kept.as_ref().is_some_and(|kept| Arc::ptr_eq(kept, &mesh)) {
        return;
    }
    shape.geometry = match kept {
        Some(mesh) => {
            Geometry::Mesh(Arc::new(Placed { mesh, low: DVec3::ZERO, size, inserted: Inserted::No, ..placed }))
        }
        None => Geometry::Empty,
    };
}

#[cfg(test)]
mod tests {
    use glam::DMat3;

    use super::*;
    use crate::comp::select::Word;
    use crate::comp::{Align, Arm, Components, Mode, Select, comp_values, never};
    use crate::geometry::Frame;
    use crate::geometry::extrude::{Extrude, extrude};
    use crate::geometry::mesh::{Mesh, MeshBuilder};
    use crate::op;
    use crate::query::{geometry_area, geometry_is_closed_surface};
    use crate::shape::Shape;
    use crate::shape::unit::UnitMesh;

    /// The results of `work` for each face, by number.
    fn on_faces(shape: &Shape, mut work: impl FnMut(&mut Env, &mut Shape) -> f64) -> Vec<f64> {
        let arms = [Arm { select: Select::Word(Word::All), mode: Mode::Each, text: "all".into() }];
        let (env, mut shape) = (&mut Env::for_tests(), shape.clone());
        comp_values(env, &mut shape, Components::Faces, Align::ZUp, &arms, never, |env, _, part| work(env, part))
            .as_slice()
            .to_vec()
    }

    /// A slab two metres thick on the face, half a metre wider on all sides.
    fn cover(env: &mut Env, part: &mut Shape) {
        part.scope.origin -= part.scope.axes * DVec3::new(0.5, 0.5, 1.0);
        part.scope.size += DVec3::new(1.0, 1.0, 2.0);
        op::cube(env, part);
    }

    fn extent(shape: &Shape) -> DVec3 {
        shape.to_mesh().bounds().size()
    }

    fn cuboid_mesh(size: DVec3) -> Shape {
        let cube =
            crate::shape::filled_scope::cuboid(&crate::shape::scope::Scope::new(size), UnitMesh::cuboid()).to_mesh();
        Shape::mesh_axis_aligned(cube)
    }

    #[test]
    fn a_side_of_a_box_is_mitred_upright() {
        for shape in [Shape::cuboid(10.0, 8.0, 6.0), cuboid_mesh(DVec3::new(10.0, 8.0, 6.0))] {
            on_faces(&shape, |env, part| {
                let width = part.scope.size.x;
                cover(env, part);
                // Its width in front of the face may be larger by the distance to the face. Upwards nothing cuts.
                let mesh = part.to_mesh();
                let middle = part.scope.size.x * 0.5;
                for point in mesh.points() {
                    let ahead = point.z - 1.0;
                    let room = (width * 0.5 + ahead).min(middle);
                    assert!((point.x - middle).abs() <= room + 1e-9, "{point}");
                }
                assert!((extent(part).y - part.scope.size.y).abs() < 1e-9);
                assert!(!geometry_is_closed_surface(part), "it stays open where it is cut");
                0.0
            });
        }
    }

    #[test]
    fn what_is_cut_in_a_mirrored_scope_is_divided_as_it_lies() {
        let halves = |y: f64, work: fn(&mut Env, &mut Shape)| {
            on_faces(&Shape::cuboid(3.0, 4.0, 5.0), |env, part| {
                part.scope.size += DVec3::new(5.0, 0.0, 4.0);
                part.scope.origin +=
                    part.scope.axes * DVec3::new(0.0, if y < 0.0 { part.scope.size.y } else { 0.0 }, 0.0);
                part.scope.size.y *= y;
                work(env, part);
                let low = part.scope.size.y.min(0.0);
                let bounds = part.to_mesh().bounds();
                assert!(low - 1e-9 <= bounds.low.y && bounds.high.y <= low + part.scope.size.y.abs() + 1e-9);
                let Geometry::Mesh(placed) = &part.geometry else { panic!("the planes cut it") };
                assert!(0.0 <= placed.size.min_element());
                geometry_area(env, part, Word::All)
            })
        };
        for work in [op::cube, op::cylinder] {
            let (upright, mirrored) = (halves(1.0, work), halves(-1.0, work));
            for (a, b) in upright.iter().zip(&mirrored) {
                assert!((a - b).abs() < 1e-9 * a, "{upright:?} {mirrored:?}");
            }
        }
    }

    #[test]
    fn switches_say_what_cuts() {
        let both = |vertical, horizontal| {
            on_faces(&Shape::cuboid(10.0, 8.0, 6.0), |env, part| {
                crate::op::set::trim_vertical(env, part, vertical);
                crate::op::set::trim_horizontal(env, part, horizontal);
                let size = part.scope.size;
                part.scope.origin -= part.scope.axes * DVec3::new(2.0, 2.0, 0.0);
                part.scope.size += DVec3::new(4.0, 4.0, 1.0);
                op::cube(env, part);
                let found = extent(part) - size;
                found.x + 100.0 * found.y
            })
        };
        let near = |found: Vec<f64>, expected: f64| {
            assert!(found.iter().all(|found| (found - expected).abs() < 1e-9), "{found:?} {expected}");
        };
        // At one metre in front of the face there is one more metre on each side.
        near(both(true, false), 2.0 + 400.0);
        near(both(false, true), 4.0 + 200.0);
        near(both(true, true), 2.0 + 200.0);
        near(both(false, false), 4.0 + 400.0);
    }

    #[test]
    fn what_stands_inside_is_left_alone() {
        on_faces(&Shape::cuboid(10.0, 8.0, 6.0), |env, part| {
            part.scope.size.z = 0.5;
            op::cube(env, part);
            assert!(matches!(part.geometry, Geometry::Box(_)));
            op::trim(env, part);
            assert!(matches!(part.geometry, Geometry::Box(_)));
            0.0
        });
    }

    #[test]
    fn a_face_alone_has_no_trim_planes() {
        on_faces(&Shape::rectangle(4.0, 4.0), |env, part| {
            cover(env, part);
            assert!(matches!(part.geometry, Geometry::Box(_)));
            0.0
        });
    }

    #[test]
    fn edges_below_40_degrees_make_horizontal_planes() {
        for (degrees, horizontal) in [(39.0, true), (39.999, true), (40.0, false), (41.0, false)] {
            // A wall in the xy plane whose top rises by `degrees`, and a roof at its back.
            let rise = 2.0 * libm::tan(f64::to_radians(degrees));
            let mut builder = MeshBuilder::new();
            let p =
                [[0., 0., 0.], [2., 0., 0.], [2., 5. + rise, 0.], [0., 5., 0.], [2., 5. + rise, -3.], [0., 5., -3.]]
                    .map(|p| builder.point(p));
            builder.face(&[p[0], p[1], p[2], p[3]], &[], Default::default());
            builder.face(&[p[3], p[2], p[4], p[5]], &[], Default::default());
            let shape = Shape::mesh_axis_aligned(builder.build().unwrap());
            let found = on_faces(&shape, |_, part| {
                let planes = part.trims.planes(&part.pivot);
                assert_eq!(planes.len(), 1);
                f64::from(u8::from(planes[0].is_horizontal(&part.pivot)))
            });
            assert_eq!(found[0] == 1.0, horizontal, "{degrees}");
        }
    }

    /// *trim attribute*: "the angle to the xz-plane of the pivot". A turned pivot swaps the classes, and the planes stay.
    #[test]
    fn the_pivot_of_the_moment_classes_planes() {
        on_faces(&Shape::cuboid(10.0, 8.0, 6.0), |_, part| {
            let before = part.trims.planes(&part.pivot);
            let classes = |part: &Shape| {
                let planes = part.trims.planes(&part.pivot);
                assert_eq!(*planes, *before);
                planes.iter().map(|plane| plane.is_horizontal(&part.pivot)).collect::<Vec<_>>()
            };
            assert_eq!(classes(part), [true, false, true, false]);
            let [x, y, z] = [part.pivot.axes.x_axis, part.pivot.axes.y_axis, part.pivot.axes.z_axis];
            let turned = |axes| Frame { axes, origin: DVec3::ONE };
            part.set_pivot(turned(DMat3::from_cols(y, -x, z)));
            assert_eq!(classes(part), [false, true, false, true]);
            part.set_pivot(turned(DMat3::from_cols(x, z, -y)));
            assert_eq!(classes(part), [true; 4]);
            0.0
        });
    }

    #[test]
    fn planes_bisect_whatever_the_turn() {
        let turn = DMat3::from_quat(glam::DQuat::from_axis_angle(DVec3::new(1.0, 1.0, 0.2).normalize(), 0.9));
        let cube = crate::geometry::primitive::cylinder(9).map(&DAffine3 { matrix3: turn, translation: DVec3::ONE });
        on_faces(&Shape::mesh_axis_aligned(cube.clone()), |_, part| {
            let planes = part.trims.planes(&part.pivot);
            assert!(!planes.is_empty());
            for plane in &*planes {
                // The face is on the near side, and so is the middle of the whole, which is convex.
                assert!(
                    part.to_mesh()
                        .points()
                        .iter()
                        .all(|p| { -1e-9 <= (part.scope.frame().to_world(*p) - plane.point).dot(plane.normal) })
                );
                assert!((plane.normal.length() - 1.0).abs() < 1e-12);
            }
            0.0
        });
    }

    #[test]
    fn holes_and_reflex_corners_cut_nothing_off_the_face() {
        let square = |low: f64, high: f64| {
            [(low, low), (high, low), (high, high), (low, high)].map(|(x, z)| DVec3::new(x, 0.0, -z)).to_vec()
        };
        let lot = Mesh::from_polygon(&square(0.0, 9.0), &[square(3.0, 6.0)]).unwrap();
        let l = [(0., 0.), (9., 0.), (9., 3.), (3., 3.), (3., 9.), (0., 9.)].map(|(x, z)| DVec3::new(x, 0.0, -z));
        for lot in [lot, Mesh::from_polygon(&l, &[]).unwrap()] {
            let shape = Shape::mesh_axis_aligned(extrude(&lot, Extrude::FaceNormal, 4.0));
            on_faces(&shape, |env, part| {
                crate::op::set::trim_horizontal(env, part, true);
                let area = geometry_area(env, part, Word::All);
                op::trim(env, part);
                assert!((geometry_area(env, part, Word::All) - area).abs() < 1e-9);
                0.0
            });
        }
    }

    #[test]
    fn a_part_of_a_face_keeps_its_planes_and_parts_of_parts_add_theirs() {
        on_faces(&Shape::cuboid(10.0, 8.0, 6.0), |_, part| {
            assert_eq!(part.trims.planes(&part.pivot).len(), 4);
            let mut inner = part.clone();
            inner.scope.size.z = 2.0;
            inner.geometry = Geometry::Box(UnitMesh::cuboid());
            on_faces(&inner, |_, part| {
                assert_eq!(part.trims.planes(&part.pivot).len(), 8);
                0.0
            });
            inner.geometry = Geometry::Rect(crate::geometry::Axis::Z, UnitMesh::rectangle(crate::geometry::Axis::Z));
            on_faces(&inner, |_, again| {
                assert_eq!(*again.trims.planes(&again.pivot), *inner.trims.planes(&inner.pivot));
                0.0
            });
            0.0
        });
    }
}
