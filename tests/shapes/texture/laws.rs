//! Laws of texture coordinates.

use std::collections::BTreeMap;

use cga::glam::{DMat3, DVec2, DVec3};
use cga::{Shape, cga};

use crate::collect::{Corner, Leaves, leaves};

fn area(faces: &[Vec<Corner>]) -> f64 {
    let of_face = |face: &Vec<Corner>| {
        let around = face.iter().zip(face.iter().cycle().skip(1));
        let sum: DVec3 = around.map(|(a, b)| (a.point - face[0].point).cross(b.point - face[0].point)).sum();
        sum.length() / 2.0
    };
    faces.iter().map(of_face).sum()
}

fn sum_of_areas(leaves: &Leaves) -> f64 {
    leaves.0.iter().map(|(_, faces)| area(faces)).sum()
}

/// A footprint with seven corners, no two sides parallel.
const OUTLINE: [[f64; 2]; 7] =
    [[0.0, 0.0], [6.13, 0.71], [11.9, -0.37], [13.1, 5.93], [8.7, 4.11], [5.3, 9.77], [-1.9, 6.1]];

/// The footprint and a rectangle, at a place and turned by an angle in radians.
fn shapes(angle: f64, at: DVec3) -> [Shape; 2] {
    let [cos, sin] = DVec2::from_angle(angle).to_array();
    let turned = |outline: &[[f64; 2]]| {
        let outline: Vec<[f64; 2]> = outline.iter().map(|[x, z]| [x * cos - z * sin, x * sin + z * cos]).collect();
        Shape::footprint(&outline, &[]).expect("an outline").at(at.to_array())
    };
    [turned(&OUTLINE), turned(&[[0.0, 0.0], [9.0, 0.0], [9.0, 4.0], [0.0, 4.0]])]
}

cga! {
    /// Splits in texture space with pieces of all kinds.
    grammar Pieces;
    attr kind = 0
    attr angle = 0
    Lot --> setupProjection(0, scope.xz, 1.7, 2.3, 0.3, ^0.1) projectUV(0) rotateUV(0, angle) Split
    Split -->
        case kind == 0 : X.
        case kind == 1 : split(u, uvSpace, 0) { 0.7 : X. | { ~0.4 : X. | ~0.9 : X. }* }
        case kind == 2 : split(v, unitSpace, 0) { { ~1 : X. | ^0.1 : split(u, unitSpace, 0) { { ~1.3 : Y. }* } }* }
        else : extrude(3) split(v, uvSpace, 0) { { ~0.31 : X. }* }
}

#[test]
fn areas_of_pieces_of_a_split_add_up() {
    for shape in shapes(0.3, DVec3::new(5.0, 1.0, -900.0)) {
        for angle in [0.0, 33.0, 90.0] {
            let run = |kind: u32| leaves!(Pieces { kind: f64::from(kind), angle }, &shape);
            let whole = sum_of_areas(&run(0));
            for kind in [1, 2] {
                let pieces = run(kind);
                let sum = sum_of_areas(&pieces);
                assert!(pieces.0.len() >= 2 && (sum - whole).abs() < 1e-9 * whole, "{kind} {angle}: {sum} and {whole}");
            }
        }
    }
}

#[test]
fn coordinates_at_a_shared_point_agree_to_the_last_bit() {
    for shape in shapes(0.3, DVec3::new(5.0, 1.0, -900.0)) {
        for (kind, angle) in [(1, 0.0), (1, 33.0), (2, 0.0), (2, 17.0)] {
            let leaves = leaves!(Pieces { kind: f64::from(kind), angle }, &shape.clone());
            // Pieces have frames of their own, so that their points in the world differ by rounding.
            let key = |point: DVec3| (point * 1e6).round().to_array().map(|number| number as i64);
            let mut known: BTreeMap<[i64; 3], Vec<DVec2>> = BTreeMap::new();
            for corner in leaves.0.iter().flat_map(|(_, faces)| faces.iter().flatten()) {
                known.entry(key(corner.point)).or_default().push(corner.uvs[0].expect("coordinates"));
            }
            let shared: Vec<_> = known.values().filter(|uvs| uvs.len() > 1).collect();
            assert!(shared.len() > 5);
            for uvs in shared {
                assert!(
                    uvs.iter().all(|uv| uv.x.to_bits() == uvs[0].x.to_bits() && uv.y.to_bits() == uvs[0].y.to_bits()),
                    "{kind} {angle}: {uvs:?}"
                );
            }
        }
    }
}

cga! {
    /// The same projection once or twice.
    grammar Twice;
    attr twice = false
    attr then = 0
    Lot --> extrude(3) comp(f) { all : Face }
    Face -->
        setupProjection(0, scope.xy, ~2, ^0.3, 0.4, -0.1, 1) setupProjection(3, world.zy, 1, 3) projectUV(0) projectUV(3)
        [ case twice : setupProjection(0, scope.xy, ~2, ^0.3, 0.4, -0.1, 1) projectUV(3) projectUV(0) Next else : Next ]
    Next -->
        case then == 0 : X.
        case then == 1 : split(x) { { ~2 : Tile }* }
        else : split(u, unitSpace, 0) { { ~1 : Tile }* }
    Tile --> case twice : projectUV(0) projectUV(0) X. else : X.
}

#[test]
fn projecting_twice_changes_nothing() {
    for shape in shapes(0.3, DVec3::new(5.0, 1.0, -900.0)) {
        for then in [0.0, 1.0] {
            let once = leaves!(Twice { twice: false, then }, &shape);
            let twice = leaves!(Twice { twice: true, then }, &shape);
            assert!(once.0.len() > 5);
            assert_eq!(once, twice);
        }
    }
}

#[test]
fn projecting_again_after_a_split_in_texture_space_is_the_same_but_for_rounding() {
    for shape in shapes(0.3, DVec3::new(5.0, 1.0, -900.0)) {
        let once = leaves!(Twice { then: 2.0, ..Twice::default() }, &shape);
        let twice = leaves!(Twice { twice: true, then: 2.0 }, &shape);
        assert_eq!(once.0.len(), twice.0.len());
        for ((_, a), (_, b)) in once.0.iter().zip(&twice.0) {
            for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
                assert!(a.point.abs_diff_eq(b.point, 1e-9));
                for set in [0, 3] {
                    assert!(a.uvs[set].unwrap().abs_diff_eq(b.uvs[set].unwrap(), 1e-9), "{a:?} {b:?}");
                }
            }
        }
    }
}

cga! {
    /// Metres on a flat rectangle, whatever its texture.
    grammar Metres;
    attr width = 1
    attr v = false
    Lot --> setupProjection(0, scope.xz, width, ^0.7, 0.1, 2) projectUV(0) Split
    Split -->
        case v : split(v, unitSpace, 0) { 1 : X. | 0.25 : X. | ~1 : X. | 0.5 : X. }
        else : split(u, unitSpace, 0) { 1 : X. | 0.25 : X. | ~1 : X. | 0.5 : X. }
}

#[test]
fn lengths_in_unit_space_are_exact_on_a_flat_rectangle() {
    for (width, v) in [(1.0, false), (2.5, false), (-0.3, true), (1e-3, false), (7e4, true)] {
        let leaves = leaves!(Metres { width, v }, &Shape::rectangle(8.0, 4.0));
        let (across, along) = if v { (8.0, 4.0) } else { (4.0, 8.0) };
        let areas: Vec<f64> = leaves.0.iter().map(|(_, faces)| area(faces) / across).collect();
        let mut expected = [1.0, 0.25, along - 1.75, 0.5];
        if areas[0] < 0.9 && width < 0.0 && !v {
            expected.reverse();
        }
        for (found, expected) in areas.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12 * along, "{width} {v}: {areas:?}");
        }
        assert_eq!(areas.len(), 4);
    }
}

cga! {
    /// Scope projections of all axes, carried through operations, splits and components.
    grammar Turned;
    Lot -->
        setupProjection(0, scope.xz, 1.3, ~2) setupProjection(1, scope.zy, ^1, 1, 0, 0, 1) setupProjection(2, scope.yx, 1, -2, ^0.1, 3)
        [ projectUV(0) X. ]
        extrude(4)
        projectUV(0) projectUV(1) projectUV(2)
        split(y) { 1 : Y. | ~1 : comp(f) { side : Face | top : Z. } }
    Face --> copyUV(0, 4) setupProjection(0, scope.xy, 1, 1, 0, 0, 1) projectUV(0) split(x) { { ~1.5 : Tile }* }
    Tile --> t(0, 0.1, -0.2) s(^0.9, ^0.8, ^1) split(u, uvSpace, 0) { 0.3 : T. | ~1 : U. }
}

#[test]
fn turning_and_moving_the_input_changes_no_coordinates() {
    let still = shapes(0.0, DVec3::ZERO).map(|shape| leaves!(Turned::default(), &shape));
    for (angle, at) in [(0.7, DVec3::new(3.0, 4.0, 5.0)), (-2.1, DVec3::new(-500.0, 0.0, 70.0)), (1.0, DVec3::ZERO)] {
        let turn = DMat3::from_rotation_y(-angle);
        for (still, shape) in still.iter().zip(shapes(angle, at)) {
            let moved = leaves!(Turned::default(), &shape);
            assert_eq!(still.0.len(), moved.0.len());
            let mut compared = 0;
            for ((rule, a), (other, b)) in still.0.iter().zip(&moved.0) {
                assert_eq!((rule, a.len()), (other, b.len()));
                for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
                    assert!((turn * a.point + at).abs_diff_eq(b.point, 1e-9), "{rule}: {a:?} {b:?}");
                    for (a, b) in a.uvs.iter().zip(&b.uvs) {
                        let same = a.zip(*b).map_or(a == b, |(a, b)| a.abs_diff_eq(b, 1e-9));
                        assert!(same, "{rule}: {a:?} {b:?}");
                        compared += usize::from(a.is_some());
                    }
                }
            }
            assert!(compared > 300, "{compared}");
        }
    }
}
