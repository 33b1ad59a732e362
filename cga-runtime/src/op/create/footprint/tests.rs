use glam::{DMat3, DVec3};

use super::footprint;
use crate::geometry::mesh::{Mesh, MeshBuilder};
use crate::run::env::Env;
use crate::shape::Shape;

fn printed(mut shape: Shape) -> Shape {
    let env = &mut Env::for_tests();
    let (axes, pivot) = (shape.scope.axes, shape.pivot);
    footprint(env, &mut shape);
    assert!(env.take_faults().0.is_empty());
    assert_eq!((shape.scope.axes, shape.pivot, shape.scope.size.y), (axes, pivot, 0.0));
    let mesh = shape.to_mesh();
    assert!(mesh.check().is_empty(), "{:?}", mesh.check());
    assert!(mesh.faces().all(|face| (face.normal() - DVec3::Y).length() < 1e-12));
    assert!(mesh.uvs().is_empty() && mesh.groups().is_empty() && mesh.tag_sets().is_empty());
    shape
}

/// A polygon (x, z), and the heights of the bottom and the top over it.
type Prism<'a> = (&'a [(f64, f64)], f64, f64);

/// Prisms with points of their own.
fn prisms(parts: &[Prism<'_>]) -> Mesh {
    let mut builder = MeshBuilder::new();
    for (outline, low, high) in parts {
        let count = outline.len() as u32;
        let mut at = |y: f64| -> Vec<u32> { outline.iter().map(|&(x, z)| builder.point([x, y, z])).collect() };
        let (bottom, top) = (at(*low), at(*high));
        let reversed: Vec<u32> = bottom.iter().rev().copied().collect();
        builder.face(&top, &[], Default::default());
        builder.face(&reversed, &[], Default::default());
        for i in 0..count as usize {
            let j = (i + 1) % count as usize;
            builder.face(&[bottom[i], bottom[j], top[j], top[i]], &[], Default::default());
        }
    }
    builder.build().expect("a mesh")
}

const SQUARE: [(f64, f64); 4] = [(0.0, 4.0), (4.0, 4.0), (4.0, 0.0), (0.0, 0.0)];
const OTHER: [(f64, f64); 4] = [(2.0, 3.0), (7.0, 3.0), (7.0, 1.0), (2.0, 1.0)];

#[test]
fn a_box_becomes_its_floor() {
    let shape = printed(Shape::cuboid(3.0, 5.0, 2.0));
    assert_eq!(shape.scope.size, DVec3::new(3.0, 0.0, 2.0));
    assert_eq!(shape.scope.origin, Shape::cuboid(3.0, 5.0, 2.0).scope.origin);
    let mesh = shape.to_mesh();
    assert_eq!((mesh.face_count(), mesh.points().len()), (1, 4));
    assert!((mesh.area() - 6.0).abs() < 1e-12);
}

#[test]
fn the_floor_is_at_the_bottom_of_the_scope() {
    let shape = Shape::mesh_axis_aligned(prisms(&[(&SQUARE, 2.0, 7.0)])).at([10.0, 20.0, 30.0]);
    let before = shape.scope;
    let shape = printed(shape);
    assert_eq!((shape.scope.origin, shape.scope.size), (before.origin, DVec3::new(4.0, 0.0, 4.0)));
}

#[test]
fn parts_that_overlap_unite_and_eaves_count() {
    // A body, and a slab on it that sticks out: eaves.
    let shape = printed(Shape::mesh_axis_aligned(prisms(&[(&SQUARE, 0.0, 5.0), (&OTHER, 5.0, 6.0)])));
    let mesh = shape.to_mesh();
    assert_eq!((mesh.face_count(), mesh.points().len()), (1, 8));
    assert!((mesh.area() - (16.0 + 6.0)).abs() < 1e-9);
}

#[test]
fn a_ring_keeps_its_hole_and_parts_apart_are_faces() {
    let ring: Vec<DVec3> = SQUARE.iter().map(|&(x, z)| DVec3::new(x, 0.0, z)).collect();
    let hole: Vec<DVec3> =
        [(1.0, 1.0), (3.0, 1.0), (3.0, 3.0), (1.0, 3.0)].map(|(x, z)| DVec3::new(x, 0.0, z)).to_vec();
    let mesh = Mesh::from_polygon(&ring, &[hole]).unwrap();
    let mut shape = Shape::mesh_axis_aligned(mesh);
    crate::op::extrude(&mut Env::for_tests(), &mut shape, crate::op::Length::Absolute(3.0));
    let mesh = printed(shape).to_mesh();
    assert_eq!((mesh.face_count(), mesh.face(0).holes().len(), mesh.points().len()), (1, 1, 8));
    assert!((mesh.area() - 12.0).abs() < 1e-9);
    let far: Vec<(f64, f64)> = SQUARE.iter().map(|(x, z)| (x + 9.0, *z)).collect();
    let mesh = printed(Shape::mesh_axis_aligned(prisms(&[(&SQUARE, 0.0, 1.0), (&far, 0.0, 1.0)]))).to_mesh();
    assert_eq!((mesh.face_count(), mesh.points().len()), (2, 8));
}

#[test]
fn faces_that_look_down_or_have_thickness_zero_count() {
    let points = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)];
    // Seen from above this quadrilateral runs clockwise.
    let down = Mesh::from_polygon(&points.map(|(x, z)| DVec3::new(x, 1.0, z)), &[]).unwrap();
    assert_eq!(down.face(0).normal(), DVec3::NEG_Y);
    let mesh = printed(Shape::mesh_axis_aligned(down)).to_mesh();
    assert!((mesh.area() - 6.0).abs() < 1e-9);
}

#[test]
fn a_ball_becomes_a_disk() {
    let mut ball = Shape::cuboid(2.0, 2.0, 2.0);
    crate::op::sphere_sides(&mut Env::for_tests(), &mut ball, 32.0, 16.0);
    let mesh = printed(ball).to_mesh();
    assert_eq!((mesh.face_count(), mesh.points().len()), (1, 32));
}

#[test]
fn a_bent_face_is_seen_as_it_is() {
    // A saddle, one face of four corners, and a bow tie on its side.
    let saddle = [(0.0, 1.0, 0.0), (0.0, 0.0, 2.0), (2.0, 1.0, 2.0), (2.0, 0.0, 0.0)];
    let mesh = Mesh::from_polygon(&saddle.map(DVec3::from), &[]);
    if let Ok(mesh) = mesh {
        let mesh = printed(Shape::mesh_axis_aligned(mesh)).to_mesh();
        assert!((mesh.area() - 4.0).abs() < 1e-9);
    }
}

#[test]
fn nothing_to_see_is_a_fault_and_changes_nothing() {
    let wall = [(0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (3.0, 2.0, 0.0), (0.0, 2.0, 0.0)].map(DVec3::from);
    let mut shape = Shape::mesh_axis_aligned(Mesh::from_polygon(&wall, &[]).unwrap());
    let (env, before) = (&mut Env::for_tests(), shape.scope);
    footprint(env, &mut shape);
    assert_eq!(env.take_faults().0.len(), 1);
    assert_eq!((shape.scope, shape.to_mesh().face_count()), (before, 1));
    // Lines have no faces.
    let mut line = Shape::line([0.0; 3], [2.0, 0.0, 0.0]).unwrap();
    footprint(env, &mut line);
    assert!(env.take_faults().0.is_empty());
}

#[test]
fn very_small_and_very_large_meshes_have_footprints() {
    for scale in [1e-9, 1e9, 1e-60, 1e60] {
        let scaled = |outline: &[(f64, f64)]| -> Vec<(f64, f64)> {
            outline.iter().map(|(x, z)| (x * scale, z * scale)).collect()
        };
        let (square, other) = (scaled(&SQUARE), scaled(&OTHER));
        let mesh = prisms(&[(&square, 0.0, scale), (&other, 0.0, scale)]);
        let mesh = printed(Shape::mesh_axis_aligned(mesh)).to_mesh();
        assert!((mesh.area() / (scale * scale) - 22.0).abs() < 1e-6);
    }
}

#[test]
fn a_turned_mesh_has_the_turned_footprint() {
    let mesh = prisms(&[(&SQUARE, 0.0, 5.0), (&OTHER, 5.0, 6.0)]);
    let plain = printed(Shape::mesh_axis_aligned(mesh.clone()));
    for angle in [0.3f64, 1.0, 2.0] {
        let turn = DMat3::from_rotation_y(angle);
        let turned = Shape::mesh_axis_aligned(mesh.map(&glam::DAffine3::from_mat3(turn)));
        let turned = printed(turned);
        let points = |shape: &Shape| -> Vec<DVec3> {
            shape.to_mesh().points().iter().map(|p| shape.scope.origin + shape.scope.axes * *p).collect()
        };
        let (own, other) = (points(&plain), points(&turned));
        assert_eq!(own.len(), other.len());
        for (a, b) in own.iter().zip(&other) {
            assert!(((turn * *a - *b) * DVec3::new(1.0, 0.0, 1.0)).length() < 1e-8, "{a} {b}");
        }
    }
}

#[test]
fn a_large_mesh_takes_little_time() {
    let mut ball = Shape::cuboid(2.0, 2.0, 2.0);
    crate::op::sphere_sides(&mut Env::for_tests(), &mut ball, 300.0, 200.0);
    let mesh = printed(ball).to_mesh();
    assert_eq!(mesh.points().len(), 300);
}
