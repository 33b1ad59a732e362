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
    Copy(Sink) --> case Sink > 1 : X. else : Y.
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
}

#[test]
fn words_of_rust_are_names_like_others() {
    let names =
        Names { r#type: 10.0, r#match: 20.0, self_: 1.0, self__: 9.0, r#gen: 2.0, r#struct: 3.0, ..Names::default() };
    let model = names.generate(&Shape::cuboid(1.0, 1.0, 1.0)).expect("no limit");
    assert_eq!(model.count("A"), 13, "{:?}", model.counts());
    assert_eq!(names.generate_from("type", &Shape::cuboid(1.0, 1.0, 1.0)).expect("a rule").len(), 1);
}
