//! Faces with many corners and operands of many faces: results, and the work for them.

use std::slice::from_ref;

use glam::{DAffine3, DVec3};

use super::{BooleanError, BooleanOp, block, combine, combined};
use crate::boolean::budget::Budget;
use crate::boolean::combine_within;
use crate::mesh::{FaceTag, Mesh, MeshBuilder};
use crate::primitive::cylinder;
use crate::random::Rng;
use crate::rotation::turn;
use BooleanOp::{Intersect, Subtract, Unify, Union};

/// A comb of height 1 with teeth of width 0.5, each 1 apart, above a back of width `back`.
fn comb(teeth: u32, back: f64) -> Mesh {
    let mut outline = vec![[0.0, 0.0], [f64::from(teeth), 0.0]];
    for tooth in (0..teeth).rev().map(f64::from) {
        outline.extend([[tooth + 1.0, back], [tooth + 0.5, back], [tooth + 0.5, 1.0], [tooth, 1.0]]);
    }
    // The last tooth begins where the back ends.
    outline.retain(|at| *at != [f64::from(teeth), back] || back != 0.0);
    let mut builder = MeshBuilder::new();
    let mut level = |y: f64| -> Vec<u32> { outline.iter().map(|[x, z]| builder.point([*x, y, *z])).collect() };
    let (low, high) = (level(0.0), level(1.0));
    builder.face(&low, &[], FaceTag::PLAIN);
    builder.face(&high.iter().rev().copied().collect::<Vec<_>>(), &[], FaceTag::PLAIN);
    for (from, to) in (0..low.len()).zip((1..low.len()).chain([0])) {
        builder.face(&[low[from], high[from], high[to], low[to]], &[], FaceTag::PLAIN);
    }
    let made = builder.build().unwrap();
    if made.volume() < 0.0 { made.reversed() } else { made }
}

/// A wall of thickness 0.2 and boxes through it, `count` in each direction.
fn wall_and_boxes(count: u32) -> (Mesh, Vec<Mesh>) {
    let step = 1.0 / f64::from(count);
    let hole = |number: u32| {
        let (x, y) = (f64::from(number % count) * step, f64::from(number / count) * step);
        block([x + 0.2 * step, y + 0.2 * step, -0.5], [x + 0.7 * step, y + 0.7 * step, 0.5])
    };
    (block([0.0, 0.0, -0.1], [1.0, 1.0, 0.1]), (0..count * count).map(hole).collect())
}

#[test]
fn volumes_of_faces_with_many_corners_add_up() {
    for seed in 0..24 {
        let rng = &mut Rng(seed);
        let mut solid = || {
            let form = if rng.unit() < 0.7 {
                let teeth = 20 + (rng.unit() * 20.0) as u32;
                comb(teeth, 0.25).map(&DAffine3::from_scale(DVec3::new(1.0 / f64::from(teeth), 1.0, 1.0)))
            } else {
                cylinder(70 + (rng.unit() * 60.0) as usize)
            };
            // Places in steps, so that solids touch.
            let mut share = || (rng.unit() * 4.0).floor() / 4.0;
            let place = DVec3::new(share(), share(), share());
            let angles = [share(), share(), share()].map(|share| share * 360.0);
            form.map(&DAffine3 { matrix3: turn(angles[0], angles[1], angles[2]), translation: place })
        };
        let (a, b) = (solid(), solid());
        let volume = |op, a: &Mesh, b: &Mesh| {
            let made = combined(op, a, b).unwrap_or_else(|error| panic!("{seed}: {op:?}: {error:?}"));
            assert_eq!(made.check(), [], "{seed}: {op:?}");
            assert!(made.is_empty() || made.is_closed(), "{seed}: {op:?}");
            made.volume()
        };
        let (union, common) = (volume(Union, &a, &b), volume(Intersect, &a, &b));
        let (left, right) = (volume(Subtract, &a, &b), volume(Subtract, &b, &a));
        let near = |x: f64, y: f64| assert!((x - y).abs() < 1e-7, "{seed}: {x} and {y}");
        near(union + common, a.volume() + b.volume());
        near(left + common, a.volume());
        near(right + common, b.volume());
    }
}

#[test]
fn crossing_combs_have_the_common_part_of_their_teeth() {
    let comb = comb(40, 0.0);
    let turned = comb.map(&DAffine3 { matrix3: turn(0.0, 90.0, 0.0), translation: DVec3::ZERO });
    let turned = turned.map(&DAffine3::from_translation(DVec3::new(0.25, 0.0, 0.25) - turned.bounds().low));
    let common = combined(Intersect, &comb, &turned).unwrap();
    assert!(common.is_closed() && common.check().is_empty());
    let other = combined(Intersect, &turned, &comb).unwrap();
    assert!((common.volume() - other.volume()).abs() < 1e-9 && 0.0 < common.volume());
}

#[test]
fn polygons_with_many_corners_in_a_plane_are_divided() {
    // Regular polygons, turned by half a step: the common part is a polygon with twice the number of corners.
    let corners = 200;
    let ring = |turned: f64| {
        let mut builder = MeshBuilder::new();
        let corner = |number: u32| {
            let angle = (f64::from(number) + turned) / f64::from(corners) * std::f64::consts::TAU;
            [libm::cos(angle), 0.0, -libm::sin(angle)]
        };
        let ring: Vec<u32> = (0..corners).map(|number| builder.point(corner(number))).collect();
        builder.face(&ring, &[], FaceTag::PLAIN);
        builder.build().unwrap()
    };
    let (a, b) = (ring(0.0), ring(0.5));
    let common = combined(Intersect, &a, &b).unwrap();
    assert_eq!((common.face_count(), common.face(0).outer().len()), (1, 2 * corners as usize));
    let left = combined(Subtract, &a, &b).unwrap();
    assert_eq!(left.face_count(), corners as usize);
    assert!((left.area() + common.area() - a.area()).abs() < 1e-12);
}

#[test]
fn the_work_for_a_wall_with_many_windows_grows_with_their_number() {
    let (wall, boxes) = wall_and_boxes(16);
    let within = |comparisons, a: &[Mesh], b: &[Mesh]| {
        combine_within(Budget { comparisons, ..Budget::DEFAULT }, Subtract, [a, b], 0.0)
    };
    let made = within(600_000, from_ref(&wall), &boxes).unwrap();
    assert!((made.volume() - 0.15).abs() < 1e-12 && made.is_closed());
    // The wall with windows is an operand again: its front and back have more than 1000 corners.
    let other = block([0.5, 0.5, -1.0], [0.6, 0.6, 1.0]);
    let again = within(400_000, from_ref(&made), from_ref(&other)).unwrap();
    let common = combined(Intersect, &made, &other).unwrap();
    assert!((again.volume() + common.volume() - 0.15).abs() < 1e-12 && again.is_closed());
}

/// Squares of half a metre at random places in a square metre.
fn random_squares(count: u32) -> Vec<Mesh> {
    let rng = &mut Rng(5);
    let square = |_: u32| {
        let at = DVec3::new(rng.unit() * 0.5, 0.0, rng.unit() * 0.5);
        let mut builder = MeshBuilder::new();
        let corners = [DVec3::ZERO, DVec3::Z * 0.5, DVec3::new(0.5, 0.0, 0.5), DVec3::X * 0.5];
        let ring = corners.map(|corner| builder.point(at + corner));
        builder.face(&ring, &[], FaceTag::PLAIN);
        builder.build().unwrap()
    };
    (0..count).map(square).collect()
}

#[test]
fn squares_that_all_overlap_in_a_plane_have_one_arrangement() {
    let squares = random_squares(60);
    let within = |budget: Budget| combine_within(budget, Unify, [&squares, &[]], 0.0);
    // The work for a pair of squares does not grow with the number of squares over them.
    let made = within(Budget { comparisons: 1_500_000, owners: 25_000, ..Budget::DEFAULT }).unwrap();
    assert_eq!(made.check(), []);
    let area = |mesh: &Mesh| mesh.faces().map(|face| face.area()).sum::<f64>();
    // All edges stay, so parts do not overlap: the area follows from a count of cells between the lines of all edges.
    let mut lines: [Vec<f64>; 2] = [0, 2].map(|axis| {
        squares
            .iter()
            .flat_map(|one| {
                let bounds = one.bounds();
                [bounds.low[axis], bounds.high[axis]]
            })
            .collect()
    });
    lines.iter_mut().for_each(|list| list.sort_by(f64::total_cmp));
    let mut covered = 0.0;
    for x in lines[0].windows(2) {
        for z in lines[1].windows(2) {
            let middle = DVec3::new(x[0] + x[1], 0.0, z[0] + z[1]) * 0.5;
            let is_in = |one: &Mesh| one.bounds().low.cmple(middle).all() && middle.cmple(one.bounds().high).all();
            covered += if squares.iter().any(is_in) { (x[1] - x[0]) * (z[1] - z[0]) } else { 0.0 };
        }
    }
    assert!((area(&made) - covered).abs() < 1e-9, "{} {covered}", area(&made));
    assert_eq!(within(Budget { windings: 5_000, ..Budget::DEFAULT }).err(), Some(BooleanError::TooMany));
    assert_eq!(within(Budget { owners: 2_000, ..Budget::DEFAULT }).err(), Some(BooleanError::TooMany));
}

#[test]
fn boxes_on_a_floor_are_joined_with_it() {
    // Some overlap and some touch each other.
    let floor = block([0.0, -1.0, 0.0], [12.0, 0.0, 12.0]);
    let rng = &mut Rng(9);
    let mut boxes = Vec::new();
    let mut heights = vec![0.0f64; 48 * 48];
    for number in 0..144 {
        let size = [1, 2 + (number % 3)][number % 2];
        let at = [0; 2].map(|_: i32| (rng.unit() * (48 - 4 * size) as f64) as usize);
        let height = 1.0 + f64::from(number as u32 % 4);
        let [x, z] = at.map(|place| place as f64 * 0.25);
        boxes.push(block([x, 0.0, z], [x + size as f64, height, z + size as f64]));
        for place in (0..4 * size).flat_map(|i| (0..4 * size).map(move |j| (at[0] + i) * 48 + at[1] + j)) {
            heights[place] = heights[place].max(height);
        }
    }
    let expected = 144.0 + heights.iter().sum::<f64>() / 16.0;
    for turn_by in [0.0, 17.0] {
        let place = DAffine3 { matrix3: turn(turn_by, turn_by, 0.0), translation: DVec3::ZERO };
        let boxes: Vec<Mesh> = boxes.iter().map(|one| one.map(&place)).collect();
        let made = combine(Union, [from_ref(&floor.map(&place)), &boxes], 16.0 * f64::EPSILON).unwrap();
        assert!(made.is_closed() && made.check().is_empty());
        assert!((made.volume() - expected).abs() < 1e-6, "{} {expected}", made.volume());
    }
}
