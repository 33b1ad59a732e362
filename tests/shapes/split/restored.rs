//! A split changes its shape while it is under way; what follows in the rule finds it as it was.

use cga::{Model, Settings, Shape, cga};

cga! {
    grammar Restored;
    // All that a split changes in its shape.
    place = scope.tx + " " + scope.ty + " " + scope.tz
    size = scope.sx + " " + scope.sy + " " + scope.sz
    seed = seedian + ""
    counter = split.index + " of " + split.total
    material = material.color.r + " " + material.color.g
    sides = str(comp(f) { isTagged("extrude.top") : "t" | isTagged("extrude.side") : "s" | all : "-" })

    Origin    --> print(place) split(x) { 1 : NIL | ~1 : X. } print(place)
    Extent    --> print(size) split(x) { 1 : X. | ~1 : X. } print(size)
    Thickness --> s(^1, 2.5, ^1) print(size) split(x) { ~1 : X. } print(size)
    Seed      --> print(seed) split(x) { ~1 : Lit | ~1 : Lit } print(seed)
    Lit       --> 50% : X. else : Y.
    Counter   --> split(x) { { 1 : Counted }* }
    Counted   --> print(counter) split(y) { { 1 : Turned(split.index) }* } print(counter)
    Turned(i) --> case i < 2 : X. else : Y.
    Material  --> color("#00ff00") print(material) split(x) { ~1 : color("#ff0000") X. } print(material)
    Sides     --> extrude(2) print(sides) split(y) { 1 : X. } print(sides)
}

/// Runs a rule, and compares its lines pair by pair.
fn check(rule: &str, shape: &Shape, pairs: &[&str]) {
    let settings = Settings { start: Some(rule.to_owned()), ..Settings::default() };
    for shape in [shape.clone(), shape.clone().held_as_meshes()] {
        let mut model = Model::new();
        let report = Restored::default().run(&shape, &settings, &mut model).expect("no limit");
        let lines: Vec<String> = report.prints().iter().map(ToString::to_string).collect();
        let expected: Vec<&str> = pairs.iter().flat_map(|line| [*line; 2]).collect();
        assert_eq!(lines, expected, "{rule}");
    }
}

#[test]
fn a_split_restores_the_origin() {
    check("Origin", &Shape::cuboid(4.0, 3.0, 2.0), &["0 0 0"]);
}

#[test]
fn a_split_restores_the_extent() {
    check("Extent", &Shape::cuboid(4.0, 3.0, 2.0), &["4 3 2"]);
}

#[test]
fn a_split_restores_the_thickness_of_a_flat_shape() {
    let settings = Settings { start: Some("Thickness".to_owned()), ..Settings::default() };
    let model = Restored::default().generate_with(&Shape::rectangle(4.0, 3.0), &settings).expect("no limit");
    let lines: Vec<String> = model.prints().iter().map(ToString::to_string).collect();
    assert_eq!(lines.len(), 2);
    assert!(lines[0].contains("2.5") && lines[0] == lines[1], "{lines:?}");
}

#[test]
fn a_split_restores_the_seed() {
    check("Seed", &Shape::cuboid(4.0, 3.0, 2.0).seed(7), &["7"]);
}

#[test]
fn a_split_restores_the_counters() {
    check("Counter", &Shape::cuboid(3.0, 3.0, 2.0), &["0 of 3", "1 of 3", "2 of 3"]);
}

#[test]
fn a_split_restores_the_material() {
    check("Material", &Shape::cuboid(4.0, 3.0, 2.0), &["0 1"]);
}

#[test]
fn a_split_restores_the_tags_of_sides() {
    let tags = "(6)[-,t,s,s,s,s]";
    check("Sides", &Shape::rectangle(4.0, 3.0), &[tags]);
}
