use glam::{DAffine3, DMat3, DVec2, DVec3};

use super::{RectangleAlignment, inner_rect, inner_rectangle};
use crate::comp::select::Word;
use crate::comp::{Arm, Arms, Faces, Mode, Select, never};
use crate::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use crate::geometry::primitive;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::seed::Seed;

use RectangleAlignment::{Edge, Scope};

fn cut(shape: &Shape, alignment: RectangleAlignment) -> (Faces, usize) {
    let env = &mut Env::for_tests();
    let arm = |word| Arm { select: Select::Word(word), mode: Mode::Each, text: "".into() };
    let arms = [arm(Word::Shape), arm(Word::Remainder)];
    let mut test = never;
    let made = inner_rectangle(env, &mut Arms::new(shape, &arms, &mut test), alignment).continue_value().unwrap();
    (made, env.take_faults().0.len())
}

fn divided(shape: &Shape, alignment: RectangleAlignment) -> Faces {
    let (made, faults) = cut(shape, alignment);
    assert_eq!(faults, 0);
    assert_eq!(made.mesh.face_count(), made.arms.len());
    assert!(made.mesh.check().is_empty(), "{:?} {:?}", made.mesh.check(), shape.to_mesh().points());
    made
}

/// The areas of the faces of an arm.
fn areas(made: &Faces, arm: u32) -> Vec<f64> {
    let is_in = |face: &usize| made.arms[*face] == Some(arm);
    (0..made.arms.len()).filter(is_in).map(|face| made.mesh.face(face).area()).collect()
}

fn polygon(outline: &[(f64, f64)], holes: &[&[(f64, f64)]]) -> Shape {
    let ring = |ring: &[(f64, f64)]| -> Vec<DVec3> { ring.iter().map(|&(x, y)| DVec3::new(x, 0.0, -y)).collect() };
    let holes: Vec<Vec<DVec3>> = holes.iter().map(|hole| ring(hole)).collect();
    Shape::mesh_axis_aligned(Mesh::from_polygon(&ring(outline), &holes).expect("a polygon"))
}

const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
const L: [(f64, f64); 6] = [(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (5.0, 5.0), (5.0, 10.0), (0.0, 10.0)];
/// The lot of the page's pictures, as read from them.
const LOT: [(f64, f64); 7] =
    [(10.0, 19.6), (21.4, 14.3), (44.5, 22.3), (52.7, 6.2), (36.1, -6.2), (12.6, -9.8), (-1.3, 9.0)];

#[test]
fn a_rectangle_has_no_remainder() {
    for alignment in [Scope, Edge] {
        let made = divided(&Shape::rectangle(10.0, 8.0), alignment);
        assert_eq!((areas(&made, 0), areas(&made, 1)), (vec![80.0], vec![]));
    }
}

#[test]
fn a_sliver_stays_whole() {
    for (width, depth) in [(10.0, 1e-9), (1e9, 1e-3)] {
        for alignment in [Scope, Edge] {
            let (made, faults) = cut(&Shape::rectangle(width, depth), alignment);
            assert_eq!((made.arms.as_slice(), faults), (&[Some(1)][..], 1));
            assert!(made.mesh.check().is_empty(), "{:?}", made.mesh.check());
        }
    }
}

#[test]
fn a_right_triangle_leaves_two() {
    let made = divided(&polygon(&[(0.0, 0.0), (10.0, 0.0), (0.0, 10.0)], &[]), Scope);
    let [shape, rest] = [0, 1].map(|arm| areas(&made, arm));
    assert!((shape[0] - 25.0).abs() < 1e-9 && rest.len() == 2);
    assert!(rest.iter().all(|area| (area - 12.5).abs() < 1e-8));
}

#[test]
fn an_l_leaves_one_of_its_wings() {
    for alignment in [Scope, Edge] {
        let made = divided(&polygon(&L, &[]), alignment);
        let [shape, rest] = [0, 1].map(|arm| areas(&made, arm));
        assert!((shape[0] - 50.0).abs() < 1e-9 && rest.len() == 1 && (rest[0] - 25.0).abs() < 1e-8);
    }
}

#[test]
fn holes_are_left_out() {
    let hole = [(3.0, 3.0), (3.0, 7.0), (7.0, 7.0), (7.0, 3.0)];
    let made = divided(&polygon(&SQUARE, &[&hole]), Scope);
    let [shape, rest] = [0, 1].map(|arm| areas(&made, arm));
    assert!((shape[0] - 30.0).abs() < 1e-9 && rest.len() == 1 && (rest[0] - 54.0).abs() < 1e-8);
    // A hole that the rectangle does not touch stays a hole.
    let hole = [(1.0, 8.5), (1.0, 9.5), (2.0, 9.5), (2.0, 8.5)];
    let made = divided(&polygon(&SQUARE, &[&hole]), Scope);
    assert!((areas(&made, 0)[0] - 85.0).abs() < 1e-9);
    assert!((areas(&made, 0)[0] + areas(&made, 1).iter().sum::<f64>() - 99.0).abs() < 1e-8);
}

#[test]
fn the_lot_of_the_page() {
    // Along the scope three parts are left, and the rectangle touches the concave corner.
    let lot = polygon(&LOT, &[]);
    let made = divided(&lot, Scope);
    assert_eq!(areas(&made, 1).len(), 3);
    let along_edges = divided(&lot, Edge);
    assert!(areas(&made, 0)[0] < areas(&along_edges, 0)[0]);
}

#[test]
fn parts_begin_on_the_outline_in_the_order_of_its_corners() {
    let rng = &mut Seed::new(4);
    for _ in 0..60 {
        let count = 4 + (rng.draw() * 8.0) as usize;
        let outline: Vec<(f64, f64)> = (0..count)
            .map(|k| {
                let angle = (k as f64 + 0.5 * rng.draw()) / count as f64 * std::f64::consts::TAU;
                let radius = 4.0 + 6.0 * rng.draw();
                (radius * libm::cos(angle), radius * libm::sin(angle))
            })
            .collect();
        let shape = polygon(&outline, &[]);
        let source = shape.to_mesh();
        for alignment in [Scope, Edge] {
            let made = divided(&shape, alignment);
            let total: f64 = made.mesh.faces().map(|face| face.area()).sum();
            assert!((total - source.area()).abs() < 1e-6 * source.area(), "{outline:?}");
            let mut last = None;
            for face in made.mesh.faces().skip(1) {
                assert!(made.mesh.face(face.index()).normal().y > 0.999);
                let at = |k: usize| made.mesh.points()[face.outer()[k % face.outer().len()] as usize];
                let edges = source.face(0).edges().map(|edge| edge.map(|corner| source.face(0).position(corner)));
                let off = |p: DVec3, [a, b]: [DVec3; 2]| {
                    let along = b - a;
                    let share = (p - a).dot(along) / along.length_squared();
                    a.lerp(b, share.clamp(0.0, 1.0)).distance(p)
                };
                let mut on = edges.map(|edge| off(at(0), edge).max(off(at(1), edge)));
                assert!(on.any(|off| off < 1e-7), "{outline:?}");
                let lowest = face.outer().iter().filter_map(|point| {
                    let p = made.mesh.points()[*point as usize];
                    source.points().iter().position(|q| q.distance(p) < 1e-9)
                });
                let lowest = lowest.min().unwrap_or(usize::MAX);
                assert!(last <= Some(lowest), "{outline:?}");
                last = Some(lowest);
            }
        }
    }
}

#[test]
fn a_slanted_face_has_a_rectangle_as_seen_along_an_axis() {
    let lift = DAffine3::from_mat3(DMat3::from_cols(DVec3::new(1.0, 0.3, 0.0), DVec3::Y, DVec3::new(0.0, -0.5, 1.0)));
    let flat = divided(&polygon(&LOT, &[]), Scope);
    let made = divided(&Shape::mesh_axis_aligned(polygon(&LOT, &[]).to_mesh().map(&lift)), Scope);
    for (a, b) in flat.mesh.points().iter().zip(made.mesh.points()) {
        let c = lift.transform_point3(*a);
        assert!(((c - *b) - (c - *b).y * DVec3::Y).length() < 1e-9);
    }
    // Walls: seen from the side.
    let wall =
        [(0.0, 0.0, 0.0), (0.0, 0.0, -6.0), (0.0, 4.0, -6.0), (0.0, 6.0, -3.0), (0.0, 4.0, 0.0)].map(DVec3::from);
    let made = divided(&Shape::mesh_axis_aligned(Mesh::from_polygon(&wall, &[]).unwrap()), Scope);
    assert!((areas(&made, 0)[0] - 24.0).abs() < 1e-9);
    assert!((made.mesh.face(0).normal() - DVec3::X).length() < 1e-12);
}

#[test]
fn groups_and_coordinates_are_kept() {
    let mut builder = MeshBuilder::new();
    let corners = [(0.0, 0.0), (10.0, 0.0), (0.0, 10.0)];
    let ring: Vec<u32> = corners.iter().map(|&(x, y)| builder.point([x, 0.0, -y])).collect();
    builder.face(&ring, &[], FaceTag { group: 0, ..FaceTag::PLAIN });
    builder.uvs(&corners.map(|(x, y)| DVec2::new(0.1 * x, 0.2 * y + 1.0))).groups(vec!["lot".to_owned()]);
    let made = divided(&Shape::mesh_axis_aligned(builder.build().unwrap()), Scope);
    for face in made.mesh.faces() {
        assert_eq!(face.tag().group, 0);
        for corner in face.corner_range() {
            let p = face.position(corner);
            // Scope coordinates: the back is 0.
            let expected = DVec2::new(0.1 * p.x, 0.2 * (10.0 - p.z) + 1.0);
            assert!((made.mesh.uvs()[corner] - expected).length() < 1e-9);
        }
    }
}

#[test]
fn what_cannot_be_divided_is_a_remainder() {
    let mut builder = MeshBuilder::new();
    let bow = [(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 7.0)].map(|(x, y)| builder.point([x, 0.0, -y]));
    builder.face(&bow, &[], FaceTag::PLAIN);
    let (made, faults) = cut(&Shape::mesh_axis_aligned(builder.build().unwrap()), Edge);
    assert_eq!((made.arms, faults), (vec![Some(1)], 1));
    let (made, faults) = cut(&Shape::line([0.0; 3], [2.0, 0.0, 0.0]).unwrap(), Edge);
    assert_eq!((made.arms.len(), faults), (0, 0));
}

#[test]
fn every_face_of_a_box_is_a_rectangle() {
    for alignment in [Scope, Edge] {
        let made = divided(&Shape::mesh_axis_aligned(primitive::cube()), alignment);
        assert_eq!(made.arms, [Some(0); 6]);
    }
}

#[test]
fn the_old_form_replaces_faces() {
    let env = &mut Env::for_tests();
    let mut shape = polygon(&[(0.0, 0.0), (10.0, 0.0), (0.0, 10.0)], &[]);
    let pivot = shape.pivot;
    inner_rect(env, &mut shape);
    assert!(env.take_faults().0.is_empty());
    assert_eq!(shape.pivot, pivot);
    assert!((shape.scope.size - DVec3::new(5.0, 0.0, 5.0)).length() < 1e-9);
    assert_eq!(shape.to_mesh().face_count(), 1);
    let mut line = Shape::line([0.0; 3], [2.0, 0.0, 0.0]).unwrap();
    inner_rect(env, &mut line);
    assert!(env.take_faults().0.is_empty());
}
