use super::*;
use crate::comp::Arm;
use crate::geometry::primitive::cube;
use crate::op::face::setback::tests::{ALL, REST, areas, made_by, random_lot, word};
use crate::op::face::swept_edges::tests::{lots, polygon, random};
use crate::shape::Shape;

const FRONT: Arm = word(Word::Front, "front");
const LEFT: Arm = word(Word::Left, "left");

/// The areas of the arms, without faults.
fn left<const N: usize>(shape: &Shape, arms: &[Arm; N], area: f64) -> [f64; N] {
    let (made, faults) = made_by(shape, arms, |env, arms| setback_to_area(env, arms, area, 0.0));
    assert_eq!(faults, 0);
    areas(&made)
}

fn between(shape: &Shape, area: f64, least: &[f64], most: Option<&[f64]>) -> [f64; 2] {
    let [least, most] = [Some(least), most].map(|list| list.map(|list| Array::from(list.to_vec())));
    let (made, faults) = made_by(shape, &[ALL, REST], |env, arms| match (least, most) {
        (Some(least), Some(most)) => setback_to_area_between(env, arms, area, least, most, 0.0),
        (Some(least), None) => setback_to_area_from(env, arms, area, least, 0.0),
        _ => setback_to_area(env, arms, area, 0.0),
    });
    assert_eq!(faults, 0);
    areas(&made)
}

fn close<const N: usize>(found: [f64; N], expected: [f64; N]) {
    let all: f64 = expected.iter().sum();
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= 1e-12 * all), "{found:?}, not {expected:?}");
}

#[test]
fn a_square_keeps_a_square() {
    let lot = Shape::rectangle(20.0, 20.0);
    close(left(&lot, &[ALL, REST], 100.0), [300.0, 100.0]);
    let (made, _) = made_by(&lot, &[ALL, REST], |env, arms| setback_to_area(env, arms, 100.0, 0.0));
    let x: Vec<f64> = made.mesh.face(1).outline().map(|at| at.x).collect();
    assert!(x.iter().all(|x| (x - 5.0).abs() < 1e-12 || (x - 15.0).abs() < 1e-12), "{x:?}");
}

/// Front and left alone have the same depth.
#[test]
fn an_l_has_equal_depths() {
    let depth = 20.0 - libm::sqrt(100.0);
    close(left(&Shape::rectangle(20.0, 20.0), &[FRONT, LEFT, REST], 100.0), [20.0 * depth, 10.0 * depth, 100.0]);
    close(left(&Shape::rectangle(20.0, 10.0), &[FRONT, REST], 50.0), [150.0, 50.0]);
}

#[test]
fn a_large_area_leaves_the_shape() {
    let lot = Shape::rectangle(20.0, 20.0);
    for area in [400.0, 401.0, 1e300] {
        close(left(&lot, &[ALL, REST], area), [0.0, 400.0]);
    }
    // Without selected edges nothing moves.
    close(left(&lot, &[REST], 100.0), [400.0]);
}

#[test]
fn distances_begin_at_the_smallest_and_end_at_the_largest() {
    let lot = polygon(&[[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]]);
    // (20 - 2t - 3)(20 - 2t) = 130: 3.5 with an offset.
    close(between(&lot, 130.0, &[3.0], None), [270.0, 130.0]);
    // Too large a minimum and too small a maximum.
    close(between(&lot, 390.0, &[1.0; 4], None), [400.0 - 324.0, 324.0]);
    close(between(&lot, 100.0, &[0.0; 4], Some(&[2.0, 2.0, 2.0, 2.0])), [400.0 - 256.0, 256.0]);
    // The front stops at 1, the others go on: (20 - 1 - t)(20 - 2t) = 19 * 20 - 58 t + 2 t^2.
    let t = (58.0 - libm::sqrt(58.0 * 58.0 - 8.0 * 180.0)) / 4.0;
    assert!(1.0 < t);
    close(between(&lot, 200.0, &[0.0; 4], Some(&[1.0, 9.0, 9.0, 9.0])), [200.0, 200.0]);
    // Elements that are missing: no least distance, and an edge that stays.
    close(between(&lot, 200.0, &[], Some(&[50.0])), [200.0, 200.0]);
    close(between(&lot, 200.0, &[30.0], Some(&[4.0])), [80.0, 320.0]);
    close(between(&lot, 200.0, &[-5.0; 4], None), [200.0, 200.0]);
}

#[test]
fn the_area_is_that_of_all_faces() {
    let cube = Shape::mesh_axis_aligned(cube());
    let (made, faults) = made_by(&cube, &[ALL, REST], |env, arms| setback_to_area(env, arms, 1.5, 0.0));
    close(areas(&made), [4.5, 1.5]);
    let rest = made.mesh.faces().zip(&made.arms).filter(|part| *part.1 == Some(1)).map(|part| part.0.area());
    assert!(rest.into_iter().all(|area| (area - 0.25).abs() < 1e-12) && faults == 0);
}

#[test]
fn areas_that_make_no_sense_leave_faults() {
    let lot = Shape::rectangle(20.0, 20.0);
    for (area, count) in [(0.0, 1), (-5.0, 1), (f64::NAN, 2), (f64::INFINITY, 2)] {
        let (made, faults) = made_by(&lot, &[ALL, REST], |env, arms| setback_to_area(env, arms, area, 0.0));
        assert_eq!((areas(&made), faults), ([0.0, 400.0], count), "{area}");
    }
    let list = |value: f64| Array::from(vec![value; 4]);
    let (made, faults) = made_by(&lot, &[ALL, REST], |env, arms| {
        setback_to_area_between(env, arms, 100.0, list(f64::NAN), list(f64::INFINITY), 0.0)
    });
    assert_eq!((areas(&made), faults), ([0.0, 400.0], 2));
}

/// Tiny shares and nearly all of faces of many forms.
#[test]
fn areas_are_exact() {
    for shape in lots() {
        let all = shape.to_mesh().area();
        for share in [1e-6, 0.01, 0.3, 0.5, 0.9, 1.0 - 1e-9] {
            let [setback, rest] = left(&shape, &[ALL, REST], share * all);
            assert!((rest - share * all).abs() <= 1e-9 * share * all, "{share}: {rest} of {all}");
            assert!((setback + rest - all).abs() <= 1e-9 * all);
        }
    }
}

#[test]
fn areas_of_random_faces_are_exact() {
    let state = &mut 17;
    for number in 0..150 {
        let shape = random_lot(number, state);
        let (corners, all) = (shape.to_mesh().corners().len(), shape.to_mesh().area());
        let area = (0.02 + 0.96 * random(state)) * all;
        let [setback, rest] = left(&shape, &[ALL, REST], area);
        assert!((rest - area).abs() <= 1e-9 * area, "{number}: {rest}, not {area}");
        assert!((setback + rest - all).abs() <= 1e-9 * all);
        // With several arms and distances of their own, at least the limits hold.
        let [front, side, rest] = left(&shape, &[FRONT, ALL, REST], area);
        assert!((front + side + rest - all).abs() <= 1e-9 * all);
        assert!((rest - area).abs() <= 1e-9 * area, "{number}: {rest}, not {area}");
        let least: Vec<f64> = (0..corners).map(|_| random(state)).collect();
        let most: Vec<f64> = least.iter().map(|least| least + 3.0 * random(state)).collect();
        let [_, smallest] = between(&shape, 1e-9, &least, Some(&most));
        let [_, largest] = between(&shape, all, &least, Some(&most));
        let [_, rest] = between(&shape, area, &least, Some(&most));
        let expected = area.clamp(smallest, largest);
        assert!((rest - expected).abs() <= 1e-9 * expected.max(1e-3), "{number}: {rest}, not {expected}");
    }
}
