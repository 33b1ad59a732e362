//! Every lint that says something about style or leftovers is an error.
#![deny(warnings, missing_docs, unused, nonstandard_style, rust_2018_idioms, let_underscore)]
#![deny(
    missing_debug_implementations,
    single_use_lifetimes,
    trivial_casts,
    trivial_numeric_casts,
    unit_bindings,
    unnameable_types,
    unreachable_pub,
    unused_import_braces,
    unused_lifetimes,
    unused_qualifications,
    unused_results,
    variant_size_differences
)]
#![deny(clippy::all, clippy::pedantic, clippy::nursery, clippy::cargo)]

use cga::{Shape, cga};

cga! {
    /// Has some of everything.
    @Allow(rule_not_reached)
    pub(crate) grammar Strict;
    /// How high.
    @Range(min = 1, max = 100000000)
    attr height = 12345678.9
    attr about = "text"
    attr computed = rand(1, height)
    attr flag = true
    const ratio = 0.1 * height
    const drawn = rand(1)
    @Allow(unused_constant)
    const sides = comp(fe, noAlign) { front || flag : scope.sx | 3 = ratio | border =: comp.index }
    unused(n) = n
    attr first = case ratio > 1 : 2 else : second * 2
    attr second = case ratio > 1 : first + 1 else : 3
    const title = case ratio > 1 : caption else : "t" + first
    const caption = case ratio > 1 : "c" + second else : title
    fac(n) = case n < 2 : 1 else : n * fac(n - 1)
    half(n) = 50% : n else : n / 2 + scope.sx

    @StartRule
    Lot --> extrude(min(height, 5)) split(y) { ~1 : A(1, flag) | { ~0.5 : B | fac(3) : NIL }* | half(drawn) : C. }
    A(n, _unused) --> case n > 3 : [ center(xz) [ NIL ] A(n - 1, false) ] case n > 2 : Z. NIL else : B C
    B --> set(about, about + computed + caption) set(material.opacity, ratio) comp(f) { top : X. | side = Y | 3 : Y }
    C --> 30% : C. 20% : B else : NIL
    Y --> crate::hygiene::operate(1, "x", true) Faces(2, about)
    Faces(N, query) --> comp(f) { crate::hygiene::function(N, query) && top : Z | scope.sx > N : Z | all =: Z }
    Z --> case crate::hygiene::function(scope.sy, about) : Y else : X.
    @Allow(rule_not_reached)
    Unused(_n) --> X.
    @Allow(rule_not_reached)
    Many(a, b, c, d, e, f, g, h, i) --> s(a + b + c, d + e + f, g + h + i) X.
    Gone --> NIL
    Early --> A(1, true) NIL B
}

cga! {
    /// Has much of the same, and equal floats.
    pub(crate) grammar Repeated;
    attr wall_a = true
    attr wall_b = false
    attr wall_c = true
    attr wall_d = false
    Lot --> split(x) { { ~1 : Part }* }
    Part --> case split.index == split.total - 1 && wall_a : Any(1, 2, 3, 4, 5, 6, 7, 8, 9)
             case wall_b || wall_c == wall_d : X. else : comp(f) { side : Side | all : X. }
    Side --> case comp.index == comp.total - 1 : X. else : NIL
    Any(a, b, c, d, e, f, g, h, i) --> case a == b || c == d || e == f || g == h : X. else : print(i) X.
}

cga! { pub(crate) grammar StrictText = "Lot --> split(x) { '0.5 : A | ~1 : B(0.2) } A --> s('1, 2, 3) B(_n) --> X."; }

#[test]
fn generated_code_gives_no_reason_to_complain() {
    let (width, name, on) = (1_i32, String::from("x"), true);
    let rules = cga! {
        attr size = 2
        attr other = rand(size)
        Lot --> case #on : set(material.name, #name) split(x) { #width : A. | ~size : B(other) | 1 : C } else : NIL
        C --> comp(e) { #width > 2 && border : A. | material.name == #name : B. } print(comp(v) { all : #name + "" })
        B(n) --> case n > 0 : B(n - 1) else : B.
    };
    assert!(rules.generate(&Shape::rectangle(1.0, 1.0)).is_ok());
    let strict = Strict { height: 5.0, ..Strict::default() };
    let result = strict.generate(&Shape::rectangle(1.0, 1.0));
    assert!(result.is_ok(), "{result:?}");
    assert!(StrictText::default().generate(&Shape::rectangle(1.0, 1.0)).is_ok());
    assert!(Repeated::default().generate(&Shape::rectangle(3.0, 1.0)).is_ok());
    drop(name);
}
