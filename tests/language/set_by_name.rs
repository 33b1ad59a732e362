//! Selectors from text (*sel function*).

#[cfg(not(feature = "compiled"))]
use cga::Grammar as _;
use cga::{FaultKind, Shape, cga};
use cga_lang::ops;

use crate::{clean, lines, rules};

#[test]
fn an_attribute_may_have_a_computed_name() {
    // The example of the page, and every kind of value.
    cga! {
        grammar Named = r##"
            colchannel(index) = "material.color." + index
            maps = "color"
            Lot --> set(sel(colchannel("r")), 0.5) set(sel(colchannel("g")), 0.25) set(sel("scope.s" + axis), 4) set(sel("trim." + "vertical"), false)
                set(sel("material." + maps + ".rgb"), "#00ff00") set(sel("material.na" + "me"), "stone") Asked
            axis = case scope.sx > 1 : "x" else : "z"
            Asked --> print(scope.sx) print(trim.vertical) print(material.color.r + material.color.g) print(material.name) print(sel("front")) X.
        "##;
    }
    let model = clean(Named::default().generate(&Shape::rectangle(2.0, 3.0)).expect("a model"));
    assert_eq!(lines(&model), ["4", "false", "1", "stone", "front"]);
}

#[test]
fn unknown_names_and_values_of_other_types_are_faults() {
    rules! {
        grammar Wrong = r#"
            attr height = 3
            name(n) = case n == 0 : "material.colour.r" case n == 1 : "split.index" case n == 2 : "height" case n == 3 : "scope.sx" else : "trim.vertical"
            Lot --> Each(0) Each(1) Each(2) [ set(sel(name(3)), "wide") ] [ set(sel(name(4)), 1) ] X.
            Each(n) --> set(sel(name(n)), 1) NIL
        "#;
    }
    let model = Wrong::default().generate(&Shape::rectangle(2.0, 3.0)).expect("a model");
    let messages: Vec<&str> = model.faults().iter().map(|fault| fault.message.as_str()).collect();
    assert!(model.faults().iter().all(|fault| fault.kind == FaultKind::Value));
    let unknown =
        |name: &str| format!("`{name}` is not an attribute of shapes that can be set; the shape stays as it is");
    assert_eq!(
        messages,
        [
            unknown("material.colour.r"),
            unknown("split.index"),
            unknown("height"),
            "`scope.sx` is a number, and the value has another type; the shape stays as it is".to_owned(),
            "`trim.vertical` is true or false, and the value has another type; the shape stays as it is".to_owned(),
        ]
    );
}

#[test]
fn every_attribute_that_can_be_set_has_its_name() {
    cga! {
        grammar Any = r#"
            attr name = ""
            Lot --> set(sel(name + ""), split.total > 1) X.
        "#;
    }
    let settable = ops::all_shape_attrs().filter(|row| row.set.is_some()).map(|row| row.name);
    let mut count = 0;
    for name in settable {
        count += 1;
        let model = Any { name: name.to_owned() }.generate(&Shape::rectangle(2.0, 3.0)).expect("a model");
        let is_known = model.faults().iter().all(|fault| !fault.message.contains("is not an attribute"));
        assert!(is_known, "{name}: {:?}", model.faults());
    }
    assert!(80 < count, "{count}");
}
