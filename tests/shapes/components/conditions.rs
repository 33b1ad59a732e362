//! Selectors that are more than a word: *comp operation*, Logical selection expressions.

use cga::{Model, Shape, cga};

use super::{lines, mesh, run};

cga! {
    @Allow(old_spelling, rule_not_reached)
    grammar Conditions = r#"
    attr least = 4
    attr flag = true
    attr none = false
    const large = geometry.area > least
    mine = geometry.isOriented(top) || geometry.nVertices == 3
    bigger(n) = geometry.area > n

    @StartRule
    TopAndFront --> comp(f) { top || front = X. | all : Y. }
    Area --> comp(f) { geometry.area() > least && !top : X. }
    Mine --> comp(f) { mine : X. | all : Y. }
    Parameter --> Bigger(5, false)
    Bigger(n, all_of_them) --> comp(f) { bigger(n) : X. | all_of_them : Z. | n : W. | n - 4 = V. }
    Attributes --> comp(f) { none : X. | flag && side : Y. | flag : Z. }
    Set --> set(least, 5) comp(f) { geometry.area > least : X. }
    Cases --> comp(f) { case least > 3 : front else : back : X. | (left == flag) : Y. | true : Z. }
    Nested --> comp(f) { sum(comp(e) { scope.sx > 2.5 || scope.sy > 2.5 || scope.sz > 2.5 : 1 }) == 2 : X. | all : Y. }
    Old --> comp(f) { noStreetSide && side : X. | streetSide : Y. | all : Z. }
    Constant --> comp(f) { large : X. | all : Y. }
    Both --> comp(f) { p(1) && top : X. | p(0) : Y. | all : Z. }
    Borders --> comp(fe) { border && (front || back) = Note("X") | inside : Note("Y") | !inside : Note("Z") }
    Note(name) --> print(name + comp.index) X.
    "#;
}

/// The leaves of a cube of 1 by 2 by 3: faces of 6 at left and right, 3 at top and bottom, 2 in front and at the back.
fn of_box(rule: &str) -> Vec<(String, usize)> {
    counts(&run(&Conditions::default(), rule, &Shape::cuboid(1.0, 2.0, 3.0)))
}

fn counts(model: &Model) -> Vec<(String, usize)> {
    let mut counts: Vec<_> = model.counts().into_iter().map(|(name, count)| (name.to_owned(), count)).collect();
    counts.sort();
    counts
}

fn is(found: &[(String, usize)], expected: &[(&str, usize)]) {
    let found: Vec<(&str, usize)> = found.iter().map(|(name, count)| (name.as_str(), *count)).collect();
    assert_eq!(found, expected);
}

#[test]
fn words_are_put_together_by_logic() {
    is(&of_box("TopAndFront"), &[("X", 1), ("Y", 4)]);
}

#[test]
fn functions_are_evaluated_on_the_component() {
    is(&of_box("Area"), &[("X", 2)]);
    is(&of_box("Nested"), &[("X", 4), ("Y", 2)]);
}

#[test]
fn a_function_of_the_grammar_selects() {
    is(&of_box("Mine"), &[("X", 1), ("Y", 5)]);
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let tetrahedron = mesh(&points, &[&[0, 2, 1], &[0, 1, 3], &[0, 3, 2], &[1, 2, 3]]);
    is(&counts(&run(&Conditions::default(), "Mine", &Shape::mesh(tetrahedron))), &[("X", 4)]);
}

#[test]
fn parameters_are_conditions_or_indices_by_their_type() {
    // Faces 5 and 1 are left of `bigger(5)`, or not: a number that is taken selects nothing.
    let found = of_box("Parameter");
    assert_eq!(found.iter().find(|(name, _)| name == "X").map(|(_, count)| *count), Some(2));
    assert!(found.iter().all(|(name, _)| name != "Z"));
    assert!((3..=4).contains(&found.iter().map(|(_, count)| count).sum::<usize>()));
}

#[test]
fn attributes_select_all_or_nothing() {
    is(&of_box("Attributes"), &[("Y", 4), ("Z", 2)]);
    is(&of_box("Set"), &[("X", 2)]);
    is(&of_box("Cases"), &[("X", 1), ("Y", 1), ("Z", 4)]);
}

#[test]
fn a_constant_is_the_initial_shape_s() {
    is(&of_box("Constant"), &[("X", 6)]);
}

#[test]
fn old_words_mean_their_new_ones() {
    is(&of_box("Old"), &[("X", 3), ("Y", 1), ("Z", 2)]);
}

#[test]
fn chance_selects() {
    is(&of_box("Both"), &[("X", 1), ("Z", 5)]);
}

#[test]
fn edges_have_conditions_too() {
    let points = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0], [2.0, 1.0], [2.0, 0.0]].map(|[x, z]| [x, 0.0, z]);
    let two = Shape::mesh(mesh(&points, &[&[0, 1, 2, 3], &[1, 4, 5, 2]]));
    let lines = lines(&run(&Conditions::default(), "Borders", &two));
    // Of eight, four face front or back, and the edge between the faces counts for both.
    assert_eq!(lines, ["X0", "Y0", "Y1", "Z0", "Z1"]);
}
