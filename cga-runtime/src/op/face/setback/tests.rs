use glam::{DVec2, DVec3};

use super::*;
use crate::comp::{Arm, Mode, Select, never};
use crate::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use crate::op::face::swept_edges::tests::{holed, lots, polygon, random};
use crate::shape::Shape;
use crate::value::text::Text;

pub(in crate::op) const fn word(word: Word, text: &'static str) -> Arm {
    Arm { select: Select::Word(word), mode: Mode::Each, text: Text::fixed(text) }
}

pub(in crate::op) const ALL: Arm = word(Word::All, "all");
pub(in crate::op) const REST: Arm = word(Word::Remainder, "remainder");
const FRONT: Arm = word(Word::Front, "front");
const LEFT: Arm = word(Word::Left, "left");
const BACK: Arm = word(Word::Back, "back");
const RIGHT: Arm = word(Word::Right, "right");

fn index(index: f64) -> Arm {
    Arm { select: Select::Index(index), mode: Mode::Each, text: "index".into() }
}

/// The faces that an operation makes, and the number of faults.
pub(in crate::op) fn made_by(
    shape: &Shape,
    arms: &[Arm],
    divide: impl FnOnce(&mut Env, &mut Arms<'_>) -> ControlFlow<(), Faces>,
) -> (Faces, usize) {
    let (env, mut never) = (&mut Env::for_tests(), never);
    let ControlFlow::Continue(made) = divide(env, &mut Arms::new(shape, arms, &mut never)) else {
        panic!("no limit is reached")
    };
    assert_eq!((made.mesh.check(), made.arms.len()), (vec![], made.mesh.face_count()));
    (made, env.take_faults().0.len())
}

fn made(shape: &Shape, arms: &[Arm], distance: f64) -> Faces {
    let (made, faults) = made_by(shape, arms, |env, arms| setback(env, arms, distance, 0.0));
    assert_eq!(faults, 0);
    made
}

fn made_each(shape: &Shape, arms: &[Arm], distances: &[f64]) -> Faces {
    let distances = Array::from(distances.to_vec());
    let (made, faults) = made_by(shape, arms, |env, arms| setback_each(env, arms, distances, 0.0));
    assert_eq!(faults, 0);
    made
}

/// For each face its arm, the number of its corners and its area in millionths.
fn parts(made: &Faces) -> Vec<(Option<u32>, usize, f64)> {
    let faces = made.mesh.faces().zip(&made.arms);
    faces.map(|(face, &arm)| (arm, face.corner_count(), (face.area() * 1e6).round() / 1e6)).collect()
}

/// The area of each arm.
pub(in crate::op) fn areas<const N: usize>(made: &Faces) -> [f64; N] {
    let of = |arm: usize| made.mesh.faces().zip(&made.arms).filter(move |part| *part.1 == Some(arm as u32));
    std::array::from_fn(|arm| of(arm).map(|(face, _)| face.area()).sum())
}

#[test]
fn a_strip_and_the_rest() {
    let lot = Shape::rectangle(10.0, 8.0);
    assert_eq!(parts(&made(&lot, &[FRONT, REST], 2.0)), [(Some(0), 4, 20.0), (Some(1), 4, 60.0)]);
    // A ring without further edges, and what it encloses.
    assert_eq!(parts(&made(&lot, &[ALL, REST], 2.0)), [(Some(0), 8, 56.0), (Some(1), 4, 24.0)]);
    assert_eq!(parts(&made(&lot, &[ALL, REST], 5.0)), [(Some(0), 4, 80.0)]);
    for nothing in [0.0, -3.0] {
        assert_eq!(parts(&made(&lot, &[ALL, REST], nothing)), [(Some(1), 4, 80.0)]);
    }
}

#[test]
fn the_place_of_the_remainder_among_the_arms_does_not_matter() {
    let lot = Shape::rectangle(10.0, 8.0);
    let [rest, front] = areas(&made(&lot, &[REST, FRONT], 2.0));
    assert_eq!([front, rest], [20.0, 60.0]);
    // Without its arm the rest is dropped.
    assert_eq!(made(&lot, &[FRONT], 2.0).arms, [Some(0), None]);
}

#[test]
fn an_earlier_arm_keeps_the_corner() {
    let lot = Shape::rectangle(10.0, 8.0);
    assert_eq!(areas(&made(&lot, &[FRONT, LEFT, REST], 2.0)), [20.0, 12.0, 48.0]);
    assert_eq!(areas(&made(&lot, &[LEFT, FRONT, REST], 2.0)), [16.0, 16.0, 48.0]);
    assert_eq!(areas(&made(&lot, &[FRONT, BACK, LEFT, RIGHT, REST], 3.0)), [30.0, 30.0, 6.0, 6.0, 8.0]);
}

#[test]
fn an_edge_belongs_to_the_first_arm_that_selects_it() {
    let lot = Shape::rectangle(10.0, 8.0);
    // The first arm takes the front, so the strip of the others has three sides.
    assert_eq!(areas(&made(&lot, &[FRONT, ALL, REST], 1.0)), [10.0, 7.0 + 7.0 + 8.0, 48.0]);
    assert_eq!(areas(&made(&lot, &[ALL, FRONT, REST], 1.0)), [32.0, 0.0, 48.0]);
}

/// Indices count from 0, and all others wrap.
#[test]
fn indices_wrap() {
    let lot = Shape::rectangle(10.0, 8.0);
    let lengths: [f64; 4] = [0.0, 1.0, 2.0, 3.0].map(|k| areas::<1>(&made(&lot, &[index(k)], 1.0))[0]);
    let [a, b, ..] = lengths;
    assert_eq!(lengths, [a, b, a, b]);
    assert_eq!(a + b, 18.0);
    for (wrapped, plain) in [(-1.0, 3.0), (4.0, 0.0), (-4.0, 0.0), (-4_000_001.0, 3.0), (1e9 + 2.0, 2.0)] {
        let [one, other] = [wrapped, plain].map(|k| made(&lot, &[index(k), REST], 1.0));
        assert_eq!(one.mesh.points(), other.mesh.points(), "{wrapped}");
    }
    assert_eq!(made(&lot, &[index(0.5), REST], 1.0).arms, [Some(1)]);
    let (faces, faults) = made_by(&lot, &[index(f64::NAN), REST], |env, arms| setback(env, arms, 1.0, 0.0));
    assert_eq!((faces.arms, faults), (vec![Some(1)], 1));
}

/// Two faces side by side: the square from x = 0 and the one from x = 10.
fn two() -> Shape {
    let mut builder = MeshBuilder::new();
    for x in [0.0, 10.0] {
        let corners = [[x, 0.0], [x + 10.0, 0.0], [x + 10.0, 10.0], [x, 10.0]];
        let points: Vec<u32> = corners.map(|[x, z]| builder.point(DVec3::new(x, 0.0, -z))).to_vec();
        builder.face(&points, &[], FaceTag::PLAIN);
    }
    Shape::mesh_axis_aligned(builder.build().expect("a mesh"))
}

#[test]
fn distances_follow_the_edges_of_all_faces() {
    let arms = [ALL, REST];
    let each = |distances: &[f64]| parts(&made_each(&two(), &arms, distances));
    // The fifth distance belongs to the first edge of the second face.
    assert_eq!(
        each(&[1.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0]),
        [(Some(0), 4, 10.0), (Some(1), 4, 90.0), (Some(0), 4, 30.0), (Some(1), 4, 70.0)]
    );
    // Missing ones set nothing back, further ones count for nothing.
    assert_eq!(each(&[1.0]), [(Some(0), 4, 10.0), (Some(1), 4, 90.0), (Some(1), 4, 100.0)]);
    assert_eq!(each(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 5.0]), each(&[]));
    // All parts of an arm have its number, whatever the face: `=` makes one shape of them.
    assert_eq!(parts(&made(&two(), &arms, 1.0)).len(), 4);
    // An index counts on from face to face.
    assert_eq!(areas(&made(&two(), &[index(4.0), index(0.0), REST], 2.0)), [20.0, 20.0, 160.0]);
}

/// `shapeL(5, 5)` and its mirror image, with distances for front, right, back and left.
#[test]
fn distances_for_two_sides_make_an_l() {
    let lot = polygon(&[[0.0, 0.0], [20.0, 0.0], [20.0, 12.0], [0.0, 12.0]]);
    for (distances, x) in [([5.0, 0.0, 0.0, 5.0], [5.0, 20.0]), ([5.0, 5.0, 0.0, 0.0], [0.0, 15.0])] {
        let made = made_each(&lot, &[ALL, REST], &distances);
        assert_eq!(parts(&made), [(Some(0), 6, 240.0 - 105.0), (Some(1), 4, 105.0)]);
        let rest: Vec<f64> = made.mesh.face(1).outline().map(|at| at.x).collect();
        assert!(rest.iter().all(|at| x.contains(at)), "{rest:?}");
    }
}

/// Parts begin at the outline with the first edge that was set back; the rest with the first edge, also if it moved.
#[test]
fn parts_begin_with_first_edges() {
    let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]];
    // The front is where the scope's z is largest.
    let at = |x: f64, z: f64| DVec3::new(x, 0.0, 8.0 - z);
    let lot = polygon(&corners);
    let made = made(&lot, &[RIGHT, BACK, REST], 2.0);
    let first = |face: usize| made.mesh.face(face).outline().take(2).collect::<Vec<_>>();
    assert_eq!(first(0), [at(10.0, 0.0), at(10.0, 8.0)]);
    assert_eq!(first(1), [at(8.0, 8.0), at(0.0, 8.0)]);
    assert_eq!(first(2), [at(0.0, 0.0), at(8.0, 0.0)]);
    // Without a front, the rest begins with the front, moved.
    let made = self::made(&lot, &[FRONT, REST], 2.0);
    assert_eq!(made.mesh.face(1).outline().take(2).collect::<Vec<_>>(), [at(0.0, 2.0), at(10.0, 2.0)]);
}

#[test]
fn collinear_corners_stay() {
    let lot = polygon(&[[0.0, 0.0], [4.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]]);
    assert_eq!(parts(&made(&lot, &[FRONT, REST], 2.0)), [(Some(0), 6, 20.0), (Some(1), 5, 60.0)]);
    // Distances that differ end at right angles.
    let made = made_each(&lot, &[ALL, REST], &[1.0, 2.0]);
    assert_eq!(parts(&made), [(Some(0), 7, 16.0), (Some(1), 6, 64.0)]);
}

/// A rectangle of 10 x 8 with u along x and v along z, from 0 to 1, in set 2.
fn textured(mirror: f64) -> Shape {
    let mut builder = MeshBuilder::new();
    let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]];
    let points: Vec<u32> = corners.iter().map(|[x, z]| builder.point(DVec3::new(*x, 0.0, -z))).collect();
    builder.face(&points, &[], FaceTag::PLAIN);
    let uvs = corners.map(|[x, z]| DVec2::new(mirror * x / 10.0, z / 8.0));
    builder.uv_set(2, &uvs);
    Shape::mesh_axis_aligned(builder.build().expect("a mesh"))
}

#[test]
fn edges_are_selected_in_texture_space() {
    for mirror in [1.0, -1.0] {
        let lot = textured(mirror);
        // The low x of what is swept, if it is an upright edge, else the low z.
        let takes = |selected: Word, set: f64| {
            let arms = [word(selected, "uv"), REST];
            let (made, _) = made_by(&lot, &arms, |env, arms| setback(env, arms, 1.0, set));
            made.arms.contains(&Some(0)).then(|| {
                let low =
                    made.mesh.face(0).outline().fold(DVec3::INFINITY, |low, at| low.min(DVec3 { z: 8.0 - at.z, ..at }));
                (low.x, low.z)
            })
        };
        let [left, right, bottom, top] = [(0.0, 0.0), (9.0, 0.0), (0.0, 0.0), (0.0, 7.0)].map(Some);
        let (small, large) = if mirror < 0.0 { (right, left) } else { (left, right) };
        let words = [
            (Word::UvLeft, small),
            (Word::UvRight, large),
            (Word::UvBottom, bottom),
            (Word::UvTop, top),
            (Word::UvUMin, small),
            (Word::UvUMax, large),
            (Word::UvVMin, bottom),
            (Word::UvVMax, top),
        ];
        for (word, place) in words {
            assert_eq!(takes(word, 2.0), place, "{word:?} {mirror}");
            // A set without coordinates, and one that no mesh has.
            assert_eq!([takes(word, 0.0), takes(word, 10.0), takes(word, f64::NAN)], [None; 3]);
        }
    }
}

#[test]
fn distances_that_are_no_numbers_leave_faults() {
    let lot = Shape::rectangle(10.0, 8.0);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (made, faults) = made_by(&lot, &[ALL, REST], |env, arms| setback(env, arms, bad, 0.0));
        assert_eq!((parts(&made), faults), (vec![(Some(1), 4, 80.0)], 1));
        let distances = Array::from(vec![1.0, bad, 0.0, 0.0]);
        let (made, faults) = made_by(&lot, &[ALL, REST], |env, arms| setback_each(env, arms, distances, 0.0));
        assert_eq!((made.arms.len(), faults), (2, 1));
    }
    for shape in [Shape::point([0.0; 3]), Shape::rectangle(0.0, 5.0), Shape::mesh(Mesh::default())] {
        let (made, _) = made_by(&shape, &[ALL, REST], |env, arms| setback(env, arms, 1.0, 0.0));
        assert!(made.arms.iter().all(|arm| *arm == Some(1)), "{made:?}");
    }
}

#[test]
fn huge_distances_take_all() {
    for shape in lots() {
        for distance in [1e6, 1e30, f64::MAX] {
            let [all, rest] = areas(&made(&shape, &[ALL, REST], distance));
            assert!((all - shape.to_mesh().area()).abs() < 1e-9 && rest == 0.0, "{distance}: {all} {rest}");
            let [front, left, rest] = areas(&made(&shape, &[FRONT, LEFT, REST], distance));
            assert!((front + left + rest - shape.to_mesh().area()).abs() < 1e-9, "{front} {left} {rest}");
        }
    }
}

/// Random outlines, with holes and with corners that are nearly collinear.
pub(in crate::op) fn random_lot(number: usize, state: &mut u64) -> Shape {
    let count = 3 + (random(state) * 14.0) as usize;
    let ring = |state: &mut u64, low: f64, high: f64| -> Vec<[f64; 2]> {
        let corner = |k: usize, radius: f64| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / count as f64);
            [radius * cos, radius * sin]
        };
        let corners: Vec<[f64; 2]> = (0..count).map(|k| corner(k, low + (high - low) * random(state))).collect();
        let middle = |k: usize| {
            let ([ax, az], [bx, bz]) = (corners[k], corners[(k + 1) % count]);
            let off = [1e-13, 1e-9, 1e-6, 0.0][k % 4] * (random(state) - 0.5);
            [0.5 * (ax + bx) + off, 0.5 * (az + bz) - off]
        };
        if number.is_multiple_of(3) {
            (0..count).map(middle).zip(&corners).flat_map(|(middle, corner)| [*corner, middle]).collect()
        } else {
            corners
        }
    };
    let outline = ring(state, 8.0, 20.0);
    let hole = ring(state, 1.0, 3.0);
    if number.is_multiple_of(2) { polygon(&outline) } else { holed(&outline, &[&hole]) }
}

/// A quarter turn of a face gives the same parts, with the words turned too.
#[test]
fn turned_faces_have_turned_parts() {
    let quarter = glam::DMat3::from_cols(DVec3::new(0.0, 0.0, -1.0), DVec3::Y, DVec3::X);
    for shape in lots() {
        let turned = shape.to_mesh().map(&glam::DAffine3::from_mat3(quarter));
        let turned = Shape::mesh_axis_aligned(turned);
        for distance in [0.3, 1.0, 2.5] {
            let a: [f64; 4] = areas(&made(&shape, &[FRONT, LEFT, BACK, REST], distance));
            let b: [f64; 4] = areas(&made(&turned, &[RIGHT, FRONT, LEFT, REST], distance));
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9), "{distance}: {a:?} {b:?}");
        }
    }
}

/// The areas that all arms have in turns, or that one arm has with all edges, and the rest.
fn in_turns_and_at_once(shape: &Shape, distances: &[f64]) -> ([f64; 6], [f64; 2]) {
    let all = shape.to_mesh().area();
    let turns: [f64; 6] = areas(&made_each(shape, &[FRONT, index(0.0), LEFT, BACK, RIGHT, REST], distances));
    let once: [f64; 2] = areas(&made_each(shape, &[ALL, REST], distances));
    assert!((turns.iter().sum::<f64>() - all).abs() < 1e-9 * all, "{turns:?}, {all}");
    assert!((once[0] + once[1] - all).abs() < 1e-9 * all, "{once:?}, {all}");
    (turns, once)
}

#[test]
fn parts_of_random_faces_add_up() {
    let state = &mut 11;
    for number in 0..1200 {
        let shape = random_lot(number, state);
        let corners = shape.to_mesh().corners().len();
        let equal = random(state) * 6.0;
        let each = |state: &mut u64| if number % 5 == 0 { equal } else { (random(state) * 9.0 - 2.0).max(0.0) };
        let distances: Vec<f64> = (0..corners).map(|_| each(state)).collect();
        in_turns_and_at_once(&shape, &distances);
    }
}

/// Where no setback meets another one but at a corner, and in convex faces, the rest does not depend on the arms.
#[test]
fn the_rest_depends_on_the_distances_alone() {
    let state = &mut 5;
    for number in 0..600 {
        let is_convex = number % 2 == 0;
        let mut near = |x: f64, z: f64| [x + 4.0 * random(state), z + 4.0 * random(state)];
        let corners = [near(0.0, 0.0), near(20.0, 0.0), near(20.0, 16.0), near(0.0, 16.0)];
        let shape = if is_convex { polygon(&corners) } else { random_lot(number / 2, state) };
        let most = if is_convex { 9.0 } else { 0.1 };
        let each = |_: &u32| (random(state) * 1.3 - 0.3).max(0.0) * most;
        let distances: Vec<f64> = shape.to_mesh().corners().iter().map(each).collect();
        let (turns, once) = in_turns_and_at_once(&shape, &distances);
        assert!((once[1] - turns[5]).abs() <= 1e-9 * shape.to_mesh().area(), "{number}: {once:?} {turns:?}");
    }
}

/// Edges with corners that are 1e-9 off meet nearly all along in the second turn, and two lines have the same side.
#[test]
fn nearly_parallel_edges_that_meet_lose_no_area() {
    let outline: [[f64; 2]; 14] = [
        [-1.1198229557221258e-9, -6.597301058655537e-10],
        [4.078982097617392, -1.076238464817031e-9],
        [8.023132155613796, -5.452395069635452e-10],
        [12.950446781663352, -6.611791221668379e-10],
        [17.847092071288998, 4.644557936521082e-10],
        [17.84709207226343, 3.0000000001682507],
        [17.847092072330298, 6.000000001020592],
        [17.847092070366514, 8.999999999135696],
        [12.950446781219608, 8.999999998872212],
        [8.023132157176187, 9.000000000619012],
        [4.07898209601488, 9.000000000334024],
        [4.07898209746833, 6.000000000771388],
        [-1.2250052450297724e-10, 6.0000000002094405],
        [3.1481998746270006e-11, 3.0000000005423364],
    ];
    let shape = Shape::footprint(&outline, &[]).expect("an outline");
    let whole = shape.to_mesh().area();
    let side = word(Word::Side, "side");
    let made = made(&shape, &[FRONT, BACK, side, REST], 17.84709207345012 * 0.2);
    let sum: f64 = made.mesh.faces().map(|face| face.area()).sum();
    assert!((sum - whole).abs() < 1e-9 * whole, "{sum} of {whole}");
}
