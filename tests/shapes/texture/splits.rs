//! Splits in texture space (*split operation*).

use cga::glam::{DVec2, DVec3};
use cga::{Mesh, Shape, cga};
use cga_runtime::geometry::mesh::MeshBuilder;

use crate::collect::{Leaves, leaves};

/// The area of a leaf.
fn area(faces: &[Vec<crate::collect::Corner>]) -> f64 {
    let of_face = |face: &Vec<crate::collect::Corner>| {
        let points: Vec<DVec3> = face.iter().map(|corner| corner.point).collect();
        let around = points.iter().zip(points.iter().cycle().skip(1));
        around.map(|(a, b)| (*a - points[0]).cross(*b - points[0])).sum::<DVec3>().length() / 2.0
    };
    faces.iter().map(of_face).sum()
}

fn areas(leaves: &Leaves, rule: &str) -> Vec<f64> {
    leaves.0.iter().filter(|(name, _)| name == rule).map(|(_, faces)| area(faces)).collect()
}

fn near(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9)
}

cga! {
    /// *split operation*, UV split examples of a façade.
    grammar Facades;
    attr metres = false
    Lot --> comp(f) { front : Facade }
    Facade -->
        setupProjection(0, scope.xy, ^1, ^1)
        projectUV(0)
        Split
    Split -->
        case metres : split(u, unitSpace, 0) { 5 : X. }*
        else : split(u, uvSpace, 0) { 0.5 : X. }*
}

#[test]
fn halves_whatever_the_size_and_pieces_of_five() {
    for width in [3.0, 23.0, 400.0] {
        let halves = leaves!(Facades::default(), &Shape::cuboid(width, 4.0, 1.0));
        assert!(near(&areas(&halves, "X"), &[width * 2.0; 2]), "{:?}", areas(&halves, "X"));
    }
    let pieces = leaves!(Facades { metres: true }, &Shape::cuboid(23.0, 4.0, 1.0));
    assert!(near(&areas(&pieces, "X"), &[20.0, 20.0, 20.0, 20.0, 12.0]), "{:?}", areas(&pieces, "X"));
    // Lengths in metres are exact on a flat rectangle.
    let borders: Vec<f64> =
        pieces.0.iter().map(|(_, faces)| faces[0].iter().map(|c| c.point.x).fold(0.0, f64::max)).collect();
    assert!(near(&borders, &[5.0, 10.0, 15.0, 20.0, 23.0]), "{borders:?}");
}

/// A street of so many metres that bends, 8 m wide, with u along from 0 to 1 and v across.
fn street(length: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let rows = 12;
    let at = |row: usize, side: f64| {
        let share = row as f64 / rows as f64;
        let (angle, radius) = (share * 1.5, length / 1.5);
        let (sin, cos) = libm::sincos(angle);
        DVec3::new((radius + side) * sin, 0.0, side * cos - radius * (1.0 - cos))
    };
    let points: Vec<[u32; 2]> =
        (0..=rows).map(|row| [4.0, -4.0].map(|side| builder.point(at(row, side).to_array()))).collect();
    for row in 0..rows {
        let ([a, d], [b, c]) = (points[row], points[row + 1]);
        let (low, high) = (row as f64 / rows as f64, (row + 1) as f64 / rows as f64);
        let uvs = [[low, 0.0], [high, 0.0], [high, 1.0], [low, 1.0]].map(DVec2::from_array);
        builder.polygon(&[a, b, c, d]).uvs(&uvs);
    }
    builder.build().expect("a street")
}

cga! {
    /// *split operation*, the street example.
    grammar Street;
    Street --> split(u, unitSpace, 0) { ~10 : Road. | ~3 : Band. | ~10 : Road. }*
}

#[test]
fn a_band_of_about_three_metres_in_every_period() {
    let shape = Shape::mesh(street(140.0));
    let leaves = leaves!(Street::default(), &shape);
    let bands = areas(&leaves, "Band");
    // 6 periods of 23.3 m: the surface bends, so metres are measured at its mean.
    assert_eq!(bands.len(), 6);
    assert!(bands.iter().all(|area| (area / 8.0 - 3.0).abs() < 0.2), "{bands:?}");
    let sum = areas(&leaves, "Road").into_iter().chain(bands).sum::<f64>();
    let whole: f64 = street(140.0).area();
    assert!((sum - whole).abs() < 1e-9 * whole);
}

cga! {
    /// Sizes of all kinds, groups, counters, and what follows.
    grammar Kinds;
    attr kind = 0
    Lot --> comp(f) { front : Facade }
    Facade --> setupProjection(1, scope.xy, 2, 1) projectUV(1) Split
    Split -->
        case kind == 0 : split(v, uvSpace, 1) { ^0.25 : A. | ~1 : B. | { ~2 : C. }* }
        case kind == 1 : split(u, uvSpace, 1) { 1 : A. | ~1 : Counted }
        case kind == 2 : split(u, unitSpace, 1) { 1 : A. }
        case kind == 3 : split(u, uvSpace, 1) { ~1 : split(y) { ~1 : A. | ~1 : B. } | ~1 : s(^2, ^1, ^1) C. }
        else : split(u, uvSpace, 7) { 1 : A. }
    Counted --> case split.index == 1 && split.total == 2 : B. else : NIL
}

#[test]
fn patterns_are_those_of_a_split() {
    let run = |kind: u32| leaves!(Kinds { kind: f64::from(kind) }, &Shape::cuboid(10.0, 8.0, 1.0));
    let all = run(0);
    assert!(near(&areas(&all, "A"), &[20.0]), "{all:?}");
    let all = run(1);
    assert!(near(&areas(&all, "A"), &[16.0]) && near(&areas(&all, "B"), &[64.0]), "{all:?}");
    let all = run(2);
    assert!(near(&areas(&all, "A"), &[8.0]) && all.0.len() == 1, "{all:?}");
    let all = run(3);
    assert!(near(&areas(&all, "A"), &[20.0]) && near(&areas(&all, "C"), &[80.0]), "{all:?}");
}

#[test]
fn a_missing_set_is_a_fault() {
    let report = Kinds { kind: 4.0 }.generate(&Shape::cuboid(10.0, 8.0, 1.0)).expect("no error");
    let faults = report.faults();
    assert_eq!(faults.len(), 1, "{faults:?}");
    assert!(faults[0].message.contains("no texture coordinates in set 7"), "{faults:?}");
}
