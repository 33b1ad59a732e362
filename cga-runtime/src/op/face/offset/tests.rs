use glam::DVec3;

use super::*;
use crate::geometry::Axis;
use crate::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use crate::shape::Shape;
use crate::shape::unit::UnitMesh;

fn faults(env: &mut Env) -> Vec<String> {
    env.take_faults().0.into_iter().map(|fault| fault.message).collect()
}

fn notched() -> Shape {
    Shape::footprint(&[[0.0, 10.0], [10.0, 10.0], [10.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]], &[]).unwrap()
}

#[test]
fn the_scope_fits_and_the_pivot_stays() {
    let env = &mut Env::for_tests();
    for (distance, keep, size) in [
        (-1.0, OffsetFaces::All, [10.0, 10.0]),
        (-1.0, OffsetFaces::Inside, [8.0, 8.0]),
        (1.5, OffsetFaces::All, [13.0, 13.0]),
        (1.5, OffsetFaces::Border, [13.0, 13.0]),
    ] {
        let before = notched();
        let mut shape = before.clone();
        offset_selected(env, &mut shape, distance, keep);
        assert!((shape.scope.size - DVec3::new(size[0], 0.0, size[1])).length() < 1e-12);
        let middle = |shape: &Shape| shape.scope.origin + shape.scope.axes * shape.scope.size * 0.5;
        assert!((middle(&shape) - middle(&before)).length() < 1e-12);
        assert_eq!((shape.pivot, shape.scope.axes), (before.pivot, before.scope.axes));
    }
    assert_eq!(faults(env), [""; 0]);
}

#[test]
fn rectangles_do_as_their_mesh_does() {
    let env = &mut Env::for_tests();
    let meshed = |mut shape: Shape| {
        shape.set_mesh(shape.to_mesh().as_ref().clone());
        shape
    };
    let quads = [Shape::rectangle(6.0, 4.0).at([3.0, 1.0, 2.0]), {
        let mut wall = Shape::cuboid(6.0, 4.0, 0.0);
        wall.geometry = Geometry::Rect(Axis::Z, UnitMesh::rectangle(Axis::Z));
        wall
    }];
    for quad in quads {
        for distance in [-2.5, -2.0, -1.0, -0.25, 0.0, 0.25, 3.0] {
            let (mut plain, mut other) = (quad.clone(), meshed(quad.clone()));
            offset_selected(env, &mut plain, distance, OffsetFaces::Inside);
            offset_selected(env, &mut other, distance, OffsetFaces::Inside);
            assert!((plain.scope.size - other.scope.size).length() < 1e-12, "{distance}");
            assert!((plain.scope.origin - other.scope.origin).length() < 1e-12);
            assert!(matches!(plain.geometry, Geometry::Rect(..)));
            let (a, b) = (plain.to_mesh(), other.to_mesh());
            assert_eq!((a.face_count(), a.face(0).outer().len()), (b.face_count(), b.face(0).outer().len()));
            let at = |mesh: &Mesh, i: usize| mesh.points()[mesh.face(0).outer()[i] as usize];
            assert!((0..4).all(|i| at(&a, i).distance(at(&b, i)) < 1e-12));
        }
    }
    assert_eq!(faults(env), [""; 0]);
}

#[test]
fn nothing_inside_leaves_the_geometry_and_all_its_strips() {
    let env = &mut Env::for_tests();
    for keep in [OffsetFaces::Inside, OffsetFaces::Border, OffsetFaces::All] {
        let mut shape = notched();
        offset_selected(env, &mut shape, -3.0, keep);
        let faces = if keep == OffsetFaces::Inside { 1 } else { 6 };
        assert_eq!(shape.to_mesh().face_count(), faces, "{keep:?}");
        assert!((shape.to_mesh().area() - 64.0).abs() < 1e-9);
    }
    assert_eq!(faults(env), [""; 0]);
}

#[test]
fn what_cannot_be_moved_stays() {
    let env = &mut Env::for_tests();
    let same = |a: &Shape, b: &Shape| a.scope == b.scope && a.to_mesh().corners() == b.to_mesh().corners();
    let mut run = |shape: &Shape, distance: f64, keep: OffsetFaces| {
        let mut moved = shape.clone();
        offset_selected(env, &mut moved, distance, keep);
        assert!(same(&moved, shape));
        faults(env).join("; ")
    };
    let stays = "stays as it is";
    let (all, inside) = (OffsetFaces::All, OffsetFaces::Inside);
    assert_eq!(run(&notched(), f64::NAN, all), "the distance of `offset` is NaN; 0 is used instead");
    assert!(run(&notched(), 1e200, all).ends_with(stays));
    assert!(run(&Shape::rectangle(4.0, 3.0), f64::MAX, inside).ends_with(stays));
    let mut bows = MeshBuilder::new();
    for _ in 0..12 {
        let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, -4.0], [4.0, 0.0, 0.0], [0.0, 0.0, -3.0]].map(|p| bows.point(p));
        bows.face(&corners, &[], FaceTag::PLAIN);
    }
    let bows = Shape::mesh_axis_aligned(bows.build().unwrap());
    let many = "faces 0, 1, 2, 3, 4, 5, 6, 7 and 4 more touch themselves or lead too far; they stay as they are";
    assert_eq!(run(&bows, -1.0, all), format!("`offset`: {many}"));
    let angle = |i: i32| f64::from(i) / 6000.0 * std::f64::consts::TAU;
    let round: Vec<[f64; 2]> = (0..6000).map(|i| [libm::cos(angle(i)), libm::sin(angle(i))]).collect();
    let round = Shape::footprint(&round, &[]).unwrap();
    assert_eq!(run(&round, -0.1, all), format!("`offset`: face 0 has too many corners; it {stays}"));
    for empty in [Shape::line([0.0; 3], [1.0, 0.0, 0.0]).unwrap(), Shape::point([1.0; 3])] {
        assert_eq!(run(&empty, 1.0, all), "");
    }
}
