//! Nothing is imported, not even the prelude.
#![no_implicit_prelude]

::cga::cga! {
    @Allow(unused_attribute)
    pub grammar Bare;
    attr height = 3
    attr about = "text"
    attr tall = height > 2
    attr count = rand(1, 4)
    const words = about + height
    total(n) = case n > 0 : total(n - 1) + 1 else : 0

    @Range(min = 0, max = 1)
    attr share = 0.5

    Lot --> extrude(height) split(y) { ~1 : Mass(words) | { ~0.5 : Mass("x") }* | 'share : NIL }
    Mass(text) --> case text == "x" : [ center(xz) s(^share, 1, 1) Band. ] NIL
                   else : set(material.name, text) set(share, 1) Half
    Half --> 50% : Faces else : Again(total(3))
    const sides = comp(fe) { front || tall : scope.sx | all = count }
    Faces --> comp(f) { top : Roof. | material.name == about || geometry.area > sides[0] : Wall. | side = Walls. }
    Again(n) --> case n > 0 : Again(n - 1) else : NIL
}

#[test]
fn a_grammar_needs_no_prelude() {
    let bare: Bare = ::core::default::Default::default();
    let model = bare.generate(&::cga::Shape::rectangle(2.0, 2.0));
    ::std::assert!(model.is_ok());
    let name = "x";
    let rules = ::cga::cga! { attr size = 2 Lot --> color(#name) split(x) { #(1.5) : A. | ~size : B. } };
    ::std::assert!(::core::clone::Clone::clone(&rules).generate(&::cga::Shape::rectangle(2.0, 2.0)).is_ok());
}
