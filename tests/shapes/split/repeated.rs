//! A repetition is made from a template only where it is of the same size, unit mesh and material.

use cga::{Model, Repeats, Settings, Shape, cga};

cga! {
    grammar Repeated;
    // The last repetition is cut; all of them are inside, and have the same unit mesh.
    Cut      --> split(x) { 1 : NIL | { 2 : Tile }* | 1 : NIL }
    // The first floor has the tags of the bottom, the last one the tags of the top.
    Tagged   --> extrude(4) split(y) { { 1 : Tile }* }
    Painted  --> extrude(4) comp(f) { front : color("#ff0000") Wall | side : color("#0000ff") Wall }
    Wall     --> split(y) { { 1 : Tile }* }
    Tile     --> split(x) { ~1 : X. | ~1 : Y. }
    // Half of the glass is lit: each hole has the seed of its repetition.
    Drawn    --> split(x) { { 1 : Pane }* }
    Pane     --> split(y) { ~1 : Lit | ~1 : X. }
    Lit      --> 50% : Y. else : Z.
    // Walls of many colours, with parts that keep the colour, one channel of it, or nothing.
    Many     --> split(x) { { ~0.5 : color(rand(1), rand(1), rand(1)) Row }* | 1 : Row | 1 : color("#ffffff") Row }
    Row      --> split(y) { { ~1 : Kept }* | { 0.3 : Channel }* | { 0.3 : Given("#00ff00", 0.5) }* | { 0.3 : Asked }* }
    Kept     --> split(x) { ~1 : X. | ~1 : set(material.roughness, 0.5) X. | ~1 : color("#ff0000") Y. | ~1 : Held }
    Channel  --> split(x) { ~1 : set(material.color.g, 0.5) X. | ~1 : set(material.color.rgb, "#123456") X. }
    Given(c, n) --> color(c) split(x) { ~1 : set(material.opacity, n) X. | ~1 : set(material.color.b, n) X. }
    Held     --> split(y) { ~1 : Lit | ~1 : extrude(0.1) Lit }
    Asked    --> case material.color.r > 0.5 : X. else : Y.
    // More colours than a session has numbers for looks. One part has the colour of its wall, the other has not.
    Crowd    --> split(x) { { ~1 : color(rand(1), rand(1), rand(1)) Few }* }
    Few      --> split(y) { { ~4 : Both }* | { 1 : Red }* }
    Both     --> split(y) { ~1 : X. | ~1 : color("#ff0000") Y. }
    Red      --> color("#ff0000") split(y) { ~1 : X. | ~1 : Y. }
}

/// The size, the material, and the tags of the faces of each leaf.
fn leaves(rule: &str, shape: &Shape, repeats: Repeats) -> Vec<String> {
    let settings = Settings { start: Some(rule.to_owned()), repeats, ..Settings::default() };
    let mut model = Model::new();
    Repeated::default().run(shape, &settings, &mut model).expect("no limit");
    let leaf = |leaf: cga::LeafView<'_>| {
        let (mesh, _) = leaf.mesh();
        let tags: Vec<_> = mesh.faces().map(|face| mesh.tag_sets().get(face.tag().tags as usize).cloned()).collect();
        format!("{} {:.6} {:?} {tags:?}", leaf.rule(), leaf.scope().size, leaf.material())
    };
    model.leaves().map(leaf).collect()
}

/// Checks that templates make no difference, and returns the number of kinds of leaves.
fn kinds(rule: &str, shape: &Shape) -> usize {
    let kept = leaves(rule, shape, Repeats::Kept);
    assert_eq!(kept, leaves(rule, shape, Repeats::Direct), "{rule}");
    kept.iter().collect::<std::collections::BTreeSet<_>>().len()
}

#[test]
fn a_repetition_of_another_size_is_another_part() {
    assert_eq!(kinds("Cut", &Shape::cuboid(7.0, 3.0, 2.0)), 4);
}

#[test]
fn a_repetition_with_other_tags_is_another_part() {
    assert_eq!(kinds("Tagged", &Shape::rectangle(4.0, 3.0)), 6);
}

#[test]
fn a_repetition_with_another_material_is_another_part() {
    assert_eq!(kinds("Painted", &Shape::rectangle(4.0, 4.0)), 4);
}

#[test]
fn a_hole_draws_from_the_seed_of_its_repetition() {
    assert_eq!(kinds("Drawn", &Shape::cuboid(20.0, 3.0, 2.0).seed(7)), 3);
}

#[test]
fn a_repetition_has_the_colour_of_its_wall() {
    let many = kinds("Many", &Shape::cuboid(20.0, 9.0, 2.0).seed(3));
    // About eight for each of 38 walls.
    assert!(250 < many, "{many}");
    assert!(5000 < kinds("Crowd", &Shape::cuboid(5000.0, 9.0, 2.0).seed(3)));
}
