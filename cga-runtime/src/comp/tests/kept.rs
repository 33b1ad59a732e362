//! The selection of faces in mirrored shapes, and their attributes.

use std::ops::ControlFlow;

use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::{arm, ball, hip_roofs, parts};
use crate::comp::select::Word;
use crate::comp::{Align, Arm, AssignedComponents, Components, Mode, Select};
use crate::geometry::Axis;
use crate::geometry::mesh::Mesh;
use crate::geometry::primitive;
use crate::op::{self, Length};
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::{Geometry, Shape};

#[test]
fn what_looks_outwards_is_selected_by_where_it_looks() {
    // `mirrorScope` and `alignScopeToAxes` do not move the geometry; a negative distance of `extrude` turns it
    // inwards.
    let env = &mut Env::for_tests();
    let word_of = |shape: &Shape, word| {
        let found = parts(shape, Components::Faces, Align::ZUp, &[arm(word, Mode::Each)]);
        found.iter().map(|part| part.2.scope.centre()).collect::<Vec<_>>()
    };
    let mut grown = Shape::rectangle(10.0, 10.0);
    op::extrude(env, &mut grown, Length::Absolute(-10.0));
    for start in [Shape::cuboid(10.0, 10.0, 10.0), Shape::mesh_axis_aligned(ball()), grown] {
        let expected = [Word::Top, Word::Front, Word::Right].map(|word| word_of(&start, word));
        assert!(expected.iter().all(|found| !found.is_empty()));
        for flips in 0..8 {
            let mut shape = start.clone();
            op::mirror_scope(env, &mut shape, flips & 1 == 1, flips & 2 == 2, flips & 4 == 4);
            let cut = shape.clone();
            op::align_to_axes(env, &mut shape, op::AlignAxes::WorldY);
            for shape in [cut, shape] {
                let found = [Word::Top, Word::Front, Word::Right].map(|word| word_of(&shape, word));
                for (found, expected) in found.iter().zip(&expected) {
                    assert_eq!(found.len(), expected.len());
                    assert!(found.iter().zip(expected).all(|(a, b)| (*a - *b).length() < 1e-9));
                }
            }
        }
    }
}

#[test]
fn edges_of_faces_and_wires_are_selected_by_where_they_are() {
    for signs in [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        let mut lot = Shape::rectangle(4.0, 4.0);
        let mut wire = parts(&lot, Components::Edges, Align::Keep, &[arm(Word::All, Mode::Together)]).remove(0).2;
        for (shape, kind) in [(&mut lot, Components::FaceEdges), (&mut wire, Components::Edges)] {
            shape.resize(DVec3::new(4.0 * signs[0], shape.scope.size.y, 4.0 * signs[1]));
            let middle = shape.scope.centre();
            if kind == Components::FaceEdges {
                for (word, axis, sign) in [(Word::Front, 2, 1.0), (Word::Left, 0, -1.0), (Word::Back, 2, -1.0)] {
                    let found = parts(shape, kind, Align::ZUp, &[arm(word, Mode::Each)]);
                    assert_eq!(found.len(), 1);
                    assert!(1.9 < (found[0].2.scope.centre() - middle)[axis] * sign, "{word:?} {signs:?}");
                    assert!(0.99 < found[0].2.scope.axes.z_axis[axis] * sign);
                }
            } else {
                assert_eq!(parts(shape, kind, Align::ZUp, &[arm(Word::Top, Mode::Each)]).len(), 4);
            }
        }
    }
}

#[test]
fn faces_keep_what_they_carry() {
    // A tag of `extrude` does not need a mesh.
    let env = &mut Env::for_tests();
    let mut tower = Shape::rectangle(4.0, 3.0);
    op::extrude(env, &mut tower, Length::Absolute(5.0));
    let l = [(0., 0.), (9., 0.), (9., 3.), (3., 3.), (3., 9.), (0., 9.)].map(|(x, z)| DVec3::new(x, 0.0, -z));
    let mut prism = Shape::mesh_axis_aligned(Mesh::from_polygon(&l, &[]).unwrap());
    op::extrude(env, &mut prism, Length::Absolute(5.0));
    for (body, sides) in [(tower, 4), (prism, 6)] {
        let walls = parts(&body, Components::Faces, Align::ZUp, &[arm(Word::Side, Mode::Each)]);
        assert_eq!(walls.len(), sides);
        for (.., wall) in walls {
            assert!(matches!(wall.geometry, Geometry::Rect(Axis::Z, unit) if unit.faces()[0].is_tagged("extrude")));
            assert!(wall.to_mesh().tag_sets()[wall.to_mesh().face(0).tag().tags as usize].has("extrude.side.outer"));
        }
    }
    // Texture coordinates need a mesh.
    for (.., face) in parts(
        &Shape::mesh_axis_aligned(primitive::cylinder(4)),
        Components::Faces,
        Align::ZUp,
        &[arm(Word::All, Mode::Each)],
    ) {
        assert_eq!((face.to_mesh().uvs().len(), face.to_mesh().points().len()), (4, 4));
    }
}

#[test]
fn a_face_is_flat_whatever_the_turn() {
    let mesh = primitive::cone(5);
    for turn in 0..360 {
        let turn = DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(0.2, 1.0, 0.1).normalize(), f64::from(turn)));
        let turned = mesh.map(&DAffine3 { matrix3: turn, translation: DVec3::splat(1e5) });
        for (.., face) in
            parts(&Shape::mesh_axis_aligned(turned), Components::Faces, Align::ZUp, &[arm(Word::All, Mode::Each)])
        {
            assert_eq!(face.scope.size.z, 0.0);
        }
    }
}

#[test]
fn edges_of_a_roof_run_upwards_whoever_finds_them() {
    let [roof, _] = hip_roofs();
    for turn in 0..36 {
        let turn = DMat3::from_rotation_y(f64::from(turn).to_radians());
        let turned = roof.map(&DAffine3 { matrix3: turn, translation: DVec3::splat(1e5) });
        let (env, shape) = (&mut Env::for_tests(), Shape::mesh_axis_aligned(turned));
        let any = [Arm { select: Select::When, mode: Mode::Each, text: "hip || ridge".into() }];
        let found = AssignedComponents::of(env, &shape, Components::Edges, Align::ZUp, &any, |_, _, candidate| {
            candidate.is(Word::Hip) || candidate.is(Word::Ridge)
        });
        let ControlFlow::Continue(found) = found else { panic!("no limit is near") };
        let mut count = 0;
        let _: Flow = found.each(|_, _, part| {
            count += 1;
            assert!(-1e-9 < part.scope.axes.x_axis.y);
            Flow::Continue(())
        });
        assert_eq!(count, 5);
    }
}

#[test]
fn trim_planes_of_faces_that_keep_the_axes_are_level_as_seen_from_the_pivot() {
    // All edges of the top are level, so nothing cuts the geometry on it.
    for (word, faces) in [(Word::Top, 6), (Word::Front, 4)] {
        let (env, shape) = (&mut Env::for_tests(), Shape::cuboid(10.0, 10.0, 10.0));
        let (.., mut face) = parts(&shape, Components::Faces, Align::Keep, &[arm(word, Mode::Each)]).remove(0);
        face.scope.origin -= DVec3::new(2.0, 1.0, 2.0);
        face.resize(face.scope.size + DVec3::new(4.0, 2.0, 4.0));
        op::cube(env, &mut face);
        assert_eq!(face.to_mesh().face_count(), faces, "{word:?}");
    }
}

#[test]
fn a_hull_of_many_corners_decides_as_all_corners_do() {
    // Every face of a prism has a plane at each of its edges. Switched on, all of them cut.
    for sides in [3, 4, 7, 100] {
        let (env, shape) = (&mut Env::for_tests(), Shape::mesh_axis_aligned(primitive::cylinder(sides)));
        for (.., mut face) in parts(&shape, Components::Faces, Align::ZUp, &[arm(Word::All, Mode::Each)]) {
            let edges = face.to_mesh().corners().len();
            assert_eq!(face.trims.planes(&face.pivot).len(), edges);
            crate::op::set::trim_horizontal(env, &mut face, true);
            let area = face.to_mesh().area();
            op::trim(env, &mut face);
            assert!((face.to_mesh().area() - area).abs() < 1e-9);
        }
    }
}

#[test]
fn faces_of_a_cube_are_numbered_alike_with_and_without_a_mesh() {
    let (env, mut cube) = (&mut Env::for_tests(), Shape::cuboid(2.0, 3.0, 4.0));
    op::cube(env, &mut cube);
    let [quads, mesh] = [cube.clone(), Shape::mesh_axis_aligned(cube.to_mesh().as_ref().clone())]
        .map(|shape| parts(&shape, Components::Faces, Align::ZUp, &[arm(Word::All, Mode::Each)]));
    for ((.., a), (.., b)) in quads.iter().zip(&mesh) {
        assert!((a.scope.origin - b.scope.origin).length() < 1e-12 && a.scope.axes.abs_diff_eq(b.scope.axes, 1e-12));
    }
    // *primitiveCube operation*: bottom, top, front, right, back, left.
    let normals = [DVec3::NEG_Y, DVec3::Y, DVec3::Z, DVec3::X, DVec3::NEG_Z, DVec3::NEG_X];
    assert!(quads.iter().zip(normals).all(|((.., side), normal)| side.scope.axes.z_axis == normal));
    assert!(cube.to_mesh().is_closed() && cube.to_mesh().volume() == 24.0);
}
