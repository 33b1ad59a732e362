//! Numbers that have no meaning, bases that look alike, and many looks.

use cga::glam::DVec2;
use cga::sink::buffers::Buffers;
use cga::{Limits, Model, Repeats, Settings, Shape, cga};

use crate::collect::leaves;

cga! {
    /// Numbers that are none, too large, or out of range.
    grammar Numbers;
    attr kind = 0
    attr x = 0
    Lot --> comp(f) { front : setupProjection(0, scope.xy, 1, 1) projectUV(0) Facade }
    Facade -->
        case kind == 0 : setupProjection(0, scope.xy, x, 1) projectUV(0) X.
        case kind == 1 : setupProjection(0, world.zy, ~x, ^x, x, x, x) projectUV(0) X.
        case kind == 2 : setupProjection(x, scope.xy, 1, 1) projectUV(x) deleteUV(x) X.
        case kind == 3 : translateUV(0, x, x) scaleUV(0, x, 1) rotateUV(0, x) X.
        case kind == 4 : scaleUV(0, x, x) scaleUV(0, x, x) translateUV(0, 1, 1) X.
        case kind == 5 : copyUV(x, 1) copyUV(0, x) scaleUV(x, 2, 2) X.
        case kind == 6 : tileUV(0, x, ~x) tileUV(0, ^x, ~1) X.
        case kind == 7 : normalizeUV(x, uv, collectiveAllFaces) scaleUV(0, x, x) normalizeUV(0, uv, separatePerFace) X.
        case kind == 8 : scaleUV(0, x, 1) split(u, uvSpace, 0) { ~1 : X. | ~1 : Y. }
        case kind == 9 : scaleUV(0, x, 1) split(v, unitSpace, 0) { ~x : X. | x : Y. }
        case kind == 10 : scaleUV(0, x, x) scaleUV(0, x, x) split(v, uvSpace, 0) { ~1 : X. | ~1 : Y. }
        case kind == 11 : split(u, uvSpace, x) { 1 : X. }
        case kind == 12 : s(x, ^1, ^1) t(x, 0, 0) X.
        case kind == 13 : scaleUV(0, x, x) s(x, ^1, ^1) extrude(x) X.
        case kind == 14 : s(x, x, x) setupProjection(0, scope.xz, ^1, ~3) projectUV(0) X.
        case kind == 15 : scaleUV(0, x, 1) print(geometry.du(0, unitSpace)) print(geometry.uMin(x)) tileUV(0, 1, 1) X.
        else : scaleUV(0, x, 1) comp(fe) { all : projectUV(0) s(^1, x, 1) primitiveQuad() scaleUV(0, x, x) X. }
}

#[test]
fn numbers_without_meaning_leave_faults_and_finite_coordinates() {
    let numbers =
        [0.0, -0.0, -1.0, 0.5, 10.0, 3e9, 1e-310, 1e160, -1e200, 1e308, f64::NAN, f64::INFINITY, -f64::INFINITY];
    let mut wrong = Vec::new();
    for kind in 0..=16 {
        for x in numbers {
            for place in [0.0, 1e6] {
                let grammar = Numbers { kind: f64::from(kind), x };
                for shape in [Shape::cuboid(10.0, 8.0, 3.0), Shape::cuboid(10.0, 8.0, 3.0).held_as_meshes()] {
                    let mut model = Model::new();
                    let report = grammar.run(&shape.at([place; 3]), &Settings::default(), &mut model);
                    let faults = report.map_or(usize::MAX, |report| report.faults().len());
                    for leaf in model.leaves() {
                        let (mesh, _) = leaf.mesh();
                        for set in 0..10 {
                            if !mesh.uv_set(set).iter().all(|uv| uv.is_finite()) {
                                wrong.push((kind, x, place, set, faults));
                            }
                        }
                    }
                }
            }
        }
    }
    wrong.dedup();
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn a_length_without_meaning_leaves_one_fault() {
    cga! {
        grammar Moved;
        attr x = 0
        Lot --> comp(f) { front : setupProjection(0, scope.xy, 1, 1) projectUV(0) Wall }
        Wall --> t(x, 1, 0) X.
    }
    for shape in [Shape::cuboid(10.0, 8.0, 3.0), Shape::cuboid(10.0, 8.0, 3.0).held_as_meshes()] {
        let model = Moved { x: f64::NAN }.generate(&shape).expect("no limit");
        let faults: Vec<&str> = model.faults().iter().map(|fault| fault.message.as_str()).collect();
        assert_eq!(faults, ["`t` along x is NaN; 0 is used instead"]);
    }
}

cga! {
    /// Parts of equal size below bases that differ.
    grammar Bases;
    Lot -->
        [ primitiveCube() t(0, 0, 0) color(rand(0.1, 0.9), 0.5, 0.5) Row ]
        [ setupProjection(0, scope.xy, 2, 2) projectUV(0) color(rand(0.1, 0.9), 0.5, 0.5) Row ]
        [ primitiveCube() color(rand(0.1, 0.9), 0.5, 0.5) Row ]
        [ setupProjection(0, scope.zy, 2, 2) projectUV(0) t(1, 0, 0) Row ]
        [ deleteUV(0) color(rand(0.1, 0.9), 0.5, 0.5) Row ]
        comp(f) { side : Side }
    Side -->
        case comp.index % 2 == 0 : setupProjection(0, scope.xy, 1, 1) projectUV(0) Row
        else : projectUV(0) Row
    Row --> split(x) { { ~1 : Tile }* }
    Tile --> split(y) { ~1 : X. | ~1 : color("#ff0000") projectUV(0) Y. | ~1 : color(rand(0.1, 0.9), 0.3, 0.2) Z. }
}

#[test]
fn templates_do_not_mix_bases() {
    leaves!(&Bases::default(), &Shape::cuboid(4.0, 4.0, 4.0));
    leaves!(&Bases::default(), &Shape::cuboid(4.0, 3.0, 4.0).at([5.0, 1e3, -7.0]).seed(9));
}

cga! {
    /// Box and cube of one size at one place in the rules, both without a number.
    grammar Cubes;
    attr first = true
    Lot -->
        case first : [ Plain ] Cube
        else : [ Cube ] Plain
    Plain --> primitiveCube() setupProjection(0, scope.xy, 2, 2) projectUV(0) t(1, 0, 0) Row
    Cube --> primitiveCube() Row
    Row --> split(x) { { ~1 : Tile }* }
    Tile --> split(y) { { ~1 : X. }* }
}

#[test]
fn a_cube_after_a_box_keeps_its_sides() {
    for first in [true, false] {
        leaves!(&Cubes { first }, &Shape::cuboid(4.0, 4.0, 4.0));
    }
}

cga! {
    /// Nearly two to the 17th looks below one base.
    grammar Looks;
    A --> setupProjection(0, scope.xy, 1, 1) projectUV(0) split(x) { ~1 : B }
    B --> [ translateUV(0, 1, 0) C ] [ translateUV(0, 2, 0) C ]
    C --> X. [ translateUV(0, 3, 0) D ] [ translateUV(0, 6, 0) D ]
    D --> X. [ translateUV(0, 9, 0) E ] [ translateUV(0, 18, 0) E ]
    E --> X. [ translateUV(0, 27, 0) F ] [ translateUV(0, 54, 0) F ]
    F --> X. [ translateUV(0, 81, 0) G ] [ translateUV(0, 162, 0) G ]
    G --> X. [ translateUV(0, 243, 0) H ] [ translateUV(0, 486, 0) H ]
    H --> X. [ translateUV(0, 729, 0) I ] [ translateUV(0, 1458, 0) I ]
    I --> X. [ translateUV(0, 0, 1) J ] [ translateUV(0, 0, 2) J ]
    J --> X. [ translateUV(0, 0, 3) K ] [ translateUV(0, 0, 6) K ]
    K --> X. [ translateUV(0, 0, 9) L ] [ translateUV(0, 0, 18) L ]
    L --> X. [ translateUV(0, 0, 27) M ] [ translateUV(0, 0, 54) M ]
    M --> X. [ translateUV(0, 0, 81) N ] [ translateUV(0, 0, 162) N ]
    N --> X. [ translateUV(0, 0, 243) O ] [ translateUV(0, 0, 486) O ]
    O --> X. [ copyUV(0, 1) P ] [ copyUV(0, 2) P ]
    P --> X. [ copyUV(0, 3) Q ] [ copyUV(0, 4) Q ]
    Q --> X. [ copyUV(0, 5) X. ] [ copyUV(0, 6) X. ]
}

#[test]
fn more_looks_than_there_are_numbers() {
    let mut buffers = Buffers::new();
    Looks::default().run(&Shape::rectangle(2.0, 2.0), &Settings::default(), &mut buffers).expect("no error");
    assert_eq!(buffers.vertices().len(), 4 * ((1 << 17) - 2));
}

cga! {
    /// A face of a cube grows.
    grammar Grown;
    attr kind = 0
    Lot --> primitiveCube() comp(f) { all : Face }
    Face -->
        case kind == 0 : extrude(0.5) X.
        case kind == 1 : extrude(face.normal, 0.5) X.
        else : X.
}

#[test]
fn a_face_of_a_cube_that_grows_keeps_its_coordinates_on_top() {
    let run = |kind: u32| leaves!(Grown { kind: f64::from(kind) }, &Shape::cuboid(4.0, 2.0, 6.0));
    let (grown, flat) = (run(0), run(2));
    for ((_, faces), (_, flat)) in grown.0.iter().zip(&flat.0) {
        let unit = |face: &[crate::collect::Corner]| {
            let mut uvs: Vec<DVec2> = face.iter().map(|corner| corner.uvs[0].expect("coordinates").round()).collect();
            uvs.sort_by(|a, b| a.to_array().partial_cmp(&b.to_array()).unwrap());
            uvs
        };
        assert_eq!(unit(&flat[0]), [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE]);
        // Bottom and top have the coordinates of the face.
        for face in [&faces[0], &faces[1]] {
            for corner in face {
                let same = flat[0].iter().min_by(|a, b| {
                    let far = |c: &crate::collect::Corner| (c.point - corner.point).length();
                    far(a).total_cmp(&far(b))
                });
                assert_eq!(corner.uvs[0].unwrap().round(), same.unwrap().uvs[0].unwrap().round());
            }
        }
    }
}

cga! {
    /// *setupProjection operation* again, below brackets, without one, after deletion.
    @Allow(missing_asset)
    grammar Again;
    attr kind = 0
    Lot --> comp(f) { front : Facade }
    Facade -->
        case kind == 0 : projectUV(0) X.
        case kind == 1 : projectUV(0) setupProjection(0, scope.xy, 1, 1) X.
        case kind == 2 : [ setupProjection(0, scope.xy, 1, 1) projectUV(0) NIL ] projectUV(0) X.
        case kind == 3 : setupProjection(0, scope.xy, 1, 1) projectUV(0) deleteUV(0) texture("builtin:uvtest.png") X.
        case kind == 4 : setupProjection(0, scope.xy, 1, 1) deleteUV(0) projectUV(0) setupProjection(0, scope.xy, 9, 9) X.
        case kind == 5 : setupProjection(0, scope.xy, 1, 1) projectUV(0) copyUV(0, 1) setupProjection(0, scope.xy, 9, 9) X.
        else : setupProjection(0, scope.xy, 1, 1) split(x) { ~1 : [ setupProjection(0, scope.xy, 5, 5) NIL ] projectUV(0) X. }
}

#[test]
fn a_projection_that_is_set_up_later_changes_nothing_before() {
    let shape = Shape::cuboid(10.0, 8.0, 3.0).at([1.0, 2.0, 3.0]);
    for kind in 0..=6 {
        let leaves = leaves!(Again { kind: f64::from(kind) }, &shape);
        match kind {
            0..4 => assert!(leaves.corners("X").iter().all(|corner| corner.uvs == [None; 10])),
            _ => {
                let [low, high] = leaves.range("X", 0);
                assert!(
                    low.abs_diff_eq(DVec2::ZERO, 1e-12) && high.abs_diff_eq(DVec2::new(10.0, 8.0), 1e-12),
                    "{kind}"
                );
            }
        }
    }
}

#[test]
fn limits_and_ways_of_repeating_agree_about_the_looks() {
    let run = |repeats| {
        let limits = Limits { shapes: 2000, ..Limits::default() };
        let mut buffers = Buffers::new();
        let settings = Settings { repeats, limits, ..Settings::default() };
        let result = Looks::default().run(&Shape::rectangle(2.0, 2.0), &settings, &mut buffers);
        (result.is_err(), buffers.uv_set(0).to_vec())
    };
    assert_eq!(run(Repeats::Kept), run(Repeats::Direct));
}

cga! {
    /// A cube with coordinates of its own is cut: its caps.
    grammar Caps;
    Lot --> primitiveCube() split(y) { ^0.4117 : reverseNormals() reverseNormals() split(x) { ^0.4117 : X. | ~1 : NIL } }
}

#[test]
fn coordinates_of_caps_are_zero() {
    let leaves = leaves!(&Caps::default(), &Shape::cuboid(10.0, 8.0, 3.0));
    let cap: Vec<DVec2> =
        leaves.corners("X").into_iter().rev().take(4).map(|corner| corner.uvs[0].expect("coordinates")).collect();
    assert_eq!(cap, [DVec2::ZERO; 4]);
}

cga! {
    /// A projection onto a plane in which the face is a line.
    grammar EdgeOn;
    attr kind = 0
    Lot --> r(0, 35, 0) comp(f) { front : setupProjection(0, scope.zy, 0.5, 1) projectUV(0) Facade }
    Facade -->
        report("du", geometry.du(0, uvSpace))
        report("metres", geometry.du(0, unitSpace))
        Next
    Next -->
        case kind == 0 : normalizeUV(0, uv, separatePerFace) X.
        case kind == 1 : split(u, unitSpace, 0) { ~1 : X. | ~1 : X. }
        case kind == 2 : split(u, uvSpace, 0) { ^0.5 : X. }*
        case kind == 3 : split(v, unitSpace, 0) { { ~1 : X. }* }
        case kind == 4 : tileUV(0, ~1, ^0.5) X.
        else : extrude(1) normalizeUV(0, uvUniform, collectiveAllFaces) X.
}

#[test]
fn a_coordinate_that_is_constant_but_for_rounding_is_constant() {
    for place in [0.0, 717.3, 1e6] {
        for kind in 0..=5 {
            let grammar = EdgeOn { kind: f64::from(kind) };
            let shape = Shape::cuboid(7.0, 3.0, 2.0).at([place; 3]);
            let model = grammar.generate(&shape).expect("no error");
            let number = |key: &str| model.reported(key).expect(key).summary().sum;
            assert_eq!([number("du"), number("metres")], [0.0; 2], "{place} {kind}");
            assert_eq!(model.len(), [1, 1, 1, 3, 1, 1][kind as usize], "{place} {kind}");
            let fitted =
                model.leaves().filter(|_| kind == 0).all(|leaf| leaf.mesh().0.uvs().iter().all(|uv| uv.x.abs() < 1e-9));
            assert!(fitted);
        }
    }
}

cga! {
    /// A block whose depth is rounding.
    grammar Thin;
    Lot --> s(^1, ^1, 1e-14) setupProjection(0, scope.xz, ^1, ^0.5) setupProjection(1, scope.zy, ~2, 1) projectUV(0) projectUV(1) X.
}

#[test]
fn shares_of_a_size_that_is_rounding_are_none() {
    let leaves = leaves!(&Thin::default(), &Shape::cuboid(7.0, 3.0, 2.0));
    assert_eq!(leaves.range("X", 0), [DVec2::ZERO, DVec2::X]);
    assert_eq!(leaves.range("X", 1), [DVec2::ZERO, DVec2::new(0.0, 3.0)]);
}
