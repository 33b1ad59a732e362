//! Occlusion queries of shapes of the same initial shape (*inside*, *overlaps*, *touches function*).

use cga::{Error, LimitKind, Model, Shape, cga};

use crate::{clean, leaves};

fn model_of(grammar: &dyn cga::Grammar, width: f64, depth: f64) -> Model {
    clean(grammar.generate(&Shape::rectangle(width, depth)).expect("a model"))
}

#[test]
fn queries_ask_the_first_derivation() {
    cga! {
        grammar Enlarged = r#"
            Lot --> extrude(10) split(x) { 10 : Block }*
            Block --> case overlaps(intra) : Red. else : s('2, '1, '2) center(xyz) Green.
        "#;
    }
    cga! {
        grammar Apart = r#"
            Lot --> extrude(10) split(x) { 10 : Block }*
            Block --> case overlaps(intra) : s('2, '1, '2) center(xyz) Red. else : Green.
        "#;
    }
    let model = model_of(&Enlarged::default(), 20.0, 10.0);
    assert_eq!(leaves(&model), ["Red", "Red"]);
    assert!(model.leaves().all(|leaf| leaf.scope().size.x == 10.0));
    assert_eq!(leaves(&model_of(&Apart::default(), 20.0, 10.0)), ["Green", "Green"]);
}

#[test]
fn ancestors_descendants_and_copies_do_not_occlude() {
    cga! {
        grammar Line = r#"
            Lot --> extrude(10) Mass
            Mass --> label("mass") comp(f) { side : Wall | top : Wall }
                [ case touches(intra) : Hidden. else : comp(f) { bottom : Free. } ]
            Wall --> case touches(intra) : HiddenWall. else : FreeWall.
        "#;
    }
    let found = leaves(&model_of(&Line::default(), 10.0, 10.0)).join(" ");
    assert_eq!(found, "FreeWall FreeWall FreeWall FreeWall FreeWall Free");
}

#[test]
fn siblings_occlude_with_a_label_too() {
    cga! {
        grammar Named = r#"
            Lot --> split(x) { 10 : Block(split.index) }*
            Block(n) --> case n == 0 : extrude(10) label("first") Sides else : extrude(10) Sides
            Sides --> comp(f) { side : Wall | top : NIL }
            Wall --> case touches(intra, "first") : Hidden. else : Free.
        "#;
    }
    let model = model_of(&Named::default(), 30.0, 10.0);
    // The wall of the second block. The labelled copy has the place of the first block.
    assert_eq!(model.count("Hidden"), 1);
}

#[test]
fn facades_and_lots_do_not_occlude() {
    cga! {
        grammar Open = r#"
            Lot --> split(x) { 10 : Tile }*
            Tile --> case touches(intra) : Hidden. else : Free.
        "#;
    }
    assert_eq!(leaves(&model_of(&Open::default(), 20.0, 10.0)), ["Free", "Free"]);
}

#[test]
fn the_limit_of_depth_ends_a_rule_that_asks_for_ever() {
    cga! { grammar Alone = r#"Lot --> extrude(1) A  A --> case touches(intra) : A else : X."#; }
    cga! { grammar Two = r#"Lot --> extrude(1) split(x) { 1 : A }*  A --> case touches(intra) : A else : X."#; }
    assert_eq!(leaves(&model_of(&Alone::default(), 1.0, 1.0)), ["X"]);
    let error = Two::default().generate(&Shape::rectangle(2.0, 1.0)).expect_err("a limit");
    assert!(matches!(error, Error::Limit { what: LimitKind::Depth, .. }), "{error}");
}
