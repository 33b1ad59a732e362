//! Rules, functions and attributes with names that mean something to Rust.

use cga::{Shape, cga};

cga! {
    pub grammar Names;

    attr type = 1
    attr match = 2
    attr self = 3
    attr Self = 4
    attr self_ = 9
    attr gen = 5
    attr r#struct = 6
    attr f64 = 7
    attr camelCase = 8
    attr String = "text"
    attr bool = true
    attr clone = rand(1, 2)

    const const_0 = type + match + self + self_ + Self + gen + struct + f64 + camelCase
    fn(shape) = shape + const_0
    drop(cx) = case bool : cx else : clone

    @StartRule
    Lot --> Vec Some None Ok Err String Default Sink Option Result Box Clone Copy Send Self Fn Flow Shape CgaRules cga_rt

    Vec --> type
    Some --> match
    None --> Some
    Ok --> fn
    Err --> dyn
    String --> async
    Default --> gen
    Sink --> auto
    Option --> self
    Result --> super
    Box --> crate
    Clone --> Box
    Copy(Sink) --> case Sink > 1 : Rules(0) else : Y.
    Rules(CgaRules) --> case CgaRules == 0 : X. else : Y.
    Copy --> Copy(fn(1))
    Send --> Copy(drop(2))
    Self --> case String == "text" : A. else : B.
    Fn --> X.
    Flow --> X.
    Shape --> X.
    CgaRules --> X.
    cga_rt --> X.
    type --> A.
    match --> A.
    fn --> A.
    dyn --> A.
    async --> A.
    gen --> A.
    auto --> A.
    self --> A.
    super --> A.
    crate --> A.

    Locals --> Locals(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12)
    Locals(g, cx, shape, part, value, arm, slot, env, own, a0, match, W)
        with ( base := g + cx  flow := base + shape  cx_ := flow  self := cx_ * 2 ) -->
        t(g, cx, shape)
        split(x) {
            part : Sum(g, cx, shape, part, value, arm, slot, env, own, a0, match, W + self)
            | ~value : comp(f) { W == 12 && top : Sum(g, cx, shape, part, value, arm, slot, env, own, a0, match, W + self) }
        }
    Constants(SPLIT, SIZES, PATTERN) -->
        split(x) { SPLIT : Constant(SPLIT) | ~SIZES : split(y) { { ~PATTERN : Constant(SIZES) }* } | { SIZES : Constant(PATTERN) }* }
    Constant(x) --> case 0 < x : Right. else : Wrong.
    Constants --> Constants(1, 2, 3)
    Sum(a, b, c, d, e, f, last, h, i, j, k, l) -->
        case a == 1 && b == 2 && c == 3 && d == 4 && e == 5 && f == 6 && last == 7 && h == 8 && i == 9 && j == 10 && k == 11 && l == 24 :
            Right.
        else :
            Wrong.
}

/// Rust would take a parameter of this name for it.
const W: f64 = 0.5;
#[allow(non_upper_case_globals, dead_code)]
const h: f64 = 0.25;
#[allow(non_upper_case_globals, dead_code)]
static i: f64 = 0.125;
#[allow(non_camel_case_types, dead_code)]
struct k;
#[allow(dead_code)]
const _J: f64 = 0.1;
#[allow(non_upper_case_globals, dead_code)]
const W_: f64 = 0.1;
#[allow(non_upper_case_globals, dead_code)]
const 幅: f64 = 0.1;
#[allow(non_camel_case_types, dead_code)]
struct gap(u8);
#[allow(non_camel_case_types, dead_code)]
enum Side {
    left,
    right,
}
#[allow(unused_imports)]
use Side::*;

cga! {
    grammar Patterns;
    Lot --> A(1, 2, 3, 4, 5, 6)
    A(_J, W_, 幅, gap, left, right) with ( W := gap + right ) -->
        split(x) { { ~left : B(W, _J) }* } [ case W_ + 幅 == 5 && W == 10 : t(0, 0, left) B(W, right) else : NIL ]
    B(W, gap) --> case W == 10 && gap > 0 : Right. else : Wrong.
}

#[test]
fn constants_and_variants_of_the_user_do_not_reach_the_rules() {
    #[allow(non_upper_case_globals)]
    const h: f64 = 0.5;
    let rules = cga! { Lot --> A(2) A(h) --> case h == 2 : Right. else : Wrong. };
    assert_eq!(rules.generate(&Shape::cuboid(1.0, 1.0, 1.0)).expect("no limit").count("Right"), 1);
    let model = Patterns {}.generate(&Shape::cuboid(10.0, 1.0, 1.0)).expect("no limit");
    assert_eq!((model.count("Right"), model.count("Wrong")), (3, 0), "{:?}", model.counts());
    assert_eq!(h, 0.5);
}

#[test]
fn words_of_rust_are_names_like_others() {
    let names =
        Names { r#type: 10.0, r#match: 20.0, self_: 1.0, self__: 9.0, r#gen: 2.0, r#struct: 3.0, ..Names::default() };
    let model = names.generate(&Shape::cuboid(1.0, 1.0, 1.0)).expect("no limit");
    assert_eq!(model.count("A"), 13, "{:?}", model.counts());
    assert_eq!(names.generate_from("type", &Shape::cuboid(1.0, 1.0, 1.0)).expect("a rule").len(), 1);
}

#[test]
fn parameters_may_have_the_names_of_generated_locals_and_of_constants() {
    let model = Names::default().generate_from("Locals", &Shape::cuboid(10.0 + W, 1.0, 1.0)).expect("a rule");
    assert_eq!((model.count("Right"), model.count("Wrong")), (2, 0), "{:?}", model.counts());
    let model = Names::default().generate_from("Constants", &Shape::cuboid(10.0, 6.0, 1.0)).expect("a rule");
    assert_eq!((model.count("Right"), model.count("Wrong")), (7, 0), "{:?}", model.counts());
}
