use glam::{DMat3, DVec3};

use super::*;
use crate::comp::{Arm, Mode, Select, never};
use crate::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use crate::geometry::primitive::cube;
use crate::shape::Shape;
use crate::value::text::Text;

pub(in crate::op) static ARMS: [Arm; 2] = [
    Arm { select: Select::Word(Word::Shape), mode: Mode::Each, text: Text::fixed("shape") },
    Arm { select: Select::Word(Word::Remainder), mode: Mode::Each, text: Text::fixed("remainder") },
];

/// For each face its arm, the number of its corners and its area.
pub(in crate::op) type Parts = Vec<(u32, usize, f64)>;

fn faces_of(shape: &Shape, divide: impl FnOnce(&mut Env, &mut Arms<'_>) -> ControlFlow<(), Faces>) -> (Faces, usize) {
    let env = &mut Env::for_tests();
    let ControlFlow::Continue(made) = divide(env, &mut Arms::new(shape, &ARMS, &mut never)) else {
        panic!("no limit is reached")
    };
    assert_eq!((made.mesh.check(), made.arms.len()), (vec![], made.mesh.face_count()));
    (made, env.take_faults().0.len())
}

/// The parts of a shape, and the number of faults.
pub(in crate::op) fn divided_by(
    shape: &Shape,
    divide: impl FnOnce(&mut Env, &mut Arms<'_>) -> ControlFlow<(), Faces>,
) -> (Parts, usize) {
    let (made, faults) = faces_of(shape, divide);
    let faces = made.mesh.faces().zip(&made.arms);
    let faces = faces.map(|(face, arm)| (arm.expect("both are selected"), face.corner_count(), face.area()));
    (faces.collect(), faults)
}

fn ring(corners: &[[f64; 2]]) -> Vec<DVec3> {
    corners.iter().map(|[x, z]| DVec3::new(*x, 0.0, -*z)).collect()
}

/// A shape on the ground. Its front has small second coordinates.
pub(in crate::op) fn polygon(corners: &[[f64; 2]]) -> Shape {
    holed(corners, &[])
}

pub(in crate::op) fn holed(corners: &[[f64; 2]], holes: &[&[[f64; 2]]]) -> Shape {
    let holes: Vec<_> = holes.iter().map(|hole| ring(hole)).collect();
    Shape::mesh_axis_aligned(Mesh::from_polygon(&ring(corners), &holes).expect("a polygon"))
}

/// Widths in the order of `shapeO`.
fn all([front, right, back, left]: [f64; 4]) -> [(Word, f64); 4] {
    [(Word::Front, front), (Word::Right, right), (Word::Back, back), (Word::Left, left)]
}

fn areas(shape: &Shape, widths: [f64; 4]) -> [f64; 2] {
    let (faces, faults) = divided_by(shape, |env, arms| set_back(env, arms, "`test`", &all(widths)));
    assert_eq!(faults, 0, "{widths:?}");
    [0, 1].map(|arm| faces.iter().filter(|face| face.0 == arm).map(|face| face.2).sum())
}

const NOTCHED: [[f64; 2]; 9] =
    [[0.0, 0.0], [6.0, -2.5], [12.0, 0.0], [13.0, 5.0], [9.0, 9.5], [6.5, 8.0], [8.0, 4.0], [5.5, 3.0], [-2.0, 7.0]];
const STEPS: [[f64; 2]; 8] =
    [[0.0, 0.0], [6.0, 0.0], [6.0, 2.0], [12.0, 2.0], [12.0, 8.0], [8.0, 8.0], [8.0, 10.0], [0.0, 10.0]];

/// Widths that leave edges where they are, that differ, and that are larger than the face.
const WIDTHS: [[f64; 4]; 9] = [
    [1.0, 0.0, 0.0, 1.0],
    [2.0, 0.5, 0.0, 1.0],
    [1.0, 1.0, 1.0, 1.0],
    [0.5, 1.0, 1.5, 2.0],
    [3.0, 0.0, 3.0, 0.0],
    [0.0, 4.0, 0.0, 0.1],
    [6.0, 0.1, 0.0, 1.0],
    [1e-3, 0.0, 1e-6, 0.0],
    [50.0, 0.0, 0.0, 0.0],
];

pub(in crate::op) fn lots() -> Vec<Shape> {
    let arc = |k: usize| {
        let angle = std::f64::consts::TAU * k as f64 / 24.0;
        [10.0 * libm::cos(angle), 8.0 * libm::sin(angle)]
    };
    let square: [[f64; 2]; 4] = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]];
    let star = |k: usize| {
        let angle = std::f64::consts::TAU * k as f64 / 14.0 + 0.1;
        let radius = if k.is_multiple_of(2) { 10.0 } else { 4.0 };
        [radius * libm::cos(angle), radius * libm::sin(angle)]
    };
    vec![
        polygon(&NOTCHED),
        polygon(&STEPS),
        polygon(&(0..24).map(arc).collect::<Vec<_>>()),
        polygon(&(0..14).map(star).collect::<Vec<_>>()),
        // Collinear corners.
        polygon(&[[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [8.0, 3.0], [8.0, 6.0], [0.0, 6.0], [0.0, 3.0]]),
        holed(&square, &[&[[5.0, 5.0], [15.0, 5.0], [15.0, 15.0], [5.0, 15.0]]]),
        holed(&square, &[&[[3.0, 3.0], [8.0, 4.0], [6.0, 9.0]], &[[10.0, 12.0], [17.0, 13.0], [11.0, 18.0]]]),
    ]
}

#[test]
fn areas_add_up() {
    for (lot, shape) in lots().iter().enumerate() {
        for widths in WIDTHS {
            let [setback, remainder] = areas(shape, widths);
            let all = shape.to_mesh().area();
            assert!((setback + remainder - all).abs() < 1e-9 * all, "{lot} {widths:?}: {setback} + {remainder}, {all}");
            assert!(0.0 < setback, "{lot} {widths:?}");
        }
    }
}

/// Wider strips leave less.
#[test]
fn the_remainder_shrinks() {
    for (lot, shape) in lots().iter().enumerate() {
        let mut last = f64::INFINITY;
        for step in 1..40 {
            let by = 0.25 * f64::from(step);
            let [_, remainder] = areas(shape, [by, 0.5 * by, 0.0, 0.25 * by]);
            assert!(remainder <= last + 1e-9, "{lot} {by}: {remainder} after {last}");
            last = remainder;
        }
    }
}

/// Equal widths on all sides are an offset.
#[test]
fn all_sides_alike_are_an_offset() {
    use crate::geometry::offset::OffsetFaces;
    use crate::geometry::offset::offset;
    for shape in lots() {
        for by in [0.3, 1.0, 2.0, 4.0] {
            let (inside, refused) = offset(&shape.to_mesh(), -by, OffsetFaces::Inside);
            let [_, remainder] = areas(&shape, [by; 4]);
            assert_eq!(refused, []);
            assert!((inside.area() - remainder).abs() < 1e-9, "{by}: {} {remainder}", inside.area());
        }
    }
}

/// A quarter turn of the face, with the widths turned too, gives the same parts; so does another first corner.
#[test]
fn turned_faces_have_turned_parts() {
    for shape in lots() {
        let mesh = shape.to_mesh();
        let quarter = DMat3::from_cols(DVec3::new(0.0, 0.0, -1.0), DVec3::Y, DVec3::X);
        let turned = mesh.map(&glam::DAffine3::from_mat3(quarter));
        let turned = Shape::mesh_axis_aligned(turned);
        for widths in WIDTHS {
            let [front, right, back, left] = widths;
            let (a, b) = (areas(&shape, widths), areas(&turned, [left, front, right, back]));
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9), "{widths:?}: {a:?} {b:?}");
        }
    }
    for first in 0..NOTCHED.len() {
        let mut corners = NOTCHED;
        corners.rotate_left(first);
        for widths in WIDTHS {
            let (a, b) = (areas(&polygon(&NOTCHED), widths), areas(&polygon(&corners), widths));
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9), "{widths:?}: {a:?} {b:?}");
        }
    }
}

/// A face on its mirror has the widths of left and right exchanged.
#[test]
fn mirrored_faces_have_mirrored_parts() {
    for corners in [&NOTCHED[..], &STEPS] {
        let mirrored: Vec<[f64; 2]> = corners.iter().rev().map(|[x, z]| [-x, *z]).collect();
        for widths in WIDTHS {
            let [front, right, back, left] = widths;
            let (a, b) = (areas(&polygon(corners), widths), areas(&polygon(&mirrored), [front, left, back, right]));
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9), "{widths:?}: {a:?} {b:?}");
        }
    }
}

/// Strips end on the line of a neighbour that stays, also at a concave corner, and have a mitre between edges that move.
#[test]
fn steps_give_strips_along_each_edge() {
    // Front edges are y = 0 and y = 2; left edges x = 0 alone.
    let [setback, remainder] = areas(&polygon(&STEPS), [1.0, 0.0, 0.0, 0.0]);
    // The strip of the upper front edge begins at its corner: 6 x 1 for each edge.
    assert_eq!([setback, remainder], [12.0, 6.0 * 2.0 + 12.0 * 6.0 + 8.0 * 2.0 - 12.0]);
    // At the concave corner the strips of the right and of the front edge have a mitre: another 1 x 1.
    let [setback, _] = areas(&polygon(&STEPS), [1.0, 1.0, 0.0, 0.0]);
    let right_edges = 2.0 + 6.0 + 2.0;
    assert!((setback - (12.0 + right_edges + 1.0 - 2.0)).abs() < 1e-9, "{setback}");
}

/// A corner that turns by 10 degrees, between an edge that moves and one that stays: the strip ends on the bisector.
#[test]
fn blunt_corners_have_no_spikes() {
    // The first edge faces the front, at 40 degrees from it, the second one the right, at 50.
    let turn = |[x, z]: [f64; 2]| {
        let (sin, cos) = libm::sincos(40f64.to_radians());
        [cos * x - sin * z, sin * x + cos * z]
    };
    let (sin, cos) = libm::sincos(10f64.to_radians());
    let corners = [[0.0, 0.0], [20.0, 0.0], [20.0 + 20.0 * cos, 20.0 * sin], [30.0, 30.0], [0.0, 30.0]].map(turn);
    let [setback, _] = areas(&polygon(&corners), [2.0, 0.0, 0.0, 0.0]);
    let on_bisector = 20.0 * 2.0 - 0.5 * 2.0 * 2.0 * libm::tan(5f64.to_radians());
    assert!((setback - on_bisector).abs() < 1e-9, "{setback} {on_bisector}");
}

#[test]
fn each_face_of_a_mesh_is_divided() {
    let shape = Shape::mesh_axis_aligned(cube());
    let (faces, faults) = divided_by(&shape, |env, arms| set_back(env, arms, "`test`", &all([0.1; 4])));
    let sum: f64 = faces.iter().map(|face| face.2).sum();
    assert!((sum - 6.0).abs() < 1e-9 && faults == 0);
    assert_eq!(faces.iter().filter(|face| face.0 == 1).count(), 6);
}

/// A face that crosses itself stays, with a fault; other faces are divided.
#[test]
fn a_face_that_crosses_itself_stays() {
    let mut builder = MeshBuilder::new();
    for face in
        [&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 3.0]], &[[10.0, 0.0], [14.0, 0.0], [14.0, 4.0], [10.0, 4.0]]]
    {
        let points: Vec<u32> = ring(face).into_iter().map(|at| builder.point(at)).collect();
        builder.face(&points, &[], FaceTag::PLAIN);
    }
    let shape = Shape::mesh_axis_aligned(builder.build().expect("a mesh"));
    let (faces, faults) = divided_by(&shape, |env, arms| set_back(env, arms, "`test`", &all([1.0, 0.0, 0.0, 1.0])));
    assert_eq!((faces.iter().map(|face| face.0).collect::<Vec<_>>(), faults), (vec![1, 0, 1], 1));
    assert_eq!([faces[1].2, faces[2].2], [7.0, 9.0]);
}

/// Corners of the face stay bit for bit, and parts begin with an edge that was set back, or with the first edge left.
#[test]
fn parts_begin_with_their_first_edges() {
    let shape = polygon(&NOTCHED);
    let (made, _) = faces_of(&shape, |env, arms| set_back(env, arms, "`test`", &all([1.0, 0.0, 0.0, 0.0])));
    let own: Vec<DVec3> = shape.to_mesh().face(0).outline().collect();
    let first: Vec<DVec3> = made.mesh.face(0).outline().take(3).collect();
    assert_eq!(first, own[..3]);
    assert!(own.iter().all(|at| made.mesh.points().contains(at)));
    let rest: Vec<DVec3> = made.mesh.face(1).outline().take(2).collect();
    let (a, b) = ((rest[1] - rest[0]).normalize(), (own[1] - own[0]).normalize());
    assert!(1.0 - 1e-12 < a.dot(b), "{rest:?}");
}

#[test]
fn an_arm_is_found_for_each_edge() {
    // As `setback` will ask: the first arm that selects the edge, with indices and words.
    let arms = [
        Arm { select: Select::Index(2.0), mode: Mode::Each, text: "2".into() },
        Arm { select: Select::Word(Word::Remainder), mode: Mode::Each, text: Text::fixed("remainder") },
        Arm { select: Select::Word(Word::All), mode: Mode::Each, text: "all".into() },
    ];
    let (env, shape) = (&mut Env::for_tests(), Shape::rectangle(2.0, 1.0));
    let mut never = never;
    let mut arms = Arms::new(&shape, &arms, &mut never);
    assert_eq!((arms.of(Word::Remainder), arms.of(Word::Shape)), (Some(1), None));
    assert_eq!(arms.edges(env, 0), ControlFlow::Continue(vec![Some(2), Some(2), Some(0), Some(2)]));
}

#[test]
fn extreme_widths_take_all_or_nothing() {
    for shape in lots() {
        let all = shape.to_mesh().area();
        for width in [1e-300, 1e-15] {
            let [setback, remainder] = areas(&shape, [width, 0.0, width, 0.0]);
            assert!(setback < 1e-9 && (remainder - all).abs() < 1e-9, "{width}: {setback} {remainder}");
        }
        for width in [1e6, 1e30, f64::MAX] {
            let [setback, remainder] = areas(&shape, [width; 4]);
            assert!((setback - all).abs() < 1e-9 && remainder == 0.0, "{width}: {setback} {remainder}");
            areas(&shape, [width, 0.0, 1.0, 0.0]);
        }
    }
}

/// Far from the origin, or tiny, with the same shares.
#[test]
fn sizes_and_places_do_not_matter() {
    for shape in lots() {
        let mesh = shape.to_mesh();
        let [setback, _] = areas(&shape, [2.0, 1.0, 0.0, 0.5]);
        for (size, to) in [(1e-3, 0.0), (1e5, 0.0), (1.0, 4e5)] {
            let place =
                glam::DAffine3::from_translation(DVec3::splat(to)) * glam::DAffine3::from_scale(DVec3::splat(size));
            let other = Shape::mesh_axis_aligned(mesh.map(&place));
            let [scaled, _] = areas(&other, [2.0, 1.0, 0.0, 0.5].map(|width| width * size));
            assert!((scaled / (size * size) - setback).abs() < 1e-6, "{size} {to}: {scaled} {setback}");
        }
    }
}

/// The numbers of a small generator.
pub(in crate::op) fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1u64 << 53) as f64
}

/// Stars with random corners, and a hole in every second one.
#[test]
fn areas_of_random_faces_add_up() {
    let state = &mut 7;
    let mut refused = 0;
    for number in 0..2000 {
        let count = 3 + (random(state) * 14.0) as usize;
        let ring = |state: &mut u64, low: f64, high: f64| -> Vec<[f64; 2]> {
            let corner = |k: usize, radius: f64| {
                let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / count as f64);
                [radius * cos, radius * sin]
            };
            (0..count).map(|k| corner(k, low + (high - low) * random(state))).collect()
        };
        let outline = ring(state, 8.0, 20.0);
        let hole = ring(state, 1.0, 3.0);
        let shape = if number % 2 == 0 { polygon(&outline) } else { holed(&outline, &[&hole]) };
        let widths = [0; 4].map(|_| (random(state) * 12.0 - 3.0).max(0.0));
        let (faces, faults) = divided_by(&shape, |env, arms| set_back(env, arms, "`test`", &all(widths)));
        refused += faults;
        let (sum, all) = (faces.iter().map(|face| face.2).sum::<f64>(), shape.to_mesh().area());
        assert!((sum - all).abs() < 1e-9 * all, "{number}: {sum} {all}");
    }
    assert_eq!(refused, 0);
}

/// The part of a convex polygon that is at least that far to the left of a line.
fn clipped(ring: &[[f64; 2]], [a, b]: [[f64; 2]; 2], by: f64) -> Vec<[f64; 2]> {
    let along = [b[0] - a[0], b[1] - a[1]];
    let length = along[0].hypot(along[1]);
    let inside = |p: [f64; 2]| (along[0] * (p[1] - a[1]) - along[1] * (p[0] - a[0])) / length - by;
    let mut kept = Vec::new();
    for (k, &p) in ring.iter().enumerate() {
        let q = ring[(k + 1) % ring.len()];
        let (d, e) = (inside(p), inside(q));
        if 0.0 <= d {
            kept.push(p);
        }
        if d * e < 0.0 {
            kept.push([0, 1].map(|i| p[i] + (q[i] - p[i]) * d / (d - e)));
        }
    }
    kept
}

/// The remainder of a convex face without blunt corners is the intersection of its half planes.
#[test]
fn convex_faces_are_cut_by_half_planes() {
    let state = &mut 3;
    for number in 0..500 {
        let mut near = |x: f64, z: f64| [x + 4.0 * random(state), z + 4.0 * random(state)];
        let corners = [near(0.0, 0.0), near(20.0, 0.0), near(20.0, 16.0), near(0.0, 16.0)];
        let by = [0; 4].map(|_| (random(state) * 9.0 - 2.0).max(0.0));
        let mut rest = corners.to_vec();
        for k in 0..4 {
            rest = clipped(&rest, [corners[k], corners[(k + 1) % 4]], by[k]);
        }
        let cross = |k: usize| {
            let (p, q) = (rest[k], rest[(k + 1) % rest.len()]);
            p[0] * q[1] - p[1] * q[0]
        };
        let area = 0.5 * (0..rest.len()).map(cross).sum::<f64>();
        let [_, remainder] = areas(&polygon(&corners), by);
        assert!((area - remainder).abs() < 1e-9, "{number}: {corners:?} {by:?}: {area} {remainder}");
    }
}
