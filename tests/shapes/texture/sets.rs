//! *translateUV*, *scaleUV*, *rotateUV*, *copyUV*, *deleteUV*, and their old spellings.

use cga::glam::DVec2;
use cga::{Shape, cga};

use crate::collect::leaves;

cga! {
    /// Operations on whole sets.
    grammar Sets;
    attr kind = 0
    Lot --> comp(f) { front : Facade }
    Facade --> setupProjection(0, scope.xy, 1, 1) projectUV(0) split(x) { { ~2 : Part }* }
    Part -->
        case kind == 0 : translateUV(0, 0, 0.5) X.
        case kind == 1 : scaleUV(0, 2, -3) X.
        case kind == 2 : rotateUV(0, 90) X.
        case kind == 3 : rotateUV(0, 90) translateUV(0, 1, 2) scaleUV(0, 2, 2) copyUV(0, 4) deleteUV(0) X.
        else : copyUV(0, 1) scaleUV(1, 10, 10) deleteUV(7) X.
}

/// The kind of the rule, the set, and the coordinates at a place.
type Expected = (u32, usize, fn(f64, f64) -> [f64; 2]);

#[test]
fn whole_sets_are_changed() {
    let expected: [Expected; 6] = [
        (0, 0, |x, y| [x, y + 0.5]),
        (1, 0, |x, y| [2.0 * x, -3.0 * y]),
        (2, 0, |x, y| [-y, x]),
        (3, 4, |x, y| [2.0 * (1.0 - y), 2.0 * (2.0 + x)]),
        (4, 0, |x, y| [x, y]),
        (4, 1, |x, y| [10.0 * x, 10.0 * y]),
    ];
    for (kind, set, uv) in expected {
        let leaves = leaves!(&Sets { kind: f64::from(kind) }, &Shape::cuboid(8.0, 3.0, 3.0));
        for corner in leaves.corners("X") {
            let expected = DVec2::from_array(uv(corner.point.x, corner.point.y));
            assert!(corner.uvs[set].unwrap().abs_diff_eq(expected, 1e-12), "{kind}: {corner:?}");
            assert_eq!(corner.uvs[0].is_none(), kind == 3);
        }
    }
}

cga! {
    /// *normalizeUV*, *tileUV* and what functions say of coordinates.
    grammar Fitted;
    attr kind = 0
    Lot --> comp(f) { front : Facade }
    Facade --> setupProjection(0, scope.xy, 1, 1, 3, 2) projectUV(0) Fit
    Fit -->
        case kind == 0 : normalizeUV(0, uv, collectiveAllFaces) X.
        case kind == 1 : normalizeUV(0, uvUniform, separatePerFace) X.
        case kind == 2 : normalizeUV(0, u, collectiveAllFaces) X.
        case kind == 3 : normalizeUV(0, v, collectiveAllFaces) X.
        case kind == 4 : normalizeUV(0, uv, collectiveAllFaces) tileUV(0, 2, -4) X.
        case kind == 5 : normalizeUV(0, uv, collectiveAllFaces) tileUV(0, ~3, ^0.5) X.
        case kind == 6 : tileUV(0, 0, 8) X.
        case kind == 7 : tileUV(0, ~0, 8) X.
        case kind == 8 : tileUV(0, 5, ^0) X.
        else : scaleUV(0, 0, 1) normalizeUV(0, uv, collectiveAllFaces) tileUV(0, 1, 1) X.
}

#[test]
fn coordinates_are_fitted_and_tiled() {
    let expected = [
        ([0.0, 0.0], [1.0, 1.0]),
        ([0.0, 0.0], [1.0, 0.8]),
        ([0.0, -2.0], [1.0, 6.0]),
        ([3.0, 0.0], [13.0, 1.0]),
        ([0.0, -2.0], [5.0, 0.0]),
        ([0.0, 0.0], [3.0, 2.0]),
        ([3.0, -0.25], [13.0, 0.75]),
        ([3.0, -0.25], [13.0, 0.75]),
        ([0.6, -2.0], [2.6, 6.0]),
        ([0.0, 0.0], [0.0, 8.0]),
    ];
    for (kind, (low, high)) in expected.into_iter().enumerate() {
        let shape = Shape::cuboid(10.0, 8.0, 3.0);
        let range = leaves!(Fitted { kind: kind as f64 }, &shape).range("X", 0);
        let near = |a: DVec2, b: [f64; 2]| a.abs_diff_eq(DVec2::from_array(b), 1e-12);
        assert!(near(range[0], low) && near(range[1], high), "{kind}: {range:?}");
    }
}

cga! {
    /// *geometry.du, dv*, *geometry.uMin* and its like, *geometry.hasUVs*.
    grammar Asked;
    Lot --> comp(f) { front : Facade }
    Facade -->
        report("before", str(geometry.hasUVs()))
        setupProjection(2, scope.xy, 2, 4, 1, 0)
        projectUV(2)
        report("hasUVs", str(geometry.hasUVs() && geometry.hasUVs(2) && !geometry.hasUVs(0)))
        report("du", geometry.du(2, uvSpace)) report("dv", geometry.dv(2, unitSpace))
        report("uMin", geometry.uMin(2)) report("uMax", geometry.uMax(2))
        report("vMin", geometry.vMin(2)) report("vMax", geometry.vMax(2))
        report("none", geometry.uMax + geometry.du(0, unitSpace))
        X.
}

#[test]
fn functions_say_what_coordinates_there_are() {
    let model = Asked::default().generate(&Shape::cuboid(10.0, 8.0, 3.0)).expect("no error");
    let number = |key: &str| model.reported(key).expect(key).summary().sum;
    let all = ["du", "dv", "uMin", "uMax", "vMin", "vMax", "none"].map(number);
    assert_eq!(all, [5.0, 8.0, 0.5, 5.5, 0.0, 2.0, 0.0]);
    let told = |key: &str| model.reported(key).expect(key).texts().map(|(text, _)| text.to_owned()).collect::<Vec<_>>();
    assert_eq!([told("before"), told("hasUVs")], [["false"], ["true"]]);
}

cga! {
    /// *primitiveCube*, *primitiveQuad* and *primitiveDisk* with the coordinates that they bring along.
    grammar Primitives;
    attr kind = 0
    Lot -->
        case kind == 0 : primitiveCube() X.
        case kind == 1 : primitiveCube() split(x) { ~1 : NIL | ~1 : X. }
        case kind == 2 : primitiveCube() comp(f) { front : X. }
        case kind == 3 : primitiveCube() setupProjection(0, scope.xy, 1, 1) projectUV(0) X.
        case kind == 4 : s(^1, 0, ^1) primitiveQuad() X.
        case kind == 5 : i("builtin:cube:notex") X.
        else : primitiveCube() t(1, 2, 3) r(0, 90, 0) s(1, 1, 1) X.
}

#[test]
fn primitives_bring_coordinates_along() {
    let shape = Shape::cuboid(4.0, 2.0, 6.0);
    let run = |kind: u32| leaves!(Primitives { kind: f64::from(kind) }, &shape);
    for kind in [0, 6] {
        let cube = run(kind);
        let faces = &cube.0[0].1;
        assert_eq!(faces.len(), 6);
        for face in faces {
            let mut uvs: Vec<DVec2> = face.iter().map(|corner| corner.uvs[0].unwrap().round()).collect();
            uvs.sort_by(|a, b| a.to_array().partial_cmp(&b.to_array()).unwrap());
            assert_eq!(uvs, [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE], "{kind}");
        }
    }
    let front = run(2).corners("X");
    let right = run(1).corners("X");
    assert!(right.iter().filter(|corner| corner.point.z == 6.0).all(|corner| 0.0 <= corner.uvs[0].unwrap().x));
    for corner in &front {
        assert!(corner.uvs[0].unwrap().abs_diff_eq(DVec2::new(corner.point.x / 4.0, corner.point.y / 2.0), 1e-12));
    }
    for corner in run(3).corners("X") {
        assert!(corner.uvs[0].unwrap().abs_diff_eq(DVec2::new(corner.point.x, corner.point.y), 1e-12));
    }
    for corner in run(4).corners("X") {
        let expected = DVec2::new(corner.point.x / 4.0, 1.0 - corner.point.z / 6.0);
        assert!(corner.uvs[0].unwrap().abs_diff_eq(expected, 1e-12), "{corner:?}");
    }
    assert!(run(5).corners("X").iter().all(|corner| corner.uvs[0].is_none()));
}
