//! `comp` as a value: *comp function*.

use cga::{Shape, cga};

use super::{lines, run, square};

cga! {
    @Allow(rule_not_reached)
    grammar Values = r#"
    attr areas = comp(f) { all : geometry.area }
    const fronts = comp(f) { front : true }
    largest = sum(comp(f) { geometry.area > 5 : 1 })
    named(word) = comp(f) { side : word + comp.index | top = word + comp.total }
    depth(n) = sum(comp(v) { 0 : case n > 0 : 1 + depth(n - 1) else : 0 })

    @StartRule
    Declared --> print(areas) print(fronts) print(largest) print(named("a")) X.
    InRules --> Inner(2)
    Inner(n) --> print(comp(f) { n : n * 10 | n + 1 : n * 100 | all : -1 }) split(x) { '0.5 : Half(n) }
    Half(n) --> print(comp(f) { geometry.area < 2 : n }) X.
    Once --> print(comp(f) { side = rand(0, 1) | all : 2 }) X.
    Stays --> print(comp(e) { all : scope.sx }) print(scope.sx) print(comp.sel) comp(f) { top : print(comp(e) { all : comp.index }) print(comp.sel) X. }
    Types --> print(comp(f) { top : "t" }) print(comp(f) { top : true }) print(comp(f) { top : 1 }) X.
    Frames --> print(comp(v, noAlign) { all : scope.sx }) print(comp(g) { all : 1 }) print(comp(h) { all : 1 }) X.
    Recursive --> print(depth(3)) X.
    Conditions --> case comp(fe) { front : true }[0] : split(x) { comp(fe) { all : scope.sx }[0] / 2 : X. } else : NIL
    "#;
}

fn of_box(rule: &str) -> Vec<String> {
    lines(&run(&Values::default(), rule, &Shape::cuboid(1.0, 2.0, 3.0)))
}

/// A printed array's elements.
fn elements(line: &str) -> Vec<&str> {
    line.trim_end_matches(']').split_once('[').map(|(_, list)| list.split(',').collect()).unwrap_or_default()
}

fn sorted(line: &str) -> Vec<&str> {
    let mut list = elements(line);
    list.sort_unstable();
    list
}

#[test]
fn attributes_constants_and_functions_hold_values_of_components() {
    let found = of_box("Declared");
    assert_eq!(sorted(&found[0]), ["2", "2", "3", "3", "6", "6"]);
    assert_eq!(sorted(&found[1]), ["false", "false", "false", "false", "false", "true"]);
    assert_eq!(found[2], "2");
    assert_eq!(sorted(&found[3]), ["", "a0", "a1", "a1", "a2", "a3"]);
}

#[test]
fn rules_compute_them_on_the_current_shape() {
    let found = of_box("InRules");
    assert_eq!(found[0], "(6)[-1,-1,20,200,-1,-1]");
    // Half as wide: 1 in front and at the back, 1.5 at top and bottom, 6 at the sides.
    assert_eq!(sorted(&found[1]), ["0", "0", "2", "2", "2", "2"]);
}

#[test]
fn what_is_put_together_is_computed_once() {
    let found = of_box("Once");
    let mut values = sorted(&found[0]);
    assert_eq!(values.len(), 6);
    values.dedup();
    assert_eq!(values.len(), 2, "{found:?}");
}

#[test]
fn the_shape_stays_as_it_is() {
    let found = of_box("Stays");
    assert_eq!(found[1..], ["1", "", "(4)[0,1,2,3]", "top"]);
}

#[test]
fn what_no_selector_takes_is_empty_false_or_zero() {
    let found = of_box("Types");
    assert_eq!(sorted(&found[0]), ["", "", "", "", "", "t"]);
    assert_eq!(sorted(&found[1]), ["false", "false", "false", "false", "false", "true"]);
    assert_eq!(sorted(&found[2]), ["0", "0", "0", "0", "0", "1"]);
}

#[test]
fn there_is_one_for_each_component() {
    assert_eq!(of_box("Frames"), ["(8)[0,0,0,0,0,0,0,0]", "(1)[1]", "(0)[]"]);
}

#[test]
fn functions_may_call_themselves_in_them() {
    assert_eq!(of_box("Recursive"), ["3"]);
}

#[test]
fn they_are_values_like_others() {
    let model = run(&Values::default(), "Conditions", &square());
    assert_eq!(model.counts(), [("X", 1)]);
    assert!((model.leaves().next().expect("a leaf").area() - 0.5).abs() < 1e-12);
}
