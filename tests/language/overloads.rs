//! Rules and functions that share a name.

use cga::cga;

use crate::{leaves, lines, model};

#[test]
fn functions_differ_in_number_and_types_of_their_parameters() {
    cga! {
        grammar Functions = r#"
            kind = "none"
            kind(x) = "number " + (x + 0)
            kind(x, y) = kind(x) + " and " + kind(y)
            what(x) = "number" + (0 * x)
            what(x) = x + " text" + len(x)
            what(x) = case x : "yes" else : "no"
            what(x) = "numbers" + sum(x .+ 0)
            Lot --> print(kind) print(kind(1)) print(kind(1, 2)) print(what(1)) print(what("a")) print(what(true)) print(what([1, 2]))
        "#;
    }
    assert_eq!(
        lines(&model(&Functions::default())),
        ["none", "number 1", "number 1 and number 2", "number0", "a text1", "yes", "numbers3"]
    );
}

#[test]
fn rules_differ_in_number_and_types_of_their_parameters() {
    cga! {
        grammar Rules = r#"
            Lot --> Part Part(1) Part("a") Part(true) Part([1, 2]) Part(1, 2)
            Part --> None.
            Part(n) --> print(n + 1) Number.
            Part(t) --> print(len(t)) Text.
            Part(b) --> print(!b) Truth.
            Part(a) --> print(a .* 2) Array.
            Part(a, b) --> print(a + b + 0) Two.
        "#;
    }
    let model = model(&Rules::default());
    assert_eq!(leaves(&model), ["None", "Number", "Text", "Truth", "Array", "Two"]);
    assert_eq!(lines(&model), ["2", "1", "false", "(2)[2,4]", "3"]);
}

#[test]
fn own_functions_come_before_those_of_the_language() {
    cga! {
        grammar Own = r#"
            max(a, b) = a + b
            clamp(a) = a * 2
            Lot --> print(max(1, 2)) print(min(1, 2)) print(clamp(4)) print(clamp(7, 0, 5))
        "#;
    }
    assert_eq!(lines(&model(&Own::default())), ["3", "1", "8", "5"]);
}

#[test]
fn a_rule_a_function_and_an_attribute_may_share_a_name() {
    cga! {
        grammar Shared = r#"
            attr Wall = 3
            Height(x) = x * 2
            Lot --> Wall Height
            Wall --> print(Wall) X.
            Height --> print(Height(Wall)) Y.
        "#;
    }
    let model = model(&Shared::default());
    assert_eq!((lines(&model), leaves(&model)), (vec!["3".to_owned(), "6".to_owned()], vec!["X", "Y"]));
}
