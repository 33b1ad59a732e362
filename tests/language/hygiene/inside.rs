//! Grammars inside functions, generics, blocks, macros, and several in one module.

use cga::{Grammar, Model, Shape, cga};

cga! { grammar One; attr a = 1 Lot --> extrude(a) A. }
cga! { grammar Two; @Allow(unused_attribute) attr a = "x" Lot --> B. C --> C. }
cga! { pub(crate) grammar Three = "Lot --> C."; }
cga! { pub(super) grammar Empty; }

fn lot() -> Shape {
    Shape::rectangle(1.0, 1.0)
}

fn names(model: &Model) -> Vec<&str> {
    model.leaves().map(|leaf| leaf.rule()).collect()
}

#[test]
fn a_module_has_room_for_several() {
    assert_eq!(names(&One::default().generate(&lot()).unwrap()), ["A"]);
    assert_eq!(names(&Two::default().generate(&lot()).unwrap()), ["B"]);
    assert_eq!(names(&Three::default().generate(&lot()).unwrap()), ["C"]);
    assert!(Empty::default().generate(&lot()).is_err());
}

#[test]
fn a_function_has_room_for_several() {
    cga! { grammar One; Lot --> Inner. }
    {
        cga! { grammar One; Lot --> Innermost. }
        assert_eq!(names(&One::default().generate(&lot()).unwrap()), ["Innermost"]);
    }
    assert_eq!(names(&One::default().generate(&lot()).unwrap()), ["Inner"]);
}

fn generic<T: Into<f64> + Copy>(height: T) -> impl Grammar {
    cga! { Lot --> extrude(#(height.into())) A. }
}

struct Holder<'a> {
    colour: &'a str,
}

impl Holder<'_> {
    fn rules(&self) -> Box<dyn Grammar> {
        Box::new(cga! { Lot --> color(#(self.colour)) A. })
    }
}

#[test]
fn rules_may_take_values_from_generic_functions_and_methods() {
    assert_eq!(generic(3.0f32).generate(&lot()).unwrap().volume(), 3.0);
    assert_eq!(names(&Holder { colour: "#ff0000" }.rules().generate(&lot()).unwrap()), ["A"]);
}

macro_rules! tower {
    ($name:ident, $height:expr, $path:path, $leaf:ident) => {
        cga! {
            grammar $name;
            attr height = 2 * $height
            Lot --> extrude(height + #$height) $path(1) $leaf.
        }
    };
}

fn nothing(_: &mut Shape, _: f64) {}

tower!(FromMacro, 1 + 2, self::nothing, Wall);

#[test]
fn a_macro_of_the_user_may_make_grammars() {
    let model = FromMacro::default().generate(&lot()).unwrap();
    assert_eq!((names(&model), model.volume()), (vec!["Wall"], 9.0));
}

mod other {
    pub(super) mod shapes {
        #[doc(hidden)]
        pub(crate) use cga::__rt;
    }
}

#[test]
fn the_runtime_may_be_reached_by_another_path() {
    cga! { #[cga(crate = self::other::shapes)] grammar Renamed; Lot --> A. }
    let rules = cga! { #[cga(crate = self::other::shapes)] Lot --> extrude(#(2)) B. };
    assert_eq!(names(&Renamed::default().generate(&lot()).unwrap()), ["A"]);
    assert_eq!(names(&rules.generate(&lot()).unwrap()), ["B"]);
}

cga! {
    #[derive(PartialEq, PartialOrd)]
    #[cfg(any())]
    grammar Left;
    Lot --> extrude(#(NO_SUCH_THING)) Out.
}

#[test]
fn a_condition_leaves_out_all_of_a_grammar() {
    #[derive(PartialEq)]
    struct Left;
    assert!(Left == Left);
}
