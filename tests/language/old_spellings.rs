//! Old spellings run as the new ones.

use cga::cga;

use crate::{leaves, lines, lot, model, rules};

#[test]
fn index_finds_an_element_as_find_first_does() {
    cga! {
        grammar Index = r#"
            const numbers = [5, 7, 7.25, 9]
            Lot --> print(index(numbers, 7)) print(index(numbers, 7.5, 0.3)) print(index(numbers, 3))
                print(index(["a", "b"], "b")) print(index([true, false], false)) print(index(["a"], "c"))
        "#;
    }
    assert_eq!(lines(&model(&Index::default())), ["1", "2", "-1", "1", "1", "-1"]);
}

#[test]
fn old_attributes_and_operations_set_the_material() {
    rules! {
        grammar Material = r#"
            Lot --> set(material.map3, "builtin:uvtest.png") set(material.map4, "builtin:uvtest.png") set(material.map5, "builtin:default") opacity(0.25)
                print(material.specularmap + material.opacitymap + material.normalmap + material.map3) print(material.opacity)
        "#;
    }
    assert_eq!(
        lines(&model(&Material::default())),
        [concat!("builtin:uvtest.png", "builtin:uvtest.png", "builtin:default", "builtin:uvtest.png"), "0.25"]
    );
}

#[test]
fn old_words_for_streets_ask_about_the_front() {
    rules! {
        grammar Streets = r#"
            Lot --> s(4, 3, 2) primitiveCube()
                print(geometry.area(streetSide) == geometry.area(street.front))
                print(geometry.area(noStreetSide) == geometry.area() - geometry.area(street.front))
                print(geometry.isOriented(streetSide)) print(geometry.isOriented(noStreetSide))
                comp(f) { street.front : print(geometry.isOriented(noStreetSide)) NIL | top : print(geometry.isOriented(noStreetSide)) NIL }
        "#;
    }
    assert_eq!(lines(&model(&Streets::default())), ["true", "true", "true", "true", "false", "true"]);
}

#[test]
fn the_width_of_a_street_is_a_value_for_each_edge() {
    rules! {
        grammar Widths = r#"
            attr streetWidth(edge) = case edge == 0 : 8 else : 0
            attr first = streetWidth(0)
            Lot --> print(first) print(streetWidth(1))
        "#;
    }
    assert_eq!(lines(&model(&Widths::default())), ["8", "0"]);
}

#[test]
fn a_list_in_a_range_is_an_enumeration() {
    cga! {
        grammar Lists = r#"
            @Location(10, 20)
            @Range(0, 1, 2)
            attr level = 0
            Lot --> print(level)
        "#;
    }
    let rules = Lists { level: 1.5 };
    assert!(cga::Grammar::generate(&rules, &lot()).is_err());
    assert_eq!(lines(&model(&Lists { level: 2.0 })), ["2"]);
}

#[test]
fn rules_overload_operations_by_types() {
    rules! {
        grammar Overloads = r##"
            Lot --> [ color(true) ] [ color("#ff0000") print(material.color.rgb) NIL ] [ extrude("high") ] [ label(3) ]
            color(dark) --> case dark : Dark. else : Light.
            extrude(how) --> print(how + "er") High.
            label(n) --> print(n * 2) Labelled.
        "##;
    }
    let model = model(&Overloads::default());
    assert_eq!(leaves(&model)[..3], ["Dark", "High", "Labelled"]);
    assert_eq!(lines(&model), ["#ff0000", "higher", "6"]);
}
