//! Keys in the tree of shapes (*getTreeKey function*), and old numbers of shapes.

#[cfg(not(feature = "compiled"))]
use cga::Grammar as _;
use cga::{Settings, Shape, cga};

use crate::{lines, model, rules};

#[test]
fn a_key_stays_during_its_rule() {
    cga! {
        grammar Stays = r#"
            Init --> print(getTreeKey) split(x) { 2 : ShapeB print(getTreeKey) | 3 : ShapeC print(getTreeKey) }
            ShapeB --> X.
            ShapeC --> Y.
        "#;
    }
    assert_eq!(lines(&model_of_width(&Stays::default(), 5.0)), ["0;"; 3]);
}

#[test]
fn keys_are_those_of_the_listing() {
    rules! {
        grammar Listed = r#"
            Init --> print("Init " + getTreeKey) extrude(10) comp(f) { front : Facade }
            Facade --> print("Facade " + getTreeKey) split(y) { '0.5 : Floor }*
            Floor --> print("Floor " + getTreeKey) split(x) { '0.1 : Wall | '0.3 : Window | '0.1 : Wall }*
            Wall --> print("Wall " + getTreeKey)
            Window --> print("Window " + getTreeKey)
        "#;
    }
    let row = |floor: usize| {
        let names = ["Wall", "Window", "Wall", "Wall", "Window", "Wall"];
        names.into_iter().enumerate().map(move |(at, name)| format!("{name} 0;0;{floor};{at};"))
    };
    let above = ["Init 0;", "Facade 0;0;", "Floor 0;0;0;", "Floor 0;0;1;"].map(str::to_owned);
    let expected: Vec<String> = above.into_iter().chain(row(0)).chain(row(1)).collect();
    assert_eq!(lines(&model(&Listed::default())), expected);
}

#[test]
fn keys_are_those_of_the_tree_of_shapes() {
    rules! {
        grammar Same = r#"
            attr key = getTreeKey
            Lot --> print(key) A B. [ A ] NIL label("a") inline(append) { A } split(x) { 1 : A | 1 : t(0, 1, 0) A C. | ~1 : Deep(700) } A
            A --> 50% : X. else : C. X.
            Deep(n) --> case n > 0 : Deep(n - 1) Y. else : Last
            Last --> report(getTreeKey, 1) Z.
        "#;
    }
    let settings = Settings { tree: true, ..Settings::default() };
    let model = Same::default().generate_with(&Shape::rectangle(4.0, 2.0).seed(3), &settings).expect("a model");
    assert_eq!(lines(&model), ["0;"]);
    let (building, _) = model.buildings().next().expect("a building");
    let tree = building.tree.as_ref().expect("a tree");
    let last = tree.nodes().find(|node| node.rule() == "Last").expect("the last rule");
    assert!(model.reported(&last.key()).is_some(), "{}", last.key());
}

#[test]
fn old_numbers_differ_where_keys_differ() {
    rules! {
        grammar Numbered = r#"Lot --> split(x) { 1 : A }*  A --> print(uid) B  B --> print(uid) print(uid) X."#;
    }
    let lines = lines(&model_of_width(&Numbered::default(), 3.0));
    let mut different = lines.clone();
    different.sort();
    different.dedup();
    assert_eq!((lines.len(), different.len()), (9, 6));
}

fn model_of_width(grammar: &dyn cga::Grammar, width: f64) -> cga::Model {
    crate::clean(grammar.generate(&Shape::rectangle(width, 1.0)).expect("a model"))
}
