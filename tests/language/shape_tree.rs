//! The tree of shapes, as data: rules, parents, keys, scopes, and the shapes of leaves.

use std::collections::BTreeSet;
use std::ops::ControlFlow;

use cga::sink::buffers::Buffers;
use cga::{
    Building, Error, Flow, Grammar, Grammars, Leaf, Limits, Mesh, Model, Scene, Scope, Settings, Shape, ShapeTree,
    Sink, Watch, cga,
};

use crate::{lot, model, rules};

/// Settings that ask for the tree.
fn with_tree() -> Settings {
    Settings { tree: true, limits: Limits { depth: 1_000_000, ..Limits::default() }, ..Settings::default() }
}

/// The model with its tree. The model equals the model without a tree.
fn kept(grammar: &dyn Grammar, shape: &Shape, start: Option<&str>) -> Model {
    let settings = Settings { start: start.map(str::to_owned), ..with_tree() };
    let model = grammar.generate_with(shape, &settings).expect("a model");
    let plain = grammar.generate_with(shape, &Settings { tree: false, ..settings }).expect("a model");
    assert!(plain.buildings().all(|(building, _)| building.tree.is_none()));
    assert!(plain.leaves().all(|leaf| leaf.node().is_none()));
    assert_eq!(model, plain);
    check(&model);
    model
}

/// The tree of a model of one shape.
fn tree_of(model: &Model) -> &ShapeTree {
    model.buildings().next().expect("a building").0.tree.as_deref().expect("a tree")
}

/// Compares the trees of a model with its leaves.
fn check(model: &Model) {
    for (building, range) in model.buildings() {
        let tree = building.tree.as_deref().expect("a tree");
        let mut keys = BTreeSet::new();
        for (index, node) in tree.nodes().enumerate() {
            assert_eq!((node.index(), node.parent().is_none()), (index, index == 0));
            assert!(node.parent().is_none_or(|parent| parent.index() < index && parent.leaf().is_none()));
            assert!(node.children().enumerate().all(|(number, child)| {
                child.number() == number && child.parent().map(|parent| parent.index()) == Some(index)
            }));
            if tree.len() < 2000 {
                assert_eq!(tree.find(&node.key()).map(|found| found.index()), Some(index));
                assert!(keys.insert(node.key()));
            }
        }
        let below: usize = tree.nodes().map(|node| node.children().len()).sum();
        assert_eq!(below + 1, tree.len());
        assert_eq!(tree.nodes().filter_map(|node| node.leaf()).count(), range.len());
        assert!(tree.of_leaf(range.len()).is_none());
        for (leaf, view) in model.leaves().skip(range.start).take(range.len()).enumerate() {
            let node = tree.of_leaf(leaf).expect("a node");
            assert_eq!((node.rule(), node.leaf()), (view.rule(), Some(leaf)));
            assert_eq!(view.node().map(|node| node.key()), Some(node.key()));
            assert!(is_near(node.scope(), &view.scope()), "{:?} {:?}", node.scope(), view.scope());
        }
    }
}

fn is_near(a: &Scope, b: &Scope) -> bool {
    let difference = [a.origin - b.origin, a.size - b.size];
    difference.iter().all(|difference| difference.abs().max_element() < 1e-9) && a.axes.abs_diff_eq(b.axes, 1e-9)
}

/// Each shape with its key.
fn listed(model: &Model) -> Vec<String> {
    tree_of(model).nodes().map(|node| format!("{} {}", node.rule(), node.key())).collect()
}

#[test]
fn the_documented_tree_has_the_documented_keys() {
    cga! {
        grammar Keys = r#"
            Init-->
                center(xz)
                extrude(10)
                comp(f) { front: Facade}
            Facade-->
                split(y) {'0.5 : Floor }*
            Floor-->
                split(x) { '0.1 : Wall | '0.3 : Window | '0.1 : Wall }*
            Wall-->
            Window-->
        "#;
    }
    let model = kept(&Keys::default(), &lot(), None);
    let row = ["Wall", "Window", "Wall", "Wall", "Window", "Wall"];
    let mut expected = vec!["Init 0;".to_owned(), "Facade 0;0;".to_owned()];
    for floor in 0..2 {
        expected.push(format!("Floor 0;0;{floor};"));
        expected.extend(row.iter().enumerate().map(|(part, rule)| format!("{rule} 0;0;{floor};{part};")));
    }
    assert_eq!(listed(&model), expected);
    assert_eq!(tree_of(&model).len() as u64, model.report().shapes);
    let root = tree_of(&model).root().expect("a root");
    assert_eq!((root.scope().size.to_array(), root.children().len()), ([2.0, 0.0, 2.0], 1));
    assert!(ShapeTree::default().is_empty() && ShapeTree::default().root().is_none());
}

#[test]
fn children_are_numbered_through_splits_and_blocks() {
    rules! {
        grammar Numbers = r##"
            Lot --> split(x) { 1 : Part | ~1 : color("#ff0000") | 0.5 : NIL | 0.1 : split(z) { ~1 : X. | ~1 : [ t(0, 1, 0) Part ] Y. } }
                comp(e) { all : E. } [ Part ] Last.
            Part --> NIL
        "##;
    }
    let model = kept(&Numbers::default(), &lot(), None);
    let expected = [
        "Lot 0;",
        "Part 0;0;",
        "Lot 0;1;",
        "X 0;2;",
        "Part 0;3;",
        "Y 0;4;",
        "E 0;5;",
        "E 0;6;",
        "E 0;7;",
        "E 0;8;",
        "Part 0;9;",
        "Last 0;10;",
    ];
    assert_eq!(listed(&model), expected);
    let lines = tree_of(&model).find("0;5;").expect("an edge");
    assert_eq!((lines.leaf(), lines.scope().size.y), (Some(3), 0.0), "placements are leaves");
}

#[test]
fn a_leaf_has_the_scope_with_which_its_rule_ends() {
    cga! { grammar Grows; Lot --> t(0, 1, 0) Wing  Wing --> extrude(3) }
    let model = kept(&Grows::default(), &lot(), None);
    let sizes: Vec<_> = tree_of(&model).nodes().map(|node| node.scope().size.y).collect();
    assert_eq!(sizes, [0.0, 3.0]);
}

cga! {
    grammar Mixed = r##"
        # Random choices, templates with holes, and trees below them.
        Town --> split(x) { ~2 : split(z) { ~3 : House }* }*
        House --> 50% : extrude(rand(3, 9)) comp(f) { side : Facade | top : Roof } else : scatter(surface, 4, uniform) { Tree. }
        Facade --> split(y) { { ~1 : Floor }* | 0.2 : Ledge. }
        Floor --> split(x) { { ~1 : Tile }* }
        Tile --> split(x) { ~1 : Wall. | 0.3 : Window | ~1 : Wall. }
        Window --> case p(0.5) : Glass. else : split(y) { ~1 : Glass. | ~1 : color(rand(0, 1), 0, 0) }
        Roof --> case split.index == 0 : roofHip(30) comp(f) { all = Tiles. } else : offset(-0.2) comp(f) { inside : Flat. | border : NIL }

        # Operands: their shapes are not in the tree.
        Solid --> primitiveCube union { split(x) { ~1 : Left | ~1 : Right. } | primitiveSphere } split(y) { ~1 : Slice }*
        Left --> primitiveCube Left.
        Slice --> inline { split(x) { ~1 : Deep(40) | ~1 : X. } } comp(f) { all : Face. }
        Deep(n) --> case n == 0 : Y. else : Deep(n - 1)
        Empty --> union { NIL | NIL } inline { NIL } E.

        # Leaves below the checkpoint of others.
        Many --> split(x) { 0.01 : A | 0.01 : B. }*
        A --> split(z) { ~1 : X. | ~1 : X. }
    "##;
}

#[test]
fn chance_and_repeats_are_the_same_in_both_runs() {
    for seed in 0..40 {
        let model = kept(&Mixed::default(), &Shape::rectangle(20.0, 12.0).seed(seed), Some("Town"));
        assert_eq!(tree_of(&model).len() as u64, model.report().shapes);
    }
    let model = kept(&Mixed::default(), &Shape::rectangle(300.0, 12.0), Some("Many"));
    assert_eq!(tree_of(&model).len() as u64, model.report().shapes);
}

#[test]
fn operands_are_not_in_the_tree() {
    let model = kept(&Mixed::default(), &Shape::cuboid(3.0, 3.0, 3.0), Some("Solid"));
    let rules: BTreeSet<_> = tree_of(&model).nodes().map(|node| node.rule()).collect();
    assert_eq!(rules.into_iter().collect::<Vec<_>>(), ["Face", "Slice", "Solid"]);
    let empty = kept(&Mixed::default(), &Shape::cuboid(3.0, 3.0, 3.0), Some("Empty"));
    assert_eq!(listed(&empty), ["Empty 0;", "E 0;0;"]);
}

#[test]
fn shapes_of_imports_are_in_the_tree() {
    rules! { grammar Flows = r#"import imp : "rules/import/height.cga" Lot --> imp.Lot Own  Own --> X."#; }
    let model = kept(&Flows::default(), &lot(), None);
    let names: Vec<_> = tree_of(&model).nodes().map(|node| node.rule()).collect();
    assert_eq!((names[0], names[names.len() - 2..].to_vec()), ("Lot", vec!["Own", "X"]));
    assert_eq!(tree_of(&model).root().expect("a root").children().len(), 2);
}

#[test]
fn calls_that_wait_keep_their_parents_and_numbers() {
    cga! {
        grammar Deep = r##"
            Lot --> Down(0) After.
            Down(n) --> case n < 3000 : Before. [ t(0, 1, 0) Down(n + 1) ] Beside(n) else : Before. End.
            Beside(n) --> case n % 100 == 0 : split(x) { ~1 : color("#ff0000") X. Down(4000) | ~1 : Y. } else : Y.
        "##;
    }
    let run = || {
        let model = kept(&Deep::default(), &lot(), None);
        let tree = tree_of(&model);
        for node in tree.nodes() {
            let names: Vec<_> = node.children().map(|child| child.rule()).collect();
            match node.rule() {
                "Lot" => assert_eq!(names, ["Down", "After"]),
                "Down" if names.len() == 3 => assert_eq!(names, ["Before", "Down", "Beside"]),
                "Down" => assert_eq!(names, ["Before", "End"]),
                "Beside" if 1 < names.len() => assert_eq!(names, ["X", "Down", "Y"]),
                "Beside" => assert_eq!(names, ["Y"]),
                _ => assert!(names.is_empty()),
            }
        }
        assert_eq!(tree.len() as u64, model.report().shapes);
        let mut node = tree.root();
        let mut depth = 0;
        while let Some(inner) = node {
            node = inner.children().find(|child| child.rule() == "Down");
            depth += 1;
        }
        assert_eq!(depth, 3002);
    };
    let thread = std::thread::Builder::new().stack_size(2 * 1024 * 1024).spawn(run).expect("a thread");
    thread.join().expect("no panic");
}

#[test]
fn each_building_of_a_list_has_its_tree() {
    cga! { grammar Park; Lot --> Lawn. scatter(surface, 3, uniform) { Lamp. } }
    let lot = |number: u32| {
        let lot = Shape::rectangle(9.0, 7.0).at([10.0 * f64::from(number), 0.0, 0.0]).seed(u64::from(number));
        lot.grammar(if number.is_multiple_of(3) { "Park" } else { "Mixed" })
    };
    let lots: Vec<_> = (0..30).map(lot).collect();
    let city = Grammars::new().with(Mixed::default()).with(Park::default());
    let all = || city.generate_all(&lots, &with_tree()).expect("models").to_model();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("threads");
    let model = pool.install(all);
    check(&model);
    let trees = |model: &Model| model.buildings().map(|(building, _)| building.tree.clone()).collect::<Vec<_>>();
    assert_eq!((trees(&model).len(), trees(&model) == trees(&all())), (30, true));
}

#[test]
fn a_run_that_ends_early_has_no_tree() {
    /// A sink that stops after a leaf.
    struct First(Option<Building>);

    impl Sink for First {
        fn mesh(&mut self, _: &Leaf<'_>, _: &std::sync::Arc<Mesh>, _: &cga::glam::DAffine3) -> Flow {
            ControlFlow::Break(())
        }

        fn end_building(&mut self, building: &dyn Fn() -> Building) {
            self.0 = Some(building());
        }
    }

    let mut first = First(None);
    let settings = Settings { start: Some("Many".to_owned()), ..with_tree() };
    let report = Mixed::default().run(&Shape::rectangle(9.0, 7.0), &settings, &mut first).expect("a report");
    assert!(report.stopped && first.0.expect("a building").tree.is_none());
    let settings = Settings { limits: Limits { shapes: 20, ..Limits::default() }, ..settings };
    let mut model = Model::new();
    let error = Mixed::default().run(&Shape::rectangle(9.0, 7.0), &settings, &mut model);
    assert!(matches!(error, Err(Error::Limit { .. })) && tree_is_none(&model));
}

fn tree_is_none(model: &Model) -> bool {
    model.buildings().all(|(building, _)| building.tree.is_none())
}

#[test]
fn the_second_run_is_silent() {
    cga! { grammar Says; Lot --> print("once") report("key", 1) X. }
    let watch = Watch::new();
    let settings = Settings { watch: Some(watch.clone()), ..with_tree() };
    let made = Says::default().generate_with(&lot(), &settings).expect("a model");
    assert_eq!((made.prints().len(), made.reported("key").map(|key| key.summary().count)), (1, Some(1)));
    assert_eq!((watch.progress().shapes, watch.progress().leaves, watch.progress().initial_shapes), (2, 1, 1));
    check(&made);
    // Sinks that do not ask for the building do not pay for the tree.
    let before = watch.progress().work;
    Says::default().run(&lot(), &settings, &mut Buffers::new()).expect("a report");
    assert_eq!(watch.progress().shapes, 4);
    assert!(before <= watch.progress().work && tree_is_none(&model(&Says::default())));
}

mod counted {
    use std::cell::Cell;

    use super::*;

    thread_local! {
        static CALLS: Cell<f64> = const { Cell::new(0.0) };
    }

    fn count() -> f64 {
        CALLS.set(CALLS.get() + 1.0);
        CALLS.get()
    }

    cga! { grammar Differs; Lot --> split(x) { 2 / self::count() : X. }* }

    #[test]
    fn rust_functions_that_differ_make_no_tree() {
        let made = Differs::default().generate_with(&lot(), &with_tree()).expect("a model");
        assert_eq!((made.len(), CALLS.get()), (1, 2.0));
        assert!(tree_is_none(&made));
    }

    cga! {
        grammar SameCounts;
        Lot --> case self::count() % 2 == 1 : split(x) { 0.5 : X. | ~1 : X. } else : split(x) { ~1 : X. | 0.5 : X. }
        Rules --> case self::count() % 2 == 1 : X. else : Y.
        Once --> report("calls", self::count()) X.
    }

    #[test]
    fn leaves_that_differ_make_no_tree() {
        for start in ["Lot", "Rules"] {
            CALLS.set(0.0);
            let settings = Settings { start: Some(start.to_owned()), ..with_tree() };
            let made = SameCounts::default().generate_with(&lot(), &settings).expect("a model");
            assert_eq!(CALLS.get(), 2.0, "{start}");
            assert!(tree_is_none(&made) && made.leaves().all(|leaf| leaf.node().is_none()), "{start}");
        }
    }

    /// Passes all that it gets on to two sinks.
    struct Both<A, B>(A, B);

    impl<A: Sink, B: Sink> Sink for Both<A, B> {
        fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &std::sync::Arc<Mesh>, at: &cga::glam::DAffine3) -> Flow {
            self.0.mesh(leaf, mesh, at)?;
            self.1.mesh(leaf, mesh, at)
        }

        fn begin_building(&mut self, name: &str, seed: u64) {
            self.0.begin_building(name, seed);
            self.1.begin_building(name, seed);
        }

        fn end_building(&mut self, building: &dyn Fn() -> Building) {
            self.0.end_building(building);
            self.1.end_building(building);
        }
    }

    #[test]
    fn the_rules_run_again_once_at_most() {
        let settings = Settings { start: Some("Once".to_owned()), ..with_tree() };
        CALLS.set(0.0);
        let mut both = Both(Model::new(), Model::new());
        SameCounts::default().run(&lot(), &settings, &mut both).expect("a report");
        assert_eq!((CALLS.get(), tree_is_none(&both.0)), (2.0, false));
        assert_eq!(tree_of(&both.0), tree_of(&both.1));
        // Files do not have trees.
        CALLS.set(0.0);
        SameCounts::default().run(&lot(), &settings, &mut cga::sink::gltf::Glb::new()).expect("a report");
        assert_eq!(CALLS.get(), 1.0);
    }
}

#[test]
fn a_sink_that_leaves_out_leaves_has_no_tree() {
    cga! { grammar TwoKinds; Lot --> split(x) { 1 : A. | 1 : B. }* }
    struct OnlyB(Model);

    impl Sink for OnlyB {
        fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &std::sync::Arc<Mesh>, at: &cga::glam::DAffine3) -> Flow {
            if leaf.rule == "B" { self.0.mesh(leaf, mesh, at) } else { ControlFlow::Continue(()) }
        }

        fn begin_building(&mut self, name: &str, seed: u64) {
            self.0.begin_building(name, seed);
        }

        fn end_building(&mut self, building: &dyn Fn() -> Building) {
            self.0.end_building(building);
        }
    }

    let mut filter = OnlyB(Model::new());
    TwoKinds::default().run(&Shape::rectangle(8.0, 3.0), &with_tree(), &mut filter).expect("a report");
    assert_eq!((filter.0.len(), tree_is_none(&filter.0)), (4, true));
    let all = TwoKinds::default().generate_with(&Shape::rectangle(8.0, 3.0), &with_tree()).expect("a model");
    let mut filter = OnlyB(Model::new());
    assert!(all.replay(&mut filter).is_continue() && tree_is_none(&filter.0));
    assert!(all.leaves().all(|leaf| leaf.node().is_some()));
}

#[test]
fn leaves_outside_of_buildings_have_no_node() {
    cga! { grammar Plain; Lot --> X. }
    let settings = with_tree();
    let (material, scope) = (std::sync::Arc::default(), *Shape::cuboid(1.0, 1.0, 1.0).scope());
    let name = cga::Text::fixed("ByHand");
    let by_hand = Leaf::new(&name, &material, &scope);
    let mut model = Model::new();
    let _ = model.placement(&by_hand);
    Plain::default().run(&lot(), &settings, &mut model).expect("a report");
    let _ = model.placement(&by_hand);
    Plain::default().run(&lot(), &settings, &mut model).expect("a report");
    let found: Vec<bool> = model.leaves().map(|leaf| leaf.node().is_some()).collect();
    assert_eq!(found, [false, true, false, true]);
}

#[test]
fn shapes_of_styles_have_the_names_of_their_leaves() {
    cga! {
        grammar Styled;
        Lot --> split(x) { ~1 : Cell }*
        Cell --> X.
        style Tall
        Cell --> Own
        Own --> case p(0.5) : split(x) { ^0.5 : Own }* else : extrude(2)
    }
    let model = kept(&Styled::default(), &Shape::rectangle(4.0, 1.0), Some("Tall$Lot"));
    assert!(tree_of(&model).nodes().all(|node| !node.rule().contains('$')), "{}", tree_of(&model));
}

#[test]
fn a_tree_is_printed_depth_first() {
    cga! { grammar Printed; Lot --> split(x) { 1 : A | 2 : B. }  A --> split(z) { ~1 : C. }* }
    let model = kept(&Printed::default(), &Shape::rectangle(3.0, 2.0), None);
    let tree = tree_of(&model);
    let text = "Lot 3 x 0 x 2\n  A 1 x 0 x 2\n    C. 1 x 0 x 1\n    C. 1 x 0 x 1\n  B. 2 x 0 x 2\n";
    assert_eq!(tree.to_string(), text);
    assert_eq!(format!("{tree:?}"), "ShapeTree { shapes: 5, leaves: 3 }");
    let below = tree.find("0;0;").expect("A").subtree().filter_map(|shape| shape.leaf()).collect::<Vec<_>>();
    assert_eq!(below, [0, 1]);
    assert!(["0;+1;", "0;01;", "0;;", "0;1", "1;", ""].iter().all(|key| tree.find(key).is_none()));
    let chain = kept(&Deep::default(), &lot(), None);
    assert!(tree_of(&chain).to_string().len() < 200 * tree_of(&chain).len());
    assert!(format!("{:?}", tree_of(&chain).root().expect("a root")).len() < 400);
}

cga! {
    grammar Deep;
    Lot --> Next(10000)
    Next(n) --> case 0 < n : Next(n - 1) else : X.
}

#[test]
fn trees_of_rules_with_queries_are_trees_of_the_last_derivation() {
    rules! {
        grammar Asking = r#"
            Lot --> extrude(10) split(x) { 5 : Block }*
            Block --> case overlaps(intra) : NIL else : label("block") comp(f) { side : Facade | top : Roof }
            Facade --> split(y) { ~5 : Tile }*
            Tile --> case touches(intra) : Wall. case touches(inter) : Party. else : print(getTreeKey) Window.
            Roof --> case contextCount(all, "block") < 6 : X. else : split(x) { ~1 : Slab }*
            Slab --> case contextCompare(inter, "block", world.highest) == 0 : Slab. else : NIL
        "#;
    }
    let lots = [Shape::rectangle(20.0, 10.0), Shape::rectangle(15.0, 10.0).at([20.0, 0.0, 0.0])];
    let asking = Asking::default();
    let scene = Scene::new(&asking, &lots);
    let plain = |at: usize| scene.generate_lot(at, &Settings::default()).expect("a model");
    for at in [0, 1] {
        let model = scene.generate_lot(at, &with_tree()).expect("a model");
        check(&model);
        assert_eq!(model, plain(at));
        let tree = tree_of(&model);
        let of_rule = |rule: &str| tree.nodes().filter(|node| node.rule() == rule && node.leaf().is_some()).count();
        for rule in ["Wall", "Party", "Window", "Slab"] {
            assert_eq!(of_rule(rule), model.count(rule), "{rule} of {at}");
        }
        assert!([model.count("Wall"), model.count("Party"), model.count("Slab")].iter().all(|count| 0 < *count));
        // The keys that rules print are the keys in the tree.
        let windows: Vec<String> = tree
            .nodes()
            .filter(|node| node.rule() == "Tile" && node.children().any(|child| child.rule() == "Window"))
            .map(|node| node.key())
            .collect();
        assert_eq!(windows, crate::lines(&model));
    }
}
