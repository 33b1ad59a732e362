//! *insertAlongUV operation*.

use std::sync::Arc;

use cga::{Assets, Model, Settings, Shape, cga};
use cga_runtime::geometry::primitive;

use crate::collect::Leaves;

cga! {
    /// Copies of a block along a wall.
    @Allow(missing_asset)
    grammar Rail;
    attr kind = 0
    Lot --> comp(f) { front : Wall }
    Wall -->
        setupProjection(0, scope.xy, 2, ^1) projectUV(0)
        Insert
    Insert -->
        case kind == 0 : insertAlongUV(0, "block", 0.5, vertex.normal, alignPosition) X.
        case kind == 1 : alignScopeToAxes(y) insertAlongUV(0, "builtin:cube", 0.5, vertex.normal, keepPosition) X.
        case kind == 2 : insertAlongUV(0, "missing", 0.5) X.
        else : insertAlongUV(3, "block", 0.5) X.
}

fn run(kind: u32) -> (Leaves, Vec<String>) {
    let assets = Arc::new(Assets::new().with("block", primitive::cube()));
    let settings = Settings { assets, ..Settings::default() };
    let (grammar, mut leaves) = (Rail { kind: f64::from(kind) }, Leaves::default());
    let report = grammar.run(&Shape::cuboid(10.0, 3.0, 1.0), &settings, &mut leaves).expect("no error");
    (leaves, report.faults().iter().map(|fault| fault.message.clone()).collect())
}

#[test]
fn an_asset_is_repeated_along_u_and_stands_on_the_surface() {
    for kind in [0, 1] {
        let (leaves, faults) = run(kind);
        assert!(faults.is_empty(), "{faults:?}");
        let corners = leaves.corners("X");
        let range = |axis: usize| {
            let values = corners.iter().map(|corner| corner.point[axis]);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
        };
        for (axis, expected) in [[0.0, 10.0], [0.0, 3.0], [1.0, 1.5]].into_iter().enumerate() {
            let found = range(axis);
            assert!((found[0] - expected[0]).abs() < 1e-9 && (found[1] - expected[1]).abs() < 1e-9, "{axis} {found:?}");
        }
        // Five copies of two metres meet at every other metre.
        let borders = [0.0, 2.0, 4.0, 6.0, 8.0, 10.0];
        assert!(corners.iter().all(|corner| borders.iter().any(|x| (corner.point.x - x).abs() < 1e-9)), "{kind}");
    }
}

#[test]
fn what_cannot_be_inserted_leaves_a_fault_and_the_shape() {
    for (kind, words) in [(2, "`missing` cannot be inserted"), (3, "no texture coordinates in set 3")] {
        let (leaves, faults) = run(kind);
        assert!(faults.len() == 1 && faults[0].contains(words), "{faults:?}");
        assert_eq!(leaves.corners("X").len(), 4);
    }
}

cga! {
    /// Ranges that end at whole numbers except for rounding, made in all ways.
    grammar Whole;
    attr kind = 0
    Lot --> comp(f) { front : Wall | all : NIL }
    Wall -->
        case kind == 0 : setupProjection(0, scope.xy, ~2, ^1) projectUV(0) Insert
        case kind == 1 : setupProjection(0, world.xy, 1, 1) projectUV(0) normalizeUV(0, uv, collectiveAllFaces) Insert
        case kind == 2 : setupProjection(0, scope.xy, 1, 1) projectUV(0) normalizeUV(0, uv, separatePerFace) tileUV(0, ~0.7, ~1.1) Insert
        else : setupProjection(0, scope.xy, ^1, ^1) projectUV(0) scaleUV(0, 7, 3) translateUV(0, 0.3, 0.1) translateUV(0, -0.3, -0.1) Insert
    Insert -->
        report("copies", rint(geometry.du(0, uvSpace)) * rint(geometry.dv(0, uvSpace)))
        insertAlongUV(0, "block", 0.5, vertex.normal, alignPosition)
        report("faces", geometry.nFaces)
        X.
}

#[test]
fn copies_of_a_closed_asset_are_whole_and_closed_for_every_way_to_make_the_range() {
    let assets = Arc::new(Assets::new().with("block", primitive::cube()));
    let settings = Settings { assets, ..Settings::default() };
    let mut runs = 0;
    for (kind, number) in (0..4).flat_map(|kind| (0..50).map(move |number| (kind, number))) {
        let (number, grammar) = (f64::from(number), Whole { kind: f64::from(kind) });
        let wall = Shape::cuboid(1.1 + 0.37 * number, 2.0 + 0.13 * number, 1.0);
        // A tenth of a millimetre high, its coordinates have the rounding errors of its place.
        let strip = Shape::cuboid(1.1 + 0.37 * number, 1e-4 + 1e-5 * number, 1.0);
        let place = [1234.567 * number, 12_345.1, -98_765.4];
        for shape in [wall.clone(), wall.at(place), strip.clone(), strip.at(place)] {
            let mut model = Model::new();
            let report = grammar.run(&shape, &settings, &mut model).expect("no error");
            let sum = |key: &str| report.reported(key).expect("a report").summary().sum;
            assert_eq!(sum("faces"), 6.0 * sum("copies"), "kind {kind}, number {number}");
            assert!(model.leaves().all(|leaf| leaf.mesh().0.is_closed()), "kind {kind}, number {number}");
            runs += 1;
        }
    }
    assert_eq!(runs, 800);
}
