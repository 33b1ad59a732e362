//! Occlusion queries of shapes of the same initial shape (*inside*, *overlaps*, *touches function*).

use cga::glam::DVec3;
use cga::mesh::Bounds;
use cga::{Error, LimitKind, Model, Shape, cga};

use crate::{clean, leaves, rules};

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
    rules! {
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
    rules! {
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
    rules! {
        grammar Open = r#"
            Lot --> split(x) { 10 : Tile }*
            Tile --> case touches(intra) : Hidden. else : Free.
        "#;
    }
    assert_eq!(leaves(&model_of(&Open::default(), 20.0, 10.0)), ["Free", "Free"]);
}

#[test]
fn the_limit_of_depth_ends_a_rule_that_asks_for_ever() {
    rules! { grammar Alone = r#"Lot --> extrude(1) A  A --> case touches(intra) : A else : X."#; }
    cga! { grammar Two = r#"Lot --> extrude(1) split(x) { 1 : A }*  A --> case touches(intra) : A else : X."#; }
    assert_eq!(leaves(&model_of(&Alone::default(), 1.0, 1.0)), ["X"]);
    let error = Two::default().generate(&Shape::rectangle(2.0, 1.0)).expect_err("a limit");
    assert!(matches!(error, Error::Limit { what: LimitKind::Depth, .. }), "{error}");
}

#[test]
fn a_staircase_has_eighteen_hidden_tiles() {
    // The example of *occlusion queries*, with storeys of 4 m.
    rules! {
        grammar Staircase = r#"
            Lot --> extrude(15) split(x) { ~5 : Step }*
            Step --> s('1, '0.7 * (split.index + 1), '1) comp(f) { side : Facade | top : X. }
            Facade --> split(y) { 4 : Tile }*
            Tile --> case touches(intra) : Red. else : Free.
        "#;
    }
    let model = model_of(&Staircase::default(), 15.0, 10.0);
    assert_eq!((model.count("Red"), model.count("Free")), (18, 50));
    // A tile at a joint is red over its whole height if a part of it is hidden.
    let highest = |x: f64| {
        let red =
            model.leaves().filter(|leaf| leaf.rule() == "Red" && leaf.bounds().low.x == x && leaf.bounds().high.x == x);
        red.map(|leaf| leaf.bounds().high.y).fold(0.0, f64::max)
    };
    assert_eq!((highest(5.0), highest(10.0)), (12.0, 24.0));
}

cga! {
    grammar Park = r#"
        attr trees = "all"
        attr windows = "all"
        Lot --> split(x) { 12 : extrude(8) label("block") House | ~1 : Garden }
        House --> comp(f) { side : Facade | top : Roof. }
        Facade --> split(y) { 2 : split(x) { 2 : Window }* }*
        Window --> case hidden : NIL else : Window.
        hidden = case windows == "block" : touches(intra, "block") else : touches(intra)
        Garden --> scatter(surface, 60, uniform) { Place } scatter(surface, 20, uniform) { t(0 - scope.tx, 0, 0) Place }
        Place --> s(1.6, 3, 1.6) primitiveCube() center(xz) CheckOverlap
        CheckOverlap --> case overlapping : NIL else : Tree.
        overlapping = case trees == "none" : false case trees == "block" : overlaps(intra, "block") else : overlaps(intra)
    "#;
}

#[test]
fn all_trees_that_overlap_another_tree_or_a_house_are_gone() {
    let lot = Shape::rectangle(40.0, 30.0).seed(5);
    let park = |trees: &str, windows: &str| {
        let park = Park { trees: trees.to_owned(), windows: windows.to_owned() };
        clean(park.generate(&lot).expect("a model"))
    };
    let trees = |model: &Model| -> Vec<Bounds> {
        model.leaves().filter(|leaf| leaf.rule() == "Tree").map(|leaf| leaf.bounds()).collect()
    };
    let all = trees(&park("none", "all"));
    let meet = |a: &Bounds, b: &Bounds| (a.high.min(b.high) - a.low.max(b.low)).min_element() > 1e-3;
    let house = Bounds { low: DVec3::ZERO, high: DVec3::new(12.0, 8.0, 30.0) };
    let free_of_trees = |tree: &&Bounds| all.iter().filter(|other| meet(tree, other)).count() == 1;
    let kept: Vec<Bounds> = all.iter().filter(|tree| free_of_trees(tree) && !meet(tree, &house)).copied().collect();
    let free_of_house: Vec<Bounds> = all.iter().filter(|tree| !meet(tree, &house)).copied().collect();
    assert!(10 < kept.len() && kept.len() < free_of_house.len() && free_of_house.len() < all.len());
    // All of them, not a subset of which the rest would be free.
    assert_eq!(trees(&park("all", "all")), kept);
    assert_eq!(trees(&park("block", "all")), free_of_house);
    // Windows stay away where trees stood that are gone; a label leaves trees out.
    let windows = |model: &Model| model.count("Window");
    let (with_trees, with_block) = (windows(&park("all", "all")), windows(&park("all", "block")));
    assert!(with_trees < with_block, "{with_trees} {with_block}");
    assert_eq!(with_block, windows(&park("none", "block")));
}

#[test]
fn edges_and_points_are_inside_or_overlap() {
    rules! {
        grammar Parts = r#"
            Lot --> split(x) { 4 : extrude(4) Solid. | ~1 : Line }
            Line --> t(-2, 2, 1) s(4, 0, 2) comp(fe) { all : Edge } comp(fv) { all : Point }
            Edge --> print("edge " + inside(intra) + " " + overlaps(intra) + " " + touches(intra)) E.
            Point --> print("point " + inside(intra) + " " + overlaps(intra) + " " + touches(intra)) P.
        "#;
    }
    let model = model_of(&Parts::default(), 8.0, 8.0);
    // Two edges cross a wall, one is in the solid and one is outside of it.
    let mut lines = crate::lines(&model);
    lines.sort();
    let (edges, points) = lines.split_at(4);
    assert_eq!(
        edges,
        ["edge false false false", "edge false true true", "edge false true true", "edge true true true"]
    );
    assert_eq!(
        points,
        ["point false false false", "point false false false", "point true true true", "point true true true"]
    );
}
