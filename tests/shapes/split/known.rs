//! Splits that the macro has solved give what the run would have computed, bit for bit: the same rules once with constants,
//! which are known, and once with attributes, which are not.

use cga::{Model, Shape};

/// Everything that can be told of the leaves.
fn all(model: &Model) -> Vec<String> {
    let faults = model.faults().iter().map(|fault| fault.to_string());
    let leaf = |leaf: cga::LeafView<'_>| {
        let scope = leaf.scope();
        let bits: Vec<u64> =
            scope.origin.to_array().iter().chain(&scope.size.to_array()).map(|number| number.to_bits()).collect();
        format!("{} {bits:x?} {:?} {}", leaf.rule(), scope.size, leaf.volume())
    };
    model.leaves().map(leaf).chain(faults).collect()
}

macro_rules! twins {
    ($($name:ident { $($rules:tt)* })*) => {
        $(
            #[test]
            fn $name() {
                mod known {
                    cga::cga! {
                        pub(super) grammar Twin;
                        const five = 5 const three = 3 const minus = -2 const none = 0 const tenth = 0.1
                        $($rules)*
                    }
                }
                mod unknown {
                    cga::cga! {
                        pub(super) grammar Twin;
                        attr five = 5 attr three = 3 attr minus = -2 attr none = 0 attr tenth = 0.1
                        $($rules)*
                    }
                }
                let shapes = [
                    Shape::rectangle(7.0, 4.0),
                    Shape::cuboid(7.0, 4.0, 2.0),
                    Shape::line([0.0; 3], [3.0, 1.0, 0.0]).unwrap(),
                    Shape::footprint(&[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.0, 1.0]], &[]).unwrap(),
                    Shape::footprint(&[[0., 0.], [0., 6.], [3., 6.], [3., 3.], [6., 3.], [6., 0.]], &[]).unwrap(),
                ];
                let mut seen = 0;
                for shape in &shapes {
                    let known = all(&known::Twin::default().generate(shape).unwrap());
                    let unknown = all(&unknown::Twin::default().generate(shape).unwrap());
                    assert_eq!(known, unknown);
                    seen += known.len();
                }
                assert!(0 < seen);
            }
        )*
    };
}

twins! {
    boxes_of_known_size {
        Lot --> s(five, three, 1) primitiveCube() split(x) { ~1 : A. | { three : B. }* | tenth : split(y) { ^0.3 : C. | { ~tenth : D. }* } }
    }
    pieces_of_pieces {
        Lot --> s(five, five, five) primitiveCube() Cell(2)
        Cell(n) --> case n == 0 : Cell. else : split(x) { ~1 : split(y) { ~1 : split(z) { ~1 : Cell(n - 1) | ~2 : B. } | ~2 : B. } | ~2 : B. }
    }
    cylinders_whose_parts_shrink {
        Lot --> s(five, three, five) primitiveCylinder() split(x) { { 1 : split(z) { { ~1 : A. }* } }* } split(x, noAdjust) { ~1 : split(z) { three : B. | ~1 : C. } | tenth : split(x) { ~1 : D. } }
    }
    sizes_below_zero {
        Lot --> s(minus, three, minus) primitiveCube() split(x) { tenth : A. | ~1 : split(z) { ~1 : B. | ~2 : C. } } split(z) { ~1 : D. }
        s(^minus, ^minus, ^minus) split(y) { { 1 : E. }* }
    }
    flat_and_thick_again {
        Lot --> s(five, none, three) primitiveCube() split(y) { 1 : A. } split(x) { 1 : B. | ~1 : split(z) { ~1 : C. } } s(^1, five, ^1) split(y) { 2 : D. | ~1 : E. }
        [ s(five, five, five) primitiveCube() s(^1, none, ^1) s(^1, three, ^1) split(y) { ~1 : split(x) { ~1 : split(y) { 1 : F. | ~1 : G. } } | ~1 : H. } ]
    }
    brackets_and_branches {
        Lot --> s(five, three, 1) [ s(three, five, 1) t(1, 0, 0) split(x) { ~2 : A. | 1 : B. } ] split(x) { ~2 : C. | 1 : D. }
        [ case 1 < scope.sx : s(tenth, 1, 1) else : s(five, 1, 1) ] split(x) { tenth : E. }
        [ 30% : s(1, 2, 3) split(y) { tenth : F. }* else : s(3, 2, 1) split(y) { ~tenth : G. }* ]
    }
    operations_that_may_do_anything {
        Lot --> s(five, three, 1) primitiveCube() extrude(1) split(x) { 1 : A. }* s(five, three, 1) primitiveCube(1, 2, 3) split(x) { tenth : B. }*
        primitiveQuad() split(x) { ~1 : C. | ~2 : D. } comp(f) { all : split(x) { ~1 : E. | 2 : F. } }
        s(five, five, five) i("nowhere.obj") split(x) { ~1 : G. | ~1 : H. } center(xyz) split(z) { ~1 : I. }
    }
    operations_that_leave_the_scope_alone {
        Lot --> s(five, three, 1) primitiveCube() reverseNormals() split(x) { tenth : A. | ~1 : split(x) { ~tenth : B. | ~1 : split(z) { tenth : C. } } }
        mirror(true, false, true) split(y) { tenth : D. | ~1 : E. } trim() split(z) { tenth : F. | ~1 : split(y) { three : G. } }
        i("nowhere.obj") split(x, noAdjust) { three : split(x) { 1 : H. | ~1 : I. } | ~1 : J. }
    }
    rules_called_from_many_places {
        Lot --> s(five, three, 1) primitiveCube() Part(1) s(three, three, 1) Part(2) t(1, 1, 1) r(0, 30, 0) color("#ff0000") Part(3) Only(1) Only(2)
        Part(n) --> split(x) { ~1 : A. | n : Inner(n) } split(y) { ~1 : B. | 1 : C. }
        Inner(n) --> split(x) { ~1 : D. | ~1 : Inner(n) } split(y) { { ~tenth : E. }* }
        Only(n) --> split(x) { { 1 : F. }* } split(z) { n : G. | ~1 : H. }
    }
    sizes_that_are_none {
        Lot --> s(five, three, 1) primitiveCube() split(x) { none : A. | minus : B. | 1 / none : C. | ~1 : D. | ~(none / none) : E. | ^minus : F. }
        s(1 / none, 1, 1) split(x) { 1 : G. } split(y) { ~1 : H. } s(five, 1, 1) split(x) { 1 : I. }*
    }
    sizes_beyond_what_a_scope_may_have {
        Lot --> s(10, 20, 10) primitiveCube() s(five * 1e300, 5, ^1) split(y) { 5 : A. | ~6 : B. }
        s(1e300, 7, ^1e200) split(y) { 2 : C. | ~1 : split(x) { three : D. | ~1 : E. } } s(1e140, 1, 1) split(x) { ^0.5 : F. | ~1 : G. }
    }
    things_the_macro_leaves_to_the_run {
        Lot --> s(five, three, 1) primitiveCube() split(x) { ~0.01 : A. }* splitArea(x) { 1 : B. | ~1 : C. } split(x) { rand(1) : D. | ~1 : split(y) { ~1 : E. } }
    }
    boxes_that_are_cut_at_trim_planes {
        Lot --> extrude(4) comp(f) { side : Wall | all : X. }
        Wall --> s(three, 4, three) primitiveCube() split(x) { 1.5 : split(z) { 1 : A. | ~1 : B. } | ~1 : split(z) { ~1 : C. | 1 : D. } }
    }
    too_small_for_the_run {
        Lot --> s(0.0000001, three, 1) primitiveCube() split(x) { ~1 : A. | ~1 : B. }
    }
}
