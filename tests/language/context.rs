//! Queries of labelled shapes of the same initial shape (*contextCount*, *contextCompare*, *minimumDistance function*).

#[cfg(not(feature = "compiled"))]
use cga::Grammar as _;
use cga::glam::DVec3;
use cga::{Scene, Settings, Shape, cga};

use crate::{clean, leaves, lines, model, rules};

#[test]
fn labelled_copies_count_and_the_first_derivation_prints_nothing() {
    cga! { grammar Counted = r#"Lot --> label("label") print(contextCount(intra, "label")) label("label")"#; }
    let model = model(&Counted::default());
    assert_eq!((lines(&model), leaves(&model)), (vec!["2".to_owned()], vec!["Lot"]));
}

#[test]
fn reports_and_faults_of_the_first_derivation_are_dropped() {
    rules! {
        grammar Reported = r#"
            Lot --> case contextCount(intra, "a") == 0 : report("first", 1) s(1 / 0, 1, 1) label("a") First.
                else : report("second", 1) Second."#;
    }
    let model = model(&Reported::default());
    assert_eq!(leaves(&model), ["Second"]);
    assert!(model.reported("first").is_none() && model.reported("second").is_some());
}

#[test]
fn tiles_know_how_many_there_are() {
    rules! {
        grammar Tiles = r#"
            Lot --> split(x) { 1 : split(z) { 1 : Tile }* }*
            Tile --> label("tile") Counted
            Counted --> case contextCount(intra, "tile") <= 9 : Green. else : Red.
        "#;
    }
    for (size, green, red) in [(3.0, 9, 0), (4.0, 0, 16)] {
        let model = clean(Tiles::default().generate(&Shape::rectangle(size, size)).expect("a model"));
        assert_eq!((model.count("Green"), model.count("Red")), (green, red));
    }
}

#[test]
fn cells_around_a_label_are_lower_with_their_distance() {
    rules! {
        grammar Cells = r#"
            Lot --> split(x) { ~0.1 : Column(split.index) }*
            Column(i) --> split(z) { ~0.1 : Cell(i, split.index) }*
            Cell(i, j) --> case i == 12 && j == 12 : label("here") Block else : Block
            Block --> case distance < 1 : extrude(1 - distance) Kept. else : NIL
            distance = minimumDistance(intra, "here")
        "#;
    }
    let model = clean(Cells::default().generate(&Shape::rectangle(2.5, 2.5)).expect("a model"));
    let height = |i: usize, j: usize| {
        let away = |at: usize| (at.abs_diff(12) as f64 - 1.0).max(0.0);
        1.0 - 0.1 * away(i).hypot(away(j))
    };
    let cells = (0..25).flat_map(|i| (0..25).map(move |j| (i, j)));
    let expected = cells.clone().filter(|&(i, j)| 1e-9 < height(i, j)).count();
    let at_rim = cells.filter(|&(i, j)| height(i, j).abs() <= 1e-9).count();
    assert_eq!((expected, at_rim), (385, 20));
    // Rounding decides at the rim.
    assert!((385..=405).contains(&model.count("Kept")), "{}", model.count("Kept"));
    for leaf in model.leaves() {
        let scope = leaf.scope();
        let cell = |place: f64| (place / 0.1).round() as usize;
        let expected = height(cell(scope.origin.x), cell(scope.origin.z));
        assert!((scope.size.y - expected).abs() < 1e-9, "{scope:?}");
    }
}

#[test]
fn points_keep_their_distance_to_labelled_boxes() {
    rules! {
        grammar Trees = r#"
            Lot --> scatter(surface, 300, uniform) { Point }
            Point --> 5% : s(0.2, 1, 0.2) label("red") Red. else : Thin
            Thin --> case 1 <= minimumDistance(intra, "red") : Kept. else : Dropped.
        "#;
    }
    let lot = Shape::rectangle(20.0, 20.0).seed(4);
    let model = clean(Trees::default().generate(&lot).expect("a model"));
    let scopes = |rule: &'static str| model.placements(rule).collect::<Vec<_>>();
    let (red, kept, dropped) = (scopes("Red"), scopes("Kept"), scopes("Dropped"));
    assert!(3 < red.len() && 20 < kept.len() && 20 < dropped.len());
    let nearest = |point: DVec3| {
        let distance = |solid: &cga::Scope| {
            let local = solid.axes.transpose() * (point - solid.origin);
            (local - local.clamp(DVec3::ZERO, solid.size)).length()
        };
        red.iter().map(distance).fold(f64::INFINITY, f64::min)
    };
    assert!(kept.iter().all(|scope| 1.0 <= nearest(scope.origin) + 1e-12));
    assert!(dropped.iter().all(|scope| nearest(scope.origin) < 1.0 + 1e-12));
}

#[test]
fn shapes_are_ranked_by_what_is_better() {
    rules! {
        grammar Ranked = r#"
            Lot --> split(x) { ~1 : Tower(split.index) }*
            Tower(n) --> extrude(1 + n % 3) label("tower") Compared(n)
            Compared(n) --> print(str(n) + ":" + contextCompare(intra, "tower", world.highest)
                + ";" + contextCompare(intra, "tower", world.lowest)
                + ";" + contextCompare(intra, "tower", world.easternmost)
                + ";" + contextCompare(intra, "tower", world.westernmost)
                + ";" + contextCompare(intra, "tower", area.largest)
                + ";" + contextCompare(intra, "tower", area.smallest)
                + ";" + contextCompare(intra, "none", area.smallest)) X.
        "#;
    }
    let model = clean(Ranked::default().generate(&Shape::rectangle(4.0, 1.0)).expect("a model"));
    assert_eq!(lines(&model), ["0:2;0;3;0;2;0;0", "1:1;0;2;1;1;2;0", "2:0;0;1;2;0;3;0", "3:2;0;0;3;2;0;0"]);
}

#[test]
fn unknown_labels_and_neighbours_give_the_defaults() {
    rules! {
        grammar Defaults = r#"
            Lot --> label("a") print(minimumDistance(intra, "b")) print(minimumDistance(inter, "a")) print(contextCount(inter, "a"))
                print(minimumDistance(all, "a")) print(contextCount(all, "a")) print(touches(inter)) X."#;
    }
    let model = Defaults::default().generate(&Shape::rectangle(2.0, 2.0)).expect("a model");
    assert_eq!(lines(&model), ["inf", "inf", "0", "0", "1", "false"]);
    let faults: Vec<&str> = model.faults().iter().map(|fault| fault.message.as_str()).collect();
    let expected = "a query with `inter` gives its default, as this run knows no other initial shape; lots that ask about each other are run by \
                    `Scene::new(&grammar, &lots).generate(&settings)`";
    assert_eq!(faults, [expected]);
    // The same lot in a scene, as the fault says.
    let (grammar, lots, settings) = (Defaults::default(), [Shape::rectangle(2.0, 2.0)], Settings::default());
    let scene = Scene::new(&grammar, &lots).generate(&settings).expect("a model");
    assert!(scene.report().faults().is_empty(), "{:?}", scene.report().faults());
}

#[test]
fn queries_are_answered_wherever_they_are() {
    rules! {
        grammar Everywhere = r#"
            attr n = contextCount(intra, "a")
            const each = comp(fe) { all : minimumDistance(intra, "a") }
            Lot --> print(n) print(each) split(x) { 1 : label("a") A(contextCount(intra, "a")) | ~1 : B }
            A(n) --> print(n) X.
            B --> comp(f) { minimumDistance(intra, "a") == 0 : print("near") Y. }
                setbackPerEdge(minimumDistance(intra, "a")) { all : Strip. | remainder : Rest. }
        "#;
    }
    let model = clean(Everywhere::default().generate(&Shape::rectangle(3.0, 4.0)).expect("a model"));
    // The edges are front, right, back and left.
    assert_eq!(lines(&model), ["1", "(4)[0,2,0,0]", "1", "near"]);
    let strips = model.leaves().filter(|leaf| leaf.rule() == "Strip");
    assert_eq!(strips.map(|leaf| leaf.area()).sum::<f64>(), 8.0);
}

#[test]
fn derivations_below_a_repeat_are_not_replayed() {
    rules! {
        grammar Repeated = r#"
            Lot --> split(x) { 1 : Bay }*
            Bay --> label("bay") Tile
            Tile --> extrude(minimumDistance(intra, "first") + 1) print(contextCount(intra, "bay")) Labelled
            Labelled --> case split.index == 0 : label("first") X. else : X.
        "#;
    }
    let model = clean(Repeated::default().generate(&Shape::rectangle(5.0, 1.0)).expect("a model"));
    assert_eq!(lines(&model), ["5"; 5]);
    let heights: Vec<f64> = model.leaves().map(|leaf| leaf.scope().size.y).collect();
    assert_eq!(heights, [1.0, 1.0, 2.0, 3.0, 4.0]);
}

#[test]
fn both_derivations_draw_the_same_numbers() {
    // Labels with a random name are found by the same draw.
    rules! {
        grammar Found = r#"
            Lot --> split(x) { ~1 : Bay }*
            Bay --> Named(str(rint(1000000 * rand(1))))
            Named(name) --> label(name) print(contextCount(intra, name)) X.
        "#;
    }
    for seed in 0..20 {
        let lot = Shape::rectangle(12.0, 1.0).seed(seed);
        let model = clean(Found::default().generate(&lot).expect("a model"));
        assert_eq!(lines(&model), ["1"; 12]);
    }
}

#[test]
fn a_tree_of_shapes_has_the_answers_of_the_model() {
    rules! {
        grammar Told = r#"
            Lot --> split(x) { 1 : Tile }*
            Tile --> label("tile") Counted
            Counted --> case contextCount(intra, "tile") == 3 : Three. else : Other.
        "#;
    }
    let settings = Settings { tree: true, ..Settings::default() };
    let model = Told::default().generate_with(&Shape::rectangle(3.0, 1.0), &settings).expect("a model");
    let (building, _) = model.buildings().next().expect("a building");
    let tree = building.tree.as_ref().expect("a tree");
    assert_eq!(tree.nodes().filter(|node| node.rule() == "Three").count(), 3);
}
